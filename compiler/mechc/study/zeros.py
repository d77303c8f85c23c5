"""Zeros and poles: which factors vanish, at which angle, and what stands still there."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from functools import cached_property
from itertools import product

from ..algebra.factors import Factor, Trig
from ..algebra.from_formula import to_product
from ..algebra.halving import without
from ..algebra.intervals import Box, vanishing_values
from ..algebra.orders import Root, angles, half_turns, order, roots
from ..algebra.product import Product, Sum
from ..algebra.trigonometry import sine
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Formula, is_call
from ..formula.walk import reached, symbols, walk
from ..model.boxes import range_box, stroke_box
from ..model.values import Chain
from ..pose.pose import Arm, Limit, evaluate_vector
from ..pose.tolerances import SAME_PLACE
from ..pose.vector_graph import mentioned
from ..power.balance import Balance, Solved
from ..power.definitions import resting_on
from .analysis import Cause, Vanishing
from .breaks import dividing_factors, may_vanish
from .causes import across_of, cause
from .meeting import TOGETHER, Meetings
from .ranges import moving_first, with_range
from .tolerances import SAME_RATIO, VANISHED_SUM
from .trends import is_free_of_zeros

STEPS = (1e-4, 1e-6)
"""How far from a root the values are compared that refute it, in radians.

