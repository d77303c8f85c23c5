"""From a figure to its kinematic scheme."""

import math
from collections.abc import Iterable, Iterator, Mapping

from ..figure.figure import Figure, Link, Pivot, Slide, Slider, Telescope
from ..formula.names import split_points
from ..pose.places import NOWHERE, Plane
from . import symbols
from .bodies import bars_at, link, slide, telescope
from .describe import describe
from .dimensions import draw_measures
from .drawing import Drawing, Polyline, Shape
from .joints import draw_slide_guides, joint, pins
from .labels import AroundPoint
from .lettering import name
from .loads import draw_forces, draw_pairs, meets
from .moving import NO_MARKS, Marks, draw_marks, say_marks
from .occupied import Occupied
from .paper import Paper, on_paper
from .pens import AXIS, COPY, SYMBOL
from .sheet import Layer, Sheet

MIRROR_LINE_BEYOND = 4.0
"""How far a mirror line goes beyond the mechanism, in millimetres."""


def scheme(figure: Figure, words: Mapping[str, str], marks: Marks = NO_MARKS) -> Drawing:
    """Return the kinematic scheme of a mechanism, with marks of how it moves if they are asked.

    ``words`` are those of a language.
    """
    paper = on_paper(figure)
    sheet, met = _drawn(paper, marks, Occupied())
    if met:  # an arrow may have another place
        other, still_met = _drawn(paper, marks, Occupied(met))
        sheet = other if len(still_met) < len(met) else sheet
    about = " ".join((describe(figure, words), *say_marks(paper, marks, words)))
    return sheet.finished(figure.title or figure.name, about)


def _drawn(paper: Paper, marks: Marks, avoided: Occupied) -> tuple[Sheet, list[Shape]]:
    """Return the sheet drawn, arrows off the lines to be avoided, and dimension lines they meet."""
    sheet = Sheet()
    sheet.draw(Layer.COPIES, _copies(paper))
    _draw_bodies(sheet, paper)
    draw_slide_guides(sheet, paper)
    draw_marks(sheet, paper, marks)
    arrows = draw_forces(sheet, paper, avoided)
    _draw_mirror(sheet, paper)
    measures = draw_measures(sheet, paper)
    _write_points(sheet, paper)
    return sheet, [m for m in measures if any(meets(arrow, Occupied((m,))) for arrow in arrows)]


def _draw_bodies(sheet: Sheet, paper: Paper) -> None:
    """Draw bodies and joints."""
    for part in paper.figure.parts:
        match part:
            case Link():
                _draw_body(sheet, link(paper, part))
            case Slide():
                _draw_body(sheet, slide(paper, part))
            case Telescope():
                _draw_body(sheet, telescope(paper, part))
            case _:
                for layer, shape in joint(paper, part):
                    sheet.draw(layer, [shape])
    draw_pairs(sheet, paper)
    sheet.draw(Layer.PINS, pins(paper))


def _draw_body(sheet: Sheet, shapes: Iterable[Shape]) -> None:
    """Draw a body; what is filled covers no rod that lies across it."""
    for shape in shapes:
        is_filled = isinstance(shape, Polyline) and shape.fill == "light"
        sheet.draw(Layer.PLATES if is_filled else Layer.BODIES, [shape])


def _copies(paper: Paper) -> Iterator[Shape]:
    """Yield the bars of the other copies, as they are seen from the side of the one described."""
    axis, number = paper.figure.axis, paper.figure.copies
    if axis is None:
        return
    at, across = paper.place(axis.at), axis.along.turned()
    widths = {round(math.cos(math.tau * i / number), 9) for i in range(1, number)} - {1.0}
    for width in sorted(widths):
        for tail, head in _bars(paper):
            start, end = (
                p.plus(across.times((width - 1) * across.dot(p.minus(at))))
                for p in (paper.at(tail), paper.at(head))
            )
            yield symbols.line(start, end, COPY)


def _bars(paper: Paper) -> Iterator[tuple[str, str]]:
    for part in paper.figure.parts:
        if isinstance(part, Link):
            yield from part.rods
        elif isinstance(part, Telescope):
            yield part.points


def _draw_mirror(sheet: Sheet, paper: Paper) -> None:
    """Draw the line between the halves all through the mechanism."""
    mirror = paper.figure.mirror
    if mirror is None:
        return
    at = paper.place(mirror.at)
    low, high = sheet.extent()
    corners = [Plane(x, y) for x in (low.x, high.x) for y in (low.y, high.y)]
    reach = [mirror.along.dot(corner.minus(at)) for corner in corners]
    start = symbols.off(at, mirror.along, min(reach) - MIRROR_LINE_BEYOND)
    end = symbols.off(at, mirror.along, max(reach) + MIRROR_LINE_BEYOND)
    sheet.draw(Layer.AXES, [symbols.line(start, end, AXIS)])


def _write_points(sheet: Sheet, paper: Paper) -> None:
    """Write the names of the points; one that only says where a guide lies has none."""
    pinned = {p.point for p in paper.figure.parts if isinstance(p, Pivot | Slider)}
    named = filter(split_points, paper.figure.points)
    for point in sorted(named, key=lambda point: point not in pinned):
        towards = _away(paper, point)
        at = paper.at(point)
        sheet.name(AroundPoint(at, name(point), SYMBOL, towards, symbols.PIN))


def _away(paper: Paper, point: str) -> float:
    """Return the direction from a point in which there are the fewest bars."""
    bars = [
        unit
        for part in paper.figure.parts
        if isinstance(part, Link)
        for unit in bars_at(paper, part, point)
    ]
    total = NOWHERE
    for unit in bars:
        total = total.plus(unit)
    if math.hypot(*total) > 0.3:
        return total.times(-1).angle
    left = bars[0].turned() if bars else Plane(0.6, 0.8)
    return left.angle if left.y >= 0 else left.times(-1).angle
