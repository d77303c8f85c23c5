"""The figure on paper: its scale, and where its points are, in millimetres."""

import math
from collections.abc import Iterator

from ..base.frozen import frozen
from ..figure.figure import Belt, Figure, Gears, Link, Rack, Segment
from ..pose.places import Plane
from .tolerances import NO_BAR, NO_EXTENT

USUAL = 42.0
"""How long a vector of usual length is drawn."""

SHORTEST_BAR = 11.0
"""How long the shortest bar is drawn at least, if the picture does not become too large."""

NORMAL, LARGE = 120.0, 170.0
"""How wide or high the points of a picture are, at most; the larger one if bars are short."""


@frozen
class Paper:
    """A figure at a scale in millimetres to a metre."""

    figure: Figure
    scale: float

    def at(self, point: str) -> Plane:
        """Return where a point is."""
        return self.place(self.figure.points[point])

    def place(self, metres: Plane) -> Plane:
        """Return where a place in metres is."""
        return metres.times(self.scale)

    def ends(self, segment: Segment) -> tuple[Plane, Plane]:
        """Return the ends of a line."""
        return self.place(segment.start), self.place(segment.end)


LARGE_WHEEL = 1.5
"""How many usual lengths the radius of a wheel may have whose outside counts."""


def on_paper(figure: Figure) -> Paper:
    """Return the figure at the scale at which it is read best."""
    places = list(_extent(figure))
    sides = [max(c) - min(c) for c in zip(*places, strict=True)]
    extent = max(*sides, NO_EXTENT * figure.size)
    scale = min(USUAL / figure.size, NORMAL / extent)
    shortest = min(_bars(figure), default=figure.size)
    return Paper(figure, min(max(scale, SHORTEST_BAR / shortest), LARGE / extent))


def _extent(figure: Figure) -> Iterator[Plane]:
    """Yield the points, and those on the outside of wheels that are not too large."""
    yield from figure.points.values()
    for part in figure.parts:
        match part:
            case Gears() | Belt():
                wheels = [(part.first, part.first_radius), (part.second, part.second_radius)]
            case Rack():
                wheels = [(part.pivot, abs(part.radius))]
            case _:
                continue
        for point, radius in wheels:
            if radius < LARGE_WHEEL * figure.size:
                yield from _round(figure.points[point], radius)


def _round(centre: Plane, radius: float) -> Iterator[Plane]:
    for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        yield centre.plus(Plane(x * radius, y * radius))


def _bars(figure: Figure) -> Iterator[float]:
    """Yield the lengths of the bars of links."""
    for link in figure.parts:
        if isinstance(link, Link):
            lengths = (math.dist(figure.points[a], figure.points[b]) for a, b in link.rods)
            yield from (length for length in lengths if length > NO_BAR * figure.size)
