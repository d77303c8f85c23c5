"""Zeros and turning points of a function of the drive: sampled, bracketed, refined.

A sign change is narrowed down to the last bit. A zero that is only touched is a minimum of the
absolute value that is next to nothing against the size of the function.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise

from ...base.named import NamedTuple

RealFunction = Callable[[float], float]

TOUCHED_ZERO = 1e-7
"""A minimum below this part of the greatest value is a zero that is touched.

Half the digits: nothing nearer separates a double zero from one that is just missed.
"""

NOISE = 1e-12
"""Neighbours that are both below this part of the greatest value show no change of sign.

A dip that is no deeper is rounding as well.
"""

ROUNDED_END = 1e-14
"""A value at an end of the stroke below this part of the greatest is a zero that was rounded."""

LEFT_AT_ZERO = 1e-3
"""What is left of a value where the sign changes, if it is a zero: a pole or a jump leaves more."""

LEAST_STEP = 4
"""So many units in the last place are stepped to where a zero must be next to a value."""

MOST_CUTS = 40
"""An interval that is not narrowed by so many values is halved from there on."""

HALF_DIGITS = 1e-8
"""How exact a zero is that is touched, as a part of it: a minimum is known to half the digits."""

EXACT_AS_AT_ZERO = 1e-3
"""A zero nearer to 0 than this is as exact as one there."""

SAME_ROOT = 1e-9
"""Roots nearer to each other than this part of the grid are one within rounding."""

GOLDEN = (math.sqrt(5) - 1) / 2

ALL_SECTIONS = 90
"""Golden sections that leave nothing between two ends."""

FEW_SECTIONS, MISSED = 16, 1e-3
"""After so many golden sections what is above this part of the size misses zero for certain."""


def spaced(low: float, high: float, parts: int) -> list[float]:
    """Return the ends of equal cells, the last one exactly.

    >>> spaced(0, 1, 4)
    [0.0, 0.25, 0.5, 0.75, 1]
    """
    parts = max(parts, 1)
    return [low + (high - low) * i / parts for i in range(parts)] + [high]


class Root(NamedTuple):
    """A zero, and the width of the interval that holds it."""

    x: float
    bracket: float


def roots(function: RealFunction, grid: Sequence[float]) -> list[Root]:
    """Return the zeros of a function between the points of a grid.

    >>> [round(r.x, 12) for r in roots(lambda x: x * x - 2, [0.0, 1.0, 2.0])]
    [1.414213562373]
    """
    values = [function(x) for x in grid]
    size = max((abs(y) for y in values if math.isfinite(y)), default=0.0)
    zeros = (i for i, y in enumerate(values) if y == 0)
    found = [Root(grid[i], 0.0) for i in zeros if _alone(values, i, size)]
    for (a, b), (u, v) in zip(pairwise(grid), pairwise(values), strict=True):
        if u * v < 0 and max(abs(u), abs(v)) > NOISE * size:
            root = narrowed(function, a, b)
            if abs(function(root.x)) <= LEFT_AT_ZERO * max(abs(u), abs(v)):
                found.append(root)
    found.extend(_touched(function, grid, values, size))
    ends = ((grid[0], values[0]), (grid[-1], values[-1]))
    found.extend(Root(x, math.ulp(x)) for x, y in ends if abs(y) < ROUNDED_END * size)
    return _distinct(found, grid)


def _alone(values: Sequence[float], i: int, size: float) -> bool:
    """Return whether a zero is one on its own; the function may be zero but for rounding."""
    beside = (*values[max(i - 1, 0) : i], *values[i + 1 : i + 2])
    return any(abs(v) > NOISE * size for v in beside)


class _At(NamedTuple):
    """A value of a function, and where it has it."""

    x: float
    y: float


def narrowed(function: RealFunction, a: float, b: float, enough: float = 0.0) -> Root:
    """Narrow an interval over which the sign changes until it is no wider than ``enough``.

    At the most that is until nothing is left between its ends. It is divided where three values
    say that the zero is, or halved where they may mislead (T. R. Chandrupatla, A new hybrid
    quadratic/bisection algorithm, *Adv. Eng. Software* 28, 1997).
    """
    here, far = _At(a, function(a)), _At(b, function(b))
    last, cuts = far, 0
    while (x := _cut(here, far, last, cuts)) not in (here.x, far.x):
        if abs(far.x - here.x) <= enough:
            break
        value, cuts = function(x), cuts + 1
        if value == 0:
            return Root(x, 0.0)
        if (value < 0) == (here.y < 0):
            last = here
        else:
            last, far = far, here
        here = _At(x, value)
    return Root((here if abs(here.y) < abs(far.y) else far).x, abs(far.x - here.x))


def _cut(here: _At, far: _At, last: _At, cuts: int) -> float:
    """Return where to divide the interval between two values of unlike sign."""
    width, least = far.x - here.x, LEAST_STEP * math.ulp(max(abs(here.x), abs(far.x)))
    if last is not far and cuts < MOST_CUTS and abs(width) > 2 * least:
        along, up = (here.x - far.x) / (last.x - far.x), (here.y - far.y) / (last.y - far.y)
        if up * up < along and (1 - up) * (1 - up) < 1 - along:
            inverse = here.y / (far.y - here.y) * last.y / (far.y - last.y)
            inverse += (
                (last.x - here.x) / width
                * here.y / (last.y - here.y) * far.y / (last.y - far.y)
            )  # fmt: skip
            part = least / abs(width)
            return here.x + min(max(inverse, part), 1 - part) * width
    return (here.x + far.x) / 2


def _touched(
    function: RealFunction, grid: Sequence[float], values: Sequence[float], size: float
) -> Iterator[Root]:
    sizes = list(map(abs, values))
    for i in range(1, len(grid) - 1):
        before, here, after = sizes[i - 1 : i + 2]
        dips = before >= here <= after and max(before, after) - here > NOISE * size
        if dips and values[i - 1] * values[i] > 0 and values[i] * values[i + 1] > 0:
            yield from _lowest(function, (grid[i - 1], grid[i + 1]), values[i], size)


def _lowest(
    function: RealFunction, within: tuple[float, float], beside: float, size: float
) -> Iterator[Root]:
    """Yield the zeros about a point where a function comes nearest to zero: none, one or two.

    ``beside`` is a value of the function nearby.
    """
    sense = math.copysign(1.0, beside)
    x = lowest(lambda x: sense * function(x), *within, FEW_SECTIONS)
    if sense * function(x) > MISSED * size:
        return
    x = lowest(lambda x: sense * function(x), *within)
    least = sense * function(x)
    if least < -NOISE * size:
        yield from (narrowed(function, *sorted((end, x))) for end in within)
    elif least < TOUCHED_ZERO * size:
        yield Root(x, HALF_DIGITS * max(abs(x), EXACT_AS_AT_ZERO))


def lowest(
    function: RealFunction, a: float, b: float, sections: int = ALL_SECTIONS, flat: float = math.inf
) -> float:
    """Return where a function with one minimum is least, by golden sections.

    There are more than ``sections`` while two values within still differ by more than ``flat``:
    next to a kink a function may be steep.
    """
    c, d = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
    at_c, at_d = function(c), function(d)
    for section in range(ALL_SECTIONS):
        if section >= sections and not abs(at_c - at_d) > flat:
            break
        if at_c < at_d:
            b, d, at_d = d, c, at_c
            c = b - GOLDEN * (b - a)
            at_c = function(c)
        else:
            a, c, at_c = c, d, at_d
            d = a + GOLDEN * (b - a)
            at_d = function(d)
    return (a + b) / 2


def _distinct(found: list[Root], grid: Sequence[float]) -> list[Root]:
    """Return roots in order, those that are one within rounding once."""
    width = SAME_ROOT * (abs(grid[-1] - grid[0]) or 1.0)
    kept: list[Root] = []
    for root in sorted(found):
        if not kept or root.x - kept[-1].x > width:
            kept.append(root)
    return kept
