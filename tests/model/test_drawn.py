"""Mechanisms by drawn coordinates, against singular values of the motion at those places."""

import cmath
import math
import re
from itertools import permutations

import pytest

import mechc
import reference_kinematics
from drawn_mechanisms import DRAWN
from mechc.compilation import Compilation, compile_source
from mechc.diagnostics import MechcError
from mechc.source import Source
from mechc.syntax import ast
from reference_geometry import Arms, evaluate, every

DRIVEN = [name for name, text in DRAWN.items() if "\ndrive" in text]


def compiled(text: str) -> Compilation:
    return compile_source(Source("drawn.mech", text))


def value(text: str, name: str = "k") -> float:
    found = {r.name: r.default for r in compiled(text).results}[name]
    assert found is not None
    return found


def codes(text: str) -> list[str]:
    try:
        return [d.code for d in compiled(text).report.diagnostics]
    except MechcError as error:
        return [d.code for d in error.diagnostics]


def without_drive(text: str) -> str:
    return re.sub(r"(?m)^drive .*\n", "", text)


def arms(file: ast.File) -> Arms:
    """Return every vector between two points that have a place."""
    statements = [*every(file, ast.Pivot), *every(file, ast.Drawn)]
    at = {
        s.point.text: complex(evaluate(s.at.x, {}), evaluate(s.at.y, {}))
        for s in statements
        if s.at
    }
    for slot in every(file, ast.Slot):
        at.setdefault(slot.line.text[-1], at[slot.point.text])
    found = Arms({}, {})
    for tail, head in permutations(at, 2):
        size, turn = cmath.polar(at[head] - at[tail])
        found.set_length(tail, head, size)
        found.set_angle(tail, head, turn)
    return found


@pytest.mark.parametrize("name", DRAWN)
def test_the_drawn_pose_agrees_with_singular_values(name):
    # From a pivot, what pushes two points apart is a force on the second.
    text = re.sub(r"actuator P between (.) and (.)", r"force P at \2 along \1\2", DRAWN[name])
    file = Compilation(Source("drawn.mech", text)).tree
    reference = reference_kinematics.results(file, arms=arms(file))["k"]
    assert value(without_drive(DRAWN[name])) == pytest.approx(reference, rel=1e-9)


@pytest.mark.parametrize("name", DRIVEN)
def test_closing_the_loops_gives_the_drawn_pose(name):
    drawn = value(without_drive(DRAWN[name]))
    assert value(DRAWN[name]) == pytest.approx(drawn, rel=1e-9)
    assert not {"E307", "W320"} & set(codes(DRAWN[name]))


FOUR_BAR = DRAWN["four_bar"]


def test_a_parameter_without_a_value_has_that_of_the_drawing():
    text = FOUR_BAR.replace("drive OA", "param phi: angle\nOA = @ phi\ndrive phi")
    assert value(text) == pytest.approx(value(FOUR_BAR), rel=1e-12)


@pytest.mark.parametrize(("place", "mode"), [("(80 mm, 60 mm)", "cw"), ("(60 mm, -50 mm)", "ccw")])
def test_with_lengths_given_the_nearest_closure_is_meant(place, mode):
    given = "OA = 40 mm\nAB = 65 mm\nCB = 63 mm\n"
    text = re.sub(r"B at .*", f"B at {place}", FOUR_BAR)
    stated = re.sub(r"B at .*", f"assembly ABC {mode}", FOUR_BAR)
    assert value(text + given) == value(stated + given)


def test_a_few_drawn_points_set_many_closures_apart():
    text = DRAWN["double_butterfly"]
    shape = [  # of the bodies through C and G, which are then not drawn
        ("link ABC", "AC = 2.7374799 m", "angle BAC = -58.4692 deg"),
        ("link BFG", "BG = 4.9404362 m", "angle FBG = 37.4152 deg"),
        ("link CD", "CD = 6.9400693 m", ""),
        ("link SG", "SG = 11.0001574 m", ""),
    ]
    given = "\n".join(line for _, *lines in shape for line in lines)
    few = re.sub(r"(?m)^[CG] at .*\n", "", text) + given + "\n"
    assert value(few) == pytest.approx(value(text), rel=1e-4)


