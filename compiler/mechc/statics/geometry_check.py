"""Whether the mechanism stands as described: loops closed, given lengths and angles kept.

Both virtual power and equilibrium take the pose for granted. This looks at it with the
eyes of a draughtsman: every point is put in its place by going along the links and the
vectors given in full, and then everything said about the geometry is measured.
"""

import math
from collections.abc import Iterator, Mapping
from typing import assert_never

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Absolute, AlongLine, Arrow, Direction, Geometry, Offset, Slider, Turn
from ..pose.places import KnownVector, Plane, PointPlaces, between, direction, placed
from ..pose.pose import Pose, evaluate_vector
from .tolerances import LOOP_GAP


class Discrepancy(NamedTuple):
    """What does not fit, and by how much in metres."""

    what: str
    size: float


def worst_gap(pose: Pose, values: Mapping[str, float]) -> Discrepancy | None:
    """Return the largest gap of the pose at these values, None where all fits."""
    edges = [*_links(pose, values), *_vectors(pose, values)]
    drawing = PlacedPoints(placed(edges), values)
    gaps = [drawing.loop(edge) for edge in edges]
    gaps += [drawing.entry(entry) for entry in pose.mechanism.geometry]
    gaps += [drawing.guide(slider) for slider in pose.mechanism.each(Slider)]
    found = [gap for gap in gaps if gap is not None]
    size = max((math.hypot(*edge.vector) for edge in edges), default=0.0)
    worst = max(found, key=lambda gap: gap.size, default=None)
    return worst if worst is not None and worst.size > LOOP_GAP * size else None


def _links(pose: Pose, values: Mapping[str, float]) -> Iterator[KnownVector]:
    """Yield the links' vectors, without those whose made-up length no loop fixes."""
    open_lengths = [name for name, length in pose.placeholders.items() if length is None]
    doubled = {**values, **{name: 2 * values[name] for name in open_lengths}}
    for link in pose.mechanism.links:
        tail, *heads = link.points
        for head in heads:
            vector = pose.vector(link.name, tail, head)
            here = evaluate_vector(vector, values)
            if not open_lengths or here == evaluate_vector(vector, doubled):
                yield KnownVector(tail, head, Plane(*here))


def _vectors(pose: Pose, values: Mapping[str, float]) -> Iterator[KnownVector]:
    """Yield the vectors that the description itself gives in full."""
    for entry in pose.mechanism.geometry:
        match entry:
            case Offset(tail, head, x, y) if _known(values, x, y):
                yield KnownVector(tail, head, Plane(evaluate(x, values), evaluate(y, values)))
            case Arrow(tail, head, length, Absolute(angle)) if length is not None:
                if _known(values, length, angle):
                    along = direction(evaluate(angle, values))
                    yield KnownVector(tail, head, along.times(evaluate(length, values)))


def _known(values: Mapping[str, float], *formulas: Formula) -> bool:
    return all(symbols(formula) <= values.keys() for formula in formulas)


@frozen
class PlacedPoints:
    """Points in their places, and what can be measured between them."""

    places: PointPlaces
    values: Mapping[str, float]

    def loop(self, edge: KnownVector) -> Discrepancy | None:
        """Return the gap that opens at a vector when all others are in place."""
        found = between(self.places, edge.tail, edge.head)
        if found is None:
            return None
        gap = math.hypot(*found.minus(edge.vector))
        return Discrepancy(f"the loop through {edge.tail} and {edge.head}", gap)

    def entry(self, entry: Geometry) -> Discrepancy | None:
        """Return the gap of something given, None for what :meth:`loop` has measured."""
        match entry:
            case Offset():
                return None
            case Arrow(tail, head, length, line):
                found = between(self.places, tail, head)
                if found is None:
                    return None
                gap = max(self._length(found, length), self._line(found, line))
                return Discrepancy(f"the vector {tail}{head}", gap)
            case Turn():
                return self._turn(entry)
            case _:
                assert_never(entry)

    def guide(self, slider: Slider) -> Discrepancy | None:
        """Return how far a slider is from its guide's line, where that has a place."""
        found = between(self.places, slider.through, slider.point) if slider.through else None
        if found is None:
            return None
        return Discrepancy(f"the guide of {slider.point}", self._line(found, slider.along))

    def _length(self, found: Plane, length: Formula | None) -> float:
        if length is None or not _known(self.values, length):
            return 0.0
        return abs(math.hypot(*found) - abs(evaluate(length, self.values)))

    def _line(self, found: Plane, line: Direction | None) -> float:
        """Return the component of a vector across a line of this direction."""
        along = None if line is None else self._unit(line)
        return 0.0 if along is None else abs(along.turned().dot(found))

    def _unit(self, line: Direction) -> Plane | None:
        """Return the unit vector of a direction; None where it has no value."""
        match line:
            case Absolute(angle):
                known = _known(self.values, angle)
                return direction(evaluate(angle, self.values)) if known else None
            case AlongLine(tail, head, quarter):
                vector = between(self.places, tail, head)
                if vector is None:
                    return None
                return direction(math.atan2(vector.y, vector.x) + quarter * math.pi / 2)
            case _:
                assert_never(line)

    def _turn(self, turn: Turn) -> Discrepancy | None:
        first, second = (between(self.places, turn.vertex, p) for p in (turn.first, turn.second))
        if first is None or second is None or not _known(self.values, turn.angle):
            return None
        angle = math.atan2(first.y, first.x) + evaluate(turn.angle, self.values)
        gap = abs(direction(angle).turned().dot(second))
        return Discrepancy(f"the angle {turn.first}{turn.vertex}{turn.second}", gap)
