"""Through what an efficiency runs, and how long it is what textbooks assume."""

import math
from collections.abc import Iterator

from ...formula.roots import lowest
from ...model.locking import USUAL, Course, Range
from ...model.mechanism import Efficiency, WithFriction
from ...model.result import Result
from ..balance import Balance
from .locking import sizes
from .places import Places
from .ranges import moved, range_of, spans, unit_of, varying
from .sampling import looked_at
from .states import Moving

REFINED = 16
"""Sections to the least or greatest, after which three figures of it are right."""

SAME = 1e-9
"""What varies less is the same: the efficiency does not depend on that parameter."""


def courses(balance: Balance, efficiency: Result) -> Iterator[Course]:
    """Yield the course of an efficiency over each range that it depends on."""
    assert isinstance(efficiency.target, Efficiency)
    of, sense = efficiency.target.of, efficiency.target.sense
    ideal = next(r for r in balance.results if r.target == of)
    real = next(r for r in balance.results if r.target == WithFriction(of, sense))
    mechanism, loads = balance.plan.graph.pose.mechanism, sizes(balance, real)
    turning = set(moved(mechanism, (ideal, real)))
    for name in varying(mechanism, (ideal, real)) if loads is not None else ():
        ends = range_of(name, mechanism)
        if ends:
            moving = Moving(Places(balance.plan, name, loads or {}), ideal, real, sense)
            course = _Run(moving, *ends).course(name, unit_of(name, mechanism))
            if course and (name in turning or course.greatest - course.least > SAME):
                yield course


class _Run:
    """An efficiency over one range."""

    def __init__(self, moving: Moving, low: float, high: float) -> None:
        self._moving, self._low, self._high = moving, low, high
        self._places = looked_at(moving, low, high)

    def course(self, name: str, unit: str) -> Course | None:
        """Return the whole, None where there is no efficiency anywhere."""
        values = [(v, x) for x in self._places if math.isfinite(v := self._moving.efficiency(x))]
        if not values:
            return None
        least, greatest = self._extreme(min(values), 1), self._extreme(max(values), -1)
        return Course(name, unit, (self._low, self._high), least, greatest, tuple(self._usual()))

    def _extreme(self, found: tuple[float, float], sense: int) -> float:
        """Return what is least, or greatest, near a place where it is less than beside it."""
        value, place = found
        i = self._places.index(place)
        if not 0 < i < len(self._places) - 1 or value in (0, 1):
            return value
        beside = self._places[i - 1], self._places[i + 1]
        near = self._moving.efficiency(
            lowest(lambda x: sense * self._moving.efficiency(x), *beside, REFINED)
        )
        return near if sense * near < sense * value else value

    def _usual(self) -> Iterator[Range]:
        """Yield the stretches on which it is usual, if it only passes through that, too."""
        low, high = USUAL
        enough = spans(self._places, lambda x: self._moving.efficiency(x) >= low)
        for first, last in list(enough):
            inside = [x for x in self._places if first < x < last]
            places = [first, *inside, last]
            yield from spans(places, lambda x: self._moving.efficiency(x) <= high)
