"""What is said of friction along a parameter, held against dense sampling of emitted code.

Each function yields what sampling refutes, in words; nothing where all holds. Where code has no
value nothing is refuted.
"""

import math
import operator
from collections.abc import Iterator, Mapping

import numpy as np

from compiled_ratios import Ratio
from mechc.compilation import Compilation
from mechc.formula.walk import symbols
from mechc.model.mechanism import Mechanism
from mechc.model.parts.targets import SIGNS, Efficiency, WithFriction
from mechc.model.values import defaults, dependent, independent
from mechc.routine.evaluate import evaluate
from mechc.routine.steps import Function
from mechc.study.analysis import Analysis
from mechc.study.locking_intervals import USUAL, EfficiencyRange, LockingInterval, LockingIntervals
from statements import evaluate as value_of
from statements import poses, with_rest

DENSE = 2001
"""Places along a range."""

BESIDE = (1e-3, 1e-4, 3e-5)
"""How far from what is said to be an end is looked, too, as parts of the range."""

NEAR = 1e-5
"""What is nearer to an end is not looked at: four figures of it are stated."""

ENOUGH = 1e-3
"""What an efficiency may be off: three figures are stated."""

BENDS, WITHIN_BENDS = 4, 41
"""Where k bends most a zero may hide next to a pole: so many places, each looked at so closely."""

OUTSIDE = 201
"""Places along a stretch that lies outside the range, or has none."""

ROUNDED_ZERO = 1e-10
"""A ratio that is smaller is a zero that was rounded, one above the inverse a pole."""

ASIDE = 1.7e-8
"""The part of the range by which places are moved: a slip may be zero at a round value alone."""

STATES = {0: "free", 3: "locked", 4: "jammed"}
"""What the status in code means; of others nothing is known."""

ULPS = 1e-13
"""The part of a parameter by which poses next to each other differ."""

CASES = 4
"""Poses at which the printed case of a ratio with friction is compared with code."""

COMPARED = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "=": operator.eq,
    "!=": operator.ne,
}

Array = np.ndarray


class Ratios:
    """A ratio without friction and the same with it, as code gives them along a parameter."""

    def __init__(self, compilation: Compilation, result: Analysis) -> None:
        named = {r.target: r.name for r in compilation.solution.results}
        target = result.target
        assert isinstance(target, WithFriction | Efficiency)
        self.sense = SIGNS[target.sense]
        real = named[WithFriction(target.of, target.sense)]
        self.parts = Ratio(compilation, named[target.of]), Ratio(compilation, real)
        inputs = [i for part in self.parts for i in part.function.inputs]
        self.defaults = {i.name: 1.0 if i.default is None else i.default for i in inputs}

    def without(self, name: str, places: Array) -> Array:
        """Return k."""
        return self._value(self.parts[0], name, places)

    def _value(self, of: Ratio, name: str, places: Array) -> Array:
        return np.broadcast_to(of.values({**self.defaults, name: places}), places.shape)

    def along(self, name: str, places: Array) -> tuple[Array, Array]:
        """Return k, and the ratio with friction as a part of it; NaN at a dead centre."""
        k, real = (self._value(f, name, places) for f in self.parts)
        with np.errstate(all="ignore"):
            share = real / k
            largest = np.fmax(np.fmax(np.abs(k), np.abs(real)), np.abs(share))
            is_dead = (np.abs(k) <= ROUNDED_ZERO) | (largest >= 1 / ROUNDED_ZERO)
            return k, np.where(is_dead, np.nan, share)

    def states(self, values: Mapping[str, float | Array]) -> Array:
        """Return the statuses in code, with the other parameters at their values."""
        ideal, real = self.parts
        return real.states(ideal.function, {**self.defaults, **values})


