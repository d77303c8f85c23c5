"""Jumps of a function of the drive from one finite value to another: seen by the grid, narrowed."""

import math
from collections.abc import Sequence
from itertools import pairwise
from operator import itemgetter

from ...base.named import NamedTuple
from .roots import LEFT_AT_ZERO, TOUCHED_ZERO, RealFunction

JUMPING = 4.0
"""How much more than next to it a function that does not change its sign varies where it jumps."""

STEADY_NEAR_JUMP = 0.1
"""What it varies by near a jump, at most, as a part of that."""

JUMP_WIDTH, NEAR_JUMP = 1e-11, 1e-8
"""To what part of the range a jump is narrowed down, and from how far its sides are seen.

What is infinite at the pole itself is rounded worse, the nearer that is.
"""

FARTHER, ALIKE = (1, 10, 100, 1000, 10000), 1e-8
"""How many times as far a side is seen as well, and the part of it by which two such agree."""


class Jump(NamedTuple):
    """An x at which a function is finite on either side, but not the same, and its sides."""

    x: float
    bracket: float
    before: float
    after: float


def jumps(function: RealFunction, grid: Sequence[float]) -> list[Jump]:
    """Return where a function jumps from one finite value to another.

    >>> [round(j.x, 9) for j in jumps(lambda x: 1.0 if x < 0.3 else 2.0, [0.0, 0.25, 0.5])]
    [0.3]
    >>> steep = lambda x: 0.02 / (x - 0.24) if x < 0.3 else -0.3
    >>> [round(j.x, 9) for j in jumps(steep, [0.0, 0.1, 0.25, 0.5])]
    [0.3]
    """
    values = [function(x) for x in grid]
    steps = [abs(v - u) for u, v in pairwise(values)]
    sizes = sorted(abs(y) for y in values if math.isfinite(y))
    least = TOUCHED_ZERO * sizes[len(sizes) // 2] if sizes else 0.0
    range_ = abs(grid[-1] - grid[0])
    found: list[Jump] = []
    for i, step in enumerate(steps):
        beside = [*steps[max(i - 1, 0) : i], *steps[i + 1 : i + 2]]
        turns = values[i] * values[i + 1] < 0
        if step > least and (turns or step > JUMPING * max(beside, default=0.0)):
            jump = _narrowed(function, grid[i], grid[i + 1], range_)
            left = abs(jump.after - jump.before)
            if left > LEFT_AT_ZERO * step and is_steady(function, jump, range_):
                found.append(jump)
    return found


def _narrowed(function: RealFunction, a: float, b: float, range_: float) -> Jump:
    """Return a jump between two points: what is between is on the side that it is more like.

    Where the sign changes that is the side of its sign: near a pole values fall from far above.
    """
    before, after = function(a), function(b)
    turns = before * after < 0
    while b - a > JUMP_WIDTH * range_ and (middle := (a + b) / 2) not in (a, b):
        value = function(middle)
        if turns:
            is_before = value * before > 0
        else:
            is_before = abs(value - before) < abs(value - after)
        if is_before:
            a, before = middle, value
        else:
            b, after = middle, value
    near = NEAR_JUMP * range_
    return Jump((a + b) / 2, b - a, side(function, a, -near), side(function, b, near))


def side(function: RealFunction, x: float, away: float) -> float:
    """Return the limit of a function at x from one side: seen at ``x + away``, and farther there.

    Each distance gives the parabola through it, twice and three times as far. Rounding makes near
    ones false, what the function bends by makes far ones; the first that agrees with the next is
    taken, or that which does so best.

    >>> round(side(lambda x: 2 + 3 * x + 1e-12 / x, 0.0, 1e-8), 6)  # rounded worse the nearer
    2.0
    """
    seen = (_parabola_at_zero([function(x + n * d * away) for n in (1, 2, 3)]) for d in FARTHER)
    found: list[tuple[float, float]] = []
    for near, far in pairwise(seen):
        gap = abs(far - near)
        if not math.isfinite(gap):
            return function(x + away)
        if gap <= ALIKE * abs(near):
            return near
        found.append((gap, near))
    return min(found, key=itemgetter(0))[1]


def _parabola_at_zero(values: Sequence[float]) -> float:
    """Return the value at 0 of a parabola by its values at 1, 2 and 3."""
    one, two, three = values
    return 3 * (one - two) + three


def is_steady(function: RealFunction, jump: Jump, range_: float) -> bool:
    """Return whether this is a jump, no pole: ten times as far values are nearly the same."""
    away, most = 10 * NEAR_JUMP * range_, STEADY_NEAR_JUMP * abs(jump.after - jump.before)
    before, after = (function(jump.x + side * away) for side in (-1, 1))
    return abs(before - jump.before) <= most and abs(after - jump.after) <= most
