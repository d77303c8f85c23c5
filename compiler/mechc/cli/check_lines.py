"""What ``mechc check`` prints of a description, line by line, in each language."""

import math
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..compilation import Compilation
from ..diagnostics import Diagnostic, Severity
from ..formula.evaluate import evaluate
from ..formula.rewriting import plus_first
from ..formula.to_text import text, text_in_degrees
from ..formula.tree import ZERO, Constant, Formula, Number
from ..model.mechanism import (
    GRAVITY,
    LoadForm,
    LoadRatio,
    Mechanism,
    Parameter,
    SpeedRatio,
    WithFriction,
)
from ..model.result import Definition, Result
from ..report import directions
from ..report.definitions import (
    NameLetters,
    SolvedSystem,
    as_written,
    grouped,
    letters,
    looked_up,
    plus_condition,
    without_minus,
)
from ..report.note import NoteLine, own_lines
from ..report.readable import readable_results
from ..report.sections import ShownNames, in_short, is_idle_direction
from ..report.sentences.locking import friction_remarks
from ..report.sentences.remarks import (
    is_direction,
    kind,
    own_conditions,
    reaction,
    says_what_drives,
)
from ..report.text import note, overview
from ..report.text.character_sets import WRITTEN, tens
from ..report.text.speller import TextSpeller, speller
from ..report.text.verdict import agreement, said, trials, untried
from ..source import Source
from ..statics.verdict import Verdict
from ..study.analysis import Analysis
from ..study.expectations import Finding
from ..study.variables import scale_of

if TYPE_CHECKING:
    from ..calculation.calculation import Calculation

FAILS: Final = "E550"
"""The code of a condition of a sheet that fails."""


def overview_of(compilation: Compilation, language: str) -> Iterator[str]:
    """Yield the lines on a description, as far as the stages went."""
    if described := Compilation.described.kept(compilation):
        mechanism = described.moved
        spell = speller((), mechanism, unicode=False, language=language)
        yield f"{compilation.source.name}: {mechanism.name}"
        yield from overview.overview(
            mechanism, Compilation.pose.kept(compilation), compilation.source, spell
        )


def failing(
    compilation: Compilation, found: Iterable[Diagnostic], language: str, width: int
) -> Iterator[str]:
    """Yield the lines on a sheet in which nothing is wrong but conditions that fail."""
    if calculation := refused(compilation, found):
        mechanism, results = calculation.pose.mechanism, calculation.results
        yield f"{compilation.source.name}: {mechanism.name}"
        yield from note.in_brief(mechanism, results, _speller(mechanism, results, language, width))


def refused(compilation: Compilation, found: Iterable[Diagnostic]) -> "Calculation | None":
    """Return the calculation of a sheet that was refused for conditions that fail, and no more."""
    errors = {each.code for each in found if each.severity is Severity.ERROR}
    calculated = Compilation.calculated.kept(compilation)
    return calculated if errors == {FAILS} else None


def report(
    compilation: Compilation, verbose: bool, language: str = "en", width: int = sys.maxsize
) -> Iterator[str]:
    """Yield the lines on a sound description; those wider than ``width`` are broken."""
    spell = _speller(compilation.mechanism, compilation.results, language, width)
    if verbose:
        yield from overview_of(compilation, language)
    else:
        yield f"{compilation.source.name}: {compilation.mechanism.name}"
    for line in _of_results(compilation, spell):
        yield from spell.broken(line, "")
    if not compilation.calculation:
        yield from _of_verdict(compilation.verdict, spell, verbose)
    for prefix, used in compilation.used_mechanisms:
        yield from _of_used(prefix, used, spell, verbose)


def _of_used(prefix: str, used: Compilation, spell: TextSpeller, verbose: bool) -> Iterator[str]:
    """Yield the lines on a mechanism that a sheet uses: what it comes to, and whether that agrees.

    Its formulas stand in the calculation, under the prefix.
    """
    yield f"  {spell.locale.checked['used'].format(prefix=prefix, name=used.mechanism.name)}"
    for result in used.results:
        if result.default is not None and _is_ratio(result):
            value = _measured(result.default, scale_of(result, used.mechanism), spell)
            yield f"    {result.name} = {value}"
    yield from (f"  {line}" for line in _of_verdict(used.verdict, spell, verbose))


def _is_ratio(result: Analysis) -> bool:
    """Return whether forces or speeds are compared, with friction or without it."""
    target = result.target
    asked = target.of if isinstance(target, WithFriction) else target
    return isinstance(asked, LoadRatio | SpeedRatio | LoadForm)


