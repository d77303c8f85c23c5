"""Labels in the first free place among their candidates; the same places for the same drawing."""

import math
from collections.abc import Iterator
from itertools import count, product

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..pose.places import Plane, direction
from .drawing import Arc, Label, Polyline, TextRun
from .lettering import SIZE, text_size
from .occupied import Occupied, Rectangle, stretches
from .pens import HATCH, Pen
from .tolerances import HORIZONTAL

TURNS, TURNS_FAR = 16, 64
"""How many directions from a point are tried, near to it and farther off."""

LABEL_DISTANCES = (0.5, 1.2, 2.0, 3.2)
"""The distances from a point at which a label is tried first, in millimetres."""

LABEL_STEP = 2.0
"""By how much farther it is tried each time where all those are taken."""

ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75, 0.15, 0.85)
"""The parts of a line beside which its label is tried."""

AT_ENDS = (1.0, 0.0, 1.1, -0.1)
"""The parts of an arc at which, and beyond which, its label is tried where those are taken."""

PATIENCE = 6400
"""After so many places a line may lead to a label across another one."""


class LabelPlace(NamedTuple):
    """A place for a label; where ``far``, a line must lead from it to what it names."""

    at: Plane
    far: bool = False


class PlacedLabel(NamedTuple):
    """A label in its place, and the line that leads to it if there is one."""

    label: Label
    leader: tuple[Polyline, ...]


@frozen
class AroundPoint:
    """A name next to a point, as near to the direction ``towards`` as there is room.

    ``gap`` is the radius of what is drawn at the point.
    """

    at: Plane
    runs: tuple[TextRun, ...]
    pen: Pen
    towards: float
    gap: float = 0.0

    def candidates(self, width: float, height: float) -> Iterator[LabelPlace]:
        """Yield places for a box, the best first."""
        return _rings(self.at, self.towards, self.gap, width, height)


@frozen
class BesideLine:
    """A name beside a line, as near to its middle as there is room; above rather than below."""

    start: Plane
    end: Plane
    runs: tuple[TextRun, ...]
    pen: Pen

    @property
    def at(self) -> Plane:
        """Return the middle of the line."""
        return self.start.plus(self.end).times(0.5)

    def candidates(self, width: float, height: float) -> Iterator[LabelPlace]:
        """Yield places for a box, the best first."""
        yield from _sides(self.start, self.end, width, height)
        yield from _rings(self.at, math.pi / 2, 0.0, width, height)


@frozen
class AlongArc:
    """A name beside an arc, as near to its middle as there is room; outside rather than in."""

    arc: Arc
    runs: tuple[TextRun, ...]
    pen: Pen

    @property
    def at(self) -> Plane:
        """Return the middle of the arc."""
        return self.arc.at(0.5)

    def candidates(self, width: float, height: float) -> Iterator[LabelPlace]:
        """Yield places for a box, the best first."""
        yield from _round(self.arc, width, height)
        yield from _rings(self.at, self.arc.start + self.arc.sweep / 2, 0.0, width, height)


PlacedName = AroundPoint | BesideLine | AlongArc
"""What is to be written, and where it wants to be."""


def write(name: PlacedName, occupied: Occupied) -> PlacedLabel:
    """Return a label in the first free place, which is then taken."""
    width, height = text_size(name.runs, SIZE)
    for tried, (place, far) in enumerate(name.candidates(width, height)):
        if not occupied.free(place, width, height):
            continue
        label = Label(place, name.runs, name.pen, SIZE, width, height)
        leader = _leaders(name, label) if far else ()
        ways = (stretch for line in leader for stretch in stretches(line))
        if tried > PATIENCE or not any(occupied.written_on(*way) for way in ways):
            break
    occupied.write(Rectangle(label.at, width, height))
    occupied.add(*leader)
    return PlacedLabel(label, leader)


def next_to(name: BesideLine, occupied: Occupied) -> Label | None:
    """Return a label next to its line, which is then taken; None where there is no room."""
    width, height = text_size(name.runs, SIZE)
    for place, _ in _sides(name.start, name.end, width, height):
        if occupied.free(place, width, height):
            occupied.write(Rectangle(place, width, height))
            return Label(place, name.runs, name.pen, SIZE, width, height)
    return None


def _support(towards: Plane, width: float, height: float) -> float:
    """Return how far the corners of a box are from its middle in a direction."""
    return (abs(towards.x) * width + abs(towards.y) * height) / 2


def _rings(
    at: Plane, towards: float, gap: float, width: float, height: float
) -> Iterator[LabelPlace]:
    """Yield places around a point, the near ones first; there is no end to them."""
    for number in count():
        late = number - len(LABEL_DISTANCES) + 1
        distance = gap + (
            LABEL_DISTANCES[number] if late <= 0 else LABEL_DISTANCES[-1] + LABEL_STEP * late
        )
        turns = TURNS_FAR if late > 0 else TURNS
        for unit in (direction(towards + math.tau / turns * _alternating(i)) for i in range(turns)):
            place = at.plus(unit.times(distance + _support(unit, width, height)))
            yield LabelPlace(place, late > 0)


def _alternating(number: int) -> int:
    """Return 0, 1, −1, 2, −2, ….

    >>> [_alternating(i) for i in range(5)]
    [0, 1, -1, 2, -2]
    """
    return (number + 1) // 2 * (1 if number % 2 else -1)


def above(along: Plane) -> Plane:
    """Return the unit vector from a line to the side above it, of an upright one to the left.

    It is the same for the line that leads back.
    """
    left = along.turned()
    is_there = left.x < 0 if abs(left.y) <= HORIZONTAL else left.y > 0
    return left if is_there else left.times(-1)


def _sides(start: Plane, end: Plane, width: float, height: float) -> Iterator[LabelPlace]:
    along = end.minus(start).unit()
    if along is None:
        return
    upper = above(along)
    for distance in (0.6, 1.4):
        for part in ALONG:
            for side in (1, -1):
                out = upper.times(side * (distance + _support(upper, width, height)))
                yield LabelPlace(start.plus(end.minus(start).times(part)).plus(out))


def _round(arc: Arc, width: float, height: float) -> Iterator[LabelPlace]:
    for parts, distance, side in product((ALONG, AT_ENDS), (0.6, 1.6, 3.0), (1, -1)):
        for part in parts:
            out = direction(arc.start + part * arc.sweep).times(side)
            yield LabelPlace(arc.at(part).plus(out.times(distance + _support(out, width, height))))


def _leaders(name: PlacedName, label: Label) -> tuple[Polyline, ...]:
    """Return the line from a label to what it names: none to an arc that is next to it."""
    if not isinstance(name, AlongArc):
        return (_leader(name.at, label),)
    nearest = min(name.arc.way(), key=lambda at: math.dist(at, label.at))
    way = nearest.minus(label.at)
    gap = math.hypot(*way) - _support(way.unit() or way, label.width, label.height)
    return (_leader(nearest, label),) if gap > LABEL_DISTANCES[-1] + LABEL_STEP else ()


def _leader(named: Plane, label: Label) -> Polyline:
    """Return the line from a label to what it names; it ends before both."""
    way = label.at.minus(named)
    unit = way.unit() or Plane(0.0, 1.0)
    inside = min(
        half / abs(part) if part else math.inf
        for half, part in zip((label.width / 2, label.height / 2), unit, strict=True)
    )
    length = math.hypot(*way)
    ends = (named.plus(unit.times(min(1.5, length / 2))), label.at.minus(unit.times(inside + 0.5)))
    return Polyline(ends, HATCH)
