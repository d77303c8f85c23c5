"""What drives a mechanism, and which closure of a loop is meant."""

import math
from collections.abc import Iterator

from ...base.frozen import replace
from ...diagnostics import Report, drawn_places, stroke
from ...diagnostics.model import doubts, held, quantities, sizes
from ...diagnostics.model import joints as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...syntax import ast
from ...syntax.vocabulary import points_of
from ...units import ANGLE, LENGTH, TIME, Dimension, in_unit
from ..entries import body_through, directions
from ..formulas.definitions import note_speed
from ..formulas.directions import is_beyond_a_turn, note_units, value_of
from ..formulas.expressions import Reader
from ..formulas.measured import fits
from ..formulas.parameters import constant
from ..mechanism import Absolute, Arrow, Assembly, Drive, Mechanism, Offset, Parameter, Turn
from ..names.scope import DESCRIPTION, NameScope, ScopeEntry
from ..statements import every
from ..tolerances import SAME_VALUE, VANISHED
from ..values import following

MOST_TURNS = 100
"""Full turns of a drive that are still a stroke: each is looked at in seven places or more."""

OFF_STROKE = 0.01
"""The part of a stroke by which the default pose is off it before that is remarked upon."""


def read_drives(file: ast.File, scope: NameScope) -> list[Drive]:
    """Return the driving coordinates with their strokes: the first one moves.

    No other parameter may enter a stroke.
    """
    found: dict[str, Drive] = {}
    for statement in every(file, ast.Drive):
        drive = _drive(statement, file, scope)
        if drive and drive.parameter in found:
            first = found[drive.parameter].span
            scope.report.add(held.driven_twice(drive.span, drive.parameter, first))
        elif drive:
            found[drive.parameter] = drive
    return list(found.values())


def _drive(statement: ast.Drive, file: ast.File, scope: NameScope) -> Drive | None:
    """Return the drive that a statement declares; None where an error was reported."""
    ends = _link_ends(statement.name, scope)
    name = _of_a_link(statement.name, file, scope) if ends else statement.name
    entry = scope.entries.get(name.text)
    if entry is None or entry.kind != "parameter":
        if not ends:
            _report_no_parameter(name, file, scope)
        return None
    scope.used.add(name.text)
    low = _end(statement.low, name, scope)
    is_reported = statement.low is not None and low is None
    high = None if is_reported else _end(statement.high, name, scope)
    speed = _speed(statement.speed, name, scope)
    _note_units(statement, (low, high), entry.dimension, scope)
    start = _end(statement.start, name, scope)
    if ends and low is not None and high is not None:
        _keep_stroke(statement, (evaluate(low, {}), evaluate(high, {})), start, name, scope)
    turns = entry.dimension == ANGLE
    if turns and statement.speed is not None:
        lines = {s.name.text: s for s in file.statements if isinstance(s, ast.Param | ast.Let)}
        note_speed(statement.speed, lines, scope)
    own = name.text, low, high, statement.span
    return Drive(*own, ends=ends, speed=speed, start=start, turns=turns)


def _report_no_parameter(name: ast.Name, file: ast.File, scope: NameScope) -> None:
    """Report that a drive names no parameter, and what it may be meant to name."""
    is_guided = any(s.point.text == name.text for s in every(file, ast.Slider))
    hint = messages.driven_by_points(name.text, is_guided) if points_of(name.text) else ""
    scope.unknown(name.span, name.text, scope.names({"parameter"}), hint)


def _note_units(
    statement: ast.Drive,
    ends: tuple[Formula | None, ...],
    measured: Dimension | None,
    scope: NameScope,
) -> None:
    """Note a stroke in two units, but one beyond a turn: W245 says how many turns it is."""
    sizes = [value_of(end, scope) or 0.0 for end in ends if end is not None]
    if measured != ANGLE or not is_beyond_a_turn(*sizes):
        written, what = (statement.low, statement.high), f"the stroke of {statement.name.text}"
        note_units(written, what, statement.span, scope)


def _keep_stroke(
    statement: ast.Drive,
    ends: tuple[float, float],
    start: Formula | None,
    name: ast.Name,
    scope: NameScope,
) -> None:
    """Keep the stroke of what is driven by points for its range; remark on a start beyond it."""
    low, high = min(ends), max(ends)
    scope.ranges[name.text] = low, high
    slack = SAME_VALUE * max(abs(low), abs(high))
    if start is None or low - slack <= evaluate(start, {}) <= high + slack:
        return
    first, last, given = (e.span for e in (statement.low, statement.high, statement.start) if e)
    scope.report.add(quantities.value_outside_range(given, name.text, first.to(last)))


def _speed(speed: ast.Expr | None, name: ast.Name, scope: NameScope) -> Formula | None:
    """Return the rate of the coordinate in time, which may rest on parameters."""
    dimension = scope.entries[name.text].dimension
    if speed is None or dimension is None:
        return None
    rate = Reader(scope, DESCRIPTION).wanted(speed, dimension.over(TIME), "the speed")
    if rate is not None and value_of(rate, scope) == 0:
        scope.report.add(sizes.of_no_size(speed.span, f"the speed of {name.text}"))
    return rate


def _link_ends(name: ast.Name, scope: NameScope) -> tuple[str, str] | None:
    """Return the two points that a drive names, where it names no parameter."""
    match points_of(name.text):
        case (tail, head) if name.text not in scope.entries:
            return tail, head
        case _:
            return None


