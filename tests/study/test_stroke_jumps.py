"""Along the stroke of a crank: where friction turns round and forces jump, and where they are zero.

The pin B of the slider alone has friction. There the rod AB turns round at 90 and 270 degrees, and
its force passes the friction circle on the other side: inclined to the rod by δ, sin δ = fd/(2l).
Nothing else jumps, and where the rod lies on the line of the slider the guide bears nothing.
"""

import math

import pytest

import mechc
from hunted import Hunted, made
from mechc.report.text.stroke import to_table
from mechc.study.stroke.jumps import changes_of_sign
from small_mechanisms import four_bar, slider_crank
from stroke_curves import refuted

F, R, L = 100.0, 0.05, 0.2
BETA, DELTA = math.asin(R / L), math.asin(0.2 * 0.04 / 2 / L)
ASKED = ("let F = 100 N", "find k = M/F", "find N_AB", "find N_B", "find R_O")
CRANK = slider_crank("friction pin B 0.2 diameter 40 mm", *ASKED)


@pytest.fixture(scope="module")
def mechanism():
    return mechc.loads(CRANK)


@pytest.fixture(scope="module")
def stroke(mechanism):
    return mechanism.stroke(3)


def of(found, name):
    return [one for one in found if one.result == name]


def test_a_force_jumps_where_the_slip_at_a_pin_turns_round(stroke):
    first, second = of(stroke.singular, "N_AB_f")
    assert [first.drive, second.drive] == pytest.approx([math.pi / 2, 3 * math.pi / 2])
    sides = [-F * math.cos(DELTA) / math.cos(BETA + s * DELTA) for s in (1, -1)]
    assert sorted(first.sides) == pytest.approx(sorted(sides))
    assert sorted(second.sides) == pytest.approx(sorted(sides))


def test_the_greatest_force_right_beside_a_jump_is_stated_as_an_extremum(mechanism, stroke):
    (jump, _) = of(stroke.singular, "N_AB_f")
    near = [e for e in of(stroke.extrema, "N_AB_f") if e.drive == jump.drive]
    assert {e.value for e in near} <= {*jump.sides}
    places = [math.radians(60 + 60 * i / 6000) for i in range(6001)]
    greatest = max(abs(mechanism.evaluate(phi=places)["N_AB_f"]))
    assert max(abs(e.value) for e in near) == pytest.approx(greatest, rel=1e-4)


def test_a_direction_has_no_extrema_at_places_looked_at_beside_its_jumps():
    """With friction in all pins of a crank-rocker R_C turns where a pin's slip turns round."""
    asked = "let T = 10 N*m", "find k = M/T", "find R_C", "friction pins 0.1 diameter 20 mm"
    stroke = mechc.loads(four_bar(*asked)).stroke(3)
    jumps = [jump.drive for jump in of(stroke.singular, "R_C_x_f")]
    turns = [turn.drive for turn in of(stroke.extrema, "R_C_direction_f")]
    beside = (0.0, *jumps, math.tau)
    assert jumps
    assert turns
    assert not [x for x in turns if any(abs(x - jump) < math.radians(0.75) for jump in beside)]


def test_a_force_is_zero_where_its_sense_changes(stroke):
    zeros = of(stroke.singular, "N_B")
    assert {z.value for z in zeros} == {"0"}
    assert [z.drive for z in zeros] == pytest.approx([0.0, math.pi, 2 * math.pi])
    assert "N_B = 0 at phi = 180 deg" in to_table(stroke)
    assert not of(stroke.singular, "N_AB")


def test_an_efficiency_is_greatest_where_the_one_joint_with_friction_rests(stroke):
    highest = [e for e in of(stroke.extrema, "eta_k") if e.kind == "maximum"]
    assert [e.drive for e in highest] == pytest.approx([math.pi / 2, 3 * math.pi / 2])
    assert [e.value for e in highest] == pytest.approx([1.0, 1.0])


def test_places_that_lie_close_together_refute_nothing(mechanism, stroke):
    assert list(refuted(mechanism._compilation, stroke)) == []


def test_a_jump_at_an_end_of_the_stroke_is_none_on_the_way():
    half = mechc.loads(CRANK.replace("from 0 deg to 360 deg", "from 90 deg to 200 deg"))
    assert not of(half.stroke(3).singular, "N_AB_f")


