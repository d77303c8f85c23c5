"""Where a loop does not close: parts of the stroke, and ends of ranges that parameters have.

It is found by the pose alone, without any of the results.
"""

from collections.abc import Iterator
from functools import partial
from itertools import pairwise

from ..diagnostics import Report
from ..diagnostics import stroke as messages
from ..formula.numeric.roots import spaced
from ..kinematics.plan import Plan
from ..model.mechanism import Parameter
from ..model.values import bounds, range_of
from ..units import in_unit, si_unit
from .pose_sweep import EXCLUDED, NO_POSE, NOT_FOUND, PoseCode, PoseSweep, last_that
from .tolerances import FLAT_LOOP

CELLS = 120
"""Cells of a stroke whose ends are looked at."""

StrokePart = tuple[float, float]


def remark_on_stroke(plan: Plan, report: Report) -> tuple[StrokePart, ...]:
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


# --------------------------------------------------------------- ranges of parameters


def remark_on_ranges(plan: Plan, report: Report) -> None:
    """Report W284 for each range at an end of which a loop does not close, the rest at default.

    The drive's is left to its stroke.
    """
    code = PoseCode(plan)
    drive = code.mechanism.drive
    stroke = drive.parameter if drive and drive.low else ""
    varied = [p for p in code.mechanism.parameters if p.name != stroke and _is_varied(p)]
    sweeps = [PoseSweep(code, parameter.name) for parameter in varied]
    if not sweeps or not _is_closed(sweeps[0], sweeps[0].default):
        return
    for parameter, along in zip(varied, sweeps, strict=True):
        ends = bounds(parameter)
        if troubles := [along.trouble(end) for end in ends if not _is_closed(along, end)]:
            below, above = (_shown(_last(along, end), parameter) for end in ends)
            why = max(troubles, key=NO_POSE.index)
            place, name = parameter.span, parameter.name
            report.add(messages.range_not_assembled(place, name, below, above, why))


def _is_varied(parameter: Parameter) -> bool:
    """Return whether a parameter has a range, and a value of its own in it."""
    return bool(parameter.range and parameter.value and not parameter.dependent)


def _is_closed(along: PoseSweep, x: float) -> bool:
    """Return whether there is a pose, or none that a condition of use allows.

    Where iteration finds none there may be one.
    """
    return along.trouble(x) in ("", EXCLUDED, NOT_FOUND) or not along.is_allowed(x)


def _last(along: PoseSweep, end: float) -> float | None:
    """Return the value nearest to an end of a range at which the loops close; None at the end."""
    if _is_closed(along, end):
        return None
    return last_that(partial(_is_closed, along), along.default, end)


def _shown(value: float | None, parameter: Parameter) -> str:
    unit = parameter.unit or si_unit(parameter.dimension)
    return "" if value is None else in_unit(value, unit, 6)
