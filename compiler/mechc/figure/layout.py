"""Every point in its place: what hangs together as it must, the rest side by side."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..model.mechanism import Force, Mechanism, Pivot, Slider
from ..pose.places import NOWHERE, KnownVector, Plane, between, placed
from .figure import MirrorLine
from .joints import loose_vectors
from .lengths import choose
from .linear_vectors import LinearVectors, usual
from .tolerances import SAME_PLACE

ORIGIN = ""
"""The name of the plane's origin in the geometry."""

NEARLY = 0.15
"""A point and its twin that are nearer to each other than this, in usual lengths, should not be."""

STRETCHED = (1.3, 1.6, 2.0, 2.5, 3.2, 4.0)
"""By what usual lengths are multiplied where nothing gives a length, until the halves are apart."""

SHRUNK = (0.7, 0.5)
"""By what they are where all that is longer leaves twins too near each other."""

PARTS_APART = 0.5
"""How far apart unconnected parts are drawn, in usual lengths."""

FigurePoints = dict[str, Plane]


class FigureLayout(NamedTuple):
    """The points of the described half, the mirror line, and what was chosen for it.

    ``gap`` is by how much the vectors miss each other, in usual lengths.
    """

    points: Mapping[str, Plane]
    mirror: MirrorLine | None
    lengths: Mapping[str, float]
    size: float
    gap: float


def lay_out(vectors: LinearVectors) -> FigureLayout:
    """Return where every point of the description is; the first pivot is at the origin.

    Where pivots have places the origin is that of the description. Lengths that nothing gives
    are such that a point and its twin are in one place, or clearly in two, and that no half
    reaches across the mirror line, where they can be.
    """
    found = _laid_out(vectors, 1.0)
    if not found.lengths or not (_nearly_meet(vectors, found) or _reaches_across(vectors, found)):
        return found
    apart = [] if _nearly_meet(vectors, found) else [found]
    apart += _apart(vectors, found, STRETCHED)
    within = (layout for layout in apart if not _reaches_across(vectors, layout))
    return next(chain(within, apart, _apart(vectors, found, SHRUNK)), found)


def _apart(
    vectors: LinearVectors, found: FigureLayout, factors: Iterable[float]
) -> Iterator[FigureLayout]:
    """Yield layouts with other lengths whose twins are apart, and whose loops close as well."""
    for factor in factors:
        other = _laid_out(vectors, factor)
        if not _nearly_meet(vectors, other) and other.gap <= max(found.gap, SAME_PLACE):
            yield other


def _nearly_meet(vectors: LinearVectors, layout: FigureLayout) -> bool:
    """Return whether some point is nearly where its twin is, but not quite."""
    return any(SAME_PLACE < abs(2 * off) < NEARLY for off in _off_the_mirror(vectors, layout))


def _reaches_across(vectors: LinearVectors, layout: FigureLayout) -> bool:
    """Return whether the described half has points on both sides of the mirror line."""
    off = [at for at in _off_the_mirror(vectors, layout) if abs(at) > SAME_PLACE]
    return any(at > 0 for at in off) and any(at < 0 for at in off)


def _off_the_mirror(vectors: LinearVectors, layout: FigureLayout) -> list[float]:
    """Return how far the points of one half are off the mirror line, in usual lengths."""
    mirror, symmetry = layout.mirror, vectors.pose.mechanism.mirror
    if mirror is None or symmetry is None:
        return []
    across = mirror.along.turned()
    own = (at for name, at in layout.points.items() if name not in symmetry.sharing)
    return [across.dot(at.minus(mirror.at)) / layout.size for at in own]


