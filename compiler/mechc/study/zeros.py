"""Zeros, poles and breaks: which factors vanish, at which angle, and what stands still there."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..algebra.factors import Factor, Trig
from ..algebra.from_formula import to_product
from ..algebra.intervals import NumberInterval, Roots, vanishing_values
from ..algebra.orders import AngleRoot, half_turns, order, roots
from ..algebra.product import Product, Sum
from ..algebra.sine_divisors import without
from ..algebra.trigonometry import sine
from ..formula.evaluate import evaluate
from ..formula.walk import symbols
from ..model.result import Definition
from ..power.balance import AlgebraicResult, Balance
from ..power.definitions import resting_on
from .analysis import Break, Cause, Vanishing
from .candidate_roots import (
    RatioSide,
    across_the_line,
    dividing_factors,
    has_order,
    is_refuted,
    is_zero,
    is_zero_at,
    may_vanish,
    roots_across,
)
from .causes import across_of
from .common_zeros import CommonZeros, is_between_sides, is_fold

MOST_STEPS = 48
"""So many places at which a sine vanishes within a range are looked at."""


def limits(
    item: AlgebraicResult, balance: Balance, near: Mapping[str, float]
) -> tuple[tuple[Vanishing, ...], tuple[Vanishing, ...]]:
    """Return the conditions under which a ratio is zero, and those under which it is infinite.

    Where it is zero the load above the line needs no force: the point of the load below stands
    still (a dead centre), or moves across it. Where it is infinite the point of the load above
    does, the other dead centre.
    """
    assert item.value is not None
    met = CommonZeros(item.value, dict(item.result.where), near, balance.plan.graph.pose.mechanism)
    found = (_conditions(RatioSide(item, balance, near, side, met)) for side in (1, -1))
    zeros, poles = map(_each_place_once, found)
    return zeros, poles


def breaks(where: Iterable[Definition], near: Mapping[str, float]) -> tuple[Break, ...]:
    """Return the conditions under which what loops find is infinite, each of them once.

    A result that rests on it may jump there.
    """
    found: dict[Factor, Break] = {}
    for name, formula in where:
        for factor in filter(lambda f: may_vanish(f, near), dividing_factors(formula)):
            found.setdefault(factor, Break(name, factor.formula()))
    return tuple(found.values())


def _each_place_once(found: Iterable[Vanishing]) -> tuple[Vanishing, ...]:
    """Return conditions without those that hold only where another one does.

    Of sin 2t and sin t the second is left out, where what stands still is the same.
    """
    kept = list[Vanishing]()
    for condition in found:
        if not any(_holds_with(condition, other) for other in kept):
            kept = [other for other in kept if not _holds_with(other, condition)]
            kept.append(condition)
    return tuple(kept)


def _holds_with(condition: Vanishing, other: Vanishing) -> bool:
    """Return whether a sine vanishes only where another one does, of the same cause."""
    if (condition.cause, condition.except_where) != (other.cause, other.except_where):
        return False
    one, another = (to_product(each.factor) for each in (condition, other))
    trigs = [f for product in (one, another) for f in product.factors if isinstance(f, Trig)]
    if len(trigs) != 2 or any(len(product.factors) != 1 for product in (one, another)):
        return False
    first, second = trigs
    if not first.angle.names <= second.angle.names:
        return False
    found = roots(first, another)
    return bool(found) and all((order(another, r.name, r.value) or 0) > 0 for r in found)


def _conditions(of: RatioSide) -> Iterator[Vanishing]:
    """Yield the conditions, each proved by the order that the whole value has there.

    None is known where something that loops find is infinite.
    """
    where = resting_on(of.balance.plan, of.value.formula(), [of.value])
    found = (*where, *of.balance.plan.graph.pose.put_in)
    far = {factor for _, formula in found for factor in dividing_factors(formula)}
    for factor, exponent in of.value.factors.items():
        if exponent * of.side > 0 and factor not in far and may_vanish(factor, of.near):
            match factor:
                case Trig():
                    yield from _at_roots(factor, of)
                case _:
                    yield from _of_sum(factor, of)


def _of_sum(factor: Factor, of: RatioSide) -> Iterator[Vanishing]:
    """Yield the rest of a sum; where that is not known, all of it but for what it shares.

    At what it shares it may have the higher order: cos(3t/2)/(1 - 2 cos t)² is infinite at 60°.
    """
    why = of.cause(factor)
    across = roots_across(factor, of.value)
    shared = [r for r in across if order(Product.of(factor), r.name, r.value) != 0]
    left = _without_shared(factor, across, shared, of.near)
    but = () if left else tuple(t.formula() for t in across_the_line(factor, of.value))
    for part in left or (factor,):
        if isinstance(part, Trig):
            yield from _at_roots(part, of)
        elif may_vanish(part, of.near):
            yield Vanishing(part.formula(), None, why, of.is_outside(part), but)
    for root in shared:
        in_rest = any(order(Product.of(part), root.name, root.value) != 0 for part in left)
        if not in_rest and has_order(root, of):
            yield _vanishing(root.factor, of.cause(root.factor, (root,)), of)


def _without_shared(
    factor: Factor,
    across: Sequence[AngleRoot],
    shared: Sequence[AngleRoot],
    near: Mapping[str, float],
) -> Iterable[Factor]:
    """Return the rest of a sum without the sines that it shares with one across the line.

    It may have sines of its own, that nothing is known of yet: cos 3t + sin 2t has cos t. Nothing
    is left where one cannot be split off, or is shared for the lengths given only: then it is not
    known what is.
    """
    left = [factor]
    if shared and isinstance(factor, Sum):
        rest = without(factor, [root.factor for root in shared])
        left = [f for f, exponent in rest.factors.items() if exponent > 0] if rest else left
    sums = [f for f in left if isinstance(f, Sum)]
    are_split_off = all(
        order(Product.of(f), root.name, root.value) == 0
        for f in (sums if shared else left)
        for root in shared
    )
    by_chance = any(is_zero(f, root, near) for f in sums for root in across)
    return left if are_split_off and not by_chance else []


def _at_roots(trig: Trig, of: RatioSide) -> Iterator[Vanishing]:
    """Yield a sine or cosine where every root has one order and one cause; else single roots.

    cos 3a/cos² a vanishes at 30° and at 150°, not at 90°; where cos(45° + a)·cos(45° - a) is
    zero, that is cos 2a/2, a point may stand still at -45° only.
    """
    found = _roots(trig, of)
    proved = [r for r in found if has_order(r, of)]
    causes = [of.cause(r.factor, (r,)) for r in proved]
    if len(proved) == len(found) and len({*causes}) == 1:
        yield _vanishing(trig, causes[0], of)
    else:
        single = zip((r.factor for r in proved), causes, strict=True)
        for factor, why in _joined([*single]):
            yield _vanishing(factor, why, of)
    for root in found:
        if root not in proved:
            yield from _but_by_chance(root, of)


def _joined(found: Sequence[tuple[Trig, Cause]]) -> list[tuple[Trig, Cause]]:
    """Return sines with their causes, two that vanish a quarter turn apart by one cause as one.

    sin(t/2) and cos(t/2) are sin t.
    """
    alike: dict[tuple[Trig, Cause], list[Trig]] = {}
    for trig, why in found:
        (double,) = sine(trig.angle * 2).factors
        assert isinstance(double, Trig)
        alike.setdefault((double, why), []).append(trig)
    joined = [(trigs[0] if len(trigs) == 1 else two, why) for (two, why), trigs in alike.items()]
    return joined if len(joined) == len(found) else _joined(joined)


def _roots(trig: Trig, of: RatioSide) -> list[AngleRoot]:
    """Return the roots of a sine or cosine that the value tells apart, or what stands still."""
    across = across_of(of.item, of.balance, of.side)
    found = (roots(trig, of.value, across) if across else []) or roots(trig, of.value)
    return [part for root in found for part in _separated(root, of)]


def _separated(root: AngleRoot, of: RatioSide) -> tuple[AngleRoot, ...]:
    """Return a root as one, or as its two within a turn where the value vanishes at one only.

    Angles that loops find need not be the same, nor opposite, half a turn on: with a chord AQ of
    the crank's circle, cos φ/sin(φ - φ_AQ) vanishes at 90° and is finite at -90°.
    """
    if not of.defined:
        return (root,)
    parts = half_turns(root)
    return parts if len({is_refuted(part, of) for part in parts}) > 1 else (root,)


def _but_by_chance(root: AngleRoot, of: RatioSide) -> Iterator[Vanishing]:
    """Yield a root at which something across the line is zero, too, for the values given only.

    With β = 0 it is sin(α + β) where sin(α - β) is, and k = sin(α + β)/sin(α - β) is 1.
    """
    known = order(of.value, root.name, root.value)
    across = [f for f, e in of.value.factors.items() if e * of.side < 0]
    zero = tuple(f.formula() for f in across if is_zero(f, root, of.near))
    if zero and known is not None and known * of.side > 0:
        why = of.cause(root.factor, (root,))
        yield Vanishing(root.factor.formula(), None, why, of.is_outside(root.factor), zero)


def _vanishing(trig: Trig, why: Cause, of: RatioSide) -> Vanishing:
    """Return a condition solved for what moves; not for, nor by, what loops find."""
    found = trig.angle.names & of.defined.keys()
    at = None if found else vanishing_values(trig, of.near, of.box, of.moving_first)
    zero = [*_at_folds(trig, of), *(() if found else _zero_across(trig, at, of))]
    but = tuple(dict.fromkeys(f.formula() for f in zero))
    outside, absent = of.is_outside(trig), of.is_absent(trig)
    limit = Vanishing(trig.formula(), None, why, outside, but, absent=absent)
    if at is None:
        return limit
    period = at.period if at.is_many else None
    return limit._replace(at=(at.name, at.nearest), within=at.within, period=period)


def _zero_across(trig: Trig, at: Roots | None, of: RatioSide) -> Iterator[Factor]:
    """Yield what is zero across the line at a place where a sine vanishes, at the values given.

    Along another symbol, of which the factor was proved to vanish, it need not be: with a = 60°,
    sin(a + b - 30°)/cos(a - b) vanishes along a where b is 120°, and is finite at b = 150°.
    """
    across = [f for f, e in of.value.factors.items() if e * of.side < 0]
    for name, place in (*(_stated(at, of) if at else ()), *_within_ranges(trig, of)):
        there = {**of.near, name: place}
        yield from (f for f in across if is_zero_at(f, name, there))


def _stated(at: Roots, of: RatioSide) -> Iterator[tuple[str, float]]:
    """Yield the places that are stated, as far as values are given for them."""
    for place in at.within or (at.nearest,):
        if symbols(place) <= of.near.keys():
            yield at.name, evaluate(place, of.near)


def _within_ranges(trig: Trig, of: RatioSide) -> Iterator[tuple[str, float]]:
    """Yield where a sine vanishes along any symbol with a range, whichever it is stated by.

    That of cos(2a + b) is stated as b = 90° - 2a. Along a, with b = 270°, what is zero at a = 90°
    may be sin(a - b/3).
    """
    if not trig.angle.names <= of.near.keys():
        return
    offset = 0.0 if trig.function == "sin" else math.pi / 2
    for name, times in trig.angle.terms:
        if reach := of.box.get(name) if name in of.ranged else None:
            nearest = of.near[name] - (trig.angle.evaluate(of.near) - offset) / float(times)
            step = math.pi / abs(float(times))
            yield from ((name, place) for place in _steps_within(nearest, step, reach))


def _steps_within(first: float, step: float, reach: NumberInterval) -> Iterator[float]:
    """Yield what lies whole steps from a first value, within an interval."""
    low, high = ((end - first) / step for end in (reach.low, reach.high))
    for steps in range(math.ceil(low), math.floor(high) + 1)[:MOST_STEPS]:
        yield first + steps * step


def _at_folds(trig: Trig, of: RatioSide) -> list[Trig]:
    """Return the sines across the line that may vanish with one where equal sides fold.

    Of β = arcsin(sin T) the cosine is zero at T = 90°, and there sin(T + β) is zero as well. So
    are the sines of all angles of a four-bar where it lies flat, if it may.
    """
    found = trig.angle.names & of.defined.keys()
    if any(is_fold(of.defined[name], of.near) for name in found):
        return across_the_line(trig, of.value)
    flat = [names for names in of.flat if found and is_between_sides(trig, names)]
    exponent = of.value.factors.get(trig, of.side)
    together = of.common_zeros.across(trig, of.side) if found else frozenset()
    across = [f for f, e in of.value.factors.items() if isinstance(f, Trig) and e * exponent < 0]
    return [
        other
        for other in across
        if other in together or any(is_between_sides(other, names) for names in flat)
    ]
