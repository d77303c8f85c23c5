"""The values in a range at which a ratio with friction is sampled: an even grid, and others.

Added to the grid are values

near dead centres, where k is small or large against friction, so that the mechanism is locked
or jammed on an interval, however short;
where the efficiency is lowest, where it may be locked or jammed, too;
between two at which it does not move, where it comes nearest to moving;
on either side of a jump, where a slip or a force changes its sign.

Cells in which the ratio without friction is not nearly straight are halved, so that none has
two dead centres in it, be it a zero and a pole or two zeros.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain, pairwise

from ..formula.numeric.roots import lowest, spaced
from .states import RatioAlong
from .tolerances import (
    BEFORE_JUMP,
    JUMP_WIDTH,
    NEARLY,
    SAME_EFFICIENCY,
    SAME_VALUE,
    THREE_FIGURES,
    TOUCHED,
)
from .variables import SignedMeasure, last

DEAD_CENTRE_CELLS = 36
"""Cells between which dead centres are looked for."""

SELDOM = 3
"""Only one in so many is looked at where friction is found by iteration, which takes long."""

STUCK = 2
"""So much closer it is looked at where nothing moves: something may in between."""

NEARER_VALUES = 8
"""Further values near a dead centre, each half as far from it as the one before."""

NEAREST = 2.0**-20
"""How near the last of them is: as near as friction is sure to be larger than k, or k than it."""

FARTHER = 4.0
"""By how much farther from it is looked at, again and again, where iteration finds nothing."""

BENT_CELL = 0.02
"""A cell is halved where its middle is off the straight line by this part of the values."""

MOST_HALVED = 10
"""How often a cell is halved at most."""

SECTIONS, FEWER = 16, 13
"""Sections to a lowest or highest efficiency; three figures of a smooth one are right then."""

FindChanges = Callable[[RatioAlong, float, float], Iterator[float]]
"""Yields values between two others at which something happens."""


def sampled_values(
    moving: RatioAlong, low: float, high: float, also: Sequence[float] = ()
) -> list[float]:
    """Return values from one end to the other, ``also`` among them if they lie between.

    None is nearer to a dead centre than what rounding leaves to be solved there.
    """
    even, centres = spaced(low, high, DEAD_CENTRE_CELLS), dead_centres(moving, low, high)
    step = even[1] - low
    ends = (x for x, out in ((low, -step), (high, step)) if _is_end(moving, x, out))
    near = [c + away for c in (*ends, *centres) for away in _near(moving, step)]
    near += [low + step / 2, high - step / 2]  # a kink may lie in the first cell, or the last
    solved = chain.from_iterable(_solved_next_to(moving, c, step) for c in centres)
    chosen = even[::SELDOM] if moving.is_slow else even
    grid = sorted({x for x in (*chosen, *near, *solved, *also) if low <= x <= high})
    far = nearest(high - low) / 2
    jumps = [x for x in _in_cells(_jumps, moving, grid) if all(abs(x - c) > far for c in centres)]
    unknown = _alone(moving, _with(grid, jumps))
    around = chain.from_iterable(_solved_next_to(moving, x, step) for x in unknown)
    known = (x for x in (*jumps, *around) if low <= x <= high and moving.at(x).state)
    grid = _with(grid, known)
    grid = _with(grid, _where_nothing_moves(moving, grid, step / STUCK))
    grid = _with(grid, _next_to_ends(moving, grid))
    grid = _with(grid, _in_cells(_edge, moving, grid))
    grid = _with(
        grid,
        _middles_beyond_both_ends(moving, grid),
        _turning_next_to_breaks(moving, grid),
        _loose(moving, grid),
    )
    return _with(grid, _extremes(moving, grid))


def dead_centres(moving: RatioAlong, low: float, high: float) -> tuple[float, ...]:
    """Return the dead centres between two values, found once for both ways of the motion.

    To look for them is a fifth of what a range takes.
    """
    found, even = moving.ideal_along.centres, spaced(low, high, DEAD_CENTRE_CELLS)
    if (low, high) not in found:
        found[low, high] = tuple(_in_cells(_dead_centres, moving, even))
    return found[low, high]


def _with(grid: Sequence[float], *more: Iterable[float]) -> list[float]:
    return sorted({*grid, *chain.from_iterable(more)})


def _in_cells(find: FindChanges, moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield the values found between each two neighbours of a grid."""
    for a, b in pairwise(grid):
        yield from find(moving, a, b)


