"""The stroke: rows, stretches, singular poses told apart, extrema."""

import math
import re

import pytest

import mechc
import small_mechanisms
from mechc.algebra.product import Product
from mechc.cli.inputs import source_of
from mechc.cli.main import main
from mechc.compilation import Compilation, checked
from mechc.formula.to_text import text as written
from mechc.formula.walk import symbols
from mechc.source import Source
from mechc.study.analysis import Acted, DeadCentre
from mechc.study.pose_sweep import PoseCode, PoseSweep
from other_kinds import of_two_lengths
from paths import LIBRARY
from small_mechanisms import slider_crank
from sources import in_thirds
from stroke_statements import rate

CLAW = """
param l_A = 100 mm
param l = 500 mm
param h = 120 mm
param x_C = 100 mm
param f = 0.2
param phi = 1.35 rad
param beta: angle
pivot O
slider B along y through O
link OAC
link AB
OA = l_A @ 90 deg - phi
OC = (x_C, -h)
AB = l @ 90 deg + beta
assembly B forward
drive phi from 1 rad to 2 rad
force P at B along -y
force R at C along x
force T = f*R at C along y
find k = P/R
let gamma = asin(sin(phi + beta))
"""

OUTPUT_STILL = DeadCentre(still=Acted("O2B"), moving=Acted("O1A"))
DRIVE_STILL = DeadCentre(still=Acted("O1A"), moving=Acted("O2B"))


def stroke(text, points=5):
    return mechc.loads(text, "test.mech").stroke(points)


def four_bar(a, b, c, d, phi, low=0, high=360):
    sides = {name: f"{side} mm" for name, side in zip("abcd", (a, b, c, d), strict=True)}
    drive = f"from {low} deg to {high} deg"
    pose = {"phi": f"{phi} deg", "drive": drive, "pivots": ("O1", "O2")}
    return small_mechanisms.four_bar("find k = M/T", **sides, **pose)


def test_the_least_k_of_the_claw():
    """The values are those of the paper's figures, computed from its equations (8) and (9)."""
    (least,) = [e for e in stroke(CLAW).extrema if e.result == "k"]
    assert least.kind == "minimum"
    assert least.drive == pytest.approx(1.380557799745, abs=1e-11)
    assert least.value == pytest.approx(1.372773669854, abs=1e-12)


def test_the_rational_zone_of_the_claw():
    (zone,) = stroke(CLAW + "require gamma >= 1.5 rad\n").stretches
    assert zone.low == pytest.approx(1.305764, abs=1e-6)
    assert zone.high == pytest.approx(1.441927, abs=1e-6)
    assert zone.before == zone.after != ""


def test_figures_of_the_claw():
    rows = stroke(CLAW, 3).rows
    assert rows[0].values[0] == pytest.approx(1.499384542672654, rel=1e-12)
    for row in rows:
        beta = math.asin(0.2 * math.sin(row.drive))
        expected = 1.4 * math.cos(beta) / math.sin(row.drive + beta)
        assert row.values[0] == pytest.approx(expected, rel=1e-12)
        gamma = row.drive + beta
        assert row.values[1] == pytest.approx(min(gamma, math.pi - gamma), rel=1e-12)


def test_dead_centres_of_a_crank_and_rocker():
    """Crank and coupler lie in one line: cos φ by the cosine rule with sides b ± a, c, d."""
    found = stroke(four_bar(40, 120, 80, 100, 60)).singular
    assert [(s.value, s.kind) for s in found] == [("0", OUTPUT_STILL)] * 2
    outer = math.acos((160**2 + 100**2 - 80**2) / (2 * 160 * 100))
    inner = math.acos((80**2 + 100**2 - 80**2) / (2 * 80 * 100)) + math.pi
    assert [s.drive for s in found] == pytest.approx([outer, inner], abs=1e-12)


