"""The vectors that a drawing is put together from, linear in the lengths left open.

What is open is a length that the description does not give, or how far a pin is along its
guide. Firm ways must hold; loose ones only say where to draw what nothing else connects.
"""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import assert_never

from ..algebra.angle import Angle
from ..formula.walk import symbols
from ..frozen import frozen
from ..model.mechanism import Contact, Pivot, Rack, Rope, Screw, Slider, Slot, WheelPair
from ..named import NamedTuple
from ..pose.places import NOWHERE, Plane, direction
from ..pose.pose import PointContact, Pose, Vector, evaluate_vector

BESIDE = 0.25
"""How far from a slide a pin is drawn that touches it, in usual lengths."""


HALFWAY = 0.5
"""How far along its groove a pin is drawn that may be anywhere, in usual lengths."""


class Linear(NamedTuple):
    """A planar vector: ``base`` + Σ ``parts[name]`` · (the length of that name)."""

    base: Plane = NOWHERE
    parts: Mapping[str, Plane] = {}

    def plus(self, other: "Linear", sign: float = 1.0) -> "Linear":
        """Return the sum, or the difference for a sign of −1."""
        parts = dict(self.parts)
        for name, part in other.parts.items():
            parts[name] = parts.get(name, NOWHERE).plus(part.times(sign))
        return Linear(self.base.plus(other.base.times(sign)), parts)

    def at(self, lengths: Mapping[str, float]) -> Plane:
        """Return the vector at given lengths."""
        vector = self.base
        for name, part in self.parts.items():
            vector = vector.plus(part.times(lengths[name]))
        return vector


class Way(NamedTuple):
    """A vector from one point to another."""

    tail: str
    head: str
    vector: Linear


def along(tail: str, head: str, line: Plane) -> Way:
    """Return a way of open length along a line, forward or back."""
    return Way(tail, head, Linear(NOWHERE, {f"{tail} to {head}": line}))


