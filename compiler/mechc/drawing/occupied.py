"""What is drawn already: which boxes are free, how many lines a line would cross."""

import itertools
import math
from collections.abc import Iterable, Iterator

from ..pose.places import Plane
from .drawing import Arc, Shape
from .pens import AXIS, COPY, HATCH, Pen
from .tolerances import ALONG_AXIS

CELL = 5.0
"""The side of a square of the grid in which lines are looked up, in millimetres."""

CLEAR = 0.35
"""How far a label keeps off lines and other labels, in millimetres."""

TOUCH = 0.2
"""Lines that are nearer to each other than this, in millimetres, meet."""

FAINT = (AXIS, COPY, HATCH)
"""Lines that others may cross."""

LineSegment = tuple[Plane, Plane]
Square = tuple[int, int]


class Rectangle:
    """A rectangle with upright sides, around its middle."""

    def __init__(self, at: Plane, width: float, height: float) -> None:
        self.low = Plane(at.x - width / 2, at.y - height / 2)
        self.high = Plane(at.x + width / 2, at.y + height / 2)

    def overlaps(self, other: "Rectangle") -> bool:
        """Return whether two boxes have a point in common."""
        return (
            self.low.x < other.high.x
            and other.low.x < self.high.x
            and self.low.y < other.high.y
            and other.low.y < self.high.y
        )

    def cut_by(self, line: LineSegment) -> bool:
        """Return whether a straight line passes through the box."""
        start, end = line
        step = end.minus(start)
        enter, leave = 0.0, 1.0
        for here, move, low, high in zip(start, step, self.low, self.high, strict=True):
            if abs(move) < ALONG_AXIS:
                if not low <= here <= high:
                    return False
                continue
            near, far = sorted(((low - here) / move, (high - here) / move))
            enter, leave = max(enter, near), min(leave, far)
        return enter <= leave


def stretches(shape: Shape) -> Iterator[LineSegment]:
    """Yield the straight lines of a shape; those of an arc are chords."""
    if isinstance(shape, Arc):
        points = shape.way()
    else:
        points = (*shape.points, shape.points[0]) if shape.closed else shape.points
    yield from itertools.pairwise(points)


class Occupied:
    """The lines and labels of a drawing that is being made."""

    def __init__(self, shapes: Iterable[Shape] = ()) -> None:
        self._lines: list[LineSegment] = []
        self._pens: list[Pen] = []
        self._squares: dict[Square, list[int]] = {}
        self._boxes: list[Rectangle] = []
        self.add(*shapes)

    def add(self, *shapes: Shape) -> None:
        """Take in what has been drawn."""
        for shape in shapes:
            for line in stretches(shape):
                for square in _squares(*line):
                    self._squares.setdefault(square, []).append(len(self._lines))
                self._lines.append(line)
                self._pens.append(shape.pen)

    def write(self, box: Rectangle) -> None:
        """Take in the box of a label."""
        self._boxes.append(box)

    def free(self, at: Plane, width: float, height: float) -> bool:
        """Return whether a box has neither lines nor labels in it, nor next to it."""
        box = Rectangle(at, width + 2 * CLEAR, height + 2 * CLEAR)
        if any(box.overlaps(other) for other in self._boxes):
            return False
        return not any(box.cut_by(self._lines[i]) for i in self._near(box.low, box.high))

    def written_on(self, start: Plane, end: Plane) -> bool:
        """Return whether a straight line meets a label."""
        return any(box.cut_by((start, end)) for box in self._boxes)

    def crossings(self, start: Plane, end: Plane) -> int:
        """Return how many lines, faint ones apart, a straight line meets."""
        near = self._in(_squares(start, end))
        return sum(self._pens[i] not in FAINT and _meet((start, end), self._lines[i]) for i in near)

    def crossed(self, shapes: Iterable[Shape]) -> int:
        """Return how many lines shapes would meet."""
        return sum(self.crossings(*line) for shape in shapes for line in stretches(shape))

    def lies_on(self, line: LineSegment, pen: Pen) -> bool:
        """Return whether a straight line and one drawn with that pen lie on each other."""
        near = self._in(_squares(*line))
        return any(self._pens[i] == pen and _lie_on_each_other(line, self._lines[i]) for i in near)

    def _near(self, low: Plane, high: Plane) -> set[int]:
        """Return the lines in the squares that a rectangle touches."""
        columns = range(_cell(low.x), _cell(high.x) + 1)
        rows = range(_cell(low.y), _cell(high.y) + 1)
        return self._in((x, y) for x in columns for y in rows)

    def _in(self, squares: Iterable[Square]) -> set[int]:
        return {i for square in squares for i in self._squares.get(square, ())}


def _cell(place: float) -> int:
    return math.floor(place / CELL)


def _squares(start: Plane, end: Plane) -> set[Square]:
    """Return the squares that a line passes through: those of points close to one another."""
    steps = 1 + math.ceil(math.dist(start, end) / (CELL / 4))
    points = (start.plus(end.minus(start).times(i / steps)) for i in range(steps + 1))
    return {(_cell(p.x + dx), _cell(p.y + dy)) for p in points for dx in (-1, 1) for dy in (-1, 1)}


def _meet(one: LineSegment, other: LineSegment) -> bool:
    """Return whether two straight lines cross, or lie on each other."""
    return _boxes_touch(one, other) and _reaches(one, other) and _reaches(other, one)


def _lie_on_each_other(one: LineSegment, other: LineSegment) -> bool:
    """Return whether two straight lines are one line, and have more than an end of it in common."""
    start, end = one
    along = end.minus(start).unit()
    if along is None:
        return False
    ways = [place.minus(start) for place in other]
    if any(abs(along.turned().dot(way)) > TOUCH for way in ways):
        return False
    low, high = sorted(along.dot(way) for way in ways)
    return low < math.dist(start, end) - TOUCH and high > TOUCH


def _boxes_touch(one: LineSegment, other: LineSegment) -> bool:
    """Return whether the upright rectangles around two straight lines touch."""
    ((ax, ay), (bx, by)), ((cx, cy), (dx, dy)) = one, other
    return (
        min(ax, bx) <= max(cx, dx) + TOUCH
        and min(cx, dx) <= max(ax, bx) + TOUCH
        and min(ay, by) <= max(cy, dy) + TOUCH
        and min(cy, dy) <= max(ay, by) + TOUCH
    )


def _reaches(line: LineSegment, other: LineSegment) -> bool:
    """Return whether the other's ends are not both clearly on one side of a line."""
    ((ax, ay), (bx, by)), ((cx, cy), (dx, dy)) = line, other
    length = math.hypot(bx - ax, by - ay)
    first = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    second = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
    near = TOUCH * length
    return length > 0 and min(first, second) <= near and max(first, second) >= -near