def test_limits_of_a_rocker_are_where_the_drive_is_locked():
    found = stroke(four_bar(80, 40, 90, 110, 78, 0, 180))
    (stretch,) = found.stretches
    locked = [s for s in found.singular if s.value == "infinite"]
    assert [s.kind for s in locked] == [DRIVE_STILL] * 2
    high = math.acos((80**2 + 110**2 - 130**2) / (2 * 80 * 110))
    low = math.acos((80**2 + 110**2 - 50**2) / (2 * 80 * 110))
    assert (stretch.low, stretch.high) == pytest.approx((low, high), abs=1e-12)
    assert [s.drive for s in locked] == pytest.approx([low, high], abs=1e-12)


def test_a_parallelogram_that_is_one_by_its_letters():
    """k is −1 throughout, the flat poses included, which are change points."""
    text = four_bar(40, 100, 40, 100, 60)
    text = text.replace("param c = 40 mm\n", "").replace("param d = 100 mm\n", "")
    text = text.replace("O2B = c", "O2B = a").replace("at (d,", "at (b,")
    found = stroke(text)
    assert {row.values[0] for row in found.rows} == {-1.0}
    assert not found.singular
    assert not found.extrema
    assert places(found) == pytest.approx([0, math.pi, 2 * math.pi], abs=1e-15)


# --------------------------------------------------------------------- branch points


def places(found):
    return [branch.drive for branch in found.branches]


CHANGE_POINTS = {
    "parallelogram": (40, 100, 40, 100),
    "kite on the frame": (40, 40, 100, 100),
    "kite on the coupler": (100, 40, 40, 100),
    "longest and shortest make the others": (40, 100, 60, 80),
    "a folded rocker": (30, 50, 80, 100),
}
"""Crank, coupler, rocker, frame: the sums or differences of two pairs of sides are equal."""


@pytest.mark.parametrize("sides", CHANGE_POINTS.values(), ids=CHANGE_POINTS)
def test_change_points_of_a_four_bar(sides):
    """The loop lies flat where the frame is the crank and the others lengthwise.

    Crank and frame lie in one line there, so that the diagonal is d − a or d + a, and
    the other two sides make it, stretched or folded.
    """
    a, b, c, d = sides
    expected = [
        phi
        for phi in (0, math.pi, 2 * math.pi)
        if abs(d - a * math.cos(phi)) in (b + c, abs(b - c))
    ]
    assert expected
    found = stroke(four_bar(a, b, c, d, 30))
    assert places(found) == pytest.approx(expected, abs=1e-12)
    assert {branch.loop for branch in found.branches} == {"O2-B-A-O1"}
    assert all(branch.bracket <= 1e-12 for branch in found.branches)
    at = [s.drive for s in found.singular]
    assert not [x for x in at if any(abs(x - y) < 1e-3 for y in expected)]


@pytest.mark.parametrize("turn", [20, 137])
def test_a_change_point_wherever_the_frame_lies(turn):
    text = four_bar(40, 100, 60, 80, turn + 60).replace(
        "at (d, 0 mm)", f"at (d*cos({turn} deg), d*sin({turn} deg))"
    )
    assert places(stroke(text)) == pytest.approx([math.radians(turn)], abs=1e-12)


def test_nothing_branches_near_a_change_point():
    """A ten-millionth of a millimetre decides; a limit of the drive is no branch point."""
    for c in (60.0000001, 59.9999999):
        assert not stroke(four_bar(40, 100, c, 80, 60)).branches
    limited = stroke(four_bar(80, 40, 90, 110, 78, 0, 180))
    assert not limited.branches
    assert {s.kind for s in limited.singular} == {OUTPUT_STILL, DRIVE_STILL}


@pytest.mark.parametrize("length", ["100 mm", "r"])
def test_a_crank_as_long_as_its_rod(length):
    """At 90° and 270° the slider is on the pivot and may stay there."""
    found = stroke(slider_crank("find k = M/F", r="100 mm", l=length, phi="30 deg"))
    assert places(found) == pytest.approx([math.pi / 2, 3 * math.pi / 2], abs=1e-12)


def test_a_pin_that_passes_over_the_pivot_of_its_slot():
    """Crank and frame of a Whitworth drive are equal: the slotted link may stand still or turn."""
    text = (LIBRARY / "whitworth.mech").read_text(encoding="utf-8").split("expect")[0]
    found = stroke(text.replace("d   = 30 mm", "d = 60 mm"))
    assert places(found) == pytest.approx([3 * math.pi / 2], abs=1e-12)


