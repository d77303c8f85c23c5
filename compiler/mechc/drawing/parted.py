"""A drawing that is too high for a page, cut between its rows."""

from collections.abc import Iterator
from itertools import pairwise

from ..frozen import replace
from ..named import NamedTuple
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


ROWS = 3.0
"""How far rows are apart at least; less may be between an arrow and its name."""


class Gap(NamedTuple):
    """A stretch in which nothing stands: its middle, and whether rows are apart there.

    Below what are only labels, a heading or the name of a point, stands what they are of.
    """

    at: float
    between_rows: bool


def _cuts(drawing: Drawing, height: float) -> Iterator[float]:
    """Yield where to cut, as far down as a part may reach; between rows, if there are some."""
    gaps, top = list(_gaps(drawing)), drawing.high.y
    while top - drawing.low.y > height:
        below = [gap for gap in gaps if gap.at < top]
        reached = [gap for gap in below if top - gap.at <= height] or below[:1]
        rows = [gap for gap in reached if gap.between_rows]
        if not reached:
            return
        top = (rows or reached)[-1].at
        yield top


def _gaps(drawing: Drawing) -> Iterator[Gap]:
    """Yield the stretches without any shape or label, from the top down."""
    pieces = sorted(
        ((*_span(each), isinstance(each, Label)) for each in (*drawing.shapes, *drawing.labels)),
        reverse=True,
        key=lambda piece: piece[1],
    )
    lowest, only_labels = pieces[0][0], True
    for low, high, is_label in pieces:
        if high < lowest:
            yield Gap((high + lowest) / 2, lowest - high > ROWS and not only_labels)
            only_labels = True
        only_labels = only_labels and is_label
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
