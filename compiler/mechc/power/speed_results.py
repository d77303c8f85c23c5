"""Ratios of speeds that are asked for: signed where a sign is defined, magnitudes elsewhere."""

from ..algebra.angle import Angle
from ..algebra.sums import canonical
from ..base.named import NamedTuple
from ..diagnostics import power as messages
from ..kinematics.plan import Plan, SpeedFactors
from ..model.mechanism import Find, Speed, SpeedRatio
from ..pose.pose import Arm, gathered
from ..units import FREQUENCY, VELOCITY, Dimension
from .balance import AlgebraicResult
from .magnitudes import length, magnitude
from .problem import PowerProblem


def speed_ratio(problem: PowerProblem, find: Find, asked: SpeedRatio) -> AlgebraicResult | None:
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
    return AlgebraicResult(problem.result(find, value.formula(), dimension, [value]), value)


def _dimension(wanted: Speed) -> Dimension:
    return FREQUENCY if wanted.kind == "link" else VELOCITY


class Rate(NamedTuple):
    """A speed per unit of each drive; ``signed`` if one of its two senses is positive."""

    speeds: SpeedFactors
    signed: bool = True


def speed(plan: Plan, wanted: Speed) -> Rate:
    """Return a speed per unit of each drive.

    A link's is counter-clockwise; a point's is signed along its guide, counter-clockwise
    about its link's pivot, and a magnitude elsewhere; a component along its axis.
    """
    if wanted.kind == "link":
        return Rate(plan.spin(wanted.of))
    if wanted.axis:
        axis = Angle.constant(0 if wanted.axis == "x" else 90)
        return Rate(plan.component(wanted.of, axis))
    guide = plan.graph.pose.guide_of(wanted.of)
    if guide is not None:
        return Rate(plan.component(wanted.of, guide))
    return _about_pivot(plan, wanted.of) or Rate(_lengths(plan, wanted.of), signed=False)


def _about_pivot(plan: Plan, point: str) -> Rate | None:
    """Return the speed of a point of a link on a pivot, ω·r; None of other points."""
    pose = plan.graph.pose
    fixed = pose.mechanism.fixed - {point}
    for link in pose.mechanism.links:
        pivot = next((p for p in link.points if p in fixed), None)
        if pivot and point in link.points:
            reach = magnitude(length(pose.vector(link.name, pivot, point)), pose.mechanism)
            return Rate(tuple(w * reach for w in plan.spin(link.name)))
    return None


def _lengths(plan: Plan, point: str) -> SpeedFactors:
    """Return |V| per unit of each drive, its sign open."""
    velocity = plan.graph.velocities[point]
    return tuple(
        length(gathered(Arm(f.size * plan.speeds[f.unknown][i], f.direction) for f in velocity))
        for i in range(plan.mobility)
    )
