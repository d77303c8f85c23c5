"""Mirror and copies: what of the mechanism is described, and what follows from it."""

import math
from collections.abc import Iterator, Sequence

from ...diagnostics import Diagnostic
from ...diagnostics.model import doubts
from ...diagnostics.model import joints as messages
from ...diagnostics.model import loads as load_words
from ...diagnostics.model import wheels as wheel_words
from ...source import Span
from ...syntax import ast
from ...units import NUMBER
from ..constants import rational
from ..entries import drawn_places
from ..formulas.directions import parallel, read_direction, value_of
from ..formulas.measured import fits
from ..formulas.parameters import constant
from ..mechanism import (
    Absolute,
    Arrow,
    Copies,
    Direction,
    Force,
    ForcePair,
    Geometry,
    Load,
    Mechanism,
    Mirror,
    Offset,
    Rack,
    Screw,
    Slide,
    Slider,
    WheelPair,
)
from ..names.scope import NameScope
from ..parts.linkage import primed
from ..statements import every, only
from ..tolerances import SAME_VECTOR

MOST_COPIES = 1000
"""More branches than any mechanism has: digits too many."""


def read_mirror(
    file: ast.File, guided: Sequence[Slider | Slide], loads: Sequence[Load], scope: NameScope
) -> Mirror | None:
    """Return the mirror.

    Twins must not be declared; gravity and the guides of shared points lie along its line.
    """
    statement = only(file, ast.Mirror)
    if statement is None:
        return None
    across = read_direction(statement.across, scope)
    shared = _shared(statement.sharing, scope)
    _check_twins(shared, statement.span, scope)
    if across is None:
        return None
    if not isinstance(across, Absolute):
        scope.report.add(load_words.mirror_turns(statement.across.span))
        return None
    if off := next(_off_the_line(guided, loads, across, shared, scope), None):
        scope.report.add(load_words.off_the_mirror(off[0], off[1], statement.span))
    if not any(isinstance(load, ForcePair) for load in loads):
        along = next(_guided_apart(file, guided, across, shared, scope), "")
        if along or not statement.sharing:
            scope.report.add(doubts.halves_apart(statement.span, along))
    return Mirror(across, shared, statement.span)


def _guided_apart(
    file: ast.File,
    guided: Sequence[Slider | Slide],
    across: Direction,
    shared: Sequence[str],
    scope: NameScope,
) -> Iterator[str]:
    """Yield the points that slide along the mirror line where the halves share no moving point."""
    pivots = {statement.point.text for statement in every(file, ast.Pivot)}
    if pivots >= set(shared):
        for body in guided:
            if isinstance(body, Slider) and parallel(body.along, across, scope):
                yield body.point


def _off_the_line(
    guided: Sequence[Slider | Slide],
    loads: Sequence[Load],
    across: Direction,
    shared: Sequence[str],
    scope: NameScope,
) -> Iterator[tuple[Span, str]]:
    """Yield the parts off the mirror line that both halves share, and where they are."""
    for load in loads:
        if isinstance(load, Force) and not _symmetric(load, across, shared, scope):
            yield load.along.span, _bound(load)
    for body in guided:
        points = body.points if isinstance(body, Slide) else (body.point,)
        common = next((p for p in points if p in shared), None)
        if common and not parallel(body.along, across, scope):
            yield body.along.span, f"the guide of the shared {common}"


def check_shared_vectors(
    mirror: Mirror | None, geometry: Sequence[Geometry], scope: NameScope
) -> None:
    """Report vectors between points that both lie on the mirror line, and that do not."""
    for entry in geometry if mirror else ():
        if not mirror or not isinstance(entry, Arrow) or entry.direction is None:
            continue
        on_the_line = {entry.tail, entry.head} <= set(mirror.sharing)
        if on_the_line and not parallel(entry.direction, mirror.across, scope):
            what = f"the vector {entry.tail}{entry.head} between shared points"
            scope.report.add(load_words.off_the_mirror(entry.span, what, mirror.span))


def check_turning_on_the_line(mechanism: Mechanism, scope: NameScope) -> None:
    """Warn of screws and wheels on the line of symmetry: each part has one, though one is seen."""
    for joint in mechanism.joints if mechanism.symmetries else ():
        match joint:
            case Screw():
                _check_screw(joint, mechanism, scope)
            case Rack(pivot=pivot, link=link) if mechanism.is_on_the_line([pivot]):
                scope.report.add(wheel_words.wheel_on_the_line(joint.span, "rack", pivot, link))
            case WheelPair(kind=kind):
                wheels = zip(joint.points, joint.wheels, strict=True)
                twice = (each for each in wheels if each[1] and mechanism.is_on_the_line(each[:1]))
                for pivot, link in twice:
                    scope.report.add(wheel_words.wheel_on_the_line(joint.span, kind, pivot, link))
            case _:
                pass


def _check_screw(screw: Screw, mechanism: Mechanism, scope: NameScope) -> None:
    """Warn of a screw that is described for each part, and has no place of its own in one."""
    points = next(k.points for k in mechanism.links if k.name == screw.link)
    placed = {place.head for place in mechanism.geometry if isinstance(place, Offset)}
    own = mechanism.fixed & (placed | {d.point for d in mechanism.drawn}) & {*points}
    number = mechanism.repeats(points) / mechanism.repeats([screw.point])
    torques = [load for load in mechanism.loads if screw.link in load.links]
    if number <= 1 or own - mechanism.shared or any(load.times != 1 for load in torques):
        return
    name = next((load.name for load in torques), "")
    found = (screw.point, screw.link, name, int(number))
    scope.report.add(wheel_words.screw_in_each_part(screw.span, *found))


