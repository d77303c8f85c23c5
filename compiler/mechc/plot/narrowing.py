"""Places brought together between which a function changes, many at once."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Function = Callable[[Array], Array]

PARTS, NARROWINGS = 64, 10
"""Into how many parts a cell is divided, and how often, until places are neighbours.

A function of systems of equations is dear for each time that it is asked, not for each place.
"""

NEAR = 1e-9
"""What a function is beside a place is what it is so far from it, as a part of a cell."""

EPS = float(np.finfo(np.float64).eps)


def lone(holds: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return where something holds that holds at no neighbouring place."""
    beside = np.concatenate([[False], holds, [False]])
    found: NDArray[np.bool_] = holds & ~beside[:-2] & ~beside[2:]
    return found


def without_holes(function: Function, xs: Array, ys: Array) -> tuple[Array, Array]:
    """Return places and values without a place that has no value, but has them on both sides.

    Rounding decides whether a condition holds there that begins or ends at this very place.
    """
    holes = np.flatnonzero(lone(np.isnan(ys))[1:-1]) + 1
    aside = NEAR * np.minimum(xs[holes] - xs[holes - 1], xs[holes + 1] - xs[holes])
    beside = on(function, xs[holes][:, None] + aside[:, None] * np.array([-1.0, 1.0]))
    left_out = holes[np.isfinite(beside).all(axis=1)]
    return np.delete(xs, left_out), np.delete(ys, left_out)


def within(low: Array, high: Array) -> Array:
    """Return places from each of several ends to the other: a row for each."""
    places: Array = low[:, None] + np.linspace(0.0, 1.0, PARTS + 1) * (high - low)[:, None]
    places[:, -1] = high
    return places


def on(function: Function, places: Array) -> Array:
    """Return the values at a table of places, in its shape."""
    return function(places.ravel()).reshape(places.shape) if places.size else places


def narrowed(
    holds: Callable[[Array], NDArray[np.bool_]], good: Array, bad: Array
) -> tuple[Array, Array]:
    """Return neighbouring places: at the first of two something holds, and no longer at the other.

    It ``holds`` at the ``good`` ends, and does not at the ``bad`` ones.
    """
    for _ in range(NARROWINGS if good.size else 0):
        places = within(good, bad)
        sound = holds(places)
        sound[:, 0], sound[:, -1] = True, False
        first, rows = np.argmin(sound, axis=1), np.arange(len(places))
        good, bad = places[rows, first - 1], places[rows, first]
        if np.all(np.nextafter(good, bad) == bad):
            break
    return good, bad


def lowest(function: Function, low: Array, high: Array) -> Array:
    """Return where a function is least between each two places, to half the digits or more.

    Where it has one value in all places, to the last bits, there is no more to be found.
    """
    for _ in range(NARROWINGS if low.size else 0):
        places = within(low, high)
        values = on(function, places)
        least = np.argmin(np.where(np.isnan(values), np.inf, values), axis=1)
        rows = np.arange(len(places))
        low = places[rows, np.maximum(least - 1, 0)]
        high = places[rows, np.minimum(least + 1, PARTS)]
        if np.all(np.ptp(values, axis=1) <= EPS * np.abs(values[rows, least])):
            break
    return (low + high) / 2
