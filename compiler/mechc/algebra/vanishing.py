"""Where a sine or a cosine vanishes: the root in reach, as a formula."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..formula.tree import Formula
from .angle import RADIAN, Angle
from .factors import Trig
from .intervals import Box, angle_bounds


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
