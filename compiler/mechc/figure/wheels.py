"""Where wheels touch each other, and how a belt runs about them."""

import math

from ..named import NamedTuple
from ..pose.places import Plane
from .figure import Segment


class Circle(NamedTuple):
    """A pitch circle."""

    centre: Plane
    radius: float


def pitch_point(first: Circle, second: Circle, *, inner: bool) -> Plane:
    """Return where the pitch circles of two gears touch.

    >>> small, large = Circle(Plane(0.0, 0.0), 1.0), Circle(Plane(3.0, 0.0), 2.0)
    >>> pitch_point(small, large, inner=False)
    Plane(x=1.0, y=0.0)
    >>> pitch_point(small, Circle(Plane(3.0, 0.0), 4.0), inner=True)
    Plane(x=-1.0, y=0.0)
    """
    towards = second.centre.minus(first.centre).unit() or Plane(1.0, 0.0)
    outside = -1 if inner and second.radius > first.radius else 1
    return first.centre.plus(towards.times(outside * first.radius))


def runs(first: Circle, second: Circle, *, crossed: bool) -> tuple[Segment, ...]:
    """Return the straight stretches of a belt: the common tangents that it lies on.

    >>> wheels = Circle(Plane(0.0, 0.0), 1.0), Circle(Plane(4.0, 0.0), 1.0)
    >>> runs(*wheels, crossed=False)[0]
    Segment(start=Plane(x=0.0, y=1.0), end=Plane(x=4.0, y=1.0))
    """
    apart = second.centre.minus(first.centre)
    distance = math.hypot(*apart)
    other = -second.radius if crossed else second.radius
    if distance <= abs(first.radius - other):
        return ()
    along = apart.times(1 / distance)
    cosine = (first.radius - other) / distance
    across = along.turned().times(math.sqrt(1 - cosine**2))
    normals = (along.times(cosine).plus(across.times(side)) for side in (1, -1))
    return tuple(
        Segment(
            first.centre.plus(normal.times(first.radius)), second.centre.plus(normal.times(other))
        )
        for normal in normals
    )
