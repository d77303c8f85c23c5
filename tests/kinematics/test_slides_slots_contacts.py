"""Slides, slots and contacts: against formulas derived by hand, and against their twins."""

import math

import pytest

from mechc.compilation import Compilation, compile_source
from mechc.diagnostics import MechcError
from mechc.routine.evaluate import evaluate
from mechc.source import Source

WHITWORTH = """
param r = 40 mm
param d = 100 mm
param c = 200 mm
param phi = 50 deg in 0 deg .. 80 deg
pivot O
pivot A
link AB
link OC
slot B in OC
OA = d @ 90 deg
AB = r @ phi
OC = c
drive phi from 0 deg to 80 deg
find q = omega_OC/omega_AB
"""

SWINGING_BLOCK = """
param r = 40 mm
param phi = 50 deg
param psi = 20 deg
pivot O
pivot B
link OA
link AC
slot B in AC
OA = r @ phi
AC = @ psi
AB = s @ psi
param s = 90 mm
find q = omega_AC/omega_OA
"""

CAM = """
param r = 60 mm
param phi = 40 deg
param theta = 75 deg
pivot O
link OC
slide AB along y
contact A on OC normal theta
OC = 2*r @ phi
OA = r @ phi
torque M on OC
force F at B along -y
find k = M / F
"""

HOOK = """
param beta = {beta} deg
slide WX along {along}
slide AB along y
contact A on WX normal {normal}
force P at W along {push}
force N at B along -y
find k = N / P
"""

FLOATING = """
param l = 100 mm
param s = 60 mm
param theta = 30 deg
slider A along x
slider B along y
link ACB
link PQ
slider P along 60 deg
slider Q along 100 deg
slot P in AB
AB = l @ 180 deg - theta
AC = s/2 @ 180 deg - theta
AP = s @ 180 deg - theta
PQ = @ 5 deg
force G at A along -x
force F at Q along {along}
find k = F / G
"""


def compiled(text: str) -> Compilation:
    return compile_source(Source("a.mech", text))


def value(text: str, **given: float) -> float:
    """Return the first result at the default values, or at some that a test gives."""
    compilation = compiled(text)
    assert compilation.verdict.agrees
    assert compilation.verdict.trials
    function = compilation.routine.functions[0]
    return float(
        evaluate(function, {i.name: given.get(i.name, i.default) for i in function.inputs})
    )


@pytest.mark.parametrize("phi", [5.0, 30.0, 50.0, 75.0])
def test_whitworth_by_differences_of_the_lever_angle(phi: float) -> None:
    def lever(at: float) -> float:
        return math.atan2(0.1 + 0.04 * math.sin(at), 0.04 * math.cos(at))

    at, step = math.radians(phi), 1e-6
    slope = (lever(at + step) - lever(at - step)) / (2 * step)
    assert value(WHITWORTH, phi=at) == pytest.approx(slope, rel=1e-8)


def test_rod_through_a_block_on_a_pivot() -> None:
    # The block B stands: along the normal of the rod, V_A = r*omega and omega_AC*s cancel.
    expected = -0.04 / 0.09 * math.cos(math.radians(50 - 20))
    assert value(SWINGING_BLOCK) == pytest.approx(expected, rel=1e-12)


def test_lever_as_a_cam_against_a_plunger() -> None:
    # V_A sin(theta) = omega r cos(phi + 90 - theta), and M omega = F V_A.
    phi, theta = math.radians(40), math.radians(75)
    expected = 0.06 * math.cos(phi + math.pi / 2 - theta) / math.sin(theta)
    assert value(CAM) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("beta", [5, 20, 44])
def test_wedge_hook(beta: int) -> None:
    text = HOOK.format(beta=beta, along="x", push="x", normal="90 deg - beta")
    assert value(text) == pytest.approx(1 / math.tan(math.radians(beta)), rel=1e-12)


def test_a_reversed_direction_of_a_slide_changes_nothing() -> None:
    text = HOOK.format(beta=15, along="-x", push="x", normal="90 deg - beta")
    assert value(text) == pytest.approx(1 / math.tan(math.radians(15)), rel=1e-12)


@pytest.mark.parametrize(
    ("push", "normal"), [("-x", "90 deg - beta"), ("x", "270 deg - beta")], ids=["load", "normal"]
)
def test_a_contact_that_pulls_is_refused(push: str, normal: str) -> None:
    with pytest.raises(MechcError) as caught:
        compiled(HOOK.format(beta=15, along="x", push=push, normal=normal))
    (error,) = [d for d in caught.value.diagnostics if d.code.startswith("E")]
    assert error.code == "E604"
    assert "beta = 15 deg" in error.message


