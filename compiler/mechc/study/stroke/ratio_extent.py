"""The extent of a ratio along the stroke: where it is 0, infinite, least and greatest."""

from collections.abc import Iterator, Sequence

from ...diagnostics import Report
from ...formula.numeric.jumps import NEAR_JUMP, side
from ...formula.numeric.roots import spaced
from ...formula.tree import Formula
from ...friction.solution import FrictionSolution
from ...model.mechanism import LoadRatio, SpeedRatio, WithFriction
from ...model.values import range_of
from ...units import ANGLE
from ..analysis import Analysis, Extent, Extreme, Vanishing, least_and_greatest
from ..locking_intervals import Range
from ..pose_sweep import PoseCode
from ..sweep import Sweep
from ..tolerances import SAME_ZERO
from ..variables import scale_of
from .from_balance import run
from .rounded import is_zero
from .run import has_sign
from .stroke import Stroke, StrokeInterval, ZeroInterval


def along_the_stroke(
    solution: FrictionSolution, results: Sequence[Analysis], report: Report
) -> dict[str, Extent]:
    """Return the extents of ratios on the part of the stroke around the default pose, by name.

    Of forces at joints without friction it is where they are zero, if anywhere: there their sense
    changes. Nothing where there is no stroke.
    """
    mechanism = solution.plan.graph.pose.mechanism
    looked = [r for r in results if _is_ratio(r) or _is_force(r)]
    drive = mechanism.drive
    if not looked or drive is None or range_of(drive.parameter, mechanism) is None:
        return {}
    return dict(_extents(run(solution, looked, 2, report), looked, solution))


def _is_force(result: Analysis) -> bool:
    """Return whether this is a force at a joint that has a sign; those with friction take long."""
    return has_sign(result.target) and not isinstance(result.target, WithFriction)


def _is_ratio(result: Analysis) -> bool:
    return isinstance(result.target, LoadRatio | SpeedRatio)


def _extents(
    stroke: Stroke, results: Sequence[Analysis], solution: FrictionSolution
) -> Iterator[tuple[str, Extent]]:
    """Yield each result with its extent on the part of the stroke that has the default pose."""
    part = _home(stroke)
    ends = range_of(stroke.drive, solution.plan.graph.pose.mechanism) or ()
    along = Sweep(PoseCode(solution.plan), stroke.drive, ends)
    known = {column.name for column in stroke.columns}
    for result in results:
        if part is None or result.name not in known:
            continue
        if not _is_ratio(result):
            yield from _zeros_of_force(result, stroke, part, along)
        elif is_zero(result, along, part):
            yield (
                result.name,
                _bare(result, stroke, part, along, zero_intervals=((part.low, part.high),)),
            )
        else:
            yield result.name, _extent(result, stroke, part, along)


def _home(stroke: Stroke) -> StrokeInterval | None:
    """Return the part of the stroke that the default pose is on."""
    default = stroke.defaults.get(stroke.drive)
    on = (s for s in stroke.stretches if default is not None and s.low <= default <= s.high)
    return next(on, None)


def _zeros_of_force(
    force: Analysis, stroke: Stroke, part: StrokeInterval, along: Sweep
) -> Iterator[tuple[str, Extent]]:
    """Yield a force with where it is zero on its way, if it is anywhere."""
    own = (s.drive for s in stroke.singular if s.result == force.name and s.value == "0")
    zeros = tuple(x for x in own if part.low < x < part.high)
    if zeros:
        yield force.name, _bare(force, stroke, part, along, zeros=zeros)


def _bare(
    result: Analysis,
    stroke: Stroke,
    part: StrokeInterval,
    along: Sweep,
    zeros: tuple[float, ...] = (),
    zero_intervals: tuple[Range, ...] = (),
) -> Extent:
    """Return an extent of which only is known where the result is zero."""
    return Extent(
        parameter=stroke.drive,
        unit="" if stroke.dimension == ANGLE else stroke.unit,
        range=(part.low, part.high),
        zeros=zeros,
        poles=(),
        least=None,
        greatest=None,
        scale=scale_of(result, along.mechanism),
        looked=False,
        zero_intervals=zero_intervals,
    )


def _extent(result: Analysis, stroke: Stroke, part: StrokeInterval, along: Sweep) -> Extent:
    """Return the extent of a ratio on a part of the stroke."""
    own = [s for s in stroke.singular if s.result == result.name and _is_on(s.drive, part)]
    zeros, poles = (tuple(s.drive for s in own if s.value == value) for value in ("0", "infinite"))
    is_open = any(s.value == "undetermined" for s in own) or any(
        _is_on(b.drive, part) for b in stroke.branches
    )
    extremes = [] if poles or is_open else _extremes(result, stroke, part, along)
    least, greatest = least_and_greatest(extremes)
    zero_intervals = (
        n for n in stroke.zero_intervals if n.result == result.name and _is_in(n, part)
    )
    return Extent(
        parameter=stroke.drive,
        unit="" if stroke.dimension == ANGLE else stroke.unit,
        range=(part.low, part.high),
        zeros=zeros,
        poles=poles,
        least=least,
        greatest=greatest,
        scale=scale_of(result, along.mechanism),
        looked=not is_open,
        zero_intervals=tuple((n.low, n.high) for n in zero_intervals),
        vanishes=dict(
            (
                *vanishing(zeros, result.zeros, result, part, along),
                *vanishing(poles, result.poles, result, part, along),
            )
        ),
    )


EXTENT_PLACES = 16
"""Places on a stroke at which it is looked at how large a factor is."""


def vanishing(
    places: Sequence[float],
    limits: Sequence[Vanishing],
    result: Analysis,
    part: StrokeInterval,
    along: Sweep,
) -> Iterator[tuple[float, Formula]]:
    """Yield places, each with the factor that is zero there, where it is one of several."""
    factors = [limit.factor for limit in limits] if len(limits) > 1 else []
    sizes = [_size(factor, result, part, along) for factor in factors]
    for x in places:
        met = [
            factor
            for factor, size in zip(factors, sizes, strict=True)
            if abs(along.of(factor, result, x)) <= SAME_ZERO * size
        ]
        if len(met) == 1:
            yield x, met[0]


def _size(factor: Formula, result: Analysis, part: StrokeInterval, along: Sweep) -> float:
    """Return the largest value of a factor at places on an interval, NaN where it has none."""
    grid = spaced(part.low, part.high, EXTENT_PLACES)
    return max(abs(along.of(factor, result, x)) for x in grid)


def _is_on(x: float, part: StrokeInterval) -> bool:
    return part.low <= x <= part.high


def _is_in(zero_intervals: ZeroInterval, part: StrokeInterval) -> bool:
    return _is_on(zero_intervals.low, part) and _is_on(zero_intervals.high, part)


def _extremes(
    result: Analysis, stroke: Stroke, part: StrokeInterval, along: Sweep
) -> list[Extreme]:
    """Return the extrema on an interval, and the values at its ends."""
    inner = [
        Extreme(e.drive, e.value)
        for e in stroke.extrema
        if e.result == result.name and _is_on(e.drive, part)
    ]
    ends = ((part.low, part.high), (part.high, part.low))
    return [*inner, *(Extreme(x, _at_end(result, along, x, other)) for x, other in ends)]


def _at_end(result: Analysis, along: Sweep, x: float, other: float) -> float:
    """Return a ratio at one of two ends: where rounding alone is left, what it comes to there."""
    value = along.function(result.formula, result)
    known = along.beyond_rounding(result, x, value(x))
    return side(value, x, (other - x) * NEAR_JUMP) if known is None else known
