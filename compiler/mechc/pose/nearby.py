"""The default pose in numbers, and poses near it, for what algebra does not see into."""

import math
from collections.abc import Iterable

from ..algebra.product import Product
from ..formula.walk import evaluate, symbols
from ..model.mechanism import Mechanism, Parameter
from ..model.values import Chain, dependent
from .pose import Definition

NUMBER = 4
STEP = 0.02

Values = dict[str, float]


def poses_nearby(mechanism: Mechanism, definitions: Iterable[Definition]) -> list[Values]:
    """Return the default pose and some others; what has no value gets one in the others only."""
    chain = Chain({**dependent(mechanism), **dict(definitions)})
    return [chain.complete(_given(mechanism, number)) for number in range(NUMBER)]


def _given(mechanism: Mechanism, number: int) -> Values:
    return {
        p.name: _moved(p, math.sin(1 + 7 * number + i), number)
        for i, p in enumerate(mechanism.parameters)
        if not p.dependent and (number or p.value is not None)
    }


def is_behind(length: Product, poses: Iterable[Values]) -> bool:
    """Tell whether a length that was found, such as a place on a line, is negative."""
    known = (values for values in poses if symbols(length.formula()) <= values.keys())
    values = next(known, None)
    return values is not None and length.evaluate(values) < 0


def _moved(parameter: Parameter, part: float, number: int) -> float:
    if parameter.value is None:
        return 0.9 + 0.3 * part
    return evaluate(parameter.value, {}) * (1 + STEP * part * bool(number))
