"""Zeros and turning points of a function of the drive: sampled, bracketed, refined.

A sign change is halved to the last bit. A zero that is only touched is a minimum of the
absolute value that is nil against the size of the function.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

Function = Callable[[float], float]

NIL = 1e-7
"""A minimum below this part of the greatest value is a zero that is touched.

Half the digits: nothing nearer separates a double zero from one that is just missed.
"""

NOISE = 1e-12
"""Neighbours that are both below this part of the greatest value show no change of sign.

A dip that is no deeper is rounding as well.
"""

ROUNDED = 1e-14
"""A value at an end of the stroke below this part of the greatest is a zero that was rounded."""

JUMP = 1e-3
"""What is left of a value where the sign changes, if it is a zero: a pole or a jump leaves more."""

STEEP = 4.0
"""How much more than beside it a function that does not change its sign varies where it jumps."""

STEADY = 0.1
"""What it varies by near a jump, at most, as a part of that."""

NARROW, BESIDE = 1e-11, 1e-8
"""To what part of the range a jump is narrowed down, and from how far its sides are seen.

What is infinite at the place itself is rounded worse, the nearer that is.
"""

GOLDEN = (math.sqrt(5) - 1) / 2


def spaced(low: float, high: float, parts: int) -> list[float]:
    """Return the ends of equal cells, the last one exactly.

    >>> spaced(0, 1, 4)
    [0.0, 0.25, 0.5, 0.75, 1]
    """
    parts = max(parts, 1)
    return [low + (high - low) * i / parts for i in range(parts)] + [high]


class Root(NamedTuple):
    """A zero, and the width of the interval that holds it."""

    place: float
    bracket: float


def roots(function: Function, places: Sequence[float]) -> list[Root]:
    """Return the zeros of a function between the places given.

    >>> [round(r.place, 12) for r in roots(lambda x: x * x - 2, [0.0, 1.0, 2.0])]
    [1.414213562373]
    """
    values = [function(x) for x in places]
    size = max((abs(y) for y in values if math.isfinite(y)), default=0.0)
    found = [Root(places[i], 0.0) for i in range(len(places)) if _alone(values, i, size)]
    for (a, b), (u, v) in zip(pairwise(places), pairwise(values), strict=True):
        if u * v < 0 and max(abs(u), abs(v)) > NOISE * size:
            root = halved(function, a, b)
            if abs(function(root.place)) <= JUMP * max(abs(u), abs(v)):
                found.append(root)
    found.extend(_touched(function, places, values, size))
    ends = ((places[0], values[0]), (places[-1], values[-1]))
    found.extend(Root(x, math.ulp(x)) for x, y in ends if abs(y) < ROUNDED * size)
    return _distinct(found, places)


class Jump(NamedTuple):
    """A place at which a function is finite on either side, but not the same, and its sides."""

    place: float
    bracket: float
    before: float
    after: float


def jumps(function: Function, places: Sequence[float]) -> list[Jump]:
    """Return where a function jumps from one finite value to another.

    >>> [round(j.place, 9) for j in jumps(lambda x: 1.0 if x < 0.3 else 2.0, [0.0, 0.25, 0.5])]
    [0.3]
    """
    values = [function(x) for x in places]
    steps = [abs(v - u) for u, v in pairwise(values)]
    sizes = sorted(abs(y) for y in values if math.isfinite(y))
    least = NIL * sizes[len(sizes) // 2] if sizes else 0.0
    range_ = abs(places[-1] - places[0])
    found: list[Jump] = []
    for i, step in enumerate(steps):
        beside = [*steps[max(i - 1, 0) : i], *steps[i + 1 : i + 2]]
        turns = values[i] * values[i + 1] < 0
        if step > least and (turns or step > STEEP * max(beside, default=0.0)):
            jump = _narrowed(function, places[i], places[i + 1], range_)
            left = abs(jump.after - jump.before)
            if left > JUMP * step and _is_steady(function, jump, range_, STEADY * left):
                found.append(jump)
    return found


def _narrowed(function: Function, a: float, b: float, range_: float) -> Jump:
    """Return a jump between two places: what is between is on the side that it is more like."""
    before, after = function(a), function(b)
    while b - a > NARROW * range_ and (middle := (a + b) / 2) not in (a, b):
        value = function(middle)
        if abs(value - before) < abs(value - after):
            a, before = middle, value
        else:
            b, after = middle, value
    beside = BESIDE * range_
    return Jump((a + b) / 2, b - a, function(a - beside), function(b + beside))


def _is_steady(function: Function, jump: Jump, range_: float, most: float) -> bool:
    """Tell a jump from a pole: ten times as far from it the values are nearly the same."""
    away = 10 * BESIDE * range_
    before, after = (function(jump.place + side * away) for side in (-1, 1))
    return abs(before - jump.before) <= most and abs(after - jump.after) <= most


def _alone(values: Sequence[float], i: int, size: float) -> bool:
    """Tell a zero from one of many, where the function is zero but for rounding."""
    beside = [abs(v) for v in (*values[max(i - 1, 0) : i], *values[i + 1 : i + 2])]
    return values[i] == 0 and any(v > NOISE * size for v in beside)


def halved(function: Function, a: float, b: float) -> Root:
    """Halve an interval over which the sign changes until nothing is left between its ends."""
    below = function(a)
    while (middle := (a + b) / 2) not in (a, b):
        value = function(middle)
        if value == 0:
            return Root(middle, 0.0)
        if (value < 0) == (below < 0):
            a = middle
        else:
            b = middle
    return Root(a if abs(function(a)) < abs(function(b)) else b, abs(b - a))


def _touched(
    function: Function, places: Sequence[float], values: Sequence[float], size: float
) -> Iterator[Root]:
    for i in range(1, len(places) - 1):
        before, here, after = (abs(v) for v in values[i - 1 : i + 2])
        alike = values[i - 1] * values[i] > 0 and values[i] * values[i + 1] > 0
        if alike and here <= min(before, after) and max(before, after) - here > NOISE * size:
            yield from _lowest(function, (places[i - 1], places[i + 1]), values[i], size)


def _lowest(
    function: Function, within: tuple[float, float], beside: float, size: float
) -> Iterator[Root]:
    """Yield the zeros about a place where a function comes nearest to zero: none, one or two.

    ``beside`` is a value of the function nearby.
    """
    sense = math.copysign(1.0, beside)
    place = lowest(lambda x: sense * function(x), *within)
    least = sense * function(place)
    if least < -NOISE * size:
        yield from (halved(function, *sorted((end, place))) for end in within)
    elif least < NIL * size:
        yield Root(place, 1e-8 * max(abs(place), 1e-3))


def lowest(function: Function, a: float, b: float, sections: int = 90) -> float:
    """Return where a function with one minimum is least, by golden sections.

    90 of them leave nothing between the ends.
    """
    c, d = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
    at_c, at_d = function(c), function(d)
    for _ in range(sections):
        if at_c < at_d:
            b, d, at_d = d, c, at_c
            c = b - GOLDEN * (b - a)
            at_c = function(c)
        else:
            a, c, at_c = c, d, at_d
            d = a + GOLDEN * (b - a)
            at_d = function(d)
    return (a + b) / 2


def _distinct(found: list[Root], places: Sequence[float]) -> list[Root]:
    """Return roots in order, those that are one within rounding once."""
    width = 1e-9 * (abs(places[-1] - places[0]) or 1.0)
    kept: list[Root] = []
    for root in sorted(found):
        if not kept or root.place - kept[-1].place > width:
            kept.append(root)
    return kept
