"""Where the formula of a result is 0/0 and the result runs on: what it comes to, from both sides.

A crank that is square to the line of its slider moves it as it turns, and by neither of two sines
that are zero there. At that place a formula has no value, and near it what rounding makes of one.
"""

import math
from collections.abc import Sequence

from ...base.named import NamedTuple
from ...formula.numeric.roots import RealFunction
from ...formula.numeric.rounding import with_error
from ...model.result import Result
from ..sweep import Sweep
from ..tolerances import ACROSS, SAME_RATIO, SMOOTH

PLACES, TRIED = (-2.0, -1.0, 1.0, 2.0), (-1.5, 1.5)
"""Steps to where a cubic has the values of a result, and to where it is tried."""


class Cubic(NamedTuple):
    """A polynomial of the third degree, its coefficients from that of 1 on."""

    c0: float
    c1: float
    c2: float
    c3: float

    def at(self, u: float) -> float:
        """Return the value."""
        return self.c0 + u * (self.c1 + u * (self.c2 + u * self.c3))

    def turning(self) -> float:
        """Return where the slope is zero next to 0, NaN where it is nowhere.

        >>> Cubic(1.0, -2.0, 4.0, 0.0).turning()
        0.25
        """
        half = math.copysign(math.sqrt(max(self.c2**2 - 3 * self.c1 * self.c3, 0.0)), self.c2)
        return -self.c1 / (self.c2 + half) if self.c2 + half else math.nan


def through(values: Sequence[float]) -> Cubic:
    """Return the cubic that has four values at -2, -1, 1 and 2.

    >>> through([-8.0, -1.0, 1.0, 8.0])
    Cubic(c0=0.0, c1=0.0, c2=0.0, c3=1.0)
    """
    far, near, ahead, beyond = values
    even, odd = (near + ahead) / 2, (ahead - near) / 2
    c2, c3 = ((far + beyond) / 2 - even) / 3, ((beyond - far) / 2 - 2 * odd) / 6
    return Cubic(even - c2, odd - c3, c2, c3)


class RemovableSingularities:
    """The values of the drive at which the formula of a result is 0/0 and the result has a limit.

    Each is looked at when it is asked for, and once.
    """

    def __init__(self, at: RealFunction, error: RealFunction, range_: float) -> None:
        """Take the function, a bound of its rounding errors, and how far the drive moves."""
        self._at, self._bound, self._step = at, error, ACROSS * range_
        self._across: dict[float, Cubic | None] = {}

    def is_one(self, x: float) -> bool:
        """Return whether rounding is all that the formula has at a place, and not next to it."""
        return self.across(x) is not None

    def across(self, x: float) -> Cubic | None:
        """Return the result by the steps from such a place; None where it is none."""
        if x not in self._across:
            self._across[x] = self._look(x)
        return self._across[x]

    def _look(self, x: float) -> Cubic | None:
        """Return the cubic that a result follows around where it is rounded away; else None."""
        places = [x + u * self._step for u in PLACES]
        values = [*map(self._at, places)]
        lost = SAME_RATIO * max(map(abs, values))
        if not all(map(math.isfinite, values)) or self._error(x) <= lost:
            return None
        cubic, error = through(values), max(map(self._error, places))
        apart = max(abs(cubic.at(u) - self._at(x + u * self._step)) for u in TRIED)
        is_smooth = apart <= SMOOTH * (max(values) - min(values)) + 4 * error
        return cubic if error <= lost and is_smooth else None

    def _error(self, x: float) -> float:
        """Return the bound of the rounding error, infinite where it is 0/0 or a pole."""
        error = self._bound(x)
        return math.inf if math.isnan(error) else error

    def value(self, x: float) -> float | None:
        """Return the limit of the function at such a place; None elsewhere."""
        cubic = self.across(x)
        return cubic.at(0.0) if cubic else None

    def turning(self, x: float) -> tuple[float, float] | None:
        """Return where a result turns next to such a place, and its value there; None elsewhere."""
        cubic = self.across(x)
        u = cubic.turning() if cubic else math.nan
        return (x + u * self._step, cubic.at(u)) if cubic and abs(u) <= max(PLACES) else None

    def left_out(self, grid: Sequence[float]) -> list[float]:
        """Return a grid without such places.

        They are looked for where values turn, or are missing, as those of rounding do.
        """
        values = [*map(self._at, grid)]
        odd = (i for i in range(1, len(grid) - 1) if _is_odd(*values[i - 1 : i + 2]))
        doubted = {j for i in odd for j in (i - 1, i, i + 1)}
        return [x for i, x in enumerate(grid) if i not in doubted or not self.is_one(x)]


def of_result(result: Result, along: Sweep, range_: float) -> RemovableSingularities:
    """Return the removable singularities of a result."""

    def error(x: float) -> float:
        form = along.form_at(result, x)
        return with_error(form.formula, form.where, along.rounding(x)).error

    return RemovableSingularities(along.function(result.formula, result), error, range_)


def _is_odd(before: float, here: float, after: float) -> bool:
    """Return whether the middle one of three values is beyond both others, or alone missing.

    >>> [_is_odd(1.0, here, 3.0) for here in (2.0, 4.0, math.nan)]
    [False, True, True]
    """
    if not math.isfinite(before + after):
        return False
    least, most = min(before, after), max(before, after)
    beyond = SAME_RATIO * max(abs(least), abs(most))
    return not least - beyond <= here <= most + beyond
