"""What drives a drawn mechanism: ``drive OA``, and values that the drawing gives."""

import math
from collections.abc import Mapping
from typing import assert_never

from ...base.frozen import replace
from ...diagnostics import Diagnostic
from ...diagnostics import drawn_places as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, Symbol
from ...formula.walk import symbols
from ...units import ANGLE, LENGTH
from ..constants import decimal
from ..entries import vector_between
from ..mechanism import (
    Absolute,
    Arrow,
    Drive,
    Geometry,
    Interval,
    Mechanism,
    Offset,
    Parameter,
    Turn,
)
from ..tolerances import SAME_VALUE
from .sketch import Sketch

TailAndHead = tuple[str, str]
"""The two points of what is driven."""


def fault_of(
    drive: Drive, ends: TailAndHead, mechanism: Mechanism, sketch: Sketch
) -> Diagnostic | None:
    """Return why a link cannot be driven: it is not drawn, or its direction is given."""
    missing = [p for p in ends if p not in sketch.places]
    entry = vector_between(ends, mechanism.geometry)
    if entry is not None and _is_given(entry, drive):
        return messages.driven_is_given(drive.span, "".join(ends), entry.span)
    return messages.driven_not_drawn(drive.span, "".join(ends), missing[0]) if missing else None


def with_driven(mechanism: Mechanism, drive: Drive, ends: TailAndHead, unit: str) -> Mechanism:
    """Return the mechanism in which a parameter is the direction, or length, of what is driven.

    A length is shown in the ``unit`` of the drawing.
    """
    old, moved = vector_between(ends, mechanism.geometry), Symbol(drive.parameter)
    span = old.span if old else drive.span
    if drive.turns:
        length = old.length if isinstance(old, Arrow) else None
        entry = Arrow(*ends, length, Absolute(moved, drive.span), span)
    else:
        entry = Arrow(*ends, moved, None, span)
    dimension, unit = (ANGLE, "deg") if drive.turns else (LENGTH, unit)
    made = Parameter(drive.parameter, dimension, drive.span, range=_stroke(drive), unit=unit)
    others = tuple(g for g in mechanism.geometry if g is not old)
    return replace(mechanism, parameters=(*mechanism.parameters, made), geometry=(entry, *others))


def _stroke(drive: Drive) -> Interval | None:
    if drive.low is None or drive.high is None:
        return None
    low, high = sorted((drive.low, drive.high), key=lambda end: evaluate(end, {}))
    return Interval(low, high)


def _is_given(entry: Arrow | Offset, drive: Drive) -> bool:
    if isinstance(entry, Offset):
        return True
    return (entry.direction if drive.turns else entry.length) is not None


def with_value(parameter: Parameter, value: float) -> Parameter:
    """Return a parameter with its value at the default pose.

    An angle is moved by whole turns to where it is nearest to the middle of its range.
    """
    ends = parameter.range
    if ends and parameter.dimension == ANGLE:
        middle = (evaluate(ends.low, {}) + evaluate(ends.high, {})) / 2
        value = middle + math.remainder(value - middle, 2 * math.pi)
    return replace(parameter, value=decimal(value))


def is_outside(parameter: Parameter) -> bool:
    """Return whether the value of a parameter is not in its range."""
    if parameter.value is None or parameter.range is None or parameter.dependent:
        return False
    low, high = (evaluate(end, {}) for end in parameter.range)
    return not low <= evaluate(parameter.value, {}) <= high


def drawn_value(name: str, entry: Geometry, sketch: Sketch) -> float | None:
    """Return the value of a parameter at which a vector or an angle is as drawn.

    None where it is not drawn, or where the parameter does not enter in proportion.
    """
    for formula, drawn in _drawn(entry, sketch) if sketch.has(entry) else ():
        known: Mapping[str, float] = {**sketch.values, name: 0.0}
        if name not in symbols(formula) or not symbols(formula) <= known.keys():
            continue
        at = [evaluate(formula, {**known, name: value}) for value in (0.0, 1.0, 2.0)]
        if math.isclose(at[2] - at[1], at[1] - at[0], rel_tol=SAME_VALUE) and at[1] != at[0]:
            return (drawn - at[0]) / (at[1] - at[0])
    return None


def _drawn(entry: Geometry, sketch: Sketch) -> list[tuple[Formula, float]]:
    """Return the formulas of an entry, and what they are in the drawing."""
    match entry:
        case Arrow(tail, head, length, direction):
            x, y = sketch.way(tail, head)
            found = [(length, math.hypot(x, y))] if length else []
            turned = (
                [(direction.angle, math.atan2(y, x))] if isinstance(direction, Absolute) else []
            )
            return [*turned, *found]
        case Offset(tail, head, along_x, along_y):
            x, y = sketch.way(tail, head)
            return [(along_x, x), (along_y, y)]
        case Turn(first, vertex, second, angle):
            (ax, ay), (bx, by) = sketch.way(vertex, first), sketch.way(vertex, second)
            return [(angle, math.atan2(ax * by - ay * bx, ax * bx + ay * by))]
        case _:
            assert_never(entry)
