"""From the results to the stroke."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise, product

from ...diagnostics import Report
from ...diagnostics import stroke as messages
from ...formula.roots import spaced
from ...formula.rounding import Rounding, Size, beyond_rounding, without_value
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...friction.solution import Solution
from ...model.mechanism import LoadRatio, Mechanism, Parameter
from ...model.targets import Efficiency, WithFriction
from ...model.values import own_unit, range_of
from ...pose.motion import Motion
from ...pose.pose import Pose
from ...units import ANGLE, LENGTH, Dimension
from ..analysis import Analysis
from ..tolerances import AT_BRANCH_POINT, BRANCH_POINT, CROSSING, STRAIGHT
from .along import EXCLUDED, NO_POSE, Along
from .branches import branch_points
from .columns import Filled, named_apart
from .ends import end_of_branch
from .extrema import extrema, turns_between
from .friction import courses, in_code, is_told, some, stuck
from .places import SAMPLES, looked_at
from .points import Asked, asked, path_columns
from .reached import with_reached
from .rounded import is_nil, rounded
from .sides import from_both_sides, is_on_a_side
from .singular import Order, order_at, places_of, singular_poses, told_apart
from .stroke import Branch, Column, Extremum, Row, Singular, Stretch, Stroke
from .transmission import Transmission, named, transmissions
from .velocities import velocities

BEYOND = "not followed beyond the branch point"

FLAT = "branch point"
"""Stands in a row at which a loop lies flat."""


def run(
    solution: Solution,
    results: Sequence[Analysis],
    points: int,
    report: Report,
    motion: Motion | None = None,
    paths: Sequence[str] = (),
) -> Stroke:
    """Return ``points`` rows along the stroke, and what is singular or extreme on it.

    ``paths`` are the points and links whose ``motion`` is shown. Reports E591 without a drive,
    E592 without a stroke's ends, E597 for a path of nothing.
    """
    pose = solution.plan.graph.pose
    drive = pose.mechanism.drive
    if drive is None:
        ranged = [p.name for p in pose.mechanism.parameters if p.range and not p.dependent]
        raise report.fail(messages.no_drive(pose.mechanism.span, *_drivable(pose), ranged))
    parameter = pose.mechanism.parameter(drive.parameter)
    ends = range_of(drive.parameter, pose.mechanism)
    if ends is None:
        raise report.fail(messages.no_stroke(drive.span, drive.parameter))
    runner = _Runner(solution, results, parameter, *ends, asked(motion, paths))
    return runner.stroke(points)


def _drivable(pose: Pose) -> tuple[list[str], str]:
    """Return the parameters that could drive, angles if there are any, and the unit of ends."""
    free = [p for p in pose.mechanism.parameters if p.name in pose.free]
    for dimension, unit in ((ANGLE, "deg"), (LENGTH, "mm")):
        if found := [p.name for p in free if p.dimension == dimension]:
            return found, unit
    return [], "deg"


class _Runner:
    """Runs along one stroke."""

    def __init__(
        self,
        solution: Solution,
        results: Sequence[Analysis],
        parameter: Parameter,
        low: float,
        high: float,
        asked: Asked,
    ) -> None:
        self._solution, self._pose = solution, solution.plan.graph.pose
        self._parameter, self._low, self._high = parameter, low, high
        self._asked = asked
        self._along = Along(solution.plan, plain_lets(self._pose.mechanism), (low, high))
        shown = [r for r in results if r.default is not None or r.target is not None]
        shown = [in_code(r, solution) for r in shown]
        self._results = [r for r in shown if not self._without(r)]
        self._open = tuple((r.name, self._without(r)) for r in shown if self._without(r))
        self._ratios = [r for r in self._results if isinstance(r.target, LoadRatio)]
        self._places = spaced(low, high, SAMPLES)
        self._branches = branch_points(self._pose, self._along, self._places)
        self._crossings: list[Branch] = []

    def _without(self, result: Analysis) -> tuple[str, ...]:
        """Return the loads that a result rests on and whose size nobody gives."""
        loads = {load.name for load in self._pose.mechanism.loads}
        defined = {d.name for d in result.where}
        return tuple(sorted((symbols(result.formula) & loads) - defined))

    def stroke(self, points: int) -> Stroke:
        """Return the whole."""
        filled = named_apart(self._columns())
        stretches = with_reached(
            tuple(self._stretches()),
            self._along.defaults.get(self._parameter.name),
            EXCLUDED,
            self._parameter.dimension == ANGLE,
        )
        places = spaced(self._low, self._high, points - 1)
        branches = sorted((*self._branches, *self._crossings), key=lambda b: b.drive)
        singular = self._singular(stretches, branches)
        return Stroke(
            self._parameter.name,
            self._parameter.dimension,
            self._parameter.unit,
            self._low,
            self._high,
            tuple(f.column for f in filled),
            tuple(self._row(x, filled, stretches) for x in places),
            stretches,
            singular,
            tuple(branches),
            self._extrema(stretches, singular),
            tuple(stuck(self._results, self._parameter.name)),
            tuple(courses(self._results, self._parameter.name)),
            self._along.defaults,
            self._open,
            tuple((r.name, self._looked(r, stretches)) for r in self._results),
        )

    # ------------------------------------------------------------------------------- columns

    def _columns(self) -> Iterator[Filled]:
        """Yield results, their slopes along the drive, velocity ratios, transmission angles."""
        for result in self._results:
            unit = own_unit(result.name, self._pose.mechanism)
            column = Column(result.name, result.dimension, unit=unit)
            at = self._values(result.formula, result)
            has_friction = isinstance(result.target, WithFriction | Efficiency)
            yield Filled(column, at, result.formula, result.where, has_friction)
        for result in self._ratios:
            slope = (result.derivatives or {}).get(self._parameter.name)
            if slope is not None:
                name = f"d{result.name}/d{self._parameter.name}"
                dimension = result.dimension.over(self._parameter.dimension)
                column = Column(name, dimension, "slope")
                yield Filled(column, self._values(slope, result), slope, result.where)
        for velocity in velocities(self._solution.balance):
            unit = self._unit(velocity.dimension)
            column = Column(velocity.name, velocity.dimension, "velocity", unit)
            at = partial(self._along.inside, velocity.value)
            yield Filled(column, at, velocity.value.formula())
        for name, angle in named(transmissions(self._pose)):
            column = Column(name, ANGLE, "angle")
            yield Filled(column, partial(self._angle, angle))
        yield from path_columns(self._asked, self._along, self._unit)

    def _values(self, formula: Formula, where: Analysis) -> Callable[[float], float]:
        return lambda place: self._along.of(formula, where, place)

    def _angle(self, angle: Transmission, place: float) -> float:
        size = angle.at(self._along.values(place))
        return 0.0 if abs(size) < STRAIGHT else size

    def _unit(self, dimension: Dimension) -> str:
        """Return the unit in which the user writes lengths, '' for anything else."""
        if dimension != LENGTH:
            return ""
        mechanism = self._pose.mechanism
        listed = (*mechanism.parameters, *mechanism.literals)
        return next((p.unit for p in listed if p.dimension == LENGTH and p.unit), "")

    def _row(self, place: float, filled: Sequence[Filled], stretches: Sequence[Stretch]) -> Row:
        trouble = self._trouble(place)
        if self._along.trouble(place):
            why = _beyond(place, stretches) if trouble in NO_POSE else ""
            return Row(place, (math.nan,) * len(filled), why or trouble)
        rounding = self._along.rounding(place)
        sizes = [self._size(f, place, rounding) for f in filled]
        values = tuple(math.nan if s.number is None else s.number for s in sizes)
        open_ = (f.column.name for f, s in zip(filled, sizes, strict=True) if s.undetermined)
        return Row(place, values, trouble, tuple(open_))

    def _size(self, filled: Filled, place: float, rounding: Rounding) -> Size:
        """Return a column's value at a place without what is nothing but rounding."""
        number, formula = filled.at(place), filled.formula
        size = beyond_rounding(number, formula, filled.where, rounding)
        if formula and math.isnan(number) and not filled.has_friction:
            return without_value(formula, filled.where, rounding)
        if filled.has_friction and is_on_a_side(size, filled.where, rounding):
            range_ = self._high - self._low
            return from_both_sides(filled.at, self._is_pose, place, range_)
        return size

    def _is_pose(self, place: float) -> bool:
        return not self._along.trouble(place)

    # ----------------------------------------------------------------------------- stretches

    def _trouble(self, place: float) -> str:
        """Return why there is no pose, or that a loop lies flat.

        Rounding decides whether a loop that is all but flat closes.
        """
        trouble = self._along.trouble(place)
        range_ = self._high - self._low
        gaps = [abs(place - branch.drive) for branch in self._branches]
        if trouble in NO_POSE and any(gap <= BRANCH_POINT * range_ for gap in gaps):
            return FLAT
        return trouble or (FLAT if any(gap <= AT_BRANCH_POINT * range_ for gap in gaps) else "")

    def _stands(self, place: float) -> bool:
        return self._trouble(place) in ("", FLAT)

    def _stretches(self) -> Iterator[Stretch]:
        """Yield the parts of the stroke on which there is a pose, their ends to the last bit."""
        places = self._places
        start, before = (places[0] if self._stands(places[0]) else None), ""
        for a, b in pairwise(places):
            if self._stands(b) and not self._stands(a):
                start, before = self._ended(a, b)
            elif self._stands(a) and not self._stands(b) and start is not None:
                end, after = self._ended(b, a)
                yield Stretch(start, end, before, after)
                start = None
        if start is not None:
            yield Stretch(start, places[-1], before, "")

    def _ended(self, bad: float, good: float) -> tuple[float, str]:
        """Return the last place before a bad one, and what ends there."""
        edge, range_, why = self._halved(bad, good), self._high - self._low, self._trouble(bad)
        if why not in NO_POSE:
            return edge, why
        end = end_of_branch(self._pose, self._along, edge, math.copysign(range_, bad - good))
        if end.crossed:
            self._crossings.append(Branch(end.crossed, end.place, CROSSING))
        return end.place, BEYOND if end.crossed else why

    def _halved(self, bad: float, good: float) -> float:
        while (middle := (bad + good) / 2) not in (bad, good):
            if self._stands(middle):
                good = middle
            else:
                bad = middle
        return good

    # -------------------------------------------------------------------- singular, extreme

    def _within(self, stretch: Stretch) -> list[float]:
        return looked_at(stretch, self._places)

    def _looked(self, result: Analysis, stretches: Sequence[Stretch]) -> int:
        """Return at how many places of the stroke a result was looked at."""
        return sum(len(some(self._within(stretch), result)) for stretch in stretches)

    def _singular(
        self, stretches: Sequence[Stretch], branches: Sequence[Branch]
    ) -> tuple[Singular, ...]:
        name = self._parameter.name
        found = [
            pose
            for stretch in stretches
            for result in self._ratios
            if not is_nil(result, self._along, stretch)
            for pose in singular_poses(result, name, self._along, stretch, self._within(stretch))
        ]
        range_ = self._high - self._low
        orders = {
            r.name: partial(self._order, self._values(r.formula, r), range_) for r in self._ratios
        }
        return told_apart(found, branches, range_, orders)

    def _order(
        self, function: Callable[[float], float], range_: float, place: float
    ) -> Order | None:
        return order_at(function, place, range_)

    def _poles(self, result: Analysis, singular: Sequence[Singular]) -> list[float]:
        """Return where a result is infinite, or what it is with friction."""
        ideal = getattr(result.target, "of", result.target)
        names = {ratio.name for ratio in self._ratios if ratio.target == ideal}
        return [s.drive for s in singular if s.result in names and s.value == "infinite"]

    def _own_poles(self, result: Analysis, stretch: Stretch) -> list[float]:
        """Return where a result that is no ratio of loads is infinite on a stretch."""
        if isinstance(result.target, LoadRatio):
            return []
        places = self._within(stretch)
        return [
            root.place
            for pole in result.poles
            for root in places_of(result, pole, self._along, stretch, places)
        ]

    def _is_pole(self, found: Extremum, result: Analysis) -> bool:
        """Tell a pole, which samples on either side of it enclose, from an extremum."""
        values = self._values(result.formula, result)
        return self._order(values, self._high - self._low, found.drive) == "infinite"

    def _extrema(
        self, stretches: Sequence[Stretch], singular: Sequence[Singular]
    ) -> tuple[Extremum, ...]:
        """Return the extrema; beside a branch that iteration finds, results lose digits.

        Where a place that is looked at is a pole, what is beside it may be none.
        """
        name, beside = self._parameter.name, 2 * (self._high - self._low) / SAMPLES
        found: list[Extremum] = []
        for stretch, result in product(stretches, self._results):
            if is_nil(result, self._along, stretch):
                continue
            poles = [*self._poles(result, singular), *self._own_poles(result, stretch)]
            turning = extrema(result, name, self._along, some(self._within(stretch), result))
            told = (e for e in turning if is_told(e, result) and not self._is_pole(e, result))
            for one in told:
                near_by = [p for p in poles if abs(one.drive - p) <= beside]
                if not near_by or turns_between(one, near_by, result, self._along):
                    found += rounded(one, result, self._along, self._places)
        near = BRANCH_POINT * (self._high - self._low)
        others = [b.drive for b in self._crossings] + [s.drive for s in singular if s.sides]
        apart = [e for e in found if all(abs(e.drive - other) > near for other in others)]
        return tuple(sorted(apart, key=lambda e: e.drive))


def _beyond(place: float, stretches: Sequence[Stretch]) -> str:
    """Return what is said of a place between stretches one of which ends at a branch point."""
    before = [s.after for s in stretches if s.high < place]
    after = [s.before for s in stretches if s.low > place]
    return BEYOND if BEYOND in (*before[-1:], *after[:1]) else ""


def plain_lets(mechanism: Mechanism) -> Mapping[str, Formula]:
    """Return the user's formulas; those that rest on loads stay without a value."""
    return {let.name: let.value for let in mechanism.lets}
