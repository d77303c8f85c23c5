"""The functions of the language on floats; :mod:`.choices` says what each of those there means."""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise

from .choices import SAME_ROW, SENSELESS, SIGNS


def _cot(x: float) -> float:
    return math.cos(x) / math.sin(x)


def _sense(x: float, size: float) -> float:
    if abs(x) <= SENSELESS * size:
        return 0.0
    return math.copysign(1.0, x) if x == x else x


_HOLDS: Mapping[str, Callable[[float, float], bool]] = {
    "less": lambda a, b: a < b,
    "at_most": lambda a, b: a <= b,
    "more": lambda a, b: a > b,
    "at_least": lambda a, b: a >= b,
    "same": lambda a, b: a == b,
    "differs": lambda a, b: a != b,
}


def _condition(name: str) -> Callable[[float, float], float]:
    holds = _HOLDS[name]
    return lambda a, b: math.nan if a != a or b != b else float(holds(a, b))


def _choose(*parts: float) -> float:
    """Return the chosen one of values; those that are not chosen may be None."""
    for condition, value in zip(parts[::2], parts[1::2], strict=False):
        if math.isnan(condition):
            return math.nan
        if condition:
            return value
    return parts[-1] if len(parts) % 2 else math.nan


def _interpolate(x: float, *rows: float) -> float:
    for (low, start), (high, end) in pairwise(zip(rows[::2], rows[1::2], strict=True)):
        if low <= x <= high:
            return start + (x - low) * ((end - start) / (high - low))
    return math.nan


def _nearest(x: float, rows: Sequence[float]) -> float:
    """Return the row that lies nearest, of two alike the smaller one; rows rise."""
    return next((a for a, b in pairwise(rows) if x <= (a + b) / 2), rows[-1])


def _met(x: float, *rows: float) -> float:
    row = _nearest(x, rows)
    return row if abs(x - row) > float(SAME_ROW) * abs(row) else x


def _row(x: float, *rows: float) -> float:
    values = dict(zip(rows[::2], rows[1::2], strict=True))
    return values[_nearest(x, rows[::2])] if _met(x, *rows[::2]) == x else math.nan


def _next(x: float, *sizes: float) -> float:
    return next((size for size in sizes if x <= size), math.nan)


FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": _cot,
    "sec": lambda x: 1 / math.cos(x),
    "csc": lambda x: 1 / math.sin(x),
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "sqrt": math.sqrt,
    "hypot": math.hypot,
    "abs": abs,
    "sign": lambda x: math.copysign(1.0, x) if x else x,
    "sense": _sense,
    "min": min,
    "max": max,
    "exp": math.exp,
    "log": math.log,
    **{name: _condition(name) for name in SIGNS},
    "both": lambda *conditions: math.prod(conditions),
    "count": lambda *conditions: math.fsum(conditions),
    "choose": _choose,
    "interpolate": _interpolate,
    "met": _met,
    "row": _row,
    "next": _next,
}
"""Every function of the language, ``sign``, ``sense`` and those of choices, on floats."""
