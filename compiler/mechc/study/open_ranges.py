"""Ranges of parameters that reach to where a loop does not close."""

from functools import partial

from ..diagnostics import Report
from ..diagnostics import stroke as messages
from ..kinematics.plan import Plan
from ..model.mechanism import Parameter
from ..model.values import bounds
from ..units import in_unit, si_unit
from .pose_sweep import EXCLUDED, NO_POSE, NOT_FOUND, PoseCode, PoseSweep, last_that


def remark(plan: Plan, report: Report) -> None:
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