def _speller(
    mechanism: Mechanism, results: Iterable[Result], language: str, width: int
) -> TextSpeller:
    """Return the speller of sentences; formulas are written as in descriptions."""
    spell = speller(results, mechanism, False, language, width)
    return spell._replace(signs=replace(spell.signs, functions={}, choices=WRITTEN))


def _of_results(compilation: Compilation, spell: TextSpeller) -> Iterator[str]:
    """Yield the lines on each result, and on the outcome of every expectation."""
    if compilation.calculation:
        yield from note.in_brief(compilation.mechanism, compilation.results, spell)
        yield from _of_findings(compilation, spell)
        return
    results = [r for r in _with_directions(compilation) if not is_idle_direction(r)]
    known = letters(compilation.mechanism, results)
    before: Analysis | None = None
    for result, entry in zip(results, _entries(compilation, results, spell), strict=True):
        yield from _of_result(entry, before, known, spell)
        before = result
        remarks = friction_remarks(result, spell.locale, spell)
        yield from (f"    {spell.units(line)}" for line in remarks)
    yield from _of_findings(compilation, spell)


def _with_directions(compilation: Compilation) -> Sequence[Analysis]:
    """Return the results as pages have them, with names for directions.

    Loops alone make long sums of these.
    """
    results, pose = compilation.results, compilation.pose
    results = readable_results(compilation.plan, results)
    if not pose.closing:
        return results
    return directions.in_results(results, directions.directions(results, pose))


class _Entry(NamedTuple):
    """A result as it is printed, and what it rests on as far as no entry before has shown it."""

    result: Analysis
    formula: str
    unit: str
    where: Sequence[Definition]
    literals: Sequence[Parameter]
    looked_up: Sequence[Parameter]


def _entries(
    compilation: Compilation, results: Sequence[Analysis], spell: TextSpeller
) -> Iterator[_Entry]:
    """Yield the entries of all results."""
    mechanism = compilation.mechanism
    earlier, own = ShownNames(), own_lines(mechanism, results)
    given = {result.name for result in results if _is_given(result)}
    for result in results:
        fresh = earlier.of(result)
        read_up = [q for q in looked_up(mechanism) if q.name in {d.name for d in fresh}]
        where = [d for d in fresh if d.name not in given | {q.name for q in read_up}]
        formulas = [d.formula for d in where] + ([] if result.name in own else [result.formula])
        literals = [*earlier.new_literals(formulas, mechanism)]
        shown = in_short(result, results)
        written = own.get(result.name)
        formula = _in_language(written, spell) if written else _described(shown.formula, spell)
        yield _Entry(shown, formula, scale_of(result, mechanism), where, literals, read_up)


def _in_language(line: NoteLine, spell: TextSpeller) -> str:
    """Return a user-defined formula as a description has it, and its text as readers have it."""
    assert line.formula
    inner = text(line.formula)
    match line.kind:
        case "table":
            said = f"{line.of} at {inner}"
        case "row":
            said = f"{line.of} at exactly {inner}"
        case "list":
            said = f"next {inner} in {line.of}"
        case "":
            said = inner
    said = spell.as_described(said)
    return f"{said}  # {spell.text(line.label)}" if line.label else said


def _described(formula: Formula, spell: TextSpeller) -> str:
    """Return a formula in the notation of descriptions, constant angles in degrees."""
    return spell.as_described(text_in_degrees(plus_first(formula)))


def _is_given(result: Analysis) -> bool:
    """Return whether the description gives a value, such as a load's, and nothing was found."""
    return result.target is None and isinstance(result.formula, Number)


def _of_result(
    entry: _Entry, before: Analysis | None, known: NameLetters, spell: TextSpeller
) -> Iterator[str]:
    """Yield the lines on a result, without those that the one before has just shown."""
    words, result = spell.locale.checked, entry.result
    if _is_given(result) and result.default is not None:
        yield f"  {result.name} = {_measured(result.default, entry.unit, spell)}"
        return
    yield f"  {result.name} = {entry.formula}"
    yield from _of_literals(entry.literals, spell)
    yield from (_where(note.as_given(quantity, spell), spell) for quantity in entry.looked_up)
    for group in grouped(as_written(entry.where, known)):
        yield from _of_definition(group, known, spell)
    yield from _of_iterated(result, before, words)
    if says_what_drives(result):
        yield f"    {kind(result, spell.locale, spell)}."
    if result.default is not None and result.formula != ZERO:
        value = _measured(result.default, entry.unit, spell)
        yield f"    = {words['default'].format(value=value)}"
    elif len(result.sides) > 1:
        yield f"    {words['default'].format(value=_jump(result.sides, entry.unit, spell))}"
    elif result.undetermined:
        no_value = f"{spell.locale.undetermined} (0/0)"
        said = spell.locale.no_direction if is_direction(result) else no_value
        yield f"    {words['default'].format(value=said)}"
    yield from _of_conditions(result, before, spell)
    if result.independent:
        yield f"    {words['independent'].format(names=', '.join(result.independent))}"


