"""Whether a formula means the same in every system of units.

A number with a unit inside a formula, as the 8 mm of ``w - 8 mm``, is a plain number of the SI
there: other units must not be put in beside it.
"""

import math
from collections.abc import Mapping

from ..formula.tree import Formula
from ..formula.walk import evaluate
from ..study.tolerances import SAME_RATIO
from ..units import LENGTH, MASS, TIME, Dimension

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


def _share(dimension: Dimension, base: Dimension) -> float:
    """Return the exponent of a base unit in a dimension."""
    return float(sum(a * b for a, b in zip(dimension, base, strict=True)))
