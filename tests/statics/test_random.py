"""Equilibrium against the null space of the velocities, on mechanisms grown at random."""

import math
from random import Random

import numpy as np
import pytest

from by_hand import build, force, result, torque
from gates import check
from mechanisms import grow
from mechc.diagnostics import Report
from mechc.formula import tree as formula
from mechc.model.mechanism import LoadRatio, Speed, SpeedRatio
from mechc.source import Source
from mechc.statics.answers import load_ratio
from mechc.statics.balanced import Balanced
from mechc.statics.referee import RefereeDisagrees, cross_check
from mechc.statics.speeds import has_sign, speed_ratio


def unfolding(linkage):
    """Return a grown linkage, without its text, as statics takes it."""
    loads = [
        torque(x.name, x.at, x.factor)
        if x.angle is None
        else force(x.name, x.at, x.factor, _tie(x))
        for x in linkage.loads
    ]
    lines = {x.name: x.angle for x in linkage.loads if x.angle is not None}
    more = {}
    if linkage.symmetry:
        kind, shared, number = linkage.symmetry
        if kind == "mirror":
            more = {"mirror": [shared], "axis": linkage.guides[shared]}
        else:
            more = {"copies": (int(number), [shared])}
    bodies = [bar.points for bar in linkage.bars]
    pose = build(linkage.places, bodies, linkage.pivots, linkage.guides, loads, lines, **more)
    return Balanced(pose, {})


def _tie(load):
    if not load.of:
        return None
    part = formula.number(round(10 * load.part)), formula.number(10), formula.Symbol(load.of)
    return formula.product(zip(part, (1, -1, 1), strict=True))


def equilibrium_against_velocities(seeds):
    errors, conditions = [], []
    for seed in seeds:
        linkage = grow(Random(seed))
        solved = linkage.solve()
        if solved is None:
            continue
        answer = load_ratio(unfolding(linkage), "P", "F")
        assert not answer.trouble, f"seed {seed}: {answer.trouble}"
        errors.append(abs(answer.value / solved[0] - 1))
        conditions.append(max(answer.condition, solved[1]))
    check(errors, conditions)


def test_equilibrium_agrees_with_velocities():
    equilibrium_against_velocities(range(500))


@pytest.mark.slow
def test_equilibrium_agrees_with_velocities_at_length():
    equilibrium_against_velocities(range(1000, 2000))


def speed(linkage, motion, what):
    """Return a speed with the sign that it has in the language, or its magnitude."""
    if what.kind == "link":
        number = [bar.name for bar in linkage.bars].index(what.of)
        return motion[2 * len(linkage.places) + number], True
    at = 2 * list(linkage.places).index(what.of)
    x, y = motion[at], motion[at + 1]
    if what.of in linkage.guides:
        angle = math.radians(linkage.guides[what.of])
        return x * math.cos(angle) + y * math.sin(angle), True
    for i, bar in enumerate(linkage.bars):
        if what.of in bar.points and set(bar.points) & set(linkage.pivots):
            turning = motion[2 * len(linkage.places) + i]
            return math.copysign(math.hypot(x, y), turning), True
    return math.hypot(x, y), False


def test_ratios_of_speeds_agree_with_velocities():
    errors, conditions = [], []
    for seed in range(400):
        linkage, dice = grow(Random(seed)), Random(seed)
        solved = linkage.solve()
        if solved is None or len(linkage.drivers) > 1:
            continue
        movable = [Speed("point", p) for p in linkage.places if p not in linkage.pivots]
        turning = [Speed("link", bar.name) for bar in linkage.bars]
        above, below = dice.sample(movable + turning, 2)
        target = SpeedRatio(above, below)
        motion = np.linalg.svd(linkage.constraints())[2][-1]
        upper, signed = speed(linkage, motion, above)
        lower, also = speed(linkage, motion, below)
        if min(abs(upper), abs(lower)) < 1e-3:
            continue
        expected = upper / lower if signed and also else abs(upper / lower)
        case = unfolding(linkage)
        answer = speed_ratio(case, target)
        assert not answer.trouble, f"seed {seed}: {answer.trouble}"
        assert has_sign(case, target) == (signed and also)
        errors.append(abs(answer.value / expected - 1))
        conditions.append(max(answer.condition, solved[1]))
    check(errors, conditions)


def test_the_referee_sees_a_formula_that_is_off_in_the_ninth_digit():
    """The other way round: on well-conditioned linkages a small error never passes."""
    for seed in range(60):
        linkage = grow(Random(seed))
        solved = linkage.solve()
        if solved is None:
            continue
        case = unfolding(linkage).pose
        target = LoadRatio("P", "F")
        asked = Report(Source("random.mech", "x"))
        right = cross_check(case, (result("k", target, solved[0]),), asked)
        if right.trials[0].condition > 1e3:
            continue
        with pytest.raises(RefereeDisagrees):
            cross_check(case, (result("k", target, solved[0] * (1 + 1e-8)),), asked)
