"""Whether a mechanism moves in a pose: freely, or held by friction, or not at all.

It stays at rest while the ratio of the loads lies between k with friction while releasing and k
with friction while tightening. One of these motions is

free: its ratio has the sign of k without friction;
locked: the load drives it, and its ratio has not that sign. Then 0 lies between both ratios, and
the load alone moves nothing, which is self-locking;
jammed: the drive drives it, and its ratio has not that sign, so that no force of the drive moves
the mechanism.

That there is no such ratio is a solution as well: the load would have to be reversed, or the
forces that balance with less friction end before all of it acts. Where no solution of the
equations is found at all, no state is known.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from functools import cached_property

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.evaluate import status_along
from ..formula.numeric.newton_status import NewtonStatus
from ..formula.tree import Formula, Implicit, Number, Power, Product, Symbol, is_call
from ..formula.walk import symbols, walk
from ..model.parts.targets import SIGNS, Sense
from ..model.result import FrictionResult, Result
from ..model.values import Values
from .locking_intervals import DriveState, Range
from .pose_sweep import Functions
from .sweep import Sweep
from .tolerances import NEGLIGIBLE


class StateFound(NamedTuple):
    """The state in a pose: ``share`` is the ratio with friction over the one without.

    It is NaN where nothing balances. Of a ratio that is zero without friction it is the one with
    friction, in the sense of the motion. ``driven`` is whether the load drives the motion, not
    the drive, None at a dead centre. There is no state there, and where nothing was found.
    """

    state: DriveState | None
    share: float
    driven: bool | None


HowItEnds = tuple[Set[str], Callable[[Values], NewtonStatus]]
"""The names that a system rests on, and how the way to its solution ends at their values."""

NOWHERE = StateFound(None, math.nan, None)


class IdealRatio:
    """A ratio without friction, and what of it is looked at everywhere."""

    def __init__(self, result: Result) -> None:
        self.result = result

    @cached_property
    def factors(self) -> list[Formula]:
        """Return the factors of the ratio."""
        return [*factors(self.result.formula, dict(self.result.where))]

    @cached_property
    def divisors(self) -> list[Formula]:
        """Return the divisors in the terms of the ratio."""
        return [*divisors_of_terms(self.result.formula, dict(self.result.where))]


class IdealAlong:
    """A ratio without friction along one parameter, the same whichever way the motion goes.

    ``centres`` are the dead centres found between two ends.
    """

    def __init__(self, sweep: Sweep, ideal: IdealRatio) -> None:
        self.sweep, self.result, self._ideal = sweep, ideal.result, ideal
        self.centres: dict[Range, tuple[float, ...]] = {}
        self._dead: dict[float, bool] = {}

    def at(self, x: float) -> float:
        """Return the ratio."""
        return self.sweep.value_of(self.result, x)

    def is_dead_centre(self, x: float) -> bool:
        """Return whether the ratio is 0 or infinite, but for rounding, or there is none."""
        if x not in self._dead:
            self._dead[x] = self._is_dead_centre(x)
        return self._dead[x]

    def _is_dead_centre(self, x: float) -> bool:
        """Return the same; rounding is looked at only far from the ratio that is by default."""
        ideal = self.at(x)
        if not math.isfinite(ideal) or not ideal:
            return True
        if self._usual and NEGLIGIBLE < abs(ideal / self._usual) < 1 / NEGLIGIBLE:
            return False
        return not self._beyond_rounding(x)

    @cached_property
    def _usual(self) -> float:
        """Return the ratio by default, 0 at a dead centre."""
        return self._beyond_rounding(self.sweep.default)

    def _beyond_rounding(self, x: float) -> float:
        """Return the ratio, 0 where it is 0 or infinite but for rounding."""
        ideal = self.sweep.beyond_rounding(self.result, x)
        return ideal if ideal is not None and math.isfinite(ideal) else 0.0

    def factors(self, x: float) -> Sequence[float]:
        """Return the factors of the ratio: each is zero at a dead centre."""
        return () if self.is_dead_centre(x) else self._factors(x)

    @cached_property
    def _factors(self) -> Functions:
        return self.sweep.functions(self._ideal.factors, self.result.where)

    def divisors(self, x: float) -> Sequence[float]:
        """Return the divisors in terms of the ratio: each is 0 at a pole."""
        return () if self.sweep.trouble(x) else self._divisors(x)

    @cached_property
    def _divisors(self) -> Functions:
        return self.sweep.functions(self._ideal.divisors, self.result.where)


class ZeroAlong(IdealAlong):
    """A ratio that is zero everywhere, and so has no dead centre."""

    def is_dead_centre(self, _: float) -> bool:
        """Return False."""
        return False


class FrictionRatios:
    """A ratio with friction next to the one without, and what of it is looked at everywhere."""

    def __init__(self, ideal: IdealRatio, real: FrictionResult, sense: Sense) -> None:
        """Take both, and the sense of the motion."""
        self.ideal, self.real = ideal, real
        self.sign = SIGNS[sense]
        self._ways: dict[int, list[HowItEnds]] = {}

    def ideal_along(self, sweep: Sweep) -> IdealAlong:
        """Return the ratio without friction along the parameter of a sweep."""
        return (ZeroAlong if self.real.is_idle else IdealAlong)(sweep, self.ideal)

    def along(self, ideal: IdealAlong) -> "RatioAlong":
        """Return the ratio along the parameter along which the one without friction is given."""
        return (AgainstFriction if self.real.is_idle else RatioAlong)(ideal, self)

    @cached_property
    def own_form(self) -> Result:
        """Return the ratio with friction without the form for where it has no value."""
        return replace(self.real, elsewhere=None)

    @cached_property
    def is_iterated(self) -> bool:
        """Return whether friction is found by iteration."""
        return any(solutions(self.real))

    @cached_property
    def is_slow(self) -> bool:
        """Return whether friction or the pose is found by iteration."""
        return any(isinstance(f, Implicit) for d in self.real.where for f in walk(d.formula))

    @cached_property
    def signs(self) -> list[Formula]:
        """Return all signs in the ratio with friction."""
        parts = (part for d in self.real.where for part in walk(d.formula))
        return [*dict.fromkeys(filter(is_sign, parts))]

    def ways(self, result: Result) -> list[HowItEnds]:
        """Return the ways to the solutions of a result's systems."""
        if id(result) not in self._ways:
            unknowns = {id(unknown.system): unknown for unknown in solutions(result)}
            self._ways[id(result)] = [(symbols(u), status_along(u)) for u in unknowns.values()]
        return self._ways[id(result)]


