"""A function of one variable followed over a range: where it is broken, zero, or turns.

It is looked at in many places at once. Between two of them that differ in sign it is halved
down to the last bit, which tells a zero from a pole and from a jump; where the curve is bent
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

BITS = 64
"""Halvings after which two places are neighbours."""

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

PROMINENT = 1e-9
"""What an extremum stands out by at least, against the usual size of values."""

EPS = float(np.finfo(np.float64).eps)

GOLDEN = (5**0.5 - 1) / 2


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
    edges = _edges(function, xs, ys)
    turns = tuple(_turns(function, xs, ys, [*poles, *jumps]))
    size = _usual(ys)
    ends = [float(x) for x, y in ((xs[0], ys[0]), (xs[-1], ys[-1])) if abs(y) < 1e-12 * size]
    known = [*xs, *edges, *(t.x for t in turns), *_beside(poles, (high - low) / CELLS, low, high)]
    places = np.unique(np.array(known))
    values = function(places)
    near = sorted({*zeros, *ends})
    return Trace(places, values, tuple(near), tuple(poles), tuple(jumps), turns)


def _usual(ys: Array) -> float:
    """Return a size that most values do not exceed."""
    sizes = np.abs(ys[np.isfinite(ys)])
    return float(np.quantile(sizes, 0.9)) if sizes.size else 0.0


def _crossings(
    function: Function, xs: Array, ys: Array
) -> tuple[list[float], list[float], list[float]]:
    """Return where a function changes its sign: zeros, poles, jumps."""
    with np.errstate(invalid="ignore"):
        cells = np.flatnonzero(np.sign(ys[:-1]) * np.sign(ys[1:]) < 0)
    finite = np.isfinite(ys)
    cells = cells[finite[cells] & finite[cells + 1]]
    if not cells.size:
        return [], [], []
    a, b = xs[cells].copy(), xs[cells + 1].copy()
    sign = np.sign(ys[cells])
    for _ in range(BITS):
        middle = (a + b) / 2
        same = np.sign(function(middle)) == sign
        a, b = np.where(same, middle, a), np.where(same, b, middle)
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
    finite = ~np.isnan(ys)
    cells = np.flatnonzero(finite[:-1] != finite[1:])
    good = np.where(finite[cells], xs[cells], xs[cells + 1])
    bad = np.where(finite[cells], xs[cells + 1], xs[cells])
    for _ in range(BITS if cells.size else 0):
        middle = (good + bad) / 2
        sound = ~np.isnan(function(middle))
        good, bad = np.where(sound, middle, good), np.where(sound, bad, middle)
    return good


def _touched(function: Function, xs: Array, ys: Array) -> Iterator[float]:
    """Yield the poles on both sides of which a function has one sign."""
    sizes = np.abs(ys)
    with np.errstate(invalid="ignore"):
        peaks = (sizes[1:-1] > sizes[:-2]) & (sizes[1:-1] >= sizes[2:])
    for i in np.flatnonzero(peaks & np.isfinite(sizes[1:-1])) + 1:
        best = _golden(lambda x: -np.abs(function(x)), xs[i - 1], xs[i + 1])
        if not abs(_at(function, best)) < LARGE**2 * max(sizes[i - 1], sizes[i + 1]):
            yield best


def _at(function: Function, x: float) -> float:
    return float(function(np.array([x]))[0])


def _golden(function: Function, low: float, high: float) -> float:
    """Return where a function is least between two places, by sections."""
    a, b = low, high
    c, d = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
    at_c, at_d = _at(function, c), _at(function, d)
    for _ in range(BITS):
        if at_c < at_d:
            b, d, at_d = d, c, at_c
            c = b - GOLDEN * (b - a)
            at_c = _at(function, c)
        else:
            a, c, at_c = c, d, at_d
            d = a + GOLDEN * (b - a)
            at_d = _at(function, d)
    return float((a + b) / 2)


def _turns(function: Function, xs: Array, ys: Array, breaks: list[float]) -> Iterator[Turn]:
    """Yield the extrema between places, but for those beside a break."""
    least = PROMINENT * _usual(ys)
    for i in range(1, len(xs) - 1):
        before, here, after = ys[i - 1 : i + 2]
        turns = before > here <= after or before < here >= after
        clear = all(not xs[i - 1] <= x <= xs[i + 1] for x in breaks)
        if turns and clear and max(abs(before - here), abs(after - here)) > least:
            sense = 1 if here <= after else -1
            yield from _refined(function, sense, xs[i - 1], xs[i + 1], sense * float(here))


def _refined(
    function: Function, sense: int, low: float, high: float, bound: float
) -> Iterator[Turn]:
    """Yield the extremum between two places: by sections, then where the slope is nil."""
    rough = _golden(lambda x: sense * function(x), low, high)
    width = 0.02 * (high - low)
    fine = _stationary(function, rough, width)
    y_rough, y_fine = _at(function, rough), _at(function, fine)
    flat = 8 * EPS * abs(y_rough)
    x, y = (fine, y_fine) if sense * y_fine <= sense * y_rough + flat else (rough, y_rough)
    if sense * y <= bound:
        yield Turn(sense, float(x), y)


def _stationary(function: Function, near: float, width: float) -> float:
    """Return where the slope changes its sign near a place, by differences of fourth order."""
    step = width / 2

    def slope(x: float) -> float:
        values = function(x + step * np.array([-2.0, -1.0, 1.0, 2.0]))
        return float(values @ np.array([1.0, -8.0, 8.0, -1.0]))

    a, b = near - width, near + width
    sign = np.sign(slope(a))
    if sign * slope(b) >= 0:
        return near
    for _ in range(BITS):
        middle = (a + b) / 2
        a, b = (middle, b) if np.sign(slope(middle)) == sign else (a, middle)
    return (a + b) / 2


def _beside(poles: list[float], cell: float, low: float, high: float) -> Iterator[float]:
    """Yield places nearer and nearer to poles, on both sides."""
    for pole in poles:
        for k in range(1, 16):
            for x in (pole - cell * 0.5**k, pole + cell * 0.5**k):
                if low <= x <= high:
                    yield x


def smooth(function: Function, trace: Trace, low: float, high: float) -> Trace:
    """Return a trace with more points where it is bent, between two values that are shown.

    A step that stays however near its ends are is a jump.
    """
    xs, ys = trace.xs, trace.ys
    scale = (xs[-1] - xs[0], (high - low) or 1.0)
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
) -> Iterator[float]:
    """Yield where a function jumps without a change of its sign."""
    with np.errstate(invalid="ignore"):
        steep = np.flatnonzero(np.abs(np.diff(ys)) > STEEP * span)
    for i in steep:
        a, b = float(xs[i]), float(xs[i + 1])
        if any(a <= p <= b for p in poles) or np.sign(ys[i]) != np.sign(ys[i + 1]):
            continue
        for _ in range(BITS):
            middle = (a + b) / 2
            at_a, here, at_b = function(np.array([a, middle, b]))
            a, b = (middle, b) if abs(here - at_a) < abs(here - at_b) else (a, middle)
        at_a, at_b = function(np.array([a, b]))
        if abs(at_b - at_a) > STEEP * span / 2:
            yield (a + b) / 2


def limits(traces: list[Trace]) -> tuple[float, float]:
    """Return between which values curves are shown: all, or where there are poles, most."""
    every = np.concatenate([t.ys[np.isfinite(t.ys)] for t in traces])
    low, high = float(every.min()), float(every.max())
    if any(t.poles for t in traces):
        inner = np.concatenate([_evenly(t) for t in traces])
        lower, upper = (float(q) for q in np.quantile(inner, (0.12, 0.88)))
        margin = 0.6 * (upper - lower)
        low, high = max(low, lower - margin), min(high, upper + margin)
    return low, high


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
