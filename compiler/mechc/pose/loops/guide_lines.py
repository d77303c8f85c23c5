"""Guides and slots as vectors of open length, for loops that close through them."""

from collections.abc import Iterator

from ...algebra.angle import Angle
from ...algebra.product import Product
from ...base.frozen import replace
from ...base.named import NamedTuple
from ...model.entries import points_of
from ...model.mechanism import (
    Arrow,
    ForcePair,
    Mechanism,
    Slider,
    Slot,
)
from ...source import Span
from ..directions import Directions
from ..pose import Arm
from ..vector_graph import Edge


class GuideLine(NamedTuple):
    """A line on which a pin slides: where it starts, its direction, the name of the distance.

    The distance is counted along the line, so that it is negative behind the start.
    """

    start: str
    pin: str
    angle: Angle
    length: str
    span: Span
    in_slot: bool = False

    @property
    def edge(self) -> Edge:
        """Return the vector from the start to the pin."""
        arm = Arm(Product.symbol(self.length), self.angle)
        return Edge(self.start, self.pin, (arm,), self.span)


def guide_lines(mechanism: Mechanism, directions: Directions) -> Iterator[GuideLine]:
    """Yield the guides that pass through a point, then the slots."""
    for joint in mechanism.joints:
        match joint:
            case Slider(pin, along, span, through):
                angle, start = directions.resolve(along, f"theta_{pin}"), through
            case Slot(pin, _, start, head, span):
                angle = directions.of(start, head)
            case _:
                continue  # no other joint leads a pin along a line of its own
        if start and angle is not None:
            name, in_slot = _length(start, pin, mechanism), isinstance(joint, Slot)
            yield GuideLine(start, pin, angle, name, span, in_slot)


def _length(start: str, pin: str, mechanism: Mechanism) -> str:
    """Return a name for the distance; that of a spring's ends means what is never negative."""
    name = f"len_{start}{pin}"
    springs = (t for t in mechanism.loads if isinstance(t, ForcePair) and t.spring)
    taken = any((t.first, t.second) == (start, pin) for t in springs)
    return name + "_" * (taken or any(literal.name == name for literal in mechanism.literals))


def with_lines(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with a vector for each slot's line that has none.

    Such a line only names the slot: its direction follows from a loop, its length is open.
    A slide does not turn, so the direction of a slot in it is the user's to give.
    """
    slides = {slide.name for slide in mechanism.slides}
    known = {frozenset(points_of(g)) for g in mechanism.geometry}
    lines = {
        frozenset((s.tail, s.head)): Arrow(s.tail, s.head, None, None, s.span)
        for s in mechanism.each(Slot)
        if s.link not in slides
    }
    fresh = tuple(line for pair, line in lines.items() if pair not in known)
    return replace(mechanism, geometry=(*mechanism.geometry, *fresh)) if fresh else mechanism
