"""Telescopes with friction: two free bodies, a couple at each end pin, no friction between.

The pins at the ends press with P along the telescope and with what their couples make across
it: |R| = P/cos δ, sin δ = ρ(σ₁ + σ₂)/s, σ the senses in which the telescope turns on each.
"""

import math
from random import Random

import pytest

import mechc
from small_mechanisms import boom, jib

BOOM = boom("friction pins 0.1 diameter 300 mm", "find k = P/T", "find R_G")


def test_the_pins_at_both_ends_have_friction():
    """T = P·(4·sin μ ± 2ρ) at the right angle, where R is along the telescope."""
    results = mechc.loads(BOOM).evaluate(T=1.0)
    assert results["k_f"] == pytest.approx(-1 / 2.43)
    assert results["k_hold"] == pytest.approx(-1 / 2.37)


def boom(dice: Random) -> tuple[str, float, float]:
    """Return a boom on a cylinder at given directions, and T/P with friction both ways."""
    alpha, beta = (dice.uniform(-math.pi, math.pi) for _ in range(2))
    a, s, radius = dice.uniform(0.5, 2), dice.uniform(0.5, 2), dice.uniform(0.001, 0.03)
    arm, along = (complex(math.cos(x), math.sin(x)) for x in (alpha, beta))
    text = f"""
    pivot O
    pivot G
    link OC
    telescope GC
    OC = {a} m @ {alpha} rad
    GC = {s} m @ {beta} rad
    actuator P between G and C
    torque T on OC
    friction pins {radius} diameter 2 m
    find k = T/P
    """
    lever = a * (arm.conjugate() * along).imag
    spin = math.copysign(1, lever)  # as P extends the cylinder
    turning = spin * a * (arm.conjugate() * along).real / s

    def balanced(sense: int) -> float:
        """Return T where P is 1: friction on the boom at O and C, on the telescope at G and C."""
        at_g, at_c, at_o = (sense * _sign(x) for x in (turning, turning - spin, spin))
        sine = -radius * (at_g + at_c) / s
        force = along * complex(1, sine / math.sqrt(1 - sine**2))
        couples = radius * abs(force) * (at_c - at_o)
        return -a * (arm.conjugate() * force).imag - couples

    return text, balanced(1), balanced(-1)


def _sign(value: float) -> float:
    return math.copysign(1.0, value)


@pytest.mark.parametrize("seed", range(6))
def test_random_booms_balance_as_two_free_bodies(seed):
    """T drives, so k_f is where the cylinder is pushed in."""
    text, out, back = boom(Random(seed))
    results = mechc.loads(text).evaluate()
    assert sorted((results["k_f"], results["k_hold"])) == pytest.approx(sorted((out, back)))


def test_a_pair_without_a_telescope_has_no_pins():
    free = BOOM.replace("telescope GC\n", "")
    solved = mechc.loads(free)
    assert [w.code for w in solved.warnings] == ["W243", "W505"]
    assert solved.evaluate(T=1.0)["k_f"] == pytest.approx(-1 / 2.415)
    on_a_link = mechc.loads(free.replace("G and C", "G and C on OC"))
    assert [w.code for w in on_a_link.warnings] == ["W505"]
    assert on_a_link.evaluate(T=1.0) == solved.evaluate(T=1.0)


def test_a_spring_beside_the_actuator_presses_the_same_pins():
    spring = "spring 1 N/m between C and G free 6 m"
    both = mechc.loads(f"{BOOM}\n{spring}\nfind P".replace("find k = P/T", "")).evaluate(T=1.0)
    assert both["P_f"] == pytest.approx(-1 / 2.43 - 1)


def test_mirrored_telescopes_have_friction_alike():
    alone = mechc.loads(BOOM.replace("find R_G", "")).evaluate()
    half = BOOM.replace("friction", "mirror across y sharing O\nfriction").replace("find R_G", "")
    twins = mechc.loads(half).evaluate()
    for name in ("k", "k_f", "k_hold"):
        assert twins[name] == pytest.approx(alone[name])


def test_a_telescope_under_no_load_has_no_friction():
    """Nothing presses its pins; it is there for the drawing."""
    idle = BOOM.replace("pivot G at", "pivot H at (0 m, 1 m)\ntelescope HC\npivot G at")
    assert mechc.loads(idle).evaluate(T=1.0)["k_f"] == pytest.approx(-1 / 2.43)


ENDS = jib("find k = P/W, R_B on OBA, R_C")


@pytest.mark.parametrize("friction", ["", "friction pins 0.2 diameter 200 mm"])
def test_a_telescope_passes_on_to_the_link_what_the_ground_does_to_it(friction):
    """Nothing but its pins acts on it, so that the forces there are equal, couples or not."""
    mechanism = mechc.loads(f"{ENDS}{friction}\n")
    found = mechanism.evaluate(W=1000.0)
    for part in ("_x", "_y", "", "_direction"):
        for ending in ("", "_f") if friction else ("",):
            on_link, on_telescope = found[f"R_B_on_OBA{part}{ending}"], found[f"R_C{part}{ending}"]
            assert on_link == pytest.approx(on_telescope, rel=1e-12)
    assert found["R_C"] == pytest.approx(1000.0 * found["k"], rel=1e-12)
