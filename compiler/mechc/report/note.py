"""The calculation note of a sheet: each formula, the numbers put in, its value; the checks.

One content for the terminal and for typesetting. Formulas are as people wrote them, values in
the units in which they are given.
"""

import math
from collections.abc import Container, Iterator, Mapping, Sequence
from typing import Literal

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.choices import chosen, is_choice
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Constant, Formula, Implicit, Number, Product, Symbol, is_call
from ..formula.walk import constants, symbols, walk
from ..model.dependence import unused
from ..model.mechanism import Axial, Let, Mechanism, Normal, Parameter, Reaction, WithFriction
from ..model.parts.written import WrittenTable
from ..model.result import Result
from ..model.values import Chain, UsualUnits, default_pose, defaults, dependent, usual_units
from ..study.analysis import Analysis, as_printed
from ..syntax.vocabulary import split_quantity
from ..units import ANGLE, NUMBER, Dimension, si_unit
from .checks import NoteCheck, checks
from .digits import VALUE_DIGITS
from .languages.locale import Locale
from .put_in import (
    COMPUTED,
    FoundValue,
    GivenQuantity,
    WrittenTables,
    in_numbers,
    line_between,
    on_the_way,
    put_in,
    tables_of,
    values_of,
)
from .sentences.remarks import kind
from .sentences.speller import Speller, component_words


class NoteLine(NamedTuple):
    """A formula of a sheet, with the numbers put in, and its value."""

    name: str
    label: str
    kind: Literal["", "table", "row", "list"]
    of: str
    """The table or list in which the value is looked up."""

    formula: Formula | None
    """The formula, of a table or list the argument; None for what is found by iteration."""

    numbers: Formula | None
    """The formula with the numbers put in; None where nothing is put in."""

    value: GivenQuantity | None
    """The value; None where a parameter has none."""

    asked: GivenQuantity | None
    """The value of the argument of a table or list."""

    decides: Formula | None
    """The largest or smallest of several, where that is taken."""

    dimension: Dimension
    is_taken: bool = False
    """Whether it is of a mechanism that the sheet uses: a result, or a name on the way to one."""

    result: Analysis | None = None
    """The result of that mechanism, where it is one."""

    between: Formula | None = None
    """The straight line between two rows of a table."""

    source: str = ""
    """The source of the table."""

    has_no_direction: bool = False
    """Whether it is the direction of a force that is zero."""

    @property
    def is_number(self) -> bool:
        """Return whether the formula is a number alone, in the unit of its value: a constant."""
        if self.kind:
            return False
        match self.formula:
            case Number():
                return True
            case Constant(name) | Product((Number(-1), Constant(name))) if name[0].isdigit():
                return self.value is None or split_quantity(name)[1] in ("", self.value.unit)
            case _:
                return False


class Note(NamedTuple):
    """A calculation sheet as people read it, without what is ``unused`` of others."""

    given: tuple[Parameter, ...]
    tables: tuple[WrittenTable, ...]
    lines: tuple[NoteLine, ...]
    checks: tuple[NoteCheck, ...]
    unused: tuple[str, ...]


def note(mechanism: Mechanism, results: Sequence[Result]) -> Note:
    """Return the calculation note of a sheet, at the values that it gives."""
    units = {p.name: p.unit or si_unit(p.dimension) for p in mechanism.parameters}
    units |= {let.name: let.unit or si_unit(let.dimension) for let in mechanism.lets}
    units |= {t.name: t.unit or si_unit(t.dimension) for t in mechanism.taken}
    values = {**default_pose(mechanism)}
    values |= {r.name: r.default for r in results if r.default is not None}
    given = {name: GivenQuantity(value, units[name]) for name, value in values.items()}
    aside = unused(mechanism, results)
    lines = _lines(mechanism, results, given, aside)
    return Note(
        tuple(p for p in mechanism.parameters if p.name not in aside),
        tuple(t for t in tables_of(mechanism).values() if t.name not in aside),
        tuple(line for line in lines if line.name not in aside),
        tuple(checks(mechanism, results, given)),
        aside,
    )


