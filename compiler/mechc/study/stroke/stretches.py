"""The parts of a stroke on which there is a pose, their ends to the last bit."""

import math
from collections.abc import Sequence
from itertools import pairwise

from ...named import NamedTuple
from ..tolerances import AT_BRANCH_POINT, BRANCH_POINT, CROSSING
from .along import NO_POSE
from .ends import end_of_branch
from .run import Run
from .stroke import Branch, StrokeInterval

BEYOND = "not followed beyond the branch point"

FLAT = "branch point"
"""Stands in a row at which a loop lies flat."""


class End(NamedTuple):
    """Where a stretch ends, why, and the branch point that it ends at, if it does."""

    x: float
    why: str
    crossing: Branch | None = None


def stretches_of(run: Run) -> tuple[list[StrokeInterval], list[Branch]]:
    """Return the stretches in order, and the branch points at which some of them end."""
    found, crossings = list[StrokeInterval](), list[Branch]()
    start = End(run.grid[0], "") if stands(run, run.grid[0]) else None
    standing = [stands(run, x) for x in run.grid]
    for (a, b), (before, after) in zip(pairwise(run.grid), pairwise(standing), strict=True):
        if after == before:
            continue
        end = _end(run, a, b) if after else _end(run, b, a)
        crossings += [end.crossing] if end.crossing else []
        if start is not None:
            found.append(StrokeInterval(start.x, end.x, start.why, end.why))
        start = end if after else None
    if start is not None:
        found.append(StrokeInterval(start.x, run.grid[-1], start.why, ""))
    return found, crossings


def stands(run: Run, x: float) -> bool:
    """Return whether there is a pose, be it one in which a loop lies flat."""
    return trouble(run, x) in ("", FLAT)


def trouble(run: Run, x: float) -> str:
    """Return why there is no pose, or that a loop lies flat.

    Rounding decides whether a loop that is all but flat closes.
    """
    why = run.along.trouble(x)
    gaps = [abs(x - branch.drive) for branch in run.branches]
    if why in NO_POSE and any(gap <= BRANCH_POINT * run.range for gap in gaps):
        return FLAT
    return why or (FLAT if any(gap <= AT_BRANCH_POINT * run.range for gap in gaps) else "")


def _end(run: Run, bad: float, good: float) -> End:
    """Return the last value before a bad one, and what ends there."""
    edge, why = _edge(run, bad, good), trouble(run, bad)
    if why not in NO_POSE:
        return End(edge, why)
    end = end_of_branch(run.pose, run.along, edge, math.copysign(run.range, bad - good))
    if not end.crossed:
        return End(end.x, why)
    return End(end.x, BEYOND, Branch(end.crossed, end.x, CROSSING))


def _edge(run: Run, bad: float, good: float) -> float:
    while (middle := (bad + good) / 2) not in (bad, good):
        if stands(run, middle):
            good = middle
        else:
            bad = middle
    return good


def beyond(x: float, stretches: Sequence[StrokeInterval]) -> str:
    """Return the remark on a value between stretches one of which ends at a branch point."""
    before = [s.after for s in stretches if s.high < x]
    after = [s.before for s in stretches if s.low > x]
    return BEYOND if BEYOND in (*before[-1:], *after[:1]) else ""
