"""A drawing that is too high for a page, cut between its rows."""

from collections.abc import Iterator
from itertools import pairwise

from ..frozen import replace
from ..pose.places import Plane
from .drawing import Drawing, Label, Polyline, Shape

Span = tuple[float, float]
"""How low and how high something reaches."""


def parted(drawing: Drawing, height: float) -> tuple[Drawing, ...]:
    """Return the parts of a drawing, top first, none higher than this where rows are not.

    They are cut where nothing stands; one that is low enough comes whole.
    """
    if drawing.high.y - drawing.low.y <= height:
        return (drawing,)
    cuts = [drawing.high.y, *_cuts(drawing, height), drawing.low.y]
    return tuple(_between(drawing, low, high) for high, low in pairwise(cuts))


def _cuts(drawing: Drawing, height: float) -> Iterator[float]:
    """Yield where to cut, as far down as a part may reach."""
    top, last = drawing.high.y, drawing.high.y
    for gap in (*_gaps(drawing), drawing.low.y):
        if top - gap > height and last < top:
            yield last
            top = last
        last = gap


def _gaps(drawing: Drawing) -> Iterator[float]:
    """Yield the middle of each stretch without any shape or label, from the top down."""
    spans = sorted(
        (_span(each) for each in (*drawing.shapes, *drawing.labels)),
        reverse=True,
        key=lambda span: span[1],
    )
    lowest = spans[0][0]
    for low, high in spans:
        if high < lowest:
            yield (high + lowest) / 2
        lowest = min(lowest, low)


def _span(each: Shape | Label) -> Span:
    if isinstance(each, Label):
        return each.at.y - each.height / 2, each.at.y + each.height / 2
    if isinstance(each, Polyline):
        heights = [point.y for point in each.points]
        return min(heights), max(heights)
    return each.centre.y - each.radius, each.centre.y + each.radius


def _between(drawing: Drawing, low: float, high: float) -> Drawing:
    """Return the part of a drawing between two heights, as wide as the whole."""

    def is_inside(each: Shape | Label) -> bool:
        bottom, top = _span(each)
        return low <= (bottom + top) / 2 <= high

    return replace(
        drawing,
        shapes=tuple(filter(is_inside, drawing.shapes)),
        labels=tuple(filter(is_inside, drawing.labels)),
        low=Plane(drawing.low.x, low),
        high=Plane(drawing.high.x, high),
    )