def _jump(sides: Sequence[float], unit: str, spell: TextSpeller) -> str:
    """Return between what a result jumps, or that it is undetermined where a side has no value."""
    if any(map(math.isnan, sides)):
        return spell.locale.undetermined
    low, high = (_measured(side, unit, spell) for side in sides)
    return spell.locale.checked["jumps"].format(low=low, high=high)


def _of_literals(literals: Iterable[Parameter], spell: TextSpeller) -> Iterator[str]:
    for literal in literals:
        assert literal.value
        value = spell.measured(evaluate(literal.value, {}), literal.unit, 6)
        yield _where(f"{literal.name} = {value}", spell)


def _of_iterated(
    result: Analysis, before: Analysis | None, words: Mapping[str, str]
) -> Iterator[str]:
    """Yield by what equation the normal forces are found that a result is made of."""
    names = sorted(result.iterated)
    if names and not (before and result.iterated == before.iterated):
        found = words["press" if len(names) > 1 else "presses"]
        yield f"    {found.format(names=', '.join(names), equation='n = |r + D*n|')}"


def _of_conditions(result: Analysis, before: Analysis | None, spell: TextSpeller) -> Iterator[str]:
    held = own_conditions(result)
    if held and not (before and reaction(before) and held == own_conditions(before)):
        each = [
            f"{_described(h.left, spell)} {h.operator} {_described(h.right, spell)}"
            for h in map(plus_condition, held)
        ]
        yield f"    {spell.locale.checked['holds'].format(conditions=', '.join(each))}"


def _measured(value: float, unit: str, spell: TextSpeller) -> str:
    return spell.measured(value, unit, 9)


def _where(formula: str, spell: TextSpeller) -> str:
    return f"    {spell.locale.checked['where'].format(formula=formula)}"


def _of_definition(
    group: Definition | SolvedSystem, known: NameLetters, spell: TextSpeller
) -> Iterator[str]:
    """Yield the lines below a result that define a name: a formula, a number, or a system."""
    if isinstance(group, SolvedSystem):
        yield f"    {spell.locale.checked['solve'].format(names=', '.join(group.names))}"
        both = ([_described(side, spell) for side in without_minus(zero)] for zero in group.zeros)
        yield from (f"      {' = '.join(sides)}" for sides in both)
        return
    if group.name in known.units and isinstance(group.formula, Number | Constant):
        figures = tens(f"{evaluate(group.formula, {}):.9g}", spell.signs)
        value = f"{spell.decimals(figures)} {spell.unit(known.units[group.name])}"
        yield _where(f"{group.name} = {value}", spell)
        return
    g = spell.units(f", g = {float(GRAVITY.value)} m/s^2") if group.name in known.usual else ""
    yield _where(f"{group.name} = {_described(group.formula, spell)}{g}", spell)


def _of_findings(compilation: Compilation, spell: TextSpeller) -> Iterator[str]:
    """Yield a line on the outcome of every expectation."""
    results = {result.name: result for result in compilation.found}
    for finding in compilation.findings:
        unit = scale_of(results[finding.expect.subject], compilation.mechanism)
        yield f"  {_of_finding(finding, unit, compilation.source, spell)}"


def _of_finding(finding: Finding, unit: str, source: Source, spell: TextSpeller) -> str:
    written = " ".join(source.written(finding.expect.span).split()).removeprefix("expect ")
    words, written = spell.locale.checked, spell.as_described(written)
    if finding.outcome == "proved":
        return words["proved"].format(formula=written)
    return words["agrees"].format(formula=written, value=_measured(finding.found, unit, spell))


def _of_verdict(verdict: Verdict, spell: TextSpeller, verbose: bool) -> Iterator[str]:
    """Yield the lines on the second opinion; the rows of its table are not broken."""
    words = spell.locale.checked
    if verbose:
        yield from (f"  {spell.decimals(row)}" for row in trials(verdict, words))
        lines = [f"  {spell.decimals(line)}" for line in said(verdict, words)]
    else:
        lines = [f"  {agreement(verdict, words)}"]
        lines += (f"    {remark}" for remark in untried(verdict.remarks, words))
    yield from (part for line in lines for part in spell.broken(line, ""))
