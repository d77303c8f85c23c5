"""``mechc check``: mistakes found, expectations proved or refuted, the second opinion."""

from collections.abc import Iterable, Iterator

import click

from ..diagnostics import MechcError
from ..driver import Compilation, complete, warnings
from ..formula.to_text import text
from ..formula.tree import Number
from ..formula.walk import evaluate, symbols
from ..model.mechanism import GRAVITY, Parameter
from ..model.result import Definition
from ..report.definitions import Letters, Solved, as_written, grouped, letters
from ..report.languages.en import LOCALE
from ..report.note import own_lines
from ..report.sections import Shown, in_short
from ..report.sentences.locking import friction_remarks
from ..report.sentences.remarks import own_conditions, reaction
from ..report.text.note import in_brief, in_language
from ..report.text.overview import overview
from ..report.text.speller import speller
from ..report.text.verdict import to_text
from ..source import Source
from ..statics.verdict import Verdict
from ..study.analysis import Analysis
from ..study.expectations import Finding
from ..study.ranges import scale_of
from ..syntax.settings import Settings
from ..units import in_unit
from .inputs import expanded, settings_option, stdin_option
from .open import begin
from .session import Repeatable, session, session_options, status
from .terminal import say
from .words import descriptions


@click.command("check", cls=Repeatable)
@click.argument(
    "files", nargs=-1, required=True, metavar="FILE|FOLDER|NAME|-...", shell_complete=descriptions
)
@click.option("-v", "--verbose", is_flag=True, help="Show what is given, and every pose.")
@click.option("-q", "--quiet", is_flag=True, help="Print errors and warnings only.")
@settings_option
@stdin_option
@session_options
def command(
    files: tuple[str, ...], verbose: bool, quiet: bool, settings: Settings, stdin_name: str
) -> None:
    """Find mistakes; prove or refute expectations.

    Every `expect` is proved by algebra, or refuted by a pose with both numbers. Every
    result is compared with the equilibrium of the free bodies at several poses. A folder
    stands for all descriptions below it, hidden folders left out. --verbose lists points,
    parameters and vectors, of a wrong description too: what has no value, place or direction.

    \b
    mechc check clamp.mech
    mechc check --verbose toggle_press
    mechc check --format concise drawings/
    """
    worst = 0
    for file in list(expanded(files)):
        compilation: Compilation | None = None
        try:
            compilation = begin(file, stdin_name, settings)
            complete(compilation)
        except MechcError as error:
            session().show(error.diagnostics, error.source)
            worst = max(worst, status(error.diagnostics))
            for line in _overview(compilation) if compilation and verbose else ():
                say(line)
            continue
        session().show(warnings(compilation), compilation.source)
        if session().werror and warnings(compilation):
            worst = max(worst, 1)
        for line in () if quiet else report(compilation, verbose):
            say(line)
    click.get_current_context().exit(worst)


def _overview(compilation: Compilation) -> Iterator[str]:
    """Yield what a description gives, as far as the stages that have run found it."""
    made = vars(compilation)
    if mechanism := made.get("mechanism"):
        yield f"{compilation.source.name}: {mechanism.name}"
        yield from overview(mechanism, made.get("pose"), compilation.source)


def report(compilation: Compilation, verbose: bool) -> Iterator[str]:
    """Yield what is known of a sound description, line by line."""
    spell = speller(compilation.derivation.results, compilation.mechanism, unicode=False)
    if verbose:
        yield from _overview(compilation)
    else:
        yield f"{compilation.source.name}: {compilation.mechanism.name}"
    if compilation.calculation:
        yield from in_brief(compilation.mechanism, compilation.results)
        yield from _of_findings(compilation)
        return
    earlier, given = Shown(), {r.name for r in compilation.results if _is_given(r)}
    known = letters(compilation.mechanism, compilation.results)
    own = own_lines(compilation.mechanism, compilation.results)
    before: Analysis | None = None
    for result in compilation.results:
        where = [d for d in earlier.of(result) if d.name not in given]
        formulas = [d.formula for d in where] + ([] if result.name in own else [result.formula])
        literals = [*earlier.new_literals(formulas, compilation.mechanism)]
        shown = in_short(result, compilation.results)
        unit = scale_of(result, compilation.mechanism)
        formula = in_language(own[result.name]) if result.name in own else text(shown.formula)
        yield from _of_result(shown, formula, where, literals, known, before, unit)
        before = result
        yield from (f"    {line}" for line in friction_remarks(result, LOCALE, spell))
    yield from _of_findings(compilation)
    yield from _of_verdict(compilation.verdict, verbose)