def refuted(compilation: Compilation) -> Iterator[str]:
    """Yield every statement on friction that sampling refutes.

    Where a ratio is 0/0 at the values given, code has a quotient of roundings along other lines.
    """
    open_ = {result.target for result in compilation.results if result.undetermined}
    for result in compilation.results:
        if isinstance(result.target, WithFriction | Efficiency) and result.target.of in open_:
            continue
        if result.locking:
            yield from as_given(Ratios(compilation, result), result)
            yield from who_drives(Ratios(compilation, result), result)
        for reach in result.locking.reaches if result.locking else ():
            if reach.range:
                yield from stuck(Ratios(compilation, result), result, reach)
            for stretch in reach.stretches:
                yield from throughout(Ratios(compilation, result), result, reach, stretch)
        for efficiency in result.efficiency_ranges:
            yield from run(Ratios(compilation, result), result, efficiency)
        if result.holds:
            yield from printed(compilation, result)


def stuck(ratios: Ratios, result: Analysis, reach: LockingIntervals) -> Iterator[str]:
    """Yield where something moves that is said to be stuck, or the other way round."""
    assert reach.range is not None
    low, high = reach.range
    parts = [(s.within, s.state) for s in reach.stretches if s.within]
    ends = [end for within, _ in parts for end in within]
    near = [e + way * d * (high - low) for e in ends for d in BESIDE for way in (1, -1)]
    even = np.linspace(low, high, DENSE + 2)[1:-1] + ASIDE * (high - low)
    places = np.unique([*even, *near, *bent(ratios, reach.parameter, even)])
    places = places[(places > low) & (places < high)]
    for x, k, share in zip(places, *ratios.along(reach.parameter, places), strict=True):
        if math.isnan(share) or any(abs(x - e) < NEAR * (high - low) for e in ends):
            continue
        held = "locked" if ratios.sense * k < 0 else "jammed"
        truth = [] if share > 0 else [held]
        if (said := [state for (a, b), state in parts if a <= x <= b]) != truth:
            yield f"{result.name} at {reach.parameter} = {x!r}: said {said}, is {truth}"
            return


def bent(ratios: Ratios, name: str, places: Array) -> Array:
    """Return places that lie closely where k bends most."""
    k = ratios.without(name, places)
    with np.errstate(all="ignore"):
        bends = np.abs(np.diff(k, 2)) / np.abs(k[1:-1])
    most = np.argsort(np.where(np.isfinite(bends), bends, 0.0))[-BENDS:]
    return np.concatenate([np.linspace(*places[[i, i + 2]], WITHIN_BENDS) for i in most])


def as_given(ratios: Ratios, result: Analysis) -> Iterator[str]:
    """Yield the state at the values given, where it is not what code has."""
    assert result.locking is not None
    state = STATES.get(int(ratios.states({})))
    if state and result.locking.state not in (None, state):
        yield f"{result.name} at the values given: said {result.locking.state}, is {state}"


def who_drives(ratios: Ratios, result: Analysis) -> Iterator[str]:
    """Yield a load that drives and is said to be driven, or the other way round.

    Friction makes the force of the load that drives larger, and smaller what holds it back.
    """
    share = float(ratios.along("", np.zeros(1))[1][0])
    if (
        result.driven is not None
        and share > 0
        and (share < 1) != result.driven
        and abs(share - 1) > ROUNDED_ZERO
    ):
        yield f"{result.name}: driven is {result.driven}, and friction makes it {share} times k"


def throughout(
    ratios: Ratios, result: Analysis, reach: LockingIntervals, stretch: LockingInterval
) -> Iterator[str]:
    """Yield where code has another state within a stretch, outside the range or in it."""
    ends = reach.range or (math.nan, math.nan)
    low = stretch.low.x if stretch.low else ends[0]
    high = stretch.high.x if stretch.high else ends[1]
    places = low + (high - low) * (np.linspace(NEAR, 1 - NEAR, OUTSIDE) + ASIDE)
    for x, code in zip(places, ratios.states({reach.parameter: places}), strict=True):
        if STATES.get(int(code), stretch.state) != stretch.state:
            yield f"{result.name} at {reach.parameter} = {x!r}: {stretch.state}, is {code}"
            return


ENDLESS = 1e12
"""A load in SI that is infinite, and of which rounding makes a number."""


