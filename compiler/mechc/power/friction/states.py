"""Whether a mechanism moves at a place: freely, or held by friction, or not at all.

Between k while releasing and k while tightening nothing moves. If 0 lies between them the
load alone moves nothing, which is self-locking: the ratio of the motion that the load
drives has not the sign of k. If the motion that the drive drives has no such ratio, no
force of the drive moves it.
"""

import math
from typing import NamedTuple

from ...formula.tree import Implicit
from ...formula.walk import walk
from ...model.locking import State
from ...model.result import Result
from ...model.targets import SIGNS, Sense
from ...model.values import holds
from .places import Places, value


class Found(NamedTuple):
    """What a place is like: ``share`` is the ratio with friction over the one without.

    ``driven`` tells the motion that the load drives from that of the drive; ``keeps`` that
    all joints are pressed as the formula says. There is no state at a dead centre, and
    where there is no pose.
    """

    state: State | None
    share: float
    driven: bool
    keeps: bool


NOWHERE = Found(None, math.nan, False, False)


class Moving:
    """A ratio with friction beside the one without, along one parameter."""

    def __init__(self, places: Places, ideal: Result, real: Result, sense: Sense) -> None:
        self.places, self.ideal, self.real = places, ideal, real
        self._sign = SIGNS[sense]
        self._known: dict[float, Found] = {}

    @property
    def is_iterated(self) -> bool:
        """Tell whether friction is found by iteration."""
        return any(isinstance(f, Implicit) for d in self.real.where for f in walk(d.formula))

    def at(self, place: float) -> Found:
        """Return what a place is like."""
        if place not in self._known:
            self._known[place] = self._look(place)
        return self._known[place]

    def driven(self, place: float) -> bool | None:
        """Return whether the motion is the one that the load drives; None at a dead centre."""
        ideal = self.places.of(self.ideal, place)
        return self._sign * ideal < 0 if math.isfinite(ideal) and ideal else None

    def _look(self, place: float) -> Found:
        driven = self.driven(place)
        if driven is None:
            return NOWHERE
        values = self.places.named(self.real, place)
        share = value(self.real.formula, values) / self.places.of(self.ideal, place)
        keeps = all(holds(guard, values) for guard in self.real.guards)
        if keeps and math.isfinite(share) and share > 0:
            return Found("free", share, driven, keeps)
        return Found("locked" if driven else "jammed", share, driven, keeps)

    def efficiency(self, place: float) -> float:
        """Return what of the power arrives, 0 where nothing moves, NaN at a dead centre."""
        state, share, driven, _ = self.at(place)
        if state is None:
            return math.nan
        return 0.0 if state != "free" else share if driven else 1 / share
