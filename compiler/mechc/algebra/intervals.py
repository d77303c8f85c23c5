"""Signs of products over a box of parameter values, proved by interval arithmetic.

Bounds are rounded outwards, so a sign that is returned is a proof; None only means that
it was not proved. :func:`vanishing_values` gives the roots of a sine or cosine in a box.
"""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..base.named import NamedTuple
from ..formula.tree import Call, Formula
from .angle import RADIAN, Angle
from .factors import CIRCLE, ConstantSymbol, Factor, Length, Opaque, Trig
from .from_formula import to_product
from .product import Product, Sum
from .tolerances import SAME_ANGLE

SLACK = 4e-16
"""Relative outward rounding of one operation, some two units in the last place."""

LEAST = math.ulp(0.0)
"""The least positive number: what lies above 0 lies no nearer."""


class NumberInterval(NamedTuple):
    """All numbers from ``low`` to ``high``."""

    low: float
    high: float


IntervalBox = Mapping[str, NumberInterval]


def widened(low: float, high: float) -> NumberInterval:
    """Return an interval rounded outwards."""
    return NumberInterval(low - SLACK * abs(low) - LEAST, high + SLACK * abs(high) + LEAST)


def sign(product: Product, box: IntervalBox) -> int | None:
    """Return +1 or −1 if a product has that sign everywhere in a box, else None."""
    result = 1 if product.coefficient > 0 else -1
    for factor, exponent in product.factors.items():
        low, high = factor_bounds(factor, box)
        if low <= 0 <= high:
            return None
        if high < 0 and exponent % 2:
            result = -result
    return result


def bounds(product: Product, box: IntervalBox) -> NumberInterval:
    """Return an interval that holds all values of a product in a box."""
    result = widened(float(product.coefficient), float(product.coefficient))
    for factor, exponent in product.factors.items():
        result = _times(result, _raised(factor_bounds(factor, box), exponent))
    return result


def factor_bounds(factor: Factor, box: IntervalBox) -> NumberInterval:
    """Return an interval that holds all values of a factor in a box."""
    match factor:
        case ConstantSymbol():
            return widened(factor.evaluate({}), factor.evaluate({}))
        case Length(name):
            return box.get(name, NumberInterval(-math.inf, math.inf))
        case Trig(function, angle):
            low, high = angle_bounds(angle, box)
            return _sine(low, high) if function == "sin" else _sine(*_quarter(low, high))
        case Sum():
            parts = [bounds(t, box) for t in factor.terms]
            return widened(sum(p.low for p in parts), sum(p.high for p in parts))
        case _ if factor == CIRCLE:
            return widened(math.pi, math.pi)
        case Opaque(Call("exp")):
            return NumberInterval(LEAST, math.inf)
        case Opaque(Call("asin" | "acos" as function, (argument,))):
            return _arc(function, bounds(to_product(argument), box))
        case _:
            return NumberInterval(-math.inf, math.inf)


def angle_bounds(angle: Angle, box: IntervalBox) -> NumberInterval:
    """Return an interval that holds every value of an angle in a box."""
    constant = math.radians(angle.degrees)
    result = widened(constant, constant)
    for name, c in angle.terms:
        turn = NumberInterval(1.0, 1.0) if name == RADIAN else box.get(name)
        if turn is None:
            return NumberInterval(-math.inf, math.inf)
        part = _times(widened(float(c), float(c)), turn)
        result = widened(result.low + part.low, result.high + part.high)
    return result


def spans_no_zero(factor: Trig, box: IntervalBox) -> bool:
    """Return whether a sine or cosine is zero at most where its angle has its bounds in a box.

    >>> alpha = Angle.of("alpha")
    >>> quarter, more = ({"alpha": NumberInterval(0.0, high)} for high in (math.pi / 2, 2.0))
    >>> [spans_no_zero(Trig(name, alpha), quarter) for name in ("sin", "cos")]
    [True, True]
    >>> [spans_no_zero(Trig(name, alpha), more) for name in ("sin", "cos")]
    [True, False]
    """
    low, high = angle_bounds(factor.angle, box)
    if not math.isfinite(high - low):
        return False
    if factor.function == "cos":
        low, high = _quarter(low, high)
    half_turns = math.floor((low + SAME_ANGLE) / math.pi)
    return high <= (half_turns + 1) * math.pi + SAME_ANGLE


def _quarter(low: float, high: float) -> NumberInterval:
    return widened(low + math.pi / 2, high + math.pi / 2)


def _sine(low: float, high: float) -> NumberInterval:
    """Return the range of the sine over an interval.

    >>> _sine(1e-300, 3.0).low > 0
    True
    """
    if not high - low < 2 * math.pi:
        return NumberInterval(-1.0, 1.0)
    a, b = math.sin(low), math.sin(high)
    top = 1.0 if _holds(low, high, math.pi / 2) else max(a, b) + SLACK
    bottom = -1.0 if _holds(low, high, -math.pi / 2) else min(a, b) - SLACK
    if low > 0 and high < math.pi:
        bottom = max(bottom, LEAST)
    return NumberInterval(max(bottom, -1.0), min(top, 1.0))