def printed(compilation: Compilation, result: Analysis) -> Iterator[str]:
    """Yield where the printed case holds, as it says, and code has another value, or none.

    Where there is no pose code has no value without friction either.
    """
    functions = {f.name: f for f in compilation.routine.functions}
    named = {r.target: r.name for r in compilation.solution.results}
    function, ideal = functions[result.name], functions[named[result.target.of]]
    names = {i.name for f in (function, ideal) for i in f.inputs}
    for known in _nearby(compilation.pose.mechanism, result):
        if not symbols(result.formula) | names <= known.keys() or not _holds(result, known):
            continue
        here, code = value_of(result.formula, known), float(evaluate(function, known))
        if math.isnan(code) and math.isnan(float(evaluate(ideal, known))):
            continue
        if math.isinf(code) and abs(here) > ENDLESS:
            continue
        alike = math.isclose(here, code, rel_tol=1e-7, abs_tol=1e-12)
        if math.isfinite(here) and not alike and _is_inside(function, known):
            yield f"{result.name} is {code}, printed {here} at {known}"
            return


def _is_inside(function: Function, known: Mapping[str, float]) -> bool:
    """Return whether a pose has others next to it on either side.

    Where a loop ends its angles have half the digits of others, however they are computed.
    """
    steps = (1 - ULPS, 1 + ULPS)
    moved = ({**known, i.name: known[i.name] * step} for i in function.inputs for step in steps)
    return all(math.isfinite(float(evaluate(function, values))) for values in moved)


def _nearby(mechanism: Mechanism, result: Analysis) -> Iterator[Mapping[str, float]]:
    """Yield the values given, values nearby, and farther away in the ranges.

    A load that follows from the pose, as a spring's force does, or is found, is none to be given.
    """
    given = defaults(mechanism)
    following = {*dependent(mechanism), *dict(result.where), *(f.name for f in mechanism.finds)}
    free_loads = {load.name for load in mechanism.loads} - following
    for i, pose in enumerate(poses(mechanism, result, CASES, CASES)):
        part = 0.5 ** (i % 8) if i else 0.0
        free = {p.name for p in independent(mechanism)} & given.keys()
        moved = {n: given[n] + part * (pose[n] - given[n]) for n in free}
        loads = {name: pose[name] for name in sorted(free_loads & pose.keys())}
        yield with_rest(mechanism, result, {**loads, **moved})


def _holds(result: Analysis, known: Mapping[str, float]) -> bool:
    """Return whether what is printed with a result holds; forces that are iterated exist, too."""
    conditions = (*result.holds, *(result.guards if result.inside else ()))
    if not all(symbols(c.left) | symbols(c.right) <= known.keys() for c in conditions):
        return False
    return all(
        COMPARED[c.operator](value_of(c.left, known), value_of(c.right, known)) for c in conditions
    )


def run(ratios: Ratios, result: Analysis, efficiency: EfficiencyRange) -> Iterator[str]:
    """Yield what an efficiency comes to beyond what it is said to run through."""
    width = efficiency.range[1] - efficiency.range[0]
    places = np.linspace(*efficiency.range, DENSE)[1:-1] + ASIDE * width
    k, share = ratios.along(efficiency.parameter, places)
    driven = ratios.sense * k < 0
    with np.errstate(all="ignore"):
        found = np.where(share > 0, np.where(driven, share, 1 / share), 0.0)
    known = ~np.isnan(share)
    where = f"{result.name} over {efficiency.parameter}"
    for x, eta in zip(places[known], found[known], strict=True):
        if not efficiency.least - ENOUGH <= eta <= efficiency.greatest + ENOUGH:
            yield f"{where} is {eta} at {x!r}, not {efficiency.least} to {efficiency.greatest}"
            return
        if any(abs(x - end) < NEAR * width for part in efficiency.usual for end in part):
            continue
        is_said = any(a <= x <= b for a, b in efficiency.usual)
        slack = ENOUGH if is_said else -ENOUGH
        if is_said != (USUAL[0] - slack <= eta <= USUAL[1] + slack):
            yield f"{where} is {eta} at {x!r}: usual from … to {efficiency.usual}"
            return
