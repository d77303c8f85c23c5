"""A drawing that is too high for a page, cut between its rows."""

from collections.abc import Iterator
from itertools import pairwise

from ..frozen import replace
from ..pose.places import Plane
from .drawing import Drawing, Label, Polyline, Shape


def parted(drawing: Drawing, height: float) -> tuple[Drawing, ...]:
    """Return the parts of a drawing, top first, none higher than this where rows are not.

    They are cut where rows meet; one that is low enough comes whole.
    """
    cuts = [drawing.high.y, *_cuts(drawing, height), drawing.low.y]
    return tuple(_between(drawing, low, high) for high, low in pairwise(cuts))


def _cuts(drawing: Drawing, height: float) -> Iterator[float]:
    """Yield where to cut, each time as far down as a part may reach."""
    top = drawing.high.y
    for here, following in pairwise((*drawing.between, drawing.low.y)):
        if top - following > height:
            top = here
            yield top


def _between(drawing: Drawing, low: float, high: float) -> Drawing:
    """Return the rows of a drawing between two heights, as wide as the whole."""

    def is_inside(each: Shape | Label) -> bool:
        return low < _middle(each) < high

    return replace(
        drawing,
        shapes=tuple(filter(is_inside, drawing.shapes)),
        labels=tuple(filter(is_inside, drawing.labels)),
        low=Plane(drawing.low.x, low),
        high=Plane(drawing.high.x, high),
        between=tuple(height for height in drawing.between if low < height < high),
    )


def _middle(each: Shape | Label) -> float:
    if isinstance(each, Label):
        return each.at.y
    if isinstance(each, Polyline):
        heights = [point.y for point in each.points]
        return (min(heights) + max(heights)) / 2
    return each.centre.y
