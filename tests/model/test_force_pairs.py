"""Pairs of forces and weights by hand: cylinders, springs, telescopes, halves, counts.

Every description is compiled from both notations.
"""

import math

import numpy as np
import pytest

import mechc
from mechc.diagnostics import Report
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.syntax.to_yaml import to_yaml


def compiled(text):
    """Compile lines, and the same as YAML, which must give the same formulas."""
    source = Source("pair.mech", text)
    yaml = to_yaml(read(source, Report(source)))
    one, other = mechc.loads(text, "pair.mech"), mechc.loads(yaml, "pair.yaml")
    assert [r.formula for r in one.results.values()] == [r.formula for r in other.results.values()]
    return one


def outcomes(text):
    return {f.outcome for f in compiled(text)._compilation.findings}


def evaluated(text, name="k", **values):
    return compiled(text).evaluate(**values)[name]


def cos_deg(angle):
    return math.cos(math.radians(angle))


# ------------------------------------------------------------------------- cylinders

BOOM = """
param r = 400 mm
param e = 900 mm
param alpha = 30 deg
pivot O
link OBE
OE = e @ alpha
OB = r @ alpha
"""


@pytest.mark.parametrize("joint", ["", "telescope CB\n", "telescope BC\n"])
def test_a_cylinder_whose_direction_is_given(joint):
    """The cylinder's moment arm about O is r sin(β − α)."""
    text = f"{BOOM}param beta = 75 deg\npivot C\n{joint}CB = @ beta\n" + (
        "actuator P between C and B\nforce F at E along -y\nfind k = P/F\n"
        "expect k = e*cos(alpha)/(r*sin(beta - alpha))"
    )
    assert outcomes(text) == {"proved"}


def test_the_order_of_its_ends_does_not_matter():
    for ends in ("C and B", "B and C"):
        text = BOOM + (
            "param beta = 75 deg\npivot C\ntelescope CB\nCB = @ beta\n"
            f"actuator P between {ends}\ntorque M on OBE\nfind k = M/P\n"
            "expect k = -r*sin(beta - alpha)"
        )
        assert outcomes(text) == {"proved"}


CYLINDER = """
param s = 500 mm
param c = 600 mm
param r = 400 mm
param e = 900 mm
pivot O at (0 mm, 0 mm)
pivot C at (c, 0 mm)
link OBE
OB = r
OE = e @ OB
CB = s
assembly OCB ccw
drive s from 350 mm to 900 mm
actuator P between C and B
"""


@pytest.mark.parametrize("joint", ["", "telescope CB\n"])
def test_a_cylinder_whose_length_drives(joint):
    """s² = c² + r² − 2 c r cos ψ, so that dψ/ds = s/(c r sin ψ)."""
    s = np.linspace(0.35, 0.9, 12)
    psi = np.arccos((0.36 + 0.16 - s**2) / (2 * 0.6 * 0.4))
    turning = s / (0.6 * 0.4 * np.sin(psi))
    found = evaluated(CYLINDER + joint + "force F at E along -y\nfind k = P/F", s=s)
    assert found == pytest.approx(0.9 * np.cos(psi) * turning, rel=1e-12)


def test_a_cylinder_of_sought_length():
    """A crank drives, the cylinder follows: M = −P ds/dφ with ds/dφ = c r sin φ/s."""
    text = """
param r = 40 mm
param c = 100 mm
param phi = 60 deg
pivot O at (0 mm, 0 mm)
pivot C at (c, 0 mm)
link OA
OA = r @ phi
drive phi from 10 deg to 170 deg
torque M on OA
actuator P between C and A
find k = M/P
"""
    phi = np.radians(np.linspace(10, 170, 9))
    s = np.sqrt(0.01 + 0.0016 - 2 * 0.1 * 0.04 * np.cos(phi))
    for joint in ("", "telescope CA", "telescope AC"):
        found = evaluated(text + joint, phi=phi)
        assert found == pytest.approx(-0.004 * np.sin(phi) / s, rel=1e-12)


def test_a_cylinder_between_two_moving_links():
    """Two levers on one pivot, the cylinder's moment arm about it a cos(γ/2).

    Its direction has a name of its own, through which the formula is compared in numbers.
    """
    text = """
param a = 200 mm
param alpha = 20 deg
param gamma = 100 deg
pivot O
link OA
link OB
OA = a @ alpha
OB = a @ alpha + gamma
telescope AB
actuator P between A and B
torque M on OB
torque N on OA
find M, N
expect M = -a*P*cos(gamma/2)
expect N = a*P*cos(gamma/2)
"""
    assert outcomes(text) == {"agrees"}


# ---------------------------------------------------------------------------- springs

LEVER = """
param a = 150 mm
param h = 100 mm
param c = 3 N/mm
param l0 = 60 mm
param phi = 40 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, h)
link OA
OA = a @ phi
torque M on OA
spring c between Q and A free l0
find M
"""


@pytest.mark.parametrize("drive", ["", "drive phi from 0 deg to 80 deg\n"])
def test_a_spring_holds_a_lever(drive):
    """M = −c (l0 − l) dl/dφ with l² = a² + h² − 2 a h sin φ."""
    phi = np.radians(np.linspace(0, 80, 9))
    length = np.sqrt(0.0225 + 0.01 - 2 * 0.015 * np.sin(phi))
    rate = -0.015 * np.cos(phi) / length
    found = evaluated(LEVER + drive, "M", phi=phi)
    assert found == pytest.approx(-3000 * (0.06 - length) * rate, rel=1e-12)


