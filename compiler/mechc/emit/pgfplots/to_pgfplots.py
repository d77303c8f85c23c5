"""A plot for LaTeX: axes of pgfplots, with the values of the curves in the text."""

from collections.abc import Iterator

from ...drawing.axes import heading
from ...drawing.describe_plot import describe
from ...drawing.drawing import Pen, Run
from ...drawing.panels import Layout, common_entry, entry, laid_out, values_at, ways
from ...drawing.ticks import Scale
from ...plot.plot import Curve, Mark, Plot
from ...pose.places import Plane
from ..tikz.picture import comment, mathematics

APART = 26.0
"""How far panels are below each other, in millimetres."""

NAMED = 6
"""How many marks of a panel have their values written beside them."""


def to_pgfplots(plot: Plot) -> str:
    """Return a plot as a document for every TeX engine."""
    lines = (
        f"% {comment(plot.title)}",
        f"% {comment(describe(plot))}",
        r"\documentclass[tikz]{standalone}",
        r"\usepackage{pgfplots}",
        r"\pgfplotsset{compat=1.15}",
        r"\begin{document}",
        *_tikzpicture(plot),
        r"\end{document}",
    )
    return "\n".join(lines) + "\n"


def fragment(plot: Plot) -> str:
    r"""Return a plot to be put into a document that has pgfplots in its preamble."""
    return "\n".join(_tikzpicture(plot)) + "\n"


def _tikzpicture(plot: Plot) -> Iterator[str]:
    layouts = [laid_out(plot, panel) for panel in plot.panels]
    yield r"\begin{tikzpicture}"
    for pen in dict.fromkeys(pen for layout in layouts for pen in layout.pens.values()):
        yield rf"\definecolor{{mechc{pen.name}}}{{HTML}}{{{pen.colour[1:].upper()}}}"
    top = 0.0
    for layout in layouts:
        top -= layout.frame.high.y
        yield from _axis(layout, top)
        top -= APART
    yield r"\end{tikzpicture}"


def _axis(layout: Layout, bottom: float) -> Iterator[str]:
    frame = layout.frame
    yield r"\begin{axis}["
    yield f"  at={{(0mm,{bottom:g}mm)}}, anchor=south west, scale only axis,"
    yield f"  width={frame.high.x:g}mm, height={frame.high.y:g}mm,"
    yield f"  xmin={frame.least.x!r}, xmax={frame.most.x!r},"
    yield f"  ymin={frame.least.y!r}, ymax={frame.most.y!r},"
    yield f"  {_ticks('x', layout.across)},"
    yield f"  {_ticks('y', layout.up)},"
    yield f"  xlabel={{${mathematics(heading((layout.plot.x,), layout.across))}$}},"
    yield f"  ylabel={{${mathematics(heading(layout.headed, layout.up))}$}},"
    yield "  grid=major, grid style={gray!40, very thin}, legend pos=outer north east,"
    yield "  legend cell align=left, clip mode=individual]"
    yield from _shaded(layout)
    yield from _poles(layout)
    for curve, pen in layout.pens.items():
        yield from _curve(curve, pen, layout)
    if layout.common:
        yield r"\addlegendimage{empty legend}"
        yield rf"\addlegendentry{{${mathematics(common_entry(layout))}$}}"
    yield from _marks(layout)
    yield r"\end{axis}"


def _ticks(axis: str, scale: Scale) -> str:
    """Return the ticks and what is written at them."""
    places = ",".join(f"{tick:.12g}" for tick in scale.ticks)
    texts = ",".join(f"${mathematics((Run(scale.text(t)),))}$" for t in scale.ticks)
    return f"{axis}tick={{{places}}}, {axis}ticklabels={{{texts}}}, scaled {axis} ticks=false"


def _shaded(layout: Layout) -> Iterator[str]:
    """Yield the zone that is marked, or the range of the description."""
    frame = layout.frame
    for left, right in layout.shaded:
        corners = f"{left!r},{frame.least.y!r}) rectangle (axis cs:{right!r},{frame.most.y!r}"
        yield rf"\fill[black!8] (axis cs:{corners});"


def _poles(layout: Layout) -> Iterator[str]:
    frame = layout.frame
    for pole in sorted({pole for curve in layout.panel.curves for pole in curve.poles}):
        x = layout.value(Plane(pole, 0.0)).x
        ends = f"(axis cs:{x!r},{frame.least.y!r}) -- (axis cs:{x!r},{frame.most.y!r})"
        yield rf"\draw[dash dot, gray] {ends};"


def _curve(curve: Curve, pen: Pen, layout: Layout) -> Iterator[str]:
    look = f"mechc{pen.name}, line width={pen.width:g}mm" + (", dashed" if pen.dashes else "")
    for i, way in enumerate(ways(curve, layout)):
        told = "" if layout.has_legend and not i else ", forget plot"
        places = " ".join(f"({p.x:.8g},{p.y:.8g})" for p in way)
        yield rf"\addplot[{look}, no markers{told}] coordinates {{{places}}};"
        if not i and layout.has_legend:
            yield rf"\addlegendentry{{${mathematics(entry(curve, layout))}$}}"


def _marks(layout: Layout) -> Iterator[str]:
    frame = layout.frame
    marks = [
        (mark, pen)
        for curve, pen in layout.pens.items()
        for mark in curve.marks
        if frame.least.y <= layout.value(mark.at).y <= frame.most.y
    ]
    told = sum(mark.kind != "default" for mark, _ in marks)
    for mark, pen in marks:
        yield _mark(mark, pen, layout, told <= NAMED or layout.plot.equal)


def _mark(mark: Mark, pen: Pen, layout: Layout, is_named: bool) -> str:
    x, y = layout.value(mark.at)
    fill = f"mechc{pen.name}" if mark.kind in ("default", "station") else "white"
    side = "below" if mark.kind == "minimum" else "above"
    text = f"${mathematics((Run(values_at(mark, layout)[0]),))}$"
    named = is_named and mark.kind != "default"
    node = rf" node[{side}, font=\small] {{{text}}}" if named else ""
    look = f"draw=mechc{pen.name}, text=mechc{pen.name}, fill={fill}"
    return rf"\path[{look}] (axis cs:{x:.8g},{y:.8g}) circle[radius=0.9mm]{node};"
