"""Boxes of values: over what ranges parameters may be moved together."""

import math
from collections.abc import Iterable

from ..algebra.from_formula import to_product
from ..algebra.intervals import LEAST, IntervalBox, NumberInterval, bounds, sign, widened
from ..base.frozen import replace
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Formula, Number, Product, Sum, is_call
from ..formula.walk import symbols
from ..units import ANGLE
from .mechanism import Mechanism, Parameter
from .values import is_constant, range_of


def range_box(mechanism: Mechanism) -> IntervalBox:
    """Return the box over which trends are stated: ranges, the drive's stroke, and values."""
    box = {p.name: _range(p) for p in mechanism.parameters if _is_known(p)}
    known = {name: interval for name, interval in box.items() if interval is not None}
    return {**known, **_stroke(mechanism)}


def _is_known(parameter: Parameter) -> bool:
    """Return whether a parameter follows from no other: a constant of a drawing is known, too."""
    return not parameter.dependent or is_constant(parameter)


POSITIVE = NumberInterval(1e-150, 1e150)
"""What a length may be, away from where bounds would be lost in rounding."""

NEGATIVE = NumberInterval(-POSITIVE.high, -POSITIVE.low)


def allowed_box(mechanism: Mechanism) -> IntervalBox:
    """Return the box of all values that parameters may take, beyond the default pose."""
    known = filter(_is_known, mechanism.parameters)
    box = {p.name: _allowed(p, _stroke_of(p, mechanism)) for p in known}
    return {name: interval for name, interval in box.items() if interval is not None}


def size_box(mechanism: Mechanism) -> IntervalBox:
    """Return the box of lengths and the like that keep their sign, whatever ranges there are.

    Constants keep their values.
    """
    known = filter(_is_known, mechanism.parameters)
    boxes = {p.name: _allowed(replace(p, range=None)) for p in known}
    return {name: interval for name, interval in boxes.items() if interval is not None}


def stroke_box(mechanism: Mechanism) -> IntervalBox:
    """Return the box of all values within the ranges given, that of the drive being its stroke."""
    return {**allowed_box(mechanism), **_stroke(mechanism)}


def given_box(mechanism: Mechanism) -> IntervalBox:
    """Return the box of all values within the ranges given, with those of loads of known size."""
    box = dict(stroke_box(mechanism))
    loads = {load.name: load.tie for load in mechanism.loads if load.tie}
    names = {load.name for load in mechanism.loads}
    given = {let.name: let.value for let in mechanism.lets if let.name in names}
    for name, size in (*given.items(), *loads.items()):
        interval = bounds(to_product(size), box)
        if math.isfinite(sum(interval)):
            box[name] = interval
    return box


ALIGNED = 1e-9
"""How far from 0° and 90° an angle of a triangle is at least: elsewhere its sides are in line."""


def with_angles(box: IntervalBox, definitions: Iterable[tuple[str, Formula]]) -> IntervalBox:
    """Return a box with the distances and angles of definitions, as far as these have bounds.

    Where points of a distance meet, or sides of a triangle are in line, nothing has a value.

    >>> from ..formula.tree import Symbol
    >>> beta = ("beta", Call("asin", (Symbol("a"),)))
    >>> low, high = with_angles({"a": POSITIVE}, [beta])["beta"]
    >>> 0 < low < high < math.pi / 2
    True
    """
    known = dict(box)
    for name, formula in definitions:
        if is_call(formula, "hypot"):
            known[name] = POSITIVE
        elif math.isfinite(sum(found := _angle(formula, known))):
            known[name] = found
    return known


def _angle(formula: Formula, box: IntervalBox) -> NumberInterval:
    """Return bounds of an angle that may be the sum of others."""
    match formula:
        case Sum(terms):
            parts = [_angle(term, box) for term in terms]
            return widened(sum(p.low for p in parts), sum(p.high for p in parts))
        case Product((Number(value), Call("asin" | "acos" | "atan2") as arc)) if value == -1:
            low, high = _angle(arc, box)
            return NumberInterval(-high, -low)
        case Call("asin" | "acos" as function):
            least = 0.0 if function == "acos" else -math.pi / 2
            low, high = bounds(to_product(formula), box)
            return _between(max(least, low), min(least + math.pi, high))  # or NaN
        case Call("atan2", (up, right)):
            return _between(*_quadrants(_side(up, box), _side(right, box)))
        case _:
            return bounds(to_product(formula), box)


def _between(low: float, high: float) -> NumberInterval:
    return NumberInterval(low + ALIGNED, high - ALIGNED)


def _side(formula: Formula, box: IntervalBox) -> int:
    """Return the sign of a component of a vector, 0 where it is open; that of a root is 1."""
    return 1 if is_call(formula, "sqrt") else sign(to_product(formula), box) or 0


def _quadrants(up: int, right: int) -> tuple[float, float]:
    """Return between what a direction is whose components have signs, 0 where these are open.

    >>> _quadrants(1, -1) == (math.pi / 2, math.pi)
    True
    """
    quarter = math.pi / 2
    if not up:
        return (-quarter, quarter) if right > 0 else (-math.inf, math.inf)
    low, high = {1: (0.0, quarter), -1: (quarter, math.pi), 0: (0.0, math.pi)}[right]
    return (low, high) if up > 0 else (-high, -low)


def _stroke(mechanism: Mechanism) -> IntervalBox:
    """Return the stroke of a drive that has no other range."""
    drive = mechanism.drive
    if drive is None or mechanism.parameter(drive.parameter).range is not None:
        return {}
    stroke = range_of(drive.parameter, mechanism)
    return {drive.parameter: widened(*stroke)} if stroke else {}


def _stroke_of(parameter: Parameter, mechanism: Mechanism) -> tuple[Formula | None, ...]:
    """Return the ends of the stroke of the drive's parameter, as far as there are any."""
    drive = mechanism.drive
    return (drive.low, drive.high) if drive and drive.parameter == parameter.name else ()


def _allowed(parameter: Parameter, stroke: Iterable[Formula | None] = ()) -> NumberInterval | None:
    """Return the range of a parameter; without one, lengths and the like keep their sign.

    A value from outside and a stroke that go beyond the range are allowed, with all between.
    """
    if parameter.range is not None or is_constant(parameter):
        return _with_values(_range(parameter), (parameter.value, parameter.outside, *stroke))
    if parameter.dimension == ANGLE:
        return None
    value = 1.0 if parameter.value is None else evaluate(parameter.value, {})
    return POSITIVE if value > 0 else NEGATIVE if value < 0 else None


def _with_values(
    interval: NumberInterval | None, given: Iterable[Formula | None]
) -> NumberInterval | None:
    values = [evaluate(value, {}) for value in given if value is not None and not symbols(value)]
    if interval is None or not values:
        return interval
    return widened(min(interval.low, *values), max(interval.high, *values))


def _range(parameter: Parameter) -> NumberInterval | None:
    if parameter.range is not None:
        low, high = (evaluate(end, {}) for end in parameter.range)
        return widened(low, high)
    if parameter.value is not None:
        value = evaluate(parameter.value, {})
        return widened(value, value)
    return None if parameter.dimension == ANGLE else NumberInterval(LEAST, math.inf)
