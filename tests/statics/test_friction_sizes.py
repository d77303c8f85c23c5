"""Frictions that agree with the forces that they make, however large coefficients are."""

import math
from random import Random

import pytest

import mechc
from force_trains import train
from mechc.compilation import Compilation
from mechc.source import Source
from mechc.statics.friction_sizes import SurfacePair, friction_sizes, other_friction_sizes


def drawn(seed, size, largest):
    """Return pairs of surfaces that press on one another at random."""
    dice = Random(f"settled {seed}")
    pairs = range(dice.randint(1, 5))
    return [
        SurfacePair(
            dice.uniform(0, largest),
            [
                (dice.gauss(0, 1), [dice.gauss(0, size) for _ in pairs])
                for _ in range(dice.choice((1, 2)))
            ],
        )
        for _ in pairs
    ]


def agree(pairs, found):
    for pair, friction in zip(pairs, found, strict=True):
        sides = (
            a + sum(f * b for f, b in zip(found, by, strict=True)) for a, by in pair.components
        )
        assert friction == pytest.approx(pair.factor * math.hypot(*sides), rel=1e-8, abs=1e-8)


@pytest.mark.parametrize(("size", "largest", "least"), [(0.3, 0.5, 16), (1, 2, 3), (3, 5, 1)])
def test_frictions_follow_from_the_forces_that_they_make(size, largest, least):
    number = 0
    for seed in range(20):
        pairs = drawn(seed, size, largest)
        found = friction_sizes(pairs)
        if found is not None:
            number += 1
            agree(pairs, found)
        for other in other_friction_sizes(pairs) if seed % 6 == 0 else ():
            agree(pairs, other)
    assert number >= least


def test_what_takes_thousands_of_repetitions_is_followed():
    """f = 0.9999·|1 + f| comes to 9999, each repetition a ten-thousandth nearer."""
    assert friction_sizes([SurfacePair(0.9999, [(1.0, [1.0])])]) == pytest.approx([9999], rel=1e-9)


def test_what_overshoots_is_followed():
    """f = 3·|1 - f| comes to 3/4, and repetition to anything but that."""
    assert friction_sizes([SurfacePair(3.0, [(1.0, [-1.0])])]) == pytest.approx([0.75], rel=1e-12)
    assert pytest.approx(friction_sizes([SurfacePair(3.0, [(1.0, [-1.0])])]), rel=1e-12) == [0.75]


def test_what_grows_without_end_has_no_end():
    assert friction_sizes([SurfacePair(2.0, [(1.0, [1.0])])]) is None


def test_a_second_balance_is_found():
    """f = 3·|1 - f| holds at 3/4, and at 3/2, where the joint is pressed the other way."""
    found = sorted(
        {round(f, 9) for (f,) in other_friction_sizes([SurfacePair(3.0, [(1.0, [-1.0])])])}
    )
    assert found == [0.75, 1.5]


@pytest.mark.parametrize("seed", [7, 51])
def test_huge_frictions_accuse_nobody(seed):
    text = train(seed).with_friction(Random(seed)).replace("param q = 1", "param q = 30")
    compilation = Compilation(Source("train.mech", text))
    _ = compilation.verdict
    assert not {"E601", "E602"} & {d.code for d in compilation.report.diagnostics}


def test_a_gear_that_loses_nearly_all_is_judged():
    text = """
param r = 40 mm
pivot O1
pivot O2
link O1A
link O2B
O1A = 1 m @ 0 deg
O2B = 1 m @ 0 deg
gear O1 r, O2 2*r
torque M on O1A
torque T on O2B
friction gear O1 0.99999
find k = T/M
"""
    assert not mechc.loads(text).warnings


TOGGLE = """\
param alpha = {alpha} deg
pivot E
slider C along 0 deg
link EB
link BC
EB = 80 mm @ alpha
BC = 80 mm @ -alpha
force Q at B along -90 deg
force W at C along 180 deg
friction pins {f} diameter 10 mm
find k = Q/W
"""


@pytest.mark.parametrize(("alpha", "f"), [(89.9, 0.1), (89.99, 0.1), (89.7, 0.5)])
def test_a_toggle_that_is_all_but_straight_is_followed_to_the_force_that_releases_it(alpha, f):
    """Friction is so large there that a force and its opposite balance nearly alike."""
    compilation = Compilation(Source("toggle.mech", TOGGLE.format(alpha=alpha, f=f)))
    held = next(t for t in compilation.verdict.trials if t.result == "k_hold")
    by_hand = 2 * math.tan(math.radians(alpha) - math.asin(f * 10 / 80))
    assert held.statics == pytest.approx(by_hand, rel=1e-8)
    assert not held.is_one_of_several


def test_a_pair_that_nothing_presses_turns_no_force():
    """T5 slides in its slot without a load: what presses it is zero, and has no direction."""
    text = """
param q = 1
pivot O at (0, 0)
pivot G6 at (131 mm, -20 mm)
pivot G9 at (111 mm, -85 mm)
link OA
OA = 50 mm @ phi
param phi = 111 deg
slot T5 in OA
slider T5 along 217 deg through G6
slot T8 in OA
slider T8 along 147 deg through G9
drive phi from 96 deg to 125 deg
torque M on OA
force F at T8 along 79 deg
friction pins 0.173*q diameter 6 mm coulomb
friction contact T5 0.083*q
friction contact T8 0.033*q
find k = M/F
"""
    compilation = Compilation(Source("idle_slot.mech", text))
    assert not any(trial.is_one_of_several for trial in compilation.verdict.trials)


@pytest.mark.parametrize("alpha", [89.9, 89.99, 89.999])
def test_the_balance_that_iteration_found_is_among_the_others(alpha):
    """Forces 1e4 times smaller than without friction: few starts lead there."""
    text = f"""
param alpha = {alpha} deg
pivot O
slider A along 180 deg
link AB
link BOD
AB = 40 mm @ alpha
OB = 40 mm @ 180 deg - alpha
DO = 100 mm @ -alpha
mirror across 0 deg sharing A O
force P at A along 180 deg
force F at D along -90 deg
friction pins 0.1 diameter 10 mm
friction pin O 0.1 diameter 16 mm
find k = P/F
"""
    trials = Compilation(Source("toggle.mech", text)).verdict.trials
    assert next(t.is_one_of_several for t in trials if t.result == "k_f")