def test_the_speed_of_a_slides_point_is_signed_along_it() -> None:
    text = HOOK.format(beta=15, along="-x", push="x", normal="90 deg - beta")
    assert value(text.replace("find k = N / P", "find q = V_A/V_W")) == pytest.approx(
        -math.tan(math.radians(15)), rel=1e-12
    )


def test_a_slot_in_a_slide_is_a_contact_of_both_senses() -> None:
    slot = HOOK.replace("contact A on WX normal {normal}", "slot A in WX\nWX = @ -beta")
    for push, sense in (("x", 1), ("-x", -1)):
        text = slot.format(beta=15, along="x", push=push, normal="")
        assert value(text) == pytest.approx(sense / math.tan(math.radians(15)), rel=1e-12)


@pytest.mark.parametrize("along", ["100 deg", "x"])
def test_a_slot_in_a_link_without_pivot(along: str) -> None:
    # A = (l cos theta, 0) and B = (0, l sin theta) with V_A = 1 along x.
    theta, length, s = math.radians(30), 0.1, 0.06
    spin = 1 / (length * math.sin(theta))  # of the direction 180 deg - theta
    line = math.pi - theta
    normal = (-math.sin(line), math.cos(line))
    across = normal[0] + spin * s
    sixty, hundred, five = (math.radians(a) for a in (60, 100, 5))
    slope = normal[0] * math.cos(sixty) + normal[1] * math.sin(sixty)
    v_p = across / slope
    v_q = v_p * math.cos(sixty - five) / math.cos(hundred - five)
    part = math.cos(hundred - (hundred if along == "100 deg" else 0.0))
    assert value(FLOATING.format(along=along)) == pytest.approx(1 / (v_q * part), rel=1e-12)


HALF = """
param beta = 10 deg
slide KW along x
slide AB along y
contact A on KW normal 90 deg - beta
mirror across 0 deg sharing K W
force P at K along x
force N at B along -y
find k = N / P
"""

WHOLE = """
param beta = 10 deg
slide KW along x
slide AB along y
slide CD along y
contact A on KW normal 90 deg - beta
contact C on KW normal beta - 90 deg
force P at K along x
force N at B along -y
force R = N at D along y
find k = N / P
"""


def test_a_mirrored_wedge_is_two_contacts_on_one_body() -> None:
    assert value(HALF) == pytest.approx(value(WHOLE), rel=1e-12)
    assert value(HALF) == pytest.approx(1 / (2 * math.tan(math.radians(10))), rel=1e-12)


SLOTTED_LEVER = """
param a = 40 mm
param alpha = 20 deg
pivot O
slider B along x
link OC
slot B in OC
{geometry}
torque M on OC
force F at B along x
find k = M / F
"""


@pytest.mark.parametrize(
    "geometry",
    ["OB = a/cos(alpha) @ 90 deg - alpha",
     "OB = a/cos(alpha)\nOC = @ 90 deg - alpha",
     "OB = (a*tan(alpha), a)"],
    ids=["pin", "line", "cartesian"],
)  # fmt: skip
def test_pin_and_slot_give_one_another_their_direction(geometry: str) -> None:
    # The pin B on the line y = a: x = a tan(alpha), so V_B = omega*a/cos(alpha)^2.
    expected = 0.04 / math.cos(math.radians(20)) ** 2
    assert value(SLOTTED_LEVER.format(geometry=geometry)) == pytest.approx(expected, rel=1e-12)


def test_the_place_of_a_pin_that_matters_is_asked_for() -> None:
    with pytest.raises(MechcError) as caught:
        compiled(SLOTTED_LEVER.format(geometry="OC = @ 90 deg - alpha"))
    assert {d.code for d in caught.value.diagnostics if d.code.startswith("E")} == {"E506"}


SHARED_PISTON = """
param r = 50 mm
param phi = 40 deg
param b = 15 deg
pivot O
link OA
link AB
slide BX along x
OA = r @ phi
AB = @ -b
torque M on OA
force F at X along x
{mirror}
find k = M / F
"""


@pytest.mark.parametrize(
    ("mirror", "halves"), [("", 1), ("mirror across 0 deg sharing B X", 2)], ids=["one", "two"]
)
def test_a_slide_on_rods_is_the_piston_of_a_slider_crank(mirror: str, halves: int) -> None:
    phi, b = math.radians(40), math.radians(15)
    expected = 0.05 * math.sin(phi + b) / math.cos(b) / halves
    assert value(SHARED_PISTON.format(mirror=mirror)) == pytest.approx(expected, rel=1e-12)


def test_three_wedges_around_a_rod_take_a_third_each() -> None:
    text = HALF.replace("mirror across 0 deg", "copies 3")
    assert value(text) == pytest.approx(1 / (3 * math.tan(math.radians(10))), rel=1e-12)
