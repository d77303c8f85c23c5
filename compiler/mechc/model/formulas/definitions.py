"""Parameters and lets: read in the order in which they need one another.

A let that uses parameters only, and that the description itself uses, is a dependent
parameter by another word; it is handed on as one.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Literal

from ...base.named import NamedTuple
from ...diagnostics import uses as uses_messages
from ...diagnostics.model import names
from ...diagnostics.model import sheets as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, Number, Symbol
from ...formula.walk import substitute, symbols, walk
from ...source import Span
from ...syntax import ast
from ...units import ANGLE, DIMENSIONS, FREQUENCY, UNITS, Dimension
from ..constants import expressions_in, leaves, names_in_let_value
from ..mechanism import Let, Parameter, Require, Subject
from ..names.scope import NameScope
from ..parts.written import WrittenSides, expression
from ..statements import every
from ..values import ordered
from .choices import read_let_value
from .measured import MeasuredFormula, fits, shown
from .misplaced_units import note_misplaced_unit, note_unit_factor
from .parameters import constant, note_unitless, read_parameter
from .sorts import Nature
from .tables import note_between, read_tables

MOST_LET_PARTS = 200
"""Parts of a let that is written out: lets of lets can double in length with each."""

DefiningStatement = ast.Param | ast.Let | ast.Taken
"""A line that gives a quantity its value or its formula."""

Leaf = ast.Symbol | ast.Number
"""What a formula is made of in the end."""

_ENDS: tuple[Literal[">=", "<="], ...] = (">=", "<=")
"""How a quantity stands to the ends of its range."""


class DefinedValues(NamedTuple):
    """What was defined, by name, each after those it needs; when lets have values."""

    parameters: dict[str, Parameter]
    lets: dict[str, Let]
    requires: list[Require]


def read_definitions(file: ast.File, scope: NameScope) -> DefinedValues:
    """Read parameters and lets whose names the scope knows."""
    statements, tables = _by_name(file, scope), read_tables(file, scope)
    found = DefinedValues({}, {}, [])
    for name in _ordered(statements, scope):
        match statements[name]:
            case ast.Param() as statement:
                if parameter := read_parameter(statement, scope, found.parameters):
                    found.parameters[name] = parameter
            case ast.Taken(measures=dimension, rests_on=used):
                scope.define(name, dimension)
                scope.used.update(symbol.name for symbol in used)
            case ast.Let() as statement:
                note_between(statement, statements, tables, scope)
                if chosen := read_let_value(statement, tables, scope):
                    found.requires.extend(chosen.requires)
                    if let := _let(statement, chosen.quantity, scope):
                        found.lets[name] = let
                        _note_turns(statement, let.dimension, statements, scope)
                        note_unit_factor(statement, let.dimension, scope)
                        found.requires.extend(_within_range(statement, let, scope))
    return found


def _by_name(file: ast.File, scope: NameScope) -> dict[str, DefiningStatement]:
    """Return the statements that own their names, and the lets that give loads a value."""
    owned: dict[str, DefiningStatement] = {}
    definitions: list[DefiningStatement] = [*every(file, ast.Param), *every(file, ast.Let)]
    definitions += every(file, ast.Taken)
    for statement in definitions:
        entry = scope.entries.get(statement.name.text)
        gives = entry is not None and entry.kind == "load" and isinstance(statement, ast.Let)
        if entry and (gives or entry.span == statement.name.span):
            owned.setdefault(statement.name.text, statement)
    return owned


def _ordered(statements: Mapping[str, DefiningStatement], scope: NameScope) -> list[str]:
    """Return the names so that each follows those it needs; report cycles."""
    order, cycles = ordered({name: _needs(s, statements) for name, s in statements.items()})
    for cycle in cycles:
        places = _places([statements[name] for name in cycle[:-1]], scope)
        scope.used.update(cycle)
        scope.report.add(names.circular_definition(places[0], cycle, places[1:]))
    return order


def _places(cycle: list[DefiningStatement], scope: NameScope) -> list[Span]:
    """Return where definitions stand, what the command line sets before all."""
    values = [s.value.span for s in cycle if isinstance(s, ast.Param) and s.value]
    settings = [value for value in values if scope.report.source.is_setting(value)]
    return settings + [statement.span for statement in cycle]


def _needs(statement: DefiningStatement, known: Mapping[str, DefiningStatement]) -> set[str]:
    if isinstance(statement, ast.Taken):
        return {symbol.name for symbol in statement.rests_on if symbol.name in known}
    if statement.value is None:
        return set()
    return {s.name for s in names_in_let_value(statement.value) if s.name in known}


def _let(statement: ast.Let, found: MeasuredFormula, scope: NameScope) -> Let | None:
    """Return a definition, its name in the scope from now on; None where an error was reported."""
    name = statement.name.text
    entry = scope.entries[name]
    if isinstance(statement, ast.Given) and not found.sort.fits(statement.measures):
        kinds = (found.dimension, statement.measures)
        parameter = statement.parameter.span
        scope.report.add(uses_messages.given_another_kind(found.span, name, *kinds, parameter))
        return None
    if entry.kind == "load" and entry.dimension is not None:
        if not fits(found, entry.dimension, f"load '{name}'", scope):
            return None
        return Let(name, found.formula, entry.dimension, statement.span)
    on_loads, on_pose = _on_loads(found.formula, scope), _on_pose(found.formula, scope)
    dimension = found.dimension
    if not _fits_its_unit(statement, found, scope):
        return None
    if statement.unit is None:
        note_misplaced_unit(statement, dimension, scope)
    scope.define(name, dimension, on_loads, on_pose, _on_results(found.formula, scope))
    note_unitless(name, found, scope)
    _note_value(name, found.formula, scope)
    unit = statement.unit.text if statement.unit else ""
    return Let(name, found.formula, dimension, statement.span, unit, statement.label)


def _note_value(name: str, formula: Formula, scope: NameScope) -> None:
    """Keep the value of a let of parameters alone: a length must be positive, whatever gives it."""
    if symbols(formula) <= scope.values.keys():
        value = evaluate(formula, scope.values)
        if math.isfinite(value):
            scope.values[name] = scope.sizes[name] = value


def _within_range(statement: ast.Let, let: Let, scope: NameScope) -> Iterator[Require]:
    """Yield that what is given to a parameter of a used sheet is in the range of that."""
    if not isinstance(statement, ast.Given):
        return
    parameter, place = statement.parameter, statement.value.span
    for written, operator in zip((parameter.low, parameter.high), _ENDS, strict=True):
        end = constant(written, scope, "an end of a range") if written else None
        if written and end:
            subject = Subject("range", parameter.name.text, let.name, end.span)
            sides = (Symbol(let.name), operator, end.formula)
            shown = WrittenSides(Symbol(let.name), expression(written))
            yield Require(*sides, place, subject, shown, let.dimension)


def _fits_its_unit(statement: ast.Let, found: MeasuredFormula, scope: NameScope) -> bool:
    """Return whether a formula measures what the unit to show it in does; report another one.

    Of what rests on it nothing is said then, as either may be meant: one mistake, one message.
    """
    unit = statement.unit
    if unit is None or found.sort.fits(UNITS[unit.text].dimension):
        return True
    asked, name = UNITS[unit.text].dimension, statement.name.text
    is_bare = isinstance(found.formula, Number) and found.sort.nature is Nature.BARE
    bare = shown(found.formula) if is_bare else ""
    kinds = (found.dimension, asked)
    scope.report.add(messages.other_unit(unit.span, name, unit.text, *kinds, bare))
    return False


def _on_loads(formula: Formula, scope: NameScope) -> bool:
    """Return whether a formula has loads or results, itself or through lets."""
    entries = [scope.entries[name] for name in symbols(formula) if name in scope.entries]
    return any(e.on_loads if e.kind == "let" else e.kind != "parameter" for e in entries)


def _on_results(formula: Formula, scope: NameScope) -> bool:
    entries = [scope.entries[name] for name in symbols(formula) if name in scope.entries]
    return any(e.kind == "result" or e.on_results for e in entries)


def _on_pose(formula: Formula, scope: NameScope) -> bool:
    """Return whether a formula mentions ``phi_AB`` or ``len_AB``, itself or through lets."""
    names = symbols(formula)
    return any(n not in scope.entries or scope.entries[n].on_pose for n in names)


# --------------------------------------------------------------- lets as parameters


def spread_feeding(found: DefinedValues, scope: NameScope) -> None:
    """Count the lets that feeding lets are made of as feeding the description too."""
    waiting = list(scope.feeding)
    while waiting:
        let = found.lets.get(waiting.pop())
        fresh = symbols(let.value) & found.lets.keys() - scope.feeding if let else frozenset()
        scope.feeding |= fresh
        waiting.extend(fresh)


def in_file_order(
    found: DefinedValues, file: ast.File, scope: NameScope
) -> tuple[tuple[Parameter, ...], tuple[Let, ...]]:
    """Return parameters and lets in the order of the file; feeding lets are parameters."""
    parameters: list[Parameter] = []
    lets: list[Let] = []
    for statement in file.statements:
        match statement:
            case ast.Param(name=name) if name.text in found.parameters:
                parameters.append(found.parameters[name.text])
            case ast.Let(name=name) if name.text in scope.feeding and name.text in found.lets:
                known = {p.name: p.unit for p in (*found.parameters.values(), *parameters)}
                parameters.append(_as_parameter(found.lets[name.text], statement, known))
            case ast.Let(name=name) if name.text in found.lets:
                lets.append(found.lets[name.text])
    return tuple(parameters), tuple(lets)


def _as_parameter(let: Let, line: ast.Let, known: Mapping[str, str]) -> Parameter:
    """Return a let as a parameter, in the unit that is asked for, else the first one it uses.

    An angle is in degrees unless its own line has another unit.
    """
    dependent, own = bool(symbols(let.value)), (let.name, let.dimension, let.span, let.value)
    known = {} if let.dimension == ANGLE else known
    written = (
        known.get(k.name, "") if isinstance(k, ast.Symbol) else k.unit for k in _leaves(line)
    )
    units = (u for u in (let.unit, *written) if u and UNITS[u].dimension == let.dimension)
    return Parameter(*own, dependent=dependent, unit=next(units, ""))


def written_out(found: DefinedValues, scope: NameScope) -> dict[str, Formula]:
    """Return lets as formulas of parameters and loads; those too long for that are left out."""
    formulas: dict[str, Formula] = {}
    lengths: dict[str, int] = {}
    for name, let in found.lets.items():
        entry = scope.entries[name]
        if entry.kind != "let" or entry.on_results or name in scope.feeding:
            continue
        parts = [part.name if isinstance(part, Symbol) else "" for part in walk(let.value)]
        lengths[name] = sum(lengths.get(part, 1) for part in parts)
        if lengths[name] <= MOST_LET_PARTS:
            formulas[name] = substitute(let.value, formulas)
    return formulas


# -------------------------------------------------------------------------------------------- turns


TURNING = frozenset({"rpm", "rev/min", "rev/s", "rad/s", "deg/s", "°/s"})
"""Units of an angular velocity, in which an angle counts radians."""

TURNS = frozenset({"Hz", "1/s", "1/min"})
"""Units in which people count turns."""

SAID = frozenset({"rev", "rad"})
"""Units that say what is counted."""

PI = "pi"
"""What brings turns to radians, and back."""

FLOW = DIMENSIONS["volume"].over(DIMENSIONS["time"])


def _note_turns(
    let: ast.Let, dimension: Dimension, lines: Mapping[str, DefiningStatement], scope: NameScope
) -> None:
    """Note where a formula counts radians and its reader may count turns (W267, W268).

    It rests on a speed in rpm, says nowhere which of the two is meant, has no pi of its own, and is
    either such a speed shown in Hz or a flow made of a volume, which is that for a turn as
    catalogues have it.
    """
    assert let.value is not None
    if dimension not in (FREQUENCY, FLOW):
        return
    names = [leaf.name for leaf in _leaves(let) if isinstance(leaf, ast.Symbol)]
    units = _units(_leaves(let), lines)
    if not units & TURNING or units & SAID or PI in names:
        return
    shown = let.unit.text if let.unit else ""
    if dimension == FREQUENCY and shown in TURNS:
        scope.report.add(messages.turns_as_radians(let.unit.span if let.unit else let.span, shown))
    volumes = (n for n in names if _measures(n, DIMENSIONS["volume"], scope))
    if dimension == FLOW and (volume := next(volumes, "")):
        scope.report.add(messages.volume_of_a_radian(let.value.span, volume))


def _measures(name: str, dimension: Dimension, scope: NameScope) -> bool:
    return name in scope.entries and scope.entries[name].dimension == dimension


def note_speed(speed: ast.Expr, lines: Mapping[str, DefiningStatement], scope: NameScope) -> None:
    """Note a speed of turning in Hz or 1/min, units in which people count turns (W296).

    With pi in it, as in ``2*pi*n``, it has been brought to radians.
    """
    units = _units(leaves(speed), lines)
    counted = sorted(units & TURNS - {"1/s"})
    if counted and not units & (TURNING | SAID | {PI}):
        scope.report.add(messages.speed_in_radians(speed.span, counted[0]))


def _units(leaves: Iterable[Leaf], lines: Mapping[str, DefiningStatement]) -> set[str]:
    """Return the units of a formula's leaves, pi, and those in the lines of what it rests on."""
    units, seen, waiting = set[str](), set[str](), [*leaves]
    while waiting:
        match waiting.pop():
            case ast.Number(unit=unit):
                units.add(unit)
            case ast.Symbol(name) if name in lines:
                waiting += _leaves(lines[name]) if name not in seen else ()
                seen.add(name)
            case ast.Symbol(name) if name == PI:
                units.add(PI)
    return units


def _leaves(line: DefiningStatement) -> Iterator[Leaf]:
    """Yield the symbols and numbers of what a line gives; none of what a used mechanism gives."""
    value = None if isinstance(line, ast.Taken) else line.value
    written = expressions_in(value) if value is not None else ()
    return (leaf for expression in written for leaf in leaves(expression))
