"""A result, or a formula of it, as code in what has a value along the drive."""

import math
from collections.abc import Callable, Sequence, Set

from ...formula.evaluate import straight_line
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.result import Result
from ...model.values import Values, compare

Form = Callable[[Values], float]
"""Returns a value where names have values; NaN where there is none."""


def form(formula: Formula, where: Result | None, names: Set[str]) -> Form:
    """Return a formula in names that have values, with the definitions of a result, as code.

    It has no value where a condition of the result is broken; where the result has a form for
    elsewhere, that form's value is taken where this one has none.
    """
    definitions, known = _definitions(where, names)
    if where is None:
        return _value(formula, definitions, known, names)
    asked = _value(formula, definitions, known, names)
    is_sound = _guarded(where, definitions, known, names)
    if where.elsewhere is None:
        return lambda values: asked(values) if is_sound(values) else math.nan
    own = asked if formula is where.formula else _value(where.formula, definitions, known, names)
    is_known = symbols(where.formula) <= known
    beside = where.elsewhere.formula if formula is where.formula else formula
    elsewhere = form(beside, where.elsewhere, names)

    def value(values: Values) -> float:
        stands = is_sound(values) and not (is_known and math.isnan(own(values)))
        return (asked if stands else elsewhere)(values)

    return value


Definitions = Sequence[tuple[str, Formula]]


def _definitions(where: Result | None, names: Set[str]) -> tuple[Definitions, Set[str]]:
    """Return the definitions that say something new, and all names that then have values."""
    known, definitions = set(names), []
    for name, formula in where.where if where else ():
        if name not in names and symbols(formula) <= known:
            known.add(name)
            definitions.append((name, formula))
    return definitions, known


def _value(formula: Formula, definitions: Definitions, known: Set[str], names: Set[str]) -> Form:
    """Return the function that computes one formula."""
    if not symbols(formula) <= known:
        return lambda values: math.nan
    code = _code([formula], definitions, names)
    return lambda values: code(values)[0]


def _guarded(
    where: Result, definitions: Definitions, known: Set[str], names: Set[str]
) -> Callable[[Values], bool]:
    """Return the function that says whether a result's conditions hold, of known names."""
    guards = [g for g in where.guards if symbols(g.left) | symbols(g.right) <= known]
    if not guards:
        return lambda values: True
    sides = _code([s for g in guards for s in (g.left, g.right)], definitions, names)
    relations = [guard.operator for guard in guards]

    def holds(values: Values) -> bool:
        found = sides(values)
        return all(map(compare, found[::2], relations, found[1::2]))

    return holds


def _code(
    formulas: Sequence[Formula], definitions: Definitions, names: Set[str]
) -> Callable[[Values], list[float]]:
    """Return the function that computes formulas, and those definitions that they need."""
    needed = frozenset[str]().union(*map(symbols, formulas))
    followed = list[tuple[str, Formula]]()
    for name, formula in reversed(definitions):
        if name in needed:
            followed.insert(0, (name, formula))
            needed |= symbols(formula)
    given = sorted(needed & names)
    code = straight_line(formulas, given, followed)
    return lambda values: code.at([values[name] for name in given])
