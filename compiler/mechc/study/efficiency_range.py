"""Through what an efficiency runs, and how long it is what textbooks assume."""

import math
from collections.abc import Iterator

from ..model.locking import USUAL, EfficiencyRange, Range
from ..model.mechanism import Efficiency
from ..model.result import Result
from ..model.values import range_of
from .ranges import moved, spans, unit_of, varying
from .ratios import Study
from .sampling import looked_at
from .states import Moving
from .tolerances import SAME_EFFICIENCY


def courses(study: Study, efficiency: Result) -> Iterator[EfficiencyRange]:
    """Yield the course of an efficiency over each range that it depends on."""
    assert isinstance(efficiency.target, Efficiency)
    of, sense = efficiency.target.of, efficiency.target.sense
    both, mechanism = (study.ideal(of), study.real(of, sense)), study.mechanism
    turning = set(moved(mechanism, both))
    for name in varying(mechanism, both):
        ends, moving = range_of(name, mechanism), study.moving(of, sense, name)
        if ends and moving:
            course = _Run(moving, *ends).course(name, unit_of(name, mechanism))
            if course and (name in turning or course.greatest - course.least > SAME_EFFICIENCY):
                yield course


class _Run:
    """An efficiency over one range."""

    def __init__(self, moving: Moving, low: float, high: float) -> None:
        self._moving, self._low, self._high = moving, low, high
        self._sweep = looked_at(moving, low, high)

    def course(self, name: str, unit: str) -> EfficiencyRange | None:
        """Return the whole, None where there is no efficiency anywhere."""
        values = [v for x in self._sweep if math.isfinite(v := self._moving.efficiency(x))]
        if not values:
            return None
        ends, usual = (self._low, self._high), tuple(self._usual())
        return EfficiencyRange(name, unit, ends, min(values), max(values), usual)

    def _usual(self) -> Iterator[Range]:
        """Yield the stretches on which it is usual, if it only passes through that, too."""
        low, high = USUAL
        enough = spans(self._sweep, lambda x: self._moving.efficiency(x) >= low)
        for first, last in list(enough):
            inside = [x for x in self._sweep if first < x < last]
            grid = [first, *inside, last]
            yield from spans(grid, lambda x: self._moving.efficiency(x) <= high)
