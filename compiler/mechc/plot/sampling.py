"""A function of one variable followed over a range: where it is broken, zero, or turns.

It is looked at in many points at once. Two of them between which its sign changes are brought
together to the last bit, which parts a zero from a pole and from a jump. What happens twice between
two neighbouring points may be missed.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..base.named import NamedTuple
from .narrowing import (
    EPS,
    NEAR_POINT,
    Array,
    ArrayFunction,
    lone,
    lowest,
    narrowed,
    on,
    without_holes,
)

PLOT_CELLS = 360
"""Cells in which zeros, poles and extrema are looked for."""

LARGE, VANISHED = 1e3, 1e-6
"""By how much a function grows towards a pole, and falls towards a zero, against its cell."""

NOISE = 1e-12
"""What is smaller than this part of the usual size of values is rounding."""

PROMINENT = 1e-9
"""What an extremum stands out by at least, against the usual size of values."""

BESIDE_BREAK = 0.05
"""How near a point is to a break, in cells around it, where its value may be rounding."""


class TurningPoint(NamedTuple):
    """A point where a function is least or greatest nearby: sense is 1, or -1."""

    sense: int
    x: float
    y: float


class Trace(NamedTuple):
    """A function followed over a range: its grid, values, and what was found between."""

    xs: Array
    ys: Array
    zeros: tuple[float, ...]
    poles: tuple[float, ...]
    jumps: tuple[float, ...]
    turns: tuple[TurningPoint, ...]


def traced(function: ArrayFunction, low: float, high: float) -> Trace:
    """Return a function on a fine grid, and its zeros, breaks and extrema."""
    grid = np.linspace(low, high, PLOT_CELLS + 1)
    xs, ys = without_holes(function, grid, function(grid))
    zeros, poles, jumps = _crossings(function, xs, ys)
    edges = _edges(function, xs, ys)
    high_up = {*map(float, xs[np.isinf(ys)]), *_touched(function, xs, ys)}
    found = sorted({*poles, *high_up, *_at_ends(function, xs, ys, edges)})
    poles = [
        x for i, x in enumerate(found) if not i or x - found[i - 1] > NEAR_POINT * (high - low)
    ]
    turns = tuple(_turns(function, xs, ys, np.array([*poles, *jumps])))
    size = _usual(ys)
    inwards = ((xs[0], ys[0], ys[1]), (xs[-1], ys[-1], ys[-2]))
    ends = [float(x) for x, y, next_ in inwards if abs(y) < NOISE * size < abs(next_)]
    beside = _beside(poles, (high - low) / PLOT_CELLS, low, high)
    known = [*xs, *edges, *(t.x for t in turns), *beside]
    grid = np.unique(np.array(known))
    near = sorted({*zeros, *ends})
    return Trace(grid, function(grid), tuple(near), tuple(poles), tuple(jumps), turns)


def _usual(ys: Array) -> float:
    """Return a size that most values do not exceed."""
    sizes = np.abs(ys[np.isfinite(ys)])
    return float(np.quantile(sizes, 0.9)) if sizes.size else 0.0


def _crossings(
    function: ArrayFunction, xs: Array, ys: Array
) -> tuple[list[float], list[float], list[float]]:
    """Return where a function changes its sign: zeros, poles, jumps."""
    finite = np.isfinite(ys)
    opposite = np.sign(ys[:-1]) * np.sign(ys[1:]) < 0
    cells = np.flatnonzero(opposite & finite[:-1] & finite[1:])
    signs = np.sign(ys[cells])[:, None]
    a, b = narrowed(lambda x: np.sign(on(function, x)) == signs, xs[cells], xs[cells + 1])
    before, after = np.abs(function(a)), np.abs(function(b))
    ends = np.abs(ys[cells]), np.abs(ys[cells + 1])
    zero = np.fmin(before, after) <= VANISHED * np.maximum(*ends)
    pole = ~zero & ~(np.fmin(before, after) < LARGE * np.minimum(*ends))
    grid = np.where(before <= after, a, b)
    return (
        sorted({*map(float, grid[zero]), *map(float, xs[lone(ys == 0)])}),
        list(map(float, grid[pole])),
        list(map(float, grid[~zero & ~pole])),
    )


def _edges(function: ArrayFunction, xs: Array, ys: Array) -> Array:
    """Return the last numbers, to the last bit, at which a function has a value."""
    there = ~np.isnan(ys)
    cells = np.flatnonzero(there[:-1] != there[1:])
    good = np.where(there[cells], xs[cells], xs[cells + 1])
    bad = np.where(there[cells], xs[cells + 1], xs[cells])
    return narrowed(lambda x: ~np.isnan(on(function, x)), good, bad)[0]


def _at_ends(function: ArrayFunction, xs: Array, ys: Array, edges: Array) -> Iterator[float]:
    """Yield the poles at the ends of the range, and where a function begins or ends to be."""
    known = np.flatnonzero(np.isfinite(ys))
    if not known.size:
        return
    ends = [xs[0], xs[-1], *edges]
    sizes = np.abs([ys[0], ys[-1], *(function(edges) if edges.size else ())])
    for end, size in zip(ends, sizes, strict=True):
        cell = known[np.argsort(np.abs(xs[known] - end))[:2]]
        if size > LARGE**2 * np.min(np.abs(ys[cell])) > 0 and size > LARGE * _usual(ys):
            yield float(end)


def _touched(function: ArrayFunction, xs: Array, ys: Array) -> Iterator[float]:
    """Yield the poles on both sides of which a function has one sign."""
    sizes = np.abs(ys)
    peaks = (sizes[1:-1] > sizes[:-2]) & (sizes[1:-1] >= sizes[2:])
    cells = np.flatnonzero(peaks & np.isfinite(sizes[1:-1])) + 1
    best = lowest(lambda x: -np.abs(function(x)), xs[cells - 1], xs[cells + 1])
    beside = np.maximum(sizes[cells - 1], sizes[cells + 1])
    width = NEAR_POINT * (xs[cells + 1] - xs[cells - 1])
    around = np.abs(on(function, best[:, None] + width[:, None] * np.array([-1.0, 0.0, 1.0])))
    largest = np.max(np.where(np.isnan(around), 0.0, around), axis=1)
    yield from map(float, best[largest > LARGE**2 * beside])


def _turns(function: ArrayFunction, xs: Array, ys: Array, breaks: Array) -> Iterator[TurningPoint]:
    """Yield the extrema between points, but for those next to a break.

    A kink at a point is narrowed down to half its digits: the point itself is the extremum.
    """
    cells, signs = _turning_points(xs, ys, breaks)
    found = _refined(function, xs[cells - 1], xs[cells + 1], signs)
    missed = PROMINENT * _usual(ys)
    for sign, x, y, point, value in zip(signs, *found, xs[cells], ys[cells], strict=True):
        if sign * y <= sign * value:
            yield TurningPoint(int(sign), float(x), float(y))
        elif sign * y <= sign * value + missed:
            yield TurningPoint(int(sign), float(point), float(value))


def _turning_points(xs: Array, ys: Array, breaks: Array) -> tuple[NDArray[np.intp], Array]:
    """Return the points at which values turn, and of each 1 for a least one, -1 for a greatest.

    A level stretch is an extremum where the function goes back after it. What a break takes part
    in is none, nor what a value so close to one does that it may be rounding: a branch point.
    """
    before, here, after = ys[:-2], ys[1:-1], _beyond_level(ys)[1:]
    least = ((before > here) & (here < after)).astype(int)
    sense = least - ((before < here) & (here > after))
    prominent = np.maximum(np.abs(before - here), np.abs(after - here)) > PROMINENT * _usual(ys)
    margin = BESIDE_BREAK * (xs[2:] - xs[:-2])
    low, high = (xs[:-2] - margin)[:, None], (xs[2:] + margin)[:, None]
    clear = ~((low <= breaks) & (breaks <= high)).any(axis=1)
    cells = np.flatnonzero((sense != 0) & prominent & clear) + 1
    return cells, sense[cells - 1].astype(np.float64)


def _refined(function: ArrayFunction, low: Array, high: Array, signs: Array) -> tuple[Array, Array]:
    """Return extrema and their values: narrowed down, then where the slope is zero if better."""
    rough = lowest(lambda x: np.repeat(signs, x.size // signs.size) * function(x), low, high)
    fine = _stationary(function, rough, 0.02 * (high - low))
    y_rough, y_fine = function(rough), function(fine)
    better = signs * y_fine <= signs * y_rough + 8 * EPS * np.abs(y_rough)
    return np.where(better, fine, rough), np.where(better, y_fine, y_rough)


def _beyond_level(ys: Array) -> Array:
    """Return the next value that is another one, of each but the last; NaN where there is none.

    >>> _beyond_level(np.array([1.0, 2.0, 2.0, 3.0, 3.0])).tolist()
    [2.0, 3.0, 3.0, nan]
    """
    found = np.full(len(ys) - 1, np.nan)
    for i in range(len(found) - 1, -1, -1):
        level = ys[i] == ys[i + 1] and i + 1 < len(found)
        found[i] = found[i + 1] if level else ys[i + 1]
    found[found == ys[:-1]] = np.nan
    return found


def _stationary(function: ArrayFunction, near: Array, width: Array) -> Array:
    """Return where the slope changes its sign near points, by differences of fourth order."""
    steps = np.array([-2.0, -1.0, 1.0, 2.0]) / 2

    def slopes(grid: Array) -> Array:
        around = grid[..., None] + width[:, None, None] * steps
        slopes: Array = on(function, around) @ np.array([1.0, -8.0, 8.0, -1.0])
        return slopes

    a, b = near - width, near + width
    signs = np.sign(slopes(a[:, None]))
    opposite = (signs * slopes(b[:, None]) < 0)[:, 0]
    a, _ = narrowed(lambda x: np.sign(slopes(x)) == signs, a, b)
    return np.where(opposite, a, near)


def _beside(poles: list[float], cell: float, low: float, high: float) -> Iterator[float]:
    """Yield points nearer and nearer to poles, on both sides."""
    steps = [cell * 0.5**k for k in range(1, 16)]
    around = (x for pole in poles for step in steps for x in (pole - step, pole + step))
    yield from (x for x in around if low <= x <= high)
