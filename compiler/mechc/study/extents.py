"""The extents of results along the stroke, or over a range in which they turn: for reports."""

import math
from collections.abc import Iterator, Sequence

from ..diagnostics import Report
from ..formula.roots import lowest, spaced
from ..friction.solution import Solution
from ..frozen import replace
from ..model.mechanism import LoadRatio
from ..model.values import range_of
from .analysis import Analysis, Extent, Extreme
from .ranges import scale_of, unit_of
from .stroke import extent
from .sweep import Sweep

CELLS = 192
"""Cells of a range in which a result is looked at."""


def with_extents(
    solution: Solution, results: Sequence[Analysis], report: Report
) -> tuple[Analysis, ...]:
    """Return the results with the extents of ratios along the stroke, or over ranges."""
    drive = solution.plan.graph.pose.mechanism.drive
    stroke = extent.along_the_stroke(solution, results, report) if drive else {}
    return tuple(
        replace(result, extents=(stroke[result.name],))
        if result.name in stroke
        else replace(result, extents=tuple(_over_ranges(solution, result)))
        for result in results
    )


def _over_ranges(solution: Solution, result: Analysis) -> Iterator[Extent]:
    """Yield the extent of a ratio over each range in which it is proved to turn.

    Nothing where it may be infinite there.
    """
    bounded = all(pole.outside for pole in result.poles) and not result.breaks
    if not isinstance(result.target, LoadRatio) or not bounded or result.default is None:
        return
    mechanism = solution.plan.graph.pose.mechanism
    for name, trend in (result.trends or {}).items():
        ends = range_of(name, mechanism)
        if trend == "turns" and ends is not None:
            sweep = Sweep(solution.plan, name, {})
            extremes = _extremes(sweep, result, spaced(*ends, CELLS))
            if extremes:
                low, high = (f(extremes, key=lambda e: e.value) for f in (min, max))
                unit = unit_of(name, mechanism)
                scale = scale_of(result, mechanism)
                yield Extent(name, unit, ends, (), (), low, high, scale, False)


def _extremes(sweep: Sweep, result: Analysis, grid: Sequence[float]) -> list[Extreme]:
    """Return the values at the ends of a range and where they turn; none where some are missing."""
    values = [sweep.of(result, x) for x in grid]
    if not all(map(math.isfinite, values)):
        return []
    turning = [grid[0], grid[-1]]
    for i in range(1, len(grid) - 1):
        for sense in (1, -1):
            if sense * values[i] <= min(sense * values[i - 1], sense * values[i + 1]):
                turning.append(_turning(sweep, result, sense, grid[i - 1], grid[i + 1]))
    return [Extreme(x, sweep.of(result, x)) for x in turning]


def _turning(sweep: Sweep, result: Analysis, sense: int, low: float, high: float) -> float:
    return lowest(lambda x: sense * sweep.of(result, x), low, high)