Far from it rounding does no harm; near it no other root that is close by does.
"""


ANYWHERE = 1.0
"""An angle at which neither sine nor cosine is special, in radians."""


def limits(
    item: Solved, balance: Balance, near: Mapping[str, float]
) -> tuple[tuple[Vanishing, ...], tuple[Vanishing, ...]]:
    """Return the conditions under which a ratio is zero, and those under which it is infinite.

    Where it is zero the load above the line needs no force: the point of the load below stands
    still (a dead centre), or moves across it. Where it is infinite the point of the load above
    does, the other dead centre.
    """
    assert item.value is not None
    met = Meetings(item.value, dict(item.result.where), near, balance.plan.graph.pose.mechanism)
    found = (_conditions(_Sought(item, balance, near, side, met)) for side in (1, -1))
    zeros, poles = map(_each_place_once, found)
    return zeros, poles


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
    if (condition.cause, condition.but) != (other.cause, other.but):
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


class _Sought:
    """A ratio, the side of its line on which factors vanish, and what is asked for each of them."""

    def __init__(
        self,
        item: Solved,
        balance: Balance,
        near: Mapping[str, float],
        side: int,
        meetings: Meetings,
    ) -> None:
        assert item.value is not None
        self.meetings = meetings
        self.item, self.value, self.balance = item, item.value, balance
        self.near, self.side = near, side
        self.defined = dict(item.result.where)
        self.given = {name: value for name, value in near.items() if name not in self.defined}
        self.chain = Chain({**self.defined, _SIZE: item.result.formula})
        mechanism = balance.plan.graph.pose.mechanism
        self.box, self._ranged = stroke_box(mechanism), with_range(mechanism)
        self.moving_first = moving_first(mechanism)

    @cached_property
    def _as_given(self) -> Box:
        """Return the box of the ranges, of what has none at its value."""
        mechanism = self.balance.plan.graph.pose.mechanism
        ranged = {name: reach for name, reach in self.box.items() if name in self._ranged}
        still = {n: x for n, x in range_box(mechanism).items() if n != mechanism.drive_name}
        return {**still, **ranged}

    @cached_property
    def flat(self) -> list[Set[str]]:
        """Return the names in the angles of each four-bar that may lie flat."""
        pose, found = self.balance.plan.graph.pose, list[Set[str]]()
        for limit in pose.limits:
            if may_lie_flat(limit, self.near):
                points = set(limit.loop.split("-"))
                given = {name for arm in limit.side for name in arm.angle.names}
                solved = (s.names for s in pose.solved if points.issuperset(s.points))
                found.append(given.union(*solved))
        return found

    def cause(self, factor: Factor, roots: tuple[Root, ...] = ()) -> Cause:
        """Return the point or link that stands still at a zero of a factor, or at some roots."""
        return cause(factor, roots, self.item, self.balance, self.side)

    def is_outside(self, factor: Factor) -> bool:
        """Return whether a factor is proved not to vanish within the ranges that are given."""
        ranged = symbols(factor.formula()) & self._ranged
        return bool(ranged) and is_free_of_zeros(Product.of(factor), self.box)

    def is_absent(self, factor: Factor) -> bool:
        """Return whether a sine or cosine of what loops find is proved not to vanish.

        That is within the ranges, at the values given of what has none, and rests on arc sines
        and cosines, of which intervals are known.
        """
        if not isinstance(factor, Trig) or factor.angle.names.isdisjoint(self.defined):
            return False
        needed = reached(factor.angle.names, self.defined)
        found = [(n, f) for n, f in self.defined.items() if n in needed]
        if not all(any(is_call(part, *ARCS) for part in walk(f)) for _, f in found):
            return False
        where = [(n, to_product(f)) for n, f in found]
        return is_free_of_zeros(Product.of(factor), self._as_given, where)


def _conditions(of: _Sought) -> Iterator[Vanishing]:
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


def _of_sum(factor: Factor, of: _Sought) -> Iterator[Vanishing]:
    """Yield the rest of a sum; where that is not known, all of it but for what it shares.

    At what it shares it may have the higher order: cos(3t/2)/(1 - 2 cos t)² is infinite at 60°.
    """
    why = of.cause(factor)
    across = _roots_across(factor, of.value)
    shared = [r for r in across if order(Product.of(factor), r.name, r.value) != 0]
    left = _without_shared(factor, across, shared, of.near)
    but = () if left else tuple(t.formula() for t in _across_the_line(factor, of.value))
    for part in left or (factor,):
        if isinstance(part, Trig):
            yield from _at_roots(part, of)
        elif may_vanish(part, of.near):
            yield Vanishing(part.formula(), None, why, of.is_outside(part), but)
    for root in shared:
        in_rest = any(order(Product.of(part), root.name, root.value) != 0 for part in left)
        if not in_rest and _has_order(root, of):
            yield _vanishing(root.factor, of.cause(root.factor, (root,)), of)


def _at_roots(trig: Trig, of: _Sought) -> Iterator[Vanishing]:
    """Yield a sine or cosine where every root has one order and one cause; else single roots.

    cos 3a/cos² a vanishes at 30° and at 150°, not at 90°; where cos(45° + a)·cos(45° - a) is
    zero, that is cos 2a/2, a point may stand still at -45° only.
    """
    found = _roots(trig, of)
    proved = [r for r in found if _has_order(r, of)]
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


def _roots(trig: Trig, of: _Sought) -> list[Root]:
    """Return the roots of a sine or cosine that the value tells apart, or what stands still."""
    across = across_of(of.item, of.balance, of.side)
    found = (roots(trig, of.value, across) if across else []) or roots(trig, of.value)
    return [part for root in found for part in _separated(root, of)]


def _separated(root: Root, of: _Sought) -> tuple[Root, ...]:
    """Return a root as one, or as its two within a turn where the value vanishes at one only.

    Angles that loops find need not be the same, nor opposite, half a turn on: with a chord AQ of
    the crank's circle, cos φ/sin(φ - φ_AQ) vanishes at 90° and is finite at -90°.
    """
    if not of.defined:
        return (root,)
    parts = half_turns(root)
    return parts if len({_is_refuted(part, of) for part in parts}) > 1 else (root,)


def _but_by_chance(root: Root, of: _Sought) -> Iterator[Vanishing]:
    """Yield a root at which something across the line is zero, too, for the values given only.

    With β = 0 it is sin(α + β) where sin(α - β) is, and k = sin(α + β)/sin(α - β) is 1.
    """
    known = order(of.value, root.name, root.value)
    across = [f for f, e in of.value.factors.items() if e * of.side < 0]
    nil = tuple(f.formula() for f in across if _is_nil(f, root, of.near))
    if nil and known is not None and known * of.side > 0:
        why = of.cause(root.factor, (root,))
        yield Vanishing(root.factor.formula(), None, why, of.is_outside(root.factor), nil)


def _vanishing(trig: Trig, why: Cause, of: _Sought) -> Vanishing:
    """Return a condition solved for what moves; not for, nor by, what loops find."""
    found = trig.angle.names & of.defined.keys()
    at = None if found else vanishing_values(trig, of.near, of.box, of.moving_first)
    but = tuple(t.formula() for t in _at_folds(trig, of))
    outside, absent = of.is_outside(trig), of.is_absent(trig)
    limit = Vanishing(trig.formula(), None, why, outside, but, absent=absent)
    if at is None:
        return limit
    period = at.period if at.is_many else None
    return limit._replace(at=(at.name, at.nearest), within=at.within, period=period)


def _at_folds(trig: Trig, of: _Sought) -> list[Trig]:
    """Return the sines across the line that may vanish with one where equal sides fold.

    Of β = arcsin(sin T) the cosine is zero at T = 90°, and there sin(T + β) is zero as well. So
    are the sines of all angles of a four-bar where it lies flat, if it may.
    """
    found = trig.angle.names & of.defined.keys()
    if any(_is_fold(of.defined[name], of.near) for name in found):
        return _across_the_line(trig, of.value)
    flat = [names for names in of.flat if found and _is_between_sides(trig, names)]
    exponent = of.value.factors.get(trig, of.side)
    together = of.meetings.across(trig, of.side) if found else frozenset()
    across = [f for f, e in of.value.factors.items() if isinstance(f, Trig) and e * exponent < 0]
    return [
        other
        for other in across
        if other in together or any(_is_between_sides(other, names) for names in flat)
    ]


def _is_between_sides(trig: Trig, names: Set[str]) -> bool:
    """Return whether a sine is that of an angle between the sides that some names belong to."""
    return trig.function == "sin" and trig.angle.names <= names and not trig.angle.degrees % 180


def may_lie_flat(limit: Limit, near: Mapping[str, float]) -> bool:
    """Return whether the four sides of a loop may all lie on one line, for the values given.

    They do where the longest and the shortest are together as long as the others (Grashof).
    """
    turning: dict[object, list[Arm]] = {}
    for arm in limit.side:
        turning.setdefault(arm.angle.terms, []).append(arm)
    names = mentioned(limit.side).union(*(symbols(size.formula()) for size in limit.sizes))
    if limit.group != "triangle" or len(turning) != 2 or not names <= near.keys():
        return False
    sides = [math.hypot(*evaluate_vector(tuple(arms), near)) for arms in turning.values()]
    sides += [abs(size.evaluate(near)) for size in limit.sizes]
    first, *others = sides
    senses = product((1, -1), repeat=len(others))
    gaps = (first + sum(s * size for s, size in zip(each, others, strict=True)) for each in senses)
    return any(abs(gap) <= SAME_PLACE * sum(sides) for gap in gaps)


def _is_fold(formula: Formula, near: Mapping[str, float]) -> bool:
    """Return whether an angle is the arcsine of a sine, or of a cosine, for the values given."""
    if not isinstance(formula, Call) or formula.function not in ("asin", "acos"):
        return False
    (argument,) = formula.arguments
    for turn in walk(argument):
        if is_call(turn, "sin", "cos"):
            values = {**near, **dict.fromkeys(symbols(turn), ANYWHERE)}
            if symbols(argument) <= values.keys():
                sizes = (abs(evaluate(f, values)) for f in (argument, turn))
                return math.isclose(*sizes, rel_tol=SAME_RATIO)
    return False


def _has_order(root: Root, of: _Sought) -> bool:
    """Return whether a value is proved zero (infinite) at a root, at the values given, too."""
    found = order(of.value, root.name, root.value)
    there = found is not None and found * of.side > 0
    return there and not _is_refuted(root, of)


def _is_refuted(root: Root, of: _Sought) -> bool:
    """Return whether a value does something else where lengths are just as they are given.

    With a = b, sin α/(a − b cos α) is infinite where it would vanish. And what is found by
    closing loops may itself be infinite there, such as a pin's distance along a slot that is
    parallel to its guide.
    """
    names = {root.name, *root.value.names}
    if not names <= of.near.keys() or not names.isdisjoint(of.defined):
        return False
    far, near = STEPS
    sizes = _beside(root, far, of)
    if not sizes:
        return _meets_another(root, of)
    return _is_otherwise(sizes, of.side) and _is_otherwise(_beside(root, near, of), of.side)


def _is_otherwise(sizes: Sequence[float], side: int) -> bool:
    """Return whether sizes at a distance and at half of it are not those of a zero, or a pole."""
    return bool(sizes) and math.log2(sizes[0] / sizes[1]) * side < 0.5


def _meets_another(root: Root, of: _Sought) -> bool:
    """Return whether a sine across the line, of what loops find, is zero at a root as well.

    Where there is no pose nothing else can refute a root.
    """
    there = of.chain.complete({**of.given, root.name: root.value.evaluate(of.near)})
    across = (f for f, e in of.value.factors.items() if isinstance(f, Trig) and e * of.side < 0)
    found = (f for f in across if not f.angle.names.isdisjoint(of.defined))
    known = (f for f in found if f.angle.names <= there.keys())
    return any(abs(evaluate(f.formula(), there)) < TOGETHER for f in known)


def _beside(root: Root, step: float, of: _Sought) -> list[float]:
    """Return the sizes of a value a step from a root, and half of one; none where it has none."""
    x = root.value.evaluate(of.near)
    here = ({**of.given, root.name: x + h} for h in (step, step / 2))
    sizes = [abs(of.chain.complete(values).get(_SIZE, math.nan)) for values in here]
    return sizes if all(math.isfinite(size) and size for size in sizes) else []


ARCS = ("asin", "acos")
"""Functions that intervals bound: angles by them may have sines that never vanish."""

_SIZE = ""
"""What a result is called among its definitions."""


def _without_shared(
    factor: Factor, across: Sequence[Root], shared: Sequence[Root], near: Mapping[str, float]
) -> Iterable[Factor]:
    """Return the rest of a sum without the sines that it shares with one across the line.

    It may have sines of its own, that nothing is known of yet: cos 3t + sin 2t has cos t. Nothing
    is left where one cannot be split off, or is shared for the lengths given only: then it is not
    known what is.
    """
    rest = without(factor, [r.factor for r in shared]) if isinstance(factor, Sum) else None
    left = [f for f, e in rest.factors.items() if e > 0] if shared and rest else [factor]
    sums = [f for f in left if isinstance(f, Sum)] if shared else left
    known = all(order(Product.of(f), r.name, r.value) == 0 for f in sums for r in shared)
    by_chance = any(_is_nil(f, r, near) for f in left if isinstance(f, Sum) for r in across)
    return left if known and not by_chance else []


def _roots_across(factor: Factor, value: Product) -> list[Root]:
    """Return the roots of the sines across the line that have a symbol in common with a sum."""
    return [root for trig in _across_the_line(factor, value) for root in roots(trig, value)]


def _across_the_line(factor: Factor, value: Product) -> list[Trig]:
    """Return the sines across the line that have a symbol in common with a sum."""
    above = value.factors[factor] > 0
    inside = {name for angle in angles(Product.of(factor)) for name in angle.names}
    return [
        trig
        for trig, e in value.factors.items()
        if isinstance(trig, Trig) and (e > 0) != above and trig.angle.names & inside
    ]


def _is_nil(factor: Factor, root: Root, near: Mapping[str, float]) -> bool:
    """Return whether a factor is zero at a root for the values given, against its usual size."""
    if not isinstance(factor, Sum | Trig) or not {root.name, *root.value.names} <= near.keys():
        return False
    if not symbols(factor.formula()) <= near.keys():
        return False
    x = root.value.evaluate(near)
    here, there = (abs(factor.evaluate({**near, root.name: x + h})) for h in (0, 1))
    return here < VANISHED_SUM * there
