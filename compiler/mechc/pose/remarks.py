"""What the default pose breaks of what is written: drawn places, radii of gears, conditions.

The pose is moved, too, where its drive is set to another place than the drawn one.
"""

import math
from collections.abc import Iterator, Mapping, Sequence

from ..algebra.product import Product
from ..base.frozen import replace
from ..base.named import NamedTuple
from ..diagnostics import Diagnostic, Report
from ..diagnostics import drawn_places as drawn_messages
from ..diagnostics import open_loops as open_messages
from ..diagnostics import pose as messages
from ..formula.walk import symbols
from ..model.mechanism import Drawn, WheelPair
from ..model.results import failures
from ..model.values import Chain, defaults, dependent, holds
from ..source import Span
from ..units import in_unit
from . import assembly_checks
from .pose import Closed, Limit, Pose, evaluate_vector
from .samples import Coordinates, Values, default_pose, places_of
from .tolerances import CENTRE_GAP, DRAWN_GAP, SAME_PLACE
from .vector_graph import mentioned
from .vectors import Vectors


def remark_on_drawing(pose: Pose, vectors: Vectors, closed: Closed, report: Report) -> None:
    """Remark on what the drawing breaks: places, centre distances, the line of a mirror.

    E318 reports an assembly that it refutes; W301 remarks on others that decide nothing.
    """
    if not (closed.idle or pose.mechanism.drawn or pose.radii or pose.mechanism.mirror):
        return
    default = default_pose(pose.mechanism, pose.definitions)
    for assembly in closed.idle:
        for remark in assembly_checks.remarks(assembly, vectors, default):
            report.add(remark)
    for fault in _drawn_elsewhere(pose.mechanism.drawn, vectors, default):
        report.add(fault)
    for misfit in _misfits(pose, vectors, default):
        report.add(messages.gears_apart(*misfit))
    for remark in _off_the_mirror_line(pose, vectors, default):
        report.add(remark)


def remark_on_conditions(pose: Pose, closed: Closed, report: Report) -> None:
    """Remark on conditions that the default pose breaks, those that were remarked on left out.

    What a sheet gives is held against its conditions where it is calculated.
    """
    if not pose.mechanism.requires:
        return
    default = default_pose(pose.mechanism, pose.closing)
    given = {p.name for p in pose.mechanism.parameters} - closed.found
    lets = {let.name for let in pose.mechanism.lets}
    for condition in pose.mechanism.requires:
        is_of_sheet = not pose.mechanism.links and symbols(condition.left, condition.right) <= given
        if not is_of_sheet and not holds(condition, default):
            report.add_first(failures.broken(condition, default, report.source, lets))


def _drawn_elsewhere(
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
        yield drawn_messages.drawn_elsewhere(one.span, farthest, f"({x}, {y})", gap)


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


class _Misfit(NamedTuple):
    """A pair of gears, how far its centres are apart and how far its radii put them.

    ``meant`` is what they would fit as: "inner" or "outer" gears, "diameters", or ''.
    """

    at: Span
    pivots: str
    apart: float
    wanted: float
    meant: str


def _misfits(pose: Pose, vectors: Vectors, values: Values) -> Iterator[_Misfit]:
    """Yield the gears whose centres have places that do not fit their radii."""
    for mesh in pose.mechanism.each(WheelPair):
        line = vectors.path(mesh.first, mesh.second)
        lengths = [pose.radii[r] for r in (mesh.first_radius, mesh.second_radius)]
        used = {s for length in lengths for s in symbols(length.formula())}
        if mesh.kind != "gear" or not line or not used | set(mentioned(line)) <= values.keys():
            continue
        first, second = (length.evaluate(values) for length in lengths)
        apart = math.hypot(*evaluate_vector(line, values))
        outer, inner = first + second, abs(first - second)
        wanted, other = (inner, outer) if mesh.same else (outer, inner)
        if not _near(apart, wanted):
            meant = ("outer" if mesh.same else "inner") if _near(apart, other) else ""
            meant = "diameters" if _near(apart, wanted / 2) else meant
            yield _Misfit(mesh.span, f"{mesh.first} and {mesh.second}", apart, wanted, meant)


def _near(apart: float, wanted: float) -> bool:
    return abs(apart - wanted) <= CENTRE_GAP * apart


def _off_the_mirror_line(pose: Pose, vectors: Vectors, values: Values) -> Iterator[Diagnostic]:
    """Yield W305 for each point that is not on the mirror line with the first one."""
    mirror, axis = pose.mechanism.mirror, pose.axis
    if mirror is None or axis is None:
        return
    for point in mirror.sharing[1:]:
        first = mirror.sharing[0]
        way = vectors.path(first, point)
        used = set(mentioned(way)) | dict(axis.terms).keys() if way else set()
        if not way or vectors.is_open(way) or not used <= values.keys():
            continue
        (x, y), across = evaluate_vector(way, values), axis.evaluate(values)
        gap = abs(y * math.cos(across) - x * math.sin(across))
        if gap > CENTRE_GAP * max(abs(arm.length.evaluate(values)) for arm in way):
            yield messages.halves_apart(mirror.span, f"{first} and {point}", gap)


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
