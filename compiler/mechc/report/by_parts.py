"""Numbers put into long formulas part by part, as they stand on a page: ``Z_1`` before ``R_O``."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from math import isfinite

from ..formula.evaluate import evaluate
from ..formula.tree import Formula, Symbol
from ..formula.walk import children, rebuild, symbols
from ..model.result import Definition
from .dimensions import names_in
from .evaluated import Evaluated, Known, found_unit
from .put_in import Quantity, in_numbers, values_of

Named = Mapping[Formula, Symbol]
"""The sums that have got names of their own on a page."""


def by_parts(
    found: Iterable[Evaluated], named: Named, fits: Callable[[Evaluated], bool]
) -> Iterator[Evaluated]:
    """Yield values; before one whose numbers do not fit, those of the named sums in its formula.

    Each sum stands once. A formula that has none, or does not fit with them, comes as it is.
    """
    shown = set[str]()
    for item in found:
        if not named or item.formula is None or item.known is None or fits(item):
            yield item
            continue
        formula = _in_names(item.formula, named)
        known = {**item.known.quantities, **_values(named, item.known)}
        shorter = item._replace(numbers=_numbers(formula, item.value, known))
        if formula == item.formula or not fits(shorter):
            yield item
            continue
        parts = [part for part in _parts(formula, named) if part[0].name not in shown]
        yield from (_evaluated(symbol, part, known) for symbol, part in parts)
        shown.update(symbol.name for symbol, _ in parts)
        yield shorter


def _in_names(formula: Formula, named: Named) -> Formula:
    """Return a formula with a name for the largest of its sums that have one."""
    return named[formula] if formula in named else _inside(formula, named)


def _inside(formula: Formula, named: Named) -> Formula:
    parts = children(formula)
    return rebuild(formula, tuple(_in_names(p, named) for p in parts)) if parts else formula


def _parts(formula: Formula, named: Named) -> Iterator[tuple[Symbol, Formula]]:
    """Yield the named sums that a formula mentions, behind those that they mention."""
    for whole, symbol in named.items():
        if symbol.name in symbols(formula):
            inside = _inside(whole, named)
            yield from _parts(inside, named)
            yield symbol, inside


def _values(named: Named, known: Known) -> dict[str, Quantity]:
    """Return the values of the named sums that have one, each in a unit that suits it."""
    values = values_of(known.quantities)
    units = {name: quantity.unit for name, quantity in known.quantities.items()}
    angles = [name for name, unit in units.items() if unit == "deg"]
    found = dict[str, Quantity]()
    for whole, symbol in named.items():
        if names_in(whole) <= known.quantities.keys():
            definition = Definition(symbol.name, whole)
            unit = found_unit(definition, known.lengths, angles, values, units)
            value = evaluate(whole, values)
            if unit is not None and isfinite(value):
                found[symbol.name] = Quantity(value, unit)
    return found


def _evaluated(symbol: Symbol, formula: Formula, known: Mapping[str, Quantity]) -> Evaluated:
    value = known[symbol.name]
    return Evaluated(symbol, _numbers(formula, value, known), value, value.unit == "deg")


def _numbers(formula: Formula, value: Quantity, known: Mapping[str, Quantity]) -> Formula | None:
    return in_numbers(formula, known, value.unit in ("", "deg"))
