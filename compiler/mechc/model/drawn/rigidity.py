"""Which lengths and directions are independent of one another, at the drawn places.

Each is a row of partial derivatives by the coordinates of the points: of a distance, of a
direction. What follows from the rows before it is given already.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import assert_never

from ..mechanism import Absolute, AlongLine, Arrow, Geometry, Offset, Turn
from ..tolerances import DEPENDENT
from .sketch import Sketch

RigidityRow = Mapping[tuple[str, int], float]
"""Derivatives by the coordinates: of a point, 0 for x or 1 for y."""


class Independent:
    """Rows so far, as orthogonal rows of length one."""

    def __init__(self, rows: Iterable[RigidityRow]) -> None:
        self._basis: list[RigidityRow] = []
        for row in rows:
            self.takes(row)

    def takes(self, row: RigidityRow) -> bool:
        """Take a row in; False where it follows from those before it."""
        rest = self._left(row)
        if rest:
            self._basis.append(combined({}, rest, 1 / _size(rest)))
        return rest is not None

    def lacks(self, row: RigidityRow) -> bool:
        """Return whether a row does not follow from those so far."""
        return self._left(row) is not None

    def _left(self, row: RigidityRow) -> RigidityRow | None:
        """Return the component of a row orthogonal to those so far, None where that vanishes."""
        rest = row
        for _ in range(2):  # the second time takes away what rounding left
            for known in self._basis:
                rest = combined(rest, known, -_product(rest, known))
        return rest if _size(rest) > DEPENDENT * _size(row) else None


def combined(row: RigidityRow, other: RigidityRow, factor: float) -> RigidityRow:
    """Return a row with a multiple of another one added.

    >>> combined({("A", 0): 1.0}, {("A", 0): 2.0, ("B", 1): 1.0}, -1)
    {('A', 0): -1.0, ('B', 1): -1.0}
    """
    return {
        key: row.get(key, 0.0) + factor * other.get(key, 0.0)
        for key in dict.fromkeys([*row, *other])
    }


def distance(tail: str, head: str, sketch: Sketch) -> RigidityRow:
    """Return the row of the distance of two points."""
    x, y = _unit(tail, head, sketch)
    return {(tail, 0): -x, (tail, 1): -y, (head, 0): x, (head, 1): y}


def direction(tail: str, head: str, sketch: Sketch) -> RigidityRow:
    """Return the row of the direction from one point to another."""
    x, y = _unit(tail, head, sketch)
    far = math.dist(sketch.places[tail].at, sketch.places[head].at)
    return {(tail, 0): y / far, (tail, 1): -x / far, (head, 0): -y / far, (head, 1): x / far}


def turn(first: str, vertex: str, second: str, sketch: Sketch) -> RigidityRow:
    """Return the row of the angle at a point between two others."""
    return combined(direction(vertex, second, sketch), direction(vertex, first, sketch), -1)


def fixed(point: str, turned: float) -> RigidityRow:
    """Return the row of a point's place across a direction, in radians."""
    return {(point, 0): -math.sin(turned), (point, 1): math.cos(turned)}


def rows_of(entry: Geometry, sketch: Sketch) -> Iterator[RigidityRow]:
    """Yield the rows of what an entry gives, none where a point of it is not drawn."""
    if not sketch.has(entry):
        return
    match entry:
        case Arrow(tail, head, length, towards):
            if length is not None:
                yield distance(tail, head, sketch)
            if isinstance(towards, Absolute):
                yield direction(tail, head, sketch)
            elif isinstance(towards, AlongLine) and sketch.has_all((towards.tail, towards.head)):
                other = direction(towards.tail, towards.head, sketch)
                yield combined(direction(tail, head, sketch), other, -1)
        case Offset(tail, head):
            ends = {tail: -1.0, head: 1.0}
            yield from ({(p, i): sign for p, sign in ends.items() if p} for i in (0, 1))
        case Turn(first, vertex, second):
            yield turn(first, vertex, second, sketch)
        case _:
            assert_never(entry)


def _unit(tail: str, head: str, sketch: Sketch) -> tuple[float, float]:
    (ax, ay), (bx, by) = sketch.places[tail].at, sketch.places[head].at
    far = math.hypot(bx - ax, by - ay)
    return (bx - ax) / far, (by - ay) / far


def _product(row: RigidityRow, other: RigidityRow) -> float:
    return math.fsum(value * other.get(key, 0.0) for key, value in row.items())


def _size(row: RigidityRow) -> float:
    return math.sqrt(_product(row, row))