class RatioAlong:
    """A ratio with friction next to the one without, along one parameter."""

    def __init__(self, along: IdealAlong, ratios: FrictionRatios) -> None:
        self.sweep, self.ideal, self.ideal_along = along.sweep, along.result, along
        self._ratios = ratios
        self.is_iterated, self.is_slow = ratios.is_iterated, ratios.is_slow
        self._known: dict[float, StateFound] = {}
        self._driven: dict[float, bool | None] = {}

    def at(self, x: float) -> StateFound:
        """Return the state at a value of the parameter."""
        if x not in self._known:
            self._known[x] = self._look(x)
        return self._known[x]

    def driven(self, x: float) -> bool | None:
        """Return whether the motion is the one that the load drives; None at a dead centre."""
        if x not in self._driven:
            is_dead = self.is_dead_centre(x)
            self._driven[x] = None if is_dead else self._ratios.sign * self.without(x) < 0
        return self._driven[x]

    def is_dead_centre(self, x: float) -> bool:
        """Return whether the ratio without friction is 0 or infinite there, or none."""
        return self.ideal_along.is_dead_centre(x)

    def without(self, x: float) -> float:
        """Return the ratio without friction."""
        return self.ideal_along.at(x)

    def signs(self, x: float) -> Sequence[float]:
        """Return the signs of slips and forces: where one changes, friction may jump."""
        return () if self.sweep.trouble(x) else self._signs(x)

    @cached_property
    def _signs(self) -> Functions:
        return self.sweep.functions(self._ratios.signs, self._ratios.real.where)

    def factors(self, x: float) -> Sequence[float]:
        """Return the factors of the ratio without friction: each is zero at a dead centre."""
        return self.ideal_along.factors(x)

    def divisors(self, x: float) -> Sequence[float]:
        """Return the divisors in terms of the ratio without friction: each is 0 at a pole."""
        return self.ideal_along.divisors(x)

    def _look(self, x: float) -> StateFound:
        driven = self.driven(x)
        if driven is None:
            return NOWHERE
        at = self._off_rest(x, driven)
        real = self._real(at)
        return StateFound(None, math.nan, driven) if real is None else self._state(real, at, driven)

    def _off_rest(self, x: float, driven: bool) -> float:
        """Return a value, or one next to it where a slip is 0, on this side of a dead centre.

        Friction has no sense there, and the ratio without it is the limit of neither side.
        """
        beside = self.sweep.off_rest(self._ratios.real.where, x)
        same = (y for y in beside if self.driven(y) == driven)
        return next(same, beside[0] if beside else x)

    def _state(self, real: float, x: float, driven: bool) -> StateFound:
        """Return the state in a pose by the ratio with friction there."""
        share = real / self.without(x)
        if share > 0:
            return StateFound("free", share, driven)
        return StateFound("locked" if driven else "jammed", share, driven)

    def _real(self, x: float) -> float | None:
        """Return the ratio with friction, NaN where nothing balances, None where none is found."""
        found = self._value(self._ratios.own_form, x)
        elsewhere = self._ratios.real.elsewhere if found is None else None
        return self._value(elsewhere, x) if elsewhere else found

    def _value(self, result: Result, x: float) -> float | None:
        """Return a result's value, NaN where its system says that there is none."""
        if not self._ratios.ways(result):
            found = self.sweep.value_of(result, x)
            return found if math.isfinite(found) else None
        found, values = self.sweep.whole(result, x)
        if math.isfinite(found):
            return found
        ways = {way(values) for needed, way in self._ratios.ways(result) if needed <= values.keys()}
        return math.nan if ways and 2 not in ways else None

    def efficiency(self, x: float) -> float:
        """Return the efficiency, 0 where nothing moves, NaN at a dead centre."""
        state = self.at(x).state
        if state is None:
            return math.nan
        return self.margin(x) if state == "free" else 0.0

    def margin(self, x: float) -> float:
        """Return the efficiency, below 0 where no power arrives, -inf where no force balances."""
        _, share, driven = self.at(x)
        if driven is None or math.isnan(share) or not (driven or share):
            return -math.inf
        return share if driven else 1 / share