def test_a_loop_behind_a_loop_branches_where_its_own_crank_lies_flat():
    """A parallelogram on the rocker of a crank and rocker: flat as the rocker meets its frame."""
    a, b, c, d, phi = 40.0, 120.0, 80.0, 100.0, math.radians(200)
    x, y = a * math.cos(phi) - d, a * math.sin(phi)
    side = math.hypot(x, y)
    psi = math.atan2(y, x) - math.acos((side**2 + c**2 - b**2) / (2 * side * c))
    text = four_bar(a, b, c, d, 60).replace(
        "torque T on O2B",
        f"""
param e = 90 mm
param psi = {psi!r} rad
pivot O3 at (d + e*cos(psi), e*sin(psi))
link BC
link O3C
BC = e
O3C = c
assembly BCO3 ccw
torque T on O3C
""",
    )
    found = stroke(text)
    assert [b.loop for b in found.branches] == ["O3-C-B-O2"] * len(found.branches)
    assert min(abs(x - phi) for x in places(found)) < 1e-12


def test_a_group_of_class_three_turns_back():
    """The place is that at which loops and determinant vanish, see the tests of E309."""
    text = (LIBRARY / "triad_closed.mech").read_text(encoding="utf-8").split("expect")[0]
    text = text.replace("in 30 deg .. 85 deg", "").replace("30 deg to 85 deg", "80 deg to 102 deg")
    found = stroke(text)
    (stretch,) = found.stretches
    assert stretch.high == pytest.approx(math.radians(99.01917149833), abs=1e-12)
    (locked,) = found.singular
    assert isinstance(locked.kind, DeadCentre)
    assert (locked.value, locked.drive) == ("infinite", stretch.high)


PLATFORM = """
param a   = 60 mm
param phi = 70 deg
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
pivot R at (300 mm, 0 mm)
link OA
link AB
link BCD
link QC
link RD
OA        = a @ phi
AB        = {b!r} mm
BC        = {c!r} mm
BD        = {d!r} mm
angle CBD = {turn!r} rad
QC        = 80 mm
RD        = 80 mm
assembly QCB ccw
assembly RDB cw
drive phi from 30 deg to 75 deg
torque M on OA
force F at C along y
find k = M/F
"""


def test_a_group_of_class_three_that_another_branch_crosses():
    """A platform on a parallelogram that lies flat as the crank stands at 40°."""
    phi = math.radians(40)
    b, c, d = complex(310, 60), complex(280, 0), complex(380, 0)
    rod = abs(b - 60 * complex(math.cos(phi), math.sin(phi)))
    turn = (d - b) / (c - b)
    shape = {"b": rod, "c": abs(c - b), "d": abs(d - b), "turn": math.atan2(turn.imag, turn.real)}
    found = stroke(PLATFORM.format(**shape), 3)
    assert places(found) == pytest.approx([phi], abs=2e-12)
    (stretch,) = found.stretches
    assert (stretch.low, stretch.high) == (places(found)[0], math.radians(75))
    assert [row.trouble for row in found.rows] == [stretch.before, "", ""]
    assert "branch point" in stretch.before
    assert not found.singular
    assert not found.extrema


def test_a_given_pose_and_an_exact_dead_centre():
    text = """
param l = 1 m
param alpha = 10 deg
pivot O
slider K along 90 deg
link OB
link BK
OB = l @ 90 deg + alpha
BK = l @ 90 deg - alpha
drive alpha from -40 deg to 40 deg
force P at B along x
force F at K along -y
find k = P/F
"""
    (dead,) = stroke(text).singular
    assert dead.kind == DeadCentre(still=Acted("K"), moving=Acted("B"))
    assert dead.drive == pytest.approx(0, abs=1e-15)
    assert dead.exact is not None


ROUND_AND_ROUND = """
param a = 100 mm
param phi = 30 deg
pivot O
link OA
OA = a @ phi
drive phi from 0 deg to 350 deg
torque M on OA
force F at A along perp OA
let F = 1 N
find M, R_O
"""


