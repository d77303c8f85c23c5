"""Where on a range conditions hold, to the last bit."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from .sampling import Function, traced

Stretch = tuple[float, float]


def stretches(functions: Sequence[Function], low: float, high: float) -> tuple[Stretch, ...]:
    """Return the stretches of a range on which no function is negative.

    >>> [(round(a, 9), round(b, 9)) for a, b in stretches([np.sin], 1.0, 8.0)]
    [(1.0, 3.141592654), (6.283185307, 8.0)]
    """
    edges = {low, high}
    with np.errstate(all="ignore"):
        for function in functions:
            trace = traced(function, low, high)
            edges |= {*trace.zeros, *trace.poles, *trace.jumps, *_ends(trace.xs, trace.ys)}
        places = sorted(edges)
        middles = np.array([(a + b) / 2 for a, b in pairwise(places)])
        holds = np.all([f(middles) >= 0 for f in functions], axis=0)
    return tuple(_joined([pair for pair, so in zip(pairwise(places), holds, strict=True) if so]))


def _ends(xs: np.ndarray, ys: np.ndarray) -> list[float]:
    """Return the places beside which a function has no value."""
    there = np.isfinite(ys)
    cells = np.flatnonzero(there[:-1] != there[1:])
    return [float(x) for x in np.where(there[cells], xs[cells], xs[cells + 1])]


def _joined(found: Sequence[Stretch]) -> list[Stretch]:
    """Return stretches with those that touch as one."""
    joined: list[Stretch] = []
    for low, high in found:
        if joined and joined[-1][1] == low:
            joined[-1] = joined[-1][0], high
        else:
            joined.append((low, high))
    return joined
