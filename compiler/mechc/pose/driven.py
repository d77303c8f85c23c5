"""A drawn mechanism whose drive is set to another place: ``-D phi_OA=30deg``."""

import math
from collections.abc import Mapping

from ..algebra.product import Product
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..frozen import replace
from ..model.values import Chain, defaults, dependent
from .pose import Pose


def driven_to(pose: Pose, report: Report) -> Pose:
    """Return the pose with its drive where it is set to; closures are those of the drawing.

    Reports E340 where a loop does not close there.
    """
    drive = pose.mechanism.drive
    if drive is None or drive.start is None:
        return pose
    parameters = tuple(
        replace(p, value=drive.start) if p.name == drive.parameter else p
        for p in pose.mechanism.parameters
    )
    moved = replace(pose, mechanism=replace(pose.mechanism, parameters=parameters))
    if loop := _open_loop(moved):
        report.add(messages.out_of_reach(drive.span, loop, drive.parameter))
    return moved


def _open_loop(pose: Pose) -> str:
    """Return a loop that does not close at the default values, '' where all do."""
    formulas = {**dependent(pose.mechanism), **dict(pose.closing)}
    values = Chain(formulas).complete(defaults(pose.mechanism))
    for limit in pose.limits:
        margins = [_evaluated(margin, values) for margin in limit.margins]
        found = [values[name] for name in formulas if name in values]
        is_lost = limit.group == "system" and not all(map(math.isfinite, found))
        if is_lost or any(margin < 0 for margin in margins):
            return limit.loop
    return ""


def _evaluated(margin: Product, values: Mapping[str, float]) -> float:
    """Return the value of what is positive where a loop closes, NaN where it has none."""
    try:
        return margin.evaluate(values)
    except (KeyError, ZeroDivisionError, ValueError, OverflowError):
        return math.nan
