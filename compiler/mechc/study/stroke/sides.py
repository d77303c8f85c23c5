"""What a result with friction is at a dead centre: its limits on either side.

There a slip or force has no sign, and what rounding makes of that sign may be of either side. At a
dead centre of the drive friction jams one motion and lets the other go on, so that the result is
undetermined; at one of the load both sides come to values between which all of them balance.
"""

import math
from collections.abc import Callable, Sequence

from ...formula.rounding import Rounding, Size
from ...formula.walk import walk
from ...model.result import Definition
from ..states import is_sign
from ..tolerances import SAME_SIDES, SIDE, VANISHING

GROWS = 1.5
"""How much larger what is infinite somewhere is at half the distance, at least."""


def is_on_a_side(size: Size, where: Sequence[Definition], rounding: Rounding) -> bool:
    """Return whether a value rests on a sign that rounding makes, or has no number."""
    if size.number is None or not math.isfinite(size.number):
        return True
    known = Rounding({})
    known.values.update(rounding.values)
    known.define(where)
    formulas = (d.formula for d in where if d.name in known.values)
    signs = (part for formula in formulas for part in walk(formula) if is_sign(part))
    return any(known.of(sign).error >= 1 for sign in signs)


def from_both_sides(
    at: Callable[[float], float], stands: Callable[[float], bool], x: float, range_: float
) -> Size:
    """Return the limit of a result at ``x``, undetermined where its sides are not alike.

    A side on which no pose ``stands`` does not count.
    """
    steps = [s * SIDE * range_ for s in (-1, 1)]
    ends = [_limit(at, x, step) for step in steps if stands(x + step)]
    low, high = min(ends, default=math.nan), max(ends, default=math.nan)
    if all(map(math.isnan, ends)):
        return Size(math.nan)
    if any(map(math.isnan, ends)) or low * high < 0 or (math.isinf(high) and low < high):
        return Size(None, undetermined=True)
    return Size(_between(at(x), low, high))


def _limit(at: Callable[[float], float], x: float, step: float) -> float:
    """Return the limit of a result, on the line through its values one and two steps away."""
    near, far = at(x + step), at(x + 2 * step)
    if abs(near) > GROWS * abs(far):
        return math.copysign(math.inf, near)
    limit = 2 * near - far
    return 0.0 if abs(limit) <= VANISHING * abs(near) else limit


def _between(value: float, low: float, high: float) -> float:
    """Return a value that lies between two others but for rounding, else their middle."""
    room = SAME_SIDES * max(abs(low), abs(high))
    return value if low - room <= value <= high + room else (low + high) / 2