@frozen
class Ways:
    """The ways of a pose, at values of all its symbols but the open lengths."""

    pose: Pose
    values: Mapping[str, float]

    def firm(self) -> Iterator[Way]:
        """Yield the vectors that bodies, the description, slots, guides and the mirror give."""
        for frame in self.pose.frames.values():
            base, *others = frame
            yield from (self._way(base, p, frame[p]) for p in others if frame[p])
        for (tail, head), vector in self.pose.vectors.items():
            yield self._way(tail, head, vector)
        yield from self._touching()
        for slider in self.pose.mechanism.each(Slider):
            if slider.through:
                yield along(slider.through, slider.point, self.guide(slider.point))
        yield from self._on_the_mirror()

    def loose(self) -> Iterator[Way]:
        """Yield where to draw what touches, meshes or slides, where nothing else says it."""
        mechanism, slides = self.pose.mechanism, self.pose.slides
        for contact in self.pose.contacts:
            if contact.kind == "contact" and not contact.reach:
                yield along(contact.tail, contact.point, self._beside(contact))
        for joint in mechanism.joints:
            match joint:
                case WheelPair(first=first, second=second):
                    step = self._away(joint).times(self._apart(joint))
                    yield Way(first, second, Linear(step))
                case Rack(point, pivot):
                    yield Way(pivot, point, Linear(self.right(joint)))
                case Screw():
                    yield self._beside_screw(joint)
                case Rope(route):
                    ways = zip(pairwise(route), self.pose.falls[joint.id], strict=True)
                    yield from (along(tail, head, self.unit(way)) for (tail, head), way in ways)
                case Pivot() | Slider() | Slot() | Contact():
                    pass
                case _:
                    assert_never(joint)
        for slide in mechanism.slides:
            first, *others = slide.points
            line = self.unit(slides[slide.name])
            yield from (along(first, p, line.times(i)) for i, p in enumerate(others, 1))

    def _beside_screw(self, screw: Screw) -> Way:
        """Return where to draw a nut: nuts on one screw stand in a row."""
        mechanism = self.pose.mechanism
        link = mechanism.link(screw.link)
        number = mechanism.each(Screw).index(screw) + 1
        return along(link.points[0], screw.point, self.guide(screw.point).times(number))

    def unit(self, angle: Angle) -> Plane:
        """Return the unit vector at an angle."""
        return direction(angle.evaluate(self.values))

    def guide(self, point: str) -> Plane:
        """Return the unit direction in which a slider, or a point of a slide, is guided."""
        angle = self.pose.guide_of(point)
        assert angle is not None
        return self.unit(angle)

    def face(self, contact: PointContact) -> Plane:
        """Return the unit direction of a slot's line, or of the face that a point touches."""
        return self.unit(contact.normal).turned().times(-1)

    def right(self, rack: Rack) -> Plane:
        """Return the vector from a gear's centre to the pitch point of its rack."""
        radius = self.pose.radii[rack.radius].evaluate(self.values)
        return self.guide(rack.point).turned().times(-radius)

    def _touching(self) -> Iterator[Way]:
        for contact in self.pose.contacts:
            if contact.reach:
                yield self._way(contact.tail, contact.point, contact.reach)
            elif contact.kind == "slot":
                yield along(contact.tail, contact.point, self.face(contact).times(HALFWAY))

    def _on_the_mirror(self) -> Iterator[Way]:
        mirror, axis = self.pose.mechanism.mirror, self.pose.axis
        if mirror is not None and axis is not None:
            first, others = mirror.sharing[:1], mirror.sharing[1:]
            yield from (along(first[0], point, self.unit(axis)) for point in others)

    def _beside(self, contact: PointContact) -> Plane:
        """Return where a pin touches a slide, from its first point: on the side it is pushed to."""
        frame = self.pose.frames[contact.body]
        row = 0 if any(frame.values()) else len(frame) - 1
        middle = self.unit(self.pose.slides[contact.body]).times(row / 2)
        return middle.plus(self.unit(contact.normal).times(BESIDE))

    def _away(self, mesh: WheelPair) -> Plane:
        """Return in which direction wheels stand in a row: away from a rack, if there is one."""
        racks = self.pose.mechanism.each(Rack)
        driven = [self.right(r).unit() for r in racks if r.pivot in (mesh.first, mesh.second)]
        right = (driven[0] if driven else None) or Plane(-1.0, 0.0)
        on_first = any(r.pivot == mesh.first for r in racks) or not driven
        return right.times(-1 if on_first else 1)

    def _apart(self, mesh: WheelPair) -> float:
        """Return how far apart two wheels are drawn: gears touch, a belt needs room."""
        radii = self.pose.radii
        first = radii[mesh.first_radius].evaluate(self.values)
        second = radii[mesh.second_radius].evaluate(self.values)
        if mesh.kind == "belt":
            return 2 * (first + second)
        return abs(first - second) if mesh.same else first + second

    def _way(self, tail: str, head: str, vector: Vector) -> Way:
        base, parts = NOWHERE, dict[str, Plane]()
        for arm in vector:
            names = sorted(symbols(arm.length.formula()) & self.pose.placeholders.keys())
            closed = {**self.values, **dict.fromkeys(names, 0.0)} if names else self.values
            fixed = Plane(*evaluate_vector((arm,), closed))
            base = base.plus(fixed)
            for name in names:
                one = Plane(*evaluate_vector((arm,), {**closed, name: 1.0}))
                parts[name] = parts.get(name, NOWHERE).plus(one.minus(fixed))
        return Way(tail, head, Linear(base, parts))


def usual(ways: list[Way]) -> float:
    """Return the length of a usual vector: the mean of those given, 1 m where none is."""
    sizes = [math.hypot(*way.vector.base) for way in ways]
    known = [size for size in sizes if size > 0]
    return sum(known) / len(known) if known else 1.0
