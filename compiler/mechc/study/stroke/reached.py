"""Which parts of the stroke the mechanism can run to from its default pose, as it is put together.

Where a loop that is closed by a formula has come to its end, the formula may have a value
again farther on. It is the same closure by its root, and another assembly of the links.
"""

import math
from collections.abc import Sequence

from ..tolerances import SAME_VALUE
from .stroke import StrokeInterval

FULL_TURN = 2 * math.pi


def with_reached(
    stretches: Sequence[StrokeInterval], default: float | None, excluded: str, turns: bool
) -> tuple[StrokeInterval, ...]:
    """Return the stretches, those marked that cannot be reached from the default pose.

    ``excluded`` is what ends a stretch that the loops go on beyond. A drive that ``turns``
    comes back to where it was. Nothing is marked where the default pose is on no stretch.
    """
    groups = _together(stretches, excluded)
    around = stretches and _comes_round(stretches[0], stretches[-1], turns)
    if around and len(groups) > 1:
        groups = [[*groups[-1], *groups[0]], *groups[1:-1]]
    home = next((g for g in groups if default is not None and _holds(g, default)), None)
    if home is None:
        return tuple(stretches)
    return tuple(s._replace(reached=s in home) for s in stretches)


def _together(stretches: Sequence[StrokeInterval], excluded: str) -> list[list[StrokeInterval]]:
    """Return runs of stretches between which the loops close."""
    groups: list[list[StrokeInterval]] = []
    for stretch in stretches:
        if groups and groups[-1][-1].after == stretch.before == excluded:
            groups[-1].append(stretch)
        else:
            groups.append([stretch])
    return groups


def _comes_round(first: StrokeInterval, last: StrokeInterval, turns: bool) -> bool:
    whole = math.isclose(last.high - first.low, FULL_TURN, rel_tol=SAME_VALUE)
    return turns and whole and not first.before and not last.after


def _holds(stretches: Sequence[StrokeInterval], x: float) -> bool:
    return any(s.low <= x <= s.high for s in stretches)
