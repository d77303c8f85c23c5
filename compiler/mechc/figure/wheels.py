"""How wheels touch, how a belt runs about them, and a rope over its pulleys."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from ..base.named import NamedTuple
from ..pose.places import NOWHERE, Plane
from .figure import Segment
from .tolerances import PARALLEL


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


def rope_runs(
    places: Sequence[Plane], radii: Sequence[float | None], pulley: float
) -> Iterator[Segment]:
    """Yield the straight stretches of a rope: tangents of the pulleys on its way.

    It runs round the pulleys on alternate sides where its falls are parallel, as a tackle is
    drawn, else on the outside of each bend. A drum has a radius of its own, negative where the
    rope goes clockwise around it.
    """
    offsets = [
        pulley * side if radius is None else -radius
        for side, radius in zip((0.0, *_sides(places), 0.0), radii, strict=True)
    ]
    for (tail, head), (left, right) in zip(pairwise(places), pairwise(offsets), strict=True):
        normal = _normal(head.minus(tail), left - right)
        yield Segment(tail.plus(normal.times(left)), head.plus(normal.times(right)))


def _normal(way: Plane, less: float) -> Plane:
    """Return the normal to the left of a line whose ends are to the left by so much less."""
    unit, length = way.unit() or NOWHERE, math.hypot(*way)
    sine = less / length if abs(less) < length else 0.0
    return unit.turned().times(math.sqrt(1 - sine * sine)).plus(unit.times(sine))


def _sides(places: Sequence[Plane]) -> Iterator[float]:
    """Yield on which side of its way a rope passes each axle between its ends: 1 is the left."""
    side = 1.0
    for before, at, after in zip(places, places[1:], places[2:], strict=False):
        way, onward = (leg.unit() or NOWHERE for leg in (at.minus(before), after.minus(at)))
        bend = way.turned().dot(onward)
        if abs(bend) > PARALLEL:
            side = -1.0 if bend > 0 else 1.0
        yield side
