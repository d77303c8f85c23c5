"""Values along the drive: parameters, what follows from them, results."""

import math
from collections.abc import Mapping

from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..model.mechanism import Mechanism, Require
from ..model.result import Result
from ..pose.pose import Pose

NOT_ASSEMBLED = "cannot be assembled"
EXCLUDED = "excluded by a condition of use"


class Along:
    """Evaluates formulas at places of the drive, the other parameters at their defaults."""

    def __init__(self, pose: Pose, lets: Mapping[str, Formula]) -> None:
        self._mechanism: Mechanism = pose.mechanism
        assert pose.mechanism.drive is not None
        self._drive = pose.mechanism.drive.parameter
        parameters = pose.mechanism.parameters
        self.defaults = {
            p.name: evaluate(p.value, {}) for p in parameters if p.value and not p.dependent
        }
        dependent = {p.name: p.value for p in parameters if p.dependent and p.value}
        self._definitions = {**dict(pose.definitions)}
        self._chain = {**dependent, **self._definitions, **lets}
        self._open = dict.fromkeys(pose.placeholders, 1.0)
        self._known: dict[float, Mapping[str, float]] = {}

    def values(self, place: float) -> Mapping[str, float]:
        """Return all that has a value at a place of the drive."""
        if place not in self._known:
            self._known[place] = self._follow({**self._open, **self.defaults, self._drive: place})
        return self._known[place]

    def _follow(self, values: dict[str, float]) -> Mapping[str, float]:
        waiting = dict(self._chain)
        while ready := [n for n, f in waiting.items() if symbols(f) <= values.keys()]:
            for name in ready:
                values[name] = evaluate(waiting.pop(name), values)
        return values

    def of(self, formula: Formula, where: Result | None, place: float) -> float:
        """Return a formula's value, with the definitions of a result; NaN where it has none."""
        values = dict(self.values(place))
        for name, inner in where.where if where else ():
            if name not in values and symbols(inner) <= values.keys():
                values[name] = evaluate(inner, values)
        return evaluate(formula, values) if symbols(formula) <= values.keys() else math.nan

    def trouble(self, place: float) -> str:
        """Return why there is no pose at a place, '' where there is one."""
        values = self.values(place)
        if not all(math.isfinite(values[name]) for name in self._definitions if name in values):
            return NOT_ASSEMBLED
        broken = (r for r in self._mechanism.requires if not _holds(r, values))
        return EXCLUDED if next(broken, None) else ""


def _holds(require: Require, values: Mapping[str, float]) -> bool:
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
