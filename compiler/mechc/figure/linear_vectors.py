"""The vectors that a drawing is put together from, linear in the lengths left open.

What is open is a length that the description does not give, or how far a pin is along its
guide. These must hold; where to draw what nothing else connects, :mod:`.joints` says.
"""

import math
from collections.abc import Iterator, Mapping

from ..algebra.angle import Angle
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.walk import symbols
from ..model.mechanism import Rack, Slider
from ..pose.places import NOWHERE, Plane, direction
from ..pose.pose import PointContact, Pose, Vector, evaluate_vector

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


class DrawnVector(NamedTuple):
    """A vector from one point to another."""

    tail: str
    head: str
    vector: Linear


def open_vector(tail: str, head: str, line: Plane) -> DrawnVector:
    """Return a vector of open length along a line, forward or back."""
    return DrawnVector(tail, head, Linear(NOWHERE, {f"{tail} to {head}": line}))


@frozen
class LinearVectors:
    """The vectors of a pose, at values of all its symbols but the open lengths."""

    pose: Pose
    values: Mapping[str, float]

    def firm(self) -> Iterator[DrawnVector]:
        """Yield the vectors that bodies, the description, slots, guides and the mirror give."""
        for frame in self.pose.frames.values():
            base, *others = frame
            yield from (self._way(base, p, frame[p]) for p in others if frame[p])
        for (tail, head), vector in self.pose.vectors.items():
            yield self._way(tail, head, vector)
        yield from self._touching()
        for slider in self.pose.mechanism.each(Slider):
            if slider.through:
                yield open_vector(slider.through, slider.point, self.guide(slider.point))
        yield from self._on_the_mirror()

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

    def _touching(self) -> Iterator[DrawnVector]:
        for contact in self.pose.contacts:
            if contact.reach:
                yield self._way(contact.tail, contact.point, contact.reach)
            elif contact.kind == "slot":
                yield open_vector(contact.tail, contact.point, self.face(contact).times(HALFWAY))

    def _on_the_mirror(self) -> Iterator[DrawnVector]:
        mirror, axis = self.pose.mechanism.mirror, self.pose.axis
        if mirror is not None and axis is not None:
            first, others = mirror.sharing[:1], mirror.sharing[1:]
            yield from (open_vector(first[0], point, self.unit(axis)) for point in others)

    def _way(self, tail: str, head: str, vector: Vector) -> DrawnVector:
        base, parts = NOWHERE, dict[str, Plane]()
        for arm in vector:
            names = sorted(symbols(arm.length.formula()) & self.pose.placeholders.keys())
            closed = {**self.values, **dict.fromkeys(names, 0.0)} if names else self.values
            fixed = Plane(*evaluate_vector((arm,), closed))
            base = base.plus(fixed)
            for name in names:
                one = Plane(*evaluate_vector((arm,), {**closed, name: 1.0}))
                parts[name] = parts.get(name, NOWHERE).plus(one.minus(fixed))
        return DrawnVector(tail, head, Linear(base, parts))


def usual(vectors: list[DrawnVector]) -> float:
    """Return the length of a usual vector: the mean of those given, 1 m where none is."""
    sizes = [math.hypot(*one.vector.base) for one in vectors]
    known = [size for size in sizes if size > 0]
    return sum(known) / len(known) if known else 1.0