def own_lines(mechanism: Mechanism, results: Sequence[Result]) -> Mapping[str, NoteLine]:
    """Return the formulas of the user's own in a mechanism, by their names."""
    quantities: tuple[Parameter | Let, ...]
    quantities = (*mechanism.parameters, *mechanism.literals, *mechanism.lets)
    units = {q.name: q.unit or UsualUnits().of(q.dimension) for q in quantities}
    usual = usual_units(mechanism)
    units |= {r.name: usual.of(r.dimension) for r in results if r.target is not None}
    where = {d.name: d.formula for r in results for d in r.where}
    units = {name: _unit_by_name(name, usual.length) for name in where} | units
    chain = Chain({**where, **dependent(mechanism)})
    values = chain.complete(defaults(mechanism))
    values |= {p.name: evaluate(p.value, {}) for p in mechanism.literals if p.value}
    values |= {r.name: r.default for r in results if r.default is not None}
    known = {name for name, value in values.items() if math.isfinite(value)}
    given = {
        name: GivenQuantity(values[name], unit) for name, unit in units.items() if name in known
    }
    shown = {result.name for result in results if result.target is None}
    tables = tables_of(mechanism)
    return {let.name: _line(let, given, tables) for let in mechanism.lets if let.name in shown}


def _unit_by_name(name: str, lengths: str) -> str:
    """Return the unit of what a loop gives, '' where its name does not show it."""
    if name.startswith("phi_"):
        return "deg"
    return lengths if name.startswith("len_") else ""


def _lines(
    mechanism: Mechanism,
    results: Sequence[Result],
    given: Mapping[str, GivenQuantity],
    aside: Container[str],
) -> Iterator[NoteLine]:
    """Yield the formulas in the order of the text, results of used mechanisms among them.

    Of results that are left ``aside`` nothing that they rest on is mentioned.
    """
    named = {result.name: as_printed(result) for result in results}
    literals = {known.name: known for known in mechanism.literals}
    numbers = {name: _quantity(known) for name, known in literals.items()}
    tables = tables_of(mechanism)
    shown, done = set(given), 0
    for known in mechanism.taken:
        yield from (_line(let, given, tables) for let in mechanism.lets[done : known.before])
        done = known.before
        if known.name in aside:
            continue
        result = named[known.name]
        is_bare = _is_iterated(result) or isinstance(result.formula, Number)  # a number in SI
        formula = None if is_bare else result.formula
        values = _on_the_way(result, mechanism, given) if formula else {}
        near = {**{name: found.value for name, found in values.items()}, **numbers, **given}
        mentioned = _mentioned(result, literals, values, shown) if formula else ()
        yield from (_with_numbers(line, near) for line in mentioned)
        said = known.label if result.target or result.label else ""
        line = _plain(known.name, said, formula, given.get(known.name), known.dimension)
        idle = formula is not None and _is_of_zero(formula, values_of(near))
        yield _with_numbers(line, near)._replace(result=result, has_no_direction=idle)
    yield from (_line(let, given, tables) for let in mechanism.lets[done:])


def _is_of_zero(formula: Formula, values: Mapping[str, float]) -> bool:
    """Return whether a formula is the direction of a vector whose components are zero."""
    return (
        isinstance(formula, Call)
        and formula.function == "atan2"
        and symbols(formula) <= values.keys()
        and not any(evaluate(part, values) for part in formula.arguments)
    )


def _is_iterated(result: Result) -> bool:
    return any(isinstance(part, Implicit) for f in _formulas(result) for part in walk(f))


def _mentioned(
    result: Result,
    literals: Mapping[str, Parameter],
    found: Mapping[str, FoundValue],
    shown: set[str],
) -> Iterator[NoteLine]:
    """Yield the numbers and the definitions that a formula mentions, each once in a note."""
    lines = [_number(literals[c.name]) for c in constants(_formulas(result))]
    lines += [
        _number(literals[name])
        if name in literals
        else _plain(name, "", formula, *found.get(name, (None, NUMBER)))
        for name, formula in result.where
    ]
    for line in lines:
        if line.name not in shown:
            shown.add(line.name)
            yield line


def _on_the_way(
    result: Analysis, mechanism: Mechanism, given: Mapping[str, GivenQuantity]
) -> Mapping[str, FoundValue]:
    """Return the values of what a result rests on."""
    numbers = {p.name: evaluate(p.value, {}) for p in mechanism.literals if p.value}
    values = values_of(given) | numbers
    dimensions = {p.name: p.dimension for p in (*mechanism.parameters, *mechanism.literals)}
    dimensions |= {let.name: let.dimension for let in mechanism.lets}
    dimensions |= {taken.name: taken.dimension for taken in mechanism.taken}
    return on_the_way(result, values, dimensions, usual_units(mechanism))