def test_a_direction_that_goes_on_at_the_other_end_of_its_values_has_no_extremum_there():
    stroke = mechc.loads(ROUND_AND_ROUND).stroke(36)
    assert [one for one in stroke.extrema if one.result == "R_O_direction"] == []


CROSSED_FLAT = """
param a = 60 mm
param b = 100 mm
param phi = 120 deg
drive phi from 80 deg to 180 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -b)
link OA
link AB
link QB
OA = a @ phi
AB = b
QB = a
assembly ABQ cw
force F at B along y
torque M on OA
find k = M/F
"""


def test_where_two_factors_vanish_at_once_nothing_is_said_to_stand_still():
    stroke = mechc.loads(CROSSED_FLAT).stroke(9)  # B moves along x where all lies flat
    (zero,) = (pose for pose in stroke.singular if pose.value == "0")
    assert (math.degrees(zero.drive), zero.kind) == (pytest.approx(90), "other")


def test_a_load_across_its_velocity_is_no_dead_centre():
    text = """
param a = 1 m
param phi = 30 deg
pivot O
link OA
OA = a @ phi
drive phi from 20 deg to 160 deg
torque M on OA
force F at A along -x
find k = M/F
"""
    found = stroke(text)
    assert not [s for s in found.singular if isinstance(s.kind, DeadCentre)]


@pytest.mark.parametrize(
    ("drive", "code"), [("", "E591"), ("drive phi\n", "E592")], ids=["no drive", "no ends"]
)
def test_errors(drive, code):
    text = CLAW.replace("drive phi from 1 rad to 2 rad\n", drive)
    with pytest.raises(mechc.MechcError) as caught:
        stroke(text.replace("param beta: angle", "param beta = 10 deg").replace("through O", ""))
    assert [d.code for d in caught.value.diagnostics if d.code[0] == "E"] == [code]


def test_angles_could_drive_and_coefficients_of_friction_could_not():
    lever = """
    param f = 0.1
    param a = 40 mm
    param alpha = 30 deg
    pivot O
    link OA
    OA = a @ alpha
    force P at A along x
    force F at A along y
    friction pins f diameter 5 mm
    find k = P/F
    """
    with pytest.raises(mechc.MechcError) as caught:
        stroke(lever)
    (found,) = (d for d in caught.value.diagnostics if d.code == "E591")
    assert found.message == "no driving coordinate is named, expected alpha"


def test_a_frame_has_no_stroke_and_wants_no_drive():
    frame = """
    pivot O at (0 mm, 0 mm)
    pivot C at (100 mm, 0 mm)
    link OA
    link CA
    A at (50 mm, 40 mm)
    force F at A along -y
    find R_O
    """
    with pytest.raises(mechc.MechcError) as caught:
        stroke(frame)
    (found,) = caught.value.diagnostics
    assert (found.code, found.message) == ("E591", "nothing moves, so that there is no stroke")


# ------------------------------------------------------------------------ velocities


def columns(text, points=7):
    found = stroke(text, points)
    names = [c.name for c in found.columns]
    return [
        (row.drive, dict(zip(names, row.values, strict=True)))
        for row in found.rows
        if not row.trouble
    ]


def test_velocities_of_the_claw():
    """The arm turns clockwise as φ grows; C moves across OC."""
    for phi, row in columns(CLAW):
        beta = math.asin(0.2 * math.sin(phi))
        rate = 0.1 * math.cos(phi) / (0.5 * math.cos(beta))
        down = 0.1 * math.sin(phi) + 0.5 * math.sin(beta) * rate
        assert row["V_B/omega_OAC"] == pytest.approx(-down, rel=1e-12)
        assert row["V_C(R)/omega_OAC"] == pytest.approx(0.12, rel=1e-12)
        assert row["V_C(T)/omega_OAC"] == pytest.approx(0.1, rel=1e-12)
        slope = 1e-6
        near = [
            1.4 * math.cos(b) / math.sin(p + b)
            for p in (phi - slope, phi + slope)
            for b in (math.asin(0.2 * math.sin(p)),)
        ]
        assert row["dk/dphi"] == pytest.approx((near[1] - near[0]) / (2 * slope), rel=1e-7)


