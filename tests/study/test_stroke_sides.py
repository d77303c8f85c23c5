"""Rows, intervals and sentences at the dead centres of a crank with friction, against code.

At a dead centre of the drive, one motion jams and the other does not; at one of the load,
friction comes to one value from either side. Code is asked beside the dead centre: at the
rounded angle it takes whichever side rounding has put it on.
"""

import math

import pytest

import mechc
from mechc.cli.main import main
from small_mechanisms import lifter, slider_crank, slotted_lever
from sources import in_thirds

CRANK = slider_crank("friction pins 0.12 diameter 20 mm", "friction slider B 0.1")
BESIDE = 1e-7


def stated(text, tmp_path, capsys, *command):
    path = tmp_path / "m.mech"
    path.write_text(text, encoding="utf-8")
    assert main([*command, str(path)]) == 0
    return capsys.readouterr().out


def rows(ratio):
    mechanism = mechc.loads(f"{CRANK}find k = {ratio}")
    stroke = mechanism.stroke(points=9)
    names = [c.name for c in stroke.columns]
    return mechanism, stroke, [dict(zip(names, row.values, strict=True)) for row in stroke.rows]


@pytest.mark.parametrize("ratio", in_thirds(["M/F", "F/M"]))
def test_a_row_is_what_code_comes_to_on_both_sides_or_undetermined(ratio):
    mechanism, stroke, values = rows(ratio)
    for row, found in zip(stroke.rows, values, strict=True):
        sides = [mechanism.evaluate(phi=row.drive + s * BESIDE) for s in (-1, 1)]
        for name in ("k_f", "k_hold", "eta_k"):
            low, high = sorted(float(side[name]) for side in sides)
            if math.isnan(low + high) or high - low > 1e-5 * max(abs(low), abs(high)):
                assert name in row.undetermined
            else:
                assert low - 1e-6 * abs(low) <= found[name] <= high + 1e-6 * abs(high)


@pytest.mark.parametrize("ratio", in_thirds(["M/F", "F/M"]))
def test_no_dead_centre_is_in_a_stuck_interval(ratio, tmp_path, capsys):
    _, stroke, _ = rows(ratio)
    ends = {end for s in stroke.standstills for end in (s.low, s.high)}
    dead = [row.drive for row in stroke.rows[::4]]
    assert all(any(math.isclose(d, e, abs_tol=1e-12) for e in ends) for d in dead)
    table = stated(f"{CRANK}find k = {ratio}", tmp_path, capsys, "stroke", "-n", "9")
    assert not any(line.endswith(("locked", "jammed")) for line in table.splitlines()[1:10])
    sentences = stated(f"{CRANK}find k = {ratio}", tmp_path, capsys, "check")
    kind = "F alone cannot move" if ratio == "M/F" else "no force F can move"
    assert sentences.count(kind) == 4
    assert "for 0 deg < phi <= 2.751 deg." in sentences
    assert "for 357.2 deg <= phi < 360 deg." in sentences


def test_a_default_pose_at_a_dead_centre_has_no_state_but_intervals():
    at_rest = CRANK.replace("phi = 60 deg", "phi = 180 deg")
    k_f = mechc.loads(f"{at_rest}find k = M/F").results["k_f"]
    assert k_f.locking is not None
    assert k_f.locking.state is None
    assert len(k_f.locking.reaches[0].stretches) == 2


def test_an_efficiency_of_what_is_zero_throughout_is_zero_in_every_row():
    """B lies on O, so that QBD stands still: m is 0 but for rounding, of either sign."""
    kite = mechc.loads("""
param phi = 40 deg in 20 deg .. 100 deg
param a = 100 mm
param c = 150 mm
drive phi
pivot O at (0 mm, 0 mm)
pivot Q
link OA
link QBD
link AB
OQ = c @ 0 deg
OA = a @ phi
AB = 100 mm
QB = 150 mm
QD = 100 mm @ -QB
assembly ABQ ccw
torque M on OA
force F at D along y
friction pins 0.1 diameter 10 mm
find m = M/F
""")
    stroke = kite.stroke(points=9)
    place = [column.name for column in stroke.columns].index("eta_m")
    assert [row.values[place] for row in stroke.rows] == [0.0] * 9


SLOT = slotted_lever()


