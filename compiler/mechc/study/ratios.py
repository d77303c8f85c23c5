"""Ratios with friction along one parameter each, evaluated once for all that is asked of them."""

import math
from collections.abc import Iterator, Sequence

from ..base.frozen import replace
from ..formula.walk import reached, symbols
from ..friction.solution import FrictionSolution
from ..model.mechanism import Efficiency, LoadForm, LoadRatio, Mechanism, Sense, WithFriction
from ..model.parts.friction import GuideFriction, PinFriction
from ..model.result import FrictionResult, Result
from ..model.values import range_of
from .locking_intervals import USUAL, EfficiencyRange, Range
from .pose_sweep import PoseCode
from .sampling import sampled_values
from .states import FrictionRatios, IdealAlong, IdealRatio, RatioAlong
from .sweep import Sweep
from .tolerances import SAME_EFFICIENCY
from .variables import moved, spans, unit_of, varying

IdealKey = tuple[str, bool, str, frozenset[str]]
"""A ratio without friction: its name, whether friction is idle, the parameter, loads of no size."""

RealKey = tuple[str, Sense]
"""A ratio with friction: the name of the one without, and the sense of motion."""

SweepKey = tuple[str, frozenset[str]]
"""A parameter, and the loads without a size."""


class FrictionStudy:
    """The ratios of one mechanism with and without friction, each kept for all that asks for it.

    Locking, jams and efficiencies are found from the same ratios.
    """

    def __init__(self, solution: FrictionSolution) -> None:
        self.solution = solution
        self.mechanism = solution.plan.graph.pose.mechanism
        self._code = PoseCode(solution.plan)
        self._ideals: dict[str, IdealRatio] = {}
        self._ideals_along: dict[IdealKey, IdealAlong] = {}
        self._ratios: dict[RealKey, FrictionRatios] = {}
        self._moving: dict[tuple[RealKey, str], RatioAlong] = {}
        self._sweep: dict[SweepKey, Sweep] = {}

    def ideal(self, of: LoadRatio | LoadForm) -> Result:
        """Return the ratio without friction."""
        return next(r for r in self.solution.results if r.target == of)

    def real(self, of: LoadRatio | LoadForm, sense: Sense) -> FrictionResult:
        """Return the ratio with friction."""
        found = (r for r in self.solution.results if isinstance(r, FrictionResult))
        return next(r for r in found if r.target == WithFriction(of, sense))

    def moving(self, of: LoadRatio | LoadForm, sense: Sense, parameter: str) -> RatioAlong | None:
        """Return a ratio along a parameter; None where loads without a size are in it."""
        ideal, real = self.ideal(of), self.real(of, sense)
        key = (ideal.name, sense), parameter
        loads = sizes(self.mechanism, real)
        if loads is None:
            return None
        if key not in self._moving:
            ratios = self._both(ideal, real, sense)
            self._moving[key] = ratios.along(self._ideal_along(ratios, parameter, loads))
        return self._moving[key]

    def _both(self, ideal: Result, real: FrictionResult, sense: Sense) -> FrictionRatios:
        """Return the ratio without friction and the one with it, the same for all parameters."""
        key = ideal.name, sense
        if key not in self._ratios:
            known = self._ideals.setdefault(ideal.name, IdealRatio(ideal))
            self._ratios[key] = FrictionRatios(known, real, sense)
        return self._ratios[key]

    def _ideal_along(
        self, of: FrictionRatios, parameter: str, loads: dict[str, float]
    ) -> IdealAlong:
        """Return the ratio without friction along a parameter, the same in both senses."""
        key = of.ideal.result.name, of.real.is_idle, parameter, frozenset(loads)
        if key not in self._ideals_along:
            self._ideals_along[key] = of.ideal_along(self._along(parameter, loads))
        return self._ideals_along[key]

    def _along(self, parameter: str, loads: dict[str, float]) -> Sweep:
        """Return the sweep along a parameter: poses are the same in both senses of motion."""
        key = parameter, frozenset(loads)
        if key not in self._sweep:
            self._sweep[key] = Sweep(self._code, parameter, loads=loads)
        return self._sweep[key]


def sizes(mechanism: Mechanism, real: Result) -> dict[str, float] | None:
    """Return sizes for loads without one: any will do for one load, for several none."""
    loads = {load.name for load in mechanism.loads}
    formulas = [real.formula, *(d.formula for d in real.where)]
    known = {d.name for d in real.where}
    missing = {s for f in formulas for s in symbols(f)} & loads - known
    return dict.fromkeys(missing, 1.0) if len(missing) < 2 else None


def efficiency_ranges(study: FrictionStudy, efficiency: Result) -> Iterator[EfficiencyRange]:
    """Yield through what an efficiency runs over each range that it depends on.

    One that is constant over a range is left out, as nobody asks for it; not so where the range is
    one of motion and the formula that is printed has its parameter, as if that mattered.
    """
    assert isinstance(efficiency.target, Efficiency)
    of, sense = efficiency.target.of, efficiency.target.sense
    both, mechanism = (study.ideal(of), study.real(of, sense)), study.mechanism
    moving_and_printed = _printed(efficiency).intersection(moved(mechanism, both))
    is_of_joints = any(
        isinstance(p, PinFriction | GuideFriction) for p in mechanism.friction.joints
    )
    for name in varying(mechanism, both):
        ends, moving = range_of(name, mechanism), study.moving(of, sense, name)
        found = _efficiency_range(moving, name, ends, mechanism) if moving and ends else None
        if found and (name in moving_and_printed or not _is_constant(found)):
            yield replace(found, is_of_joints=is_of_joints)


def _is_constant(found: EfficiencyRange) -> bool:
    return found.greatest - found.least <= SAME_EFFICIENCY


def _printed(efficiency: Result) -> set[str]:
    """Return the names that an efficiency is printed with, and what these rest on."""
    case = efficiency.case if isinstance(efficiency, FrictionResult) else None
    printed = case or efficiency
    return reached(symbols(printed.formula), {d.name: d.formula for d in printed.where})


def _efficiency_range(
    moving: RatioAlong, name: str, ends: Range, mechanism: Mechanism
) -> EfficiencyRange | None:
    """Return the least and the greatest of an efficiency in a range; None where it has none."""
    grid = sampled_values(moving, *ends)
    values = [v for x in grid if math.isfinite(v := moving.efficiency(x))]
    if not values:
        return None
    usual = tuple(_with_usual_efficiency(moving, grid))
    return EfficiencyRange(name, unit_of(name, mechanism), ends, min(values), max(values), usual)


def _with_usual_efficiency(moving: RatioAlong, grid: Sequence[float]) -> Iterator[Range]:
    """Yield the intervals on which an efficiency is usual, also where it only passes through it."""
    (low, high), efficiency = USUAL, moving.efficiency
    enough = spans(grid, lambda x: efficiency(x) >= low, lambda x: efficiency(x) - low)
    for first, last in list(enough):
        part = [first, *(x for x in grid if first < x < last), last]
        yield from spans(part, lambda x: efficiency(x) <= high, lambda x: high - efficiency(x))