def test_velocities_of_a_four_bar_are_those_of_its_power():
    for _, row in columns(four_bar(40, 120, 80, 100, 60)):
        assert row["omega_O2B/omega_O1A"] == pytest.approx(-row["k"], rel=1e-12, abs=1e-15)


def test_no_two_columns_have_one_name():
    found = mechc.load("peaucellier_closed").stroke(2)
    names = [column.name for column in found.columns]
    assert len(set(names)) == len(names)
    assert {"mu_B(AB-OB)", "mu_C(AC-OC)"} <= set(names)


KITE = """
param a = 100 mm
param c = 150 mm
param phi = 40 deg
drive phi from 20 deg to 160 deg
pivot O
pivot Q
link OA
link AB
link QB
OQ = c @ 0 deg
OA = a @ phi
AB = a
QB = c
assembly ABQ cw
torque M on OA
torque T on QB
find k = T/M
"""


def test_the_angle_of_a_triangle_that_is_mirrored_has_its_name():
    """Its loop needs no law of cosines; the angle at its pin is the transmission angle still."""
    stroke = mechc.loads(KITE).stroke(3)
    assert [c.name for c in stroke.columns if c.name.startswith("mu_")] == ["mu_B"]


PUSHED = """
param l = 300 mm
param s = 200 mm
pivot O
slider A along x through O
slider B along y through O
link AB
OA = s @ x
AB = l
assembly B forward
drive s from 50 mm to 250 mm
force P at A along x
force F at B along -y
find k = P/F
"""


def test_velocities_by_the_slider_that_is_driven():
    """The ladder: x² + y² = l²."""
    for s, row in columns(PUSHED):
        assert row["V_B/V_A"] == pytest.approx(s / math.sqrt(0.09 - s * s), rel=1e-12)


CYLINDER = """
param a = 200 mm
param c = 300 mm
param s = 250 mm
pivot O at (0 mm, 0 mm)
pivot Q at (c, 0 mm)
link OA
telescope QA
OA = a
QA = s
assembly OAQ cw
drive s from 150 mm to 450 mm
actuator P between Q and A
torque M on OA
find k = P/M
"""


def test_velocities_by_the_cylinder_that_is_driven():
    """s² = a² + c² − 2ac·cos φ, so ds/dφ = ac·sin φ/s."""
    for s, row in columns(CYLINDER):
        phi = math.acos((0.04 + 0.09 - s * s) / 0.12)
        expected = s / (0.06 * math.sin(phi))
        assert row["omega_OA/V_QA"] == pytest.approx(expected, rel=1e-12)


def test_velocities_by_the_rate_of_a_drive_that_is_no_angle_of_a_link():
    text = four_bar(40, 120, 80, 100, 30).replace("O1A = a @ phi", "O1A = a @ 2*phi")
    for phi, row in columns(text):
        assert row["omega_O1A/phi'"] == pytest.approx(2, rel=1e-12), phi
        assert row["omega_O2B/phi'"] == pytest.approx(-2 * row["k"], rel=1e-12, abs=1e-15)


GEARED = """
param r = 20 mm
param R = 40 mm
param a = 50 mm
param b = 70 mm
param phi = 30 deg
param psi = {psi}
pivot O
pivot Q
link OA
link QB
{wheels}
OA = a @ phi
QB = b @ psi
drive phi from 10 deg to 80 deg
force P at A along y
{load}
find k = P/F
"""


def remarked(text, code="W591"):
    """Return the messages of links that do not follow the drive."""
    compilation = Compilation(Source("a.mech", text))
    checked(compilation)
    return [d.message.split()[1] for d in compilation.report.diagnostics if d.code == code]


@pytest.mark.parametrize(
    ("wheels", "psi", "stays"),
    [
        ("gear O r, Q R", "20 deg", ["QB"]),
        ("gear O r, Q R", "35 deg - r/R*phi", []),
        ("gear O r, Q R", "35 deg + r/R*phi", ["QB"]),
        ("gear O r, Q R", "35 deg - phi", ["QB"]),
        ("gear O r, Q R", "35 deg - 3*phi", ["QB"]),
        ("gear O r, Q R inner", "35 deg + r/R*phi", []),
        ("belt O r, Q R", "35 deg + r/R*phi", []),
    ],
)
def test_a_geared_link_follows_the_drive_or_is_remarked(wheels, psi, stays):
    force = "force F at B along y"
    assert remarked(GEARED.format(wheels=wheels, psi=psi, load=force)) == stays