def _number(known: Parameter) -> NoteLine:
    """Return a number of a mechanism under its name."""
    return _plain(known.name, "", None, _quantity(known), known.dimension)


def _quantity(known: Parameter) -> GivenQuantity:
    assert known.value
    unit = "deg" if known.dimension == ANGLE else known.unit or si_unit(known.dimension)
    return GivenQuantity(evaluate(known.value, {}), unit)


def _formulas(result: Result) -> list[Formula]:
    return [result.formula, *(d.formula for d in result.where)]


def _plain(
    name: str,
    label: str,
    formula: Formula | None,
    value: GivenQuantity | None,
    dimension: Dimension,
) -> NoteLine:
    """Return a line of a used mechanism, without the numbers put in."""
    return NoteLine(
        name=name,
        label=label,
        kind="",
        of="",
        formula=formula,
        numbers=None,
        value=value,
        asked=None,
        decides=None,
        dimension=dimension,
        is_taken=True,
    )


def _with_numbers(line: NoteLine, given: Mapping[str, GivenQuantity]) -> NoteLine:
    """Return a line of a used mechanism with the numbers put in, if a person would do so."""
    bare = line.dimension in (ANGLE, NUMBER)
    known = line.formula if line.value else None
    return line._replace(numbers=in_numbers(known, given, bare) if known else None)


def _line(let: Let, given: Mapping[str, GivenQuantity], tables: WrittenTables) -> NoteLine:
    """Return a formula of a sheet with the numbers put in, and its value."""
    assert let.written
    table = tables.get(let.written.of) if let.written.kind == "table" else None
    formula = let.written.formula
    values = values_of(given)
    known = symbols(formula) <= values.keys()
    value = given.get(let.name)
    asked = GivenQuantity(evaluate(formula, values), value.unit) if known and value else None
    return NoteLine(
        name=let.name,
        label=let.label,
        kind=let.written.kind,
        of=let.written.of,
        formula=_rounded(formula, value),
        numbers=_numbers(formula, let.written.kind, given) if known else None,
        value=value,
        asked=asked,
        decides=_deciding(formula, given),
        dimension=let.dimension,
        between=line_between(table, evaluate(formula, values)) if known and table else None,
        source=table.source if table else "",
    )


def _rounded(formula: Formula, value: GivenQuantity | None) -> Formula:
    """Return a formula; a number of so many digits that it was computed as values are shown."""
    digits = sum(map(str.isdigit, formula.name)) if isinstance(formula, Constant) else 0
    if isinstance(formula, Constant) and value and digits > COMPUTED:
        return replace(formula, name=value.text(VALUE_DIGITS))
    return formula


def _numbers(formula: Formula, kind: str, given: Mapping[str, GivenQuantity]) -> Formula | None:
    """Return a formula in numbers, of a choice what is chosen.

    None where nothing is put in, or where it would be what the formula comes to.
    """
    if is_choice(formula):
        values = values_of(given)
        part = chosen(formula.arguments, lambda f: evaluate(f, values))
        return _numbers(part, kind, given) if part else None
    is_value = isinstance(formula, Symbol) and not kind
    return put_in(formula, given) if symbols(formula) and not is_value else None


def _deciding(formula: Formula, given: Mapping[str, GivenQuantity]) -> Formula | None:
    """Return the part that is the largest, or smallest, of several, if one is."""
    values = values_of(given)
    taken = [p for p in walk(formula) if is_call(p, "min", "max")]
    if len(taken) != 1 or not symbols(taken[0]) <= values.keys():
        return None
    best = max if taken[0].function == "max" else min
    return best(taken[0].arguments, key=lambda a: evaluate(a, values))


def label(line: NoteLine, text: str, locale: Locale, spell: Speller) -> str:
    """Return the text of a line; before that of a result of a used mechanism what it is."""
    said = _kind(line.result, locale, spell) if line.result else ""
    said = f"{said[:1].lower()}{said[1:]} {text}".strip()
    return f"{said}: {locale.no_direction}" if line.has_no_direction else said


def _kind(result: Analysis, locale: Locale, spell: Speller) -> str:
    """Return the kind of a result in words; of a force at a joint its component, too."""
    match result.target:
        case WithFriction(Reaction() | Normal() | Axial() as force):
            said = locale.at_joints["with friction"]
            return said.format(force=component_words(force, locale, spell))
        case Reaction() | Normal() | Axial() as force:
            return component_words(force, locale, spell)
        case _:
            return kind(result, locale, spell)
