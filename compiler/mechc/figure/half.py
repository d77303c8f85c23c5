"""One half of a drawing: where the points, lines and lengths of a description are in it."""

from collections.abc import Iterable, Iterator, Mapping

from ..algebra.angle import Angle
from ..base.frozen import frozen
from ..formula.tree import Formula
from ..model.parts.linkage import primed
from ..pose.places import Plane, direction
from .figure import MirrorLine, Segment
from .linear_vectors import LinearVectors
from .outline import rods

REACH = 0.4
"""How far a guide or a face is drawn to either side of its pin, in usual lengths."""


@frozen
class Half:
    """One half of the drawing: the described one, or its mirror image.

    ``points`` are those of both halves, ``images`` has each that is not shared with the one that
    the mirror makes of it. Lines are given by their directions in the described
    half; ``sense`` is −1 in the twin, where what turned left turns right.
    """

    vectors: LinearVectors
    points: Mapping[str, Plane]
    size: float
    shared: frozenset[str]
    images: Mapping[str, str]
    mirror: MirrorLine | None
    sense: int = 1

    def point(self, name: str) -> str:
        """Return the name in this half of a point of the description."""
        return name if self.sense > 0 or name in self.shared else self.images[name]

    def link(self, name: str) -> str:
        """Return the name of a body in this half."""
        points = self.vectors.pose.frames.get(name, {})
        return name if self.sense > 0 or self.shared.issuperset(points) else primed(name)

    def vector(self, vector: Plane) -> Plane:
        """Return a vector of the described half as it is in this one."""
        if self.mirror is None or self.sense > 0:
            return vector
        return vector.reflected(self.mirror.along)

    def unit(self, angle: Angle) -> Plane:
        """Return the unit vector at an angle of the described half."""
        return self.vector(self.vectors.unit(angle))

    def turned(self, angle: float) -> float:
        """Return a direction of the described half, in radians, as it is in this one."""
        return angle if self.sense > 0 else self.vector(direction(angle)).angle

    def at(self, name: str) -> Plane:
        """Return where a point of the description is in this half."""
        return self.points[self.point(name)]

    def guide(self, point: str) -> Plane:
        """Return the unit direction in which a point is guided."""
        return self.vector(self.vectors.guide(point))

    def length(self, formula: Formula) -> float:
        """Return a radius or a pitch."""
        return self.vectors.pose.radii[formula].evaluate(self.vectors.values)

    def line(self, along: Plane, *points: str) -> Segment:
        """Return a line through the first of some points, to beyond all of them."""
        return self.through(along, [self.at(p) for p in points])

    def through(self, along: Plane, points: Iterable[Plane]) -> Segment:
        """Return a line through the first of some positions, to beyond all of them."""
        first, *others = points
        far = [0.0, *(along.dot(at.minus(first)) for at in others)]
        reach = REACH * self.size
        start, end = along.times(min(far) - reach), along.times(max(far) + reach)
        return Segment(first.plus(start), first.plus(end))

    def neighbours(self, point: str) -> Iterator[str]:
        """Yield the points to which bars lead from a point of the description."""
        mechanism = self.vectors.pose.mechanism
        bars = [bar for link in mechanism.links for bar in rods(link, mechanism.geometry)]
        bars += [(t.points[0], t.points[1]) for t in mechanism.telescopes]
        for tail, head in bars:
            if point in (tail, head):
                yield head if point == tail else tail