HUGE = 1e9
"""A load in SI beyond which it is looked at whether rounding made it of an infinite one."""


class AgainstFriction(RatioAlong):
    """A drive that has friction alone to overcome, as in a brake: without it the ratio is zero.

    The drive drives either way, and there are no dead centres.
    """

    def driven(self, x: float) -> bool | None:
        """Return False, as no load drives the motion; None where there is no pose."""
        return None if self.sweep.trouble(x) else False

    def _state(self, real: float, x: float, driven: bool) -> StateFound:
        """Return the state in a pose: friction takes power in every motion.

        An effort below zero contradicts itself, and nothing is said of it.
        """
        effort = real * self._ratios.sign
        if math.isnan(effort) or (abs(effort) > HUGE and self._is_endless(x)):
            return StateFound("jammed", math.nan, driven)
        return StateFound(
            "free" if effort >= 0 else None, effort if effort >= 0 else math.nan, driven
        )

    def _is_endless(self, x: float) -> bool:
        """Return whether the ratio is infinite but for rounding: a brake begins to grip."""
        found = self.sweep.beyond_rounding(self._ratios.real, x)
        return found is not None and math.isinf(found)

    def efficiency(self, x: float) -> float:
        """Return 1 as long as something moves: no power is meant to arrive."""
        return 1.0 if self.at(x).state == "free" else super().efficiency(x)

    def margin(self, x: float) -> float:
        """Return the inverse of the effort, -inf where nothing moves."""
        state, effort, _ = self.at(x)
        if state != "free":
            return -math.inf
        return 1 / effort if effort else math.inf


def is_sign(formula: Formula) -> bool:
    """Return whether a formula is the sign of another, or its sense."""
    return is_call(formula, "sign", "sense")


def solutions(result: Result) -> Iterator[Implicit]:
    """Yield the pressing forces that a result finds by iteration, several of one system."""
    inside = result.inside if isinstance(result, FrictionResult) else frozenset[str]()
    formulas = (d.formula for d in result.where if d.name in inside)
    return (formula for formula in formulas if isinstance(formula, Implicit))


def factors(formula: Formula, where: Mapping[str, Formula]) -> Iterator[Formula]:
    """Yield what a formula is a product of, powers and the names of definitions taken apart.

    >>> from ..formula.tree import Call, quotient
    >>> k = quotient(Call("sin", (Symbol("t"),)), Symbol("i"))
    >>> list(factors(k, {"i": Symbol("r")}))
    [Call(function='sin', arguments=(Symbol(name='t'),)), Symbol(name='r')]
    """
    match formula:
        case Product(parts):
            for part in parts:
                yield from factors(part, where)
        case Power(base, _):
            yield from factors(base, where)
        case Symbol(name) if name in where:
            yield from factors(where[name], where)
        case _:
            yield formula


def divisors_of_terms(formula: Formula, where: Mapping[str, Formula]) -> Iterator[Formula]:
    """Yield what is divided by within the factors of a formula, names of definitions taken apart.

    A factor that is a sum has a pole where such a divisor is zero, and may be zero next to it.

    >>> from ..formula.tree import Call, quotient, total
    >>> k = quotient(total((Symbol("e"), quotient(Symbol("c"), Symbol("i")))), Symbol("r"))
    >>> list(divisors_of_terms(k, {"i": Call("sin", (Symbol("t"),))}))
    [Call(function='sin', arguments=(Symbol(name='t'),))]
    """
    seen = set[str]()
    for factor in factors(formula, where):
        yield from _divisors_in(factor, where, seen)


def _divisors_in(
    formula: Formula, where: Mapping[str, Formula], seen: set[str]
) -> Iterator[Formula]:
    """Yield the divisors in a formula; a name that many mention is gone into once."""
    for part in walk(formula):
        match part:
            case Power(base, Number(exponent)) if exponent < 0:
                yield from factors(base, where)
            case Symbol(name) if name in where and name not in seen:
                seen.add(name)
                yield from _divisors_in(where[name], where, seen)
            case _:
                pass
