"""From a plot to its picture: panels above one another, legends to their right."""

from collections.abc import Iterator, Mapping
from itertools import chain

from ...base.frozen import replace
from ...plot.plot import Plot
from ...pose.places import Plane
from ..arrange import below_each_other
from ..drawing import Drawing, Polyline, Shape
from ..lettering import SIZE, text_size
from ..sheet import Layer, Sheet
from .axes import grid, heading, label, numbers_below, numbers_beside, outline, rectangle
from .describe_plot import describe
from .marks import curves, dots, poles, values_beside
from .panels import PanelLayout, common_entry, entry, laid_out

SAMPLE = 9.0
"""How long a line in the legend is."""

LEGEND_ROW = 5.6
"""How far rows of the legend are apart."""

BELOW, LEFT, ABOVE = 9.4, 6.0, 4.2
"""How far the headings of the axes are from the frame: one below it, one up its left side."""


def picture(plot: Plot, words: Mapping[str, str]) -> Drawing:
    """Return the picture of a plot, in the words of a language."""
    panels = [_drawn(laid_out(plot, panel, words)) for panel in plot.panels]
    left = min(panel.low.x for panel in panels)
    whole = below_each_other([replace(p, low=Plane(left, p.low.y)) for p in panels])
    return replace(whole, title=plot.title, description=describe(plot, words))


def _drawn(layout: PanelLayout) -> Drawing:
    sheet, frame = Sheet(), layout.frame
    sheet.shade(Layer.COPIES, [*_shaded(layout), *grid(frame, layout.across, layout.up)])
    sheet.draw(Layer.AXES, poles(layout))
    sheet.draw(Layer.BODIES, curves(layout))
    sheet.draw(Layer.JOINTS, [outline(frame)])
    _write_axes(sheet, layout)
    _draw_legend(sheet, layout)
    _draw_marks(sheet, layout)
    return sheet.finished("", "")


def _write_axes(sheet: Sheet, layout: PanelLayout) -> None:
    """Write the numbers of both axes and their headings."""
    frame = layout.frame
    numbers = numbers_below(frame, layout.across), numbers_beside(frame, layout.up)
    for number in chain(*numbers):
        sheet.write(number)
    below = heading((layout.plot.x,), layout.across)
    width, _ = text_size(below, SIZE)
    middle = (frame.low.x + frame.high.x - width) / 2
    sheet.write(label(Plane(middle, frame.low.y - BELOW), below))
    beside = heading(layout.headed, layout.up)
    sheet.write(label(Plane(frame.low.x - LEFT, frame.high.y + ABOVE), beside))


def _shaded(layout: PanelLayout) -> Iterator[Shape]:
    """Yield the zone that is marked, or the range of the description."""
    frame = layout.frame
    for ends in layout.shaded:
        left, right = (frame.at(Plane(end, 0.0)).x for end in ends)
        yield rectangle(Plane(left, frame.low.y), Plane(right, frame.high.y), "light")


def _draw_marks(sheet: Sheet, layout: PanelLayout) -> None:
    sheet.draw(Layer.PINS, (dot for dot, *_ in dots(layout)))
    for written in values_beside(layout):
        half = Plane(written.width / 2 + 0.5, written.height / 2 + 0.3)
        paper = rectangle(written.at.minus(half), written.at.plus(half), "white")
        sheet.shade(Layer.GROUND, [paper])
        sheet.write(written)


def _draw_legend(sheet: Sheet, layout: PanelLayout) -> None:
    """Draw which line is which, and under them what they have in common."""
    corner = layout.frame.high
    at = Plane(corner.x + 4.0, corner.y - 3.0)
    for curve, pen in layout.pens.items() if layout.has_legend else ():
        end = Plane(at.x + SAMPLE, at.y)
        sheet.draw(Layer.BODIES, [Polyline((at, end), pen)])
        sheet.write(label(Plane(end.x + 1.5, at.y), entry(curve, layout)))
        at = Plane(at.x, at.y - LEGEND_ROW)
    if layout.common:
        sheet.write(label(at, common_entry(layout)))
