"""Planar vectors in numbers, and points put in their places along them."""

import math
from collections.abc import Iterable, Mapping

from ..base.named import NamedTuple


class Plane(NamedTuple):
    """A planar vector in numbers: metres, newtons, or a unit direction."""

    x: float
    y: float

    def turned(self) -> "Plane":
        """Return the vector turned by +90°."""
        return Plane(-self.y, self.x)

    def times(self, factor: float) -> "Plane":
        """Return the vector times a number."""
        return Plane(self.x * factor, self.y * factor)

    def dot(self, other: "Plane") -> float:
        """Return the scalar product."""
        return self.x * other.x + self.y * other.y

    def plus(self, other: "Plane") -> "Plane":
        """Return the sum of both vectors."""
        return Plane(self.x + other.x, self.y + other.y)

    def minus(self, other: "Plane") -> "Plane":
        """Return the vector from the head of the other to the head of this one."""
        return Plane(self.x - other.x, self.y - other.y)

    def reflected(self, axis: "Plane") -> "Plane":
        """Return the vector's mirror image across a line of this unit direction.

        >>> Plane(3.0, 4.0).reflected(Plane(0.0, 1.0))
        Plane(x=-3.0, y=4.0)
        """
        normal = axis.turned()
        return axis.times(axis.dot(self)).minus(normal.times(normal.dot(self)))

    @property
    def angle(self) -> float:
        """Return the vector's direction in radians, counter-clockwise from +x."""
        return math.atan2(self.y, self.x)

    def unit(self) -> "Plane | None":
        """Return the unit vector of the same direction; None for a vector of no length."""
        size = math.hypot(*self)
        return self.times(1 / size) if size else None


NOWHERE = Plane(0.0, 0.0)


def direction(angle: float) -> Plane:
    """Return the unit vector at an angle in radians."""
    return Plane(math.cos(angle), math.sin(angle))


class KnownVector(NamedTuple):
    """A vector that is known in full."""

    tail: str
    head: str
    vector: Plane


class PlacedPoint(NamedTuple):
    """Where a point is, in the part of the drawing that hangs together with ``start``."""

    start: str
    at: Plane


PointPlaces = Mapping[str, PlacedPoint]


def placed(edges: Iterable[KnownVector]) -> dict[str, PlacedPoint]:
    """Put every point in its place, part by part, along the first way that leads there.

    >>> edges = [KnownVector("O", "A", Plane(1, 0)), KnownVector("B", "A", Plane(0, 2))]
    >>> placed(edges)["B"]
    PlacedPoint(start='O', at=Plane(x=1.0, y=-2.0))
    """
    ways: dict[str, list[tuple[str, Plane]]] = {}
    for tail, head, vector in edges:
        ways.setdefault(tail, []).append((head, vector))
        ways.setdefault(head, []).append((tail, vector.times(-1)))
    places: dict[str, PlacedPoint] = {}
    for start in ways:
        places.setdefault(start, PlacedPoint(start, NOWHERE))
        waiting = [start]
        while waiting:
            here = waiting.pop()
            root, at = places[here]
            for there, vector in ways[here]:
                if there not in places:
                    places[there] = PlacedPoint(root, at.plus(vector))
                    waiting.append(there)
    return places


def between(places: PointPlaces, tail: str, head: str) -> Plane | None:
    """Return the vector between two points, None where they are not connected."""
    a, b = places.get(tail), places.get(head)
    if a is None or b is None or a.start != b.start:
        return None
    return b.at.minus(a.at)
