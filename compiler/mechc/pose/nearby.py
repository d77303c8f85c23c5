"""The default pose in numbers, and poses near it, for what algebra does not see into."""

import math
from collections.abc import Iterable

from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..model.mechanism import Mechanism, Parameter
from .pose import Definition

NUMBER = 4
STEP = 0.02

Values = dict[str, float]


def poses_nearby(mechanism: Mechanism, definitions: Iterable[Definition]) -> list[Values]:
    """Return the default pose and some others; what has no value gets one in the others only."""
    known = tuple(definitions)
    return [_pose(mechanism, known, number) for number in range(NUMBER)]


def _pose(mechanism: Mechanism, definitions: Iterable[Definition], number: int) -> Values:
    values: Values = {}
    dependent: list[tuple[str, Formula]] = []
    for i, parameter in enumerate(mechanism.parameters):
        if parameter.dependent and parameter.value is not None:
            dependent.append((parameter.name, parameter.value))
        elif number or parameter.value is not None:
            values[parameter.name] = _moved(parameter, math.sin(1 + 7 * number + i), number)
    for name, formula in (*dependent, *definitions):
        if symbols(formula) <= values.keys():
            values[name] = evaluate(formula, values)
    return values


def _moved(parameter: Parameter, part: float, number: int) -> float:
    if parameter.value is None:
        return 0.9 + 0.3 * part
    return evaluate(parameter.value, {}) * (1 + STEP * part * bool(number))
