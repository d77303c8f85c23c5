"""Numbers put into long formulas part by part, as they stand on a page: ``Z_1`` before ``R_O``."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from math import isclose, isfinite

from ..formula.evaluate import evaluate
from ..formula.layout import in_degrees, over_line
from ..formula.numeric.rounding import Rounding
from ..formula.tree import (
    Constant,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    is_call,
    power,
    product,
)
from ..formula.walk import children, rebuild, symbols
from ..model.result import Definition
from .digits import VALUE_DIGITS
from .dimensions import names_in
from .evaluated import Evaluated, KnownQuantities, found_unit
from .made_names import NamedSums
from .put_in import GivenQuantity, in_numbers, values_of

ROUNDED_SUMS = 5e-6
"""The part of a value that rounding of printed numbers may make."""


def by_parts(
    found: Iterable[Evaluated], named: NamedSums, fits: Callable[[Evaluated], bool]
) -> Iterator[Evaluated]:
    """Yield values; before one whose numbers do not fit, those of the named sums in its formula.

    Each sum that has a value stands once. A formula without such sums, or that does not fit with
    them, has the values of its terms, or of the sums among its factors; where that does not fit
    either it comes as it is.
    """
    shown, sums = set[str](), _NamedSums(named)
    for item in found:
        if item.formula is None or item.known is None or fits(item):
            yield item
            continue
        formula = _in_names(item.formula, named)
        known = {**item.known.quantities, **sums.values(item.known)}
        shorter = item._replace(numbers=_numbers(formula, item.value, known))
        if formula == item.formula or not fits(shorter):
            yield _shortened(item, item.formula, item.known, fits)
            continue
        valued = known.keys() - shown
        parts = {s: part for s, part in _parts(formula, named) if s.name in valued}
        more = item.known._replace(quantities=known)
        for symbol, part in parts.items():
            evaluated = _evaluated(symbol, part, known)
            yield evaluated if fits(evaluated) else _shortened(evaluated, part, more, fits)
        shown.update(symbol.name for symbol in parts)
        yield shorter


def _in_names(formula: Formula, named: NamedSums) -> Formula:
    """Return a formula with a name for the largest of its sums that have one."""
    return named[formula] if formula in named else _inside(formula, named)


def _inside(formula: Formula, named: NamedSums) -> Formula:
    parts = tuple(_in_names(part, named) for part in children(formula))
    return rebuild(formula, parts) if parts != children(formula) else formula


def _parts(formula: Formula, named: NamedSums) -> Iterator[tuple[Symbol, Formula]]:
    """Yield the named sums that a formula mentions, behind those that they mention."""
    for whole, symbol in named.items():
        if symbol.name in symbols(formula):
            inside = _inside(whole, named)
            yield from _parts(inside, named)
            yield symbol, inside


class _NamedSums:
    """The values of named sums, each found once: what it rests on keeps its value on a page."""

    def __init__(self, named: NamedSums) -> None:
        self._named = named
        self._needs: dict[str, frozenset[str]] = {}
        self._found: dict[str, GivenQuantity | None] = {}

    def values(self, known: KnownQuantities) -> dict[str, GivenQuantity]:
        """Return the values of those that have one, each in a unit that suits it."""
        found = (
            (symbol.name, self._value(symbol.name, whole, known))
            for whole, symbol in self._named.items()
        )
        return {name: value for name, value in found if value is not None}

    def _value(self, name: str, whole: Formula, known: KnownQuantities) -> GivenQuantity | None:
        """Return the value of a sum; None where not all is known that it rests on."""
        if name not in self._needs:
            self._needs[name] = names_in(whole)
        if not self._needs[name] <= known.quantities.keys():
            return None
        if name not in self._found:
            self._found[name] = _value(whole, known)
        return self._found[name]


def _evaluated(symbol: Symbol, formula: Formula, known: Mapping[str, GivenQuantity]) -> Evaluated:
    value = known[symbol.name]
    return Evaluated(symbol, _numbers(formula, value, known), value, value.unit == "deg")


def _numbers(
    formula: Formula, value: GivenQuantity, known: Mapping[str, GivenQuantity]
) -> Formula | None:
    return in_numbers(formula, known, value.unit in ("", "deg"))


def _shortened(
    item: Evaluated, formula: Formula, known: KnownQuantities, fits: Callable[[Evaluated], bool]
) -> Evaluated:
    """Return an item with the values of its formula's parts put in, if that fits."""
    found = item._replace(numbers=_in_values(formula, item.value, known))
    return found if found.numbers and fits(found) else item


