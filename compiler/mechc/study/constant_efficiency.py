"""How far a constant efficiency is from the truth: against friction, and near dead centres.

With the angle δ by which friction turns a rod's line of force, a ratio k changes by
|dk/dφ|·δ, so that the efficiency is about 1/(1 + |d ln k/dφ|·δ).
"""

import math
from collections.abc import Iterator

from ..diagnostics import Report
from ..diagnostics import friction as messages
from ..formula.evaluate import evaluate
from ..formula.numeric.roots import spaced
from ..formula.walk import symbols
from ..friction.problem import FrictionProblem
from ..friction.results import by_coefficients
from ..friction.solution import FrictionSolution
from ..model.mechanism import Find, LoadForm, LoadRatio, WithFriction
from ..model.result import FrictionResult, Result
from ..model.values import range_of
from .pose_sweep import PoseCode
from .ratios import sizes
from .sampling import sampled_values
from .states import FrictionRatios, IdealRatio, RatioAlong
from .sweep import Sweep
from .tolerances import DIFFERENCE
from .variables import moved, shown, spans, turns

SAME_CONSTANT = 0.05
"""By so much a constant may miss the efficiency that friction makes."""

STEEP_LOGARITHM = 8.0
"""|d ln k/dφ| per radian at which pins of an eighth of a rod's length with f = 0.1, δ = 0.0125,
take a tenth of the force."""

RANGE_CELLS = 48
"""Cells of a range whose ends are looked at for steep ratios."""


def remark_on_constant(solution: FrictionSolution, report: Report) -> None:
    """Warn where an efficiency given as one number is far from the truth."""
    problem = FrictionProblem(solution.balance, Report(report.source))
    for find in problem.mechanism.finds:
        if isinstance(find.target, WithFriction):
            ideal = next(r for r in solution.results if r.target == find.target.of)
            real = _by_coefficients(problem, find, find.target, ideal)
            if real is not None:
                _Comparison(solution, find, ideal, real).remark(report)
            elif where := list(_steep(solution, ideal)):
                report.add(messages.efficiency_near_dead_centre(find.span, ideal.name, where))


def _by_coefficients(
    problem: FrictionProblem, find: Find, target: WithFriction, ideal: Result
) -> FrictionResult | None:
    """Return the result that the joints' friction makes; None where they have none, or forces."""
    if not problem.mechanism.friction.joints or not isinstance(target.of, LoadRatio | LoadForm):
        return None
    found = by_coefficients(problem, find, ideal, target.of, target.sense)
    return found.result if found else None


# ------------------------------------------------------------------ with friction, too


class _Comparison:
    """A constant efficiency against the one that friction makes."""

    def __init__(
        self, solution: FrictionSolution, find: Find, ideal: Result, real: FrictionResult
    ) -> None:
        assert isinstance(find.target, WithFriction)
        self._solution, self._find = solution, find
        self._ideal, self._real = ideal, real
        self._ratios = FrictionRatios(IdealRatio(ideal), real, find.target.sense)
        self._mechanism = solution.plan.graph.pose.mechanism
        self._loads = sizes(self._mechanism, real)
        self._code = PoseCode(solution.plan)

    def remark(self, report: Report) -> None:
        """Warn where both differ much, at the default pose or on a range."""
        if self._loads is None:
            return
        here = self._moving("")
        found = (
            [f"{here.efficiency(0.0):.3g} at the default pose"] if self._is_far(here, 0.0) else []
        )
        for name in moved(self._mechanism, (self._ideal, self._real)):
            found += self._along(name)
        if found:
            given = self._given(here, 0.0)
            report.add(messages.efficiency_beside_friction(self._find.span, given, found))

    def _moving(self, name: str) -> RatioAlong:
        sweep = Sweep(self._code, name, loads=self._loads)
        return self._ratios.along(self._ratios.ideal_along(sweep))

    def _given(self, moving: RatioAlong, x: float) -> float:
        efficiency, values = self._mechanism.friction.efficiency, moving.sweep.values(x)
        known = efficiency is not None and symbols(efficiency) <= values.keys()
        return evaluate(efficiency, values) if efficiency is not None and known else math.nan

    def _is_far(self, moving: RatioAlong, x: float) -> bool:
        return abs(self._given(moving, x) - moving.efficiency(x)) > SAME_CONSTANT

    def _along(self, name: str) -> Iterator[str]:
        """Yield the efficiencies with friction over ranges where they differ from the given one."""
        ends, moving = range_of(name, self._mechanism), self._moving(name)
        if ends is None:
            return
        grid = sampled_values(moving, *ends)
        for part in spans(grid, lambda x: self._is_far(moving, x)):
            inside = [x for x in grid if part[0] <= x <= part[1]]
            values = [moving.efficiency(x) for x in (*part, *inside)]
            span = shown(name, part, self._mechanism)
            yield f"{min(values):.3g} … {max(values):.3g} for {span}"


# ------------------------------------------------------------------- near dead centres


def _steep(solution: FrictionSolution, ideal: Result) -> Iterator[str]:
    """Yield where a ratio changes so fast that friction takes much."""
    mechanism = solution.plan.graph.pose.mechanism
    loads = sizes(mechanism, ideal)
    if loads is None or ideal.default is None:
        return
    code = PoseCode(solution.plan)
    for name in moved(mechanism, (ideal,)):
        sweep, ends = Sweep(code, name, loads=loads), range_of(name, mechanism)
        here = sweep.defaults[name]
        whole = ends or (here, here)
        scale = 1.0 if turns(name, mechanism) else whole[1] - whole[0]
        slope = _Slope(sweep, ideal, scale)
        if ends:
            for part in spans(spaced(*ends, RANGE_CELLS), slope.is_steep):
                yield f"for {shown(name, part, mechanism)}"
        elif scale and slope.is_steep(here):
            yield f"at the default {name}"


class _Slope:
    """The logarithmic slope of a ratio along a parameter, per radian or per stroke."""

    def __init__(self, sweep: Sweep, ideal: Result, scale: float) -> None:
        self._sweep, self._ideal, self._scale = sweep, ideal, scale

    def is_steep(self, x: float) -> bool:
        """Return whether the ratio changes fast, passes zero or has no value."""
        step, here = DIFFERENCE * self._scale, self._sweep.value_of(self._ideal, x)
        before, after = (self._sweep.value_of(self._ideal, x + s) for s in (-step, step))
        first, last = (v if math.isfinite(v) else here for v in (before, after))
        if not first * last > 0:
            return True
        width = DIFFERENCE * (math.isfinite(before) + math.isfinite(after))
        return abs(math.log(last / first)) > STEEP_LOGARITHM * width
