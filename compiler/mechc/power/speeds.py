"""The speeds that are asked for: signed where a sign is defined, magnitudes elsewhere."""

import math
from collections.abc import Iterator
from fractions import Fraction

from ..algebra.angle import Angle, Rational
from ..algebra.factors import Factor, Opaque, Trig
from ..algebra.from_formula import to_product
from ..algebra.intervals import Box, sign
from ..algebra.product import Product, Sum
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..formula.tree import Call
from ..kinematics.plan import Plan, Speeds
from ..model.boxes import allowed_box
from ..model.mechanism import Mechanism, Speed
from ..named import NamedTuple
from ..pose.pose import Arm, Vector, gathered


class Rate(NamedTuple):
    """A speed per unit of each drive; ``signed`` if one of its two senses is positive."""

    speeds: Speeds
    signed: bool = True


def speed(plan: Plan, wanted: Speed) -> Rate:
    """Return a speed per unit of each drive.

    A link's is counter-clockwise; a point's is signed along its guide, counter-clockwise
    about its link's pivot, and a magnitude elsewhere; a component along its axis.
    """
    if wanted.kind == "link":
        return Rate(plan.spin(wanted.of))
    if wanted.axis:
        axis = Angle.constant(0 if wanted.axis == "x" else 90)
        return Rate(plan.component(wanted.of, axis))
    guide = plan.graph.pose.guide_of(wanted.of)
    if guide is not None:
        return Rate(plan.component(wanted.of, guide))
    return _about_pivot(plan, wanted.of) or Rate(_lengths(plan, wanted.of), signed=False)


def _about_pivot(plan: Plan, point: str) -> Rate | None:
    """Return the speed of a point of a link on a pivot, ω·r; None of other points."""
    pose = plan.graph.pose
    fixed = pose.mechanism.fixed - {point}
    for link in pose.mechanism.links:
        pivot = next((p for p in link.points if p in fixed), None)
        if pivot and point in link.points:
            reach = magnitude(length(pose.vector(link.name, pivot, point)), pose.mechanism)
            return Rate(tuple(w * reach for w in plan.spin(link.name)))
    return None


def magnitude(value: Product, mechanism: Mechanism) -> Product:
    """Return the absolute value of a product.

    A length, or a sum of lengths, keeps the sign that it has over the ranges given, and
    without ranges for whatever the lengths may be; what else changes its sign, such as the
    difference of two lengths, or what depends on angles beyond a dead centre, is put
    between bars.
    """
    box, barred = allowed_box(mechanism), Product(1)
    result = Product(value.coefficient).scaled(1 if value.coefficient > 0 else -1)
    for factor, exponent in value.factors.items():
        part = Product.of(factor, exponent)
        sense = 1 if exponent % 2 == 0 or _is_root(factor) else _sense(Product.of(factor), box)
        result, barred = (result * part.scaled(sense), barred) if sense else (result, barred * part)
    return result * _bars(barred)


def _sense(factor: Product, box: Box) -> int:
    """Return the sign of a factor that no angle enters, 0 for others and where it is open."""
    if any(isinstance(f, Trig) and f.angle.terms for f in _leaves(factor)):
        return 0
    return sign(factor, box) or 0


def _leaves(value: Product) -> Iterator[Factor]:
    for factor in value.factors:
        if isinstance(factor, Sum):
            for term in factor.terms:
                yield from _leaves(term)
        else:
            yield factor


def _is_root(factor: Factor) -> bool:
    return (
        isinstance(factor, Opaque)
        and isinstance(factor.inside, Call)
        and (factor.inside.function == "sqrt")
    )


def _bars(value: Product) -> Product:
    above = Product(1, {f: e for f, e in value.factors.items() if e > 0})
    below = Product(1, {f: -e for f, e in value.factors.items() if e < 0})
    return _barred(above) / _barred(below)


def _barred(value: Product) -> Product:
    if not value.factors:
        return value
    return Product.of(Opaque(Call("abs", (value.formula(),))))


def even(value: Product) -> Product:
    """Return a product without bars around what has an even power."""
    result = value
    for factor, exponent in value.factors.items():
        match factor:
            case Opaque(Call("abs", (inner,))) if exponent % 2 == 0:
                result = result * Product.of(factor, -exponent) * to_product(inner) ** exponent
    return result


def length(vector: Vector) -> Product:
    """Return the length of a vector: an arm as it stands, else a root."""
    if len(vector) == 1:
        return vector[0].length
    square = add(a.length * b.length * cosine(a.angle - b.angle) for a in vector for b in vector)
    return root(square)


def root(square: Product) -> Product:
    """Return a square root, its sign open: even powers outside, the rest under the root."""
    outside = Product(1, {f: e // 2 for f, e in square.factors.items() if e % 2 == 0})
    inside = {f: e for f, e in square.factors.items() if e % 2}
    coefficient: Rational = 1
    parts = (square.coefficient.numerator, square.coefficient.denominator)
    whole = [math.isqrt(abs(n)) for n in parts]
    if [n * n for n in whole] == list(parts):
        outside = outside.scaled(Fraction(*whole))
    else:
        coefficient = square.coefficient
    if coefficient == 1 and not inside:
        return outside
    under = Product(coefficient, inside).formula()
    return outside * Product.of(Opaque(Call("sqrt", (under,))))


def _lengths(plan: Plan, point: str) -> Speeds:
    """Return |V| per unit of each drive, its sign open."""
    velocity = plan.graph.velocities[point]
    return tuple(
        length(gathered(Arm(f.size * plan.speeds[f.unknown][i], f.direction) for f in velocity))
        for i in range(plan.mobility)
    )
