"""Where on a range conditions hold, to the last bit."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from .narrowing import Array, Function, narrowed, on
from .sampling import traced

Ends = tuple[float, float]


def stretches(functions: Sequence[Function], low: float, high: float) -> tuple[Ends, ...]:
    """Return the stretches of a range on which no function is negative.

    >>> [(round(a, 9), round(b, 9)) for a, b in stretches([np.sin], 1.0, 8.0)]
    [(1.0, 3.141592654), (6.283185307, 8.0)]
    """
    edges = {low, high}
    with np.errstate(all="ignore"):
        for function in functions:
            edges |= set(_edges(function, traced(function, low, high).xs))
        grid = sorted(edges)
        middles = np.array([(a + b) / 2 for a, b in pairwise(grid)])
        holds = np.all([f(middles) >= 0 for f in functions], axis=0)
    return tuple(_joined([pair for pair, so in zip(pairwise(grid), holds, strict=True) if so]))


def _edges(function: Function, xs: Array) -> list[float]:
    """Return the last points at which a function is not negative, before and behind it is."""
    holds = function(xs) >= 0
    cells = np.flatnonzero(holds[:-1] != holds[1:])
    good = np.where(holds[cells], xs[cells], xs[cells + 1])
    bad = np.where(holds[cells], xs[cells + 1], xs[cells])
    return list(map(float, narrowed(lambda x: on(function, x) >= 0, good, bad)[0]))


def _joined(found: Sequence[Ends]) -> list[Ends]:
    """Return stretches with those that touch as one."""
    joined: list[Ends] = []
    for low, high in found:
        if joined and joined[-1][1] == low:
            joined[-1] = joined[-1][0], high
        else:
            joined.append((low, high))
    return joined
