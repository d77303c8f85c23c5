"""Whether points stand where the drive takes them: only then do their positions make a path."""

import cmath
from collections.abc import Collection, Iterator, Mapping

from ...algebra.angle import Angle
from ...kinematics.plan import Plan
from ...model.mechanism import Link
from ...model.values import Chain, Values
from ...pose.motion import paths
from ...pose.pose import Vector, evaluate_vector
from ..pose_sweep import PoseSweep
from ..tolerances import DIFFERENCE, SAME_RATE, STILL
from .in_step import at_default, links_out_of_step

PointVelocities = Mapping[str, complex]
"""How fast points move, x and y as a complex number."""


def names_out_of_step(plan: Plan) -> frozenset[str]:
    """Return the names of links and points that do not follow the drive at its default.

    A rack drawn in one place stays there, whatever the gear does. Where the drive does not
    move all by itself, everything is where it is said to be.
    """
    found = at_default(plan)
    if found is None:
        return frozenset()
    links = tuple(one.link for one in links_out_of_step(plan, *found))
    return frozenset((*(link.name for link in links), *_points(plan, links, *found)))


def _points(plan: Plan, lost: Collection[Link], along: PoseSweep, x: float) -> Iterator[str]:
    """Yield the points whose positions do not change as the joints demand."""
    pose = plan.graph.pose
    located = paths(pose, lost)
    closing = Chain(dict(pose.closing))
    before, here, after = (
        closing.complete(along.values(x + step)) for step in (-DIFFERENCE, 0, DIFFERENCE)
    )
    drawn = {point: _rate(vector, before, after) for point, vector in located.items()}
    demanded = _demanded(plan, here)
    leader = max(drawn, key=lambda point: abs(drawn[point]), default="")
    if not demanded.get(leader):
        return
    pace = drawn[leader] / demanded[leader]
    fastest = abs(drawn[leader])
    for point, rate in drawn.items():
        if abs(rate - pace * demanded.get(point, 0)) > SAME_RATE * fastest:
            yield point


def _rate(vector: Vector, before: Values, after: Values) -> complex:
    start, end = (complex(*evaluate_vector(vector, values)) for values in (before, after))
    return (end - start) / (2 * DIFFERENCE)


def _demanded(plan: Plan, known: Values) -> PointVelocities:
    """Return the velocities that relations demand of points, of those that have a value."""
    values = dict(known)
    found: dict[str, complex] = {}
    try:
        for name, value in plan.bindings:
            values[name] = value.evaluate(values)
    except (KeyError, ZeroDivisionError):
        return found
    for point in plan.graph.velocities:
        try:
            velocity = _velocity(plan, point, values)
        except (KeyError, ZeroDivisionError):
            continue
        if cmath.isfinite(velocity):
            found[point] = velocity
    return found


def _velocity(plan: Plan, point: str, values: Values) -> complex:
    """Return a point's velocity per unit of the drive, 0 where the sum of its parts is rounding."""
    try:
        parts = [
            cmath.rect(
                size.evaluate(values) * plan.speeds[u][0].evaluate(values), d.evaluate(values)
            )
            for size, d, u in plan.graph.velocities[point]
        ]
    except ZeroDivisionError:  # of two poles that cancel algebra alone knows
        x, y = (plan.component(point, Angle.constant(a))[0] for a in (0, 90))
        return complex(x.evaluate(values), y.evaluate(values))
    velocity = sum(parts)
    return velocity if abs(velocity) > STILL * sum(map(abs, parts)) else 0j
