"""Timing side by side: contenders take turns, medians are compared, never seconds."""

import gc
import math
import statistics
import sys
import time
from collections.abc import Callable, Mapping, Sequence

Contender = Callable[[], object]


def medians(contenders: Mapping[str, Contender], rounds: int) -> dict[str, float]:
    """Return the median time of each contender in seconds; they take turns in every round."""
    times: dict[str, list[float]] = {name: [] for name in contenders}
    for _ in range(rounds):
        for name, run in contenders.items():
            times[name].append(timed(run))
    return {name: statistics.median(spent) for name, spent in times.items()}


TURN = 0.02
"""A contender's turn lasts at least this long, in seconds; a quick one runs many times."""


def timed(run: Contender) -> float:
    """Return how long one call takes, in seconds: the mean over a turn.

    Garbage is not collected meanwhile, as in ``timeit``: the heap that a peer leaves
    behind would be charged to whoever comes next.
    """
    gc.collect()
    gc.disable()
    try:
        calls, start = 0, time.perf_counter()
        while not calls or time.perf_counter() - start < TURN:
            run()
            calls += 1
        return (time.perf_counter() - start) / calls
    finally:
        gc.enable()


def exponent(sizes: Sequence[int], costs: Sequence[float]) -> float:
    """Return the slope of log cost over log size by least squares.

    >>> round(exponent([1, 2, 4, 8], [3, 12, 48, 192]), 6)
    2.0
    """
    x, y = [math.log(n) for n in sizes], [math.log(c) for c in costs]
    return statistics.linear_regression(x, y).slope


def table(title: str, heading: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print rows in columns under a title."""
    cells = [[*heading], *([_cell(c) for c in row] for row in rows)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(heading))]
    print(f"\n{title}")
    for row in cells:
        padded = [
            c.ljust(w) if i == 0 else c.rjust(w)
            for i, (c, w) in enumerate(zip(row, widths, strict=True))
        ]
        print("  " + "  ".join(padded).rstrip())
    sys.stdout.flush()


def _cell(value: object) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
