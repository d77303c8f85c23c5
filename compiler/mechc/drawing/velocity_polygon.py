"""The polygon of velocities: those of points from the pole, those relative to others between."""

import math
from collections.abc import Iterator
from itertools import combinations

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..figure.figure import Contact, Figure, Link, Slide, Slot, Telescope
from ..figure.velocities import MotionVelocities
from ..formula.names import split_points
from ..pose.places import NOWHERE, Plane
from .drawing import Arc, Drawing, TextRun
from .labels import AroundPoint, BesideLine
from .lettering import enumerated, name
from .pens import RELATIVE, SYMBOL, VELOCITY, Pen
from .sheet import Layer, Sheet
from .symbols import arrow
from .vectors import VelocityVectors, index

LARGE = 62.0
"""How wide or high the polygon is, in millimetres."""

SAME_DRAWN_POINT = 0.5
"""Points nearer to each other than this, in millimetres, are drawn as one."""

SHORTEST_NAMED = 5.0
"""An arrow shorter than this, in millimetres, is not named in the polygon."""

DOT = 0.6
"""The radius of a point of the polygon."""

AHEAD = math.radians(2.0)
"""Arrows from the pole with less than this between them lie on each other."""


class PolygonPoint(NamedTuple):
    """A place in the polygon, the points whose velocities end there, and those under a pin."""

    at: Plane
    points: tuple[str, ...]
    under: tuple[tuple[str, str], ...] = ()


class Side(NamedTuple):
    """A velocity of ``points[1]`` relative to ``points[0]``, which is a point or a body."""

    start: PolygonPoint
    end: PolygonPoint
    points: tuple[str, str]


def velocity_scale(velocities: MotionVelocities) -> float:
    """Return how many millimetres a unit of speed is."""
    ends = [NOWHERE, *velocities.points.values()]
    xs, ys = [end.x for end in ends], [end.y for end in ends]
    return LARGE / max(max(xs) - min(xs), max(ys) - min(ys))


class VelocityArrow(NamedTuple):
    """An arrow and what it is called."""

    tail: Plane
    tip: Plane
    runs: tuple[TextRun, ...]
    pen: Pen


class Polygon(NamedTuple):
    """The polygon, and what is said of arrows beside which there is no room."""

    drawing: Drawing
    left: tuple[tuple[TextRun, ...], ...]


def velocity_polygon(figure: Figure, velocities: MotionVelocities) -> Polygon:
    """Return the polygon of the velocities of one motion."""
    maker = _PolygonMaker(
        figure, velocities, VelocityVectors(velocities), velocity_scale(velocities)
    )
    return maker.polygon()


