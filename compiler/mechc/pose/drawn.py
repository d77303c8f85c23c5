"""Where points are drawn: against the default pose, and with the drive set to another place."""

import math
from collections.abc import Iterator, Mapping, Sequence

from ..algebra.product import Product
from ..diagnostics import Diagnostic, Report
from ..diagnostics import drawn as messages
from ..diagnostics import open_loops as open_messages
from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..frozen import replace
from ..model.mechanism import Drawn, Mechanism, Pivot
from ..model.values import Chain, defaults, dependent
from ..source import Span
from ..units import in_unit
from .pose import Limit, Pose, evaluate_vector
from .samples import Values
from .tolerances import DRAWN_GAP, SAME_PLACE
from .vector_graph import mentioned
from .vectors import Vectors

Coordinates = tuple[float, float]


def places_of(drawn: Sequence[Drawn], values: Values) -> dict[str, Coordinates]:
    """Return where points are drawn, in metres."""
    known = (d for d in drawn if symbols(d.x) | symbols(d.y) <= values.keys())
    return {d.point: (evaluate(d.x, values), evaluate(d.y, values)) for d in known}


def given_by_hand(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters that stand in the description, without the drive and what is drawn.

    What lies between pivots at coordinates, lengths and angles, is drawn as well.
    """
    pivots = (pivot.span for pivot in mechanism.each(Pivot))
    places, drive = [*(drawn.span for drawn in mechanism.drawn), *pivots], mechanism.drive_name
    declared = (p for p in mechanism.parameters if p.name != drive)
    return frozenset(p.name for p in declared if not any(_is_in(p.span, at) for at in places))


def _is_in(span: Span, place: Span) -> bool:
    return place.start <= span.start and span.end <= place.end


def drawn_elsewhere(
    drawn: Sequence[Drawn], vectors: Vectors, values: Values
) -> Iterator[Diagnostic]:
    """Yield W320 for the point that is farthest from where it is drawn."""
    places = places_of(drawn, values)
    real = dict(_real(places, vectors, values))
    gaps = {point: math.dist(at, places[point]) for point, at in real.items()}
    farthest = max(gaps, key=lambda point: gaps[point], default="")
    slack = max((d.slack for d in drawn), default=0.0)
    if farthest and gaps[farthest] > slack + DRAWN_GAP * _size(places):
        (one,) = (d for d in drawn if d.point == farthest)
        least = SAME_PLACE * _size(places)
        x, y = (_shown(part if abs(part) > least else 0.0, one.unit) for part in real[farthest])
        gap = _shown(gaps[farthest], one.unit)
        yield messages.drawn_elsewhere(one.span, farthest, f"({x}, {y})", gap)


def _real(
    places: Mapping[str, Coordinates], vectors: Vectors, values: Values
) -> Iterator[tuple[str, Coordinates]]:
    """Yield where drawn points are, as far as their vectors have values."""
    for point in places:
        path = vectors.path("", point)
        if path and not vectors.is_open(path) and mentioned(path) <= values.keys():
            yield point, evaluate_vector(path, values)


def _size(places: Mapping[str, Coordinates]) -> float:
    return max((math.hypot(*at) for at in places.values()), default=0.0)


def _shown(size: float, unit: str) -> str:
    return in_unit(size, unit or "m", 4)


def moved_from_drawing(pose: Pose, report: Report) -> Pose:
    """Return the pose with its drive, and what has a value from outside, where they are set to.

    Lengths and closures are those of the drawing. Reports E340 where a loop does not close there.
    """
    mechanism, before = pose.mechanism.moved, pose.mechanism.parameters
    pairs = zip(mechanism.parameters, before, strict=True)
    first = next((moved for moved, drawn in pairs if moved is not drawn), None)
    if first is None:
        return pose
    free = tuple(p.name for p in mechanism.parameters if not p.dependent)
    moved = replace(pose, mechanism=mechanism, free=free)
    if limit := _open_loop(moved):
        drive = mechanism.drive
        at = drive.span if drive and drive.parameter == first.name else first.given
        is_followed = any(each.group == "system" for each in pose.limits)
        report.add(open_messages.out_of_reach(at, limit.loop, first.name, is_followed))
    return moved


def _open_loop(pose: Pose) -> Limit | None:
    """Return the limit of a loop that does not close at the default values, None where all do."""
    formulas = {**dependent(pose.mechanism), **dict(pose.closing)}
    values = Chain(formulas).complete(defaults(pose.mechanism))
    for limit in pose.limits:
        margins = [_evaluated(margin, values) for margin in limit.margins]
        found = [values[name] for name in formulas if name in values]
        is_lost = limit.group == "system" and not all(map(math.isfinite, found))
        if is_lost or any(margin < 0 for margin in margins):
            return limit
    return None


def _evaluated(margin: Product, values: Mapping[str, float]) -> float:
    """Return the value of what is positive where a loop closes, NaN where it has none."""
    try:
        return margin.evaluate(values)
    except (KeyError, ZeroDivisionError, ValueError, OverflowError):
        return math.nan
