"""Links that slide along moving links without turning on them, against statics by hand."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.source import Source

DRAWN = """
mechanism block
pivot O
pivot C
link OA
link CD
link AE
slot A in CD guiding AE
O at (0 mm, 0 mm)
C at (-80 mm, 0 mm)
A at (20 mm, 25 mm)
D at (60 mm, 35 mm)
E at (20 mm, 65 mm)
{drive}
torque M on OA
force F at E along x
find k = M/F
find N_A
"""

CYLINDER = """
mechanism cylinder
param psi = 60 deg
param d   = 320 mm
param s   = 120 mm
param D   = 400 mm
pivot  C
slider E along x
link   CD "cylinder"
link   BE "piston rod"
slot B in CD guiding BE
CD = D @ psi
CB = d @ psi
BE = s @ CD
actuator P between C and B
force    F at E along -x
force    W = P/4 at D along -y
find k = F/P
find N_B
expect k = cos(psi)*(1 + D*sin(psi)/(4*(d + s)))
expect N_B = -P*D*cos(psi)/(4*(d + s))
"""


def by_hand(turned: float) -> tuple[float, float]:
    """Return M and the force of the slot on the block, for a force F of 1 N.

    ``turned`` is how far the crank is turned from where it is drawn. F gives the rod, which
    the slot keeps from turning, a couple: F·y_AE = −M_E. That couple turns the rocker about C,
    which the slot's force at A holds: N·CA = couple. The crank then bears F and N.
    """
    a = complex(0.020, 0.025) * complex(math.cos(turned), math.sin(turned))
    drawn, now = complex(0.100, 0.025), a + 0.080
    arm = complex(0, 0.040) * (now / abs(now)) / (drawn / abs(drawn))
    normal = -arm.imag / abs(now)
    force = 1 + normal * 1j * now / abs(now)
    return -(a.conjugate() * force).imag, normal


@pytest.mark.parametrize("drive", ["", "drive OA from 20 deg to 80 deg"])
def test_a_drawn_block_keeps_its_angle_to_the_slot(drive: str) -> None:
    made = mechc.loads(DRAWN.format(drive=drive), "block.mech")
    assert not made.warnings
    moment, normal = by_hand(0.0)
    found = made.evaluate(F=1.0)
    assert found["k"] == pytest.approx(moment, rel=1e-12)
    assert found["N_A"] == pytest.approx(normal, rel=1e-12)


def test_the_angle_is_kept_along_the_stroke() -> None:
    made = mechc.loads(DRAWN.format(drive="drive OA from 20 deg to 80 deg"), "block.mech")
    start = math.atan2(0.025, 0.020)
    for turned in (-0.3, 0.2):
        found = made.evaluate(phi_OA=start + turned, F=1.0)
        moment, normal = by_hand(turned)
        assert found["k"] == pytest.approx(moment, rel=1e-12)
        assert found["N_A"] == pytest.approx(normal, rel=1e-12)


def test_free_bodies_show_the_couple_of_the_block() -> None:
    (diagram,) = mechc.loads(DRAWN.format(drive=""), "block.mech").free_bodies(F=1.0)[:1]
    couples = {
        body.name: acting.moment
        for body in diagram.bodies
        for acting in body.forces
        if acting.kind == "slot" and not acting.point
    }
    assert couples == pytest.approx({"AE": 0.040, "CD": -0.040}, rel=1e-12)


def test_a_piston_rod_in_its_cylinder_bears_a_side_load() -> None:
    """Moments of the cylinder about C, and forces across the rod."""
    compilation = compile_source(Source("a.mech", CYLINDER))
    assert [finding.outcome for finding in compilation.findings] == ["proved", "proved"]
    assert compilation.verdict.agrees
    assert compilation.verdict.trials


@pytest.mark.parametrize(
    ("language", "words"), [("en", "is fast in the block"), ("uk", "повзуном"), ("ru", "ползуном")]
)
def test_reports_state_what_the_slot_guides(language: str, words: str) -> None:
    report = mechc.loads(DRAWN.format(drive=""), "block.mech").emit("latex", language=language)
    assert report.count(words) == 1


def test_the_figure_has_the_guided_link() -> None:
    figure = compile_source(Source("a.mech", DRAWN.format(drive=""))).figure
    (slot,) = [part for part in figure.parts if type(part).__name__ == "Slot"]
    assert (slot.point, slot.guided) == ("A", "AE")
