"""Where in the stroke a mechanism can be assembled: stretches of the driving coordinate."""

import math
from collections.abc import Callable

from ...diagnostics.pose import Stretch
from ...formula.walk import evaluate
from ...model.values import Chain, dependent
from ...units import ANGLE, Dimension
from .dyads import Closure
from .state import State

SAMPLES = 720
"""Places along the stroke that are tried: every half degree of a full turn."""


def reach_of(state: State, closure: Closure) -> list[Stretch]:
    """Return the stretches of the drive in which a group closes, empty without a drive."""
    drive = state.mechanism.drive
    if drive is None:
        return []
    parameter = next(p for p in state.mechanism.parameters if p.name == drive.parameter)
    low, high = _limits(state, parameter.dimension)
    closes = _tester(state, closure, drive.parameter)
    places = [low + (high - low) * i / SAMPLES for i in range(SAMPLES + 1)]
    found: list[Stretch] = []
    start: float | None = None
    for i, place in enumerate(places):
        good = closes(place)
        if good and start is None:
            start = place if i == 0 else _edge(places[i - 1], place, closes)
        elif not good and start is not None:
            found.append(Stretch(start, _edge(place, places[i - 1], closes), parameter.dimension))
            start = None
    if start is not None:
        found.append(Stretch(start, high, parameter.dimension))
    return found


def _limits(state: State, dimension: Dimension) -> tuple[float, float]:
    drive = state.mechanism.drive
    assert drive is not None
    if drive.low is not None and drive.high is not None:
        ends = evaluate(drive.low, state.base), evaluate(drive.high, state.base)
        return min(ends), max(ends)
    if dimension == ANGLE:
        return -math.pi, math.pi
    return 0.0, 2 * state.base[drive.parameter]


def _tester(state: State, closure: Closure, drive: str) -> Callable[[float], bool]:
    definitions = dict((*state.definitions, *closure.definitions))
    chain = Chain({**dependent(state.mechanism), **definitions})
    given = {name: value for name, value in state.base.items() if name not in chain.names}

    def closes(place: float) -> bool:
        values = chain.complete({**given, drive: place})
        return all(map(math.isfinite, values.values()))

    return closes


def _edge(bad: float, good: float, closes: Callable[[float], bool]) -> float:
    """Halve the gap between a place that closes and one that does not, to the last bit."""
    while (middle := (bad + good) / 2) not in (bad, good):
        if closes(middle):
            good = middle
        else:
            bad = middle
    return good
