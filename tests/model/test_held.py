"""Several drives: one moves, the others are held at their values."""

import math

import pytest

import mechc
from mechc.cli.main import main
from mechc.driver import Compilation, complete
from mechc.report.languages.registry import LANGUAGES
from mechc.report.text.derivation import render
from mechc.source import Source

FIVE_BAR = """
mechanism five_bar
param l = 100 mm
param m = 150 mm
param d = 120 mm
param q1 = 100 deg
param q2 = 70 deg
pivot O at (0 mm, 0 mm)
pivot Q at (d, 0 mm)
link OA
link AC
link QB
link BC
OA = l @ q1
QB = l @ q2
AC = m
BC = m
assembly ABC ccw
drive q1 from 80 deg to 140 deg
drive q2 from 40 deg to 100 deg
torque M on OA
force F at C along -y
find k = M/F
find r = V_C_x/omega_OA
"""

ARM = """
param a = 300 mm
param b = 200 mm
param q1 = 30 deg
param q2 = 40 deg
pivot O
link OA
link AB
OA = a @ q1
{second}
{drives}
torque M on {moved}
force F at B along -y
find k = M/F
"""
BOTH = "drive q1 from 0 deg to 90 deg\ndrive q2"
OTHER = "drive q2 from 0 deg to 90 deg\ndrive q1"

CRANE = """
param s1 = 500 mm in 400 mm .. 600 mm
param s2 = 300 mm in 250 mm .. 350 mm
pivot O at (0 mm, 0 mm)
pivot Q at (400 mm, 0 mm)
link OAC
link CED
telescope QA
telescope AE
OA = 400 mm
OC = 600 mm
angle AOC = 0 deg
CE = 150 mm
CD = 500 mm
angle ECD = 180 deg
QA = s1
AE = s2
assembly QAO ccw
assembly CEA ccw
drive s1 from 400 mm to 600 mm
drive s2 from 250 mm to 350 mm
actuator P between Q and A
force F at D along -y
find k = P/F
find R_O
"""


def slope(text: str, drive: str, step: float = 1e-6) -> float:
    """Return by differences how fast the loaded point C, D or B rises with a drive."""
    made = mechc.loads(text)
    at = made.defaults[drive]
    point = next(p for p in "DCB" if f"y_{p}" in made.points()[0])
    ahead, behind = (made.points(**{drive: at + s * step})[0][f"y_{point}"] for s in (1, -1))
    return (ahead - behind) / (2 * step)


@pytest.mark.parametrize(
    ("text", "drive"),
    [
        (FIVE_BAR, "q1"),
        (ARM.format(second="AB = b @ q1 + q2", drives=BOTH, moved="OA"), "q1"),
        (ARM.format(second="angle OAB = 180 deg - q2\nAB = b", drives=BOTH, moved="OA"), "q1"),
        (ARM.format(second="AB = b @ q1 + q2", drives=OTHER, moved="AB"), "q2"),
        (CRANE, "s1"),
    ],
)
def test_the_work_of_both_loads_where_one_drive_moves(text: str, drive: str) -> None:
    """M·dφ − F·dy = 0; an actuator pushes as its length grows."""
    found = mechc.loads(text).evaluate()
    assert found["k"] == pytest.approx(slope(text, drive), rel=1e-8)


def test_a_five_bar_by_hand() -> None:
    """C is on two circles about A and B; only A moves."""
    found = mechc.loads(FIVE_BAR).evaluate(q1=1.9)
    a = 0.1 * complex(math.cos(1.9), math.sin(1.9))
    b = 0.12 + 0.1 * complex(math.cos(math.radians(70)), math.sin(math.radians(70)))
    c = (a + b) / 2 + 1j * (b - a) * math.sqrt(0.15**2 / abs(b - a) ** 2 - 0.25)
    velocity = 1j * a
    turn = (velocity * (c - a).conjugate()).real / (1j * (c - b) * (c - a).conjugate()).real
    expected = 1j * (c - b) * turn
    assert found["k"] == pytest.approx(expected.imag, rel=1e-12)
    assert found["r"] == pytest.approx(expected.real, rel=1e-12)


