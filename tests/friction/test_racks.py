"""Racks on wheels whose pivots have friction: closed forms, against equilibrium by hand."""

import math

import pytest

import mechc
from mechc.compilation import Compilation
from mechc.model.result import FrictionResult
from mechc.power.numbers import pose_values, value_of
from mechc.source import Source
from paths import TESTS

RAISED = """
param phi = 160 deg in 150 deg .. 200 deg
pivot O at (0 mm, 0 mm)
slider A along y
link OB
OB = 400 mm @ phi
rack A on O 50 mm
force P at B along -y
force Q at A along -y
{friction}
find k = P/Q
"""

RHO = 0.15 * 30 / 2
"""The radius of the friction circle in mm."""


def raised(*friction: str) -> dict[str, float]:
    mechanism = mechc.loads(RAISED.format(friction="\n".join(friction)))
    return {name: result.default for name, result in mechanism.results.items()}


def test_a_lever_lifts_a_rack_by_the_arms_less_the_friction_circle():
    """All forces are vertical: P·(OB·|cos φ| − ρ) = Q·(r + ρ), and the other way when it sinks."""
    found, arm = raised("friction pin O 0.15 diameter 30 mm"), -400 * math.cos(math.radians(160))
    assert found["k_f"] == pytest.approx((50 + RHO) / (arm - RHO), rel=1e-12)
    assert found["k_hold"] == pytest.approx((50 - RHO) / (arm + RHO), rel=1e-12)


def test_teeth_lose_a_part_of_the_force_of_the_wheel():
    """The wheel gives T and the rack gets T·(1 − c): as it sinks it has to press T·(1 + c)."""
    found = raised("friction pin O 0.15 diameter 30 mm", "friction rack A 0.03")
    arm = -400 * math.cos(math.radians(160))
    assert found["k_f"] == pytest.approx((50 + RHO) / (arm - RHO) / 0.97, rel=1e-12)
    assert found["k_hold"] == pytest.approx((50 - RHO) / (arm + RHO) / 1.03, rel=1e-12)


def test_the_guide_of_a_rack_is_loaded_by_what_is_across_it():
    """Q stands askew: the guide's friction is μ·Q·sin, and the wheel lifts all of it."""
    askew = RAISED.replace("force Q at A along -y", "force Q at A along 250 deg")
    friction = "friction pin O 0.15 diameter 30 mm\nfriction slider A 0.2"
    found = mechc.loads(askew.format(friction=friction)).results["k_f"].default
    arm, lean = -400 * math.cos(math.radians(160)), math.radians(20)
    lifted = math.cos(lean) + 0.2 * math.sin(lean)
    assert found == pytest.approx(lifted * (50 + RHO) / (arm - RHO), rel=1e-12)


@pytest.mark.parametrize("radius", ["50 mm", "-50 mm"])
@pytest.mark.parametrize("along", ["y", "200 deg", "-35 deg"])
def test_code_agrees_with_the_balance_of_the_wheel(radius, along):
    """At random angles: M − T·r = ρ·|R|, R what P, at right angles to the arm, and T come to."""
    text = RAISED.replace("along y", f"along {along}").replace("50 mm", radius)
    text = text.replace("force P at B along -y", "force P at B along perp OB")
    text = text.replace("force Q at A along -y", f"force Q at A along {along}")
    mechanism = mechc.loads(text.format(friction="friction pin O 0.15 diameter 30 mm"))
    angles = [2.7, 2.9, 3.2, 3.4]
    for name, sense in (("k_f", 1), ("k_hold", -1)):
        for phi, found in zip(angles, mechanism.evaluate(phi=angles)[name], strict=True):
            left = moment_left(found, sense, phi, float(radius.split()[0]), along)
            assert left == pytest.approx(0, abs=1e-9), name


def moment_left(ratio: float, sense: int, phi: float, radius: float, along: str) -> float:
    """Return the moment about O that P = ratio and Q = 1 leave unbalanced, in mm."""
    guide = math.radians({"y": 90.0}.get(along) or float(along.split()[0]))
    # Q acts along the guide on the rack, so that the wheel holds it back with T = -Q
    size = math.hypot(
        -ratio * math.sin(phi) + math.cos(guide), ratio * math.cos(phi) + math.sin(guide)
    )
    return ratio * 400 + radius - sense * RHO * size


LIBRARY_RACKS = ("library/table_4_4_gear", "library/d45_08_double_rack")
OTHERS = ("tests/corpus/good/rack_on_slide", "tests/corpus/good/copies_rack")


@pytest.mark.parametrize("motion", ["tightening", "releasing"])
@pytest.mark.parametrize("name", [*LIBRARY_RACKS, *OTHERS])
def test_closed_forms_are_what_iteration_comes_to(name, motion):
    """On slides, on both sides of a wheel, in copies, and with weights."""
    lines = (TESTS.parent / f"{name}.mech").read_text("utf-8").splitlines()
    kept = [line for line in lines if not line.startswith(("expect", "friction", "efficiency"))]
    added = ("friction pins 0.1 diameter 8 mm", f"motion {motion}")
    compilation = Compilation(Source("rack.mech", "\n".join((*kept, *added))))
    values = pose_values(compilation.pose)
    solved = [r for r in compilation.solution.results if isinstance(r, FrictionResult)]
    closed = [r for r in solved if r.elsewhere]
    assert closed
    for result in closed:
        other = value_of(result.elsewhere, values)
        assert value_of(result, values) == pytest.approx(other, rel=1e-9), result.name
