"""Zeros and poles: which factors vanish, at which angle, and what stands still there."""

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Literal

from ..algebra.angle import RADIAN, Angle
from ..algebra.factors import Factor, Trig
from ..algebra.product import Bound, Product, Sum
from ..algebra.sums import canonical
from ..formula.tree import Call, Formula
from ..formula.tree import Sum as Terms
from ..formula.walk import evaluate, symbols, walk
from ..kinematics.forms import QUARTER
from ..kinematics.plan import Plan
from ..model.mechanism import Force
from ..model.result import Vanishing
from .balance import Balance, Solved, Term

Kind = Literal["output still", "drive locked", "perpendicular load", "other"]


def zeros(item: Solved, balance: Balance, near: Mapping[str, float]) -> tuple[Vanishing, ...]:
    """Return the conditions under which a ratio is zero.

    The load above the line needs no force there: the point of the load below stands
    still (a dead centre), or moves across it.
    """
    return tuple(_conditions(item, balance, near, 1))


def poles(item: Solved, balance: Balance, near: Mapping[str, float]) -> tuple[Vanishing, ...]:
    """Return the conditions under which a ratio is infinite.

    The point of the load above stands still while the other moves (the drive is locked),
    or moves across its load.
    """
    return tuple(_conditions(item, balance, near, -1))


def _conditions(
    item: Solved, balance: Balance, near: Mapping[str, float], side: int
) -> Iterator[Vanishing]:
    assert item.value is not None
    for factor, exponent in item.value.factors.items():
        if exponent * side > 0 and _may_vanish(factor, near):
            kind = _kind(factor, item, balance, side)
            yield Vanishing(factor.formula(), solution(factor, near), kind)


def _may_vanish(factor: Factor, near: Mapping[str, float]) -> bool:
    """Tell a sum, or a sine or cosine of something that varies, from lengths and constants.

    A sum of lengths that are all positive, ``a + b``, does not vanish.
    """
    match factor:
        case Trig(angle=angle):
            return any(name != RADIAN for name, _ in angle.terms)
        case Sum():
            return not _all_positive(factor.formula(), near)
        case _:
            return isinstance(factor, Bound)


def _all_positive(formula: Formula, near: Mapping[str, float]) -> bool:
    """Tell whether a sum has no functions and no term that is negative by default."""
    if not isinstance(formula, Terms) or any(isinstance(f, Call) for f in walk(formula)):
        return False
    known = symbols(formula) <= near.keys()
    return known and all(evaluate(t, near) > 0 for t in formula.terms)


def _kind(factor: Factor, item: Solved, balance: Balance, side: int) -> Kind:
    """Tell a point that stands still from one that moves across its load."""
    still, moving = (item.below, item.above) if side > 0 else (item.above, item.below)
    tied = {name for t in balance.terms if t.tie for name in (t.load.name, t.tie[0])}
    if not still or still in tied or balance.plan.mobility != 1:
        return "other"
    terms = {t.load.name: t for t in balance.terms}
    if not terms[moving].power[0]:
        return "other"
    across = _across(balance.plan, terms[still])
    ratio = canonical(across / terms[moving].power[0]) if across else across
    if ratio and ratio.factors.get(factor, 0) <= 0:
        return "perpendicular load"
    return "output still" if side > 0 else "drive locked"


def _across(plan: Plan, term: Term) -> Product:
    """Return the component of a load's point velocity across the load; 0 for a torque."""
    if not isinstance(term.load, Force) or term.line is None:
        return Product(0)
    return plan.component(term.load.point, term.line + QUARTER)[0]


def solution(factor: Factor, near: Mapping[str, float]) -> tuple[str, Formula] | None:
    """Return (symbol, value) at which a sine or cosine vanishes, the one nearest by.

    ``near`` are default values; the symbol is the first of the angle's by name whose
    coefficient is ±1, or its only one.
    """
    if not isinstance(factor, Trig):
        return None
    terms = [(n, c) for n, c in factor.angle.terms if n != RADIAN]
    unit = next(((n, c) for n, c in terms if abs(c) == 1), terms[0] if len(terms) == 1 else None)
    if unit is None:
        return None
    name, c = unit
    rest = factor.angle - Angle(((name, c),))
    first = Angle.constant(0 if factor.function == "sin" else 90)
    turns = _nearest(factor, first, near)
    value = (first + Angle.constant(180 * turns) - rest) * (1 / Fraction(c))
    return name, value.formula()


def _nearest(factor: Trig, first: Angle, near: Mapping[str, float]) -> int:
    """Return the half turns to add so that the angle is as near as can be to its default."""
    try:
        now = factor.angle.evaluate(near)
    except KeyError:
        return 0
    return round((now - first.evaluate({})) / math.pi)
