"""Boxes of values: over what ranges parameters may be moved together."""

import math

from ..algebra.intervals import Box, Interval, widened
from ..formula.walk import evaluate
from ..units import ANGLE
from .mechanism import Mechanism, Parameter


def range_box(mechanism: Mechanism) -> Box:
    """Return the box over which trends are stated."""
    box = {p.name: _range(p) for p in mechanism.parameters if not p.dependent}
    return {name: interval for name, interval in box.items() if interval is not None}


POSITIVE = Interval(1e-150, 1e150)
"""What a length may be, away from where bounds would be lost in rounding."""


def allowed_box(mechanism: Mechanism) -> Box:
    """Return the box of all values that parameters may take, beyond the default pose."""
    box = {p.name: _allowed(p) for p in mechanism.parameters if not p.dependent}
    return {name: interval for name, interval in box.items() if interval is not None}


def _allowed(parameter: Parameter) -> Interval | None:
    """Return the range of a parameter; without one, lengths and the like keep their sign."""
    if parameter.range is not None:
        return _range(parameter)
    is_positive = parameter.value is None or evaluate(parameter.value, {}) > 0
    return POSITIVE if is_positive and parameter.dimension != ANGLE else None


def _range(parameter: Parameter) -> Interval | None:
    if parameter.range is not None:
        low, high = (evaluate(end, {}) for end in parameter.range)
        return widened(low, high)
    if parameter.value is not None:
        value = evaluate(parameter.value, {})
        return widened(value, value)
    return None if parameter.dimension == ANGLE else Interval(5e-324, math.inf)