OFF_ITS_GUIDE = """
param phi = 40 deg
pivot O at (0 mm, 0 mm)
slider B along x
link OA
link AB
OA = 50 mm @ phi
AB = 80 mm @ -20 deg
drive phi from 10 deg to 80 deg
torque M on OA
force F at B along -x
find k = M/F
"""


def test_a_slider_that_would_leave_its_guide_is_given_one_with_a_place():
    """With the length alone nothing else would say where B is."""
    compilation = Compilation(Source("a.mech", OFF_ITS_GUIDE))
    checked(compilation)
    (hint,) = (d.hint for d in compilation.report.diagnostics if d.code == "W591")
    assert hint == "give its length alone, and its guide a place: slider B … through …"
    followed = OFF_ITS_GUIDE.replace("along x", "along x through O").replace("mm @ -20 deg", "mm")
    assert remarked(followed) == []


PLANET = """
param q = 50 deg
param b = 150 deg
pivot O at (0 mm, 0 mm)
link OA
link AB
link BC
slider C along x through O
OA = 60 mm @ q
AB = 20 mm @ b
BC = 200 mm
assembly C forward
gear O 40 mm on ground, A 20 mm
drive q from 0 deg to 360 deg
torque P on OA
force F at C along -x
find k = P/F
"""


def test_what_a_loop_gives_is_not_blamed_for_the_link_before_it():
    """BC closes its loop with AB, which the teeth turn three times as fast as the arm."""
    assert remarked(PLANET) == ["AB"]
    assert remarked(PLANET.replace("b = 150 deg", "b = 3*q")) == []


BENT = """
param phi = 60 deg
pivot O at (0 mm, 0 mm)
pivot Q at (100 mm, 0 mm)
link OA
link ABE
link QB
link EG
slider G along y through (150 mm, 0 mm)
OA = 40 mm @ phi
AB = 120 mm
{arm}
QB = 80 mm
EG = 400 mm
assembly ABQ cw
assembly G forward
drive phi from 20 deg to 100 deg
torque M on OA
force F at G along -y
find k = M/F
"""


@pytest.mark.parametrize(
    ("arm", "bends", "stays"),
    [
        ("AE = 60 mm\nangle BAE = 20 deg", [], []),
        ("AE = 60 mm @ 20 deg", ["ABE"], []),  # EG closes a loop with it
    ],
)
def test_a_link_whose_pin_stays_behind_is_remarked(arm, bends, stays):
    text = BENT.format(arm=arm)
    assert (remarked(text, "W592"), remarked(text)) == (bends, stays)


@pytest.mark.parametrize(
    ("arm", "said"),
    [
        ("BH = s @ 180 deg - phi", []),
        ("BH = s @ phi", ["link BMHE is rigid, but its angle MBH changes with phi"]),
    ],
)
def test_a_cylinder_holds_a_link_that_would_bend(arm, said):
    """A scissor's arm, with the pin of the cylinder on it."""
    text = f"""
param l = 1200 mm
param s = 800 mm
param phi = 25 deg
pivot O at (0 mm, 0 mm)
pivot Q at (150 mm, -60 mm)
slider B along x through O
link OMD
link BMHE
OM = l/2 @ phi
OD = l @ phi
BM = l/2 @ 180 deg - phi
BE = l @ 180 deg - phi
{arm}
drive phi from 8 deg to 50 deg
telescope QH
actuator P between Q and H
force F at E along -y
find k = P/F
"""
    compilation = Compilation(Source("a.mech", text))
    checked(compilation)
    assert [d.message for d in compilation.report.diagnostics if d.code == "W592"] == said


def test_where_a_wheel_under_a_couple_stands_does_not_matter():
    torque = "torque F on QB"
    assert remarked(GEARED.format(wheels="gear O r, Q R", psi="20 deg", load=torque)) == []


