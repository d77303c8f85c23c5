"""The pictures of a report, each at its place: scheme, free bodies, plot, and its table."""

from collections.abc import Iterable, Iterator

from ...diagnostics import MechcError
from ...drawing.arrange import parted
from ...drawing.drawing import Drawing
from ...drawing.language_letters import in_letters
from ...formula.letters import Letters, letters
from ...model.mechanism import Reported
from ...plot.plot import Plot, PlotColumn
from ...plot.query import ROWS, Query, rows, usual
from ...report.languages.locale import Locale, Words
from ...report.latex.notation import LatexNotation, name, of_result
from ...study.stroke.stroke import Stroke
from ..pgfplots.to_pgfplots import tikzpicture as plotted
from ..target import Compiled
from ..tikz.picture import definitions, tikzpicture
from .blocks import NO_PICTURES, Pictures
from .tables import along_stroke, head, numbers, tabular

WIDE, HIGH = 155.0, 200.0
"""How large a picture may be on a page, in millimetres; a larger one is made smaller."""


def preamble() -> Iterator[str]:
    """Yield the lines of a preamble that pictures need."""
    yield r"\usepackage{graphicx}"
    yield r"\usepackage{tikz}"
    yield r"\usepackage{pgfplots}"
    yield r"\pgfplotsset{compat=1.15}"
    yield from definitions()


def pictures(compiled: Compiled, locale: Locale, style: LatexNotation) -> Pictures:
    """Return the pictures of a mechanism at the pose of its description.

    They are those that it wants in its report; where it says nothing, the scheme, the free
    bodies, the plot of the first result, and the table of that, along the stroke if there is one.
    """
    named = {part.name for part in _wanted(compiled) if not part.over}
    words, plots = locale.pictures, [compiled.plot(query) for query in _queries(compiled)]
    known = _letters(compiled, locale, style)
    along = _stroke(compiled)
    others = [plot for plot in plots if along is None or plot.x.name != along.drive]
    scheme = compiled.drawn_scheme(style.language) if "scheme" in named else None
    drawings = {
        "bodies": compiled.drawn_bodies(style.language) if "bodies" in named else None,
        "plans": compiled.drawn_plans(style.language) if "plans" in named else None,
    }
    afloat = {n: tuple(_afloat(d, words[n], known, words)) for n, d in drawings.items()}
    return Pictures(
        scheme=tuple(_drawn(scheme, words["scheme"], known)),
        **afloat,
        plot=tuple(line for plot in plots for line in _plotted(plot, known, locale, style)),
        table=(
            *(along_stroke(along, locale, style) if along else ()),
            *_tables(others, locale, style),
        ),
    )


def scheme_alone(compiled: Compiled, locale: Locale, style: LatexNotation) -> Pictures:
    """Return the scheme of a mechanism as its only picture."""
    drawing = compiled.drawn_scheme(style.language)
    known = _letters(compiled, locale, style)
    return NO_PICTURES._replace(scheme=tuple(_drawn(drawing, locale.pictures["scheme"], known)))


def _letters(compiled: Compiled, locale: Locale, style: LatexNotation) -> Letters:
    return letters(locale, compiled.mechanism.translations.get(style.language, style.texts))


def _wanted(compiled: Compiled) -> tuple[Reported, ...]:
    """Return the parts of the report: the scheme and the free bodies where none are chosen."""
    return compiled.mechanism.reported or (Reported("scheme"), Reported("bodies"))


def _stroke(compiled: Compiled) -> Stroke | None:
    """Return the stroke if it is wanted; by itself it is, as far as it is not too much work."""
    reported = compiled.mechanism.reported
    if reported:
        return _of_rows(compiled) if Reported("stroke") in reported else None
    try:
        return _of_rows(compiled) if compiled.mechanism.drive else None
    except MechcError:
        return None


def _of_rows(compiled: Compiled) -> Stroke:
    """Return the stroke at round values of the drive, as far as it has some."""
    drive = compiled.mechanism.drive
    return compiled.stroke(rows(drive.parameter, compiled.mechanism) if drive else ROWS)


def _queries(compiled: Compiled) -> Iterator[Query]:
    """Yield the queries of the plots."""
    for part in compiled.mechanism.reported:
        if part.over:
            table = rows(part.over, compiled.mechanism)
            yield Query(part.over, (part.name,), points=table)
    if not compiled.mechanism.reported:
        first = usual(compiled.mechanism, compiled.routine)
        yield from (first,) if first else ()


def _drawn(drawing: Drawing | None, caption: str, known: Letters) -> Iterator[str]:
    """Yield a drawing, if there is one, in the letters of a language."""
    if drawing is not None:
        yield from _centred(_picture(in_letters(drawing, known)), caption)


def _afloat(drawing: Drawing | None, caption: str, known: Letters, words: Words) -> Iterator[str]:
    """Yield a drawing, if there is one, where the text beside it leaves no page half empty.

    One that a page holds only where it is made small goes on in another picture.
    """
    if drawing is None:
        return
    scale = min(1.0, WIDE / (drawing.high.x - drawing.low.x))
    for number, part in enumerate(parted(drawing, HIGH / scale)):
        said = words["continued"].format(caption=caption) if number else caption
        yield from _floating(_picture(in_letters(part, known)), said)


def _plotted(plot: Plot, known: Letters, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield a plot above its caption."""
    return _floating(plotted(plot, locale.pictures, known), _against(plot, locale, style))


def _tables(plots: Iterable[Plot], locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield the table of the values of each plot."""
    for plot in plots:
        heads = [head(of_result(c.axis.name, style), c.axis.unit, locale) for c in plot.columns]
        columns = (numbers(_in_unit(column), style) for column in plot.columns)
        yield rf"\medskip\noindent {_against(plot, locale, style)}:"
        yield from tabular(heads, list(zip(*columns, strict=True)))


def _picture(drawing: Drawing) -> Iterator[str]:
    """Yield a drawing in its size, or as large as a page takes it."""
    width, height = drawing.high.minus(drawing.low)
    scale = min(1.0, WIDE / width, HIGH / height)
    yield from (rf"\scalebox{{{scale:.3g}}}{{%", *tikzpicture(drawing), "}")


def _centred(lines: Iterable[str], caption: str) -> Iterator[str]:
    yield r"\begin{center}"
    yield from lines
    yield rf"\par\nopagebreak\smallskip{{\small {caption}\par}}"
    yield r"\end{center}"


def _floating(lines: Iterable[str], caption: str) -> Iterator[str]:
    """Yield a picture that goes to the next page where it is too high for this one."""
    yield r"\begin{figure}[!htb]"
    yield r"\centering"
    yield from lines
    yield rf"\par\nopagebreak\smallskip{{\small {caption}\par}}"
    yield r"\end{figure}"


def _against(plot: Plot, locale: Locale, style: LatexNotation) -> str:
    """Return the caption of a plot: its curves, and the parameter along its axis."""
    names = ", ".join(f"${of_result(curve.name, style)}$" for curve in plot.curves)
    return locale.pictures["plot"].format(names=names, x=f"${name(plot.x.name, style)}$")


def _in_unit(column: PlotColumn) -> list[float]:
    return [value / column.axis.size for value in column.values]
