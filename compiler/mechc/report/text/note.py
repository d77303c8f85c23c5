"""The calculation note of a sheet for the terminal."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from ...formula.choices import is_choice
from ...formula.layout import is_angle
from ...formula.tree import Formula
from ...formula.walk import evaluate
from ...frozen import replace
from ...model.mechanism import Mechanism, Parameter
from ...model.result import Result
from ...units import ANGLE, described, in_unit, si_unit
from ..note import Note, NoteCheck, NoteLine, note
from .printer import ASCII, UNICODE, Signs, print_formula, print_name

SHOWN = 6
"""Significant digits of what a formula comes to."""


class Row(NamedTuple):
    """What is said of a quantity, and the text of it."""

    said: str
    label: str = ""


def render(mechanism: Mechanism, results: Sequence[Result], unicode: bool) -> str:
    """Return the whole note: what is given, the formulas with their numbers, the checks."""
    found, signs = note(mechanism, results), _signs(mechanism, unicode)
    parts = [
        [mechanism.title or mechanism.name, *filter(None, [mechanism.source])],
        _headed("Given", [_given(p, signs) for p in mechanism.parameters]),
        _headed("Tables and lists of sizes", [*_tables(found, signs)]),
        _headed("Calculation", [_line(line, signs, in_numbers=True) for line in found.lines]),
        _headed("Checks", [_check(check, signs) for check in found.checks]),
    ]
    return "\n".join("".join(f"{line}\n" for line in part) for part in parts if part)


def in_brief(mechanism: Mechanism, results: Sequence[Result]) -> Iterator[str]:
    """Yield what each formula comes to, and the checks, in characters that every terminal has."""
    found, signs = note(mechanism, results), _signs(mechanism, unicode=False)
    yield from _aligned([_line(line, signs, in_numbers=False) for line in found.lines])
    yield from _aligned([_check(check, signs) for check in found.checks])


def _signs(mechanism: Mechanism, unicode: bool) -> Signs:
    angles = {p.name for p in mechanism.parameters if p.dimension == ANGLE}
    angles |= {let.name for let in mechanism.lets if let.dimension == ANGLE}
    return replace(UNICODE if unicode else ASCII, angles=frozenset(angles))


def _headed(heading: str, rows: Sequence[Row]) -> list[str]:
    return [heading, *_aligned(rows)] if rows else []


def _aligned(rows: Sequence[Row]) -> Iterator[str]:
    """Yield rows with their texts behind them, those of short rows in one column."""
    width = max((len(row.said) for row in rows if len(row.said) <= 48), default=0)
    for row in rows:
        yield f"  {row.said:{width}}  {row.label}".rstrip()


def _given(parameter: Parameter, signs: Signs) -> Row:
    unit = parameter.unit or si_unit(parameter.dimension)
    if parameter.value is None:
        said = f"{described(parameter.dimension)} without a value"
    elif parameter.dependent:
        said = print_formula(parameter.value, signs, parameter.name in signs.angles)
    else:
        said = in_unit(evaluate(parameter.value, {}), unit, SHOWN)
    if parameter.range:
        ends = (in_unit(evaluate(end, {}), unit, SHOWN) for end in parameter.range)
        said += f" in {' .. '.join(ends)}"
    return Row(f"{print_name(parameter.name, signs)} = {said}", parameter.label)


def _tables(found: Note, signs: Signs) -> Iterator[Row]:
    for table in found.tables:
        rows = (": ".join(_set(cell, signs) for cell in row) for row in table.rows)
        yield Row(f"{table.name} = {', '.join(rows)}", table.source)


def _set(formula: Formula, signs: Signs) -> str:
    return print_formula(formula, signs, is_angle(formula, signs.angles))


def _line(line: NoteLine, signs: Signs, in_numbers: bool) -> Row:
    """Return a formula, the numbers put in if they are wanted, and what it comes to."""
    sides = [_asked(line, line.formula, signs)] if line.formula else []
    if in_numbers and line.numbers:
        sides.append(_asked(line, line.numbers, signs))
    constant = not line.of and line.numbers is None and line.is_number
    if line.value and not constant:
        sides.append(line.value.text(SHOWN))
    decides = f" ({_set(line.decides, signs)} decides)" if line.decides else ""
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


def _check(check: NoteCheck, signs: Signs) -> Row:
    operator = f" {signs.relations.get(check.operator, check.operator)} "
    said = operator.join(_set(side, signs) for side in (check.left, check.right))
    if check.values is None:
        return Row(f"{said}: not known", check.label)
    said += f": {operator.join(side.text(SHOWN) for side in check.values)}"
    if check.reserve is not None:
        said += f", reserve {check.reserve:.3g}{', the least' if check.decides else ''}"
    return Row(said, check.label)
