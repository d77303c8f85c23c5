"""Ratios with friction along one parameter each, evaluated once for all that is asked of them."""

from ..formula.walk import symbols
from ..friction.solution import Solution
from ..model.mechanism import LoadForm, LoadRatio, Mechanism, Sense, WithFriction
from ..model.result import FrictionResult, Result
from .states import Moving
from .sweep import Code, Sweep


class Study:
    """What is looked at in a mechanism with friction: locking, jams and efficiencies alike."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution
        self.mechanism = solution.plan.graph.pose.mechanism
        self._code = Code(solution.plan)
        self._moving: dict[tuple[str, Sense, str], Moving] = {}
        self._sweep: dict[tuple[str, frozenset[str]], Sweep] = {}

    def ideal(self, of: LoadRatio | LoadForm) -> Result:
        """Return the ratio without friction."""
        return next(r for r in self.solution.results if r.target == of)

    def real(self, of: LoadRatio | LoadForm, sense: Sense) -> FrictionResult:
        """Return the ratio with friction."""
        found = (r for r in self.solution.results if isinstance(r, FrictionResult))
        return next(r for r in found if r.target == WithFriction(of, sense))

    def moving(self, of: LoadRatio | LoadForm, sense: Sense, parameter: str) -> Moving | None:
        """Return a ratio along a parameter; None where loads without a size are in it."""
        ideal, real = self.ideal(of), self.real(of, sense)
        key = ideal.name, sense, parameter
        loads = sizes(self.mechanism, real)
        if loads is None:
            return None
        if key not in self._moving:
            self._moving[key] = Moving(self._along(parameter, loads), ideal, real, sense)
        return self._moving[key]

    def _along(self, parameter: str, loads: dict[str, float]) -> Sweep:
        """Return the sweep along a parameter: poses are the same in both senses of motion."""
        key = parameter, frozenset(loads)
        if key not in self._sweep:
            self._sweep[key] = Sweep(self.solution.plan, parameter, loads, self._code)
        return self._sweep[key]


def sizes(mechanism: Mechanism, real: Result) -> dict[str, float] | None:
    """Return sizes for loads without one: any will do for one load, for several none."""
    loads = {load.name for load in mechanism.loads}
    formulas = [real.formula, *(d.formula for d in real.where)]
    known = {d.name for d in real.where}
    missing = {s for f in formulas for s in symbols(f)} & loads - known
    return dict.fromkeys(missing, 1.0) if len(missing) < 2 else None
