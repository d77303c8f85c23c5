"""The extents of results along the stroke, or over ranges: for reports."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import partial
from itertools import chain

from ..base.frozen import replace
from ..diagnostics import Report
from ..formula.numeric.roots import RealFunction, lowest, spaced
from ..friction.solution import FrictionSolution
from ..model.mechanism import Drive, LoadRatio, Mechanism, SpeedRatio
from ..model.values import range_of
from .analysis import Analysis, Extent, Extreme, Trend, least_and_greatest
from .pose_sweep import PoseCode
from .stroke import ratio_extent
from .sweep import Sweep
from .tolerances import SAME_FIGURE
from .variables import extends, scale_of, turns, unit_of, varying

EXTENT_CELLS = 192
"""Cells of a range in which a result is looked at."""


def with_extents(
    solution: FrictionSolution, results: Sequence[Analysis], report: Report
) -> tuple[Analysis, ...]:
    """Return the results with the extents of ratios along the stroke, or over ranges.

    Without a drive a loop is followed along each angle that has a range, and along the length of
    a telescope that has one, as if that were one.
    """
    drive = solution.plan.graph.pose.mechanism.drive
    driving = {drive.parameter: results} if drive else _driving(solution, results)
    along = _along_strokes(solution, driving, report)
    code = PoseCode(solution.plan)
    return tuple(
        replace(result, extents=tuple(chain(inside or _over_ranges(code, result), at_ends)))
        for result in results
        for inside, at_ends in [(along.get(result.name), _at_ends(code, result, driving))]
    )


def _along_strokes(
    solution: FrictionSolution, driving: Mapping[str, Sequence[Analysis]], report: Report
) -> dict[str, list[Extent]]:
    """Return the extents of results, by their names, along what drives them."""
    has_drive = solution.plan.graph.pose.mechanism.drive is not None
    found: dict[str, list[Extent]] = {}
    for name, driven in driving.items():
        along = solution if has_drive else _driven_by(name, solution)
        for result, extent in ratio_extent.along_the_stroke(along, driven, report).items():
            found.setdefault(result, []).append(extent)
    return found


def _driving(solution: FrictionSolution, results: Sequence[Analysis]) -> dict[str, list[Analysis]]:
    """Return the ratios that rest on a loop, by the angles and telescopes that move them."""
    pose = solution.plan.graph.pose
    closed = {definition.name for definition in pose.definitions}
    found: dict[str, list[Analysis]] = {}
    for result in results:
        is_ratio = isinstance(result.target, LoadRatio | SpeedRatio)
        if is_ratio and any(d.name in closed for d in result.where):
            for name in varying(pose.mechanism, [result]):
                if not turns(name, pose.mechanism) and not extends(name, pose.mechanism):
                    continue
                if name in pose.free and range_of(name, pose.mechanism) is not None:
                    found.setdefault(name, []).append(result)
    return found


def _driven_by(name: str, solution: FrictionSolution) -> FrictionSolution:
    """Return the solution as if a drive stood in the description."""
    plan = solution.plan
    graph, mechanism = plan.graph, plan.graph.pose.mechanism
    drive = Drive(name, None, None, mechanism.span, turns=turns(name, mechanism))
    pose = replace(graph.pose, mechanism=replace(mechanism, drive=drive))
    plan = replace(plan, graph=replace(graph, pose=pose))
    return replace(solution, balance=replace(solution.balance, plan=plan))


def _over_ranges(code: PoseCode, result: Analysis) -> Iterator[Extent]:
    """Yield the extent of a ratio over each range in which it is proved to turn.

    Nothing where it may be infinite there.
    """
    bounded = all(pole.outside for pole in result.poles) and not result.breaks
    is_ratio = isinstance(result.target, LoadRatio | SpeedRatio)
    if not is_ratio or not bounded or result.default is None:
        return
    for one in _of_trends(code.mechanism, result, ["turns"]):
        sweep = Sweep(code, one.parameter, one.range)
        extremes = _extremes(partial(sweep.value_of, result), spaced(*one.range, EXTENT_CELLS))
        if extremes:
            low, high = least_and_greatest(extremes)
            yield replace(one, least=low, greatest=high)


def _at_ends(code: PoseCode, result: Analysis, moving: Collection[str]) -> Iterator[Extent]:
    """Yield the extent of a ratio over each range in which it is proved to rise, or to fall.

    That is what it comes to at the ends. Nothing of what is ``moving`` along a stroke.
    """
    if not isinstance(result.target, LoadRatio | SpeedRatio):
        return
    known = {*moving, *(result.proportional or {})}
    for one in _of_trends(code.mechanism, result, ["rises", "falls"]):
        if one.parameter in known:
            continue
        sweep = Sweep(code, one.parameter, one.range)
        reached = [(x, sweep.beyond_rounding(result, x)) for x in one.range]
        ends = [Extreme(x, y) for x, y in reached if y is not None and math.isfinite(y)]
        if len(ends) == len(reached):
            low, high = sorted(ends, key=lambda end: end.value)
            yield replace(one, least=low, greatest=high, is_monotone=True)


def _of_trends(
    mechanism: Mechanism, result: Analysis, trends: Collection[Trend]
) -> Iterator[Extent]:
    """Yield the extent, values left out, over each range in which a result has such a trend."""
    for name, trend in (result.trends or {}).items():
        ends = range_of(name, mechanism)
        if trend in trends and ends is not None:
            yield Extent(
                parameter=name,
                unit=unit_of(name, mechanism),
                range=ends,
                zeros=(),
                poles=(),
                least=None,
                greatest=None,
                scale=scale_of(result, mechanism),
                looked=False,
            )


def _extremes(at: RealFunction, grid: Sequence[float]) -> list[Extreme]:
    """Return the values at the ends of a range and where they turn; none where some are missing."""
    values = [*map(at, grid)]
    if not all(map(math.isfinite, values)):
        return []
    turning = [grid[0], grid[-1]]
    for i in range(1, len(grid) - 1):
        for sense in (1, -1):
            if sense * values[i] <= min(sense * values[i - 1], sense * values[i + 1]):
                turning.append(_turning(at, sense, grid[i - 1], grid[i + 1]))
    turning += _next_to_ends(at, grid, values)
    most = max(map(abs, values))
    return [Extreme(x, _without_rounding(at(x), most)) for x in turning]


def _without_rounding(value: float, most: float) -> float:
    """Return a value, 0 for what refining leaves of a double zero, against the largest value."""
    return 0.0 if abs(value) < SAME_FIGURE * most else value


def _next_to_ends(
    at: RealFunction, grid: Sequence[float], values: Sequence[float]
) -> Iterator[float]:
    """Yield where a result turns within the first and the last cell, beyond both ends of it."""
    for i in (0, len(grid) - 2):
        for sense in (1, -1):
            x = _turning(at, sense, grid[i], grid[i + 1])
            beyond = min(sense * values[i], sense * values[i + 1]) - sense * at(x)
            if beyond > SAME_FIGURE * abs(values[i]):
                yield x


def _turning(at: RealFunction, sense: int, low: float, high: float) -> float:
    return lowest(lambda x: sense * at(x), low, high)
