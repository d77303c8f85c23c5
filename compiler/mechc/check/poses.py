"""Poses to compare formulas at: the default one, then random ones within the ranges.

Values are SI and radians. The draw is seeded, so that two runs see the same poses.
"""

import math
import random
from collections.abc import Iterator, Mapping
from itertools import islice

from ..formula.walk import evaluate, symbols
from ..model.mechanism import Mechanism, Parameter, Require
from ..units import ANGLE

Values = Mapping[str, float]

TRIES = 200
"""Draws before a narrow ``require`` is given up."""


def default_pose(mechanism: Mechanism) -> Values:
    """Return the values that the user gave, those that follow from them included.

    A parameter declared by dimension only is missing.
    """
    given = {p.name: evaluate(p.value, {}) for p in _independent(mechanism) if p.value}
    return complete(mechanism, given)


def complete(mechanism: Mechanism, given: Values) -> Values:
    """Return the values with the dependent parameters that follow from them."""
    values = dict(given)
    for parameter in mechanism.parameters:
        if parameter.dependent and parameter.value and parameter.name not in given:
            _follow(parameter.name, mechanism, values)
    return values


def _follow(name: str, mechanism: Mechanism, values: dict[str, float]) -> None:
    """Evaluate a dependent parameter after those it needs, wherever they were declared."""
    formulas = {p.name: p.value for p in mechanism.parameters if p.dependent and p.value}
    stack = [name]
    while stack:
        formula = formulas[stack[-1]]
        missing = [s for s in sorted(symbols(formula)) if s in formulas and s not in values]
        if missing:
            stack.append(missing[0])
        elif symbols(formula) <= values.keys():
            values[stack.pop()] = evaluate(formula, values)
        else:
            return


def random_poses(mechanism: Mechanism, number: int, seed: int = 1) -> Iterator[Values]:
    """Yield up to ``number`` poses that every ``require`` allows."""
    chance = random.Random(seed)
    drawn = (_draw(mechanism, chance) for _ in range(TRIES))
    return islice((v for v in drawn if allowed(mechanism, v)), number)


def _draw(mechanism: Mechanism, chance: random.Random) -> Values:
    given = {p.name: chance.uniform(*bounds(p)) for p in _independent(mechanism)}
    return complete(mechanism, given)


def bounds(parameter: Parameter) -> tuple[float, float]:
    """Return the range to draw from: the user's, or one about the value, or a usual one."""
    if parameter.range:
        return evaluate(parameter.range.low, {}), evaluate(parameter.range.high, {})
    if parameter.value and not parameter.dependent:
        value = evaluate(parameter.value, {})
        return value * 0.8, value * 1.25
    return (0.1, 1.4) if parameter.dimension == ANGLE else (0.5, 2.0)


def allowed(mechanism: Mechanism, values: Values) -> bool:
    """Return whether every ``require`` that can be evaluated holds."""
    return all(_holds(r, values) for r in mechanism.requires)


def _holds(require: Require, values: Values) -> bool:
    if not symbols(require.left) | symbols(require.right) <= values.keys():
        return True
    left, right = evaluate(require.left, values), evaluate(require.right, values)
    match require.operator:
        case "<":
            return left < right
        case "<=":
            return left <= right
        case ">":
            return left > right
        case ">=":
            return left >= right
        case "=":
            return math.isclose(left, right, rel_tol=1e-12)
        case "!=":
            return left != right


def _independent(mechanism: Mechanism) -> tuple[Parameter, ...]:
    return tuple(p for p in mechanism.parameters if not p.dependent)
