"""The parts of a figure: what is drawn of each joint, body and load, in one half or its twin."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import assert_never

from ..algebra.angle import Angle
from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..frozen import frozen, replace
from ..model import mechanism as model
from ..pose.places import NOWHERE, Plane, direction
from ..pose.pose import PointContact
from . import figure as drawn
from .figure import MirrorLine, Part, Segment
from .outline import outline, rods
from .ropes import rope_runs
from .ways import Ways
from .wheels import Circle, pitch_point, runs

DOWN, UP, LEFT, RIGHT = Plane(0.0, -1.0), Plane(0.0, 1.0), Plane(-1.0, 0.0), Plane(1.0, 0.0)
GROUNDS = (DOWN, UP, LEFT, RIGHT, *(direction(math.radians(45 + 90 * i)) for i in (2, 3, 1, 0)))
"""Where the ground may be, seen from a pivot: the usual places first."""

APART = math.radians(50)
"""The angle between the ground of a pivot and the bars that leave it, where there is room."""

PULLEY = 0.07
"""The radius at which a pulley is drawn, in usual lengths."""

REACH = 0.4
"""How far a guide or a face is drawn to either side of its pin, in usual lengths."""


@frozen
class Half:
    """One half of the drawing: the described one, or its mirror image.

    ``points`` are those of both halves. Lines are given by their directions in the described
    half; ``sense`` is −1 in the twin, where what turned left turns right.
    """

    ways: Ways
    points: Mapping[str, Plane]
    size: float
    shared: frozenset[str]
    mirror: MirrorLine | None
    sense: int = 1

    def parts(self) -> Iterator[Part]:
        """Yield the drawn part of every body, joint and load."""
        mechanism = self.ways.pose.mechanism
        for body in mechanism.bodies:
            yield self.body(body)
        for joint in joints(mechanism):
            yield self.joint(joint)
        for load in mechanism.loads:
            yield self.load(load)

    def point(self, name: str) -> str:
        """Return the name in this half of a point of the description."""
        if self.sense > 0 or name in self.shared:
            return name
        return name[:-1] if name.endswith("'") and name[:-1] in self.points else f"{name}'"

    def link(self, name: str) -> str:
        """Return the name of a body in this half."""
        points = self.ways.pose.frames.get(name, {})
        return name if self.sense > 0 or self.shared.issuperset(points) else f"{name}'"

    def vector(self, vector: Plane) -> Plane:
        """Return a vector of the described half as it is in this one."""
        if self.mirror is None or self.sense > 0:
            return vector
        return vector.reflected(self.mirror.along)

    def unit(self, angle: Angle) -> Plane:
        """Return the unit vector at an angle of the described half."""
        return self.vector(self.ways.unit(angle))

    def turned(self, angle: float) -> float:
        """Return a direction of the described half, in radians, as it is in this one."""
        return angle if self.sense > 0 else self.vector(direction(angle)).angle

    def at(self, name: str) -> Plane:
        """Return where a point of the description is in this half."""
        return self.points[self.point(name)]

    # --------------------------------------------------------------------- bodies

    def body(self, body: model.Body) -> Part:
        """Return the drawn part of a body."""
        points = tuple(map(self.point, body.points))
        match body:
            case model.Link(arc=model.ArcSlot(link, centre, radius)):
                groove = self.length(radius)
                return drawn.ArcSlot(points[1], self.link(link), self.point(centre), groove)
            case model.Link(name):
                bars = rods(body, self.ways.pose.mechanism.geometry)
                named = tuple((self.point(a), self.point(b)) for a, b in bars)
                corners = outline(points, self.points)
                return drawn.Link(self.link(name), points, corners, named, body.label)
            case model.Slide(name):
                along = self.unit(self.ways.pose.slides[name])
                corners = outline(points, self.points)
                guide = self._line(along, *body.points)
                return drawn.Slide(self.link(name), points, corners, along, guide)
            case model.Telescope(name):
                twin = "" if points == body.points else "'"
                return drawn.Telescope(name + twin, (points[0], points[1]))
            case _:
                assert_never(body)

    # --------------------------------------------------------------------- joints

    def joint(self, joint: model.Joint) -> Part:
        """Return the drawn part of a joint."""
        match joint:
            case model.Pivot(point):
                return drawn.Pivot(self.point(point), self.vector(self._ground(point)))
            case model.Slider(point):
                along, through = self.unit(self.ways.pose.guides[point]), joint.through
                line = self._line(along, point, *((through,) if through else ()))
                return drawn.Slider(
                    self.point(point), along, line, self.point(through) if through else ""
                )
            case model.Slot():
                return self._slot(joint)
            case model.Contact():
                return self._contact(joint)
            case model.WheelPair():
                return self._wheels(joint)
            case model.Rack():
                return self._rack(joint)
            case model.Screw(point, pitch, link):
                along = self.guide(point)
                turn = self.sense * self.length(pitch)
                return drawn.Screw(
                    self.point(point), self.link(link), turn, along, self._line(along, point)
                )
            case model.Rope():
                return self._rope(joint)
            case _:
                assert_never(joint)

    def _rope(self, rope: model.Rope) -> drawn.Rope:
        drums = {k.place: k.reach for k in self._sliding_ropes() if k.joint == rope.id}
        reaches = [drums.get(i) for i in range(len(rope.route))]
        radii = [None if r is None else self.sense * self.length(r) for r in reaches]
        pulley = PULLEY * self.size
        runs = tuple(rope_runs([self.at(point) for point in rope.route], radii, pulley))
        sizes = tuple(pulley if radius is None else abs(radius) for radius in radii[1:-1])
        return drawn.Rope(tuple(map(self.point, rope.route)), runs, sizes)

    def _sliding_ropes(self) -> Iterator[model.RopeFriction]:
        """Yield the friction of ropes around pulleys."""
        joints = self.ways.pose.mechanism.friction.joints
        yield from (joint for joint in joints if isinstance(joint, model.RopeFriction))

    def _ground(self, point: str) -> Plane:
        """Return where the ground of a pivot is: down, where no bar of the described half is."""
        half = replace(self, sense=1)
        bars = [half.at(other).minus(half.at(point)).unit() for other in half.neighbours(point)]
        ways = [unit for unit in bars if unit is not None]
        if point in self.shared and self.mirror is not None:
            ways += [unit.reflected(self.mirror.along) for unit in ways]
        room = {g: min((_angle(g, unit) for unit in ways), default=math.pi) for g in GROUNDS}
        return max(GROUNDS, key=lambda ground: min(room[ground], APART))

    def neighbours(self, point: str) -> Iterator[str]:
        """Yield the points to which bars lead from a point of the description."""
        mechanism = self.ways.pose.mechanism
        bars = [bar for link in mechanism.links for bar in rods(link, mechanism.geometry)]
        bars += [(t.points[0], t.points[1]) for t in mechanism.telescopes]
        for tail, head in bars:
            if point in (tail, head):
                yield head if point == tail else tail

    def guide(self, point: str) -> Plane:
        """Return the unit direction in which a point is guided."""
        return self.vector(self.ways.guide(point))

    def length(self, formula: Formula) -> float:
        """Return a radius or a pitch."""
        return self.ways.pose.radii[formula].evaluate(self.ways.values)

    def _slot(self, slot: model.Slot) -> drawn.Slot:
        along = self.vector(self.ways.face(self._touch("slot", slot.point)))
        if along.dot(self.at(slot.head).minus(self.at(slot.tail))) < 0:
            along = along.times(-1)
        return drawn.Slot(
            self.point(slot.point),
            self.link(slot.link),
            self.point(slot.tail),
            self.point(slot.head),
            along,
            self._line(along, slot.point),
            slot.guided and self.link(slot.guided),
        )

    def _contact(self, contact: model.Contact) -> drawn.Contact:
        touch = self._touch("contact", contact.point)
        face = self._line(self.vector(self.ways.face(touch)), contact.point)
        normal = self.unit(touch.normal)
        return drawn.Contact(self.point(contact.point), self.link(contact.link), normal, face)

    def _touch(self, kind: str, point: str) -> PointContact:
        touches = self.ways.pose.touches
        return next(t for t in touches if (t.kind, t.point) == (kind, point))

    def _wheels(self, mesh: model.WheelPair) -> drawn.Gears | drawn.Belt:
        first, second = self.point(mesh.first), self.point(mesh.second)
        radius, other = self.length(mesh.first_radius), self.length(mesh.second_radius)
        circles = Circle(self.points[first], radius), Circle(self.points[second], other)
        wheels = (
            *(first, mesh.first_link and self.link(mesh.first_link), radius),
            *(second, mesh.second_link and self.link(mesh.second_link), other),
        )
        if mesh.kind == "gear":
            touch = pitch_point(*circles, inner=mesh.same)
            return drawn.Gears(*wheels, mesh.same, touch)
        crossed = not mesh.same
        return drawn.Belt(*wheels, crossed, runs(*circles, crossed=crossed))

    def _rack(self, rack: model.Rack) -> drawn.Rack:
        along = self.guide(rack.point)
        touch = self.at(rack.pivot).plus(self.vector(self.ways.right(rack)))
        line = self._through(along, (touch, self.at(rack.point)))
        return drawn.Rack(
            self.point(rack.point),
            self.point(rack.pivot),
            self.link(rack.link),
            self.sense * self.length(rack.radius),
            along,
            line,
            touch,
        )

    # ---------------------------------------------------------------------- loads

    def load(self, load: model.Load) -> Part:
        """Return the drawn part of a load."""
        match load:
            case model.Force(spread=model.Spread() as spread):
                return self._spread(load, spread)
            case model.Force(name, point):
                along, times = self.unit(self.ways.pose.lines[name]), float(load.times)
                link = load.link and self.link(load.link)
                return drawn.Force(name, self.point(point), along, load.weight, times, link)
            case model.Torque(name, link):
                at, times = self._hub(link), float(load.times)
                return drawn.Torque(name, self.link(link), at, self.sense > 0, times)
            case model.ForcePair(name, first, second):
                kind = drawn.Spring if load.spring else drawn.Actuator
                links = (link and self.link(link) for link in (load.first_link, load.second_link))
                return kind(name, self.point(first), self.point(second), *links)
            case _:
                assert_never(load)

    def _spread(self, load: model.Force, spread: model.Spread) -> drawn.SpreadLoad:
        """Return the drawn part of a distributed load."""
        values = self.ways.values
        given = all(symbols(q) <= values.keys() for q in spread.intensities)
        known = [evaluate(q, values) for q in spread.intensities] if given else []
        return drawn.SpreadLoad(
            load.name,
            self.point(load.point),
            self.unit(self.ways.pose.lines[load.name]),
            float(load.times),
            self.link(spread.link),
            self.point(spread.tail),
            self.point(spread.head),
            *(known[0] if known else 1.0, known[-1] if known else 1.0),
        )

    def _hub(self, link: str) -> Plane:
        """Return the place of a couple: the link's pivot, or its middle."""
        mechanism = self.ways.pose.mechanism
        points = tuple(self.ways.pose.frames[link])
        fixed = [p.point for p in mechanism.each(model.Pivot) if p.point in points]
        chosen = [self.at(p) for p in (fixed[:1] or points)]
        total = NOWHERE
        for at in chosen:
            total = total.plus(at)
        return total.times(1 / len(chosen))

    # ---------------------------------------------------------------------- lines

    def _line(self, along: Plane, *points: str) -> Segment:
        return self._through(along, [self.at(p) for p in points])

    def _through(self, along: Plane, points: Iterable[Plane]) -> Segment:
        """Return a line through the first of some places, to beyond all of them."""
        first, *others = points
        far = [0.0, *(along.dot(at.minus(first)) for at in others)]
        reach = REACH * self.size
        start, end = along.times(min(far) - reach), along.times(max(far) + reach)
        return Segment(first.plus(start), first.plus(end))


def _angle(one: Plane, other: Plane) -> float:
    """Return the angle between two unit vectors, without its sense."""
    return abs(math.atan2(one.turned().dot(other), one.dot(other)))


def joints(mechanism: model.Mechanism) -> Iterator[model.Joint]:
    """Yield the joints of a mechanism; a place that a guide goes through is no pivot.

    Where a drawn mechanism stands still, the guide no longer names its place: ``C_0`` of slider C.
    """
    places = {s.through for s in mechanism.each(model.Slider)} - mechanism.spans.keys()
    places |= {f"{s.point}_0" for s in mechanism.each(model.Slider)}
    for joint in mechanism.joints:
        if not isinstance(joint, model.Pivot) or joint.point not in places:
            yield joint
