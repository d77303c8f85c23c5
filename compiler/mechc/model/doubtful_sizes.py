"""Angles and lengths that can be meant, and hardly ever are: too large, or zero."""

import math
from collections.abc import Iterable, Iterator

from ..diagnostics import Diagnostic
from ..diagnostics.model import doubtful_sizes as messages
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..source import Span
from ..units import ANGLE
from .entries import body_through, directions
from .joint_friction import RopeFriction
from .mechanism import (
    Absolute,
    Arrow,
    Mechanism,
    Parameter,
)
from .tolerances import SAME_VALUE
from .values import Chain, Values, defaults

TURN = 2 * math.pi * (1 + SAME_VALUE)

FARTHEST = 1e6
"""Lengths in metres beyond which a vector is as good as infinite."""


# -------------------------------------------------------------------------- angles


def beyond_a_turn(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the angles beyond a turn: values, ends of ranges and strokes, directions.

    A rope may be wound around a pulley several times, and wheels lead links round and round.
    """
    ranged = {p.name for p in mechanism.parameters if p.range}
    wraps = (j.wrap for j in mechanism.friction.joints if isinstance(j, RopeFriction))
    wound = {name for wrap in wraps for name in symbols(wrap)}
    if mechanism.meshes:
        wound |= _turning(mechanism)
    for parameter in mechanism.parameters:
        turns = parameter.dimension == ANGLE and parameter.name not in wound
        if turns and not parameter.dependent and not _is_drawn(parameter, mechanism):
            yield from _turn_of(parameter)
    if not mechanism.meshes:
        yield from _turns_written(mechanism, ranged)


def _is_drawn(parameter: Parameter, mechanism: Mechanism) -> bool:
    """Return whether a parameter is the direction of a drawn link, whose range is the stroke."""
    return mechanism.drive is not None and parameter.span == mechanism.drive.span


def _turning(mechanism: Mechanism) -> set[str]:
    """Return the names that directions rest on, and the drive's."""
    given = (d.angle for d in directions(mechanism) if isinstance(d, Absolute))
    driving = {mechanism.drive.parameter} if mechanism.drive else set[str]()
    return driving.union(*map(symbols, given))


def _turns_written(mechanism: Mechanism, ranged: set[str]) -> Iterator[Diagnostic]:
    """Yield the ends of strokes and the directions beyond a turn."""
    drive = mechanism.drive
    angles = mechanism.angles
    is_drawn = drive and _is_drawn(mechanism.parameter(drive.parameter), mechanism)
    if drive and drive.parameter in angles and (is_drawn or drive.parameter not in ranged):
        what = f"an end of the stroke of {drive.parameter}"
        yield from _beyond(drive.span, what, (drive.low, drive.high))
    for direction in directions(mechanism):
        if isinstance(direction, Absolute):
            rest = evaluate(direction.angle, dict.fromkeys(symbols(direction.angle), 0.0))
            if 2 * TURN < abs(rest) < math.inf:
                yield messages.beyond_a_turn(direction.span, "the direction", rest / (2 * math.pi))


def _turn_of(parameter: Parameter) -> Iterator[Diagnostic]:
    value = list(_beyond(parameter.given, f"the value of '{parameter.name}'", (parameter.value,)))
    ends = (parameter.range.low, parameter.range.high) if parameter.range else ()
    yield from value or _beyond(parameter.span, f"an end of the range of '{parameter.name}'", ends)


def _beyond(span: Span, what: str, angles: Iterable[Formula | None]) -> Iterator[Diagnostic]:
    """Yield the remark on the largest of constant angles, if it is beyond a turn."""
    sizes = [evaluate(angle, {}) for angle in angles if angle is not None]
    largest = max(sizes, key=abs, default=0.0)
    if abs(largest) > TURN:
        yield messages.beyond_a_turn(span, what, largest / (2 * math.pi))


# ------------------------------------------------------------------------- lengths


def vanishing_lengths(mechanism: Mechanism, chain: Chain, values: Values) -> Iterator[Diagnostic]:
    """Yield the parameters that may take a length to zero or to infinity, each once.

    A coordinate along a given direction may pass zero.
    """
    given, resting = defaults(mechanism), dict[str, list[Arrow]]()
    for arrow in mechanism.geometry:
        if isinstance(arrow, Arrow) and arrow.length is not None:
            for name in sorted(symbols(arrow.length)):
                resting.setdefault(name, []).append(arrow)
    for parameter in mechanism.parameters:
        for end, where in _reach(parameter, mechanism, values):
            known = chain.complete({**given, parameter.name: end})
            moved = [n for n in known if known[n] != values.get(n)]
            arrows = [a for n in moved for a in resting.get(n, ()) if _fails(a, known)]
            found = next((a for a in arrows if _is_strange(a, known, where, mechanism)), None)
            if found:
                yield _vanishes(found, known, parameter, where)
                break


def _fails(arrow: Arrow, known: Values) -> bool:
    """Return whether a length that has a value is no positive one, or as good as infinite."""
    assert arrow.length is not None
    is_known = symbols(arrow.length) <= known.keys()
    return is_known and not 0 < evaluate(arrow.length, known) < FARTHEST


def _is_strange(arrow: Arrow, known: Values, where: str, mechanism: Mechanism) -> bool:
    """Return whether a length that fails is no coordinate, and no study of sizes."""
    assert arrow.length is not None
    if body_through((arrow.tail, arrow.head), mechanism):
        return where != "the stroke"
    return arrow.direction is None or not abs(evaluate(arrow.length, known)) < FARTHEST


def _vanishes(arrow: Arrow, known: Values, parameter: Parameter, where: str) -> Diagnostic:
    assert arrow.length is not None
    size = evaluate(arrow.length, known)
    shown = f"{size * 1000:.6g} mm" if abs(size) < FARTHEST else "infinity"
    shown = "" if math.isnan(size) else shown
    points = f"{arrow.tail}{arrow.head}"
    return messages.length_vanishes(parameter.span, points, shown, parameter.name, where)


def _reach(
    parameter: Parameter, mechanism: Mechanism, values: Values
) -> Iterator[tuple[float, str]]:
    """Yield how far a parameter may go, and what takes it there."""
    value, drive = values.get(parameter.name), mechanism.drive
    if parameter.range:
        yield evaluate(parameter.range.low, {}), "the range"
        yield evaluate(parameter.range.high, {}), "the range"
    elif drive and drive.parameter == parameter.name:
        yield from ((evaluate(e, {}), "the stroke") for e in (drive.low, drive.high) if e)
    if parameter.tolerance is not None and value is not None:
        size = evaluate(parameter.tolerance, {})
        yield from ((value + sign * size, "the tolerance") for sign in (-1, 1))
