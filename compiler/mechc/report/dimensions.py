"""What formulas measure, and whether they mean the same in every system of units."""

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction

from ..formula.evaluate import evaluate
from ..formula.layout import is_angle
from ..formula.tree import Formula, Implicit, Symbol
from ..formula.walk import constants, substitute, symbols, walk
from ..model.result import Definition
from ..study.tolerances import SAME_RATIO
from ..units import ANGLE, LENGTH, MASS, TIME, Dimension

_SCALE = 1.7
"""What a base unit is divided by, once and once more: any number but 1 serves."""


def is_homogeneous(
    formula: Formula, values: Mapping[str, float], dimensions: Mapping[str, Dimension]
) -> bool:
    """Return whether other units of length, mass or time change a formula by a factor alone.

    ``values`` of its names are in SI. One that is zero, or has no value, is taken to be so.

    >>> from ..formula.tree import Symbol, number, total
    >>> w = Symbol("w")
    >>> is_homogeneous(total([w, w]), {"w": 2.0}, {"w": LENGTH})
    True
    >>> is_homogeneous(total([w, number(8)]), {"w": 2.0}, {"w": LENGTH})
    False
    """
    known = _Scaled(formula, values, dimensions)
    return all(map(known.is_power_of, (LENGTH, MASS, TIME)))


def is_plain(
    formula: Formula, values: Mapping[str, float], dimensions: Mapping[str, Dimension]
) -> bool:
    """Return whether other units of length, mass or time leave a formula as it is.

    >>> from ..formula.tree import Symbol, number, quotient
    >>> w = Symbol("w")
    >>> is_plain(quotient(w, w), {"w": 2.0}, {"w": LENGTH})
    True
    >>> is_plain(quotient(w, number(8)), {"w": 2.0}, {"w": LENGTH})
    False
    """
    known = _Scaled(formula, values, dimensions)
    return all(map(known.is_same, (LENGTH, MASS, TIME)))


class _Scaled:
    """A formula where base units are smaller."""

    def __init__(
        self, formula: Formula, values: Mapping[str, float], dimensions: Mapping[str, Dimension]
    ) -> None:
        self._formula, self._values, self._dimensions = formula, values, dimensions
        self._first = evaluate(formula, values)
        self._known: dict[tuple[Dimension, int], float] = {}

    def _value(self, base: Dimension, times: int) -> float:
        """Return the value where a base unit is so many times smaller by a factor."""
        if (base, times) not in self._known:
            self._known[base, times] = self._found(base, times)
        return self._known[base, times]

    def _found(self, base: Dimension, times: int) -> float:
        shares = {name: _share(self._dimensions[name], base) for name in self._values}
        if not any(shares.values()):
            return self._first
        scaled = {n: v * _SCALE ** (times * shares[n]) for n, v in self._values.items()}
        return evaluate(self._formula, scaled)

    def is_power_of(self, base: Dimension) -> bool:
        """Return whether a unit that is twice so small changes the value by one factor squared."""
        first = self._first
        if not math.isfinite(first):
            return True
        second, third = self._value(base, 1), self._value(base, 2)
        return math.isclose(second * second, first * third, rel_tol=SAME_RATIO)

    def is_same(self, base: Dimension) -> bool:
        """Return whether a smaller unit leaves the value as it is; one that has none is left."""
        first = self._first
        return not math.isfinite(first) or math.isclose(
            first, self._value(base, 1), rel_tol=SAME_RATIO
        )

    def exponent(self, base: Dimension) -> Fraction | None:
        """Return the exponent of a base unit in the formula; halves and thirds are exact.

        What rounding leaves of a zero changes by any factor, and has none.
        """
        first, second = self._first, self._value(base, 1)
        if not (first and second and math.isfinite(first) and math.isfinite(second)):
            return None
        found = math.log(second / first) / math.log(_SCALE)
        exponent = Fraction(found).limit_denominator(6)
        return exponent if math.isclose(found, exponent, abs_tol=SAME_RATIO) else None


def dimension_of(
    formula: Formula, values: Mapping[str, float], dimensions: Mapping[str, Dimension]
) -> Dimension | None:
    """Return the dimension of a formula; None where it is zero, or has no one dimension.

    ``values`` of its names are in SI.

    >>> from ..formula.tree import Symbol, product, total
    >>> w, f = Symbol("w"), Symbol("f")
    >>> area = product([(w, 2), (f, 1)])
    >>> dimension_of(area, {"w": 2.0, "f": 0.1}, {"w": LENGTH, "f": Dimension()})
    Dimension(length=Fraction(2, 1), mass=Fraction(0, 1), time=Fraction(0, 1), angle=0)
    >>> dimension_of(total([w, f]), {"w": 2.0, "f": 0.1}, {"w": LENGTH, "f": Dimension()})
    """
    known = _Scaled(formula, values, dimensions)
    bases = (LENGTH, MASS, TIME)
    if not all(map(known.is_power_of, bases)):
        return None
    length, mass, time = map(known.exponent, bases)
    if length is None or mass is None or time is None:
        return None
    return Dimension(length, mass, time)


def _share(dimension: Dimension, base: Dimension) -> float:
    """Return the exponent of a base unit in a dimension."""
    return float(sum(a * b for a, b in zip(dimension, base, strict=True)))


def found_dimension(
    definition: Definition,
    angles: Iterable[str],
    values: Mapping[str, float],
    dimensions: Mapping[str, Dimension],
) -> Dimension | None:
    """Return the dimension of what a loop or friction defines; None if it is not known."""
    if definition.name.startswith("len_"):
        return LENGTH
    if is_angle(definition.formula, set(angles)):
        return ANGLE
    names = names_in(definition.formula)
    if is_solved(definition.formula) or not names <= dimensions.keys() & values.keys():
        return None
    return dimension_of(
        with_symbols(definition.formula),
        {name: values[name] for name in names},
        {name: dimensions[name] for name in names},
    )


def is_solved(formula: Formula) -> bool:
    """Return whether the solution of a system is in a formula."""
    return any(isinstance(part, Implicit) for part in walk(formula))


def names_in(formula: Formula) -> frozenset[str]:
    """Return all names of a formula, those of numbers too."""
    return symbols(formula) | {c.name for c in constants([formula])}


def with_symbols(formula: Formula) -> Formula:
    """Return a formula in which named numbers are symbols, to be put in like all others."""
    return substitute(formula, {c.name: Symbol(c.name) for c in constants([formula])})
