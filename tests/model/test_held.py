"""Several drives: one moves, the others are held at their values."""

import math

import pytest

import mechc
from mechc.cli.main import main
from mechc.compilation import Compilation, complete
from mechc.diagnostics import MechcError
from mechc.report.languages.registry import LANGUAGES
from mechc.report.text.derivation import render
from mechc.source import Source
from mechc.syntax.settings import parse

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


DRAWN = """
mechanism five_bar
pivot O at (0 mm, 0 mm)
pivot C at (200 mm, 0 mm)
link OA
link AG
link CB
link BG
A at (-40 mm, 90 mm)
B at (250 mm, 80 mm)
G at (100 mm, 220 mm)
drive OA from 90 deg to 130 deg
drive CB from 40 deg to 80 deg
torque M on OA
force F at G along x
find k = M/F
"""

ARM_OF_TELESCOPES = """
mechanism arm
pivot O at (0 m, 0 m)
pivot A at (0.2 m, -0.4 m)
link OBCD
link CFG
telescope AB
telescope DF
B at (0.5 m, 0.4 m)
D at (0.7 m, 0.9 m)
C at (1.4 m, 0.9 m)
F at (1.5 m, 1.15 m)
G at (1.8 m, 0.1 m)
drive AB from 0.75 m to 0.95 m
drive DF from 0.75 m to 0.95 m
actuator P between A and B
weight W mass 200 kg at G
find P
"""


def at_setting(text: str, name: str, value: str) -> Compilation:
    found = Compilation(Source("a.mech", text), dict([parse(f"{name}={value}")]))
    complete(found)
    return found


def of_five_bar(turn: float) -> float:
    """Return M/F = -dx_G/dphi_OA in metres, by differences, where CB stands at an angle."""

    def x(phi: float) -> float:
        a = math.hypot(40, 90) * complex(math.cos(phi), math.sin(phi))
        b = 200 + math.hypot(50, 80) * complex(math.cos(turn), math.sin(turn))
        long, other, apart = math.hypot(140, 130), math.hypot(150, 140), abs(b - a)
        along = (apart**2 + long**2 - other**2) / (2 * apart)
        return (a + (b - a) / apart * complex(along, math.sqrt(long**2 - along**2))).real

    phi = math.atan2(90, -40)
    return (x(phi - 1e-6) - x(phi + 1e-6)) / 2e-6 / 1000


def test_the_value_of_a_drawn_drive_that_is_held_may_be_set() -> None:
    made = mechc.loads(DRAWN)
    assert made.defaults["phi_CB"] == pytest.approx(math.atan2(80, 50), rel=1e-9)
    assert made.evaluate()["k"] == pytest.approx(of_five_bar(math.atan2(80, 50)), rel=1e-7)
    for degrees in (45, 57.5, 79):
        expected = pytest.approx(of_five_bar(math.radians(degrees)), rel=1e-7)
        assert made.evaluate(phi_CB=f"{degrees} deg")["k"] == expected
        assert at_setting(DRAWN, "phi_CB", f"{degrees} deg").results[0].default == expected


def test_the_length_of_a_drawn_telescope_that_is_held_may_be_set() -> None:
    """P does the work of W while the stick stands fast at the boom."""

    def height(longer: float, held: float) -> float:
        made = mechc.loads(ARM_OF_TELESCOPES)
        at = made.defaults["len_AB"] + longer
        return made.points(len_AB=at, len_DF=held)[0]["y_G"]

    made = mechc.loads(ARM_OF_TELESCOPES)
    for held in (made.defaults["len_DF"], 0.8, 0.9):
        slope = (height(1e-6, held) - height(-1e-6, held)) / 2e-6
        expected = pytest.approx(200 * 9.80665 * slope, rel=1e-7)
        assert made.evaluate(len_DF=held)["P"] == expected
        assert at_setting(ARM_OF_TELESCOPES, "len_DF", f"{held} m").results[0].default == expected


@pytest.mark.parametrize(("figure", "agrees"), [("65.4656 mm", True), ("63.734 mm", False)])
def test_expectations_hold_at_the_value_of_a_held_drive(figure: str, agrees: bool) -> None:
    expect = f"expect k = {figure} +- 0.001 mm at phi_CB = 45 deg\n"
    found = Compilation(Source("a.mech", DRAWN + expect))
    if agrees:
        complete(found)
    else:
        with pytest.raises(MechcError, match=r"k is 65\.4656 mm where 63\.734 mm"):
            complete(found)


@pytest.mark.parametrize("name", ["phi_OA", "phi_CB"])
def test_a_value_outside_the_stroke_of_what_is_drawn_is_remarked_upon(name: str) -> None:
    found = at_setting(DRAWN, name, "85 deg")
    assert [d.code for d in found.report.diagnostics] == ["W220"]
    inside = {"phi_OA": "100 deg", "phi_CB": "40 deg"}[name]
    assert not at_setting(DRAWN, name, inside).report.diagnostics
    set_there = Compilation(
        Source("a.mech", f"{DRAWN}expect k = 60 mm +- 30 mm at {name} = 85 deg\n")
    )
    complete(set_there)
    assert [d.code for d in set_there.report.diagnostics] == ["W285"]


def test_a_held_drawn_drive_is_named_as_a_quantity() -> None:
    compilation = Compilation(Source("a.mech", DRAWN))
    text = render(compilation.derivation, compilation.mechanism)
    assert "Held at its value while the drive moves: φ_CB." in text
    assert "φ_CB = 57.9946°, range 40° … 80°" in text


def test_links_driven_twice_from_both_ends_are_refused() -> None:
    with pytest.raises(MechcError, match="drives what a formula gives"):
        mechc.loads(DRAWN.replace("drive CB from 40 deg to 80 deg", "drive AO"))
