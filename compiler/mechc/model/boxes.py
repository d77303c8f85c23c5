"""Boxes of values: over what ranges parameters may be moved together."""

import math

from ..algebra.intervals import Box, Interval, widened
from ..formula.walk import evaluate
from ..units import ANGLE
from .mechanism import Mechanism, Parameter
from .values import is_constant


def range_box(mechanism: Mechanism) -> Box:
    """Return the box over which trends are stated."""
    box = {p.name: _range(p) for p in mechanism.parameters if _is_known(p)}
    return {name: interval for name, interval in box.items() if interval is not None}


def _is_known(parameter: Parameter) -> bool:
    """Tell whether a parameter follows from no other: a constant of a drawing is known, too."""
    return not parameter.dependent or is_constant(parameter)


POSITIVE = Interval(1e-150, 1e150)
"""What a length may be, away from where bounds would be lost in rounding."""

NEGATIVE = Interval(-POSITIVE.high, -POSITIVE.low)


def allowed_box(mechanism: Mechanism) -> Box:
    """Return the box of all values that parameters may take, beyond the default pose."""
    box = {p.name: _allowed(p) for p in mechanism.parameters if _is_known(p)}
    return {name: interval for name, interval in box.items() if interval is not None}


def _allowed(parameter: Parameter) -> Interval | None:
    """Return the range of a parameter; without one, lengths and the like keep their sign."""
    if parameter.range is not None or is_constant(parameter):
        return _range(parameter)
    if parameter.dimension == ANGLE:
        return None
    value = 1.0 if parameter.value is None else evaluate(parameter.value, {})
    return POSITIVE if value > 0 else NEGATIVE if value < 0 else None


def _range(parameter: Parameter) -> Interval | None:
    if parameter.range is not None:
        low, high = (evaluate(end, {}) for end in parameter.range)
        return widened(low, high)
    if parameter.value is not None:
        value = evaluate(parameter.value, {})
        return widened(value, value)
    return None if parameter.dimension == ANGLE else Interval(5e-324, math.inf)
