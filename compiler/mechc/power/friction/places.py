"""Results where one parameter varies and the others stand at their values."""

import math
from collections.abc import Mapping

from ...formula.tree import Formula
from ...formula.walk import Evaluation, evaluate, symbols
from ...kinematics.plan import Plan
from ...model.result import Definition, Result
from ...model.values import Chain, allowed, defaults, dependent


class Places:
    """Evaluates results; ``loads`` are sizes of loads that nobody gives."""

    def __init__(self, plan: Plan, parameter: str, loads: Mapping[str, float]) -> None:
        pose = plan.graph.pose
        self._mechanism = pose.mechanism
        self._parameter = parameter
        self.defaults = {**loads, **defaults(pose.mechanism)}
        lets = {let.name: let.value for let in pose.mechanism.lets}
        self._formulas = {**dependent(pose.mechanism), **dict(pose.definitions), **lets}
        self._chain = Chain(self._formulas)
        self._known: dict[float, dict[str, float]] = {}
        self._needed: dict[int, list[tuple[Definition, frozenset[str]]]] = {}

    def values(self, place: float) -> dict[str, float]:
        """Return all that has a value at a place; nothing where no pose is allowed."""
        if place not in self._known:
            values = self._chain.complete({**self.defaults, self._parameter: place})
            self._known[place] = values if allowed(self._mechanism, values) else {}
        return self._known[place]

    def varying(self, result: Result) -> set[str]:
        """Return the parameter and the names that vary with it, those of a result among them."""
        formulas = {**self._formulas, **dict(result.where)}
        needed = {name: symbols(formula) for name, formula in formulas.items()}
        varying, before = {self._parameter}, 0
        while len(varying) > before:
            before = len(varying)
            varying |= {n for n, needs in needed.items() if not varying.isdisjoint(needs)}
        return varying

    def of(self, result: Result, place: float) -> float:
        """Return a result's value, NaN where it has none."""
        return value(result.formula, self.named(result, place))

    def named(self, result: Result, place: float) -> dict[str, float]:
        """Return what has a value at a place, the names that a result mentions among it."""
        key = id(result.where)
        if key not in self._needed:
            self._needed[key] = [(d, symbols(d.formula)) for d in result.where]
        found = dict(self.values(place))
        here = Evaluation(found)
        for (name, formula), needs in self._needed[key]:
            if name not in found and needs <= found.keys():
                found[name] = here.of(formula)
        return found


def value(formula: Formula, values: Mapping[str, float]) -> float:
    """Return the value of a formula, NaN where something in it has none."""
    return evaluate(formula, values) if symbols(formula) <= values.keys() else math.nan