@frozen
class _PolygonMaker:
    """One motion at a scale in millimetres to a unit of speed."""

    figure: Figure
    velocities: MotionVelocities
    speeds: VelocityVectors
    scale: float

    def polygon(self) -> Polygon:
        sheet, nodes = Sheet(), self._nodes()
        arrows = list(self._arrows(nodes))
        for one in arrows:
            sheet.draw(Layer.LOADS, arrow(one.tail, one.tip, one.pen))
        for node in nodes:
            sheet.draw(Layer.PINS, [Arc(node.at, DOT, SYMBOL, fill="solid")])
        for node in nodes:
            towards = node.at.angle if node is not nodes[0] else -math.pi / 2
            runs = self._named(node, node is nodes[0])
            sheet.name_now(AroundPoint(node.at, runs, SYMBOL, towards, DOT))
        left = [one.runs for one in arrows if not _is_named(sheet, one, nodes)]
        return Polygon(sheet.finished("", ""), tuple(left))

    def _arrows(self, nodes: list[PolygonPoint]) -> Iterator[VelocityArrow]:
        """Yield the arrows from the pole, then those between other points."""
        for node in nodes[1:]:
            if node.points:
                yield VelocityArrow(NOWHERE, node.at, self._absolute(node), VELOCITY)
        for side in self._sides(nodes):
            yield VelocityArrow(side.start.at, side.end.at, self._relative(side), RELATIVE)

    # --------------------------------------------------------------------------- nodes

    def _nodes(self) -> list[PolygonPoint]:
        """Return the pole, which has what stands still, and where the other velocities end."""
        nodes = [PolygonPoint(NOWHERE, ())]
        for point, velocity in self.velocities.points.items():
            if split_points(point):
                self._join(nodes, PolygonPoint(velocity.times(self.scale), (point,)))
        for point, body, velocity in self.velocities.slidings:
            under = self.velocities.points[point].minus(velocity)
            self._join(nodes, PolygonPoint(under.times(self.scale), (), ((point, body),)))
        return nodes

    def _join(self, nodes: list[PolygonPoint], new: PolygonPoint) -> None:
        for i, node in enumerate(nodes):
            if math.dist(node.at, new.at) < SAME_DRAWN_POINT:
                nodes[i] = PolygonPoint(node.at, node.points + new.points, node.under + new.under)
                return
        nodes.append(new)

    def _sides(self, nodes: list[PolygonPoint]) -> Iterator[Side]:
        """Yield the relative velocities, one where several are between the same nodes."""
        known = set[frozenset[int]]()
        for points in self._pairs():
            start, end = (self._node(nodes, point) for point in points)
            ends = frozenset((nodes.index(start), nodes.index(end)))
            if nodes[0] not in (start, end) and len(ends) == 2 and ends not in known:
                known.add(ends)
                yield Side(start, end, points)
        for point, body, _ in self.velocities.slidings:
            start = next(node for node in nodes if (point, body) in node.under)
            end = self._node(nodes, point)
            if start != end:
                yield Side(start, end, (body, point))

    def _pairs(self) -> Iterator[tuple[str, str]]:
        """Yield the points between which there is a relative velocity.

        On a link that turns about a pivot those from the pole say it all.
        """
        for points in self._bodies():
            known = [p for p in points if p in self.velocities.points and split_points(p)]
            if all(self.velocities.speed(p) * self.scale > SAME_DRAWN_POINT for p in known):
                yield from combinations(known, 2)

    def _bodies(self) -> Iterator[tuple[str, ...]]:
        """Yield the points of each body, and what is in contact with one that only translates."""
        slides = {p.name: p.points[0] for p in self.figure.parts if isinstance(p, Slide)}
        for part in self.figure.parts:
            match part:
                case Link(points=points) | Telescope(points=points):
                    yield points
                case Slot(point=point, body=body) | Contact(point=point, body=body):
                    if body in slides:
                        yield slides[body], point
                case _:
                    pass

    def _node(self, nodes: list[PolygonPoint], point: str) -> PolygonPoint:
        return next(node for node in nodes if point in node.points)

    # ------------------------------------------------------------------------- lettering

    def _named(self, node: PolygonPoint, is_pole: bool) -> tuple[TextRun, ...]:
        """Return the small letters of the points that a node stands for."""
        taken = any(run.text == "P" for p in self.velocities.points for run in name(p))
        pole = [(TextRun("p", italic=True), *([TextRun("v", level=-1)] if taken else []))]
        parts = [
            *(pole if is_pole else []),
            *(_small(point) for point in node.points),
            *((*_small(point), *index(*_points(self.figure, body))) for point, body in node.under),
        ]
        return tuple(run for part in parts for run in (TextRun(", "), *part))[1:]

    def _absolute(self, node: PolygonPoint) -> tuple[TextRun, ...]:
        """Return the name and the size of the velocity from the pole to a node."""
        names = [self.speeds.name(point) for point in node.points]
        equal = tuple(run for named in names for run in (TextRun(" = "), *named))[1:]
        first = node.points[0]
        if self.velocities.per in node.points:
            return equal
        return (*equal, *self.speeds.size(self.velocities.speed(first), first))

    def _relative(self, side: Side) -> tuple[TextRun, ...]:
        """Return the name and the size of a relative velocity."""
        base, point = side.points
        speed = math.dist(side.start.at, side.end.at) / self.scale
        if base in self.velocities.points:
            return (*self.speeds.name(point, base), *self.speeds.size(speed, point, base))
        link = (run for end in _points(self.figure, base) for run in name(end))
        named = enumerated((name(point), link))
        return (TextRun("V", italic=True), *named, *self.speeds.size(speed, point, base))


def _small(point: str) -> tuple[TextRun, ...]:
    return tuple(run._replace(text=run.text.lower()) for run in name(point))


def _points(figure: Figure, body: str) -> tuple[str, ...]:
    links = (p for p in figure.parts if isinstance(p, Link) and p.name == body)
    return next((link.points for link in links), (body,))


def _is_named(sheet: Sheet, one: VelocityArrow, nodes: list[PolygonPoint]) -> bool:
    """Write the name of an arrow next to it; return whether it is long enough, with room."""
    start = one.tail if one.tail != NOWHERE else _behind(one.tip, nodes)
    if math.dist(start, one.tip) < SHORTEST_NAMED:
        return False
    return sheet.name_next_to(BesideLine(start, one.tip, one.runs, one.pen))


def _behind(tip: Plane, nodes: list[PolygonPoint]) -> Plane:
    """Return the end of the next shorter arrow that lies on one, else the pole."""
    length = math.hypot(*tip)
    on = [
        at
        for at, points, _ in nodes
        if points
        and 0 < math.hypot(*at) < length - SAME_DRAWN_POINT
        and abs(at.turned().dot(tip)) < AHEAD * math.hypot(*at) * length
        and at.dot(tip) > 0
    ]
    return max(on, key=lambda at: math.hypot(*at), default=NOWHERE)