def test_lengths_given_hold_and_a_gap_is_stated():
    assert "W320" not in codes(FOUR_BAR + "OA = 40 mm\nAB = 65 mm\n")
    assert "W320" in codes(FOUR_BAR + "OA = 42 mm\nAB = 65 mm\n")


def test_an_angle_that_is_not_the_drawn_one_holds():
    given = FOUR_BAR.replace("drive OA", "param phi = 50 deg\nOA = @ phi\ndrive phi")
    (gap,) = (d for d in compiled(given).report.diagnostics if d.code == "W320")
    driven = FOUR_BAR + "expect k = 0 at phi_OA = 50 deg\n"
    with pytest.raises(MechcError, match=f"{value(given):.5f}"):
        compiled(driven)
    assert gap.message.startswith("A is drawn 6.97")


def test_coordinates_may_be_formulas():
    text = (
        "param a = 20 mm\nparam b = 30 mm in 20 mm .. 40 mm\npivot O at (0 mm, 0 mm)\n"
        "slider K along y\nlink OB\nlink BK\nB at (b, 2*a)\nK at (0 mm, 4*a)\n"
        "force P at B along x\nforce F at K along y\nfind k = P/F\nexpect k = b/a\n"
    )
    assert codes(text) == []


def _moved(turned: float) -> float:
    """Return ds/dφ of the slider crank of 50 and 40√10, over 50."""
    across = 50 * math.sin(turned)
    return math.sin(turned) + across * math.cos(turned) / math.sqrt(16000 - across**2)


BY_ANGLE = FOUR_BAR.replace(
    "A at (20 mm, 34.64 mm)",
    "param alpha = 60 deg\nA at (40 mm*cos(alpha), 40 mm*sin(alpha))",
).replace("drive OA", "drive alpha")


@pytest.mark.parametrize("alpha", ["20 deg", "60 deg", "75 deg"])
def test_what_drives_may_be_in_the_coordinates(alpha):
    # The same four-bar by its lengths, where the coupler keeps its own.
    lengths = "OA = 40 mm @ alpha\nAB = hypot(60 mm, 59.64 mm - 40 mm*sin(60 deg))"
    lengths += "\nCB = hypot(20 mm, 59.64 mm)\nassembly ABC cw"
    by_lengths = re.sub(r"(?m)^[AB] at .*\n", "", BY_ANGLE) + lengths
    asked = {"alpha": math.radians(float(alpha.split()[0]))}
    reference = mechc.loads(by_lengths).evaluate(**asked)["k"]
    assert mechc.loads(BY_ANGLE).evaluate(**asked)["k"] == pytest.approx(reference, rel=1e-9)
    assert codes(BY_ANGLE) == []


def test_a_slider_may_drive_by_its_coordinate():
    text = DRAWN["slider_crank"].replace("B at (150 mm", "param s = 150 mm\nB at (s")
    driven = text.replace("drive OA from 10 deg to 170 deg", "drive s from 130 mm to 160 mm")
    assert value(driven) == pytest.approx(value(DRAWN["slider_crank"]), rel=1e-9)
    # At s the sides of O-A-B are 50, 40√10 and s.
    at = mechc.loads(driven).evaluate(s=0.14)["k"]
    turned = math.acos((50**2 + 140**2 - 16000) / (2 * 50 * 140))
    assert abs(at) == pytest.approx(0.05 * _moved(turned), rel=1e-9)


def test_turned_moved_and_scaled_it_is_the_same_mechanism():
    text = without_drive(DRAWN["toggle_clamp"]).replace("torque M on HE", "force M at E along HN")
    turn = cmath.rect(3, 0.7)

    def moved(match: re.Match[str]) -> str:
        z = complex(float(match[1]), float(match[2])) * turn + 5 - 2j
        return f"at ({z.real!r} m, {z.imag!r} m)"

    other = re.sub(r"at \((\S+) m, (\S+) m\)", moved, text).replace("along -y", "along 0.7 - pi/2")
    assert value(other) == pytest.approx(value(text), rel=1e-9)


