"""How a rope runs over its pulleys."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from ..pose.places import NOWHERE, Plane
from .figure import Segment

STRAIGHT = 1e-6
"""The sine of an angle between falls that are parallel."""


def rope_runs(places: Sequence[Plane], radius: float) -> Iterator[Segment]:
    """Yield the straight stretches of a rope: tangents of the pulleys on its way.

    It runs round the pulleys on alternate sides where its falls are parallel, as a tackle is
    drawn, else on the outside of each bend.
    """
    sides = [0.0, *_sides(places), 0.0]
    for i, (tail, head) in enumerate(pairwise(places)):
        unit = head.minus(tail).unit() or NOWHERE
        across = unit.turned().times(radius)
        start, end = tail.plus(across.times(sides[i])), head.plus(across.times(sides[i + 1]))
        yield Segment(start, end)


def _sides(places: Sequence[Plane]) -> Iterator[float]:
    """Yield on which side of its way a rope passes each axle between its ends: 1 is the left."""
    side = 1.0
    for before, at, after in zip(places, places[1:], places[2:], strict=False):
        way, onward = (leg.unit() or NOWHERE for leg in (at.minus(before), after.minus(at)))
        bend = way.turned().dot(onward)
        if abs(bend) > STRAIGHT:
            side = -1.0 if bend > 0 else 1.0
        yield side