def _of_a_link(vector: ast.Name, file: ast.File, scope: NameScope) -> ast.Name:
    """Return the name of what a driven link changes, and enter it: its direction or length."""
    name = ast.Name(f"phi_{vector.text}", vector.span)
    ends = set(scope.points.known(vector) or ())
    if any(ends == set(points_of(t.points.text)) for t in every(file, ast.Telescope)):
        name = ast.Name(f"len_{vector.text}", vector.span)
        scope.enter(name.text, ScopeEntry("parameter", vector.span, LENGTH))
    elif ends and any(ends <= set(link.points) for link in scope.points.links.values()):
        scope.enter(name.text, ScopeEntry("parameter", vector.span, ANGLE))
    elif ends:
        scope.report.add(drawn_places.driven_between_bodies(vector.span, vector.text))
    return name


def check_drives(mechanism: Mechanism, report: Report) -> None:
    """Report drives that follow from other parameters, and strokes that make no sense."""
    for drive in mechanism.drives:
        for parameter in mechanism.parameters:
            if parameter.name == drive.parameter:
                _check(drive, parameter.moved, report)


def _check(drive: Drive, moved: Parameter, report: Report) -> None:
    if moved.dependent:
        report.add(messages.drive_depends(drive.span, drive.parameter))
    elif drive.low is not None and drive.high is not None:
        _check_stroke(drive, moved, (evaluate(drive.low, {}), evaluate(drive.high, {})), report)


def _check_stroke(
    drive: Drive, parameter: Parameter, ends: tuple[float, float], report: Report
) -> None:
    """Report a stroke that is empty, or far too long; remark on what it leaves out or passes."""
    low, high = sorted(ends)
    slack = VANISHED * max(abs(low), abs(high))
    turns = (high - low) / (2 * math.pi)
    if high - low <= slack:
        report.add(stroke.empty(drive.span, drive.parameter))
    elif parameter.dimension == ANGLE and turns > MOST_TURNS:
        report.add(stroke.too_many_turns(drive.span, drive.parameter, turns, MOST_TURNS))
    elif parameter.range is not None:
        least, most = (evaluate(end, {}) for end in (parameter.range.low, parameter.range.high))
        if low < least - slack or high > most + slack:
            report.add(stroke.beyond_range(drive.span, drive.parameter, parameter.span))
    if parameter.value is not None and _strays(parameter, low, high):
        shown = in_unit(evaluate(parameter.value, {}), parameter.unit, 6)
        report.add(stroke.pose_left_out(drive.span, drive.parameter, shown))


def _strays(parameter: Parameter, low: float, high: float) -> bool:
    """Return whether the value at the default pose is outside a stroke, full turns apart."""
    assert parameter.value is not None
    gap = evaluate(parameter.value, {}) - (low + high) / 2
    if parameter.dimension == ANGLE:
        gap = math.remainder(gap, 2 * math.pi)
    return low < high and abs(gap) > (0.5 + OFF_STROKE) * (high - low)


def _end(end: ast.Expr | None, name: ast.Name, scope: NameScope) -> Formula | None:
    """Return one end of the stroke, a constant of the coordinate's dimension."""
    found = constant(end, scope, "an end of a stroke") if end else None
    dimension = scope.entries[name.text].dimension
    if found is None or dimension is None:
        return None
    sound = fits(found, dimension, "the stroke", scope)
    return found.formula if sound else None


def read_assemblies(file: ast.File, scope: NameScope) -> list[Assembly]:
    """Return the closures that are meant: the turn of three points, or a place on a guide."""
    guided = scope.points.guided | {s.point.text for s in every(file, ast.Slot)}
    found: list[Assembly] = []
    for statement in every(file, ast.Assembly):
        points = scope.points.acting(statement.points)
        if points is None:
            continue
        turns = statement.mode in ("cw", "ccw")
        if (len(points) == 3) != turns or (len(points) == 1) == turns:
            text, mode = statement.points.text, statement.mode
            scope.report.add(messages.assembly_of_wrong_points(statement.span, text, mode))
        elif not turns and points[0] not in guided:
            scope.report.add(messages.assembly_without_guide(statement.span, points[0]))
        else:
            found.append(Assembly(points, statement.mode, statement.span))
    return found


# ----------------------------------------------------------------------------- what the drive moves


def checked(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with what its drive is; remark on one that is no motion."""
    drive = mechanism.drive
    if drive is None:
        return mechanism
    driven = {drive.parameter}
    for name, formula in following(mechanism).definitions:
        if not driven.isdisjoint(symbols(formula)):
            driven.add(name)
    if all(driven.isdisjoint(symbols(formula)) for formula in _moved(mechanism)):
        report.add(doubts.drive_moves_nothing(drive.span, drive.parameter))
    parameters = [p for p in mechanism.parameters if p.name == drive.parameter]
    is_length = any(p.dimension == LENGTH for p in parameters)
    for entry in mechanism.geometry:
        sizes = [f for f in _sizes(entry, is_length) if not driven.isdisjoint(symbols(f))]
        if sizes and isinstance(entry, Arrow | Offset):
            body = body_through((entry.tail, entry.head), mechanism)
            if body:
                found = doubts.drive_reshapes(
                    drive.span, drive.parameter, entry.tail, entry.head, body
                )
                report.add(found)
                return replace(mechanism, drive=replace(drive, reshapes=True))
    return mechanism


def _moved(mechanism: Mechanism) -> Iterator[Formula]:
    """Yield the formulas of all that makes the pose."""
    for entry in mechanism.geometry:
        match entry:
            case Arrow(length=length) if length is not None:
                yield length
            case Offset(x=x, y=y):
                yield from (x, y)
            case Turn(angle=angle):
                yield angle
    yield from (d.angle for d in directions(mechanism) if isinstance(d, Absolute))


def _sizes(entry: object, with_components: bool) -> Iterator[Formula]:
    """Yield the formulas of a vector's size; its components change with an angle, too."""
    match entry:
        case Arrow(length=length) if length is not None:
            yield length
        case Offset(x=x, y=y) if with_components:
            yield from (x, y)
