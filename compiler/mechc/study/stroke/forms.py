"""A result, or a formula of it, as code in what has a value along the drive."""

import math
from collections.abc import Callable, Sequence, Set

from ...formula.evaluate import straight_line
from ...formula.straight_line import in_order
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.mechanism import Require
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
    is_sound = holding(where.guards, names, definitions, known)
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
    at, given = _code([formula], definitions, names)
    return lambda values: at(given(values))[0]


def together(
    formulas: Sequence[Formula], names: Set[str], definitions: Definitions = ()
) -> Callable[[Values], Sequence[float]]:
    """Return formulas in names that have values, or definitions, as one code."""
    at, given = _code(formulas, definitions, names)
    return lambda values: at(given(values))


def holding(
    conditions: Sequence[Require],
    names: Set[str],
    definitions: Definitions = (),
    known: Set[str] | None = None,
) -> Callable[[Values], bool]:
    """Return the function that says whether conditions hold, of those that have a value.

    They may rest on definitions; ``known`` are the names that then have values.
    """
    known = names if known is None else known
    guards = [g for g in conditions if symbols(g.left) | symbols(g.right) <= known]
    if not guards:
        return lambda values: True
    sides, given = _code([s for g in guards for s in (g.left, g.right)], definitions, names)
    relations = [guard.operator for guard in guards]

    def holds(values: Values) -> bool:
        found = sides(given(values))
        return all(map(compare, found[::2], relations, found[1::2]))

    return holds


def _code(
    formulas: Sequence[Formula], definitions: Definitions, names: Set[str]
) -> tuple[Callable[[Sequence[float]], list[float]], Callable[[Values], Sequence[float]]]:
    """Return the function that computes formulas and those definitions that they need.

    With it comes the function that takes what it needs from among values.
    """
    needed = frozenset[str]().union(*map(symbols, formulas))
    followed = list[tuple[str, Formula]]()
    for name, formula in reversed(definitions):
        if name in needed:
            followed.insert(0, (name, formula))
            needed |= symbols(formula)
    given = sorted(needed & names)
    return straight_line(formulas, given, followed).at, in_order(given)
