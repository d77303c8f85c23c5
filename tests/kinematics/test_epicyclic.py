"""Wheels on moving arms: Willis's relations, moments by hand, and what is stated of them."""

import math
import re

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.source import Source
from paths import CORPUS

TRAIN = """
param r = {r} mm
param p = {p} mm
param phi = 25 deg
pivot O
link OA "arm"
link AB "planet"
link OS "sun"
{wheels}
OA = {arm} @ phi
AB = 10 mm @ 70 deg
OS = 10 mm @ 200 deg
torque M on OS
torque T on OA
find k = M/T
find i = omega_OS/omega_OA
find j = omega_AB/omega_OA
"""

RING = "gear O r on OS, A p\ngear O r + 2*p on ground, A p inner"
SWAPPED = "gear A p, O r on OS\ngear A p, O r + 2*p on ground inner"


def train(wheels: str = RING, arm: str = "r + p", r: float = 20, p: float = 15) -> str:
    return TRAIN.format(wheels=wheels, arm=arm, r=r, p=p)


def values(text: str) -> dict[str, float]:
    made = mechc.loads(text, "train.mech")
    assert not {d.code for d in made.warnings} - {"W502", "W505"}
    return made.evaluate()


@pytest.mark.parametrize("wheels", [RING, SWAPPED])
@pytest.mark.parametrize(("r", "p"), [(20, 15), (12, 40)])
def test_a_fixed_ring(wheels: str, r: float, p: float) -> None:
    """(ω_sun − ω_arm)/(0 − ω_arm) = −R/r with R = r + 2p; M·ω_sun + T·ω_arm = 0."""
    found = values(train(wheels, r=r, p=p))
    assert found["i"] == pytest.approx(1 + (r + 2 * p) / r, rel=1e-13)
    assert found["j"] == pytest.approx(1 - (r + 2 * p) / p, rel=1e-13)
    assert found["k"] == pytest.approx(-1 / found["i"], rel=1e-13)


def test_a_stepped_planet() -> None:
    """Two gears on one planet: ω_sun − ω_arm = (0 − ω_arm)·R·p/(r·q), of opposite sense."""
    wheels = "param q = 10 mm\ngear O r on OS, A p\ngear O r + p + q on ground, A q inner"
    assert values(train(wheels))["i"] == pytest.approx(1 + 45 * 15 / (20 * 10), rel=1e-13)


@pytest.mark.parametrize(
    ("belt", "i"), [("belt O r on OS, A p", 0.25), ("belt O r on OS, A p crossed", 1.75)]
)
def test_belts_on_an_arm(belt: str, i: float) -> None:
    """The planet does not turn: ω_sun − ω_arm = ∓ω_arm·p/r."""
    text = train(f"{belt}\nbelt O 30 mm on ground, A 30 mm", "200 mm")
    found = values(text)
    assert found["i"] == pytest.approx(i, rel=1e-13)
    assert abs(found["j"]) < 1e-15


def test_friction_of_teeth_acts_in_the_motion_relative_to_the_arm() -> None:
    """Moments by hand, M driving along its arrow against T on the arm, c = 2 % at the sun.

    The sun takes X·r at its rim, the planet X·(1 − c), which the ring takes as well. All
    couples from outside add up to zero: T = −(r + R·(1 − c))·X. The sun turns ahead of the
    arm, so that it drives, and T, the load above the line, is back-driven (W505).
    """
    turned = train(SWAPPED).replace("find k = M/T", "find k = T/M") + "friction gear A 0.02\n"
    turned = turned.replace("gear A p, O r + 2*p on ground inner", RING.split("\n")[1])
    found = values(turned)
    assert found["k_f"] == pytest.approx(-(20 + 50 * 0.98) / 20, rel=1e-12)
    assert found["k_hold"] == pytest.approx(-(20 + 50 * 1.02) / 20, rel=1e-12)


