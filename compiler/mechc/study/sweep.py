"""Results where one parameter varies and the others stand at their values."""

import math
from collections.abc import Mapping

from ..formula.rounding import Rounding, beyond_rounding
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..kinematics.plan import Plan
from ..model.result import Result
from ..model.values import Chain, allowed, compare, defaults, dependent

VALUE, LEFT, RIGHT = "=", "<", ">"
"""What a result's value, and the sides of its guards, are called, next to its definitions."""


class Code:
    """The formulas of a pose and of results as code, the same whatever parameter varies."""

    def __init__(self, plan: Plan) -> None:
        pose = plan.graph.pose
        lets = {let.name: let.value for let in pose.mechanism.lets}
        self.formulas = {**dependent(pose.mechanism), **dict(pose.definitions), **lets}
        self.pose = Chain(self.formulas)
        self._closing = tuple(definition.name for definition in pose.definitions)
        self._results: dict[int, tuple[Result, Chain]] = {}

    def closes(self, values: Mapping[str, float]) -> bool:
        """Return whether loops close with values: nothing that closes them is undefined."""
        return not any(math.isnan(values.get(name, 0.0)) for name in self._closing)

    def of(self, result: Result) -> Chain:
        """Return a result's definitions, its value and the sides of its guards."""
        if id(result) not in self._results:
            self._results[id(result)] = result, Chain(_formulas(result))
        return self._results[id(result)][1]


class Sweep:
    """Evaluates results; ``loads`` are sizes of loads that nobody gives."""

    def __init__(
        self, plan: Plan, parameter: str, loads: Mapping[str, float], code: Code | None = None
    ) -> None:
        self._mechanism = plan.graph.pose.mechanism
        self._parameter = parameter
        self.defaults = {**loads, **defaults(self._mechanism)}
        self._code = code or Code(plan)
        self._known: dict[float, dict[str, float]] = {}
        self._found: dict[tuple[int, float], float] = {}
        self._sizes: dict[tuple[int, float], float | None] = {}
        self._rounding: dict[float, Rounding] = {}
        self._last: tuple[Result, float, dict[str, float]] | None = None

    def values(self, x: float) -> dict[str, float]:
        """Return the values of all names that have one; nothing where no pose is allowed.

        Nor is there anything where a loop does not close, be it one that a result does not rest on.
        """
        if x not in self._known:
            values = self._code.pose.complete({**self.defaults, self._parameter: x})
            is_pose = self._code.closes(values) and allowed(self._mechanism, values)
            self._known[x] = values if is_pose else {}
        return self._known[x]

    @property
    def default(self) -> float:
        """Return the parameter's own value; any value where it is none of the mechanism."""
        return self.defaults.get(self._parameter, 0.0)

    def beyond_rounding(self, result: Result, x: float) -> float | None:
        """Return a result's value without what is nothing but rounding; None where it has none."""
        key = id(result), x
        if key not in self._sizes:
            number, rounding = self.of(result, x), self._rounding_at(x)
            size = beyond_rounding(number, result.formula, result.where, rounding)
            self._sizes[key] = size.number
        return self._sizes[key]

    def _rounding_at(self, x: float) -> Rounding:
        if x not in self._rounding:
            rounding = Rounding({**self.defaults, self._parameter: x})
            rounding.define(self._code.pose.definitions)
            self._rounding[x] = rounding
        return self._rounding[x]

    def varying(self, result: Result) -> set[str]:
        """Return the parameter and the names that vary with it, those of a result among them."""
        formulas = {**self._code.formulas, **dict(result.where)}
        needed = {name: symbols(formula) for name, formula in formulas.items()}
        varying, before = {self._parameter}, 0
        while len(varying) > before:
            before = len(varying)
            varying |= {n for n, needs in needed.items() if not varying.isdisjoint(needs)}
        return varying

    def of(self, result: Result, x: float) -> float:
        """Return a result's value, NaN where it has none."""
        key = id(result), x
        if key not in self._found:
            self._found[key] = self.named(result, x).get(VALUE, math.nan)
        return self._found[key]

    def named(self, result: Result, x: float) -> dict[str, float]:
        """Return the values at ``x``, those of the names in a result among them."""
        if self._last and self._last[0] is result and self._last[1] == x:
            return self._last[2]
        found = self._code.of(result).complete(self.values(x))
        self._last = result, x, found
        return found


def guarded(result: Result, values: Mapping[str, float]) -> float:
    """Return a result among all that has a value, NaN where a guard does not hold."""
    sides = (
        (values.get(f"{LEFT}{i}"), guard.operator, values.get(f"{RIGHT}{i}"))
        for i, guard in enumerate(result.guards)
    )
    sound = all(a is None or b is None or compare(a, sign, b) for a, sign, b in sides)
    return values.get(VALUE, math.nan) if sound else math.nan


def _formulas(result: Result) -> dict[str, Formula]:
    """Return a result's definitions, and with them its value and the sides of its guards."""
    found = {**dict(result.where), VALUE: result.formula}
    for i, guard in enumerate(result.guards):
        found |= {f"{LEFT}{i}": guard.left, f"{RIGHT}{i}": guard.right}
    return found
