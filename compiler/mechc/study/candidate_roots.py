"""What is asked of a factor of a ratio, and of its roots, before a zero or a pole is stated."""

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import cached_property

from ..algebra.angle import RADIAN
from ..algebra.factors import Factor, Trig
from ..algebra.from_formula import to_product
from ..algebra.intervals import IntervalBox
from ..algebra.orders import AngleRoot, angles, order, roots
from ..algebra.product import Product, Sum
from ..algebra.sums import BoundSum
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Formula, Power, is_call
from ..formula.tree import Product as Factors
from ..formula.tree import Sum as Terms
from ..formula.walk import reached, symbols, walk
from ..model.boxes import range_box, stroke_box
from ..model.values import Chain
from ..power.balance import AlgebraicResult, Balance
from .analysis import Cause
from .causes import cause
from .common_zeros import CommonZeros, flat_sides
from .tolerances import FROM_ROOT, VANISHED_SUM, VANISHES_TOO
from .trends import is_free_of_zeros
from .variables import moving_first, with_range

ARCS = ("asin", "acos")
"""Functions that intervals bound: angles by them may have sines that never vanish."""

_SIZE = ""
"""What a result is called among its definitions."""


class RatioSide:
    """A ratio, the side of its line on which factors vanish, and what is asked for each of them."""

    def __init__(
        self,
        item: AlgebraicResult,
        balance: Balance,
        near: Mapping[str, float],
        side: int,
        common_zeros: CommonZeros,
    ) -> None:
        assert item.value is not None
        self.common_zeros = common_zeros
        self.item, self.value, self.balance = item, item.value, balance
        self.near, self.side = near, side
        self.defined = dict(item.result.where)
        self.given = {name: value for name, value in near.items() if name not in self.defined}
        self.chain = Chain({**self.defined, _SIZE: item.result.formula})
        mechanism = balance.plan.graph.pose.mechanism
        self.box, self.ranged = stroke_box(mechanism), with_range(mechanism)
        self.moving_first = moving_first(mechanism)

    @cached_property
    def _as_given(self) -> IntervalBox:
        """Return the box of the ranges, of what has none at its value."""
        mechanism = self.balance.plan.graph.pose.mechanism
        ranged = {name: reach for name, reach in self.box.items() if name in self.ranged}
        still = {n: x for n, x in range_box(mechanism).items() if n != mechanism.drive_name}
        return {**still, **ranged}

    @cached_property
    def flat(self) -> list[Set[str]]:
        """Return the names in the angles of each four-bar that may lie flat."""
        return list(flat_sides(self.balance.plan.graph.pose, self.near))

    def cause(self, factor: Factor, roots: tuple[AngleRoot, ...] = ()) -> Cause:
        """Return the point or link that stands still at a zero of a factor, or at some roots."""
        return cause(factor, roots, self.item, self.balance, self.side)

    def is_outside(self, factor: Factor) -> bool:
        """Return whether a factor is proved not to vanish within the ranges that are given."""
        ranged = symbols(factor.formula()) & self.ranged
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


def has_order(root: AngleRoot, of: RatioSide) -> bool:
    """Return whether a value is proved zero (infinite) at a root, at the values given, too."""
    found = order(of.value, root.name, root.value)
    there = found is not None and found * of.side > 0
    return there and not is_refuted(root, of)


def is_refuted(root: AngleRoot, of: RatioSide) -> bool:
    """Return whether a value does something else where lengths are just as they are given.

    With a = b, sin α/(a − b cos α) is infinite where it would vanish. And what is found by
    closing loops may itself be infinite there, such as a pin's distance along a slot that is
    parallel to its guide.
    """
    names = {root.name, *root.value.names}
    if not names <= of.near.keys() or not names.isdisjoint(of.defined):
        return False
    far, near = FROM_ROOT
    sizes = _sizes_nearby(root, far, of)
    if not sizes:
        return _meets_another(root, of)
    return _is_otherwise(sizes, of.side) and _is_otherwise(_sizes_nearby(root, near, of), of.side)


