"""The calculation note of a sheet for the terminal."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...formula.choices import is_choice
from ...formula.evaluate import evaluate
from ...formula.layout import is_angle
from ...formula.tree import Formula
from ...model.mechanism import Mechanism, Parameter
from ...model.parts.written import WrittenFormula, WrittenTable
from ...model.result import Result
from ...model.values import is_constant
from ...units import ANGLE, in_unit, si_unit
from ..checks import NoteCheck
from ..digits import VALUE_DIGITS
from ..languages.locale import Words
from ..note import NoteLine, label, note
from ..put_in import GivenQuantity
from .character_sets import TextSigns, tens
from .printer import print_formula, print_name, print_quantity
from .speller import TextSpeller


class NoteRow(NamedTuple):
    """What is said of a quantity, and the text of it."""

    said: str
    label: str = ""


def render(mechanism: Mechanism, results: Sequence[Result], spell: TextSpeller) -> str:
    """Return the whole note: what is given, the formulas with their numbers, the checks."""
    found, signs = note(mechanism, results), _signs(mechanism, spell.signs)
    words = spell.locale.calculation
    title = mechanism.title or mechanism.name, mechanism.source
    parts = [
        [line for part in title if part for line in spell.wrapped(spell.text(part), "")],
        given(found.given, spell),
        tables(found.tables, spell),
        _headed(words["lines"], [_line(one, signs, spell, True) for one in found.lines], spell),
        spell.wrapped(_unused(found.unused, signs, words), "  "),
        _headed(words["checks"], [_check(check, signs, words) for check in found.checks], spell),
    ]
    return "\n".join("".join(f"{line}\n" for line in part) for part in parts if part)


def in_brief(mechanism: Mechanism, results: Sequence[Result], spell: TextSpeller) -> Iterator[str]:
    """Yield the value of each formula, and the checks; of used mechanisms their results alone."""
    found, signs = note(mechanism, results), _signs(mechanism, spell.signs)
    words = spell.locale.calculation
    said = (_without_the_way(line) for line in found.lines if line.result or not line.is_taken)
    lines = [_line(line, signs, spell, in_numbers=False) for line in said]
    yield from _aligned(lines, spell)
    yield from spell.wrapped(_unused(found.unused, signs, words), "  ")
    yield from _aligned([_check(check, signs, words) for check in found.checks], spell)


def _without_the_way(line: NoteLine) -> NoteLine:
    """Return the line of a mechanism's result as its value, if it has one; others as they are."""
    is_found = line.result and line.result.target and line.value
    return line._replace(formula=None) if is_found else line


def _signs(mechanism: Mechanism, signs: TextSigns) -> TextSigns:
    angles = mechanism.angles
    angles |= {let.name for let in mechanism.lets if let.dimension == ANGLE}
    return replace(signs, angles=frozenset(angles))


def _headed(heading: str, rows: Sequence[NoteRow], spell: TextSpeller) -> list[str]:
    """Return rows under a heading, in the language of the note."""
    return [heading, *_aligned(rows, spell)] if rows else []


def _translated(rows: Iterable[NoteRow], spell: TextSpeller) -> list[NoteRow]:
    """Return rows with units and texts in the language of the note."""
    return [NoteRow(spell.units(row.said), spell.text(row.label)) for row in rows]


def _aligned(rows: Iterable[NoteRow], spell: TextSpeller) -> Iterator[str]:
    """Yield rows with their texts behind them, those of short rows in one column.

    Where a line has no room for both, the text stands below.
    """
    shown = _translated(rows, spell)
    width = max((len(row.said) for row in shown if len(row.said) <= 48), default=0)
    for row in shown:
        lines = (f"  {row.said:{room}}  {row.label}".rstrip() for room in (width, 0))
        if line := next((line for line in lines if len(line) <= spell.width), ""):
            yield line
        else:
            yield from (*spell.broken(row.said, "  "), *spell.wrapped(row.label, " " * 6))


def given(
    parameters: Iterable[Parameter],
    spell: TextSpeller,
    angles: Iterable[str] = (),
    values: Mapping[str, Formula] = MappingProxyType({}),
) -> list[str]:
    """Return the given parameters under their heading, values, ranges, texts, and ``angles``.

    One that follows from others may have one of the ``values`` behind its formula.
    """
    rows = [*(_given(p, spell, values.get(p.name)) for p in parameters), *map(NoteRow, angles)]
    return _headed(spell.locale.given, rows, spell)


def _given(parameter: Parameter, spell: TextSpeller, value: Formula | None = None) -> NoteRow:
    """Return the row of a parameter, with its ``value`` behind the formula that it has."""
    said = _value_and_range(parameter, value, spell)
    texts = (spell.text(text) for text in (parameter.label, parameter.about) if text)
    return NoteRow(f"{print_name(parameter.name, spell.signs)} = {said}", "; ".join(texts))


def _value_and_range(parameter: Parameter, value: Formula | None, spell: TextSpeller) -> str:
    if parameter.value is None:
        said = spell.locale.any_value
    elif parameter.dependent and not is_constant(parameter):
        said = _formula_and_value(parameter, parameter.value, value, spell.signs)
    else:
        said = _constant(parameter, evaluate(parameter.value, {}), spell.signs)
    return f"{said}, {_range(parameter, spell)}" if parameter.range else said


