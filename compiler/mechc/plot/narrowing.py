"""Where a function changes, narrowed down in many cells at once; its limits and its holes."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
ArrayFunction = Callable[[Array], Array]

PARTS, NARROWINGS = 64, 10
"""Into how many parts a cell is divided, and how often, until numbers are neighbours.

A function of systems of equations is dear for each time that it is asked, not for each number.
"""

NEAR_POINT = 1e-9
"""What a function is near a point is what it is so far from it, as a part of a cell."""

NEXT, MOST_CHANGE = 2.0**-46, 0.01
"""Numbers that are all but the same, as a part of the range; by what part a function may change."""

SIDE = 1e-6
"""How far from a point its sides are looked at, as a part of the range."""

SAME_SIDES = 1e-6
"""By what part of themselves the limits on two sides may differ that are one."""

EPS = float(np.finfo(np.float64).eps)


def lone(holds: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return where something holds that holds at no neighbouring point."""
    beside = np.concatenate([[False], holds, [False]])
    found: NDArray[np.bool_] = holds & ~beside[:-2] & ~beside[2:]
    return found


def without_holes(function: ArrayFunction, xs: Array, ys: Array) -> tuple[Array, Array]:
    """Return a grid and values without a point that has no value, but has them on both sides.

    Rounding decides whether a condition holds there that begins or ends at this very point.
    """
    holes = np.flatnonzero(lone(np.isnan(ys))[1:-1]) + 1
    aside = NEAR_POINT * np.minimum(xs[holes] - xs[holes - 1], xs[holes + 1] - xs[holes])
    beside = on(function, xs[holes][:, None] + aside[:, None] * np.array([-1.0, 1.0]))
    left_out = holes[np.isfinite(beside).all(axis=1)]
    return np.delete(xs, left_out), np.delete(ys, left_out)


def is_rounding(function: ArrayFunction, low: float, high: float) -> bool:
    """Return whether rounding is all that is left of a function in a range.

    Then it changes as much as it is large between numbers that are all but the same.

    >>> is_rounding(lambda x: (3 + x) - 3 - x, 0.1, 1.0)
    True
    >>> is_rounding(lambda x: 1e-20 * x, 0.1, 1.0)
    False
    """
    grid = np.linspace(low, high, PARTS)
    with np.errstate(all="ignore"):
        here, there = function(grid), function(grid + NEXT * (high - low))
    known = np.isfinite(here) & np.isfinite(there)
    if not known.any():
        return False
    changes = np.abs(there - here)[known]
    return bool(np.median(changes) > MOST_CHANGE * np.median(np.abs(here[known])))


def with_limits(
    function: ArrayFunction, is_left_out: Callable[[Array], NDArray[np.bool_]], width: float
) -> ArrayFunction:
    """Return a function that has what its sides come to where its own value is left out.

    There is none where the sides come to different values: the function jumps there.
    """

    def at(grid: Array) -> Array:
        values = function(grid)
        places = np.flatnonzero(np.broadcast_to(is_left_out(grid), grid.shape))
        values[places] = _limits(function, grid[places], SIDE * width)
        return values

    return at


def _limits(function: ArrayFunction, xs: Array, step: float) -> Array:
    """Return the limits at points, by straight lines on either side; NaN where these differ."""
    around = on(function, xs[:, None] + step * np.array([-2.0, -1.0, 1.0, 2.0]))
    before, after = 2 * around[:, 1] - around[:, 0], 2 * around[:, 2] - around[:, 3]
    is_jump = np.abs(before - after) > SAME_SIDES * np.maximum(np.abs(before), np.abs(after))
    middle = np.where(is_jump, np.nan, (before + after) / 2)
    return np.where(np.isnan(before), after, np.where(np.isnan(after), before, middle))


def within(low: Array, high: Array) -> Array:
    """Return a grid from each of several ends to the other: a row for each."""
    grid: Array = low[:, None] + np.linspace(0.0, 1.0, PARTS + 1) * (high - low)[:, None]
    grid[:, -1] = high
    return grid


def on(function: ArrayFunction, grid: Array) -> Array:
    """Return the values at a table of points, in its shape."""
    return function(grid.ravel()).reshape(grid.shape) if grid.size else grid


def narrowed(
    holds: Callable[[Array], NDArray[np.bool_]], good: Array, bad: Array
) -> tuple[Array, Array]:
    """Return neighbouring numbers: at the first of two something holds, and no longer at the other.

    It ``holds`` at the ``good`` ends, and does not at the ``bad`` ones.
    """
    for _ in range(NARROWINGS if good.size else 0):
        grid = within(good, bad)
        sound = holds(grid)
        sound[:, 0], sound[:, -1] = True, False
        first, rows = np.argmin(sound, axis=1), np.arange(len(grid))
        good, bad = grid[rows, first - 1], grid[rows, first]
        if np.all(np.nextafter(good, bad) == bad):
            break
    return good, bad


def lowest(function: ArrayFunction, low: Array, high: Array) -> Array:
    """Return where a function is least between each two numbers, to half the digits or more.

    Where it has one value everywhere, to the last bits, there is no more to be found.
    """
    for _ in range(NARROWINGS if low.size else 0):
        grid = within(low, high)
        values = on(function, grid)
        least = np.argmin(np.where(np.isnan(values), np.inf, values), axis=1)
        rows = np.arange(len(grid))
        low = grid[rows, np.maximum(least - 1, 0)]
        high = grid[rows, np.minimum(least + 1, PARTS)]
        if np.all(np.ptp(values, axis=1) <= EPS * np.abs(values[rows, least])):
            break
    return (low + high) / 2
