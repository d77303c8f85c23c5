"""Self-locking as a condition: solved for each angle, and where in its range it holds."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import chain, groupby, pairwise

from ...algebra.from_formula import to_product
from ...formula.operations import count_operations
from ...formula.solved import Solution, poles, zeros
from ...formula.tree import Formula
from ...formula.walk import evaluate, symbols
from ...frozen import frozen
from ...model.locking import Bound, Locking, Range, Reach, State, Stretch
from ...model.mechanism import LoadForm, LoadRatio, WithFriction
from ...model.result import Result
from ..balance import Balance
from .places import Places
from .ranges import EXACT, NEARLY, last, range_of, turns, unit_of, varying
from .sampling import PLACES, before_dead_centre, dead_centre, looked_at
from .states import Moving

BEYOND = math.pi / 2
"""How far beyond its range an angle is followed, to the next dead centre at most."""

SHORT = 12
"""An end of more operations than this is told as a figure."""

LONG = 200
"""A formula of more operations than this is not solved for anything."""

Solve = Callable[[Formula, str], Iterator[Solution]]

CLEAR = 10.0
"""At the end of what is locked k is nil, at that of what is jammed infinite: so many times."""


def locking(balance: Balance, real: Result, printed: Result) -> Locking | None:
    """Return where a ratio with friction is locked or jammed; None where it has no values.

    ``printed`` is the same as it is printed, which is what is solved for angles.
    """
    assert isinstance(real.target, WithFriction)
    asked = real.target.of
    assert isinstance(asked, LoadRatio | LoadForm)
    ideal = next(r for r in balance.results if r.target == asked)
    loads = sizes(balance, real)
    if loads is None:
        return None
    mechanism, sense = balance.plan.graph.pose.mechanism, real.target.sense
    at_default = Moving(Places(balance.plan, "", loads), ideal, real, sense).at(0.0).state
    if at_default is None:
        return None
    reaches = []
    for name in varying(mechanism, (ideal, real)):
        moving = Moving(Places(balance.plan, name, loads), ideal, real, sense)
        looked_at = _window(name, moving, balance)
        if looked_at is not None:
            stretches = _Stretches(name, moving, printed, range_of(name, mechanism))
            unit = unit_of(name, mechanism)
            reaches.append(Reach(name, unit, stretches.range, tuple(stretches.found(*looked_at))))
    drive, load = (asked.load, "") if isinstance(asked, LoadForm) else (asked.above, asked.below)
    return Locking(at_default, drive, load, tuple(reaches))


def sizes(balance: Balance, real: Result) -> dict[str, float] | None:
    """Return sizes for loads without one: any will do for one load, for several none."""
    loads = {load.name for load in balance.plan.graph.pose.mechanism.loads}
    formulas = [real.formula, *(d.formula for d in real.where)]
    known = {d.name for d in real.where}
    missing = {s for f in formulas for s in symbols(f)} & loads - known
    return dict.fromkeys(missing, 1.0) if len(missing) < 2 else None


# ---------------------------------------------------------------------- what is looked at


def _window(name: str, moving: Moving, balance: Balance) -> Range | None:
    """Return what is looked at: the range, and of an open pose what is beyond it."""
    pose = balance.plan.graph.pose
    given = range_of(name, pose.mechanism)
    if pose.definitions or moving.is_iterated or not turns(name, pose.mechanism):
        return given
    here = moving.places.defaults[name]
    low, high = given or (here, here)
    return (
        _next_dead_centre(low, -BEYOND, moving),
        _next_dead_centre(high, BEYOND, moving),
    )


def _next_dead_centre(start: float, beyond: float, moving: Moving) -> float:
    """Return the place of the next dead centre, or where nothing more is looked at."""
    driven = moving.driven(start)
    if driven is None:
        return start
    places = [start + beyond * step / PLACES for step in range(PLACES + 1)]
    for before, place in pairwise(places):
        if moving.driven(place) != driven:
            return before_dead_centre(moving, before, place)
    return places[-1]


# --------------------------------------------------------------------------- stretches


@frozen
class _Stretches:
    """Finds the stretches of one parameter on which nothing moves."""

    name: str
    moving: Moving
    printed: Result
    range: Range | None

    def found(self, low: float, high: float) -> Iterator[Stretch]:
        """Yield the stretches in their order."""
        places = looked_at(self.moving, low, high, self.range or ()) if low < high else []
        first = 0
        for state, group in groupby(places, lambda x: self.moving.at(x).state):
            last = first + len(list(group)) - 1
            if state in ("locked", "jammed") and (one := self._stretch(places, first, last, state)):
                yield one
            first = last + 1

    def _stretch(
        self, places: Sequence[float], first: int, last: int, state: State
    ) -> Stretch | None:
        low, high = self._end(places, first, -1), self._end(places, last, 1)
        if not self._is_certain(state, (low, high), places[(first + last) // 2]):
            return None
        begins = places[first] if low is None else low.place
        ends = places[last] if high is None else high.place
        return Stretch(state, low, high, self._within(begins, ends))

    def _end(self, places: Sequence[float], i: int, way: int) -> Bound | None:
        """Return where a state ends that the place i is the last to have."""
        if not 0 <= i + way < len(places):
            return None
        a, b = places[i], places[i + way]
        here, there = self.moving.at(a), self.moving.at(b)
        if there.state is None or here.driven != there.driven:
            is_pose = not math.isnan(self.moving.places.of(self.moving.ideal, b))
            return self._bound(
                dead_centre(self.moving, a, b), self.moving.ideal, (zeros, poles), is_pose
            )
        state = here.state
        width = NEARLY if self.moving.is_iterated else EXACT
        place = last(lambda x: self.moving.at(x).state == state, a, b, width)
        return self._bound(place, self.printed, (zeros if state == "locked" else poles,))

    def _is_certain(
        self, state: State, ends: tuple[Bound | None, Bound | None], middle: float
    ) -> bool:
        """Tell what is stuck from a formula that merely ends, where a joint is relieved."""
        inside = self.moving.at(middle)
        bounds = (e for e in ends if e is not None and not e.is_dead_centre)
        shares = [abs(self.moving.at(e.place).share) for e in bounds]
        if not shares or inside.keeps:
            return not inside.share > 0
        if state == "locked":
            return any(share < 1 / CLEAR for share in shares)
        return any(not share <= CLEAR for share in shares)

    def _within(self, low: float, high: float) -> Range | None:
        if self.range is None:
            return None
        first, last = max(low, self.range[0]), min(high, self.range[1])
        return (first, last) if first < last else None

    def _bound(
        self, place: float, result: Result, ways: Sequence[Solve], is_dead_centre: bool = False
    ) -> Bound:
        """Return an end with its formula, if it has one of names that do not vary themselves."""
        if count_operations(result.formula) > LONG:
            return Bound(place, None, is_dead_centre)
        values = self.moving.places.named(result, place)
        varying = self.moving.places.varying(result)
        for solution in chain(*(solve(result.formula, self.name) for solve in ways)):
            exact = solution.at(place, values)
            if exact is not None and symbols(exact).isdisjoint(varying) and _is_short(exact):
                shown = exact if solution.period else to_product(exact).formula()
                return Bound(evaluate(exact, values), shown, is_dead_centre)
        return Bound(place, None, is_dead_centre)


def _is_short(exact: Formula) -> bool:
    return count_operations(exact) <= SHORT