@pytest.mark.parametrize("name", ["k_f", "k_hold", "eta_k"])
def test_what_has_one_limit_where_a_slip_is_zero_for_once_has_that_value(name):
    """Friction has no sense there in code, and its value is the limit of neither side."""
    mechanism = mechc.loads(SLOT)
    stroke = mechanism.stroke(points=3)
    row = stroke.rows[1]
    before, here, after = (
        float(mechanism.evaluate(phi_CA=row.drive + step)[name]) for step in (-1e-9, 0, 1e-9)
    )
    assert before == pytest.approx(after, rel=1e-7) != pytest.approx(here, rel=1e-3)
    column = [c.name for c in stroke.columns].index(name)
    assert row.values[column] == pytest.approx(before, rel=1e-7)
    extrema = [e for e in stroke.extrema if e.result == name and abs(e.drive - row.drive) < 1e-3]
    assert [e.value for e in extrema] == [pytest.approx(before, rel=1e-7)]


WEDGE = lifter("drive phi from -3 deg to 3 deg")
"""A contact on the line of centres, in the middle of its stroke."""


def test_what_jumps_where_a_slip_is_zero_for_once_is_undetermined_there():
    mechanism = mechc.loads(WEDGE)
    stroke = mechanism.stroke(points=3)
    assert stroke.rows[1].undetermined == ("k_f", "k_hold", "eta_k")
    before, after = (float(mechanism.evaluate(phi=s * 1e-9)["eta_k"]) for s in (-1, 1))
    (jump,) = (s for s in stroke.singular if s.result == "eta_k")
    assert jump.sides == pytest.approx((before, after), rel=1e-6)


def test_an_extremum_that_a_jump_has_on_one_side_is_called_so(tmp_path, capsys):
    table = stated(WEDGE, tmp_path, capsys, "stroke", "-n", "3")
    assert "eta_k has a maximum 0.952981 beside its jump at phi = 0 deg" in table


def test_an_efficiency_at_a_single_pose_is_no_stretch(tmp_path, capsys):
    """Without friction at the contact it would be in the usual range at 0 degrees alone."""
    sentences = stated(WEDGE, tmp_path, capsys, "check")
    assert "eta_k runs from" in sentences
    assert "0 deg <= phi <= 0 deg" not in sentences


def test_of_the_drawn_pose_the_limit_is_stated_or_that_it_jumps(tmp_path, capsys):
    one = stated(SLOT, tmp_path, capsys, "check")
    assert one.count("the value is the limit as these values are approached") == 3
    two = stated(WEDGE, tmp_path, capsys, "check")
    assert two.count("    jumps from ") == two.count("the result jumps") == 3


def test_of_the_drawn_pose_nothing_is_said_over_ranges_but_of_the_drive(tmp_path, capsys):
    """Along an angle of the drawing the contact would be without friction all the while."""
    ranged = WEDGE.replace("param phi", "param alpha = 12 deg in 4 deg .. 25 deg\nparam phi")
    ranged = ranged.replace("168 deg", "180 deg - alpha")
    sentences = stated(ranged, tmp_path, capsys, "check")
    assert "<= phi <=" in sentences
    assert "<= alpha <=" not in sentences
    beside = stated(ranged.replace("phi = 0", "phi = 1"), tmp_path, capsys, "check")
    assert "<= alpha <=" in beside


@pytest.mark.parametrize("ends", ["", " in -3 deg .. 3 deg"])
def test_without_a_drive_an_angle_has_the_sides_that_it_has_as_the_drive(ends):
    driven = mechc.loads(WEDGE)
    free = WEDGE.replace("drive phi from -3 deg to 3 deg\n", "").replace(
        "0 deg\n", f"0 deg{ends}\n"
    )
    for name in ("k_f", "k_hold", "eta_k"):
        assert mechc.loads(free).results[name].sides == driven.results[name].sides != ()


def test_without_a_drive_nothing_is_said_over_ranges_that_leave_the_slip_zero(tmp_path, capsys):
    ranged = WEDGE.replace("drive phi from -3 deg to 3 deg\n", "").replace(
        "param phi = 0 deg",
        "param alpha = 12 deg in 4 deg .. 25 deg\nparam phi = 0 deg in 0 deg .. 3 deg",
    )
    ranged = ranged.replace("168 deg", "180 deg - alpha")
    sentences = stated(ranged, tmp_path, capsys, "check")
    assert "<= phi <=" in sentences
    assert "<= alpha <=" not in sentences
    assert "the value is the limit as these values are approached" in sentences