def _is_otherwise(sizes: Sequence[float], side: int) -> bool:
    """Return whether sizes at a distance and at half of it are not those of a zero, or a pole."""
    return bool(sizes) and math.log2(sizes[0] / sizes[1]) * side < 0.5


def _meets_another(root: AngleRoot, of: RatioSide) -> bool:
    """Return whether a sine across the line, of what loops find, is zero at a root as well.

    Where there is no pose nothing else can refute a root.
    """
    there = of.chain.complete({**of.given, root.name: root.value.evaluate(of.near)})
    across = (f for f, e in of.value.factors.items() if isinstance(f, Trig) and e * of.side < 0)
    found = (f for f in across if not f.angle.names.isdisjoint(of.defined))
    known = (f for f in found if f.angle.names <= there.keys())
    return any(abs(evaluate(f.formula(), there)) < VANISHES_TOO for f in known)


def _sizes_nearby(root: AngleRoot, step: float, of: RatioSide) -> list[float]:
    """Return the sizes of a value a step from a root, and half of one; none where it has none."""
    x = root.value.evaluate(of.near)
    here = ({**of.given, root.name: x + h} for h in (step, step / 2))
    sizes = [abs(of.chain.complete(values).get(_SIZE, math.nan)) for values in here]
    return sizes if all(math.isfinite(size) and size for size in sizes) else []


def roots_across(factor: Factor, value: Product) -> list[AngleRoot]:
    """Return the roots of the sines across the line that have a symbol in common with a sum."""
    return [root for trig in across_the_line(factor, value) for root in roots(trig, value)]


def across_the_line(factor: Factor, value: Product) -> list[Trig]:
    """Return the sines across the line that have a symbol in common with a sum."""
    above = value.factors[factor] > 0
    inside = {name for angle in angles(Product.of(factor)) for name in angle.names}
    return [
        trig
        for trig, e in value.factors.items()
        if isinstance(trig, Trig) and (e > 0) != above and trig.angle.names & inside
    ]


def is_zero(factor: Factor, root: AngleRoot, near: Mapping[str, float]) -> bool:
    """Return whether a factor is zero at a root for the values given, against its usual size."""
    if not {root.name, *root.value.names} <= near.keys():
        return False
    return is_zero_at(factor, root.name, {**near, root.name: root.value.evaluate(near)})


def is_zero_at(factor: Factor, name: str, there: Mapping[str, float]) -> bool:
    """Return whether a factor is zero at some values, against its size at another one of a name."""
    if not isinstance(factor, Sum | Trig) or not symbols(factor.formula()) <= there.keys():
        return False
    here, beside = (abs(factor.evaluate({**there, name: there[name] + h})) for h in (0, 1))
    return here < VANISHED_SUM * beside


# ---------------------------------------------------------------------------- factors


def dividing_factors(formula: Formula) -> Iterator[Factor]:
    """Yield the factors that a formula as a whole is divided by."""
    for part in formula.factors if isinstance(formula, Factors) else (formula,):
        if isinstance(part, Power | Call):
            yield from (f for f, exponent in to_product(part).factors.items() if exponent < 0)


def may_vanish(factor: Factor, near: Mapping[str, float]) -> bool:
    """Return whether this is a sum, or a sine or cosine of what varies: no length, no constant.

    A sum of lengths that are all positive, ``a + b``, does not vanish.
    """
    match factor:
        case Trig(angle=angle):
            return any(name != RADIAN for name, _ in angle.terms)
        case Sum():
            return not _all_positive(factor.formula(), near)
        case _:
            return isinstance(factor, BoundSum)


def _all_positive(formula: Formula, near: Mapping[str, float]) -> bool:
    """Return whether a sum has no functions and no term that is negative by default."""
    if not isinstance(formula, Terms) or any(isinstance(f, Call) for f in walk(formula)):
        return False
    known = symbols(formula) <= near.keys()
    return known and all(evaluate(t, near) > 0 for t in formula.terms)