def check_shared_places(mechanism: Mechanism, scope: NameScope) -> None:
    """Report drawn points that both halves share and that are not on one line across the mirror."""
    mirror, slacks = mechanism.mirror, {d.point: d.slack for d in mechanism.drawn}
    if mirror is None or not isinstance(mirror.across, Absolute):
        return
    angle = value_of(mirror.across.angle, scope)
    placed = [(p, at) for p, at in _placed(mechanism, scope) if p in mirror.sharing]
    if angle is None:
        return
    for point, place in placed[1:]:
        first, start = placed[0]
        slack = slacks.get(first, 0.0) + slacks.get(point, 0.0)
        if not _is_along(start, place, angle, slack):
            what = f"the way from {first} to {point}, which both halves share,"
            span = mechanism.spans.get(point, mirror.span)
            scope.report.add(load_words.off_the_mirror(span, what, mirror.span))
    _check_guided_twice(mechanism, mirror, angle, scope)


def _is_along(
    start: tuple[float, float], end: tuple[float, float], angle: float, slack: float
) -> bool:
    """Return whether a way leads in a direction, or against it, but for what is slack."""
    x, y = (b - a for a, b in zip(start, end, strict=True))
    off = abs(y * math.cos(angle) - x * math.sin(angle))
    return off <= slack + SAME_VECTOR * math.hypot(x, y)


def _check_guided_twice(
    mechanism: Mechanism, mirror: Mirror, angle: float, scope: NameScope
) -> None:
    """Warn of a load on a point that slides on the mirror line and that each half has."""
    places = dict(_placed(mechanism, scope))
    guides = [k for k in mechanism.each(Slider) if not k.is_of_slide]
    places |= {k.point: places[k.through] for k in guides if k.through in places}
    start = next((places[point] for point in mirror.sharing if point in places), None)
    for slider in guides if start else ():
        point, place = slider.point, places.get(slider.point)
        acting = [k for k in mechanism.loads if point in k.points and k.times == 1]
        if point in mechanism.shared or not (start and place and acting):
            continue
        is_along = parallel(slider.along, mirror.across, scope)
        if is_along and _is_along(start, place, angle, 0.0):
            names, load = ", ".join((*mirror.sharing, point)), acting[0]
            scope.report.add(load_words.on_the_line_twice(load.span, load.name, point, names))


def _placed(mechanism: Mechanism, scope: NameScope) -> Iterator[tuple[str, tuple[float, float]]]:
    """Yield the points that are drawn where their coordinates have values, with these."""
    for point, at in drawn_places(mechanism).items():
        x, y = (value_of(part, scope) for part in at)
        if x is not None and y is not None:
            yield point, (x, y)


def _symmetric(load: Force, across: Direction, shared: Sequence[str], scope: NameScope) -> bool:
    """Return whether a force acts on both halves alike: gravity and forces on shared points."""
    bound = load.weight or load.point in shared
    return not bound or parallel(load.along, across, scope)


def _shared(sharing: Sequence[ast.Name], scope: NameScope) -> tuple[str, ...]:
    found = [scope.points.acting(name) for name in sharing]
    return tuple(dict.fromkeys(points[0] for points in found if points))


def _check_twins(shared: Sequence[str], mirror: Span, scope: NameScope) -> None:
    places = scope.points.places
    for point in places:
        twin = primed(point)
        if point not in shared and twin in places:
            scope.report.add(messages.twin_declared(places[twin], twin, point, mirror))


def read_copies(file: ast.File, scope: NameScope) -> Copies | None:
    """Return how many identical branches the description stands for."""
    statement = only(file, ast.Copies)
    if statement is None:
        return None
    shared = _shared(statement.sharing, scope)
    found = constant(statement.number, scope, "the number of copies")
    if not found or not fits(found, NUMBER, "the number of copies", scope):
        return None
    value = rational(found.formula)
    if value is None or not 2 <= value <= MOST_COPIES or value.denominator != 1:
        span = statement.number.span
        shown = scope.report.source.written(span)
        scope.report.add(messages.copies_not_whole(span, shown))
        return None
    if set(shared) <= {statement.point.text for statement in every(file, ast.Pivot)}:
        scope.report.add(doubts.copies_apart(statement.span))
    return Copies(value, shared, statement.span)


def check_axis_of_copies(mechanism: Mechanism, scope: NameScope) -> None:
    """Warn of points that copies share and no guide keeps on their axis; refuse loads off it."""
    copies = mechanism.copies
    if copies is None:
        return
    guided = {slider.point for slider in mechanism.each(Slider)} | mechanism.fixed
    guided |= {point for slide in mechanism.slides for point in slide.points}
    for point in copies.sharing:
        if point not in guided:
            scope.report.add(doubts.copies_off_axis(copies.span, point))
    if off := next(_off_the_axis(mechanism, copies, scope), None):
        scope.report.add(off)


def _off_the_axis(mechanism: Mechanism, copies: Copies, scope: NameScope) -> Iterator[Diagnostic]:
    """Yield the loads that do not act on all branches alike, as far as a guide is their axis."""
    axes = (slider for slider in mechanism.each(Slider) if slider.point in copies.sharing)
    if (axis := next(axes, None)) is None:
        return
    for load in mechanism.loads:
        if isinstance(load, Force) and not _symmetric(load, axis.along, copies.sharing, scope):
            at = load.along.span
            yield load_words.off_the_axis(at, _bound(load), axis.point, copies.span)


def _bound(load: Force) -> str:
    """Return a load that acts on all parts, in words."""
    return "gravity" if load.weight else f"force {load.name} on the shared {load.point}"
