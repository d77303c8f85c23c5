"""Velocities in numbers: those of points and links at the pose of a figure.

Points and links are called as in the figure, of a mirrored mechanism those of the half
that is described. Angular velocities are counter-clockwise.
"""

import math
from collections.abc import Iterator, Mapping

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..kinematics.graph import Velocity
from ..kinematics.plan import Plan, SpeedFactors
from ..model.values import Values
from ..pose.places import NOWHERE, Plane, direction
from .figure import Contact, Figure, Link, Slot


class Sliding(NamedTuple):
    """The velocity of a pin, or a point that touches, relative to the body under it."""

    point: str
    body: str
    velocity: Plane


@frozen
class MotionVelocities:
    """The velocities of one independent motion, while the others stand still.

    They are in metres and radians a second. Where nothing gives how fast it moves they are
    per unit of the speed of the point ``per``. ``chosen`` are the points and links whose
    velocities depend on lengths that nothing gives.
    """

    per: str
    points: Mapping[str, Plane]
    spins: Mapping[str, float]
    slidings: tuple[Sliding, ...]
    chosen: frozenset[str] = frozenset()

    def speed(self, point: str) -> float:
        """Return how fast a point moves."""
        return math.hypot(*self.points.get(point, (0.0, 0.0)))

    @property
    def largest(self) -> float:
        """Return the largest speed of a point; 0 where none moves."""
        return max(map(self.speed, self.points), default=0.0)

    def times(self, factor: float) -> "MotionVelocities":
        """Return the velocities of a motion that is faster by a factor."""
        return MotionVelocities(
            self.per,
            {point: velocity.times(factor) for point, velocity in self.points.items()},
            {link: spin * factor for link, spin in self.spins.items()},
            tuple(s._replace(velocity=s.velocity.times(factor)) for s in self.slidings),
            self.chosen,
        )


def rates(plan: Plan, figure: Figure, given: Values, drive: int) -> MotionVelocities:
    """Return velocities per unit of a drive; KeyError where something has no value there.

    ZeroDivisionError where the drive can't move the mechanism.
    """
    values = dict(given)
    for name, value in plan.bindings:
        values[name] = value.evaluate(values)

    def number(speeds: SpeedFactors) -> float:
        return speeds[drive].evaluate(values)

    unknowns = {unknown: number(speeds) for unknown, speeds in plan.speeds.items()}
    points = {
        point: _velocity(flows, unknowns, values)
        for point, flows in plan.graph.velocities.items()
        if point in figure.points
    }
    spins = {link: number(plan.spin(link)) for link in _links(plan, figure, points)}
    return MotionVelocities("", points, spins, tuple(_slidings(figure, points, spins)))


def _velocity(flows: Velocity, unknowns: Mapping[int, float], values: Values) -> Plane:
    found = NOWHERE
    for size, along, unknown in flows:
        speed = size.evaluate(values) * unknowns[unknown]
        found = found.plus(direction(along.evaluate(values)).times(speed))
    return found


def _links(plan: Plan, figure: Figure, points: Mapping[str, Plane]) -> Iterator[str]:
    """Yield the links of the half that is described."""
    frames = plan.graph.pose.frames
    links = (part for part in figure.parts if isinstance(part, Link) and part.name in frames)
    for link in links:
        if points.keys() >= {*link.points}:
            yield link.name


def _slidings(
    figure: Figure, points: Mapping[str, Plane], spins: Mapping[str, float]
) -> Iterator[Sliding]:
    """Yield how pins move in slots, and points along the links that they touch."""
    tails = {part.name: part.points[0] for part in figure.parts if isinstance(part, Link)}
    for part in figure.parts:
        if isinstance(part, Slot | Contact) and part.point in points and part.body in spins:
            tail = tails[part.body]
            arm = figure.points[part.point].minus(figure.points[tail])
            under = points[tail].plus(arm.turned().times(spins[part.body]))
            yield Sliding(part.point, part.body, points[part.point].minus(under))
