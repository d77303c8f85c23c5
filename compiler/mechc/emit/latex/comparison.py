r"""Several mechanisms in one table: the scheme of each beside its formulas.

A fragment needs what a report does, graphicx and tikz, and the lines of :func:`.pictures.preamble`.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import takewhile

from ...drawing.drawing import Drawing
from ...drawing.letters import in_letters
from ...frozen import frozen
from ...report.languages import registry
from ...report.languages.letters import letters
from ...report.languages.locale import Locale
from ...report.latex.document_style import style_of
from ...report.latex.notation import Notation, notation, translated
from ...report.latex.results import section_block, width
from ...report.sections import Section, outline
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

_BESIDE = 3
"""Sections that stand beside a scheme; a row with more of them could outgrow its page."""

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
    """Yield the row of a scheme with the formulas that fit beside it, and the rest below it."""
    compiled = compared.compiled
    style = style_of(compiled.mechanism, compiled.derivation.results, notation(language))
    sections = outline(compiled.derivation, compiled.mechanism).results
    beside = _beside(sections, style)
    yield f"{number} &"
    yield from _scheme(compared, style, locale)
    yield "&"
    yield from _cell(beside, locale, style)
    yield r"\\"
    for section in sections[len(beside) :]:
        yield r"\multicolumn{3}{@{}p{\linewidth}@{}}{%"
        yield from _cell([section], locale, style)
        yield r"} \\"


def _beside(sections: Sequence[Section], style: Notation) -> Sequence[Section]:
    """Return the first sections, as far as none is wider than its column."""
    return list(takewhile(lambda s: width(s, style) <= _ROOM, sections[:_BESIDE]))


def _scheme(compared: Compared, style: Notation, locale: Locale) -> Iterator[str]:
    mechanism, scheme = compared.compiled.mechanism, compared.scheme
    if scheme is not None:
        (left, bottom), (right, top) = scheme.low, scheme.high
        is_tall = top - bottom > _TALL * (right - left)
        yield rf"\resizebox{{!}}{{{_TALL}\linewidth}}{{%" if is_tall else _FULL_WIDTH
        yield from tikzpicture(in_letters(scheme, letters(locale)))
        yield r"}\par\smallskip"
    yield rf"{{\small {translated(mechanism.title or mechanism.name, style)}\par}}"


def _cell(sections: Iterable[Section], locale: Locale, style: Notation) -> Iterator[str]:
    """Yield displays, each with what its names stand for.

    Braces keep the ``&`` of an ``align*`` from ending the cell.
    """
    yield "{"
    for section in sections:
        yield from section_block(section, locale, style).displays
    yield "}"
