"""How what closing finds moves with the drive: loops differentiated, in angle algebra.

The vectors of a loop add up to zero all along the stroke, so their rates do: an unknown
direction turns its part, an unknown length stretches it. The rates come out as the
velocity ratios of mechanics, ``a·sin(φ − ψ)/(b·sin(ψ − θ))``.
"""

from collections.abc import Iterable, Mapping, Sequence

from ...algebra.angle import Angle, rational
from ...algebra.derivative import derivative
from ...algebra.determinant import determinant, with_column
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ..pose import Arm, Vector, components, gathered
from ..vector_graph import mentioned

Rates = Mapping[str, Product]
"""The derivative by the drive of every name that moves with it."""


def loop_rates(loops: Sequence[Vector], unknown: Sequence[str], known: Rates) -> dict[str, Product]:
    """Return the rates of the unknowns of loops that close together."""
    if len(loops) == 1 and len(unknown) == 1:
        return _single(loops[0], unknown[0], known)
    if len(loops) == 1 and len(unknown) == 2:
        return _pair(loops[0], unknown, known)
    rows = [part for loop in loops for part in zip(*_columns(loop, unknown, known), strict=True)]
    matrix, right = [row[:-1] for row in rows], [-row[-1] for row in rows]
    if len(matrix) != len(unknown) or not (whole := determinant(matrix)):
        return {}
    return {
        name: determinant(with_column(matrix, i, right)) / whole for i, name in enumerate(unknown)
    }


def _single(loop: Vector, unknown: str, known: Rates) -> dict[str, Product]:
    """Solve K + x′·X = 0 along X, where the loop's other unknown was recognised."""
    given, own = rate(loop, known), rate(loop, {unknown: Product(1)})
    if len(own) != 1:
        return {}
    size, angle = own[0]
    along = add(a.length * cosine(a.angle - angle) for a in given)
    return {unknown: add([-(along / size)])}


def _columns(
    loop: Vector, unknown: Sequence[str], known: Rates
) -> Iterable[tuple[Product, Product]]:
    """Return the components of a loop's rate for each unknown, then those of what is known."""
    for name in unknown:
        yield components(rate(loop, {name: Product(1)}))
    yield components(rate(loop, known))


def _pair(loop: Vector, unknown: Sequence[str], known: Rates) -> dict[str, Product]:
    """Solve K + x′·X + y′·Y = 0 by products with the vectors at right angles."""
    x, y = unknown
    given = rate(loop, known)
    one, other = (rate(loop, {name: Product(1)}) for name in unknown)
    whole = _cross(one, other)
    if not whole:
        return {}
    return {x: add([-_cross(given, other) / whole]), y: add([_cross(given, one) / whole])}


def _cross(one: Vector, other: Vector) -> Product:
    return add(a.length * b.length * sine(b.angle - a.angle) for a in one for b in other)


def rate(vector: Vector, rates: Rates) -> Vector:
    """Return the derivative of a vector whose symbols move at given rates."""
    arms: list[Arm] = []
    for length, angle in vector:
        turning = add(rates[n].scaled(rational(c)) for n, c in angle.terms if n in rates)
        arms.append(Arm(length * turning, angle + Angle.constant(90)))
        names = mentioned((Arm(length, Angle()),)) & rates.keys()
        arms.append(Arm(add(derivative(length, n) * rates[n] for n in sorted(names)), angle))
    return gathered(arm for arm in arms if arm.length)
