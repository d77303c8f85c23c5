"""Values on the way to results."""

import math
from collections.abc import Mapping

from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model.values import Values, completed
from ..named import NamedTuple
from ..study.analysis import Analysis
from ..study.tolerances import SAME_RATIO
from ..units import ANGLE, Dimension
from .dimensions import found_dimension
from .put_in import Quantity, usual_unit


class Found(NamedTuple):
    """A value, and what it measures."""

    value: Quantity
    dimension: Dimension


def on_the_way(
    result: Analysis, values: Values, dimensions: Mapping[str, Dimension], lengths: str
) -> dict[str, Found]:
    """Return the values of the names that a result rests on, as far as their units are known.

    There are none where the result has another form at these ``values`` than the one printed.
    """
    known, measures = completed(values, result.where), dict(dimensions)
    if not _is_printed(result, known):
        return {}
    found: dict[str, Found] = {}
    for definition in result.where:
        angles = [name for name, dimension in measures.items() if dimension == ANGLE]
        dimension = found_dimension(definition, angles, known, measures)
        if dimension is not None and math.isfinite(known[definition.name]):
            measures[definition.name] = dimension
            value = Quantity(known[definition.name], usual_unit(dimension, lengths))
            found[definition.name] = Found(value, dimension)
    return found


def _is_printed(result: Analysis, known: Values) -> bool:
    """Return whether the printed formula gives the value of a result."""
    if result.default is None or not symbols(result.formula) <= known.keys():
        return False
    return math.isclose(evaluate(result.formula, known), result.default, rel_tol=SAME_RATIO)
