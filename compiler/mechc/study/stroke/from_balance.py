"""From the results to the stroke."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain

from ...diagnostics import Report
from ...diagnostics import stroke as messages
from ...formula.numeric.roots import spaced
from ...friction.solution import FrictionSolution
from ...model.parts.targets import drives_from_below
from ...model.values import range_of
from ...pose.motion import Motion
from ...pose.pose import Pose
from ...units import ANGLE, LENGTH
from ..analysis import Analysis
from ..locking_intervals import EfficiencyRange, LockingInterval
from ..pose_sweep import EXCLUDED
from .columns import ShownQuantities, asked, named_apart
from .extrema import extrema_along
from .jumps import is_on_the_stroke, turns_along
from .rounded import is_apart, zero_parts
from .rows import columns, rows
from .run import StrokeRun, run_of
from .singular import singular_along
from .stretches import stretches_of, with_reached
from .stroke import StandstillInterval, Stroke, StrokeInterval

Watch = Callable[[Sequence[float]], Iterable[float]]


def run(
    solution: FrictionSolution,
    results: Sequence[Analysis],
    points: int,
    report: Report,
    motion: Motion | None = None,
    paths: Sequence[str] = (),
    watch: Watch = iter,
) -> Stroke:
    """Return ``points`` rows along the stroke, and what is singular or extreme on it.

    ``paths`` are the points and links whose ``motion`` is shown, ``watch`` sees the values of
    the drive done one after another. Reports E591 without a drive,
    E592 without a stroke's ends, E597 for a path of nothing.
    """
    pose = solution.plan.graph.pose
    drive = pose.mechanism.drive
    if drive is None:
        ranged = [p.name for p in pose.mechanism.parameters if p.range and not p.dependent]
        (able, unit), moves = _drivable(pose), bool(solution.plan.mobility)
        raise report.fail(messages.no_drive(pose.mechanism.span, able, unit, ranged, moves))
    parameter = pose.mechanism.parameter(drive.parameter)
    ends = range_of(drive.parameter, pose.mechanism)
    if ends is None:
        raise report.fail(messages.no_stroke(drive.span, drive.parameter))
    return _stroke(run_of(solution, results, parameter, *ends), asked(motion, paths), points, watch)


def _drivable(pose: Pose) -> tuple[list[str], str]:
    """Return the parameters that could drive, angles if there are any, and the unit of ends."""
    free = [p for p in pose.mechanism.parameters if p.name in pose.free]
    for dimension, unit in ((ANGLE, "deg"), (LENGTH, "mm")):
        if found := [p.name for p in free if p.dimension == dimension]:
            return found, unit
    return [], "deg"


def _stroke(run: StrokeRun, paths: ShownQuantities, points: int, watch: Watch) -> Stroke:
    """Return the stroke: what is found along the drive, then the rows of its table."""
    along, drive = run.along, run.drive
    filled = named_apart(columns(run, paths))
    found, crossings = stretches_of(run)
    default, is_angle = along.defaults.get(drive.name), drive.dimension == ANGLE
    stretches = with_reached(tuple(found), default, EXCLUDED, is_angle)
    branches = sorted((*run.branches, *crossings), key=lambda b: b.drive)
    drives = list(spaced(run.low, run.high, points - 1))
    zero_intervals = tuple(zero_parts(run, stretches, branches))
    turns = turns_along(run, stretches)
    found_singular = singular_along(run, stretches, branches, turns)
    extrema = extrema_along(run, stretches, found_singular, branches, turns)
    singular = (one for one in found_singular if is_on_the_stroke(one, run))
    return Stroke(
        drive=drive.name,
        dimension=drive.dimension,
        unit=drive.unit,
        low=run.low,
        high=run.high,
        columns=tuple(f.column for f in filled),
        rows=tuple(
            r for _, r in zip(watch(drives), rows(run, drives, filled, stretches), strict=True)
        ),
        stretches=stretches,
        singular=tuple(one for one in singular if is_apart(one, zero_intervals, run.range)),
        branches=tuple(branches),
        extrema=tuple(one for one in extrema if is_apart(one, zero_intervals, run.range)),
        standstills=tuple(_standstills(run.results, drive.name)),
        efficiency_ranges=tuple(_efficiency_ranges(run.results, drive.name)),
        defaults=along.defaults,
        without=run.open,
        looked=_looked(run, stretches) if run.results else 0,
        zero_intervals=tuple(
            part for part in zero_intervals if part.result in {r.name for r in run.quotients}
        ),
    )


def _looked(run: StrokeRun, stretches: Sequence[StrokeInterval]) -> int:
    """Return at how many values of the drive the results were looked at."""
    return sum(len(run.within(stretch)) for stretch in stretches)


def _standstills(results: Iterable[Analysis], drive: str) -> Iterator[StandstillInterval]:
    """Yield where friction lets nothing move."""
    for result in results:
        for stretch in _stretches(result, drive):
            if stretch.within:
                left_out, driving = _left_out(stretch, *stretch.within), _driving(result)
                yield StandstillInterval(
                    result.name, stretch.state, *stretch.within, left_out, driving
                )


def _driving(result: Analysis) -> str:
    """Return the load that drives from below the line, '' where that above the line does."""
    is_by_other = drives_from_below(result.target, result.name, result.driven)
    return result.locking.load if is_by_other and result.locking else ""


def _stretches(result: Analysis, drive: str) -> Iterator[LockingInterval]:
    """Return the stretches of the drive on which a result is locked or jammed."""
    reaches = result.locking.reaches if result.locking else ()
    return chain.from_iterable(reach.of_interest for reach in reaches if reach.parameter == drive)


def _left_out(stretch: LockingInterval, low: float, high: float) -> tuple[bool, bool]:
    """Return of either end of what lies in the range whether the stretch only reaches up to it."""
    first, last = stretch.low, stretch.high
    return (
        first is not None and first.is_strict and first.x == low,
        last is not None and last.is_strict and last.x == high,
    )


def _efficiency_ranges(
    results: Iterable[Analysis], drive: str
) -> Iterator[tuple[str, EfficiencyRange]]:
    """Yield each efficiency with what it runs through."""
    for result in results:
        yield from ((result.name, c) for c in result.efficiency_ranges if c.parameter == drive)
