"""From a sampled function to the curve shown: points where it bends, jumps, limits, pieces."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from .narrowing import NEAR_POINT, Array, ArrayFunction, narrowed, on, without_holes
from .sampling import PLOT_CELLS, PROMINENT, Trace

OFF_THE_LINE = 3e-4
"""How far a curve may be off the straight line between two points, against the panel."""

NARROW = 1e-9
"""A cell narrower than this part of the range is not halved: that is where a curve breaks off."""

ROUNDS, MOST = 12, 6000
"""How often cells are halved for a smooth curve, and how many points are enough for any."""

JUMP_OF_PANEL = 0.02
"""A step of this part of the panel, between values that are neighbours, is a jump."""


def smooth(function: ArrayFunction, trace: Trace, low: float, high: float) -> Trace:
    """Return a trace with more points where it is bent, between two values that are shown.

    A step that stays however near its ends are is a jump, and no extremum.
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
    xs, ys = without_holes(function, xs, ys)
    shown = np.clip(ys, low, high)
    jumps = sorted({*trace.jumps, *_steps(function, xs, shown, scale[1], trace.poles)})
    near = NEAR_POINT * scale[0]
    turns = (t for t in trace.turns if all(abs(t.x - jump) > near for jump in jumps))
    if beside := [x for jump in jumps for x in (jump - near, jump + near) if xs[0] < x < xs[-1]]:
        xs = np.unique(np.array([*xs, *beside]))
        xs, ys = without_holes(function, xs, function(xs))
    return trace._replace(xs=xs, ys=ys, jumps=tuple(jumps), turns=tuple(turns))


def _open(
    xs: Array, ys: Array, scale: tuple[float, float], low: float, high: float
) -> NDArray[np.intp]:
    """Return the cells next to which a curve is bent, or that are steep."""
    x, y = xs / scale[0], np.clip(ys, low - scale[1], high + scale[1]) / scale[1]
    with np.errstate(invalid="ignore", divide="ignore"):
        dx, dy = np.diff(x), np.diff(y)
        slope = dy / dx
        bend = np.abs(np.diff(slope)) * np.minimum(dx[:-1], dx[1:]) / 8
        bent = np.concatenate([[False], bend / np.hypot(1.0, slope[1:]) > OFF_THE_LINE])
        bent[:-1] |= bend / np.hypot(1.0, slope[:-1]) > OFF_THE_LINE
        wide = np.hypot(dx, dy) > OFF_THE_LINE
    return np.flatnonzero(bent & wide & (dx > NARROW))


def _steps(
    function: ArrayFunction, xs: Array, ys: Array, span: float, poles: tuple[float, ...]
) -> list[float]:
    """Return where a function jumps without a change of its sign."""
    steep = np.abs(np.diff(ys)) > JUMP_OF_PANEL * span
    alike = np.sign(ys[:-1]) * np.sign(ys[1:]) >= 0
    inside = np.searchsorted(poles, xs[:-1]) == np.searchsorted(poles, xs[1:])
    cells = np.flatnonzero(steep & alike & inside)
    start, end = ys[cells][:, None], ys[cells + 1][:, None]

    def is_before(x: Array) -> NDArray[np.bool_]:
        values = on(function, x)
        return np.abs(values - start) <= np.abs(values - end)

    a, b = narrowed(is_before, xs[cells], xs[cells + 1])
    width = NEAR_POINT * (xs[cells + 1] - xs[cells])
    jumps = np.abs(function(b + width) - function(a - width)) > JUMP_OF_PANEL * span / 2
    return list(map(float, np.where(is_before(b[:, None])[:, 0], b, a)[jumps]))


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
    """Return the values on an even grid: more of them are near poles."""
    ys = np.interp(np.linspace(trace.xs[0], trace.xs[-1], PLOT_CELLS + 1), trace.xs, trace.ys)
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
