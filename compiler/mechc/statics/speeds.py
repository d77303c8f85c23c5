"""Ratios of speeds out of statics: minus the inverse ratio of two loads in equilibrium.

With a load f on one point and a load of 1 on the other, both along the motions, the
balance of power f·V + 1·V' = 0 makes V'/V = −f. Nothing is said about velocities but
the directions in which they count as positive.
"""

import math

from ..base.named import NamedTuple
from ..model.mechanism import Speed, SpeedRatio
from .answers import Answer, combination
from .assembly import Action, Plane, direction
from .balanced import eliminated
from .equations import equilibrium
from .unfold import Unfolding
from .verdict import NO_SPEED

Probe = tuple[Action, ...]
"""A unit load that does work with one component of a speed."""

SLANT = 1.0
"""The direction, in radians, of the reference load on a point whose direction is open."""


class Probes(NamedTuple):
    """The loads that feel a speed: one where it has a sign, else one along x and one along y."""

    components: tuple[Probe, ...]
    reference: Probe


def speed_ratio(unfolding: Unfolding, target: SpeedRatio) -> Answer:
    """Return a ratio of speeds, its magnitude where :func:`has_sign` says that it has no sign."""
    above, below = _probes(unfolding, target.above), _probes(unfolding, target.below)
    upper = _size([dual_speed(unfolding, p, below.reference) for p in above.components])
    lower = _size([dual_speed(unfolding, p, below.reference) for p in below.components])
    scale = unfolding.count(target.below.of) / unfolding.count(target.above.of)
    if upper.trouble or lower.trouble or not lower.value:
        trouble = upper.trouble or lower.trouble or NO_SPEED
        return Answer(math.nan, math.inf, trouble)
    value = upper.value / lower.value * scale
    influence = (upper.influence * scale + lower.influence * abs(value)) / abs(lower.value)
    return Answer(value if has_sign(unfolding, target) else abs(value), influence)


def has_sign(unfolding: Unfolding, target: SpeedRatio) -> bool:
    """Return whether both speeds have a positive direction."""
    return all(
        speed.kind == "link" or direction_of_motion(unfolding, speed) is not None
        for speed in (target.above, target.below)
    )


def direction_of_motion(unfolding: Unfolding, speed: Speed) -> Plane | None:
    """Return the direction in which a point's speed counts as positive, None where it has none.

    That is along the axis of a component, along the guide of a slider or slide, and
    counter-clockwise about the pivot of a link.
    """
    if speed.axis:
        return Plane(1.0, 0.0) if speed.axis == "x" else Plane(0.0, 1.0)
    pose, point = unfolding.pose, speed.of
    guide = pose.guide_of(point)
    if guide is not None:
        return direction(guide.evaluate(unfolding.values))
    fixed = pose.mechanism.fixed - {point}
    for link in pose.mechanism.links:
        pivot = next((p for p in link.points if p in fixed), None)
        if pivot is not None and point in link.points:
            arm = unfolding.arm(link.name, pivot, point)
            return direction(math.atan2(arm.y, arm.x)).turned()
    return None


def _probes(unfolding: Unfolding, speed: Speed) -> Probes:
    """Return the loads that do work with a speed: along it, or along both axes where it is open."""
    if speed.kind == "link":
        couple = unfolding.couple(speed.of, 1.0)
        return Probes((couple,), couple)
    motion = direction_of_motion(unfolding, speed)
    if motion is not None:
        push = unfolding.push(speed.of, motion)
        return Probes((push,), push)
    axes = (Plane(1.0, 0.0), Plane(0.0, 1.0))
    components = tuple(unfolding.push(speed.of, axis) for axis in axes)
    return Probes(components, unfolding.push(speed.of, direction(SLANT)))


def dual_speed(unfolding: Unfolding, probe: Probe, reference: Probe) -> Answer:
    """Return the speed that a probe feels, in units of the one that the reference feels."""
    system = equilibrium(unfolding.assembly(("probe", probe), ("reference", reference)))
    right = {i: -amount for i, amount in system.loads["probe"].items()}
    column = len(system.unknowns)
    factors, units = eliminated(system, {"reference": system.loads["reference"]}, column)
    weights = {column: units["reference"]}
    answer = combination(system, factors, right, weights)
    return answer._replace(value=-answer.value)


def _size(components: list[Answer]) -> Answer:
    """Return a speed with its sign, or the magnitude of one that has two components."""
    trouble = next((a.trouble for a in components if a.trouble), "")
    influence = sum(a.influence for a in components)
    values = [a.value for a in components]
    return Answer(values[0] if len(values) == 1 else math.hypot(*values), influence, trouble)