def _is_given(result: Analysis) -> bool:
    """Return whether the description gives a value, such as a load's, and nothing was found."""
    return result.target is None and isinstance(result.formula, Number)


def _of_result(
    result: Analysis,
    formula: str,
    where: Iterable[Definition],
    literals: Iterable[Parameter],
    known: Letters,
    before: Analysis | None,
    unit: str,
) -> Iterator[str]:
    """Yield what is known of a result, without what the one before has just shown."""
    if _is_given(result) and result.default is not None:
        yield f"  {result.name} = {in_unit(result.default, unit, 9)}"
        return
    yield f"  {result.name} = {formula}"
    for literal in literals:
        assert literal.value
        yield f"    where {literal.name} = {in_unit(evaluate(literal.value, {}), literal.unit, 6)}"
    for group in grouped(as_written(where, known)):
        yield from _of_definition(group, known)
    sizes = _sizes(result)
    if sizes and not (before and sizes == _sizes(before)):
        press = "press the joints" if len(sizes) > 1 else "presses the joint"
        yield f"    where {', '.join(sizes)} {press}: n = |r + D*n| by Newton's method"
    if result.default is not None:
        yield f"    = {in_unit(result.default, unit, 9)} at the default pose"
    elif result.undetermined:
        yield f"    {LOCALE.undetermined} (0/0) at the default pose"
    held = own_conditions(result)
    if held and not (before and reaction(before) and held == own_conditions(before)):
        holds = (f"{text(h.left)} {h.operator} {text(h.right)}" for h in held)
        yield f"    holds while {', '.join(holds)}"
    if result.independent:
        yield f"    does not depend on {', '.join(result.independent)}"


def _sizes(result: Analysis) -> list[str]:
    """Return the pressing forces that a result is made of."""
    return sorted(symbols(result.formula) & result.inside)


def _of_definition(group: Definition | Solved, known: Letters) -> Iterator[str]:
    if isinstance(group, Solved):
        yield f"    where {', '.join(group.names)} solve"
        yield from (f"      {text(zero)} = 0" for zero in group.zeros)
        return
    if group.name in known.units and isinstance(group.formula, Number):
        yield f"    where {group.name} = {float(group.formula.value):.9g} {known.units[group.name]}"
        return
    g = f", g = {float(GRAVITY.value)} m/s^2" if group.name in known.usual else ""
    yield f"    where {group.name} = {text(group.formula)}{g}"


def _of_findings(compilation: Compilation) -> Iterator[str]:
    """Yield what every expectation came to."""
    results = {result.name: result for result in compilation.found}
    for finding in compilation.findings:
        unit = scale_of(results[finding.expect.subject], compilation.mechanism)
        yield f"  {_of_finding(finding, unit, compilation.source)}"


def _of_finding(finding: Finding, unit: str, source: Source) -> str:
    written = " ".join(source.written(finding.expect.span).split()).removeprefix("expect ")
    if finding.outcome == "proved":
        return f"expect {written}: proved"
    return f"expect {written}: agrees ({in_unit(finding.found, unit, 9)})"


def _of_verdict(verdict: Verdict, verbose: bool) -> Iterator[str]:
    if verbose:
        yield from (f"  {line}" for line in to_text(verdict).splitlines())
        return
    number = len(verdict.trials)
    yield f"  equilibrium of the free bodies agrees in {number} trials"
    yield from (f"    {remark}" for remark in verdict.remarks)
