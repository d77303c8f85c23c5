"""Ratios of speeds that are asked for."""

from ..algebra.sums import canonical
from ..diagnostics import power as messages
from ..model.mechanism import Find, Speed, SpeedRatio
from ..units import FREQUENCY, VELOCITY, Dimension
from .balance import Solved
from .problem import Problem
from .speeds import magnitude, speed


def speed_ratio(problem: Problem, find: Find, asked: SpeedRatio) -> Solved | None:
    """Return a speed per unit of another; None where that one is nothing, or they are unrelated.

    Reports E504 and E505 there.
    """
    above, below = asked.above, asked.below
    (upper, signed), (lower, signed_below) = (speed(problem.plan, s) for s in (above, below))
    moving = [i for i, v in enumerate(lower) if v]
    if not moving:
        problem.report.add(messages.speed_vanishes(find.span, below.name))
        return None
    if len(moving) > 1 or any(v for i, v in enumerate(upper) if i not in moving):
        ratio = f"{above.name}/{below.name}"
        problem.report.add(messages.speeds_independent(find.span, ratio))
        return None
    value = canonical(upper[moving[0]] / lower[moving[0]])
    if not (signed and signed_below):
        value = magnitude(value, problem.mechanism)
    dimension = _dimension(above).over(_dimension(below))
    return Solved(problem.result(find, value.formula(), dimension, [value]), value)


def _dimension(wanted: Speed) -> Dimension:
    return FREQUENCY if wanted.kind == "link" else VELOCITY
