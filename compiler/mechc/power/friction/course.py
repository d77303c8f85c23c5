"""Through what an efficiency runs, and how long it is what textbooks assume."""

import math
from collections.abc import Iterator

from ...formula.roots import lowest
from ...model.locking import USUAL, Course
from ...model.mechanism import Efficiency, WithFriction
from ...model.result import Result
from ..balance import Balance
from .locking import sizes
from .places import Places
from .ranges import moved, range_of, spaced, spans, unit_of, varying
from .states import Moving

PLACES, ITERATED = 48, 12
"""Places at which a range is looked at; fewer where friction is found by iteration."""

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
        number = ITERATED if moving.is_iterated else PLACES
        self._places = spaced((low, high), number)

    def course(self, name: str, unit: str) -> Course | None:
        """Return the whole, None where there is no efficiency anywhere."""
        values = [(v, x) for x in self._places if math.isfinite(v := self._moving.efficiency(x))]
        if not values:
            return None
        least, greatest = self._extreme(min(values), 1), self._extreme(max(values), -1)
        usual = tuple(spans(self._places, self._is_usual))
        return Course(name, unit, (self._low, self._high), least, greatest, usual)

    def _extreme(self, found: tuple[float, float], sense: int) -> float:
        """Return what is least, or greatest, near a place where it is less than beside it."""
        value, place = found
        i = self._places.index(place)
        if self._moving.is_iterated or not 0 < i < len(self._places) - 1 or value in (0, 1):
            return value
        beside = self._places[i - 1], self._places[i + 1]
        near = self._moving.efficiency(
            lowest(lambda x: sense * self._moving.efficiency(x), *beside)
        )
        return near if sense * near < sense * value else value

    def _is_usual(self, place: float) -> bool:
        return USUAL[0] <= self._moving.efficiency(place) <= USUAL[1]