def test_a_spring_of_zero_free_length_has_a_moment_like_a_weight():
    """Carwardine's spring: with l0 = 0 the moment is c a h cos φ, as that of a weight."""
    phi = np.radians(np.linspace(0, 80, 9))
    found = evaluated(LEVER.replace("l0 = 60 mm", "l0 = 0 mm"), "M", phi=phi)
    assert found == pytest.approx(-3000 * 0.15 * 0.1 * np.cos(phi), rel=1e-12)


def test_two_springs_on_one_pin_count_by_times():
    twice = LEVER.replace("free l0", "free l0 times 2")
    assert evaluated(twice, "M") == pytest.approx(2 * evaluated(LEVER, "M"))


# ---------------------------------------------------------------------------- weights

BEAM = "param b = 2 m\nparam m = 30 kg\nparam phi = 25 deg\npivot O\nlink OG\nOG = b @ phi\n"
BEAM += "torque M on OG\nweight W mass m at G\nfind M\n"


def test_a_weight_on_a_beam():
    assert evaluated(BEAM, "M") == pytest.approx(30 * 9.80665 * 2 * cos_deg(25))


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("param g = 1.62 m/s^2\n", 1.62 * cos_deg(25)),
        ("gravity along -x\n", -9.80665 * math.sin(math.radians(25))),
        (
            "param theta = 10 deg\ngravity along theta - 90 deg\n",
            9.80665 * math.cos(math.radians(15)),
        ),
    ],
)
def test_gravity_of_another_size_or_direction(lines, expected):
    assert evaluated(lines + BEAM, "M") == pytest.approx(30 * 2 * expected)


def test_a_weight_is_held_by_a_cylinder_along_a_stroke():
    """P ds = W dy: the weight hangs at E, the cylinder lifts it."""
    s = np.linspace(0.35, 0.9, 12)
    psi = np.arccos((0.36 + 0.16 - s**2) / (2 * 0.6 * 0.4))
    found = evaluated(CYLINDER + "weight W mass 80 kg at E\nfind P", "P", s=s)
    expected = 80 * 9.80665 * 0.9 * np.cos(psi) * s / (0.6 * 0.4 * np.sin(psi))
    assert found == pytest.approx(expected, rel=1e-12)


# ----------------------------------------------------------------- halves, copies, counts

LADDER = """
param l = 300 mm
param beta = 50 deg
slider K along y
slider A along x
link KA
KA = l @ -beta
mirror across y sharing K
force F at K along y
"""


@pytest.mark.parametrize(("times", "count"), [("", 1), (" times 2", 2), (" times 1/2", 0.5)])
def test_an_actuator_between_twins_counts_once(times, count):
    """2 P dx = −F dy and dx = −dy tan β: P/F = cot β/2, however many cylinders share P."""
    text = LADDER + f"actuator P between A and A'{times}\nfind k = P/F\n"
    text += f"expect k = cot(beta)/{2 * count}"
    assert outcomes(text) == {"proved"}


def test_an_actuator_to_a_shared_point_counts_on_both_halves():
    """A cylinder in each half between K and a pivot under the guide of A."""
    text = LADDER + (
        "param gamma = 70 deg\npivot Q\nKQ = @ -gamma\n"
        "actuator P between Q and K\nfind k = P/F\nexpect k = -1/(2*sin(gamma))"
    )
    assert outcomes(text) == {"proved"}


@pytest.mark.parametrize("direction", ["-beta", "180 deg + beta"])
def test_a_spring_between_twins(direction):
    """Its length is 2 l cos β on whichever side the half was drawn; F = 2 S tan β."""
    text = LADDER.replace("@ -beta", f"@ {direction}")
    found = evaluated(text + "spring 4 N/mm between A and A' free 500 mm\nfind F", "F")
    beta = math.radians(50)
    assert found == pytest.approx(2 * 4000 * (0.5 - 0.6 * math.cos(beta)) * math.tan(beta))


@pytest.mark.parametrize("way", ["forward", "back"])
def test_twins_along_a_stroke(way):
    """The ladder again, its height driven: P/F = cot β/2 on whichever side A stands."""
    text = f"""
param l = 300 mm
param h = 200 mm
pivot O at (0 mm, 0 mm)
slider K along y through O
slider A along x through O
link KA
OK = h @ 90 deg
KA = l
assembly A {way}
mirror across y sharing K O
drive h from 100 mm to 280 mm
force F at K along y
actuator P between A and A'
find k = P/F
"""
    h = np.linspace(0.1, 0.28, 7)
    assert evaluated(text, h=h) == pytest.approx(np.sqrt(0.09 - h**2) / (2 * h), rel=1e-12)


def test_copies_count_each_actuator():
    """Three claws, a cylinder in each: 3 P cos γ = F."""
    text = """
param gamma = 35 deg
slider K along y
pivot Q
QK = @ 90 deg - gamma
copies 3 sharing K
link KB
slider B along x
KB = @ -60 deg
actuator P between Q and K
force F at K along -y
find k = P/F
expect k = 1/(3*cos(gamma))
"""
    assert outcomes(text) == {"proved"}
