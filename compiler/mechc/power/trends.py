"""Where a result rises and falls: signs of its derivatives over the range, proved.

The box is made of the parameters' ranges; a parameter without a range stands at its
value, and a length without a value is anything positive.
"""

import math
from collections.abc import Iterator

from ..algebra.formula import evaluate
from ..algebra.product import Product
from ..model.mechanism import Mechanism, Parameter
from ..units import ANGLE
from .intervals import Box, Interval, sign, widened
from .result import Trend

DEPTH = 7
"""The box is halved along its widest range at most this many times."""


def ranges(mechanism: Mechanism) -> Box:
    """Return the box over which trends are stated."""
    box = {p.name: _range(p) for p in mechanism.parameters if not p.dependent}
    return {name: interval for name, interval in box.items() if interval is not None}


def _range(parameter: Parameter) -> Interval | None:
    if parameter.range is not None:
        low, high = (evaluate(end, {}) for end in parameter.range)
        return widened(low, high)
    if parameter.value is not None:
        value = evaluate(parameter.value, {})
        return widened(value, value)
    return None if parameter.dimension == ANGLE else Interval(5e-324, math.inf)


def trend(slope: Product, box: Box) -> Trend:
    """Return how a result moves with a parameter, from its derivative."""
    if not slope:
        return "constant"
    signs = set(_signs(slope, box))
    if signs == {1}:
        return "rises"
    if signs == {-1}:
        return "falls"
    return "turns" if {1, -1} <= signs else "unknown"


def _signs(slope: Product, box: Box) -> Iterator[int | None]:
    """Yield the signs over parts of the box, halved until each is proved."""
    waiting = [(box, 0)]
    while waiting:
        part, depth = waiting.pop()
        found = sign(slope, part)
        if found is None and depth < DEPTH and (name := _widest(part)):
            waiting.extend((half, depth + 1) for half in _halves(part, name))
        else:
            yield found


def _widest(box: Box) -> str | None:
    """Return the parameter with the widest finite range, relative to its size."""
    widths = {
        name: (high - low) / max(abs(low), abs(high), 1e-300)
        for name, (low, high) in box.items()
        if math.isfinite(high - low)
    }
    name = max(widths, key=lambda n: widths[n], default=None)
    return name if name is not None and widths[name] > 1e-9 else None


def _halves(box: Box, name: str) -> Iterator[Box]:
    low, high = box[name]
    middle = (low + high) / 2
    for half in (Interval(low, middle), Interval(middle, high)):
        yield {**box, name: half}