def test_gears_along_the_stroke():
    text = GEARED.format(
        wheels="gear O r, Q R", psi="35 deg - r/R*phi", load="force F at B along y"
    )
    for row in stroke(text).rows:
        psi = math.radians(35) - row.drive / 2
        by_hand = 0.7 * math.cos(psi) / math.cos(row.drive)
        assert row.values[0] == pytest.approx(by_hand, rel=1e-12)


@pytest.mark.parametrize(
    ("slope", "stays"), [("15 deg", ["AB"]), ("asin(a/l*sin(phi))", [])], ids=["stands", "follows"]
)
@pytest.mark.parametrize("length", ["l", ""], ids=["length", "open"])
def test_a_rod_follows_the_drive_or_is_remarked(slope, stays, length):
    text = f"""
param a = 50 mm
param l = 96.592582628906829 mm
param phi = 30 deg
param beta = {slope}
pivot O
slider B along x
link OA
link AB
OA = a @ phi
AB = {length} @ -beta
drive phi from 10 deg to 80 deg
force P at A along y
force F at B along x
find k = P/F
"""
    assert remarked(text) == stays


def test_the_command(tmp_path, capsys):
    file = tmp_path / "claw.mech"
    file.write_text(CLAW, encoding="utf-8")
    assert main(["stroke", str(file), "-n", "3"]) == 0
    shown = capsys.readouterr().out
    assert "k has a minimum 1.37277 at phi = 1.38056 rad" in shown
    assert main(["stroke", str(file), "-n", "3", "--csv"]) == 0
    head, *rows = capsys.readouterr().out.splitlines()
    assert head == (
        "phi [rad],k,gamma [deg],dk/dphi,V_B/omega_OAC [mm],V_C(R)/omega_OAC [mm],"
        "V_C(T)/omega_OAC [mm],mu_B [deg]"
    )
    assert len(rows) == 3
    assert float(rows[0].split(",")[1]) == pytest.approx(1.499384542672654, rel=1e-12)


def test_spreadsheets_get_their_decimals(capsys):
    """Where decimals follow a comma, semicolons part the fields; the values are the same."""
    assert main(["stroke", "crank_rocker", "-n", "3", "--csv"]) == 0
    point = capsys.readouterr().out
    assert main(["stroke", "crank_rocker", "-n", "3", "--csv-dialect", "comma"]) == 0
    assert capsys.readouterr().out == point.replace(",", ";").replace(".", ",")


BOTH_WAYS = slider_crank(
    "find k = F / M",
    r="40 mm",
    l="120 mm",
    phi="40 deg",
    drive="from -60 deg to 240 deg",
    along="x",
)


@pytest.mark.parametrize("with_friction", in_thirds([False, True]))
def test_a_pole_that_is_looked_at_is_no_extremum(with_friction):
    """A place of the stroke is φ = 180°, where the rod and the crank lie on one line."""
    friction = "friction pins 0.1 diameter 10 mm" if with_friction else ""
    found = mechc.loads(BOTH_WAYS + friction).stroke()
    extrema = [e.drive for e in found.extrema if e.result == "k"]
    assert [math.degrees(e) for e in extrema] == pytest.approx([73.17529663624])
    assert all(abs(e.value) < 200 for e in found.extrema if e.result != "k_f1")


DRIVEN = [
    path.stem
    for path in sorted(LIBRARY.iterdir())
    if path.suffix in (".mech", ".yaml") and re.search(r"^drive\b", path.read_text(), re.M)
]

INVERSES = ("k = M/T", "k = T/M")


@pytest.mark.parametrize("asked", INVERSES)
def test_what_stands_still_does_whichever_load_is_above_the_line(asked):
    """Of T/M, too, the rocker stands still where the crank and the coupler are in line."""
    text = four_bar(40, 120, 80, 100, 60).replace("k = M/T", asked)
    assert [s.kind for s in stroke(text).singular] == [OUTPUT_STILL] * 2


