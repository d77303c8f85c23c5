"""A function of one variable followed over a range: where it is broken, zero, or turns.

It is looked at in many places at once. Two of them between which its sign changes are brought
together to the last bit, which tells a zero from a pole and from a jump; where the curve is bent
it gets more points. What happens twice between two neighbouring places may be missed.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Function = Callable[[Array], Array]

CELLS = 360
"""Places between which zeros, poles and extrema are looked for."""

PARTS, NARROWINGS = 256, 8
"""Into how many parts a cell is divided, and how often, until places are neighbours.

A function of systems of equations is dear for each time that it is asked, not for each place.
"""

BENT = 3e-4
"""How far a curve may be off the straight line between two points, against the panel."""

ROUNDS, MOST = 12, 6000
"""How often cells are halved for a smooth curve, and how many points are enough for any."""

STEEP = 0.02
"""A step of this part of the panel, between places that are neighbours, is a jump."""

LARGE, NIL = 1e3, 1e-6
"""By how much a function grows towards a pole, and falls towards a zero, against its cell."""

NEAR = 1e-9
"""Poles that are nearer to each other than this part of the range are one."""

NOISE = 1e-12
"""What is smaller than this part of the usual size of values is rounding."""

PROMINENT = 1e-9
"""What an extremum stands out by at least, against the usual size of values."""

EPS = float(np.finfo(np.float64).eps)


class Turn(NamedTuple):
    """A place where a function is least or greatest nearby: sense is 1, or -1."""

    sense: int
    x: float
    y: float


class Trace(NamedTuple):
    """A function followed over a range: its places, values, and what was found between."""

    xs: Array
    ys: Array
    zeros: tuple[float, ...]
    poles: tuple[float, ...]
    jumps: tuple[float, ...]
    turns: tuple[Turn, ...]


def traced(function: Function, low: float, high: float) -> Trace:
    """Return a function at places close together, and its zeros, breaks and extrema."""
    xs = np.linspace(low, high, CELLS + 1)
    ys = function(xs)
    zeros, poles, jumps = _crossings(function, xs, ys)
    found = sorted({*poles, *map(float, xs[np.isinf(ys)]), *_touched(function, xs, ys)})
    poles = [x for i, x in enumerate(found) if not i or x - found[i - 1] > NEAR * (high - low)]
    turns = tuple(_turns(function, xs, ys, np.array([*poles, *jumps])))
    size = _usual(ys)
    ends = [float(x) for x, y in ((xs[0], ys[0]), (xs[-1], ys[-1])) if abs(y) < NOISE * size]
    beside = _beside(poles, (high - low) / CELLS, low, high)
    known = [*xs, *_edges(function, xs, ys), *(t.x for t in turns), *beside]
    places = np.unique(np.array(known))
    near = sorted({*zeros, *ends})
    return Trace(places, function(places), tuple(near), tuple(poles), tuple(jumps), turns)


def _usual(ys: Array) -> float:
    """Return a size that most values do not exceed."""
    sizes = np.abs(ys[np.isfinite(ys)])
    return float(np.quantile(sizes, 0.9)) if sizes.size else 0.0


# ------------------------------------------------------------------- between two places


def _within(low: Array, high: Array) -> Array:
    """Return places from each of several ends to the other: a row for each."""
    places: Array = low[:, None] + np.linspace(0.0, 1.0, PARTS + 1) * (high - low)[:, None]
    places[:, -1] = high
    return places


def _on(function: Function, places: Array) -> Array:
    return function(places.ravel()).reshape(places.shape) if places.size else places


def _narrowed(
    holds: Callable[[Array], NDArray[np.bool_]], good: Array, bad: Array
) -> tuple[Array, Array]:
    """Return neighbouring places: at the first of two something holds, and no longer at the other.

    It ``holds`` at the ``good`` ends, and does not at the ``bad`` ones.
    """
    for _ in range(NARROWINGS if good.size else 0):
        places = _within(good, bad)
        sound = holds(places)
        sound[:, 0], sound[:, -1] = True, False
        first, rows = np.argmin(sound, axis=1), np.arange(len(places))
        good, bad = places[rows, first - 1], places[rows, first]
    return good, bad


def _crossings(
    function: Function, xs: Array, ys: Array
) -> tuple[list[float], list[float], list[float]]:
    """Return where a function changes its sign: zeros, poles, jumps."""
    finite = np.isfinite(ys)
    opposite = np.sign(ys[:-1]) * np.sign(ys[1:]) < 0
    cells = np.flatnonzero(opposite & finite[:-1] & finite[1:])
    signs = np.sign(ys[cells])[:, None]
    a, b = _narrowed(lambda x: np.sign(_on(function, x)) == signs, xs[cells], xs[cells + 1])
    before, after = np.abs(function(a)), np.abs(function(b))
    ends = np.abs(ys[cells]), np.abs(ys[cells + 1])
    zero = np.minimum(before, after) <= NIL * np.maximum(*ends)
    pole = ~zero & ~(np.minimum(before, after) < LARGE * np.minimum(*ends))
    places = np.where(before <= after, a, b)
    return (
        sorted({*map(float, places[zero]), *map(float, xs[ys == 0])}),
        list(map(float, places[pole])),
        list(map(float, places[~zero & ~pole])),
    )


def _edges(function: Function, xs: Array, ys: Array) -> Array:
    """Return the last places, to the last bit, at which a function has a value."""
    there = ~np.isnan(ys)
    cells = np.flatnonzero(there[:-1] != there[1:])
    good = np.where(there[cells], xs[cells], xs[cells + 1])
    bad = np.where(there[cells], xs[cells + 1], xs[cells])
    return _narrowed(lambda x: ~np.isnan(_on(function, x)), good, bad)[0]


def _touched(function: Function, xs: Array, ys: Array) -> Iterator[float]:
    """Yield the poles on both sides of which a function has one sign."""
    sizes = np.abs(ys)
    peaks = (sizes[1:-1] > sizes[:-2]) & (sizes[1:-1] >= sizes[2:])
    cells = np.flatnonzero(peaks & np.isfinite(sizes[1:-1])) + 1
    best = _lowest(lambda x: -np.abs(function(x)), xs[cells - 1], xs[cells + 1])
    beside = np.maximum(sizes[cells - 1], sizes[cells + 1])
    yield from map(float, best[~(np.abs(function(best)) < LARGE**2 * beside)])


def _lowest(function: Function, low: Array, high: Array) -> Array:
    """Return where a function is least between each two places, to half the digits or more.

    Where it has one value in all places, to the last bits, there is no more to be found.
    """
    for _ in range(NARROWINGS if low.size else 0):
        places = _within(low, high)
        values = _on(function, places)
        least = np.argmin(np.where(np.isnan(values), np.inf, values), axis=1)
        rows = np.arange(len(places))
        low = places[rows, np.maximum(least - 1, 0)]
        high = places[rows, np.minimum(least + 1, PARTS)]
        if np.all(np.ptp(values, axis=1) <= EPS * np.abs(values[rows, least])):
            break
    return (low + high) / 2


def _turns(function: Function, xs: Array, ys: Array, breaks: Array) -> Iterator[Turn]:
    """Yield the extrema between places, but for those beside a break.

    They are refined by narrowing, and then to where the slope is nil.
    """
    before, here, after = ys[:-2], ys[1:-1], ys[2:]
    least = ((before > here) & (here <= after)).astype(int)
    sense = least - ((before < here) & (here >= after))
    prominent = np.maximum(np.abs(before - here), np.abs(after - here)) > PROMINENT * _usual(ys)
    clear = ~((xs[:-2, None] <= breaks) & (breaks <= xs[2:, None])).any(axis=1)
    cells = np.flatnonzero((sense != 0) & prominent & clear) + 1
    signs = sense[cells - 1].astype(np.float64)
    low, high = xs[cells - 1], xs[cells + 1]
    rough = _lowest(lambda x: np.repeat(signs, x.size // signs.size) * function(x), low, high)
    fine = _stationary(function, rough, 0.02 * (high - low))
    y_rough, y_fine = function(rough), function(fine)
    better = signs * y_fine <= signs * y_rough + 8 * EPS * np.abs(y_rough)
    places, values = np.where(better, fine, rough), np.where(better, y_fine, y_rough)
    for sign, x, y, bound in zip(signs, places, values, signs * ys[cells], strict=True):
        if sign * y <= bound:
            yield Turn(int(sign), float(x), float(y))


def _stationary(function: Function, near: Array, width: Array) -> Array:
    """Return where the slope changes its sign near places, by differences of fourth order."""
    steps = np.array([-2.0, -1.0, 1.0, 2.0]) / 2

    def slopes(places: Array) -> Array:
        around = places[..., None] + width[:, None, None] * steps
        slopes: Array = _on(function, around) @ np.array([1.0, -8.0, 8.0, -1.0])
        return slopes

    a, b = near - width, near + width
    signs = np.sign(slopes(a[:, None]))
    opposite = (signs * slopes(b[:, None]) < 0)[:, 0]
    a, _ = _narrowed(lambda x: np.sign(slopes(x)) == signs, a, b)
    return np.where(opposite, a, near)


def _beside(poles: list[float], cell: float, low: float, high: float) -> Iterator[float]:
    """Yield places nearer and nearer to poles, on both sides."""
    for pole in poles:
        for k in range(1, 16):
            for x in (pole - cell * 0.5**k, pole + cell * 0.5**k):
                if low <= x <= high:
                    yield x


# ------------------------------------------------------------------------- fit to be shown


def smooth(function: Function, trace: Trace, low: float, high: float) -> Trace:
    """Return a trace with more points where it is bent, between two values that are shown.

    A step that stays however near its ends are is a jump.
    """
    xs, ys = trace.xs, trace.ys
    scale = (xs[-1] - xs[0], (high - low) or abs(high) or 1.0)
    for _ in range(ROUNDS):
        cells = _open(xs, ys, scale, low, high)
        if not cells.size or len(xs) + cells.size > MOST:
            break
        middle = (xs[cells] + xs[cells + 1]) / 2
        xs = np.insert(xs, cells + 1, middle)
        ys = np.insert(ys, cells + 1, function(middle))
    shown = np.clip(ys, low, high)
    jumps = sorted({*trace.jumps, *_steps(function, xs, shown, scale[1], trace.poles)})
    return trace._replace(xs=xs, ys=ys, jumps=tuple(jumps))


def _open(
    xs: Array, ys: Array, scale: tuple[float, float], low: float, high: float
) -> NDArray[np.intp]:
    """Return the cells beside which a curve is bent, or that are steep."""
    x, y = xs / scale[0], np.clip(ys, low - scale[1], high + scale[1]) / scale[1]
    with np.errstate(invalid="ignore", divide="ignore"):
        dx, dy = np.diff(x), np.diff(y)
        slope = dy / dx
        bend = np.abs(np.diff(slope)) * np.minimum(dx[:-1], dx[1:]) / 8
        bent = np.concatenate([[False], bend / np.hypot(1.0, slope[1:]) > BENT])
        bent[:-1] |= bend / np.hypot(1.0, slope[:-1]) > BENT
        wide = np.hypot(dx, dy) > BENT
    return np.flatnonzero(bent & wide & (dx > 1e-9))


def _steps(
    function: Function, xs: Array, ys: Array, span: float, poles: tuple[float, ...]
) -> list[float]:
    """Return where a function jumps without a change of its sign."""
    steep = np.abs(np.diff(ys)) > STEEP * span
    alike = np.sign(ys[:-1]) == np.sign(ys[1:])
    inside = np.searchsorted(poles, xs[:-1]) == np.searchsorted(poles, xs[1:])
    cells = np.flatnonzero(steep & alike & inside)
    low, high = xs[cells], xs[cells + 1]
    for _ in range(NARROWINGS if cells.size else 0):
        places = _within(low, high)
        first = np.argmax(np.abs(np.diff(_on(function, places), axis=1)), axis=1)
        rows = np.arange(len(places))
        low, high = places[rows, first], places[rows, first + 1]
    jumps = np.abs(function(high) - function(low)) > STEEP * span / 2
    return list(map(float, ((low + high) / 2)[jumps]))


def limits(traces: list[Trace]) -> tuple[float, float]:
    """Return between which values curves are shown: all, or where there are poles, most.

    Of what is level but for rounding it is one value.
    """
    every = np.concatenate([t.ys[np.isfinite(t.ys)] for t in traces])
    low, high = float(every.min()), float(every.max())
    if any(t.poles for t in traces):
        inner = np.concatenate([_evenly(t) for t in traces])
        lower, upper = (float(q) for q in np.quantile(inner, (0.12, 0.88)))
        margin = 0.6 * (upper - lower)
        low, high = max(low, lower - margin), min(high, upper + margin)
    middle = (low + high) / 2
    is_level = high - low <= PROMINENT * max(abs(low), abs(high))
    return (middle, middle) if is_level else (low, high)


def _evenly(trace: Trace) -> Array:
    """Return the values at places that lie evenly: more of them are near poles."""
    ys = np.interp(np.linspace(trace.xs[0], trace.xs[-1], CELLS + 1), trace.xs, trace.ys)
    found: Array = ys[np.isfinite(ys)]
    return found


def pieces(trace: Trace) -> Iterator[tuple[Array, Array]]:
    """Yield the parts of a trace on which nothing is broken."""
    whole = np.isfinite(trace.ys)
    cut = np.array([*trace.poles, *trace.jumps])
    part = np.searchsorted(np.sort(cut), trace.xs) + np.cumsum(~whole)
    for number in np.unique(part[whole]):
        inside = whole & (part == number)
        if np.count_nonzero(inside) > 1:
            yield trace.xs[inside], trace.ys[inside]
