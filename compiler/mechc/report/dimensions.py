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
    return all(_is_power_of(base, formula, values, dimensions) for base in (LENGTH, MASS, TIME))


def _is_power_of(
    base: Dimension,
    formula: Formula,
    values: Mapping[str, float],
    dimensions: Mapping[str, Dimension],
) -> bool:
    """Return whether a unit that is twice so small changes the value by one factor squared."""

    def value(times: int) -> float:
        scaled = {n: v * _SCALE ** (times * _share(dimensions[n], base)) for n, v in values.items()}
        return evaluate(formula, scaled)

    first, second, third = map(value, range(3))
    return not math.isfinite(first) or math.isclose(
        second * second, first * third, rel_tol=SAME_RATIO
    )


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
    bases = (LENGTH, MASS, TIME)
    if not all(_is_power_of(base, formula, values, dimensions) for base in bases):
        return None
    length, mass, time = (_exponent(base, formula, values, dimensions) for base in bases)
    if length is None or mass is None or time is None:
        return None
    return Dimension(length, mass, time)


def _exponent(
    base: Dimension,
    formula: Formula,
    values: Mapping[str, float],
    dimensions: Mapping[str, Dimension],
) -> Fraction | None:
    """Return the exponent of a base unit in a formula; halves and thirds are exact."""
    scaled = {n: v * _SCALE ** _share(dimensions[n], base) for n, v in values.items()}
    first, second = evaluate(formula, values), evaluate(formula, scaled)
    if not (first and second and math.isfinite(first) and math.isfinite(second)):
        return None
    return Fraction(math.log(second / first) / math.log(_SCALE)).limit_denominator(6)


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
