"""Where on its stroke a mechanism cannot be assembled, found without any of its results."""

from collections.abc import Iterator
from itertools import pairwise

from ...diagnostics import Report
from ...diagnostics import stroke as messages
from ...formula.roots import spaced
from ...kinematics.plan import Plan
from ...model.values import range_of
from ..pose_sweep import NO_POSE, PoseCode, PoseSweep, last_that
from ..tolerances import FLAT_LOOP

CELLS = 120
"""Cells of a stroke whose ends are looked at."""

StrokePart = tuple[float, float]


def remark(plan: Plan, report: Report) -> tuple[StrokePart, ...]:
    """Return the parts of the stroke on which a loop does not close, with W594 for all of them."""
    mechanism = plan.graph.pose.mechanism
    drive = mechanism.drive
    ends = range_of(drive.parameter, mechanism) if drive else None
    if not drive or not ends or not plan.graph.pose.loops:
        return ()
    parameter = mechanism.parameter(drive.parameter)
    wide = FLAT_LOOP * (ends[1] - ends[0])
    along, grid = PoseSweep(PoseCode(plan), drive.parameter, ends), spaced(*ends, CELLS)
    parts = _parts(along, grid)
    found = tuple((low, high) for low, high in parts if high - low > wide)
    if found:
        troubles = set(map(along.trouble, grid))
        worst = next(why for why in NO_POSE[::-1] if why in troubles)
        shown = drive.parameter, found, parameter.dimension, CELLS + 1, worst
        report.add(messages.not_assembled(drive.span, *shown))
    return found


def _parts(along: PoseSweep, grid: list[float]) -> Iterator[StrokePart]:
    """Yield the parts between points of a grid, each as far as a loop does not close."""

    def closes(x: float) -> bool:
        return along.trouble(x) not in NO_POSE

    closed = list(map(closes, grid))
    start = None if closed[0] else grid[0]
    for (a, b), (before, after) in zip(pairwise(grid), pairwise(closed), strict=True):
        if before and not after:
            start = last_that(closes, a, b)
        elif after and not before and start is not None:
            yield start, last_that(closes, b, a)
            start = None
    if start is not None:
        yield start, grid[-1]