def test_derived_quantities_are_constants_with_names():
    text = FOUR_BAR + "let l = len_OA\nlet turned = phi_OA\n"
    found = compiled(text)
    assert value(text, "l") == pytest.approx(math.hypot(0.02, 0.03464), rel=1e-15)
    assert value(text, "turned") == pytest.approx(math.atan2(0.03464, 0.02), rel=1e-15)
    (k, *_) = found.routine.functions
    assert [i.name for i in k.inputs] == ["phi_OA"]
    assert {p.name: p.unit for p in found.mechanism.parameters} == {"phi_OA": "deg"}
    lengths = {p.name: p.unit for p in found.mechanism.literals}
    assert lengths == dict.fromkeys(("len_OA", "len_AB", "len_CB", "x_C"), "mm")


def test_a_pin_a_little_off_its_slot_is_laid_on_it():
    text = without_drive(DRAWN["inverted_slider_crank"])
    rounded = text.replace("A at (20 mm, 20 mm)", "A at (20.0 mm, 20.1 mm)")
    assert value(rounded) == pytest.approx(value(text), rel=0.01)
    assert codes(text.replace("A at (20 mm, 20 mm)", "A at (20.0 mm, 21.0 mm)")) == ["E322"]


def test_a_vector_given_whole_draws_the_point_that_it_leads_to():
    undrawn = re.sub(r"A at .*", "OA = 40 mm @ phi", FOUR_BAR)
    stated = undrawn.replace("drive OA", "param phi = 60 deg\ndrive phi")
    closed = re.sub(r"drive .*", "param phi = 60 deg", undrawn)
    assert value(stated) == pytest.approx(value(FOUR_BAR), rel=1e-4)
    assert value(closed) == pytest.approx(value(stated), rel=1e-12)


@pytest.mark.parametrize("drive", ["", "drive phi from 0 deg to 360 deg\n"])
def test_a_pin_that_a_crank_leads_lies_in_its_slot_where_the_end_alone_is_drawn(drive):
    ends = "OA = 2 m @ phi\nC at (0 m, 2.1 m)\nparam phi = atan2(1.6, 1.2)\n"
    text = re.sub(r"A at .*\n", ends + drive, without_drive(DRAWN["quick_return"]))
    assert codes(text) == []
    assert value(text) == pytest.approx(value(DRAWN["quick_return"]), rel=1e-9)


def test_an_angle_with_a_range_alone_follows_from_the_loop():
    ranged = FOUR_BAR + "param psi in 60 deg .. 120 deg\nCB = @ psi\n"
    assert codes(ranged) == ["W303"]
    assert value(ranged) == pytest.approx(value(FOUR_BAR), rel=1e-12)


def test_a_value_that_is_given_is_none_of_the_drawing():
    """Only the remark stands that it lies outside its range, wherever it was given."""
    ranged = FOUR_BAR + "param psi = 60 deg in 70 deg .. 80 deg\nlet twice = 2*psi\n"
    assert codes(ranged) == ["W220"]


SLOTTED_LEVER = """
pivot O at (0 mm, 0 mm)
slider K along x
link OB
slot K in OB
K at (40 mm, 60 mm)
B at (50 mm, 75 mm)
torque M on OB
force P at K along x
find k = M/P
"""

FLAT_FOLLOWER = """
pivot O at (0 mm, 0 mm)
link OC
slide WX along y
contact W on OC normal 90 deg
C at (8 mm, 6 mm)
W at (8 mm, 36 mm)
X at (0 mm, 100 mm)
torque M on OC
force F at X along -y
find k = M/F
"""


def test_what_slides_or_touches_pushes_on_an_arm_as_it_is_drawn():
    """The slot turns with P·sin/r: ω·r = V·sin, r² = 40² + 60²; the face is lifted by ω·x."""
    assert value(SLOTTED_LEVER) == pytest.approx((0.04**2 + 0.06**2) / 0.06, rel=1e-12)
    assert value(FLAT_FOLLOWER) == pytest.approx(0.008, rel=1e-12)


@pytest.mark.parametrize(("wide", "high"), [("1.2", "0.4"), ("1", "0.4"), ("0.7", "0.3")])
def test_lengths_in_a_ratio_are_so_to_the_last_digit(wide, high):
    """Scissors with a guide too many move whatever the digits of the roots are."""
    double = [f"{2 * float(size):g}" for size in (wide, high)]
    text = f"""mechanism scissors
    pivot A at (0 m, 0 m)
    slider B along x
    slider C along y
    link AED
    link BEC
    B at ({double[0]} m, 0 m)
    E at ({wide} m, {high} m)
    C at (0 m, {double[1]} m)
    D at ({double[0]} m, {double[1]} m)
    force P at B along -x
    force F at D along -y
    find k = P/F"""
    assert value(text) == pytest.approx(float(wide) / float(high), rel=1e-12)
    assert codes(text) == ["W401"]