@pytest.mark.parametrize("name", in_thirds(DRIVEN))
def test_what_is_said_to_stand_still_does(name):
    mechanism = mechc.load(name)
    found = mechanism.stroke(3)
    inside = BESIDE * (found.high - found.low)
    for pose in found.singular:
        if isinstance(pose.kind, DeadCentre):
            at = min(max(pose.drive, found.low + inside), found.high - inside)
            rates, _ = mechanism.points(**{found.drive: at})
            still, moving = (rate(rates, found.drive, a) for a in pose.kind)
            assert abs(still) < 1e-3 * abs(moving), (name, pose)


@pytest.mark.parametrize("name", in_thirds(DRIVEN))
def test_a_column_is_what_the_formulas_call_so(name):
    """A transmission angle has no symbol of another angle at the same pin."""
    compilation = Compilation(source_of(name, ""))
    plan = compilation.solution.plan
    defined = {d.name for d in (*plan.graph.pose.definitions, *plan.graph.pose.closing)}
    found = compilation.stroke(5)
    along = PoseSweep(PoseCode(plan), found.drive)
    for i, column in enumerate(found.columns):
        if column.name in defined:
            for row in found.rows:
                if not row.trouble:
                    value = along.inside(Product.symbol(column.name), row.drive)
                    assert row.values[i] == pytest.approx(value, rel=1e-9), column.name


BESIDE = 1e-9
"""At the very end of a stroke there may be no rates."""


FOLDED = """
param r = 39.7557 mm in 38.8584 mm .. 44.2337 mm
param phi = 63.322 deg in 43.322 deg .. 83.322 deg
pivot O at (174 mm, 107 mm)
link OA
link AB
OA = r @ phi
AB = 115 mm
drive phi from 43.5 deg to 83 deg
torque M on OA
use "toggle.mech" as T (l = 101 mm) at (0 mm, 210 mm) joining T.B = B
assembly ABC1 ccw
find k = M/T_F
"""
"""A toggle of equal links that folds at 60.65 deg; beyond, its ram stands still at its pivot."""


def test_equal_links_that_fold_make_no_pole_and_no_jumps_of_rounding(tmp_path):
    folded = of_two_lengths(FOLDED, tmp_path)
    (tmp_path / "press.mech").write_text(folded, encoding="utf-8")
    mechanism = mechc.load(tmp_path / "press.mech")
    (pole,) = [p for p in mechanism.results["k"].poles if symbols(p.factor) == {"beta_BK1"}]
    assert [written(factor) for factor in pole.except_where] == ["sin(T_alpha + beta_BK1)"]
    found = mechanism.stroke(3)
    assert [s.value for s in found.singular] == ["infinite", "undetermined"]
    places = [math.degrees(s.drive) for s in found.singular]
    assert places == pytest.approx([44.268, 60.65], abs=1e-3)
    assert [math.degrees(b.drive) for b in found.branches] == [pytest.approx(60.65, abs=1e-3)]


def test_the_zero_of_a_load_is_named():
    """A weight on a lever needs no moment where it hangs above the pivot."""
    source = """
param phi = 40 deg
pivot O
link OA
OA = 1.2 m @ phi
drive phi from 20 deg to 160 deg
weight W mass 10 kg at A
torque M on OA
find M
"""
    (zero,) = Compilation(Source("lever.mech", source)).stroke(9).singular
    assert (zero.result, zero.value) == ("M", "0")
    assert math.isclose(zero.drive, math.pi / 2)


WATT = """
param phi = 10 deg in -20 deg .. 20 deg
pivot O at (0 mm, 0 mm)
pivot C at (160 mm, 40 mm)
link OA
link APB
link CB
OA = 80 mm @ phi
AB = 40 mm
CB = 80 mm
AP = 20 mm @ AB
assembly ABC cw
drive phi from -20 deg to 20 deg
torque M on OA
force F at P along x
find k = M/F
"""


def test_a_zero_of_the_fourth_order_is_one_and_where_it_is():
    """Watt's point runs straight: rounding changed the sign of k at -0.00078 and -0.000012 deg."""
    stroke = mechc.loads(WATT).stroke()
    assert [(s.value, s.kind, s.drive) for s in stroke.singular] == [
        ("0", "perpendicular load", 0.0)
    ]
