"""The functions of the language on floats."""

import math
from collections.abc import Callable, Mapping

from . import choices


def _cot(x: float) -> float:
    return math.cos(x) / math.sin(x)


def _sense(x: float, size: float) -> float:
    if abs(x) <= choices.SENSELESS * size:
        return 0.0
    return math.copysign(1.0, x) if x == x else x


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
    **choices.FUNCTIONS,
}
"""Every function of the language, ``sign``, ``sense`` and those of choices, on floats."""