def _in_values(formula: Formula, value: GivenQuantity, known: KnownQuantities) -> Formula | None:
    """Return a sum by the values of its terms, a product by those of the sums among its factors.

    None where there is nothing to be shortened, where something in it has no value on the page, or
    where so little is left of a difference that it has another value with the digits printed.
    """
    if not isinstance(formula, Sum | Product):
        return None
    values = _Values(isinstance(formula, Product), known)
    shorter = rebuild(formula, tuple(map(values.put_in, children(formula))))
    shorter = over_line(shorter) if over_line(formula) == formula else shorter
    as_printed = {n: q.value for n, q in known.quantities.items()}
    as_printed |= {n: float(f"{q.value:.{VALUE_DIGITS}g}") for n, q in values.named.items()}
    if not values.named or not names_in(shorter) <= as_printed.keys():
        return None
    if not isclose(evaluate(shorter, as_printed), value.value, rel_tol=ROUNDED_SUMS):
        return None
    numbers = _numbers(shorter, value, {**known.quantities, **values.named})
    return None if numbers is not None and _is_a_value(numbers) else numbers


class _Values:
    """The values that stand for parts of a sum or a product, by the names that these have there."""

    def __init__(self, in_product: bool, known: KnownQuantities) -> None:
        self._in_product, self._known = in_product, known
        self.named: dict[str, GivenQuantity] = {}

    def put_in(self, part: Formula) -> Formula:
        """Return the name of a part's value with its sign; itself where it is short as it is."""
        if isinstance(part, Power):
            return power(self.put_in(part.base), part.exponent)
        if self._is_short(part) or (quantity := _value(part, self._known)) is None:
            return part
        name, sign = f"_{len(self.named) + 1}", -1 if quantity.value < 0 else 1
        self.named[name] = quantity._replace(value=sign * quantity.value)
        return product([(Symbol(name), 1), (Number(Fraction(sign)), 1)])

    def _is_short(self, part: Formula) -> bool:
        """Return whether a part is a name, a number, or a factor that is no sum."""
        if isinstance(part, Symbol | Number) or in_degrees(part) is not None:
            return True
        return self._in_product and not _is_sum(part)


def _is_a_value(numbers: Formula) -> bool:
    """Return whether numbers are one angle or quantity: a sum of which the others are zero."""
    return isinstance(numbers, Number | Constant) or in_degrees(numbers) is not None


def _is_sum(part: Formula) -> bool:
    return isinstance(part, Sum) or is_call(part, "sqrt", "hypot")


SHIFT = 0.01
"""By what part of themselves values differ from those at which a part is zero."""


def _value(part: Formula, known: KnownQuantities) -> GivenQuantity | None:
    """Return the value of a part in a unit that suits it, None where it has none.

    Rounding alone has no unit: that of what is zero is known from the terms that it is added to.
    """
    if not names_in(part) <= known.quantities.keys():
        return None
    values = values_of(known.quantities)
    units = {name: quantity.unit for name, quantity in known.quantities.items()}
    angles = [name for name, unit in units.items() if unit == "deg"]
    size = Rounding(values).of(part)
    near = _values_nearby(values) if size.is_zero else values
    if size.is_zero and Rounding(near).of(part).is_zero:
        return None
    unit = found_unit(Definition("_", part), known.usual, angles, near, units)
    value = 0.0 if size.is_zero else size.value
    return GivenQuantity(value, unit) if unit is not None and isfinite(value) else None


def _values_nearby(values: Mapping[str, float]) -> dict[str, float]:
    """Return values that are each a little larger, none by the same part as another."""
    return {name: v * (1 + SHIFT * i) for i, (name, v) in enumerate(sorted(values.items()), 1)}