def test_a_sign_of_what_is_nothing_but_rounding_changes_too_often_to_be_followed():
    grid = [i / 100 for i in range(201)]
    signs = lambda x: (math.sin(1e5 * x), x - 1.234)  # noqa: E731
    assert list(changes_of_sign(signs, grid)) == [pytest.approx(1.234)]


def test_a_kink_where_friction_turns_round_stands_beside_a_turn(tmp_path):
    """k_f1 has a maximum at -0.08416, and a kink at -0.07973 in the next of 720 cells."""
    found = Hunted(made("small with friction", 161000078), 161000078, tmp_path)
    places = [e.drive for e in of(found.stroke.extrema, "k_f1")]
    assert places[:2] == pytest.approx([-0.0841646, -0.0797332], abs=1e-6)
    assert list(refuted(found.compilation, found.stroke)) == []


def test_an_efficiency_jumps_where_the_ratio_does_however_steep_it_is(tmp_path):
    """A distance passes zero, and the force along it turns round, close to the end of a loop."""
    hunted = Hunted(made("closed with friction", 98200011), 98200011, tmp_path)
    jumps = [one for one in hunted.compilation.stroke(3).singular if one.kind == "jump"]
    assert {one.result for one in jumps} == {"k", "k_f", "k_f1", "k_hold", "eta_k"}
    assert [one.drive for one in jumps] == pytest.approx([jumps[0].drive] * 5, abs=1e-9)


def test_a_telescope_passes_length_zero_without_a_turn_of_its_pin(tmp_path):
    """It lies along its slot: the slip of one pin is zero, next to length zero but for rounding."""
    found = Hunted(made("small with friction", 156002017), 156002017, tmp_path)
    stroke = found.stroke
    zero, other = of(stroke.singular, "k"), of(stroke.singular, "k_f1")
    assert len(zero) == 1
    assert [one.drive for one in other] == [one.drive for one in zero]
    assert other[0].sides == pytest.approx((0.042992412, -0.041763342), abs=2e-9)
    jammed = [(s.low, s.high) for s in of(stroke.standstills, "k_f")]
    assert len(jammed) == 2
    assert [jammed[0][1], jammed[1][0]] == pytest.approx([zero[0].drive] * 2)


def test_a_turn_in_the_cell_next_to_a_jam_is_stated(tmp_path):
    found = Hunted(made("small with friction", 156002017), 156002017, tmp_path)
    least = [e.drive for e in of(found.stroke.extrema, "k_f")]
    assert least == pytest.approx([-0.49306, -0.48614], abs=2e-4)


ARC = """
param phi = 30 deg
drive phi from -30 deg to 120 deg
pivot O at (0 mm, 0 mm)
pivot Q at (50 mm, 50 mm)
link OA
link QCD
OA = 50 mm @ phi
QC = 50 mm
slot A in QCD about C radius 50 mm
QD = 50 mm @ perp QC
assembly ACQ ccw
friction contact A 0.1
force F at D along -x
torque M on OA
find k = M/F
"""


def test_an_efficiency_jumps_where_drive_and_load_change_places():
    """The load is square to the velocity of D at 60 deg: k and k_f pass 0, and no slip does."""
    mechanism = mechc.loads(ARC)
    (jump,) = of(mechanism.stroke(3).singular, "eta_k")
    assert jump.drive == pytest.approx(math.pi / 3, abs=1e-9)
    beside = mechanism.evaluate(phi=[jump.drive + side * 1e-7 for side in (-1, 1)])["eta_k"]
    assert jump.sides == pytest.approx(tuple(beside), rel=1e-6)
    assert jump.sides[0] - jump.sides[1] == pytest.approx(0.0024, abs=1e-4)


def test_a_row_has_0_with_friction_where_that_only_multiplies_a_zero():
    """At 60 deg, too; what rounding left of k was 0 and what it left of k_f 1.7e-17 m."""
    stroke = mechc.loads(ARC).stroke(11)
    row = dict(zip((c.name for c in stroke.columns), stroke.rows[6].values, strict=True))
    assert (row["k"], row["k_f"], row["k_hold"]) == (0.0, 0.0, 0.0)