def _arc(function: str, argument: NumberInterval) -> NumberInterval:
    """Return the range of an arc sine or cosine, which beyond -1 and 1 has no values."""
    low, high = (min(max(end, -1.0), 1.0) for end in argument)
    if function == "asin":
        return widened(math.asin(low), math.asin(high))
    return widened(math.acos(high), math.acos(low))


def _holds(low: float, high: float, peak: float) -> bool:
    """Return whether an interval holds ``peak`` plus a whole number of turns (or nearly)."""
    turns = math.ceil((low - peak) / (2 * math.pi) - SAME_ANGLE)
    return peak + turns * 2 * math.pi <= high + SAME_ANGLE


def _times(a: NumberInterval, b: NumberInterval) -> NumberInterval:
    corners = [x * y if x and y else 0.0 for x in a for y in b]
    return widened(min(corners), max(corners))


def _raised(a: NumberInterval, exponent: int) -> NumberInterval:
    """Return an interval that holds the powers of all numbers in one."""
    if exponent < 0:
        if a.low <= 0 <= a.high:
            return NumberInterval(-math.inf, math.inf)
        a, exponent = widened(1 / a.high, 1 / a.low), -exponent
    result = a
    for _ in range(exponent - 1):
        result = _times(result, a)
    if exponent % 2 == 0:
        result = NumberInterval(max(result.low, 0.0), result.high)
    return result


class Roots(NamedTuple):
    """The values of a symbol at which a sine or cosine vanishes.

    ``nearest`` is that next to the default value, within the range of the symbol if any is;
    ``within`` are all of them that the range has, in their order, and ``period`` is what lies
    between two. Of more than :data:`MOST_LISTED_ROOTS` there is the first.
    """

    name: str
    nearest: Formula
    within: tuple[Formula, ...]
    period: Formula
    is_many: bool = False


MOST_LISTED_ROOTS = 5
"""So many roots within a range are listed at most."""


def vanishing_values(
    factor: Trig, near: Mapping[str, float], box: IntervalBox, order: Sequence[str] = ()
) -> Roots | None:
    """Return the roots of a sine or cosine by a symbol of its angle.

    ``near`` are default values, a ``box`` is the ranges; the symbol is the first of the angle's in
    an ``order``, else by name, whose coefficient is ±1, or its only one.
    """
    terms = [(n, c) for n, c in factor.angle.terms if n != RADIAN]
    terms.sort(key=lambda term: order.index(term[0]) if term[0] in order else len(order))
    unit = next(((n, c) for n, c in terms if abs(c) == 1), terms[0] if len(terms) == 1 else None)
    if unit is None:
        return None
    name, c = unit
    period = 180 / abs(Fraction(c))
    first = Angle.constant(0 if factor.function == "sin" else 90)
    root = (first - (factor.angle - Angle(((name, c),)))) * (1 / Fraction(c))

    def turned(turns: int) -> Formula:
        return (root + Angle.constant(period * turns)).formula()

    half_turn = math.radians(period)
    within = _turns_within(root, half_turn, box.get(name), near, box)
    is_many = len(within) > MOST_LISTED_ROOTS
    listed = tuple(map(turned, within[:1] if is_many else within))
    nearest = _nearest_turns(Angle.of(name) - root, half_turn, within, near)
    return Roots(name, turned(nearest), listed, Angle.constant(period).formula(), is_many)


def _turns_within(
    root: Angle,
    period: float,
    reach: NumberInterval | None,
    near: Mapping[str, float],
    box: IntervalBox,
) -> range:
    """Return how many periods may be added to a root for it to lie within a symbol's range.

    Others in it vary within theirs, or have their default values. What only touches the range
    when all of them are at an end does not lie within it.
    """
    where = angle_bounds(root, box)
    if not math.isfinite(where.high - where.low) and root.names <= near.keys():
        where = NumberInterval(*[root.evaluate(near)] * 2)
    if reach is None or not math.isfinite(reach.high - reach.low + where.high - where.low):
        return range(0)
    touch = SAME_ANGLE if where.high - where.low < SAME_ANGLE else -SAME_ANGLE
    return range(
        math.ceil((reach.low - where.high - touch) / period),
        math.floor((reach.high - where.low + touch) / period) + 1,
    )


def _nearest_turns(distance: Angle, period: float, within: range, near: Mapping[str, float]) -> int:
    """Return the periods to add to a root: within the range, else nearest by.

    Of sin(φ + β), with φ = 60° in 5° … 175°, that is 180° - β and not -β.
    """
    if not distance.names <= near.keys():
        return within[0] if within else 0
    nearest = round(distance.evaluate(near) / period)
    return min(within, key=lambda turns: abs(turns - nearest), default=nearest)
