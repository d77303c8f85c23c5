"""At which places of a range friction is looked at: evenly, and closely at dead centres.

Beside a dead centre k is small or large against friction, so that something is stuck
there, on however short a stretch.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from .ranges import last, spaced
from .states import Moving

PLACES = 36
"""Places between which dead centres are looked for."""

SELDOM = 3
"""Only one in so many is looked at where friction is found by iteration, which takes long."""

HALVINGS = 8
"""Further places beside a dead centre, each half as far from it as the one before."""

NEAREST = 2.0**-20
"""How near the last place is: as near as friction is sure to be larger than k, or k than it."""

NEAR = 1e-9
"""What is nearer to 0, against the distance of places, is 0."""


def looked_at(moving: Moving, low: float, high: float, also: Sequence[float] = ()) -> list[float]:
    """Return places from one end to the other, ``also`` among them if they lie between."""
    even = spaced((low, high), PLACES)
    still = [z for a, b in pairwise(even) for z in _still(moving, a, b)]
    beside = [c + away for c in (low, high, *still) for away in _near(moving, even[1] - low)]
    chosen = even[::SELDOM] if moving.is_iterated else even
    return sorted({x for x in (*chosen, *beside, *also) if low <= x <= high})


def _near(moving: Moving, step: float) -> Iterator[float]:
    """Yield how far from a dead centre to look, on both sides."""
    halvings = 1 if moving.is_iterated else HALVINGS
    for part in (*(0.5**i for i in range(1, halvings + 1)), NEAREST):
        yield from (-step * part, step * part)


def _still(moving: Moving, a: float, b: float) -> Iterator[float]:
    """Yield the dead centre between two places."""
    if moving.driven(b) != moving.driven(a):
        yield dead_centre(moving, a, b)


def dead_centre(moving: Moving, a: float, b: float) -> float:
    """Return the dead centre between two places, 0 where it is nearly that."""
    place = before_dead_centre(moving, a, b)
    return 0.0 if abs(place) < NEAR * abs(b - a) else place


def before_dead_centre(moving: Moving, a: float, b: float) -> float:
    """Return the last place, from the first of two on, that is still before the dead centre."""
    driven = moving.driven(a)
    return last(lambda x: driven is not None and moving.driven(x) == driven, a, b)