def _laid_out(vectors: LinearVectors, factor: float) -> FigureLayout:
    """Return the layout with open lengths that are this many times a usual one, if they can be."""
    pose, firm = vectors.pose, list(vectors.firm())
    size = usual(firm)
    lengths = choose(firm, pose.placeholders, factor * size)
    names = [*dict.fromkeys(points_of(pose.mechanism))]
    edges = [KnownVector(w.tail, w.head, w.vector.at(lengths)) for w in firm]
    places = placed(
        _connected([*(KnownVector(n, n, NOWHERE) for n in names), *edges], vectors, size)
    )
    groups: dict[str, FigurePoints] = {}
    for name, place in places.items():
        groups.setdefault(place.start, {})[name] = place.at
    table = _Table(vectors.unit(pose.axis) if pose.axis else None, size)
    sharing = pose.mechanism.mirror.sharing if pose.mechanism.mirror else ()
    points, mirror = table.spread(list(groups.values()), sharing)
    found = {name: lengths[name] for name in pose.placeholders}
    gap = max((math.dist(edge.vector, _span(edge, points)) for edge in edges), default=0.0)
    return FigureLayout({n: points[n] for n in names}, mirror, found, size, gap / size)


def _span(edge: KnownVector, points: FigurePoints) -> Plane:
    """Return the vector between the ends of an edge, where they have come to stand."""
    return points[edge.head].minus(points[edge.tail])


def points_of(mechanism: Mechanism) -> Iterable[str]:
    """Yield the points of a mechanism, those on the ground first, some of them repeatedly."""
    yield from (pivot.point for pivot in mechanism.each(Pivot))
    yield from (slider.point for slider in mechanism.each(Slider))
    for body in mechanism.bodies:
        yield from body.points
    for joint in mechanism.joints:
        yield from joint.points
    yield from (load.point for load in mechanism.loads if isinstance(load, Force))


def _connected(edges: list[KnownVector], vectors: LinearVectors, size: float) -> list[KnownVector]:
    """Return the edges with loose ones, as long as they connect what is not connected yet."""
    for tail, head, vector in loose_vectors(vectors):
        if between(placed(edges), tail, head) is None:
            edges.append(KnownVector(tail, head, vector.at(dict.fromkeys(vector.parts, size))))
    return edges


@frozen
class _Table:
    """Where groups of points are laid side by side, away from the mirror line if there is one."""

    axis: Plane | None
    size: float

    def spread(
        self, groups: Sequence[FigurePoints], sharing: Sequence[str]
    ) -> tuple[FigurePoints, MirrorLine | None]:
        """Return all points in one plane, and the mirror line."""
        first, *others = sorted(groups, key=lambda g: (not _holds(g, sharing), ORIGIN not in g))
        start = first[ORIGIN] if ORIGIN in first else next(iter(first.values()))
        points = {name: at.minus(start) for name, at in first.items()}
        mirror = self._line(points, sharing)
        side = self._side(points, mirror)
        for group in others:
            step = self._beside(points, group, side)
            points |= {name: at.plus(step) for name, at in group.items()}
        return points, mirror

    def _line(self, points: FigurePoints, sharing: Sequence[str]) -> MirrorLine | None:
        if self.axis is None:
            return None
        if sharing:
            return MirrorLine(points[sharing[0]], self.axis)
        left = self.axis.turned()
        reach = max(left.dot(at) for at in points.values()) + PARTS_APART * self.size
        return MirrorLine(left.times(reach), self.axis)

    def _side(self, points: FigurePoints, mirror: MirrorLine | None) -> Plane:
        """Return the direction in which to go on: that in which the half is from its line."""
        if mirror is None:
            return Plane(1.0, 0.0)
        right = mirror.along.turned().times(-1)
        lean = math.fsum(right.dot(at.minus(mirror.at)) for at in points.values())
        return right if lean >= 0 else right.times(-1)

    def _beside(self, points: FigurePoints, group: FigurePoints, side: Plane) -> Plane:
        """Return the step that takes a group beyond the points placed so far."""
        up = side.turned()
        far = max(side.dot(at) for at in points.values())
        near = min(side.dot(at) for at in group.values())
        rise = _middle(points, up) - _middle(group, up)
        return side.times(far + PARTS_APART * self.size - near).plus(up.times(rise))


def _holds(group: FigurePoints, sharing: Sequence[str]) -> bool:
    return any(point in group for point in sharing)


def _middle(points: FigurePoints, line: Plane) -> float:
    heights = [line.dot(at) for at in points.values()]
    return (min(heights) + max(heights)) / 2
