"""Signs of products over a box of parameter values, proved by interval arithmetic.

Bounds are rounded outwards, so a sign that is returned is a proof; None only means that
it was not proved. :func:`vanishing_value` gives the root of a sine or cosine in a box.
"""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..formula.tree import Call, Formula
from ..named import NamedTuple
from .angle import RADIAN, Angle
from .factors import CIRCLE, Constant, Factor, Length, Opaque, Trig
from .product import Product, Sum

SLACK = 4e-16
"""Relative outward rounding of one operation, some two units in the last place."""

LEAST = math.ulp(0.0)
"""The least positive number: what lies above 0 lies no nearer."""

SAME_ANGLE = 1e-12
"""An angle beyond a bound by less than this, in radians, was rounded, and lies within it."""


class Interval(NamedTuple):
    """All numbers from ``low`` to ``high``."""

    low: float
    high: float


Box = Mapping[str, Interval]


def widened(low: float, high: float) -> Interval:
    """Return an interval rounded outwards."""
    return Interval(low - SLACK * abs(low) - LEAST, high + SLACK * abs(high) + LEAST)


def sign(product: Product, box: Box) -> int | None:
    """Return +1 or −1 if a product has that sign everywhere in a box, else None."""
    result = 1 if product.coefficient > 0 else -1
    for factor, exponent in product.factors.items():
        low, high = factor_bounds(factor, box)
        if low <= 0 <= high:
            return None
        if high < 0 and exponent % 2:
            result = -result
    return result


def bounds(product: Product, box: Box) -> Interval:
    """Return an interval that holds all values of a product in a box."""
    result = widened(float(product.coefficient), float(product.coefficient))
    for factor, exponent in product.factors.items():
        result = _times(result, _raised(factor_bounds(factor, box), exponent))
    return result


def factor_bounds(factor: Factor, box: Box) -> Interval:
    """Return an interval that holds all values of a factor in a box."""
    match factor:
        case Constant():
            return widened(factor.evaluate({}), factor.evaluate({}))
        case Length(name):
            return box.get(name, Interval(-math.inf, math.inf))
        case Trig(function, angle):
            low, high = angle_bounds(angle, box)
            return _sine(low, high) if function == "sin" else _sine(*_quarter(low, high))
        case Sum():
            parts = [bounds(t, box) for t in factor.terms]
            return widened(sum(p.low for p in parts), sum(p.high for p in parts))
        case _ if factor == CIRCLE:
            return widened(math.pi, math.pi)
        case Opaque(Call("exp")):
            return Interval(LEAST, math.inf)
        case _:
            return Interval(-math.inf, math.inf)


def angle_bounds(angle: Angle, box: Box) -> Interval:
    constant = math.radians(angle.degrees)
    result = widened(constant, constant)
    for name, c in angle.terms:
        turn = Interval(1.0, 1.0) if name == RADIAN else box.get(name)
        if turn is None:
            return Interval(-math.inf, math.inf)
        part = _times(widened(float(c), float(c)), turn)
        result = widened(result.low + part.low, result.high + part.high)
    return result


def _quarter(low: float, high: float) -> Interval:
    return widened(low + math.pi / 2, high + math.pi / 2)


def _sine(low: float, high: float) -> Interval:
    """Return the range of the sine over an interval."""
    if not high - low < 2 * math.pi:
        return Interval(-1.0, 1.0)
    a, b = math.sin(low), math.sin(high)
    top = 1.0 if _holds(low, high, math.pi / 2) else max(a, b) + SLACK
    bottom = -1.0 if _holds(low, high, -math.pi / 2) else min(a, b) - SLACK
    return Interval(max(bottom, -1.0), min(top, 1.0))


def _holds(low: float, high: float, peak: float) -> bool:
    """Return whether an interval holds ``peak`` plus a whole number of turns (or nearly)."""
    turns = math.ceil((low - peak) / (2 * math.pi) - SAME_ANGLE)
    return peak + turns * 2 * math.pi <= high + SAME_ANGLE


def _times(a: Interval, b: Interval) -> Interval:
    corners = [x * y if x and y else 0.0 for x in a for y in b]
    return widened(min(corners), max(corners))


def _raised(a: Interval, exponent: int) -> Interval:
    if exponent < 0:
        if a.low <= 0 <= a.high:
            return Interval(-math.inf, math.inf)
        a, exponent = widened(1 / a.high, 1 / a.low), -exponent
    result = a
    for _ in range(exponent - 1):
        result = _times(result, a)
    if exponent % 2 == 0:
        result = Interval(max(result.low, 0.0), result.high)
    return result


def vanishing_value(
    factor: Trig, near: Mapping[str, float], box: Box, order: Sequence[str] = ()
) -> tuple[str, Formula] | None:
    """Return (symbol, value) at which a sine or cosine vanishes, of its roots the one in reach.

    ``near`` are default values, a ``box`` is the ranges; the symbol is the first of the angle's in
    an ``order``, else by name, whose coefficient is ±1, or its only one.
    """
    terms = [(n, c) for n, c in factor.angle.terms if n != RADIAN]
    terms.sort(key=lambda term: order.index(term[0]) if term[0] in order else len(order))
    unit = next(((n, c) for n, c in terms if abs(c) == 1), terms[0] if len(terms) == 1 else None)
    if unit is None:
        return None
    name, c = unit
    rest = factor.angle - Angle(((name, c),))
    first = Angle.constant(0 if factor.function == "sin" else 90)
    turns = _half_turns(factor.angle, first.evaluate({}), near, box)
    value = (first + Angle.constant(180 * turns) - rest) * (1 / Fraction(c))
    return name, value.formula()


def _half_turns(angle: Angle, first: float, near: Mapping[str, float], box: Box) -> int:
    """Return the half turns to add to a first root: within the ranges, else nearest by.

    Of sin(φ + β), with φ = 60° in 5° … 175°, that is 180° - β and not -β.
    """
    if not angle.names <= near.keys():
        return 0
    nearest = round((angle.evaluate(near) - first) / math.pi)
    within = angle_bounds(angle, box)
    if not math.isfinite(within.high - within.low):
        return nearest
    inside = range(
        math.ceil((within.low - first) / math.pi), math.floor((within.high - first) / math.pi) + 1
    )
    return min(inside, key=lambda turns: abs(turns - nearest), default=nearest)
