"""What is run along: a stroke, the results that have values on it, where they are looked at.

Where a loop comes to its end, what it finds varies as the root of the distance from there: there
values are spaced evenly by that root. Where a loop that lies flat can go on, nothing does.
"""

from collections.abc import Callable, Iterator, Sequence

from ...base.frozen import frozen, replace
from ...formula.numeric.roots import spaced
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...friction.solution import FrictionSolution
from ...model.mechanism import (
    Axial,
    LoadForm,
    LoadRatio,
    Mechanism,
    Normal,
    Parameter,
    Reaction,
    ResultTarget,
    SpeedRatio,
    WithFriction,
)
from ...pose.pose import Pose
from ..analysis import Analysis
from ..pose_sweep import PoseCode
from ..sweep import Sweep
from .branches import branch_points
from .stroke import ChangePoint, StrokeInterval

SAMPLES = 720
"""Cells in which the stroke is looked at for singular poses and extrema."""


ENOUGH = 180
"""Values that are enough for a stretch."""


GRADED = 16
"""Cells that one next to the end of a loop is divided into."""


def looked_at(stretch: StrokeInterval, grid: Sequence[float]) -> list[float]:
    """Return values in a stretch, those that were looked at already where they are enough."""
    inner = [x for x in grid if stretch.low < x < stretch.high]
    if len(inner) < ENOUGH:
        inner = spaced(stretch.low, stretch.high, SAMPLES)[1:-1]
    first = graded(stretch.low, inner[0]) if stretch.before else ()
    last = graded(stretch.high, inner[-1]) if stretch.after else ()
    return sorted({stretch.low, *first, *inner, *last, stretch.high})


def graded(root: float, far: float) -> Iterator[float]:
    """Yield values between an end and another value, evenly by the root of the distance."""
    yield from (root + (far - root) * (i / GRADED) ** 2 for i in range(1, GRADED))


@frozen
class StrokeRun:
    """A stroke from ``low`` to ``high`` of the drive, and the ``results`` that have values on it.

    ``open`` names the others, with the loads whose size nobody gives. ``grid`` lies evenly
    along it; at the ``branches`` a loop lies flat.
    """

    solution: FrictionSolution
    drive: Parameter
    low: float
    high: float
    along: Sweep
    results: tuple[Analysis, ...]
    open: tuple[tuple[str, tuple[str, ...]], ...]
    grid: tuple[float, ...]
    branches: tuple[ChangePoint, ...]

    @property
    def pose(self) -> Pose:
        """Return the pose, as it depends on the drive."""
        return self.solution.plan.graph.pose

    @property
    def range(self) -> float:
        """Return how far the drive moves."""
        return self.high - self.low

    @property
    def ratios(self) -> list[Analysis]:
        """Return the results that are ratios of loads."""
        return [result for result in self.results if isinstance(result.target, LoadRatio)]

    @property
    def quotients(self) -> list[Analysis]:
        """Return the results that are ratios of loads or of speeds."""
        return [r for r in self.results if isinstance(r.target, LoadRatio | SpeedRatio)]

    @property
    def forms(self) -> list[Analysis]:
        """Return the loads that are found from all others."""
        return [r for r in self.results if isinstance(r.target, LoadForm)]

    @property
    def first_order(self) -> list[Analysis]:
        """Return the ratios and loads with friction to first order."""
        return [
            r
            for r in self.results
            if isinstance(r.target, WithFriction)
            and r.target.order == "first"
            and isinstance(r.target.of, LoadRatio | LoadForm)
        ]

    @property
    def signed(self) -> list[Analysis]:
        """Return the forces at joints that have a sign: components, and forces along rods."""
        return [r for r in self.results if has_sign(r.target)]

    def values(self, formula: Formula, of: Analysis) -> Callable[[float], float]:
        """Return a formula of a result as a function of the drive."""
        return self.along.function(formula, of)

    def within(self, stretch: StrokeInterval) -> list[float]:
        """Return the values at which a stretch is looked at."""
        return looked_at(stretch, self.grid)


def has_sign(target: ResultTarget | None) -> bool:
    """Return whether a result is a force with a sign: a component, one in a rod or of a guide.

    A magnitude has none; forces with friction to first order are not looked at.
    """
    match target:
        case WithFriction(of=force, order="exact"):
            return has_sign(force)
        case Reaction(part=part):
            return part in ("x", "y")
        case Axial() | Normal():
            return True
        case _:
            return False


def run_of(
    solution: FrictionSolution,
    results: Sequence[Analysis],
    drive: Parameter,
    low: float,
    high: float,
) -> StrokeRun:
    """Return the run of the drive between two ends."""
    pose = solution.plan.graph.pose
    along = Sweep(PoseCode(solution.plan), drive.name, (low, high))
    shown = [r for r in results if r.default is not None or r.target is not None]
    shown = [_in_code(r, solution) for r in shown]
    without = {r.name: _loads_without_size(r, pose.mechanism) for r in shown}
    valued = tuple(r for r in shown if not without[r.name])
    open_ = tuple((r.name, without[r.name]) for r in shown if without[r.name])
    grid = tuple(spaced(low, high, SAMPLES))
    branches = tuple(branch_points(pose, along, grid))
    return StrokeRun(
        solution=solution,
        drive=drive,
        low=low,
        high=high,
        along=along,
        results=valued,
        open=open_,
        grid=grid,
        branches=branches,
    )


def _loads_without_size(result: Analysis, mechanism: Mechanism) -> tuple[str, ...]:
    """Return the loads that a result rests on and whose size nobody gives."""
    loads = {load.name for load in mechanism.loads}
    defined = {d.name for d in result.where}
    return tuple(sorted((symbols(result.formula) & loads) - defined))


def _in_code(result: Analysis, solution: FrictionSolution) -> Analysis:
    """Return a result as code takes it, with signs that follow from the pose."""
    whole = next(r for r in solution.results if r.name == result.name)
    return replace(result, formula=whole.formula, where=whole.where, guards=whole.guards)
