"""Poses to judge at: the default one, then feasible ones drawn from the parameters' ranges."""

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from random import Random

from ..formula.walk import evaluate, symbols
from ..model.mechanism import Mechanism, Parameter, Require
from ..pose.pose import Pose
from ..units import ANGLE

Values = dict[str, float]

CLOSE_TO_DEFAULT = 0.2
"""A parameter with a value and no range is drawn within this part of its value."""

COMPARE: Mapping[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "=": partial(math.isclose, rel_tol=1e-9, abs_tol=1e-12),
    "!=": operator.ne,
}


class Replay:
    """A stream of poses that can be gone through again from its start; each is drawn once."""

    def __init__(self, stream: Iterator[Values]) -> None:
        self._stream = stream
        self._seen: list[Values] = []

    def __iter__(self) -> Iterator[Values]:
        yield from self._seen
        for values in self._stream:
            self._seen.append(values)
            yield values


def candidates(pose: Pose, number: int) -> Iterator[Values]:
    """Yield the default pose, if it is feasible, and up to ``number`` random feasible ones.

    The draws depend on the mechanism's name only, so that every compile sees the same.
    """
    dice = Random(pose.mechanism.name)
    for turn in range(number + 1):
        draw = _at_default if turn == 0 else _near
        parameters = {p.name: draw(p, dice) for p in _free(pose)}
        values = settle(pose, parameters, dice)
        if values is not None:
            yield values


def settle(pose: Pose, parameters: Mapping[str, float], dice: Random) -> Values | None:
    """Return the values of all symbols at given parameters, None where there is no such pose.

    A made-up length that no loop fixes is drawn; no result may depend on it.
    """
    values = dict(parameters)
    for definition in pose.definitions:
        values[definition.name] = evaluate(definition.formula, values)
    for name, length in pose.placeholders.items():
        values[name] = dice.uniform(0.5, 2) if length is None else length.evaluate(values)
    _add_dependent(pose.mechanism, values)
    finite = all(map(math.isfinite, values.values()))
    return values if finite and _allowed(pose.mechanism, values) else None


def _free(pose: Pose) -> list[Parameter]:
    return [p for p in pose.mechanism.parameters if p.name in pose.free]


def _at_default(parameter: Parameter, dice: Random) -> float:
    if parameter.value is None:
        return _near(parameter, dice)
    return evaluate(parameter.value, {})


def _near(parameter: Parameter, dice: Random) -> float:
    if parameter.range is not None:
        low, high = (evaluate(end, {}) for end in parameter.range)
    elif parameter.value is not None:
        value = evaluate(parameter.value, {})
        low, high = value * (1 - CLOSE_TO_DEFAULT), value * (1 + CLOSE_TO_DEFAULT)
    elif parameter.dimension == ANGLE:
        low, high = math.radians(5), math.radians(85)
    else:
        low, high = 0.5, 2.0
    return dice.uniform(low, high)


def _add_dependent(mechanism: Mechanism, values: Values) -> None:
    """Add the dependent parameters and the lets that follow from parameters alone."""
    formulas = {p.name: p.value for p in mechanism.parameters if p.dependent and p.value}
    formulas.update({let.name: let.value for let in mechanism.lets})
    waiting = {name: formula for name, formula in formulas.items() if name not in values}
    while ready := [name for name, f in waiting.items() if symbols(f) <= values.keys()]:
        for name in ready:
            values[name] = evaluate(waiting.pop(name), values)


def _allowed(mechanism: Mechanism, values: Values) -> bool:
    return all(_holds(condition, values) for condition in mechanism.requires)


def _holds(condition: Require, values: Values) -> bool:
    """Return whether a condition holds; one on loads or results cannot be judged here."""
    if not symbols(condition.left) | symbols(condition.right) <= values.keys():
        return True
    left, right = evaluate(condition.left, values), evaluate(condition.right, values)
    return COMPARE[condition.operator](left, right)
