"""The table along a stroke: its columns and its rows."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial

from ...formula.numeric.rounded_columns import RoundedColumn, RoundedColumns
from ...formula.numeric.rounding import (
    PrintedNumber,
    Rounding,
    beyond_rounding,
    with_error,
    without_rounding,
    without_value,
)
from ...formula.walk import symbols
from ...model.mechanism import Mechanism
from ...model.parts.targets import Efficiency, WithFriction
from ...model.result import Definition
from ...model.values import own_unit
from ...units import ANGLE, LENGTH, Dimension
from ..pose_sweep import NO_POSE
from ..sweep import Sweep
from ..tolerances import SAME_SIDES, SIDE, STRAIGHT, VANISHING
from .columns import FilledColumn, ShownQuantities, path_columns
from .removable import RemovableSingularities
from .rounded import is_on_a_sign
from .run import StrokeRun
from .stretches import beyond, trouble
from .stroke import AngleAt, StrokeColumn, StrokeInterval, StrokeRow
from .transmission import TransmissionAngle, angles_at_pins, named, transmissions
from .velocities import velocities

AT_ONCE = 64
"""Rows whose rounding is found at once."""


def columns(run: StrokeRun, asked: ShownQuantities) -> Iterator[FilledColumn]:
    """Yield results, slopes, velocity ratios, transmission angles, then the paths asked for."""
    unit_of = partial(_unit, run.pose.mechanism)
    yield from _results(run, unit_of)
    yield from _slopes(run, unit_of)
    for velocity in velocities(run.solution.balance):
        unit = unit_of(velocity.dimension)
        column = StrokeColumn(velocity.name, velocity.dimension, "velocity", unit, velocity.about)
        yield FilledColumn(
            column, partial(run.along.inside, velocity.value), velocity.value.formula()
        )
    for name, angle in named(transmissions(run.pose), angles_at_pins(run.pose)):
        about = AngleAt(name, angle.pin, angle.rod, angle.onto)
        column = StrokeColumn(name, ANGLE, "angle", about=(about,))
        yield FilledColumn(column, partial(_angle, run.along, angle))
    if asked.quantities:
        yield from path_columns(asked, run.along, unit_of)


def _results(run: StrokeRun, unit_of: Callable[[Dimension], str]) -> Iterator[FilledColumn]:
    for result in run.results:
        unit = own_unit(result.name, run.pose.mechanism) or unit_of(result.dimension)
        column = StrokeColumn(result.name, result.dimension, unit=unit)
        at = run.values(result.formula, result)
        has_friction = isinstance(result.target, WithFriction | Efficiency)
        of = getattr(result.target, "of", None)
        ideal = next((r.name for r in run.results if of is not None and r.target == of), "")
        yield FilledColumn(column, at, result.formula, result.where, has_friction, ideal)


def _slopes(run: StrokeRun, unit_of: Callable[[Dimension], str]) -> Iterator[FilledColumn]:
    """Yield the columns of slopes of ratios along the drive."""
    for result in run.ratios:
        slope = (result.derivatives or {}).get(run.drive.name)
        if slope is not None:
            name = f"d{result.name}/d{run.drive.name}"
            dimension = result.dimension.over(run.drive.dimension)
            column = StrokeColumn(name, dimension, "slope", unit_of(dimension))
            yield FilledColumn(column, run.values(slope, result), slope, result.where)


def _angle(along: Sweep, angle: TransmissionAngle, x: float) -> float:
    size = angle.at(along.values(x))
    return 0.0 if abs(size) < STRAIGHT else size


def _unit(mechanism: Mechanism, dimension: Dimension) -> str:
    """Return the unit in which the user writes lengths, '' for anything else."""
    if dimension != LENGTH:
        return ""
    listed = (*mechanism.parameters, *mechanism.literals)
    return next((p.unit for p in listed if p.dimension == LENGTH and p.unit), "")


class StrokeSizes:
    """Finds sizes at poses; how exact they are is found for all poses at once where it can be."""

    def __init__(
        self, run: StrokeRun, drives: Sequence[float], filled: Sequence[FilledColumn]
    ) -> None:
        self._run, self._filled = run, filled
        self._rows = {x: i for i, x in enumerate(drives)}
        columns = run.along.rounded(drives)
        self._rounded = [_rounded(f, columns) for f in filled]

    def at(self, x: float) -> list[PrintedNumber]:
        """Return the size of each column at one of the poses."""
        alone = cache(partial(self._run.along.rounding_inside, x))
        sizes: list[PrintedNumber] = []
        zeros = set[str]()
        for filled, column in zip(self._filled, self._rounded, strict=True):
            size = self._printed(filled, x, column, alone)
            if filled.ideal in zeros and size.number is not None:
                size = self._from_both_sides(filled, x)
            if size.number == 0:
                zeros.add(filled.column.name)
            sizes.append(size)
        return sizes

    def _printed(
        self,
        filled: FilledColumn,
        x: float,
        column: RoundedColumn | None,
        alone: Callable[[], Rounding],
    ) -> PrintedNumber:
        """Return a value of a column as it is printed: rounding left out, limits put in."""
        number, formula, where = filled.at(x), filled.formula, filled.where
        if filled.has_friction and len(self._run.along.sides(filled.at, where, x)) > 1:
            return PrintedNumber(None, undetermined=True)
        if formula is None:
            return PrintedNumber(number + 0.0)
        if math.isnan(number) and not filled.has_friction:
            return self._across(filled, x, without_value(formula, where, alone()))
        rounded = column.at(self._rows[x]) if column and math.isfinite(number) else None
        if rounded is not None:
            size = without_rounding(number, rounded)
        else:
            size = beyond_rounding(number, formula, where, alone())
        if filled.has_friction and is_on_a_side(size, where, alone()):
            return self._from_both_sides(filled, x)
        return size if filled.has_friction else self._across(filled, x, size)

    def _from_both_sides(self, filled: FilledColumn, x: float) -> PrintedNumber:
        at = partial(self._beyond_rounding, filled)
        return from_both_sides(at, partial(_is_pose, self._run), x, self._run.range)

    def _across(self, filled: FilledColumn, x: float, size: PrintedNumber) -> PrintedNumber:
        """Return the size of a column, where its formula alone is 0/0 that from both sides."""
        if not size.undetermined:
            return size
        value = RemovableSingularities(
            filled.at, partial(self._error, filled), self._run.range
        ).value(x)
        return size if value is None else PrintedNumber(value)

    def _error(self, filled: FilledColumn, x: float) -> float:
        """Return a bound of the rounding error in a column."""
        assert filled.formula is not None
        rounding = self._run.along.rounding_inside(x)
        return with_error(filled.formula, filled.where, rounding).error

    def _beyond_rounding(self, filled: FilledColumn, x: float) -> float:
        """Return a value, 0 where it is but rounding: that grows near a pose as at a pole."""
        number, rounding = filled.at(x), self._run.along.rounding_inside(x)
        size = beyond_rounding(number, filled.formula, filled.where, rounding)
        return number if size.number is None else size.number


def _rounded(filled: FilledColumn, columns: RoundedColumns) -> RoundedColumn | None:
    """Return a column with its errors; None where it has no formula, or not in what has values."""
    if filled.formula is None:
        return None
    known = columns.with_definitions(filled.where)
    return known.of(filled.formula) if symbols(filled.formula) <= known.names else None


def _is_pose(run: StrokeRun, x: float) -> bool:
    return not run.along.trouble(x)


def rows(
    run: StrokeRun,
    drives: Sequence[float],
    filled: Sequence[FilledColumn],
    stretches: Sequence[StrokeInterval],
) -> Iterator[StrokeRow]:
    """Yield the rows at values of the drive: values, or why there are none."""
    for start in range(0, len(drives), AT_ONCE):
        some = drives[start : start + AT_ONCE]
        sizes = StrokeSizes(run, [x for x in some if not run.along.trouble(x)], filled)
        for x in some:
            if run.along.trouble(x):
                yield _gap(run, x, len(filled), stretches)
            else:
                yield _row(run, x, filled, sizes.at(x))


def _gap(run: StrokeRun, x: float, width: int, stretches: Sequence[StrokeInterval]) -> StrokeRow:
    """Return a row without values, and why there are none."""
    why = trouble(run, x)
    why = (beyond(x, stretches) if why in NO_POSE else "") or why
    return StrokeRow(x, (math.nan,) * width, why)


def _row(
    run: StrokeRun, x: float, filled: Sequence[FilledColumn], sizes: Sequence[PrintedNumber]
) -> StrokeRow:
    values = tuple(math.nan if s.number is None else s.number for s in sizes)
    open_ = (f.column.name for f, s in zip(filled, sizes, strict=True) if s.undetermined)
    return StrokeRow(x, values, trouble(run, x), tuple(open_))


# ------------------------------------------------------------------------------------- dead centres


GROWS_TWICE_AS_NEAR = 1.5
"""How much larger what is infinite somewhere is at half the distance, at least."""


def is_on_a_side(size: PrintedNumber, where: Sequence[Definition], rounding: Rounding) -> bool:
    """Return whether a value rests on a sign that rounding makes, or has no number."""
    if size.number is None or not math.isfinite(size.number):
        return True
    return is_on_a_sign(where, rounding)


def from_both_sides(
    at: Callable[[float], float], stands: Callable[[float], bool], x: float, range_: float
) -> PrintedNumber:
    """Return the limit of a result at ``x``, undetermined where its sides are not alike.

    At a dead centre of the drive friction jams one motion and lets the other go on, so that the
    result is undetermined; at one of the load both sides come to values between which all of them
    balance. A side on which no pose ``stands`` does not count.
    """
    steps = [s * SIDE * range_ for s in (-1, 1)]
    ends = [_limit(at, x, step) for step in steps if stands(x + step)]
    low, high = min(ends, default=math.nan), max(ends, default=math.nan)
    if all(map(math.isnan, ends)):
        return PrintedNumber(math.nan)
    if any(map(math.isnan, ends)) or low * high < 0 or (math.isinf(high) and low < high):
        return PrintedNumber(None, undetermined=True)
    return PrintedNumber(_between(at(x), low, high))


def _limit(at: Callable[[float], float], x: float, step: float) -> float:
    """Return the limit of a result, on the line through its values one and two steps away."""
    near, far = at(x + step), at(x + 2 * step)
    if abs(near) > GROWS_TWICE_AS_NEAR * abs(far):
        return math.copysign(math.inf, near)
    limit = 2 * near - far
    return 0.0 if abs(limit) <= VANISHING * abs(near) else limit


def _between(value: float, low: float, high: float) -> float:
    """Return a value that lies between two others but for rounding, else their middle."""
    room = SAME_SIDES * max(abs(low), abs(high))
    return value if low - room <= value <= high + room else (low + high) / 2
