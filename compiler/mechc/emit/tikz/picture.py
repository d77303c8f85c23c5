"""A drawing as TikZ, in a document of its own that needs no other package."""

import math
from collections.abc import Iterable, Iterator
from itertools import groupby

from ...base.later import pattern
from ...drawing.drawing import Arc, Drawing, Fill, Label, Plane, Polyline, Shape, TextRun
from ...drawing.lettering import SIZE
from ...drawing.pens import PENS, Pen
from ...formula.names import GREEK
from ...report.latex.text import escape

POINTS = 72.27 / 25.4
"""TeX's points in a millimetre."""

TINT = "E8EDF2"

_LETTERS = {letter: rf"\{name} " for name, letter in GREEK.items()} | {
    "−": "{-}",
    "+": "{+}",
    "=": "{=}",
    ":": "{:}",
    "\u2009": r"\,",
    " ": r"\ ",
    "°": r"^{\circ}",
    "√": r"\surd ",
    "ο": "o",
    "φ": r"\varphi ",
    "ε": r"\varepsilon ",
}
"""Characters of labels in mathematics."""

_PLAIN = frozenset("-/().,'?;")

FONTS = ("cmunrm.otf", "Noto Serif", "FreeSerif", "Liberation Serif", "DejaVu Serif")
"""Fonts with Cyrillic letters, of which the first is taken that is installed."""

_COMMA = pattern(r"(?<=\d),(?=\d)")
"""A decimal comma, behind which mathematics would leave a space."""


def to_tikz(drawing: Drawing) -> str:
    """Return a picture as a document for every TeX engine."""
    picture = list(tikzpicture(drawing))
    lines = (
        f"% {comment(drawing.title)}",
        f"% {comment(drawing.description)}",
        r"\documentclass[tikz]{standalone}",
        r"\usepackage{amsmath}",
        *cyrillic(picture),
        *definitions(),
        r"\begin{document}",
        *picture,
        r"\end{document}",
    )
    return "\n".join(lines) + "\n"


def cyrillic(picture: Iterable[str]) -> Iterator[str]:
    """Yield the lines of a preamble by which Cyrillic letters are set, where there are any."""
    if not any(r"\mechccyr" in line for line in picture):
        return
    yield r"\usepackage{iftex}"
    yield r"\ifPDFTeX"
    yield r"  \usepackage[T2A,T1]{fontenc}"
    yield r"  \newcommand{\mechccyr}[1]{{\fontencoding{T2A}\fontfamily{cmr}\selectfont #1}}"
    yield r"\else"
    yield r"  \usepackage[no-math]{fontspec}"
    yield r"  \newcommand{\mechccyr}[1]{{#1}}"
    for font in FONTS:
        yield rf"  \IfFontExistsTF{{{font}}}{{\setmainfont{{{font}}}}}{{%"
    yield rf"  {'}' * len(FONTS)}"
    yield r"\fi"


def definitions() -> Iterator[str]:
    """Yield the lines of a preamble that say how pens draw."""
    yield from map(_definition, PENS)
    yield rf"\definecolor{{mechctint}}{{HTML}}{{{TINT}}}"


def tikzpicture(drawing: Drawing) -> Iterator[str]:
    """Yield the lines of the picture alone."""
    size = SIZE * POINTS
    yield r"\begin{tikzpicture}[x=1mm, y=1mm, line cap=round, line join=round,"
    yield rf"  every node/.style={{inner sep=0pt, font=\fontsize{{{size:.4g}}}{{13}}\selectfont}}]"
    yield rf"\path {_pair(drawing.low)} rectangle {_pair(drawing.high)};"
    yield from map(_shape, drawing.shapes)
    yield from map(_label, drawing.labels)
    yield r"\end{tikzpicture}"


def comment(text: str) -> str:
    """Return text of the user's without what would end a comment."""
    return "".join(c if c.isprintable() else " " for c in text)


def _definition(pen: Pen) -> str:
    """Return the colour and the style of a pen."""
    dashes = [
        f"{way} {_number(d)}mm" for way, d in zip(("on", "off") * 4, pen.dashes, strict=False)
    ]
    pattern = f", dash pattern={' '.join(dashes)}" if dashes else ""
    return (
        rf"\definecolor{{mechc{pen.name}}}{{HTML}}{{{pen.colour[1:].upper()}}}"
        rf" \tikzset{{{pen.name}/.style={{mechc{pen.name},"
        rf" line width={_number(pen.width)}mm{pattern}}}}}"
    )


def _shape(shape: Shape) -> str:
    return rf"\path[{_look(shape.pen, shape.fill)}] {_way(shape)};"


def _look(pen: Pen, fill: Fill) -> str:
    colours = {"white": "white", "light": "mechctint", "solid": f"mechc{pen.name}"}
    look = [pen.name, "draw"] if pen.width else []
    return ", ".join([*look, *([f"fill={colours[fill]}"] if fill else [])])


def _way(shape: Shape) -> str:
    match shape:
        case Polyline(points, _, closed):
            return f"{' -- '.join(map(_pair, points))}{' -- cycle' if closed else ''}"
        case Arc(centre, radius) if shape.whole:
            return f"{_pair(centre)} circle[radius={_number(radius)}]"
        case Arc(_, radius, _, start, sweep):
            ends = (_number(math.degrees(angle)) for angle in (start, start + sweep))
            angles = "start angle={}, end angle={}".format(*ends)
            return f"{_pair(shape.at(0.0))} arc[{angles}, radius={_number(radius)}]"


def _pair(at: Plane) -> str:
    return f"({_number(at.x)},{_number(at.y)})"


def _number(value: float) -> str:
    """Return a number to a hundredth.

    >>> _number(-0.004), _number(2.50)
    ('0', '2.5')
    """
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _label(label: Label) -> str:
    colour = f"[text=mechc{label.pen.name}]"
    return rf"\node{colour} at {_pair(label.at)} {{${mathematics(label.runs)}$}};"


def mathematics(runs: Iterable[TextRun]) -> str:
    """Return text in runs as mathematics."""
    return "".join(_runs(runs))


def _runs(runs: Iterable[TextRun]) -> Iterator[str]:
    for sign, group in groupby(runs, lambda run: (run.level > 0) - (run.level < 0)):
        text = "".join(f"_{{{_run(run)}}}" if run.level < -1 else _run(run) for run in group)
        yield {0: text, -1: f"_{{{text}}}", 1: f"^{{{text}}}"}[sign]


def _run(run: TextRun) -> str:
    text = _COMMA.sub("{,}", "".join(map(_spelled, run.text)))
    if any(c.isascii() and c.isalpha() for c in run.text):
        return rf"\mathit{{{text}}}" if run.italic else rf"\mathrm{{{text}}}"
    return text


def _spelled(character: str) -> str:
    """Return a character of a label in mathematics."""
    if character in _LETTERS:
        return _LETTERS[character]
    if character in _PLAIN or (character.isascii() and character.isalnum()):
        return character
    return rf"\text{{{escape(character)}}}"