def test_forces_beside_the_teeth_follow_by_moments_about_the_pin() -> None:
    """The teeth on the sun have the moment −T about O, those on the rod −T·p/r about A.

    The moments of the rod about A: N·l·cos psi + P·l·sin psi − T·p/r = 0.
    """
    text = (CORPUS / "good" / "gear_on_coupler.mech").read_text(encoding="utf-8")
    found = mechc.loads(text + "find N_B\n", "gear_on_coupler.mech").evaluate(T=1.0)
    push, psi = found["k"], math.radians(-15)
    by_hand = (0.020 / 0.030 - push * 0.160 * math.sin(psi)) / (0.160 * math.cos(psi))
    assert found["N_B"] == pytest.approx(by_hand, rel=1e-12)


def test_two_degrees_of_freedom_give_each_torque_by_the_one_that_is_known() -> None:
    """Couples on sun, ring and arm are as r : R : −(r + R), whatever turns."""
    wheels = RING.replace("ground", "OR") + "\nlink OR\nOR = 10 mm @ 0 deg"
    text = train(wheels) + "torque N on OR\nfind T\nfind N\n"
    text = re.sub("find [kij] = .*\n", "", text)
    found = mechc.loads(text, "train.mech").evaluate(M=2.0)
    assert found["T"] == pytest.approx(-2 * (20 + 50) / 20, rel=1e-13)
    assert found["N"] == pytest.approx(2 * 50 / 20, rel=1e-13)


def test_gears_on_an_arm_that_do_not_reach_one_another() -> None:
    found = compile_source(Source("a.mech", train(arm="40 mm"))).report.diagnostics
    assert [d.code for d in found if d.code != "W502"] == ["W302", "W302"]


def test_couples_of_the_teeth_on_free_bodies() -> None:
    """The arm takes X·(20 + 50) mm = 7 N·m: X loads the sun at 20 mm, the planet twice at 15."""
    (diagram,) = mechc.loads(train(), "train.mech").free_bodies(T=7)
    couples = {
        (body.name, acting.by): acting.moment
        for body in diagram.bodies
        for acting in body.forces
        if acting.kind == "gear"
    }
    wanted = {("AB", "OS"): 1.5, ("AB", "ground"): -1.5, ("OS", "AB"): 2.0}
    assert couples == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize(
    ("language", "arm", "still"),
    [
        ("en", "carries the centres", "is fixed to the ground"),
        ("uk", "водило", "нерухоме"),
        ("ru", "водило", "неподвижно"),
    ],
)
def test_reports_state_the_arm_and_which_wheel_stands_still(
    language: str, arm: str, still: str
) -> None:
    report = mechc.loads(train(), "train.mech").emit("latex", language=language).lower()
    given = report.split(r"\section*")[1]
    assert (given.count(arm), given.count(still)) == (1, 1)


@pytest.mark.parametrize(
    ("language", "author"), [("en", "Willis"), ("uk", "Вілліса"), ("ru", "Виллиса")]
)
def test_speeds_are_related_as_willis_has_them(language: str, author: str) -> None:
    """Relative to the arm, with teeth for radii; the planet and the arm turn oppositely."""
    report = mechc.load("planetary_gear").emit("latex", language=language)
    assert r"z_S(\omega_{OS}-\omega_{OA})&=z_P(\omega_{AP}+\omega_{OA})" in report
    assert r"z_R\omega_{OA}&=z_P(\omega_{AP}+\omega_{OA})" in report
    assert report.count(author) == 1


def test_reports_do_not_take_a_planet_for_the_ring() -> None:
    report = mechc.loads(train(), "train.mech").emit("latex")
    assert report.count("mesh, one inside the other") == 1
    assert "The relations for $OS$, $AB$ and $OA$ are solved together" in report


def test_what_is_solved_together_has_its_reasons() -> None:
    derivation = mechc.load("double_butterfly").derivation
    (step,) = (s for s in derivation.steps if s.rule == "together")
    assert step.reasons == tuple(
        ("projection", ends) for ends in (("B", "D"), ("E", "G"), ("C", "F"))
    )
