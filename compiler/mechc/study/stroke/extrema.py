"""Where a result is least and greatest along a stretch."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Literal

from ...formula.roots import Function, lowest, roots
from ...model.mechanism import LoadRatio, Reaction, SpeedRatio, WithFriction
from ..analysis import Analysis
from ..tolerances import BESIDE_BRANCH_POINT, CONSTANT
from .along import Along
from .friction import is_shown, some
from .rounded import is_nil, is_turning, rounded
from .run import SAMPLES, Run
from .singular import order_of, roots_at
from .stroke import Branch, Extremum, Singular, StrokeInterval

KINDS: Mapping[int, Literal["minimum", "maximum"]] = {1: "minimum", -1: "maximum"}

BESIDE_JUMP = 1e-9
"""How far from where a result seems to turn both sides of a jump are seen, as a part of a cell."""


def extrema_along(
    run: Run,
    stretches: Sequence[StrokeInterval],
    singular: Sequence[Singular],
    branches: Sequence[Branch],
) -> tuple[Extremum, ...]:
    """Return the extrema along a stroke; beside a branch point what looks like one is rounding."""
    near = BESIDE_BRANCH_POINT * run.range
    breaks = [b.drive for b in branches]
    breaks += [s.drive for s in singular if s.value == "undetermined"]
    found = [
        one
        for stretch, result in product(stretches, run.results)
        if not is_nil(result, run.along, stretch)
        for part in parted(some(run.within(stretch), result), breaks, near)
        for one in _on_part(run, result, stretch, singular, part)
    ]
    return tuple(sorted(found, key=lambda e: e.drive))


def parted(grid: Sequence[float], breaks: Sequence[float], near: float) -> Iterator[list[float]]:
    """Yield the parts of a grid between breaks, each up to as ``near`` as rounding is small enough.

    What is on the other side of a break says nothing of whether a result turns on this one.
    """
    low, high = grid[0], grid[-1]
    inner = sorted(x for x in breaks if low <= x <= high)
    begins, ends = [low, *(x + near for x in inner)], [*(x - near for x in inner), high]
    for first, last in zip(begins, ends, strict=True):
        if first < last:
            yield [first, *(x for x in grid if first < x < last), last]


def _on_part(
    run: Run,
    result: Analysis,
    stretch: StrokeInterval,
    singular: Sequence[Singular],
    part: Sequence[float],
) -> Iterator[Extremum]:
    """Yield the extrema of a result on a part of a stretch.

    Where a value that is looked at is a pole, what is next to it may be none.
    """
    along = run.along
    poles = [*_poles(run, result, singular), *_own_poles(run, result, stretch)]
    for one in extrema(result, run.drive.name, along, part):
        if not is_shown(one, result) or order_of(run, result, one.drive) == "infinite":
            continue
        if not is_turning(one, result, along, part):
            continue
        near_by = [p for p in poles if abs(one.drive - p) <= 2 * run.range / SAMPLES]
        if not near_by or turns_between(one, near_by, result, along):
            yield from rounded(one, result, along, run.grid)


def _poles(run: Run, result: Analysis, singular: Sequence[Singular]) -> list[float]:
    """Return where a result is infinite, or what it is with friction."""
    ideal = getattr(result.target, "of", result.target)
    names = {ratio.name for ratio in run.quotients if ratio.target == ideal}
    return [s.drive for s in singular if s.result in names and s.value == "infinite"]


def _own_poles(run: Run, result: Analysis, stretch: StrokeInterval) -> list[float]:
    """Return where a result that is no ratio of loads is infinite on a stretch."""
    if isinstance(result.target, LoadRatio | SpeedRatio):
        return []
    grid = run.within(stretch)
    return [
        root.x for pole in result.poles for root in roots_at(result, pole, run.along, stretch, grid)
    ]


def extrema(
    result: Analysis, drive: str, along: Along, grid: Sequence[float]
) -> Iterator[Extremum]:
    """Yield the extrema between values that lie close together.

    A direction that passes half a turn goes on at the other end of its values.
    """
    values = [*map(along.function(result.formula, result), grid)]
    least = CONSTANT * _usual(values)
    for i in range(1, len(grid) - 1):
        before, here, after = values[i - 1 : i + 2]
        turns = before > here <= after or before < here >= after
        change = max(abs(before - here), abs(after - here))
        if turns and change > least and not (_is_direction(result) and change > math.pi):
            sense = 1 if here <= after else -1
            near = _turning(result, drive, along, sense, (grid[i - 1], grid[i + 1]))
            value = along.of(result.formula, result, near)
            if not sense * value <= sense * here:
                near, value = grid[i], here
            yield Extremum(result.name, KINDS[sense], near, value)


def _is_direction(result: Analysis) -> bool:
    """Return whether a result is the direction of a force."""
    match result.target:
        case Reaction(part="direction") | WithFriction(Reaction(part="direction")):
            return True
        case _:
            return False


def turns_between(
    extremum: Extremum, poles: Sequence[float], result: Analysis, along: Along
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
    result: Analysis, drive: str, along: Along, sense: int, within: tuple[float, float]
) -> float:
    """Return the value between two others at which a result turns: where its slope is 0."""
    slope = (result.derivatives or {}).get(drive)
    if slope is not None:
        found = roots(along.function(slope, result), within)
        if found:
            return found[0].x
    size = along.function(result.formula, result)
    return _least(lambda x: sense * size(x), *within)


def _least(size: Function, low: float, high: float) -> float:
    """Return where a function is least; at a jump that is on one of its sides alone."""
    x, beside = lowest(size, low, high), BESIDE_JUMP * (high - low)
    return min((x, x - beside, x + beside), key=size)
