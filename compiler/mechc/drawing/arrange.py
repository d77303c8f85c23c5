"""Several drawings on one sheet, side by side in rows."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Literal, assert_never

from ..base.frozen import replace
from ..pose.places import Plane
from .drawing import Arc, Drawing, Label, Polyline, Shape, TextRun
from .lettering import SIZE, text_size
from .pens import SYMBOL

WIDE = 180.0
"""How wide a row may become, in millimetres."""


LabelLevel = Literal["middle", "top"]
"""What of drawings beside each other is at one height."""


def in_rows(drawings: Sequence[Drawing], level: LabelLevel = "middle") -> Drawing:
    """Return drawings beside each other, in rows that are not too wide; no title."""
    rows: list[list[Drawing]] = []
    for drawing in drawings:
        width = _width(drawing)
        if not rows or sum(map(_width, rows[-1])) + width > WIDE:
            rows.append([])
        rows[-1].append(drawing)
    return below_each_other([_beside(row, level) for row in rows])


def line_of_text(runs: tuple[TextRun, ...]) -> Drawing:
    """Return a line of text by itself."""
    width, height = text_size(runs, SIZE)
    label = Label(Plane(width / 2, 0.0), runs, SYMBOL, SIZE, width, height)
    return Drawing("", "", (), (label,), Plane(0.0, -height), Plane(width, height))


def below_each_other(drawings: Sequence[Drawing]) -> Drawing:
    """Return drawings one below the other, each of them a row or several; no title."""
    moved = list(_lowered(drawings))
    between = [height for drawing in moved for height in (*drawing.between, drawing.low.y)]
    return replace(_as_one(moved), between=tuple(between[:-1]))


def joined(drawings: Sequence[Drawing]) -> Drawing:
    """Return drawings one below the other as one row, but for rows within them; no title.

    A heading is joined to the first row of what it is of.
    """
    moved = list(_lowered(drawings))
    between = tuple(height for drawing in moved for height in drawing.between)
    return replace(_as_one(moved), between=between)


def _lowered(drawings: Iterable[Drawing]) -> Iterator[Drawing]:
    """Yield drawings that begin at one line, each where the one before it ends."""
    top = 0.0
    for drawing in drawings:
        moved = _moved(drawing, Plane(-drawing.low.x, top - drawing.high.y))
        top = moved.low.y
        yield moved


def _beside(drawings: Sequence[Drawing], level: LabelLevel) -> Drawing:
    right, moved = 0.0, list[Drawing]()
    for drawing in drawings:
        top = drawing.high.y
        height = top if level == "top" else (drawing.low.y + top) / 2
        moved.append(_moved(drawing, Plane(right - drawing.low.x, -height)))
        right = moved[-1].high.x
    return _as_one(moved)


def _width(drawing: Drawing) -> float:
    return drawing.high.x - drawing.low.x


def _as_one(drawings: Sequence[Drawing]) -> Drawing:
    """Return the drawing of all shapes and labels of several, without titles, as they lie."""
    shapes = tuple(shape for drawing in drawings for shape in drawing.shapes)
    labels = tuple(label for drawing in drawings for label in drawing.labels)
    low = Plane(min(d.low.x for d in drawings), min(d.low.y for d in drawings))
    high = Plane(max(d.high.x for d in drawings), max(d.high.y for d in drawings))
    return Drawing("", "", shapes, labels, low, high)


def _moved(drawing: Drawing, by: Plane) -> Drawing:
    """Return a drawing shifted on the paper with all that it has."""
    return replace(
        drawing,
        shapes=tuple(_moved_shape(shape, by) for shape in drawing.shapes),
        labels=tuple(_moved_labels(drawing.labels, by)),
        low=drawing.low.plus(by),
        high=drawing.high.plus(by),
        between=tuple(height + by.y for height in drawing.between),
    )


def _moved_shape(shape: Shape, by: Plane) -> Shape:
    match shape:
        case Polyline():
            return shape._replace(points=tuple(point.plus(by) for point in shape.points))
        case Arc():
            return shape._replace(centre=shape.centre.plus(by))
        case _:
            assert_never(shape)


def _moved_labels(labels: Iterable[Label], by: Plane) -> Iterable[Label]:
    return (label._replace(at=label.at.plus(by)) for label in labels)


# -------------------------------------------------------------------------------------- taken apart


def parted(drawing: Drawing, height: float) -> tuple[Drawing, ...]:
    """Return the parts of a drawing, top first, none higher than this where rows are not.

    They are cut where rows meet, into parts as high as each other as far as rows allow it; one that
    is low enough comes whole.
    """
    down = [drawing.high.y, *_cuts(drawing, height), drawing.low.y]
    even = _even_cuts(drawing, len(down) - 1)
    cuts = even if _highest(even) <= _highest(down) else down
    return tuple(_between(drawing, low, high) for high, low in pairwise(cuts))


def _highest(cuts: Sequence[float]) -> float:
    return max(high - low for high, low in pairwise(cuts))


def _even_cuts(drawing: Drawing, parts: int) -> list[float]:
    """Return where so many parts begin and end that are as high as each other, as rows allow it."""
    whole, places = drawing.high.y - drawing.low.y, {*drawing.between}
    cuts = [drawing.high.y]
    for part in range(1, parts):
        wanted = drawing.high.y - whole * part / parts
        below = [place for place in places if place < cuts[-1]]
        cuts += [min(below, key=lambda place: abs(place - wanted))] if below else []
    return [*cuts, drawing.low.y]


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
