"""Where a result is least and greatest along a stretch."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import Literal

from ...base.frozen import replace
from ...formula.numeric.jumps import NEAR_JUMP
from ...formula.numeric.roots import RealFunction, lowest, roots
from ...model.mechanism import Efficiency, LoadRatio, Reaction, SpeedRatio, WithFriction
from ..analysis import Analysis
from ..sweep import Sweep
from ..tolerances import (
    CONSTANT,
    NEAR_BRANCH_POINT,
    NEAR_END,
    NEAR_JAM,
    SAME_EFFICIENCY,
    SAME_RATIO,
    SAME_VALUE,
    SHOWN_JUMP,
)
from ..variables import spans
from .jumps import has_turns, is_on_the_stroke
from .removable import RemovableSingularities, of_result
from .rounded import is_turning, is_zero, rounded
from .run import SAMPLES, StrokeRun
from .singular import order_of, roots_at
from .stroke import ChangePoint, Extremum, Singular, StrokeInterval

KINDS: Mapping[int, Literal["minimum", "maximum"]] = {1: "minimum", -1: "maximum"}


def extrema_along(
    run: StrokeRun,
    stretches: Sequence[StrokeInterval],
    singular: Sequence[Singular],
    branches: Sequence[ChangePoint],
    turns: Sequence[float] = (),
) -> tuple[Extremum, ...]:
    """Return the extrema along a stroke; near a branch point what looks like one is rounding.

    Results with friction are looked at where it ``turns`` round, too: they have kinks there.
    """
    found = [
        one
        for stretch, result in product(stretches, run.results)
        if not is_zero(result, run.along, stretch)
        for one in _without_unseen_jumps(
            _on_stretch(run, result, stretch, singular, branches, turns), run.range
        )
    ]
    return tuple(sorted(found, key=lambda e: e.drive))


def _without_unseen_jumps(found: Iterable[Extremum], range_: float) -> list[Extremum]:
    """Return the extrema of a result without the two sides of each jump too small to be shown.

    It falls to a jump, rises there by less than shows in its figures, and falls on: the figures of
    its minimum and of its maximum there are the same.

    >>> low = Extremum("k", "minimum", 0.5, 1.0)
    >>> high = Extremum("k", "maximum", 0.5 + 1e-12, 1.0 + 1e-7)
    >>> _without_unseen_jumps([low, high], 1.0)
    []
    >>> len(_without_unseen_jumps([low, high._replace(value=1.1)], 1.0))
    2
    """
    kept = list[Extremum]()
    for one in sorted(found, key=lambda e: e.drive):
        before = kept[-1] if kept else None
        if before and before.kind != one.kind and _is_unseen(before, one, range_):
            kept.pop()
        else:
            kept.append(one)
    return kept


def _is_unseen(before: Extremum, after: Extremum, range_: float) -> bool:
    """Return whether a result jumps from one extremum to the next, by less than is shown."""
    is_jump = after.drive - before.drive <= NEAR_JUMP * range_
    return is_jump and math.isclose(before.value, after.value, rel_tol=SHOWN_JUMP)


def _on_stretch(
    run: StrokeRun,
    result: Analysis,
    stretch: StrokeInterval,
    singular: Sequence[Singular],
    branches: Sequence[ChangePoint],
    turns: Sequence[float],
) -> Iterator[Extremum]:
    """Yield the extrema of a result on a stretch: between its breaks, and next to its jumps."""
    own = [s for s in singular if s.value == "undetermined" and s.result in _shared(run, result)]
    jumps = [s for s in own if s.kind == "jump" and s.sides]
    near = NEAR_BRANCH_POINT * run.range
    breaks = {s.drive: near for s in own} | {s.drive: NEAR_JUMP * run.range for s in jumps}
    breaks |= {b.drive: near for b in branches}
    grid = run.within(stretch)
    value = run.values(result.formula, result)
    removable = of_result(result, run.along, run.range)
    for part in parted(_with(grid, turns) if has_turns(result) else grid, breaks):
        whole = removable.left_out(part)
        for valued in with_values(whole, value) if has_turns(result) else [whole]:
            yield from _on_part(run, result, stretch, singular, valued, removable)
    for jump in (j for j in jumps if j.result == result.name and is_on_the_stroke(j, run)):
        if stretch.low < jump.drive < stretch.high:
            yield from next_to_jump(jump, result, run.along, run.range)


def _with(grid: Sequence[float], turns: Sequence[float]) -> list[float]:
    """Return a grid with what lies between its values, and is none of them but for rounding.

    A result may turn on either side of such a kink, so that the middles next to it belong there.

    >>> _with([0.0, 1.0, 2.0], [1.5, 2.0])
    [0.0, 1.0, 1.25, 1.5, 1.75, 2.0]
    """
    near = SAME_VALUE * (grid[-1] - grid[0])
    new = [x for x in turns if grid[0] < x < grid[-1] and all(abs(x - g) > near for g in grid)]
    whole = sorted({*grid, *new})
    middles = ((a + b) / 2 for a, b in pairwise(whole) if a in new or b in new)
    return sorted({*whole, *middles})


def _shared(run: StrokeRun, result: Analysis) -> set[str]:
    """Return the names of results at whose breaks a result has its own: ratios, and itself.

    A direction has them where the components of its force have theirs.
    """
    alike = (r.name for r in run.results if _force(r) == _force(result) is not None)
    return {result.name, *alike, *(ratio.name for ratio in run.quotients)}


def _force(result: Analysis) -> WithFriction | None:
    """Return the force with friction that a result is the size, a part or the direction of."""
    match result.target:
        case WithFriction(of=Reaction() as force):
            return replace(result.target, of=replace(force, part="size"))
        case _:
            return None


def parted(grid: Sequence[float], breaks: Mapping[float, float]) -> Iterator[list[float]]:
    """Yield the parts of a grid between breaks, each up to as near as rounding is small enough.

    What is on the other side of a break says nothing of whether a result turns on this one; that
    it turns in the cell next to one shows at a place close to its end.
    """
    low, high = grid[0], grid[-1]
    inner = sorted((x, near) for x, near in breaks.items() if low <= x <= high)
    begins = [low, *(x + near for x, near in inner)]
    ends = [*(x - near for x, near in inner), high]
    for first, last in zip(begins, ends, strict=True):
        if first < last:
            yield _part([x for x in grid if first < x < last], first, last)


def with_values(part: Sequence[float], value: RealFunction) -> Iterator[Sequence[float]]:
    """Yield the parts of a grid on which a function has values, each up to its ends.

    Friction ends them where it jams, and a result may turn in the cell next to that.
    """
    for low, high in spans(part, lambda x: math.isfinite(value(x))):
        is_whole = (low, high) == (part[0], part[-1])
        if low < high:
            yield part if is_whole else _up_to_jams(part, low, high)


def _up_to_jams(part: Sequence[float], low: float, high: float) -> list[float]:
    """Return the places of a grid between two ends, and closer ones in the cells next to these."""
    cell = max(b - a for a, b in pairwise(part))
    near = [x for d in NEAR_JAM for x in (low + d * cell, high - d * cell)]
    return sorted({low, high, *(x for x in (*part, *near) if low < x < high)})


def _part(inner: Sequence[float], first: float, last: float) -> list[float]:
    """Return places between two ends, with some close to the ends."""
    after, before = (inner[0], inner[-1]) if inner else (last, first)
    close = (first + (after - first) * NEAR_END, last + (before - last) * NEAR_END)
    return sorted({first, *close, *inner, last})


def next_to_jump(
    jump: Singular, result: Analysis, along: Sweep, range_: float
) -> Iterator[Extremum]:
    """Yield the sides of a jump that are the least or greatest nearby: the result turns there."""
    assert jump.sides is not None
    for way, value, other in zip((-1, 1), jump.sides, reversed(jump.sides), strict=True):
        away = along.of(result.formula, result, jump.drive + way * NEAR_BRANCH_POINT * range_)
        for sense, kind in KINDS.items():
            if sense * value < sense * other and sense * (away - value) > SAME_RATIO * abs(value):
                yield Extremum(result.name, kind, jump.drive, value)


def _on_part(
    run: StrokeRun,
    result: Analysis,
    stretch: StrokeInterval,
    singular: Sequence[Singular],
    part: Sequence[float],
    removable: RemovableSingularities,
) -> Iterator[Extremum]:
    """Yield the extrema of a result on a part of a stretch.

    Where a value that is looked at is a pole, what is next to it may be none.
    """
    along = run.along
    poles = [*_poles(run, result, singular), *_own_poles(run, result, stretch)]
    for one in extrema(result, run.drive.name, along, part, removable.turning):
        if not _is_shown(one, result) or order_of(run, result, one.drive) == "infinite":
            continue
        if not is_turning(one, result, along, part):
            continue
        if removable.is_one(one.drive):
            yield one
            continue
        near_by = [p for p in poles if abs(one.drive - p) <= 2 * run.range / SAMPLES]
        if not near_by or turns_between(one, near_by, result, along):
            yield from rounded(one, result, along, run.grid)


def _poles(run: StrokeRun, result: Analysis, singular: Sequence[Singular]) -> list[float]:
    """Return where a result is infinite, or what it is with friction."""
    ideal = getattr(result.target, "of", result.target)
    names = {ratio.name for ratio in run.quotients if ratio.target == ideal}
    return [s.drive for s in singular if s.result in names and s.value == "infinite"]


def _own_poles(run: StrokeRun, result: Analysis, stretch: StrokeInterval) -> list[float]:
    """Return where a result that is no ratio of loads is infinite on a stretch."""
    if isinstance(result.target, LoadRatio | SpeedRatio):
        return []
    grid = run.within(stretch)
    return [
        root.x for pole in result.poles for root in roots_at(result, pole, run.along, stretch, grid)
    ]


def extrema(
    result: Analysis,
    drive: str,
    along: Sweep,
    grid: Sequence[float],
    across: Callable[[float], tuple[float, float] | None] = lambda _: None,
) -> Iterator[Extremum]:
    """Yield the extrema between values that lie close together.

    A direction that passes half a turn goes on at the other end of its values. Where a formula is
    0/0, ``across`` returns at which value the result turns nearby, and what it is there.
    """
    values = [*map(along.function(result.formula, result), grid)]
    least = CONSTANT * _usual(values)
    differing = _differing(values, least)
    for a, i, b in zip(differing, differing[1:], differing[2:], strict=False):
        before, here, after = values[a], values[i], values[b]
        turns = before > here < after or before < here > after
        change = max(abs(before - here), abs(after - here))
        if turns and not (_is_direction(result) and change > math.pi):
            sense = 1 if here < after else -1
            near = _turning(result, drive, along, sense, (grid[a], grid[b]))
            near, value = across(near) or (near, along.of(result.formula, result, near))
            if not sense * value <= sense * here:
                near, value = grid[i], here
            yield Extremum(result.name, KINDS[sense], near, value)


def _differing(values: Sequence[float], least: float) -> list[int]:
    """Return the indices of values, of those that differ by no more than rounding the first.

    Beside a place at which friction turns round two others may be looked at, as near as rounding.

    >>> _differing([2.0, 1.0, 1.0, 1.0, math.nan, 2.0], 1e-9)
    [0, 1, 4, 5]
    """
    kept = [0] if values else []
    for i, value in enumerate(values):
        if kept[-1] != i and not abs(value - values[kept[-1]]) <= least:
            kept.append(i)
    return kept


def _is_direction(result: Analysis) -> bool:
    """Return whether a result is the direction of a force."""
    match result.target:
        case Reaction(part="direction") | WithFriction(Reaction(part="direction")):
            return True
        case _:
            return False


def turns_between(
    extremum: Extremum, poles: Sequence[float], result: Analysis, along: Sweep
) -> bool:
    """Return whether an extremum near a pole is no value at the pole, which is rounding.

    The result turns there within an eighth of the way to the pole.
    """
    step = min(abs(extremum.drive - pole) for pole in poles) / 8
    beside = (along.of(result.formula, result, extremum.drive + s * step) for s in (-1, 1))
    sense = 1 if extremum.kind == "minimum" else -1
    return all(sense * value > sense * extremum.value for value in beside)


def _usual(values: Sequence[float]) -> float:
    """Return a size that most values do not exceed: near poles they exceed any."""
    sizes = sorted(abs(v) for v in values if math.isfinite(v))
    return sizes[len(sizes) * 9 // 10] if sizes else 0.0


def _turning(
    result: Analysis, drive: str, along: Sweep, sense: int, within: tuple[float, float]
) -> float:
    """Return the value between two others at which a result turns: where its slope is 0."""
    slope = (result.derivatives or {}).get(drive)
    if slope is not None:
        found = roots(along.function(slope, result), within)
        if found:
            return found[0].x
    size = along.function(result.formula, result)
    return lowest(lambda x: sense * size(x), *within)


def _is_shown(extremum: Extremum, result: Analysis) -> bool:
    """Return whether an extremum is none of an efficiency where nothing moves, but for rounding."""
    return extremum.value > SAME_EFFICIENCY or not isinstance(result.target, Efficiency)
