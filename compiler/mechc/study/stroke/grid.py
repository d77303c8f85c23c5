"""The values at which a stroke is looked at: closer together where results vary fastest.

Where a loop comes to its end, what it finds varies as the root of the distance from there. There
values are spaced evenly by that root. Where a loop that lies flat can go on, nothing does.
"""

from collections.abc import Iterator, Sequence

from ...formula.roots import spaced
from .stroke import StrokeInterval

SAMPLES = 720
"""Cells in which the stroke is looked at for singular poses and extrema."""

ENOUGH = 180
"""Values that are enough for a stretch."""

GRADED = 16
"""Cells that one next to the end of a loop is divided into."""


def looked_at(stretch: StrokeInterval, grid: Sequence[float]) -> list[float]:
    """Return values in a stretch, those that were looked at already where they are enough."""
    inner = [x for x in grid if stretch.low < x < stretch.high]
    if len(inner) < ENOUGH:
        inner = spaced(stretch.low, stretch.high, SAMPLES)[1:-1]
    first = graded(stretch.low, inner[0]) if stretch.before else ()
    last = graded(stretch.high, inner[-1]) if stretch.after else ()
    return sorted({stretch.low, *first, *inner, *last, stretch.high})


def graded(root: float, far: float) -> Iterator[float]:
    """Yield values between an end and another value, evenly by the root of the distance."""
    yield from (root + (far - root) * (i / GRADED) ** 2 for i in range(1, GRADED))
