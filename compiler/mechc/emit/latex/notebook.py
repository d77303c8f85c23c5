"""Results and derivations as notebooks show them: Markdown with the mathematics of the report."""

import re
from collections.abc import Iterable, Iterator

from ...base.later import pattern
from ...model.statements import is_sheet
from ...report.languages import registry
from ...report.latex.document_style import style_of
from ...report.latex.notation import LatexNotation, notation
from ...report.latex.results import section_block
from ...report.latex.text import plain
from ...report.sections import outline
from ...report.steps import calculated
from ...study.analysis import Analysis
from ..render import render
from ..target import Compiled, Options
from .note import note_report
from .to_latex import TARGET, report

_LANGUAGE = "en"

_MATHEMATICS = pattern(r"(\$\$.*?\$\$|\$[^$]*\$)", re.DOTALL)
_PAPER = pattern(r"\\noindent |\\par\b")
"""What text has for a page alone."""


def results(compiled: Compiled, wanted: Iterable[Analysis]) -> str:
    """Return results with all that they rest on, each name defined once; of a sheet its note."""
    if is_sheet(compiled.mechanism):
        return derivation(compiled)
    return _markdown(results_in_latex(compiled, wanted))


def results_in_latex(compiled: Compiled, wanted: Iterable[Analysis]) -> str:
    """Return results as LaTeX, for what a notebook is printed by; of a sheet its note."""
    if is_sheet(compiled.mechanism):
        return derivation_in_latex(compiled)
    return "\n\n".join(_displays(compiled, tuple(wanted)))


def _displays(compiled: Compiled, wanted: tuple[Analysis, ...]) -> Iterator[str]:
    locale, style = registry.locale(_LANGUAGE), _style(compiled)
    shown = {result.name: result for result in compiled.reported.results}
    found = tuple(shown[result.name] for result in wanted)
    for section in outline(calculated(found), compiled.mechanism).results:
        yield from section_block(section, locale, style).displays


def derivation(compiled: Compiled) -> str:
    """Return the derivation, from the position to what follows from results; a sheet's note."""
    locale, style = registry.locale(_LANGUAGE), notation(_LANGUAGE)
    if is_sheet(compiled.mechanism):
        note = note_report(compiled, locale, style, fragment=True)
        return _markdown(render("latex/notebook_note.jinja", note))
    options = Options(compiled.mechanism.name, numbers=False)
    whole = report(compiled, compiled.reported, locale, _style(compiled), options)
    return _markdown(render("latex/notebook.jinja", whole))


def derivation_in_latex(compiled: Compiled) -> str:
    """Return the report without its preamble."""
    options = Options(compiled.mechanism.name, fragment=True, numbers=False)
    return TARGET.emit(compiled, options)[0].text


def _style(compiled: Compiled) -> LatexNotation:
    return style_of(compiled.mechanism, compiled.reported.results, notation(_LANGUAGE))


def _markdown(text: str) -> str:
    r"""Return LaTeX as Markdown: text as it was, displays with the signs that MathJax looks for.

    >>> print(_markdown(r"\[ k=1 \] and a line that ends in \\[2pt]"))
    $$ k=1 $$ and a line that ends in \\[2pt]
    """
    parts = _MATHEMATICS.split(re.sub(r"(?<!\\)\\[\[\]]", "$$", text))
    parts[::2] = (_PAPER.sub("", plain(part)) for part in parts[::2])
    return re.sub(r"\n{3,}", "\n\n", "".join(parts))
