"""Formulas of results as code in what has a value along a parameter."""

import math
from collections.abc import Callable, Iterator, Sequence, Set
from itertools import compress

from ..formula.evaluate import straight_line
from ..formula.numeric.straight_line import in_order
from ..formula.tree import Definitions, Formula
from ..formula.walk import Mentions, reached, symbols
from ..model.mechanism import Require
from ..model.result import Result
from ..model.values import Values, compare

SOON = 4
"""Code along a range is compiled when it has been used so often: most is used a hundred times."""

FormulaCode = Callable[[Values], float]
"""Returns a value where names have values; NaN where there is none."""

FormulaCodes = Callable[[Values], Sequence[float]]
"""Returns several values at once."""


def form(formula: Formula, where: Result | None, names: Set[str]) -> FormulaCode:
    """Return a formula in names that have values, with the definitions of a result, as code.

    It has no value where a condition of the result is broken; where the result has a form for
    elsewhere, that form's value is taken where this one has none.
    """
    if where is None:
        return code_of(formula, names)
    known = _with_defined(names, where.where)
    guards = _valued(where.guards, known)
    if where.elsewhere is None and not guards:
        return code_of(formula, names, where.where)
    own = where.formula if where.elsewhere else formula
    found = code_of_all([formula, own, *_sides(guards)], names, where.where)
    is_known = _is_known(own, known)
    elsewhere = _elsewhere(formula, where, names)

    def value(values: Values) -> float:
        asked, own, *sides = found(values)
        is_sound = _hold(guards, sides)
        if elsewhere is None:
            return asked if is_sound else math.nan
        stands = is_sound and not (is_known and math.isnan(own))
        return asked if stands else elsewhere(values)

    return value


def _elsewhere(formula: Formula, where: Result, names: Set[str]) -> FormulaCode | None:
    """Return a formula of a result in its form for elsewhere, that one's value if it is its own."""
    if where.elsewhere is None:
        return None
    beside = where.elsewhere.formula if formula is where.formula else formula
    return form(beside, where.elsewhere, names)


def code_of(formula: Formula, names: Set[str], definitions: Definitions = ()) -> FormulaCode:
    """Return one formula in names that have values, or definitions, as code."""
    code = code_of_all([formula], names, definitions)
    return lambda values: code(values)[0]


def code_of_all(
    formulas: Sequence[Formula], names: Set[str], definitions: Definitions = ()
) -> FormulaCodes:
    """Return formulas in names that have values, or definitions, as one code.

    One that rests on anything else is NaN; a name that has a value keeps it.
    """
    new = {name: f for name, f in definitions if name not in names}
    known = _with_defined(names, definitions)
    is_valued = [_is_known(formula, known) for formula in formulas]
    valued = [*compress(formulas, is_valued)]
    followed = reached(symbols(*valued), new)
    needed = symbols(*valued, *map(new.__getitem__, followed))
    given = sorted(needed & names)
    at = straight_line(valued, given, [d for d in new.items() if d[0] in followed], SOON).at
    take = in_order(given)
    if all(is_valued):
        return lambda values: at(take(values))

    def with_unknown(values: Values) -> Sequence[float]:
        found = iter(at(take(values)))
        return [next(found) if known else math.nan for known in is_valued]

    return with_unknown


def holding(
    conditions: Sequence[Require], names: Set[str], definitions: Definitions = ()
) -> Callable[[Values], bool]:
    """Return the function that says whether conditions hold, of those that have a value."""
    guards = _valued(conditions, _with_defined(names, definitions))
    if not guards:
        return lambda values: True
    sides = code_of_all([*_sides(guards)], names, definitions)
    return lambda values: _hold(guards, sides(values))


def _valued(guards: Sequence[Require], known: Set[str]) -> list[Require]:
    """Return the conditions whose sides have values."""
    return [g for g in guards if _is_known(g.left, known) and _is_known(g.right, known)]


def _with_defined(names: Set[str], definitions: Definitions) -> Set[str]:
    """Return the names that have values, those among them that definitions give one."""
    known, needs = set(names), Mentions()
    for name, formula in definitions:
        if needs.of(formula) <= known:
            known.add(name)
    return known


def _is_known(formula: Formula, known: Set[str]) -> bool:
    return symbols(formula) <= known


def _sides(guards: Sequence[Require]) -> Iterator[Formula]:
    for guard in guards:
        yield from (guard.left, guard.right)


def _hold(guards: Sequence[Require], sides: Sequence[float]) -> bool:
    """Return whether conditions hold whose sides have these values."""
    relations = [guard.operator for guard in guards]
    return all(map(compare, sides[::2], relations, sides[1::2]))
