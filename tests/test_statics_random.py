"""Equilibrium against the null space of the velocities, on mechanisms grown at random."""

from random import Random

import pytest

from by_hand import build, force, torque
from gates import check
from mechanisms import grow
from mechc.algebra import formula
from mechc.statics.answers import load_ratio
from mechc.statics.unfold import Unfolding


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
    return Unfolding(pose, {})


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
    equilibrium_against_velocities(range(1000))


@pytest.mark.slow
def test_equilibrium_agrees_with_velocities_at_length():
    equilibrium_against_velocities(range(1000, 40_000))
