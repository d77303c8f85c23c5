"""The calculation note of a sheet for the terminal."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from ...formula.choices import is_choice
from ...formula.layout import is_angle
from ...formula.tree import Formula
from ...formula.walk import evaluate
from ...frozen import replace
from ...model.mechanism import Mechanism, Parameter
from ...model.result import Result
from ...model.values import is_constant
from ...units import ANGLE, in_unit, si_unit
from ..languages.registry import locale
from ..note import Note, NoteCheck, NoteLine, note
from .printer import ASCII, Signs, print_formula, print_name
from .speller import SHOWN, Speller

Words = Mapping[str, str]
"""The words of notes in a language."""


class Row(NamedTuple):
    """What is said of a quantity, and the text of it."""

    said: str
    label: str = ""


def render(mechanism: Mechanism, results: Sequence[Result], spell: Speller) -> str:
    """Return the whole note: what is given, the formulas with their numbers, the checks."""
    found, signs = note(mechanism, results), _signs(mechanism, spell.signs)
    words = spell.locale.calculation
    title = mechanism.title or mechanism.name, mechanism.source
    parts = [
        [spell.text(text) for text in title if text],
        given(mechanism.parameters, spell),
        _headed(words["tables"], [*_tables(found, signs)], spell),
        _headed(words["lines"], [_line(one, signs, words, True) for one in found.lines], spell),
        _headed(words["checks"], [_check(check, signs, words) for check in found.checks], spell),
    ]
    return "\n".join("".join(f"{line}\n" for line in part) for part in parts if part)


def in_brief(mechanism: Mechanism, results: Sequence[Result]) -> Iterator[str]:
    """Yield what each formula comes to, and the checks, in characters that every terminal has."""
    found, signs = note(mechanism, results), _signs(mechanism, ASCII)
    words = locale("en").calculation
    yield from _aligned([_line(line, signs, words, in_numbers=False) for line in found.lines])
    yield from _aligned([_check(check, signs, words) for check in found.checks])


def _signs(mechanism: Mechanism, signs: Signs) -> Signs:
    angles = {p.name for p in mechanism.parameters if p.dimension == ANGLE}
    angles |= {let.name for let in mechanism.lets if let.dimension == ANGLE}
    return replace(signs, angles=frozenset(angles))


def _headed(heading: str, rows: Sequence[Row], spell: Speller) -> list[str]:
    """Return rows under a heading, in the language of the note."""
    translated = [Row(spell.units(row.said), spell.text(row.label)) for row in rows]
    return [heading, *_aligned(translated)] if rows else []


def _aligned(rows: Sequence[Row]) -> Iterator[str]:
    """Yield rows with their texts behind them, those of short rows in one column."""
    width = max((len(row.said) for row in rows if len(row.said) <= 48), default=0)
    for row in rows:
        yield f"  {row.said:{width}}  {row.label}".rstrip()


def given(parameters: Iterable[Parameter], spell: Speller) -> list[str]:
    """Return the given parameters under their heading: values, ranges, texts."""
    return _headed(spell.locale.given, [_given(p, spell) for p in parameters], spell)


def _given(parameter: Parameter, spell: Speller) -> Row:
    signs = spell.signs
    unit = parameter.unit or si_unit(parameter.dimension)
    if parameter.value is None:
        said = spell.locale.any_value
    elif parameter.dependent and not is_constant(parameter):
        said = print_formula(parameter.value, signs, parameter.name in signs.angles)
    else:
        said = in_unit(evaluate(parameter.value, {}), unit, SHOWN)
    if parameter.range:
        ends = (in_unit(evaluate(end, {}), unit, SHOWN) for end in parameter.range)
        said += f", {spell.locale.range.lower()} {' .. '.join(ends)}"
    said = said.replace(" deg", signs.degree).replace("-", signs.minus)
    return Row(f"{print_name(parameter.name, signs)} = {said}", parameter.label)


def _tables(found: Note, signs: Signs) -> Iterator[Row]:
    for table in found.tables:
        rows = (": ".join(_set(cell, signs) for cell in row) for row in table.rows)
        yield Row(f"{table.name} = {', '.join(rows)}", table.source)


def _set(formula: Formula, signs: Signs) -> str:
    return print_formula(formula, signs, is_angle(formula, signs.angles))


def _line(line: NoteLine, signs: Signs, words: Words, in_numbers: bool) -> Row:
    """Return a formula, the numbers put in if they are wanted, and what it comes to."""
    sides = [_asked(line, line.formula, signs)] if line.formula else []
    if in_numbers and line.numbers:
        sides.append(_asked(line, line.numbers, signs))
    constant = not line.of and line.numbers is None and line.is_number
    if line.value and not constant:
        sides.append(line.value.text(SHOWN))
    decides = (
        f" ({words['decides'].format(formula=_set(line.decides, signs))})" if line.decides else ""
    )
    return Row(f"{print_name(line.name, signs)} = {' = '.join(sides)}{decides}", line.label)


def _asked(line: NoteLine, formula: Formula, signs: Signs) -> str:
    """Return a formula, or what is asked of a table or list."""
    inner = print_formula(formula, signs, line.dimension == ANGLE and not line.of)
    match line.kind:
        case "table":
            return f"{line.of} at {inner}"
        case "list":
            return f"next {inner} in {line.of}"
        case "":
            return f"({inner})" if is_choice(formula) else inner


def _check(check: NoteCheck, signs: Signs, words: Words) -> Row:
    operator = f" {signs.relations.get(check.operator, check.operator)} "
    said = operator.join(_set(side, signs) for side in (check.left, check.right))
    if check.values is None:
        return Row(f"{said}: {words['unknown']}", check.label)
    said += f": {operator.join(side.text(SHOWN) for side in check.values)}"
    if check.reserve is not None:
        least = f", {words['least of all']}" if check.decides else ""
        said += f", {words['reserve'].lower()} {check.reserve:.3g}{least}"
    return Row(said, check.label)