def nearest(width: float) -> float:
    """Return how near to a dead centre is looked at, where so much is looked at altogether."""
    return NEAREST * width / DEAD_CENTRE_CELLS


def _near(moving: RatioAlong, step: float) -> Iterator[float]:
    """Yield how far from a dead centre to look, on both sides."""
    halvings = 1 if moving.is_slow else NEARER_VALUES
    for part in (*(0.5**i for i in range(1, halvings + 1)), NEAREST):
        yield from (-step * part, step * part)


def _is_end(moving: RatioAlong, x: float, outwards: float) -> bool:
    """Return whether a dead centre, or the end of a loop, is at an end of what is looked at."""
    driven = moving.driven(x)
    return driven is None or moving.driven(x + outwards * NEAREST) != driven


def _solved_next_to(moving: RatioAlong, centre: float, step: float) -> Iterator[float]:
    """Yield the nearest value on each side for which friction is found.

    Iteration may give up where k is nearly infinite, and what stands there would not be seen.
    """
    for away in (-step, step):
        near = NEAREST
        while near < 1 and not moving.at(centre + away * near).state:
            near *= FARTHER
        if near < 1:
            yield centre + away * near


def _alone(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield values of a motion at which alone nothing is found, at an end of a grid, too.

    There a slip may be infinite though the ratio without friction is not, and near it
    something may stand.
    """
    for a, x, b in _triples([grid[0], *grid, grid[-1]]):
        before, here, after = (moving.at(v).state for v in (a, x, b))
        if here is None and (before or after) and moving.driven(x) is not None:
            yield x


# -------------------------------------------------------------------- dead centres


def _dead_centres(
    moving: RatioAlong, a: float, b: float, depth: int = MOST_HALVED
) -> Iterator[float]:
    """Yield the dead centres between two values; ``depth`` falls with every halving."""
    pole = _pole_of_a_term(moving, a, b)
    if pole is not None and depth:
        step = NEAREST * (b - a)
        yield pole
        yield from _dead_centres(moving, a, max(a, pole - step), depth - 1)
        yield from _dead_centres(moving, min(b, pole + step), b, depth - 1)
    elif several := list(_of_several_factors(moving, a, b)):
        yield from several
    elif moving.driven(b) != moving.driven(a):
        yield dead_centre(moving, a, b)
    elif _is_bent(moving, a, b):
        if depth:
            middle = (a + b) / 2
            yield from _dead_centres(moving, a, middle, depth - 1)
            yield from _dead_centres(moving, middle, b, depth - 1)
        else:
            yield from _touched(moving, a, b)


def _is_bent(moving: RatioAlong, a: float, b: float) -> bool:
    """Return whether a ratio without friction may come to zero between two values and go back."""
    middle = (a + b) / 2
    if moving.driven(a) is None and moving.driven(middle) is None:
        return False  # the ratio is zero throughout, but for rounding, or there is no pose
    first, here, final = (moving.without(x) for x in (a, middle, b))
    size = abs(first) + 2 * abs(here) + abs(final)
    return abs(first + final - 2 * here) > BENT_CELL * size


def _pole_of_a_term(moving: RatioAlong, a: float, b: float) -> float | None:
    """Return where a divisor in a term changes its sign first; None where none does.

    The ratio, a sum, may be zero so near to that pole that its ends, and its middle, show nothing.
    """
    signs = [d > 0 for d in moving.divisors(a)]
    if not signs or signs == [d > 0 for d in moving.divisors(b)]:
        return None
    return last(lambda x: [d > 0 for d in moving.divisors(x)] == signs, a, b)


def _of_several_factors(moving: RatioAlong, a: float, b: float) -> Iterator[float]:
    """Yield where factors change their signs, if several do: the ratio may keep its own."""
    ends = tuple(zip(moving.factors(a), moving.factors(b), strict=False))
    changed = [i for i, (first, final) in enumerate(ends) if first * final < 0]
    for i in changed if len(changed) > 1 else ():
        yield last(partial(_is_of_one_sign, moving, i, a), a, b)


def _is_of_one_sign(moving: RatioAlong, i: int, a: float, x: float) -> bool:
    """Return whether the i-th factor of the ratio has one sign at two values."""
    found = moving.factors(x)
    return i < len(found) and found[i] * moving.factors(a)[i] > 0


def _touched(moving: RatioAlong, a: float, b: float) -> Iterator[float]:
    """Yield where a ratio touches zero, or infinity, near a narrow cell."""
    low, high = 2 * a - b, 2 * b - a
    sizes = [abs(moving.without(x)) for x in (low, high)]
    zero = lowest(lambda x: abs(moving.without(x)), low, high)
    if abs(moving.without(zero)) <= TOUCHED * max(sizes):
        yield zero
    pole = lowest(lambda x: -abs(moving.without(x)), low, high)
    if not abs(moving.without(pole)) * TOUCHED < min(sizes):
        yield pole


def dead_centre(moving: RatioAlong, a: float, b: float) -> float:
    """Return the dead centre between two values, 0 where it is nearly that.

    It may be the end of a loop, beyond which there is nothing: it is come to from where there is.
    """
    ends = (a, b) if moving.driven(a) is not None else (b, a)
    x = before_dead_centre(moving, *ends)
    return 0.0 if abs(x) < SAME_VALUE * abs(b - a) else x


def before_dead_centre(moving: RatioAlong, a: float, b: float) -> float:
    """Return the last value, from the first of two on, that is still before the dead centre."""
    driven = moving.driven(a)
    if driven is None:
        return last(lambda _: False, a, b)
    measures: tuple[SignedMeasure, ...] = (moving.without, partial(_inverse, moving))
    straightest = min(measures, key=lambda measure: _bend(measure, a, b))
    return last(lambda x: moving.driven(x) == driven, a, b, measure=straightest)


def _inverse(moving: RatioAlong, x: float) -> float:
    """Return the inverse of the ratio without friction, which passes zero at a pole."""
    ratio = moving.without(x)
    return 1 / ratio if ratio else math.inf


def _bend(measure: SignedMeasure, a: float, b: float) -> float:
    """Return by which part of its values a measure is off the straight line between two."""
    first, here, final = (measure(x) for x in (a, (a + b) / 2, b))
    return abs(first + final - 2 * here) / (abs(first) + abs(final))


# ------------------------------------------------------------------------ extremes


def _jumps(moving: RatioAlong, a: float, b: float) -> Iterator[float]:
    """Yield the values on either side of each change of a sign of a slip or force.

    They are no closer than a change is narrowed down: the step after one passes it.
    """
    width = max((b - a) * JUMP_WIDTH, NEARLY * max(abs(a), abs(b)))
    while moving.signs(a) != moving.signs(b) and b - a > 2 * width:
        x = _last_alike(moving, a, b)
        yield x
        yield x + width
        a = x + width


def _last_alike(moving: RatioAlong, a: float, b: float) -> float:
    signs = moving.signs(a)
    return last(lambda x: moving.signs(x) == signs, a, b, NEARLY)


def _edge(moving: RatioAlong, a: float, b: float) -> Iterator[float]:
    """Yield the last value at which it moves as at the first, where it sticks at the second.

    There an efficiency may fall to nothing at once.
    """
    state, driven, beyond = moving.at(a).state, moving.driven(a), moving.at(b).state
    if None not in (state, beyond) and state != beyond and moving.driven(b) == driven:
        yield last(lambda x: moving.at(x).state == state, a, b, NEARLY, moving.margin)
        yield last(lambda x: moving.at(x).state == beyond, b, a, NEARLY, moving.margin)


def _where_nothing_moves(moving: RatioAlong, grid: Sequence[float], step: float) -> Iterator[float]:
    """Yield values between two of one state other than free, no farther apart than a step.

    Where forces do not balance on either side no margin shows that they may in between.
    """
    for a, b in pairwise(grid):
        if _is_stuck(moving, a, b):
            yield from spaced(a, b, math.ceil((b - a) / step))[1:-1]


def _next_to_ends(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield ever nearer values where nothing moves next to a dead centre, or to the end of a loop.

    Two ratios that both grow without end there may change places once more.
    """
    for beyond, end, inside in (*_triples(grid), *_triples(grid[::-1])):
        if moving.driven(beyond) != moving.driven(end) and _stands(moving, end):
            yield from (end + (inside - end) * 0.5**i for i in range(1, NEARER_VALUES + 1))


def _is_stuck(moving: RatioAlong, a: float, b: float) -> bool:
    """Return whether nothing moves at two values, for one reason."""
    return _stands(moving, a) and moving.at(b).state == moving.at(a).state


def _stands(moving: RatioAlong, x: float) -> bool:
    """Return whether nothing moves at a value."""
    return moving.at(x).state in ("locked", "jammed")


def _loose(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield where something moves among values where nothing does: where least is missing."""
    sections = FEWER if moving.is_slow else SECTIONS
    margins = [moving.margin(x) for x in grid]
    for (a, _, c), (before, here, after) in zip(_triples(grid), _triples(margins), strict=True):
        if -math.inf < here <= 0 and max(before, after) <= here:
            top = lowest(lambda x: -moving.margin(x), a, c, sections)
            if moving.margin(top) > 0:
                yield top


def _middles_beyond_both_ends(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield the middles of cells with an extremum: the efficiency is above or below both ends.

    Next to a jump the cell itself may hold its lowest or highest. Where cells are narrow and it
    rises, or falls, from the value before one to that after it, its middle is not looked at.
    """
    values = [moving.efficiency(x) for x in grid]
    for i, (a, b) in enumerate(pairwise(grid)):
        steady = not moving.is_slow and _is_steady(values[max(i - 1, 0) : i + 3])
        if steady and moving.signs(a) == moving.signs(b):
            continue
        middle = (a + b) / 2
        first, here, final = (moving.efficiency(x) for x in (a, middle, b))
        if here > max(first, final) or here < min(first, final):
            yield middle


def _is_steady(values: Sequence[float]) -> bool:
    """Return whether these are four values that rise, or fall."""
    rises = [a < b for a, b in pairwise(values)]
    falls = [a > b for a, b in pairwise(values)]
    return len(values) == 4 and (all(rises) or all(falls))


def _turning_next_to_breaks(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield where an efficiency is lowest or highest within a cell that ends at a break.

    No neighbour beyond a jump, or the end of a range, shows anything of that; a value just before
    it does.
    """
    sections = FEWER if moving.is_slow else SECTIONS
    for far, end in _before_breaks(moving, grid):
        first, final = moving.efficiency(far), moving.efficiency(end)
        inside = moving.efficiency(end + (far - end) * BEFORE_JUMP)
        for sense in (1, -1):
            if sense * inside < sense * final <= sense * first:
                efficiency = partial(_signed, moving, sense)
                yield lowest(efficiency, min(far, end), max(far, end), sections, THREE_FIGURES)


def _before_breaks(moving: RatioAlong, grid: Sequence[float]) -> Iterator[tuple[float, float]]:
    """Yield the cells next to jumps and to the ends of a grid, from their far ends to these."""
    for way in (grid, grid[::-1]):
        jumps = ((a, b) for a, b, c in _triples(way) if moving.signs(b) != moving.signs(c))
        yield from (*jumps, (way[-2], way[-1]))


def _triples(grid: Sequence[float]) -> Iterator[tuple[float, float, float]]:
    return zip(grid, grid[1:], grid[2:], strict=False)


def _extremes(moving: RatioAlong, grid: Sequence[float]) -> Iterator[float]:
    """Yield where the efficiency is lowest or highest between values."""
    values = [moving.efficiency(x) for x in grid]
    sections = FEWER if moving.is_slow else SECTIONS
    for i in range(1, len(grid) - 1):
        before, here, after = values[i - 1 : i + 2]
        if not max(abs(here - before), abs(here - after)) > SAME_EFFICIENCY or here == 0:
            continue
        for sense in (1, -1):
            if sense * here <= sense * before and sense * here <= sense * after:
                efficiency = partial(_signed, moving, sense)
                yield lowest(efficiency, grid[i - 1], grid[i + 1], sections, THREE_FIGURES)


def _signed(moving: RatioAlong, sense: int, x: float) -> float:
    """Return an efficiency times a sign, infinite where there is none."""
    value = moving.efficiency(x)
    return math.inf if math.isnan(value) else sense * value
