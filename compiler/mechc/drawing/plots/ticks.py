"""Where an axis has its ticks: at multiples of 1, 2 or 5, of an angle also of 15, 30, 45, 90."""

import math

from ...base.named import NamedTuple
from ..tolerances import ONE_VALUE, SAME_STEP, SAME_WHOLE_NUMBER

TICK_STEPS = (1.0, 2.0, 5.0, 10.0)
"""The steps between ticks, times a power of ten."""

OF_DEGREES = (15.0, 30.0, 45.0, 90.0, 180.0, 360.0)
"""The steps between ticks of many degrees."""

LARGEST, LEAST = 1e5, 1e-3
"""Beyond these a power of ten stands at the end of the axis."""


class Scale(NamedTuple):
    """The values at the ticks, how many decimals they need, and the power of ten to shorten by."""

    ticks: tuple[float, ...]
    step: float
    decimals: int
    exponent: int = 0

    def text(self, value: float) -> str:
        """Return a tick as it is written.

        >>> Scale((), 0.25, 2).text(-0.5)
        '−0.50'
        """
        written = f"{value / 10.0**self.exponent:.{self.decimals}f}"
        plain = written.removeprefix("-") if float(written) == 0 else written
        return plain.replace("-", "−")


def scale(low: float, high: float, most: int, degrees: bool = False) -> Scale:
    """Return the ticks of an axis, at most so many spaces between them.

    >>> scale(2, 40, 8).ticks
    (5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0)
    >>> scale(0, 360, 8, degrees=True).ticks[:3], scale(0.0, 0.19, 5).ticks[-1]
    ((0.0, 45.0, 90.0), 0.15)
    """
    step = _step((high - low) / most, degrees)
    first, last = (
        math.ceil(low / step - SAME_WHOLE_NUMBER),
        math.floor(high / step + SAME_WHOLE_NUMBER),
    )
    decimals = max(0, -math.floor(math.log10(step) + SAME_WHOLE_NUMBER))
    ticks = tuple(round(i * step, decimals + 3) for i in range(first, last + 1))
    size = max(abs(low), abs(high))
    if LEAST <= size < LARGEST:
        return Scale(ticks, step, decimals)
    exponent = math.floor(math.log10(size) + SAME_WHOLE_NUMBER)
    ticks = tuple(i * step for i in range(first, last + 1))
    return Scale(
        ticks, step, max(0, exponent - math.floor(math.log10(step) + SAME_WHOLE_NUMBER)), exponent
    )


def _step(least: float, degrees: bool) -> float:
    """Return the smallest step that is no less."""
    power = 10.0 ** math.floor(math.log10(least) + SAME_STEP)
    if degrees and 10.0 < least <= OF_DEGREES[-1]:
        return next(step for step in OF_DEGREES if step >= least)
    return next(step * power for step in TICK_STEPS if step * power >= least * (1 - SAME_STEP))


def widened(low: float, high: float, most: int, degrees: bool = False) -> tuple[float, float]:
    """Return a range from tick to tick around another; around one value, a range beside it.

    >>> widened(0.03, 0.19, 5), widened(2, 2, 5)
    ((0.0, 0.2), (1.8, 2.2))
    >>> widened(0.0, 7e-64, 5)
    (0.0, 8e-64)
    """
    if high - low <= ONE_VALUE * max(abs(low), abs(high)):
        beside = abs(high) / 10 or 1.0
        return low - beside, high + beside
    step = scale(low, high, most, degrees).step
    ends = (
        math.floor(low / step + SAME_WHOLE_NUMBER) * step,
        math.ceil(high / step - SAME_WHOLE_NUMBER) * step,
    )
    digits = 12 - min(0, math.floor(math.log10(step)))
    return round(ends[0], digits), round(ends[1], digits)
