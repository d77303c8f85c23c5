"""The parts of a stroke on which there is a pose, their ends to the last bit.

Where a loop that is closed by a formula has come to its end, the formula may have a value
again farther on. It is the same closure by its root, and another assembly of the links: only
stretches between which the loops close can be reached from the default pose.
"""

import math
from collections.abc import Sequence
from itertools import pairwise

from ...base.named import NamedTuple
from ..pose_sweep import NO_POSE
from ..tolerances import AT_BRANCH_POINT, BRANCH_POINT, CROSSING, SAME_VALUE
from .ends import end_of_branch
from .run import StrokeRun
from .stroke import ChangePoint, StrokeInterval

BEYOND = "not followed beyond the branch point"

FLAT = "branch point"
"""Stands in a row at which a loop lies flat."""


class StretchEnd(NamedTuple):
    """Where a stretch ends, why, and the branch point that it ends at, if it does."""

    x: float
    why: str
    crossing: ChangePoint | None = None


def stretches_of(run: StrokeRun) -> tuple[list[StrokeInterval], list[ChangePoint]]:
    """Return the stretches in order, and the branch points at which some of them end."""
    found, crossings = list[StrokeInterval](), list[ChangePoint]()
    start = StretchEnd(run.grid[0], "") if stands(run, run.grid[0]) else None
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


def stands(run: StrokeRun, x: float) -> bool:
    """Return whether there is a pose, be it one in which a loop lies flat."""
    return trouble(run, x) in ("", FLAT)


def trouble(run: StrokeRun, x: float) -> str:
    """Return why there is no pose, or that a loop lies flat.

    Rounding decides whether a loop that is all but flat closes.
    """
    why = run.along.trouble(x)
    gaps = [abs(x - branch.drive) for branch in run.branches]
    if why in NO_POSE and any(gap <= BRANCH_POINT * run.range for gap in gaps):
        return FLAT
    return why or (FLAT if any(gap <= AT_BRANCH_POINT * run.range for gap in gaps) else "")


def _end(run: StrokeRun, bad: float, good: float) -> StretchEnd:
    """Return the last value before a bad one, and what ends there."""
    edge, why = _edge(run, bad, good), trouble(run, bad)
    if why not in NO_POSE:
        return StretchEnd(edge, why)
    end = end_of_branch(run.pose, run.along, edge, math.copysign(run.range, bad - good))
    if not end.crossed:
        return StretchEnd(end.x, why)
    return StretchEnd(end.x, BEYOND, ChangePoint(end.crossed, end.x, CROSSING))


def _edge(run: StrokeRun, bad: float, good: float) -> float:
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


FULL_TURN = 2 * math.pi


def with_reached(
    stretches: Sequence[StrokeInterval], default: float | None, excluded: str, turns: bool
) -> tuple[StrokeInterval, ...]:
    """Return the stretches, those marked that cannot be reached from the default pose.

    ``excluded`` is what ends a stretch that the loops go on beyond. A drive that ``turns``
    comes back to where it was. Nothing is marked where the default pose is on no stretch.
    """
    if default is None:
        return tuple(stretches)
    groups = _connected(stretches, excluded)
    if len(groups) > 1 and turns and _comes_round(stretches[0], stretches[-1]):
        groups = [[*groups[-1], *groups[0]], *groups[1:-1]]
    reached = next((group for group in groups if _holds(group, default)), stretches)
    return tuple(s._replace(reached=s in reached) for s in stretches)


def _connected(stretches: Sequence[StrokeInterval], excluded: str) -> list[list[StrokeInterval]]:
    """Return runs of stretches between which the loops close."""
    groups: list[list[StrokeInterval]] = []
    for stretch in stretches:
        if groups and groups[-1][-1].after == stretch.before == excluded:
            groups[-1].append(stretch)
        else:
            groups.append([stretch])
    return groups


def _comes_round(first: StrokeInterval, last: StrokeInterval) -> bool:
    """Return whether stretches end where they begin, a full turn later, with a pose there."""
    whole = math.isclose(last.high - first.low, FULL_TURN, rel_tol=SAME_VALUE)
    return whole and not first.before and not last.after


def _holds(stretches: Sequence[StrokeInterval], x: float) -> bool:
    return any(s.low <= x <= s.high for s in stretches)
