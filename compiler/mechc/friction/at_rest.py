"""Results at a default pose in which a slip is 0 for once: what they come to next to it.

Friction has no sense there. What is without it is the limit of neither side, and no value of the
motion: where both sides come to one value that is the result, elsewhere the result jumps.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..formula.evaluate import evaluate
from ..formula.tree import Formula, is_call
from ..formula.walk import symbols, walk
from ..model.mechanism import Efficiency, Mechanism
from ..model.result import Result
from ..model.values import completed, range_of
from ..pose.pose import Pose
from ..power.numbers import pose_values, value_of, values_along
from ..units import ANGLE
from .tolerances import NEAR_POSE, PRECISE, SAME_BY_ITERATION


def sides(result: Result, pose: Pose, number: float | None) -> tuple[float, ...]:
    """Return the limits of a result next to the default pose, none where they are its number."""
    found = limits(result, pose)
    is_so = number is not None and all(
        math.isclose(s, number, rel_tol=SAME_BY_ITERATION) for s in found
    )
    return () if is_so else found


def limits(result: Result, pose: Pose) -> tuple[float, ...]:
    """Return the limits of a result on both sides of the default pose, one if they are alike.

    There is nothing where every slip has a sense, or has none along the drive either, where
    nothing balances on either side. Without a drive the sides are those of all that may
    :func:`move <movers>` such a slip. NaN stands for a side on which nothing balances.
    """
    found = [_limit(result, pose, *side) for side in _sides(result, pose)]
    kept = one_or_both(found, SAME_BY_ITERATION)
    return kept if len(kept) < 3 else _least_and_greatest(kept)


def movers(result: Result, pose: Pose) -> frozenset[str]:
    """Return the parameters along which a slip has a sense that has none at the default pose."""
    return frozenset(name for name, _ in _sides(result, pose))


def values_nearby(result: Result, pose: Pose) -> dict[str, float]:
    """Return the value of a parameter on one side of the default pose, where slips have a sense.

    There is nothing where each has one at the default pose.
    """
    for name, step in _sides(result, pose):
        return {name: pose_values(pose).get(name, 0.0) + step}
    return {}


def _sides(result: Result, pose: Pose) -> Iterator[tuple[str, float]]:
    """Yield parameters and the steps by which they move a slip that is 0 at the default pose."""
    if not senses_in(result.where):
        return
    if not (rest := slips_at_rest(result, pose_values(pose))):
        return
    for name in followed(pose.mechanism):
        for step in _steps(pose, name):
            if slips_at_rest(result, values_along(pose, name, step)) < rest:
                yield name, step


def followed(mechanism: Mechanism) -> list[str]:
    """Return the drive; without one the angles, and what else has a range."""
    if mechanism.drive is not None:
        return [mechanism.drive.parameter]
    free = (p for p in mechanism.parameters if p.value and not p.dependent)
    return [p.name for p in free if p.dimension == ANGLE or p.range is not None]


def _steps(pose: Pose, name: str) -> Iterator[float]:
    """Yield the steps to either side at which a parameter is in its range, and there is a pose."""
    low, high = range_of(name, pose.mechanism) or (-math.inf, math.inf)
    is_within = low <= pose_values(pose).get(name, 0.0) <= high
    for step in (-NEAR_POSE, NEAR_POSE):
        values = values_along(pose, name, 2 * step)
        if _is_pose(pose, values) and (low <= values[name] <= high or not is_within):
            yield step


def _least_and_greatest(limits: Sequence[float]) -> tuple[float, float]:
    """Return the bounds of limits along several parameters: (NaN, x) where some side jams."""
    found = [limit for limit in limits if math.isfinite(limit)]
    return (min(found) if len(found) == len(limits) else math.nan), max(found)


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


def slips_at_rest(result: Result, values: Mapping[str, float]) -> int:
    """Return how many slips in a result are 0, so that their friction has no sense."""
    known = completed(values, result.where)
    return sum(
        symbols(sense) <= known.keys() and evaluate(sense, known) == 0
        for sense in senses_in(result.where)
    )


def senses_in(where: Iterable[tuple[str, Formula]]) -> tuple[Formula, ...]:
    """Return the senses of slips in definitions: each by itself, or a part of coupled equations."""
    parts = (part for _, formula in where for part in walk(formula))
    return tuple(dict.fromkeys(part for part in parts if is_call(part, "sense")))


def _is_pose(pose: Pose, values: Mapping[str, float]) -> bool:
    return not any(math.isnan(values.get(d.name, 0.0)) for d in pose.definitions)


def _limit(result: Result, pose: Pose, name: str, step: float) -> float:
    """Return the limit on one side, on the line through the values one and two steps away."""
    near, far = (value_of(result, values_along(pose, name, s)) for s in (step, 2 * step))
    if near is None or far is None or not math.isfinite(2 * near - far):
        return math.nan
    limit, share = 2 * near - far, 1.0 if isinstance(result.target, Efficiency) else 0.0
    return 0.0 if abs(limit) <= max(SAME_BY_ITERATION * abs(near), PRECISE * share) else limit
