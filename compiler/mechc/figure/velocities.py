"""Velocities as data: those of points and links at the pose of a figure.

Points and links are called as in the figure, of a mirrored mechanism those of the half
that is described. Angular velocities are counter-clockwise.
"""

import math
from collections.abc import Mapping

from ..frozen import frozen
from ..named import NamedTuple
from .figure import Plane


class Sliding(NamedTuple):
    """The velocity of a pin, or a point that touches, relative to the body under it."""

    point: str
    body: str
    velocity: Plane


@frozen
class Velocities:
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

    def times(self, factor: float) -> "Velocities":
        """Return the velocities of a motion that is faster by a factor."""
        return Velocities(
            self.per,
            {point: velocity.times(factor) for point, velocity in self.points.items()},
            {link: spin * factor for link, spin in self.spins.items()},
            tuple(s._replace(velocity=s.velocity.times(factor)) for s in self.slidings),
            self.chosen,
        )
