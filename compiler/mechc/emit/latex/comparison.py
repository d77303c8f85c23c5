r"""Several mechanisms in one table: the scheme of each beside its formulas.

A fragment needs what a report does, graphicx and tikz, and the lines of :func:`.pictures.preamble`.
"""

from collections.abc import Iterable, Iterator, Sequence

from ...drawing.drawing import Drawing
from ...frozen import frozen
from ...report.languages import registry
from ...report.languages.locale import Locale
from ...report.latex.document_style import style_of
from ...report.latex.notation import Notation, notation, translated
from ...report.latex.results import section_block
from ...report.sections import outline
from ..target import Compiled
from ..tikz.picture import tikzpicture
from .pictures import preamble
from .to_latex import document

_COLUMNS = (
    r"@{}r>{\centering\arraybackslash}m{0.44\linewidth}"
    r">{\raggedright\arraybackslash}m{0.44\linewidth}@{}"
)


@frozen
class Compared:
    """A mechanism of the table, with its scheme if it has one."""

    compiled: Compiled
    scheme: Drawing | None


def to_table(mechanisms: Sequence[Compared], language: str, fragment: bool) -> str:
    """Return a table in a language, as a document or to be put into one."""
    locale = registry.locale(language)
    body = "\n".join(_table(mechanisms, locale, language)) + "\n"
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
        yield f"{number} &"
        yield from _scheme(compared, language)
        yield "&"
        yield from _formulas(compared.compiled, locale, language)
        yield r"\\"
    yield r"\bottomrule"
    yield r"\end{longtable}"


def _style(compiled: Compiled, language: str) -> Notation:
    return style_of(compiled.mechanism, compiled.derivation.results, notation(language))


def _scheme(compared: Compared, language: str) -> Iterator[str]:
    mechanism = compared.compiled.mechanism
    if compared.scheme is not None:
        yield r"\resizebox{\linewidth}{!}{%"
        yield from tikzpicture(compared.scheme)
        yield r"}\par\smallskip"
    title = translated(mechanism.title or mechanism.name, _style(compared.compiled, language))
    yield rf"{{\small {title}\par}}"


def _formulas(compiled: Compiled, locale: Locale, language: str) -> Iterator[str]:
    """Yield what was asked for as displays, each with what its names stand for."""
    style = _style(compiled, language)
    for section in outline(compiled.derivation, compiled.mechanism).results:
        yield from section_block(section, locale, style).displays
