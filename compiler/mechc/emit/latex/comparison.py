r"""Several mechanisms in one table: the scheme of each beside its formulas.

A fragment needs what a report does, graphicx and tikz, and the lines of :func:`.pictures.preamble`.
"""

from collections.abc import Iterable, Iterator, Sequence

from ...base.frozen import frozen
from ...drawing.drawing import Drawing
from ...drawing.language_letters import in_letters
from ...formula.letters import letters
from ...report.languages import registry
from ...report.languages.locale import Locale
from ...report.latex.document_style import style_of
from ...report.latex.notation import LatexNotation, notation, translated
from ...report.latex.results import section_block, width
from ...report.sections import Section, outline
from ...report.steps import unexplained
from ..render import Nothing, render
from ..target import Compiled
from ..tikz.picture import tikzpicture
from .pictures import preamble
from .to_latex import document

_SHARE = 0.44
"""The part of a line that each of the two columns has."""

_COLUMNS = (
    rf"@{{}}r>{{\centering\arraybackslash}}m{{{_SHARE}\linewidth}}"
    rf">{{\raggedright\arraybackslash}}m{{{_SHARE}\linewidth}}@{{}}"
)

_ROOM = 14.0
"""Room in the second column, in em: its share of 160 mm at 11 pt, less some air."""

_BESIDE = 4
"""Sections in a row of the table: one with more of them could outgrow its page."""

_CLOSE_DISPLAYS = r"\abovedisplayskip=3pt\belowdisplayskip=3pt"
"""In a column the formulas of a mechanism are a list, not displays in a text."""

_FULL_WIDTH = r"\resizebox{\linewidth}{!}{%"

_TALL = 1.2
"""Height of a scheme, by the width of its column, beyond which the height is what is bounded."""


@frozen
class Compared:
    """A mechanism of the table, with its scheme if it has one."""

    compiled: Compiled
    scheme: Drawing | None


def to_table(mechanisms: Sequence[Compared], language: str, fragment: bool) -> str:
    """Return a table in a language, as a document or to be put into one."""
    locale = registry.locale(language)
    letters = render("latex/letters.jinja", Nothing())
    body = letters + "\n".join(_table(mechanisms, locale, language)) + "\n"
    return body if fragment else document(body, locale, preamble())


def _table(mechanisms: Iterable[Compared], locale: Locale, language: str) -> Iterator[str]:
    """Yield the lines of a table in LaTeX, with the rows of each mechanism between rules."""
    words = locale.comparison
    yield rf"\begin{{longtable}}{{{_COLUMNS}}}"
    yield r"\toprule"
    yield rf"{words['number']} & {words['scheme']} & {words['results']} \\"
    yield r"\midrule"
    yield r"\endhead"
    for number, compared in enumerate(mechanisms, start=1):
        if number > 1:
            yield r"\midrule"
        yield from _rows(number, compared, locale, language)
    yield r"\bottomrule"
    yield r"\end{longtable}"


def _rows(number: int, compared: Compared, locale: Locale, language: str) -> Iterator[str]:
    """Yield the row of a scheme with its first formulas, and rows of the others.

    They go on in their own column, the wide ones across both.
    """
    compiled = compared.compiled
    style = style_of(compiled.mechanism, compiled.derivation.results, notation(language))
    sections = outline(unexplained(compiled.derivation), compiled.mechanism).results
    beside, *below = _in_rows(sections, style)
    yield f"{number} &"
    yield from _scheme(compared, style, locale)
    yield "&"
    yield from _cell(beside, locale, style)
    yield r"\\"
    for row in below:
        is_wide = _is_wide(row[0], style)
        yield r"\multicolumn{3}{@{}p{\linewidth}@{}}{%" if is_wide else "& &"
        yield from _cell(row, locale, style)
        yield r"} \\" if is_wide else r"\\"


def _in_rows(sections: Iterable[Section], style: LatexNotation) -> list[list[Section]]:
    """Give what stands beside the scheme, maybe nothing, and the rows below it.

    A wide section has a row of its own.
    """
    rows: list[list[Section]] = [[]]
    after_wide = False
    for section in sections:
        is_wide = _is_wide(section, style)
        if is_wide or after_wide or len(rows[-1]) == _BESIDE:
            rows.append([])
        rows[-1].append(section)
        after_wide = is_wide
    return rows


def _is_wide(section: Section, style: LatexNotation) -> bool:
    """Return whether a section is wider than its column."""
    return width(section, style) > _ROOM


def _scheme(compared: Compared, style: LatexNotation, locale: Locale) -> Iterator[str]:
    mechanism, scheme = compared.compiled.mechanism, compared.scheme
    if scheme is not None:
        (left, bottom), (right, top) = scheme.low, scheme.high
        is_tall = top - bottom > _TALL * (right - left)
        yield rf"\resizebox{{!}}{{{_TALL}\linewidth}}{{%" if is_tall else _FULL_WIDTH
        yield from tikzpicture(in_letters(scheme, letters(locale, style.texts)))
        yield r"}\par\smallskip"
    yield rf"{{\small {translated(mechanism.title or mechanism.name, style)}\par}}"


def _cell(sections: Iterable[Section], locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield displays, each with what its names stand for.

    Braces keep the ``&`` of an ``align*`` from ending the cell.
    """
    yield rf"{{{_CLOSE_DISPLAYS}"
    for section in sections:
        yield from section_block(section, locale, style).displays
    yield "}"