def test_points_on_one_line_but_for_the_last_digit_make_no_angle():
    """A, M and C are collinear with A at 9450/11 mm: its sixteen digits leave 3e-16 degrees."""
    text = """
    pivot O at (0 mm, 0 mm)
    slider A along x
    link OM
    link AMC
    A at (859.0909090909091 mm, 0 mm)
    M at (450 mm, 180 mm)
    C at (-50 mm, 400 mm)
    drive OM from 10 deg to 30 deg
    torque T on OM
    force F at C along -y
    find k = T/F
    """
    found = compiled(text)
    names = {p.name for p in found.mechanism.parameters}
    assert not any(name.startswith("delta_") for name in names)


CLAW = """
param y = 30 mm
pivot O at (0 mm, 0 mm)
pivot Q at (50 mm, 0 mm)
slider K along y{through}
link KB
link QBC
{place}
KB = 40 mm
QB = 35 mm
QC = 80 mm
angle BQC = -100 deg
assembly KQB cw
drive y from 20 mm to 45 mm
force P at K along y
force F at C along perp QC
find k = P/F
"""


@pytest.mark.parametrize("through", ["", " through O"])
def test_a_drive_moves_a_slider_whose_guide_has_a_place(through):
    """Its drawn place says how it moves, as a vector along the guide does."""
    drawn = mechc.loads(CLAW.format(through=through, place="K at (0 mm, y)"))
    given = mechc.loads(CLAW.format(through=" through O", place="OK = y @ 90 deg"))
    for y in (0.022, 0.03, 0.042):
        k = given.evaluate(y=y)["k"]
        assert drawn.evaluate(y=y)["k"] == pytest.approx(k, rel=1e-12)


IN_LINE = """
param phi = 90 deg
pivot O at (0 mm, 0 mm)
pivot Q at (100 mm, 150 mm)
link OA
link QB
link AB
B at (50 mm, 100 mm)
OA = 50 mm @ phi
QB = 90 mm
AB = 60 mm
assembly ABQ {turn}
{drive}
torque M on OA
torque F on QB
find k = M/F
"""


@pytest.mark.parametrize("drive", ["", "drive phi from 85 deg to 95 deg"])
def test_rods_drawn_in_one_line_close_where_their_lengths_are_others(drive):
    """There they seem to leave B free across the line: its drawn direction was taken for given."""
    far, along = 100 * (1 + 1j), 100 * (1 + 1j) / math.hypot(100, 100)
    ahead = (abs(far) ** 2 + 60**2 - 90**2) / (2 * abs(far))
    aside = math.sqrt(60**2 - ahead**2)
    b = [50j + along * complex(ahead, side) for side in (-aside, aside)]
    for turn, at in zip(("ccw", "cw"), b, strict=True):
        ab, qb = at - 50j, at - complex(100, 150)
        crank = -50 * ab.real / abs(ab)  # how fast A moves along AB: A moves by i·OA = -50 mm
        rocker = (1j * qb * ab.conjugate()).real / abs(ab)
        found = mechc.loads(IN_LINE.format(turn=turn, drive=drive)).evaluate()["k"]
        assert found == pytest.approx(-crank / rocker)


COVERED = """
pivot A at (0 mm, 400 mm)
pivot B at (60 mm, 400 mm)
slider K along x
slider H along y
K at (0 mm, 400 mm)
H at (60 mm, 0 mm)
rope A, K along {along}, B along x, H along -y
force P at H along -y
force F at K along -x
find k = P/F
"""


@pytest.mark.parametrize("along", ["x", "-x", "150 deg"])
def test_a_fall_between_points_that_lie_on_one_another_runs_no_way(along):
    """K is drawn on A, where its rope begins: no direction is against the way from A to K."""
    assert not {"E345", "W351"}.intersection(codes(COVERED.format(along=along)))
