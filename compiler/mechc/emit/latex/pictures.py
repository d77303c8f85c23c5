"""The pictures of a report, each at its place: scheme, free bodies, plot, and its table."""

import re
from collections.abc import Iterable, Iterator

from ...drawing.drawing import Drawing
from ...model.mechanism import Reported
from ...plot.plot import Column, Plot
from ...plot.query import Query
from ...plot.usual import ROWS, usual
from ...report.languages.locale import Locale
from ...report.latex.notation import Notation, name
from ..pgfplots.to_pgfplots import tikzpicture as plotted
from ..target import Compiled
from ..tikz.picture import definitions, tikzpicture
from .picture_lines import Pictures
from .tables import along_stroke, head, number, tabular

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
    """Return the pictures of a mechanism at the pose of its description.

    They are those that it wants in its report; where it says nothing, the scheme, the free
    bodies, the plot of the first result, and the table of that, along the stroke if there is one.
    """
    named = {part.name for part in _wanted(compiled) if not part.over}
    words, plots = locale.pictures, [compiled.plot(query) for query in _queries(compiled)]
    along = compiled.stroke(ROWS) if "stroke" in named else None
    found = Pictures(
        _drawn(compiled.scheme if "scheme" in named else None, words["scheme"]),
        _drawn(compiled.drawn_bodies(words) if "bodies" in named else None, words["bodies"]),
        _drawn(compiled.drawn_plans(words) if "plans" in named else None, words["plans"]),
        tuple(line for p in plots for line in _centred(plotted(p), _against(p, locale, style))),
        tuple(along_stroke(along, locale, style) if along else _tables(plots, locale, style)),
    )
    return Pictures(*(tuple(_localized(lines, locale)) for lines in found))


def _wanted(compiled: Compiled) -> tuple[Reported, ...]:
    """Return what the report holds."""
    usual_ones = ("scheme", "bodies", *(["stroke"] if compiled.mechanism.drive else []))
    return compiled.mechanism.reported or tuple(map(Reported, usual_ones))


def _queries(compiled: Compiled) -> Iterator[Query]:
    """Yield what is plotted."""
    for part in compiled.mechanism.reported:
        if part.over:
            yield Query(part.over, (part.name,), points=ROWS)
    if not compiled.mechanism.reported:
        first = usual(compiled.mechanism, compiled.routine)
        yield from (first,) if first else ()


def _drawn(drawing: Drawing | None, caption: str) -> tuple[str, ...]:
    return tuple(_picture(drawing, caption)) if drawing else ()


def _tables(plots: Iterable[Plot], locale: Locale, style: Notation) -> Iterator[str]:
    """Yield the table of the values of each plot."""
    for plot in plots:
        heads = [head(name(c.axis.name, style), c.axis.unit, locale) for c in plot.columns]
        columns = (_cells(column, style) for column in plot.columns)
        yield from tabular(heads, list(zip(*columns, strict=True)))


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


def _cells(column: Column, style: Notation) -> Iterator[str]:
    for value in column.values:
        yield number(value / column.axis.size, style)


def _localized(lines: Iterable[str], locale: Locale) -> Iterator[str]:
    """Yield lines with the decimal sign of a language in what is written."""
    for line in lines:
        yield _WRITTEN.sub(lambda found: found[0].replace(".", locale.decimal), line)