def _formula_and_value(
    parameter: Parameter, formula: Formula, value: Formula | None, signs: TextSigns
) -> str:
    """Return the formula that a parameter follows from as it was written, then its value."""
    shown = parameter.written or WrittenFormula(formula)
    said = _asked(shown, shown.formula, signs, parameter.name in signs.angles)
    if value is None:
        return said
    known = in_unit(evaluate(value, {}), _unit_of_value(parameter), VALUE_DIGITS)
    return f"{said} = {print_quantity(known, signs)}"


def _constant(parameter: Parameter, size: float, signs: TextSigns) -> str:
    """Return a size in the unit of a parameter, radians with the degrees behind them."""
    unit = _own_unit(parameter)
    units = (unit, "deg") if unit == "rad" else (unit,)
    first, *others = (print_quantity(in_unit(size, u, VALUE_DIGITS), signs) for u in units)
    return " ".join((first, *(f"({other})" for other in others)))


def _range(parameter: Parameter, spell: TextSpeller) -> str:
    unit, between = _own_unit(parameter), " … " if spell.signs.fancy else " .. "
    ends = (in_unit(evaluate(end, {}), unit, VALUE_DIGITS) for end in parameter.range or ())
    return f"{spell.locale.range.lower()} {print_quantity(between.join(ends), spell.signs)}"


def _own_unit(parameter: Parameter) -> str:
    return parameter.unit or si_unit(parameter.dimension)


def _unit_of_value(parameter: Parameter) -> str:
    usual = "deg" if parameter.dimension == ANGLE else si_unit(parameter.dimension)
    return parameter.unit or usual


def as_given(parameter: Parameter, spell: TextSpeller) -> str:
    """Return the line of a parameter among what is given: ``b = next 2*a in sizes``."""
    return _given(parameter, spell).said


def _table(table: WrittenTable, signs: TextSigns) -> NoteRow:
    rows = (": ".join(_set(cell, signs) for cell in row) for row in table.rows)
    return NoteRow(f"{print_name(table.name, signs)} = {', '.join(rows)}", table.source)


def _set(formula: Formula, signs: TextSigns) -> str:
    return print_formula(formula, signs, is_angle(formula, signs.angles))


def formula_alone(line: NoteLine, spell: TextSpeller) -> str:
    """Return a user-defined formula as it is written."""
    return _line(line._replace(value=None), spell.signs, spell, in_numbers=False).said


def tables(shown: Iterable[WrittenTable], spell: TextSpeller) -> list[str]:
    """Return tables and lists of sizes, under their heading."""
    rows = [_table(table, spell.signs) for table in shown]
    return _headed(spell.locale.calculation["tables"], rows, spell)


def _unused(names: Sequence[str], signs: TextSigns, words: Words) -> str:
    """Return the sentence about what is not used of other sheets, '' where there is none."""
    said = ", ".join(print_name(name, signs) for name in names)
    return words["unused"].format(names=said) if names else ""


def _unknown(missing: Sequence[str], signs: TextSigns, words: Words) -> str:
    """Return that a condition has no numbers, and what it lacks."""
    names = ", ".join(print_name(name, signs) for name in missing)
    return words["missing"].format(names=names) if names else words["unknown"]


def _line(line: NoteLine, signs: TextSigns, spell: TextSpeller, in_numbers: bool) -> NoteRow:
    """Return a formula, the numbers put in if they are wanted, and its value."""
    angle, words = line.dimension == ANGLE, spell.locale.calculation
    sides = [_asked(line, line.formula, signs, angle)] if line.formula else []
    if in_numbers and line.numbers:
        sides.append(_asked(line, line.numbers, signs, angle))
    if in_numbers and line.between:
        sides.append(print_formula(line.between, signs, angle))
    constant = not line.of and line.numbers is None and line.is_number
    if line.value and not constant:
        sides.append(_value(line.value, signs))
    decides = ""
    if line.decides:
        decides = f" ({words['decides'].format(formula=_set(line.decides, signs))})"
    said = f"{print_name(line.name, signs)} = {' = '.join(sides)}{decides}"
    return NoteRow(said, label(line, spell.text(line.label), spell.locale, spell))


def _asked(line: NoteLine | WrittenFormula, formula: Formula, signs: TextSigns, angle: bool) -> str:
    """Return a formula, or what is asked of a table or list."""
    inner = print_formula(formula, signs, angle and not line.of)
    match line.kind:
        case "table" | "row" | "list":
            of = print_name(line.of, signs)
            return signs.choices[f"of {line.kind}"].format(name=of, asked=inner)
        case "":
            return f"({inner})" if is_choice(formula) else inner


def _value(quantity: GivenQuantity, signs: TextSigns) -> str:
    return print_quantity(quantity.text(VALUE_DIGITS), signs)


def _check(check: NoteCheck, signs: TextSigns, words: Words) -> NoteRow:
    """Return the line of a condition: in symbols and in numbers, its reserve, whether it fails."""
    operator = f" {signs.relations.get(check.operator, check.operator)} "
    said = operator.join(_set(side, signs) for side in (check.left, check.right))
    if check.values is None:
        return NoteRow(f"{said}: {_unknown(check.missing, signs, words)}", check.label)
    said += f": {operator.join(_value(side, signs) for side in check.values)}"
    if check.reserve is not None:
        least = f", {words['least of all']}" if check.decides else ""
        reserve = tens(f"{check.reserve:.3g}", signs)
        said += f", {words['reserve'].lower()} {reserve}{least}"
    return NoteRow(f"{said}, {words['fails']}" if check.fails else said, check.label)
