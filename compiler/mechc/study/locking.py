"""Self-locking as a condition: solved for each angle, and where in its range it holds."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import chain, groupby, pairwise

from ..algebra.from_formula import to_product
from ..base.frozen import frozen, on_demand, replace
from ..formula.evaluate import evaluate
from ..formula.operations import count_operations
from ..formula.positive_divisors import arcs_of_positive_divisors
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..formula.zeros_and_poles import AngleSolution, poles, zeros
from ..model.mechanism import LoadForm, LoadRatio, WithFriction
from ..model.result import Result
from ..model.values import range_of
from .locking_intervals import Bound, DriveState, Locking, LockingInterval, LockingIntervals, Range
from .ratios import FrictionStudy
from .sampling import (
    DEAD_CENTRE_CELLS,
    before_dead_centre,
    dead_centre,
    dead_centres,
    nearest,
    sampled_values,
)
from .states import RatioAlong
from .tolerances import EXACT, HALF_THE_DIGITS, NEARLY
from .variables import last, turns, unit_of, varying

BEYOND = math.pi / 2
"""How far beyond its range an angle is followed, to the next dead centre at most."""

WHOLE_TURN = 2 * math.pi - NEARLY
"""What is beyond a wider range is the same again."""

MOST_END_OPERATIONS = 12
"""An end of more operations than this is given as a figure."""

MOST_SOLVED_OPERATIONS = 200
"""A formula of more operations than this is not solved for anything."""

SolveFor = Callable[[Formula, str], Iterator[AngleSolution]]


def locking(study: FrictionStudy, real: Result, printed: Result) -> Locking | None:
    """Return where a ratio with friction is locked or jammed; None where it has no values.

    ``printed`` is the same as it is printed, which is what is solved for angles.
    """
    assert isinstance(real.target, WithFriction)
    asked = real.target.of
    assert isinstance(asked, LoadRatio | LoadForm)
    mechanism, sense = study.mechanism, real.target.sense
    here = study.moving(asked, sense, "")
    state = here.at(0.0).state if here else None
    if here is None or (state is None and not here.is_dead_centre(0.0)):
        return None
    moved = frozenset(varying(mechanism, (study.ideal(asked),)))
    reaches = []
    for name in varying(mechanism, (study.ideal(asked), real)):
        moving = study.moving(asked, sense, name)
        window = _window(name, name in moved, moving, study) if moving else None
        if moving and window:
            reaches.append(_reach(name, window, moving, printed, study))
    drive, load = (asked.load, "") if isinstance(asked, LoadForm) else (asked.above, asked.below)
    return Locking(state, drive, load, tuple(reaches))


def _reach(
    name: str, window: Range, moving: RatioAlong, printed: Result, study: FrictionStudy
) -> LockingIntervals:
    """Return the stretches of a parameter on which nothing moves."""
    mechanism = study.mechanism
    has_loops = bool(study.solution.plan.graph.pose.definitions)
    least = HALF_THE_DIGITS if has_loops or moving.is_iterated else NEARLY
    stretches = _Intervals(name, moving, printed, range_of(name, mechanism), least)
    moves = not stretches.may_be_solved and stretches.moves_in_range(*window)
    found = on_demand(lambda: tuple(stretches.found(*window)))
    reach = LockingIntervals(name, unit_of(name, mechanism), stretches.range, found, moves)
    return reach if moves else replace(reach, stretches=reach.stretches)


# ---------------------------------------------------------------------- what is looked at


def _window(name: str, is_moved: bool, moving: RatioAlong, study: FrictionStudy) -> Range | None:
    """Return the interval that is examined: the range, and around an open pose more than it.

    Not more of an angle of friction, on which the ratio without friction does not rest.
    """
    pose = study.solution.plan.graph.pose
    given = range_of(name, pose.mechanism)
    if pose.definitions or moving.is_slow or not (is_moved and turns(name, pose.mechanism)):
        return given
    here = moving.sweep.defaults[name]
    low, high = given or (here, here)
    if high - low > WHOLE_TURN:
        return given
    return (
        _next_dead_centre(low, -BEYOND, moving),
        _next_dead_centre(high, BEYOND, moving),
    )


def _next_dead_centre(start: float, beyond: float, moving: RatioAlong) -> float:
    """Return the next dead centre, or where nothing more is looked at."""
    driven = moving.driven(start)
    if driven is None:
        return start
    grid = [start + beyond * step / DEAD_CENTRE_CELLS for step in range(DEAD_CENTRE_CELLS + 1)]
    for before, x in pairwise(grid):
        if moving.driven(x) != driven:
            return before_dead_centre(moving, before, x)
    return grid[-1]


# --------------------------------------------------------------------------- stretches


@frozen
class _Intervals:
    """Finds the stretches of one parameter on which nothing moves.

    One narrower than the part ``least`` of what is looked at may be but rounding.
    """

    name: str
    moving: RatioAlong
    printed: Result
    range: Range | None
    least: float

    @property
    def may_be_solved(self) -> bool:
        """Return whether a formula may give the end of a stretch that is no dead centre."""
        return bool(self._solutions(self.printed, (zeros, poles)))

    def moves_in_range(self, low: float, high: float) -> bool:
        """Return whether it moves at each value in the range, and no dead centre is between.

        That is, between the range and the ends of what is looked at. Most of what is looked at
        lies there, near dead centres, where no closed form holds and friction is iterated.
        """
        if self.range is None or self.range == (low, high):
            return False
        near, centres = nearest(high - low), dead_centres(self.moving, low, high)
        beside = (c + away for c in centres for away in (-near, 0.0, near))
        between = (x for x in beside if low + 2 * near < x < high - 2 * near)
        return all(map(self._moves_as_in_range, between)) and all(
            self.moving.at(x).state == "free" for x in sampled_values(self.moving, *self.range)
        )

    def _moves_as_in_range(self, x: float) -> bool:
        """Return whether the load that drives is the same as at the next value in the range."""
        assert self.range
        low, high = self.range
        return self.moving.driven(x) == self.moving.driven(min(max(x, low), high))

    def found(self, low: float, high: float) -> Iterator[LockingInterval]:
        """Yield the stretches in their order."""
        grid = sampled_values(self.moving, low, high, self.range or ()) if low < high else []
        first = 0
        for state, group in groupby(self._states(grid)):
            last = first + len(list(group)) - 1
            if state in ("locked", "jammed"):
                interval = self._interval(grid, first, last, state)
                if not self._is_rounding(interval, high - low):
                    yield interval
            first = last + 1

    def _is_rounding(self, found: LockingInterval, width: float) -> bool:
        """Return whether an interval is no wider than angles are inexact where loops end."""
        ends = found.low, found.high
        if not all(ends):
            return False
        begins, finishes = (end.x for end in ends if end)
        return finishes - begins < self.least * width

    def _states(self, grid: Sequence[float]) -> list[DriveState | None]:
        """Return the state at each value.

        A dead centre at which the window ends has that of the value next to it: so near to it
        rounding leaves nothing to be solved.
        """
        states = [self.moving.at(x).state for x in grid]
        for end, beside in ((0, 1), (-1, -2)) if grid else ():
            is_near = _are_near(grid, grid[end], grid[beside])
            if states[end] is None and is_near and self._is_beyond(grid[end]):
                states[end] = states[beside]
        return states

    def _interval(
        self, grid: Sequence[float], first: int, last: int, state: DriveState
    ) -> LockingInterval:
        low, high = self._end(grid, first, -1), self._end(grid, last, 1)
        begins = grid[first] if low is None else low.x
        ends = grid[last] if high is None else high.x
        sampled, within = self._is_sampled(low, high), self._within(begins, ends)
        low, high = low or self._end_of_window(begins), high or self._end_of_window(ends)
        return LockingInterval(state, low, high, within, sampled)

    def _is_sampled(self, *ends: Bound | None) -> bool:
        """Return whether an interval was found by sampling, its ends not solved for."""
        solved = [end.exact is not None for end in ends if end]
        return self.moving.is_iterated or not solved or not all(solved)

    def _end(self, grid: Sequence[float], i: int, way: int) -> Bound | None:
        """Return where a state ends that the i-th value is the last to have."""
        if not 0 <= i + way < len(grid):
            return None
        a, b = grid[i], grid[i + way]
        here, there = self.moving.at(a), self.moving.at(b)
        if here.driven != there.driven:
            is_pose = not self.moving.sweep.trouble(b)
            return self._bound(
                dead_centre(self.moving, a, b), self.moving.ideal, (zeros, poles), is_pose
            )
        state, x = here.state, self._last(here.state, a, b)
        if there.state is None and _are_near(grid, x, b):
            return Bound(b, left_out=True)
        return self._bound(x, self.printed, (zeros if state == "locked" else poles,))

    def _last(self, state: DriveState | None, good: float, bad: float) -> float:
        """Return the last value of a state before one of another, or of which nothing is known."""
        width = NEARLY if self.moving.is_slow else EXACT
        return last(
            lambda x: self.moving.at(x).state == state, good, bad, width, self.moving.margin
        )

    def _end_of_window(self, x: float) -> Bound | None:
        """Return the end of what was looked at beyond the range; the range ends as it is given."""
        if not self._is_beyond(x):
            return None
        return self._bound(x, self.moving.ideal, (zeros, poles), True)

    def _is_beyond(self, x: float) -> bool:
        return self.range is None or not self.range[0] <= x <= self.range[1]

    def _within(self, low: float, high: float) -> Range | None:
        if self.range is None:
            return None
        first, last = max(low, self.range[0]), min(high, self.range[1])
        return (first, last) if first < last else None

    def _bound(
        self, x: float, result: Result, ways: Sequence[SolveFor], is_dead_centre: bool = False
    ) -> Bound:
        """Return an end with its formula, if it has one of names that do not vary themselves."""
        solutions = self._solutions(result, ways)
        values = self.moving.sweep.named(result, x) if solutions else {}
        varying = self.moving.sweep.varying(result) if solutions else set[str]()
        for solution in solutions:
            exact = solution.at(x, values)
            if exact is not None and symbols(exact).isdisjoint(varying) and _is_short(exact):
                shown = exact if solution.period else to_product(exact).formula()
                return Bound(
                    evaluate(exact, values),
                    arcs_of_positive_divisors(shown, values),
                    is_dead_centre,
                )
        return Bound(x, None, is_dead_centre)

    def _solutions(self, result: Result, ways: Sequence[SolveFor]) -> list[AngleSolution]:
        """Return the values of the parameter that a formula gives, none where it is long."""
        if count_operations(result.formula) > MOST_SOLVED_OPERATIONS:
            return []
        return [*chain(*(solve(result.formula, self.name) for solve in ways))]


def _are_near(grid: Sequence[float], a: float, b: float) -> bool:
    """Return whether nothing is looked at between two values, one of them a dead centre."""
    return abs(b - a) <= 2 * nearest(grid[-1] - grid[0])


def _is_short(exact: Formula) -> bool:
    return count_operations(exact) <= MOST_END_OPERATIONS
