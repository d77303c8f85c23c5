"""A drawing as SVG: a millimetre is a unit, numbers are rounded, and all text is escaped.

A PDF or a PNG is the same SVG, set by typst: a library that is installed with ``mechc[pdf]``. It
has letters of its own, Cyrillic and Greek among them, and is asked for no others: a picture is
the same on a machine without fonts.
"""

import math
from collections.abc import Iterable, Iterator
from html import escape
from importlib import import_module
from itertools import groupby
from typing import Any

from ...diagnostics import MechcError
from ...diagnostics.drawing import no_library
from ...drawing.drawing import Arc, Drawing, Fill, Label, Plane, Polyline, Shape, TextRun
from ...drawing.lettering import INDEX_SIZE, SMALLER
from ...drawing.pens import Pen

FONTS = (
    "STIX Two Text, Times New Roman, Liberation Serif, FreeSerif, Noto Serif, DejaVu Serif,"
    " CMU Serif, Latin Modern Roman, serif"
)
"""Fonts by which text is set, those with Greek and Cyrillic letters first.

CMU Serif comes late: its slanted α looks like its a.
"""

TINT = "#e8edf2"
"""The colour of what is filled lightly."""

_BASELINE = 0.32
"""How far below the middle of a letter's box its foot is, in letters."""

NO_SHIFT = 1e-9
"""A step from line to line below this, in millimetres, is none."""

_SHIFT = {-2: 0.34, -1: 0.22, 0: 0.0, 1: -0.38}
"""How far below the base line a run of a level is, as a part of the letters' size."""


def to_svg(drawing: Drawing) -> str:
    """Return a picture as a document of its own, with a text that stands for it."""
    width, height = drawing.high.minus(drawing.low)
    lines = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{_number(width)}mm"'
        f' height="{_number(height)}mm" viewBox="0 0 {_number(width)} {_number(height)}">',
        f"<title>{_text(drawing.title)}</title>",
        f"<desc>{_text(drawing.description)}</desc>",
        '<rect width="100%" height="100%" fill="#fff"/>',
        '<g fill="none" stroke-linecap="round" stroke-linejoin="round">',
        *_shapes(drawing),
        "</g>",
        f'<g font-family="{escape(FONTS)}" text-anchor="middle" xml:space="preserve">',
        *(_label(label, drawing) for label in drawing.labels),
        "</g>",
        "</svg>",
    )
    return "\n".join(lines) + "\n"


def _text(text: str) -> str:
    """Return text of the user's as XML takes it: without characters that it forbids."""
    return escape("".join(c if c.isprintable() else " " for c in text), quote=False)


def _shapes(drawing: Drawing) -> Iterator[str]:
    """Yield a path for each row of shapes that look alike."""
    for (pen, fill), shapes in groupby(drawing.shapes, key=lambda shape: (shape.pen, shape.fill)):
        ways = "".join(_way(shape, drawing) for shape in shapes)
        yield f'<path d="{ways}"{_look(pen, fill)}/>'


def _look(pen: Pen, fill: Fill) -> str:
    colours = {"": "", "white": "#fff", "light": TINT, "solid": pen.colour}
    look = f' fill="{colours[fill]}"' if fill else ""
    if pen.width:
        look += f' stroke="{pen.colour}" stroke-width="{_number(pen.width)}"'
    if pen.dashes:
        look += f' stroke-dasharray="{" ".join(map(_number, pen.dashes))}"'
    return look


def _way(shape: Shape, drawing: Drawing) -> str:
    match shape:
        case Polyline(points, _, closed):
            return f"M{_row(points, drawing)}{'Z' if closed else ''}"
        case Arc():
            return _arc(shape, drawing)


def _arc(arc: Arc, drawing: Drawing) -> str:
    """Return an arc, in two halves: SVG has none that goes all the way round."""
    start, middle, end = (_pair(arc.at(part), drawing) for part in (0.0, 0.5, 1.0))
    radius, turn = _number(arc.radius), 0 if arc.sweep > 0 else 1
    halves = "".join(f"A{radius} {radius} 0 0 {turn} {place}" for place in (middle, end))
    return f"M{start}{halves}{'Z' if arc.whole else ''}"


def _row(points: Iterable[Plane], drawing: Drawing) -> str:
    return " ".join(_pair(point, drawing) for point in points)


def _pair(at: Plane, drawing: Drawing) -> str:
    """Return a place as SVG counts: from the upper left corner, downwards."""
    return f"{_number(at.x - drawing.low.x)} {_number(drawing.high.y - at.y)}"


def _number(value: float) -> str:
    """Return a number to a hundredth, in as few letters as can be.

    >>> _number(-0.004), _number(2.50), _number(-0.25)
    ('0', '2.5', '-.25')
    """
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    if text in ("-0", ""):
        return "0"
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text


def _label(label: Label, drawing: Drawing) -> str:
    foot = label.at.minus(Plane(0.0, _BASELINE * label.size))
    x, y = _pair(foot, drawing).split()
    runs = "".join(_runs(label))
    colour = "" if label.pen.colour == "#000000" else f' fill="{label.pen.colour}"'
    return f'<text x="{x}" y="{y}" font-size="{_number(label.size)}"{colour}>{runs}</text>'


def _runs(label: Label) -> Iterator[str]:
    """Yield the runs of a label as tspans, whose dy counts from the run before."""
    before = 0.0
    for run in label.runs:
        shift = _SHIFT[run.level] * label.size
        yield f"<tspan{_type(run, label.size, shift - before)}>{_text(run.text)}</tspan>"
        before = shift


def _type(run: TextRun, size: float, step: float) -> str:
    italic = ' font-style="italic"' if run.italic else ""
    scale = SMALLER if run.level < -1 else INDEX_SIZE
    small = f' font-size="{_number(scale * size)}"' if run.level else ""
    moved = f' dy="{_number(step)}"' if not math.isclose(step, 0.0, abs_tol=NO_SHIFT) else ""
    return f"{italic}{small}{moved}"


DENSITY = 150
"""Points to an inch of a PNG."""


_PAGE = "#set page(width: auto, height: auto, margin: 0pt)\n"


def to_pdf(drawing: Drawing) -> bytes:
    """Return a picture on a page of its size; :class:`MechcError` (E721) without the library."""
    return _set(drawing, "PDF", format="pdf", timestamp=0)


def to_png(drawing: Drawing) -> bytes:
    """Return a picture in points; :class:`MechcError` (E721) without the library."""
    return _set(drawing, "PNG", format="png", ppi=DENSITY)


def _set(drawing: Drawing, what: str, **options: Any) -> bytes:
    try:
        typst: Any = import_module("typst")
    except ImportError as error:
        raise MechcError([no_library(what, what.lower(), str(error))]) from None
    text = to_svg(drawing).replace("\\", "\\\\").replace('"', '\\"')
    page = f'{_PAGE}#image(bytes("{text}"), format: "svg")\n'
    return bytes(typst.compile(page.encode(), ignore_system_fonts=True, **options))
