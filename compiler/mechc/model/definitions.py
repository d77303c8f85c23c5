"""Parameters and lets: read in the order in which they need one another.

A let that uses parameters only, and that the description itself uses, is a dependent
parameter by another word; it is handed on as one.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from graphlib import CycleError, TopologicalSorter

from ..algebra.formula import Formula, substitute, symbols
from ..diagnostics.model import names
from ..syntax import ast
from .constants import names_in
from .expressions import Reader
from .mechanism import Let, Parameter
from .parameters import read_parameter
from .scope import FORMULA, Scope
from .statements import every

Definition = ast.Param | ast.Let


@dataclass(slots=True)
class Definitions:
    """What was defined, by name, each after those it needs."""

    parameters: dict[str, Parameter] = field(default_factory=dict)
    lets: dict[str, Let] = field(default_factory=dict)

    def feeding(self, scope: Scope) -> set[str]:
        """Return the lets that the description is made of, directly or through another let."""
        feeding: set[str] = set()
        waiting = [name for name in scope.feeding if name in self.lets]
        while waiting:
            name = waiting.pop()
            if name not in feeding:
                feeding.add(name)
                waiting.extend(s for s in symbols(self.lets[name].value) if s in self.lets)
        return feeding


def read_definitions(file: ast.File, scope: Scope) -> Definitions:
    """Read parameters and lets whose names the scope knows."""
    statements = _by_name(file, scope)
    found = Definitions()
    for name in _ordered(statements, scope):
        match statements[name]:
            case ast.Param() as statement:
                if parameter := read_parameter(statement, scope, found.parameters):
                    found.parameters[name] = parameter
            case ast.Let() as statement:
                if let := _read_let(statement, scope):
                    found.lets[name] = let
    return found


def _by_name(file: ast.File, scope: Scope) -> dict[str, Definition]:
    """Return the statements that own their names, and the lets that give loads a value."""
    owned: dict[str, Definition] = {}
    definitions: list[Definition] = [*every(file, ast.Param), *every(file, ast.Let)]
    for statement in definitions:
        entry = scope.entries.get(statement.name.text)
        gives = entry is not None and entry.kind == "load" and isinstance(statement, ast.Let)
        if entry and (gives or entry.span == statement.name.span):
            owned.setdefault(statement.name.text, statement)
    return owned


def _ordered(statements: Mapping[str, Definition], scope: Scope) -> list[str]:
    """Return the names so that each follows those it needs; report circles and drop them."""
    needs = {name: _needs(statement, statements) for name, statement in statements.items()}
    while True:
        try:
            return list(TopologicalSorter(needs).static_order())
        except CycleError as error:
            cycle: list[str] = error.args[1]
            _report_cycle(cycle, scope, statements)
            needs = {n: wanted - set(cycle) for n, wanted in needs.items() if n not in cycle}


def _needs(statement: Definition, known: Mapping[str, Definition]) -> set[str]:
    if statement.value is None:
        return set()
    return {s.name for s in names_in(statement.value) if s.name in known}


def _report_cycle(cycle: list[str], scope: Scope, statements: Mapping[str, Definition]) -> None:
    """Say ``a → b → a`` in the order of use (the sorter gives each before its user)."""
    places = [statements[name].span for name in cycle[:-1]]
    scope.used.update(cycle)
    scope.report.add(names.circular_definition(places[0], cycle[::-1], places[1:]))


def _read_let(statement: ast.Let, scope: Scope) -> Let | None:
    name = statement.name.text
    found = Reader(scope, FORMULA).read(statement.value)
    if found is None:
        return None
    entry = scope.entries[name]
    if entry.kind == "load" and entry.dimension is not None:
        if not Reader(scope, FORMULA).fits(found, entry.dimension, f"load '{name}'"):
            return None
        return Let(name, found.formula, entry.dimension, statement.span)
    scope.define(name, found.dimension, plain=_plain(found.formula, scope))
    return Let(name, found.formula, found.dimension, statement.span)


def _plain(formula: Formula, scope: Scope) -> bool:
    entries = [scope.entries[name] for name in symbols(formula)]
    return all(e.kind == "parameter" or (e.kind == "let" and e.plain) for e in entries)


# --------------------------------------------------------------- lets as parameters


def settled(
    found: Definitions, file: ast.File, scope: Scope
) -> tuple[tuple[Parameter, ...], tuple[Let, ...]]:
    """Return parameters and lets in the order of the file; feeding lets are parameters."""
    feeding = found.feeding(scope)
    parameters: list[Parameter] = []
    lets: list[Let] = []
    for statement in file.statements:
        match statement:
            case ast.Param(name=name) if name.text in found.parameters:
                parameters.append(found.parameters[name.text])
            case ast.Let(name=name) if name.text in feeding:
                parameters.append(_as_parameter(found.lets[name.text]))
            case ast.Let(name=name) if name.text in found.lets:
                lets.append(found.lets[name.text])
    return tuple(parameters), tuple(lets)


def _as_parameter(let: Let) -> Parameter:
    dependent = bool(symbols(let.value))
    return Parameter(let.name, let.dimension, let.span, let.value, dependent=dependent)


def without_lets(formula: Formula, found: Definitions, scope: Scope) -> Formula:
    """Return the formula with every let that is no parameter written out."""
    kept = found.feeding(scope)
    while names_left := [n for n in symbols(formula) if n in found.lets and n not in kept]:
        formula = substitute(formula, {n: found.lets[n].value for n in names_left})
    return formula
