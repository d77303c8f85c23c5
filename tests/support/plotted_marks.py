"""Marks of plots that are not true: a default pose off the result, an extremum that is none."""

import math
from collections.abc import Iterator

from mechc.model.result import Result
from mechc.plot.plot import Curve, Plot

SAME = 1e-6
"""What a value may differ by, as a part of the largest one on its curve."""


def refuted(result: Result, plot: Plot) -> Iterator[str]:
    """Yield the marks on the curve of a result that are refuted by the result, or by the curve."""
    for curve in plot.curves:
        yield from _default(result, curve)
        yield from _extrema(curve, plot)


def _default(result: Result, curve: Curve) -> Iterator[str]:
    """Yield a mark of the default pose that is not at the value of the result.

    Where it jumps as something else varies the curve has what code has, which is between.
    """
    if result.default is None or len(result.sides) > 1:
        return
    for mark in (m for m in curve.marks if m.kind == "default"):
        if not _is_near(mark.at.y, result.default):
            yield f"{curve.name} is marked at {mark.at.y} by default, and is {result.default}"


def _is_near(found: float, value: float) -> bool:
    return math.isclose(found, value, rel_tol=SAME, abs_tol=1e-12)


def _extrema(curve: Curve, plot: Plot) -> Iterator[str]:
    """Yield the extrema that the next points of the curve go beyond, up to its breaks."""
    size = max((abs(p.y) for piece in curve.pieces for p in piece), default=0.0)
    cell = (plot.high - plot.low) / 2000
    for mark in (m for m in curve.marks if m.kind in ("minimum", "maximum")):
        sense = 1 if mark.kind == "minimum" else -1
        whole = next((p for p in curve.pieces if p[0].x <= mark.at.x <= p[-1].x), ())
        beyond = [p.y for p in whole if abs(p.x - mark.at.x) < cell]
        if any(sense * (mark.at.y - y) > SAME * size for y in beyond):
            yield f"{curve.name} has no {mark.kind} at {mark.at}: {beyond}"
