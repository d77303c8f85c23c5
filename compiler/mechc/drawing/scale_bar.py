"""The bar that says to which scale arrows are drawn."""

import math

from ..pose.places import NOWHERE, Plane
from .drawing import SYMBOL, Drawing, Run
from .labels import Around
from .sheet import Layer, Sheet
from .symbols import line
from .ticks import STEPS
from .tolerances import WHOLE

LONGEST = 30.0
"""How long the bar is at most, in millimetres."""

TICK = 1.2
"""Half the height of the strokes at its ends."""


def scale_bar(size: float, unit: tuple[Run, ...]) -> Drawing:
    """Return a bar as long as a round number of units, one of which is ``size`` millimetres."""
    units = _round(LONGEST / size)
    end = Plane(units * size, 0.0)
    sheet = Sheet()
    up = Plane(0.0, TICK)
    bar = [line(at.minus(up), at.plus(up), SYMBOL) for at in (NOWHERE, end)]
    sheet.draw(Layer.MEASURES, [line(NOWHERE, end, SYMBOL), *bar])
    sheet.name(Around(end, (Run(f"{units:g}\u2009"), *unit), SYMBOL, 0.0, TICK))
    return sheet.finished("", "")


def _round(most: float) -> float:
    """Return the largest of 1, 2, 5, 10, … that is no larger.

    >>> _round(0.19), _round(7.0), _round(20.0)
    (0.1, 5.0, 20.0)
    """
    power = 10.0 ** math.floor(math.log10(most))
    return max(step * power for step in STEPS if step * power <= most * (1 + WHOLE))
