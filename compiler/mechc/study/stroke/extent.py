"""The extent of a ratio along the stroke: where it is 0, infinite, least and greatest."""

from collections.abc import Iterator, Sequence

from ...diagnostics import Report
from ...formula.roots import spaced
from ...formula.tree import Formula
from ...friction.solution import Solution
from ...model.mechanism import LoadRatio, SpeedRatio
from ...model.values import range_of
from ...units import ANGLE
from ..analysis import Analysis, Extent, Extreme, Vanishing, least_and_greatest
from ..ranges import scale_of
from ..tolerances import SAME_ZERO
from .along import Along
from .from_balance import run
from .rounded import is_nil
from .run import plain_lets
from .stroke import Stroke, StrokeInterval, ZeroInterval


def along_the_stroke(
    solution: Solution, results: Sequence[Analysis], report: Report
) -> dict[str, Extent]:
    """Return the extents of ratios on the part of the stroke around the default pose, by name.

    Nothing where there is no stroke.
    """
    mechanism = solution.plan.graph.pose.mechanism
    ratios = [r for r in results if isinstance(r.target, LoadRatio | SpeedRatio)]
    drive = mechanism.drive
    if not ratios or drive is None or range_of(drive.parameter, mechanism) is None:
        return {}
    return dict(_extents(run(solution, ratios, 2, report), ratios, solution))


def _extents(
    stroke: Stroke, ratios: Sequence[Analysis], solution: Solution
) -> Iterator[tuple[str, Extent]]:
    part = _home(stroke)
    along = Along(solution.plan, plain_lets(solution.plan.graph.pose.mechanism))
    known = {column.name for column in stroke.columns}
    for result in ratios:
        if part and result.name in known:
            is_zero = is_nil(result, along, part)
            yield result.name, (_zero_extent if is_zero else _extent)(result, stroke, part, along)


def _home(stroke: Stroke) -> StrokeInterval | None:
    """Return the part of the stroke that the default pose is on."""
    default = stroke.defaults.get(stroke.drive)
    on = (s for s in stroke.stretches if default is not None and s.low <= default <= s.high)
    return next(on, None)


def _zero_extent(result: Analysis, stroke: Stroke, part: StrokeInterval, along: Along) -> Extent:
    """Return the extent of what is zero wherever it was looked at."""
    return Extent(
        parameter=stroke.drive,
        unit="" if stroke.dimension == ANGLE else stroke.unit,
        range=(part.low, part.high),
        zeros=(),
        poles=(),
        least=None,
        greatest=None,
        scale=scale_of(result, along.mechanism),
        looked=False,
        nil=((part.low, part.high),),
    )


def _extent(result: Analysis, stroke: Stroke, part: StrokeInterval, along: Along) -> Extent:
    own = [s for s in stroke.singular if s.result == result.name and _is_on(s.drive, part)]
    zeros, poles = (tuple(s.drive for s in own if s.value == value) for value in ("0", "infinite"))
    is_open = any(s.value == "undetermined" for s in own) or any(
        _is_on(b.drive, part) for b in stroke.branches
    )
    extremes = [] if poles or is_open else _extremes(result, stroke, part, along)
    least, greatest = least_and_greatest(extremes)
    nil = (n for n in stroke.nil if n.result == result.name and _is_in(n, part))
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
        nil=tuple((n.low, n.high) for n in nil),
        vanishes=dict(
            (
                *vanishing(zeros, result.zeros, result, part, along),
                *vanishing(poles, result.poles, result, part, along),
            )
        ),
    )


SAMPLES = 16
"""Places on a stroke at which it is looked at how large a factor is."""


def vanishing(
    places: Sequence[float],
    limits: Sequence[Vanishing],
    result: Analysis,
    part: StrokeInterval,
    along: Along,
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


def _size(factor: Formula, result: Analysis, part: StrokeInterval, along: Along) -> float:
    """Return the largest value of a factor at places on an interval, NaN where it has none."""
    grid = spaced(part.low, part.high, SAMPLES)
    return max(abs(along.of(factor, result, x)) for x in grid)


def _is_on(x: float, part: StrokeInterval) -> bool:
    return part.low <= x <= part.high


def _is_in(nil: ZeroInterval, part: StrokeInterval) -> bool:
    return _is_on(nil.low, part) and _is_on(nil.high, part)


def _extremes(
    result: Analysis, stroke: Stroke, part: StrokeInterval, along: Along
) -> list[Extreme]:
    """Return the extrema on an interval, and the values at its ends."""
    inner = [
        Extreme(e.drive, e.value)
        for e in stroke.extrema
        if e.result == result.name and _is_on(e.drive, part)
    ]
    ends = (part.low, part.high)
    return [*inner, *(Extreme(x, along.of(result.formula, result, x)) for x in ends)]