def test_a_differential_has_a_ratio_for_each_input() -> None:
    """Willis: (ω_ring − ω_arm)/(ω_sun − ω_arm) = −r/(r + 2p)."""
    text = """
    param r = 20 mm
    param p = 15 mm
    param sun = 10 deg
    param arm = 30 deg
    pivot O at (0 mm, 0 mm)
    link OS
    link OA
    link OR
    link AB
    OA = r + p @ arm
    OS = 10 mm @ sun
    OR = 60 mm @ 0 deg
    AB = 5 mm @ 40 deg
    gear O r on OS, A p
    gear O r + 2*p on OR, A p inner
    torque M on {load}
    torque T on OR
    drive {drives}
    find k = M/T
    find i = omega_OR/omega_{load}
    """
    text = "\n".join(map(str.strip, text.splitlines()))
    sun = mechc.loads(text.format(load="OS", drives="sun\ndrive arm")).evaluate()
    arm = mechc.loads(text.format(load="OA", drives="arm\ndrive sun")).evaluate()
    assert sun["i"] == pytest.approx(-20 / 50)
    assert arm["i"] == pytest.approx(1 + 20 / 50)
    assert sun["k"] == pytest.approx(-sun["i"])
    assert arm["k"] == pytest.approx(-arm["i"])


def test_what_does_not_follow_the_drive_has_no_path() -> None:
    names = set(mechc.loads(FIVE_BAR).points()[0])
    assert {"x_C", "phi_AC", "dphi_AC_dq1"} <= names
    assert "dphi_QB_dq1" not in names
    train = """
    param r = 20 mm
    param phi = 10 deg
    pivot O at (0 mm, 0 mm)
    pivot Q at (3*r, 0 mm)
    link OA
    link QB
    OA = r @ phi
    QB = r @ 40 deg
    gear O r, Q 2*r
    torque M on OA
    torque T on QB
    drive phi from 0 deg to 90 deg
    find k = M/T
    """
    text = "\n".join(map(str.strip, train.splitlines()))
    names = set(mechc.loads(text).points()[0])
    assert {"x_A", "y_A", "phi_OA"} <= names
    assert names.isdisjoint({"x_B", "y_B", "phi_QB"})


def test_drawn_links_are_held_where_they_are_drawn() -> None:
    text = """
    pivot O at (0 mm, 0 mm)
    pivot Q at (120 mm, 0 mm)
    link OA
    link AC
    link QB
    link BC
    A at (-20 mm, 100 mm)
    B at (150 mm, 90 mm)
    C at (60 mm, 200 mm)
    drive OA from 80 deg to 140 deg
    drive QB from 40 deg to 100 deg
    torque M on OA
    force F at C along -y
    find k = M/F
    """
    text = "\n".join(map(str.strip, text.splitlines()))
    assert mechc.loads(text).evaluate()["k"] == pytest.approx(slope(text, "phi_OA"), rel=1e-8)
    other = text.replace("torque M on OA", "torque M on QB")
    compilation = Compilation(Source("a.mech", other), drive="QB")
    first, last = (compilation.stroke(2).rows[i] for i in (0, -1))
    assert first.values[0] != pytest.approx(last.values[0])
    assert compilation.stroke(2).drive == "phi_QB"


def test_a_link_of_a_held_drive_is_none_of_the_ground() -> None:
    compilation = Compilation(Source("a.mech", FIVE_BAR))
    complete(compilation)
    assert "W262" not in {d.code for d in compilation.report.diagnostics}
    fixed = FIVE_BAR.replace("link QB", "link QB\nlink OQ")
    compilation = Compilation(Source("a.mech", fixed))
    complete(compilation)
    (message,) = (d.message for d in compilation.report.diagnostics if d.code == "W262")
    assert "of link OQ" in message


def test_the_derivation_says_which_drive_is_held(tmp_path) -> None:
    compilation = Compilation(Source("a.mech", FIVE_BAR))
    text = render(compilation.derivation, compilation.mechanism)
    assert "Held at its value while the drive moves: q₂." in text
    for language in LANGUAGES:
        assert "$q_2$" in mechc.loads(FIVE_BAR).emit("latex", language=language)


def test_the_stroke_moves_the_drive_that_is_named(tmp_path, capsys) -> None:
    path = tmp_path / "five.mech"
    path.write_text(FIVE_BAR.replace("M on OA", "M on QB").replace("omega_OA", "omega_QB"))
    assert main(["stroke", str(path), "--drive", "q2", "--points", "3"]) == 0
    assert capsys.readouterr().out.startswith("q2 [deg]")
    assert main(["stroke", str(path), "--drive", "q3"]) == 2
    assert "has no drive 'q3'" in capsys.readouterr().err
