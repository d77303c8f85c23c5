"""The pictures of a report, each at its place: scheme, free bodies, plot, and its table."""

import math
import re
from collections.abc import Iterable, Iterator

from ...drawing.drawing import Drawing
from ...plot.plot import Axis, Column, Plot
from ...plot.usual import usual
from ...report.languages.locale import Locale
from ...report.latex.notation import Notation, name
from ...report.latex.quantity import decimal
from ...report.latex.unit_symbols import unit_symbol
from ..pgfplots.to_pgfplots import tikzpicture as plotted
from ..target import Compiled
from ..tikz.picture import definitions, tikzpicture
from .picture_lines import Pictures

WIDE, HIGH = 155.0, 200.0
"""How large a picture may be on a page, in millimetres; a larger one is made smaller."""


_WRITTEN = re.compile(r"\$[^$]*\$")
"""What a picture says, in mathematics."""


def preamble() -> Iterator[str]:
    """Yield the lines of a preamble that pictures need."""
    yield r"\usepackage{graphicx}"
    yield r"\usepackage{tikz}"
    yield r"\usepackage{pgfplots}"
    yield r"\pgfplotsset{compat=1.15}"
    yield from definitions()


def pictures(compiled: Compiled, locale: Locale, style: Notation) -> Pictures:
    """Return the pictures of a mechanism at the pose of its description."""
    words, scheme = locale.pictures, compiled.scheme
    bodies = compiled.drawn_bodies(words)
    query = usual(compiled.mechanism, compiled.routine)
    plot = compiled.plot(query) if query else None
    found = Pictures(
        tuple(_picture(scheme, words["scheme"])) if scheme else (),
        tuple(_picture(bodies, words["bodies"])) if bodies else (),
        tuple(_centred(plotted(plot), _against(plot, locale, style))) if plot else (),
        tuple(_table(plot, locale, style)) if plot else (),
    )
    return Pictures(*(tuple(_localized(lines, locale)) for lines in found))


def _picture(drawing: Drawing, caption: str) -> Iterator[str]:
    """Yield a drawing in its size, or as large as a page takes it."""
    width, height = drawing.high.minus(drawing.low)
    scale = min(1.0, WIDE / width, HIGH / height)
    lines = (rf"\scalebox{{{scale:.3g}}}{{%", *tikzpicture(drawing), "}")
    yield from _centred(lines, caption)


def _centred(lines: Iterable[str], caption: str) -> Iterator[str]:
    yield r"\begin{center}"
    yield from lines
    yield rf"\par\nopagebreak\smallskip{{\small {caption}\par}}"
    yield r"\end{center}"


def _against(plot: Plot, locale: Locale, style: Notation) -> str:
    """Return what is plotted against what."""
    names = ", ".join(f"${name(curve.name, style)}$" for curve in plot.curves)
    return locale.pictures["plot"].format(names=names, x=f"${name(plot.x.name, style)}$")


def _table(plot: Plot, locale: Locale, style: Notation) -> Iterator[str]:
    """Yield the table of the values that are plotted."""
    yield r"\begin{center}"
    yield rf"\begin{{tabular}}{{@{{}}{'r' * len(plot.columns)}@{{}}}}"
    yield r"\toprule"
    yield f"{' & '.join(_head(c.axis, locale, style) for c in plot.columns)} \\\\"
    yield r"\midrule"
    for row in zip(*(_cells(c, style) for c in plot.columns), strict=True):
        yield f"{' & '.join(row)} \\\\"
    yield r"\bottomrule"
    yield r"\end{tabular}"
    yield r"\end{center}"


def _head(axis: Axis, locale: Locale, style: Notation) -> str:
    unit = unit_symbol(axis.unit, locale).removeprefix(r"\,")
    return f"${name(axis.name, style)}${f', ${unit}$' if unit else ''}"


def _cells(column: Column, style: Notation) -> Iterator[str]:
    for value in column.values:
        yield _number(value / column.axis.size, style)


def _number(value: float, style: Notation) -> str:
    """Return a number; a dash where there is none."""
    if math.isnan(value):
        return "--"
    return f"${decimal(value, style)}$" if math.isfinite(value) else r"$\infty$"


def _localized(lines: Iterable[str], locale: Locale) -> Iterator[str]:
    """Yield lines with the decimal sign of a language in what is written."""
    for line in lines:
        yield _WRITTEN.sub(lambda found: found[0].replace(".", locale.decimal), line)
