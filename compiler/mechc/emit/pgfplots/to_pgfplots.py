"""A plot for LaTeX: axes of pgfplots, with the values of the curves in the text."""

from collections.abc import Iterable, Iterator, Mapping

from ...drawing.drawing import TextRun
from ...drawing.language_letters import spelled
from ...drawing.pens import Pen
from ...drawing.plots.axes import heading
from ...drawing.plots.describe_plot import describe
from ...drawing.plots.marks import DOT, THIN, dots, values_beside
from ...drawing.plots.panels import PanelLayout, common_entry, entry, laid_out, steps, ways
from ...drawing.plots.ticks import Scale
from ...formula.letters import LATIN, Letters, lettered
from ...plot.plot import Curve, Plot
from ...pose.places import Plane
from ..tikz.picture import comment, cyrillic, mathematics

APART = 26.0
"""How far panels are below each other, in millimetres."""


def to_pgfplots(plot: Plot, words: Mapping[str, str], letters: Letters = LATIN) -> str:
    """Return a plot as a document for every TeX engine, in words and letters of a language."""
    picture = list(tikzpicture(plot, words, letters))
    lines = (
        f"% {comment(plot.title)}",
        f"% {comment(lettered(describe(plot, words), letters))}",
        r"\documentclass[tikz]{standalone}",
        r"\usepackage{amsmath}",
        *cyrillic(picture),
        r"\usepackage{pgfplots}",
        r"\pgfplotsset{compat=1.15}",
        r"\begin{document}",
        *picture,
        r"\end{document}",
    )
    return "\n".join(lines) + "\n"


def tikzpicture(plot: Plot, words: Mapping[str, str], letters: Letters = LATIN) -> Iterator[str]:
    """Yield the lines of the picture alone, in words and letters of a language."""
    layouts = [laid_out(plot, panel, words) for panel in plot.panels]
    yield r"\begin{tikzpicture}"
    for pen in dict.fromkeys(pen for layout in layouts for pen in layout.pens.values()):
        yield rf"\definecolor{{mechc{pen.name}}}{{HTML}}{{{pen.colour[1:].upper()}}}"
    top = 0.0
    for layout in layouts:
        top -= layout.frame.high.y
        yield from _axis(layout, top, letters)
        top -= APART
    yield r"\end{tikzpicture}"


def _axis(layout: PanelLayout, bottom: float, letters: Letters) -> Iterator[str]:
    """Yield the lines of one panel: its axes, what is shaded, its curves."""
    frame = layout.frame
    x, y = heading((layout.plot.x,), layout.across), heading(layout.headed, layout.up)
    yield r"\begin{axis}["
    yield f"  at={{(0mm,{bottom:g}mm)}}, anchor=south west, scale only axis,"
    yield f"  width={frame.high.x:g}mm, height={frame.high.y:g}mm,"
    yield f"  xmin={frame.least.x!r}, xmax={frame.most.x!r},"
    yield f"  ymin={frame.least.y!r}, ymax={frame.most.y!r},"
    yield f"  {_ticks('x', layout.across, letters)},"
    yield f"  {_ticks('y', layout.up, letters)},"
    yield f"  xlabel={{{_set(x, letters)}}},"
    yield f"  ylabel={{{_set(y, letters)}}},"
    yield "  grid=major, grid style={gray!40, very thin}, legend pos=outer north east,"
    yield "  legend cell align=left, clip mode=individual]"
    yield from _shaded(layout)
    yield from _poles(layout)
    for curve, pen in layout.pens.items():
        yield from _curve(curve, pen, layout, letters)
    if layout.common:
        yield r"\addlegendimage{empty legend}"
        yield rf"\addlegendentry{{{_set(common_entry(layout), letters)}}}"
    yield from _marks(layout, letters)
    yield r"\end{axis}"


def _set(runs: Iterable[TextRun], letters: Letters) -> str:
    """Return text as mathematics in the letters of a language."""
    return f"${mathematics(spelled(runs, letters))}$"


def _ticks(axis: str, scale: Scale, letters: Letters) -> str:
    """Return the ticks and what is written at them."""
    places = ",".join(f"{tick:.12g}" for tick in scale.ticks)
    texts = ",".join(_set((TextRun(scale.text(t)),), letters) for t in scale.ticks)
    return f"{axis}tick={{{places}}}, {axis}ticklabels={{{texts}}}, scaled {axis} ticks=false"


def _shaded(layout: PanelLayout) -> Iterator[str]:
    """Yield the zone that is marked, or the range of the description."""
    frame = layout.frame
    for left, right in layout.shaded:
        corners = f"{left!r},{frame.least.y!r}) rectangle (axis cs:{right!r},{frame.most.y!r}"
        yield rf"\fill[black!8] (axis cs:{corners});"


def _poles(layout: PanelLayout) -> Iterator[str]:
    frame = layout.frame
    for pole in sorted({pole for curve in layout.panel.curves for pole in curve.poles}):
        x = layout.value(Plane(pole, 0.0)).x
        ends = f"(axis cs:{x!r},{frame.least.y!r}) -- (axis cs:{x!r},{frame.most.y!r})"
        yield rf"\draw[dash dot, gray] {ends};"


def _curve(curve: Curve, pen: Pen, layout: PanelLayout, letters: Letters) -> Iterator[str]:
    """Yield the jumps of a curve as thin lines, then its pieces, the first with a legend."""
    for step in steps(curve, layout):
        look = f"mechc{pen.name}, line width={THIN:g}mm"
        yield rf"\addplot[{look}, no markers, forget plot] coordinates {{{_listed(step)}}};"
    look = f"mechc{pen.name}, line width={pen.width:g}mm" + (", dashed" if pen.dashes else "")
    for i, way in enumerate(ways(curve, layout)):
        in_legend = "" if layout.has_legend and not i else ", forget plot"
        yield rf"\addplot[{look}, no markers{in_legend}] coordinates {{{_listed(way)}}};"
        if not i and layout.has_legend:
            yield rf"\addlegendentry{{{_set(entry(curve, layout), letters)}}}"


def _listed(places: Iterable[Plane]) -> str:
    return " ".join(f"({p.x:.8g},{p.y:.8g})" for p in places)


def _marks(layout: PanelLayout, letters: Letters) -> Iterator[str]:
    """Yield rings and dots, and their values where the picture has them, too."""
    for dot, mark, _ in dots(layout):
        x, y = layout.value(mark.at)
        colour = f"mechc{dot.pen.name}"
        fill = colour if dot.fill == "solid" else "white"
        look = f"draw={colour}, fill={fill}"
        yield rf"\path[{look}] (axis cs:{x:.8g},{y:.8g}) circle[radius={DOT:g}mm];"
    corner = layout.frame.high
    for label in values_beside(layout):
        at = f"rel axis cs:{label.at.x / corner.x:.4f},{label.at.y / corner.y:.4f}"
        look = rf"text=mechc{label.pen.name}, fill=white, inner sep=1pt, font=\small"
        yield rf"\node[{look}] at ({at}) {{{_set(label.runs, letters)}}};"
