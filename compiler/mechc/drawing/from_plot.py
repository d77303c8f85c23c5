"""From a plot to its picture: panels above one another, legends to their right."""

import math
from collections.abc import Iterator
from itertools import takewhile

from ..frozen import replace
from ..plot.plot import Mark, Plot
from ..pose.places import Plane
from .arrange import below_each_other
from .axes import grid, heading, label, numbers_below, numbers_beside, outline, rectangle
from .describe_plot import describe
from .drawing import AXIS, Arc, Drawing, Fill, Label, Pen, Polyline, Run, Shape
from .labels import Around
from .lettering import SIZE, box
from .panels import Layout, common_entry, entry, laid_out, values_at, ways
from .sheet import Layer, Sheet

SAMPLE = 9.0
"""How long a line in the legend is."""

ROW = 5.6
"""How far rows of the legend are apart."""

NAMED = 6
"""How many marks of a panel have their values written beside them; more are only dots."""

DOT = 0.9
"""The radius of a mark."""


def picture(plot: Plot) -> Drawing:
    """Return the picture of a plot."""
    panels = [_drawn(laid_out(plot, panel)) for panel in plot.panels]
    left = min(panel.low.x for panel in panels)
    whole = below_each_other([replace(p, low=Plane(left, p.low.y)) for p in panels])
    return replace(whole, title=plot.title, description=describe(plot))


def _drawn(layout: Layout) -> Drawing:
    sheet, frame = Sheet(), layout.frame
    sheet.shade(Layer.COPIES, [*_shaded(layout), *grid(frame, layout.across, layout.up)])
    sheet.draw(Layer.AXES, _poles(layout))
    for curve, pen in layout.pens.items():
        places = (tuple(map(frame.at, way)) for way in ways(curve, layout))
        sheet.draw(Layer.BODIES, [Polyline(way, pen) for way in places])
    sheet.draw(Layer.JOINTS, [outline(frame)])
    _write_axes(sheet, layout)
    _draw_legend(sheet, layout)
    _draw_marks(sheet, layout)
    return sheet.finished("", "")


def _write_axes(sheet: Sheet, layout: Layout) -> None:
    frame = layout.frame
    numbers = numbers_below(frame, layout.across), numbers_beside(frame, layout.up)
    for written in (one for side in numbers for one in side):
        sheet.write(written)
    below = heading((layout.plot.x,), layout.across)
    width, _ = box(below, SIZE)
    middle = (frame.low.x + frame.high.x - width) / 2
    sheet.write(label(Plane(middle, frame.low.y - 9.4), below))
    beside = heading(layout.headed, layout.up)
    sheet.write(label(Plane(frame.low.x - 6.0, frame.high.y + 4.2), beside))


def _shaded(layout: Layout) -> Iterator[Shape]:
    """Yield the zone that is marked, or the range of the description."""
    frame = layout.frame
    for ends in layout.shaded:
        left, right = (frame.at(Plane(end, 0.0)).x for end in ends)
        yield rectangle(Plane(left, frame.low.y), Plane(right, frame.high.y), "light")


def _poles(layout: Layout) -> Iterator[Shape]:
    """Yield a broken line where a curve is infinite, from edge to edge."""
    frame = layout.frame
    for pole in sorted({pole for curve in layout.panel.curves for pole in curve.poles}):
        x = layout.at(Plane(pole, 0.0)).x
        if frame.low.x < x < frame.high.x:
            yield Polyline((Plane(x, frame.low.y), Plane(x, frame.high.y)), AXIS)


def _draw_marks(sheet: Sheet, layout: Layout) -> None:
    frame = layout.frame
    marks = [
        (mark, pen)
        for curve, pen in layout.pens.items()
        for mark in curve.marks
        if frame.least.y <= layout.value(mark.at).y <= frame.most.y
    ]
    sheet.draw(Layer.PINS, (_dot(mark, pen, layout) for mark, pen in marks))
    told = [(mark, pen) for mark, pen in marks if mark.kind != "default"]
    if len(told) <= NAMED or layout.plot.equal:
        for mark, pen in told:
            _write_values(sheet, mark, pen, layout)


def _dot(mark: Mark, pen: Pen, layout: Layout) -> Arc:
    fill: Fill = "solid" if mark.kind in ("default", "station") else "white"
    return Arc(layout.at(mark.at), DOT, pen._replace(width=0.35, dashes=()), fill=fill)


def _away(mark: Mark) -> float:
    """Return in which direction from a mark there is likely to be room."""
    return -math.pi / 2 if mark.kind == "minimum" else math.pi / 2


def _write_values(sheet: Sheet, mark: Mark, pen: Pen, layout: Layout) -> None:
    """Write the values at a mark inside the panel, over its grid, if there is room."""
    at, towards = layout.at(mark.at), _away(mark)
    for text in values_at(mark, layout):
        name = Around(at, (Run(text),), pen, towards, DOT)
        width, height = box(name.runs, SIZE)
        half = Plane(width / 2 + 0.5, height / 2 + 0.3)
        for place, _ in takewhile(lambda c: not c.far, name.candidates(width, height)):
            low, high = place.minus(half), place.plus(half)
            inside = layout.frame.holds(low) and layout.frame.holds(high)
            if inside and sheet.occupied.free(place, width, height):
                sheet.shade(Layer.GROUND, [rectangle(low, high, "white")])
                sheet.write(Label(place, name.runs, pen, SIZE, width, height))
                return


def _draw_legend(sheet: Sheet, layout: Layout) -> None:
    """Draw which line is which, and under them what they have in common."""
    corner = layout.frame.high
    at = Plane(corner.x + 4.0, corner.y - 3.0)
    for curve, pen in layout.pens.items() if layout.has_legend else ():
        end = Plane(at.x + SAMPLE, at.y)
        sheet.draw(Layer.BODIES, [Polyline((at, end), pen)])
        sheet.write(label(Plane(end.x + 1.5, at.y), entry(curve, layout)))
        at = Plane(at.x, at.y - ROW)
    if layout.common:
        sheet.write(label(at, common_entry(layout)))
