"""The default pose in numbers, poses near it, and drawn places, for what algebra cannot see."""

import math
from collections.abc import Iterable, Sequence

from ..algebra.product import Product
from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model.mechanism import Drawn, Mechanism, Parameter
from ..model.values import bounds, following
from ..units import ANGLE, LENGTH
from .pose import PoseDefinition

NUMBER = 5
"""The default pose, and two pairs of poses on either side of it."""

POSE_STEP = 0.02
"""The part of a value, or of a usual one, by which poses lie apart."""

USUAL_ANGLE, USUAL_PART = 0.1, 0.01
"""A value nearer to zero is moved by a part of this: in radians, or of the greatest length."""

Values = dict[str, float]

Coordinates = tuple[float, float]
"""In metres."""

GivenParameters = list[tuple[Parameter, float | None]]
"""Parameters that follow from no others, each with its value."""


def poses_nearby(mechanism: Mechanism, definitions: Iterable[PoseDefinition]) -> list[Values]:
    """Return the default pose and some others; what has no value gets one in the others only.

    The others are pairs, each of which has the default pose in its middle: of two motions that
    meet near it, one holds in it and in one pose at least of each pair.
    """
    chain = following(mechanism, definitions)
    given = _given(mechanism)
    return [chain.complete(_moved(given, number)) for number in range(NUMBER)]


def default_pose(mechanism: Mechanism, definitions: Iterable[PoseDefinition]) -> Values:
    """Return the first of :func:`poses_nearby`."""
    chain = following(mechanism, definitions)
    return chain.complete(_moved(_given(mechanism), 0))


def is_behind(length: Product, poses: Iterable[Values]) -> bool:
    """Return whether a length that was found, such as a place on a line, is negative."""
    known = (values for values in poses if symbols(length.formula()) <= values.keys())
    values = next(known, None)
    return values is not None and length.evaluate(values) < 0


def places_of(drawn: Sequence[Drawn], values: Values) -> dict[str, Coordinates]:
    """Return where points are drawn, in metres."""
    known = (d for d in drawn if symbols(d.x) | symbols(d.y) <= values.keys())
    return {d.point: (evaluate(d.x, values), evaluate(d.y, values)) for d in known}


def _given(mechanism: Mechanism) -> GivenParameters:
    free = [p for p in mechanism.parameters if not p.dependent]
    return [(p, None if p.value is None else evaluate(p.value, {})) for p in free]


def _moved(given: GivenParameters, number: int) -> Values:
    """Return values that differ from the default ones, even where those are zero."""
    lengths = (abs(v) for p, v in given if v is not None and p.dimension == LENGTH)
    longest = max(lengths, default=0.0)
    values: Values = {}
    pair, side = (number + 1) // 2, 1 if number % 2 else -1
    for i, (parameter, value) in enumerate(given):
        part = side * math.sin(1 + 7 * pair + i)
        if value is None and number:
            low, high = bounds(parameter) if parameter.range else (0.6, 1.2)
            values[parameter.name] = (low + high) / 2 + (high - low) / 2 * part
        elif value is not None:
            usual = USUAL_ANGLE if parameter.dimension == ANGLE else USUAL_PART * longest
            step = POSE_STEP * part * max(abs(value), usual)
            values[parameter.name] = value + step * bool(number)
    return values
