"""The sides and angles of the triangles that loops make."""

from ...algebra.angle import Angle
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine
from ...formula.tree import Call, Formula, is_call, product
from ...formula.tree import Product as Factors
from ..pose import Vector


def along(vector: Vector, direction: Angle) -> Product:
    """Return the component of a vector along a direction."""
    return add(arm.length * cosine(arm.angle - direction) for arm in vector)


def common_turn(vector: Vector) -> Angle:
    """Return the symbols by which all arms turn alike."""
    alike = set.intersection(*(set(arm.angle.terms) for arm in vector))
    return Angle(tuple(sorted((n, c) for n, c in alike if n in vector[0].angle.names)))


def heron(d: Product, p: Product, q: Product) -> Call:
    """Return four times the area of a triangle.

    The factors stay apart: two that are alike would else make a square, whose root has no sign.
    """
    factors = (add([p, q, d]), add([p, q, -d]), add([d, p, -q]), add([d, q, -p]))
    return Call("sqrt", (product((f.formula(), 1) for f in factors),))


def is_of_vector(formula: Formula) -> bool:
    """Return whether something is the length or the direction of a vector between two points."""
    return is_call(formula, "hypot", "atan2")


def is_same_angle(one: Formula, other: Formula) -> bool:
    """Return whether two angles are those of a triangle of the same three sides, in any order."""
    if one == other:
        return True
    match one, other:
        case Call("atan2", (Call("sqrt", (Factors(here),)), x)), Call(
            "atan2", (Call("sqrt", (Factors(there),)), y)
        ):
            return x == y and frozenset(here) == frozenset(there)
    return False
