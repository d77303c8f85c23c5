"""The default pose in numbers, and poses near it, for what algebra does not see into."""

import math
from collections.abc import Iterable

from ..algebra.product import Product
from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model.mechanism import Mechanism, Parameter
from ..model.values import Chain, bounds, dependent
from ..units import ANGLE, LENGTH
from .pose import Definition

NUMBER = 4

STEP = 0.02
"""The part of a value, or of a usual one, by which poses lie apart."""

USUAL_ANGLE, USUAL_PART = 0.1, 0.01
"""A value nearer to zero is moved by a part of this: in radians, or of the greatest length."""

Values = dict[str, float]


def poses_nearby(mechanism: Mechanism, definitions: Iterable[Definition]) -> list[Values]:
    """Return the default pose and some others; what has no value gets one in the others only."""
    chain = Chain({**dependent(mechanism), **dict(definitions)})
    return [chain.complete(_given(mechanism, number)) for number in range(NUMBER)]


def _given(mechanism: Mechanism, number: int) -> Values:
    longest = max(map(_size, mechanism.parameters), default=0.0)
    return {
        p.name: _moved(p, math.sin(1 + 7 * number + i), number, longest)
        for i, p in enumerate(mechanism.parameters)
        if not p.dependent and (number or p.value is not None)
    }


def _size(parameter: Parameter) -> float:
    """Return the size of a length, 0 for anything else."""
    if parameter.dimension != LENGTH or parameter.value is None or parameter.dependent:
        return 0.0
    return abs(evaluate(parameter.value, {}))


def is_behind(length: Product, poses: Iterable[Values]) -> bool:
    """Return whether a length that was found, such as a place on a line, is negative."""
    known = (values for values in poses if symbols(length.formula()) <= values.keys())
    values = next(known, None)
    return values is not None and length.evaluate(values) < 0


def _moved(parameter: Parameter, part: float, number: int, longest: float) -> float:
    """Return a value that differs from the default one, even where that is zero."""
    if parameter.value is None:
        low, high = bounds(parameter) if parameter.range else (0.6, 1.2)
        return (low + high) / 2 + (high - low) / 2 * part
    value = evaluate(parameter.value, {})
    usual = USUAL_ANGLE if parameter.dimension == ANGLE else USUAL_PART * longest
    return value + STEP * part * max(abs(value), usual) * bool(number)
