"""Where a result is least and greatest along a stretch."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal

from ...formula.roots import lowest, roots
from ..analysis import Analysis
from ..tolerances import CONSTANT
from .along import Along
from .stroke import Extremum

KINDS: Mapping[int, Literal["minimum", "maximum"]] = {1: "minimum", -1: "maximum"}


def extrema(
    result: Analysis, drive: str, along: Along, places: Sequence[float]
) -> Iterator[Extremum]:
    """Yield the extrema between places that lie close together."""
    values = [along.of(result.formula, result, x) for x in places]
    least = CONSTANT * _usual(values)
    for i in range(1, len(places) - 1):
        before, here, after = values[i - 1 : i + 2]
        turns = before > here <= after or before < here >= after
        if turns and max(abs(before - here), abs(after - here)) > least:
            sense = 1 if here <= after else -1
            near = _turning(result, drive, along, sense, (places[i - 1], places[i + 1]))
            value = along.of(result.formula, result, near)
            if not sense * value <= sense * here:
                near, value = places[i], here
            yield Extremum(result.name, KINDS[sense], near, value)


def turns_between(
    extremum: Extremum, poles: Sequence[float], result: Analysis, along: Along
) -> bool:
    """Tell an extremum near a pole from a value at the pole, which is rounding.

    The result turns there within an eighth of the way to the pole.
    """
    step = min(abs(extremum.drive - pole) for pole in poles) / 8
    beside = (along.of(result.formula, result, extremum.drive + s * step) for s in (-1, 1))
    sense = 1 if extremum.kind == "minimum" else -1
    return all(sense * value > sense * extremum.value for value in beside)


def _usual(values: Sequence[float]) -> float:
    """Return a size that most values do not exceed: near poles they exceed any."""
    sizes = sorted(abs(v) for v in values if math.isfinite(v))
    return sizes[len(sizes) * 9 // 10] if sizes else 0.0


def _turning(
    result: Analysis, drive: str, along: Along, sense: int, within: tuple[float, float]
) -> float:
    """Return the place between two others at which a result turns: where its slope is 0."""
    slope = (result.derivatives or {}).get(drive)
    if slope is not None:
        found = roots(lambda x: along.of(slope, result, x), within)
        if found:
            return found[0].place
    return lowest(lambda x: sense * along.of(result.formula, result, x), *within)
