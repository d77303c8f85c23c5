"""Pairs of surfaces that never slip: what is joined to one rigid part turns as one.

The algebra takes an angle of a triangle for any angle, so that the slip of a pin in it is a
difference that vanishes by the law of sines alone. Its value is rounding, and so its sign would be.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from random import Random

from ..algebra.product import Product
from ..formula.rounding import Rounding
from ..kinematics.plan import Plan
from ..model.values import Chain, completed, defaults, dependent, independent
from ..power.numbers import default_values
from ..power.tolerances import VANISHED
from ..units import ANGLE
from .tolerances import PRECISE

POSES = 4
"""At so many poses besides the default one a slip is nothing but rounding if it is zero."""

TRIES = 24
"""Draws to find these poses, at most."""

SPREAD = 0.1
"""How far a parameter is moved: radians, or parts of what else it is."""


def without_standing(slips: Sequence[Product], plan: Plan) -> list[Product]:
    """Return slips, per unit speed of the drive; exactly zero where they are so at any pose."""
    values = completed(default_values(plan), ((b.name, b.value.formula()) for b in plan.bindings))
    doubtful = [i for i, slip in enumerate(slips) if slip and _is_small(slip, values)]
    found = list(slips)
    if doubtful:
        poses = list(_poses(plan))
        for i in doubtful:
            if _vanishes(found[i], poses):
                found[i] = Product(0)
    return found


def _is_small(slip: Product, values: Mapping[str, float]) -> bool:
    """Return whether a slip has no sign at the default pose."""
    try:
        return abs(slip.evaluate(values)) <= VANISHED
    except (KeyError, ZeroDivisionError, ValueError, OverflowError):
        return False


def _poses(plan: Plan) -> Iterator[Rounding]:
    """Yield the default pose and random ones about it, with what rounding makes of them."""
    pose, chance = plan.graph.pose, Random(1)
    given = {**defaults(pose.mechanism), **dict.fromkeys(pose.placeholders, 1.0)}
    moved = sorted(p.name for p in independent(pose.mechanism) if p.name in given)
    angles = {p.name for p in pose.mechanism.parameters if p.dimension == ANGLE}
    chain = Chain({**dependent(pose.mechanism), **dict(pose.definitions)})
    for i in range(TRIES):
        shifts = {n: chance.uniform(-SPREAD, SPREAD) * bool(i) for n in moved}
        there = {n: given[n] + s if n in angles else given[n] * (1 + s) for n, s in shifts.items()}
        rounding = Rounding({**given, **there})
        rounding.define(chain.definitions)
        rounding.define((b.name, b.value.formula()) for b in plan.bindings)
        yield rounding


def _vanishes(slip: Product, poses: Sequence[Rounding]) -> bool:
    """Return whether a slip is rounding at the default pose and at enough others."""
    formula, zeros = slip.formula(), 0
    for pose in poses:
        try:
            found = pose.of(formula)
        except KeyError:
            continue
        if math.isnan(found.value):
            continue
        if not (found.is_zero and found.error <= PRECISE):
            return False
        zeros += 1
    return zeros > POSES
