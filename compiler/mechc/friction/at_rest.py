"""Results at a default pose in which a slip is 0 for once: what they come to beside it.

Friction has no sense there. What is without it is the limit of neither side, and no value of the
motion: where both sides come to one value that is the result, elsewhere the result jumps.
"""

import math
from collections.abc import Mapping, Sequence

from ..formula.tree import is_call
from ..model.result import Result
from ..model.values import completed
from ..pose.pose import Pose
from ..power.numbers import pose_values, value_of, values_along
from .tolerances import SAME_RESULT

STEP = 1e-8
"""How far from the default pose its sides are looked at, by the drive in SI."""


def sides(result: Result, pose: Pose, number: float | None) -> tuple[float, ...]:
    """Return the limits of a result beside the default pose, none where they are its number."""
    found = limits(result, pose)
    is_so = number is not None and all(math.isclose(s, number, rel_tol=SAME_RESULT) for s in found)
    return () if is_so else found


def limits(result: Result, pose: Pose) -> tuple[float, ...]:
    """Return the limits of a result before and after the default pose, one if they are alike.

    There is nothing where every slip has a sense, or has none along the drive either, where
    nothing balances on either side, and where no drive is named. NaN stands for a side on
    which nothing balances.
    """
    if pose.mechanism.drive is None or not any(is_call(d.formula, "sense") for d in result.where):
        return ()
    rest = _at_rest(result, pose_values(pose))
    if not rest:
        return ()
    sides = (s for s in (-STEP, STEP) if _is_pose(pose, values_along(pose, 2 * s)))
    moving = (s for s in sides if _at_rest(result, values_along(pose, s)) < rest)
    return one_or_both([_limit(result, pose, step) for step in moving], SAME_RESULT)


def one_or_both(limits: Sequence[float], same: float) -> tuple[float, ...]:
    """Return the limits on the sides of a pose, one where they are the ``same`` but for that part.

    NaN stands for a side on which nothing balances; there is nothing where that is so on all.

    >>> one_or_both([2.0, 2.0], 1e-6), one_or_both([1.0, 2.0], 1e-6), one_or_both([3.0], 1e-6)
    ((2.0,), (1.0, 2.0), (3.0,))
    >>> one_or_both([math.nan, 1.0], 1e-6), one_or_both([math.nan], 1e-6)
    ((nan, 1.0), ())
    """
    found = [limit for limit in limits if math.isfinite(limit)]
    if found and len(found) < len(limits):
        return tuple(x if math.isfinite(x) else math.nan for x in limits)
    low, high = min(found, default=0.0), max(found, default=0.0)
    if high - low > same * max(abs(low), abs(high)):
        return tuple(found)
    return (sum(found) / len(found),) if found else ()


def _at_rest(result: Result, values: Mapping[str, float]) -> int:
    """Return how many slips in a result are 0, so that their friction has no sense."""
    known = completed(values, result.where)
    return sum(is_call(d.formula, "sense") and known.get(d.name) == 0 for d in result.where)


def _is_pose(pose: Pose, values: Mapping[str, float]) -> bool:
    return not any(math.isnan(values.get(d.name, 0.0)) for d in pose.definitions)


def _limit(result: Result, pose: Pose, step: float) -> float:
    """Return the limit on one side, on the line through the values one and two steps away."""
    near, far = (value_of(result, values_along(pose, s)) for s in (step, 2 * step))
    limit = math.nan if near is None or far is None else 2 * near - far
    return limit if math.isfinite(limit) else math.nan
