"""Sines that vanish together: each of them alone would be a zero or a pole, and none is."""

import pytest

from hunt import looked_at
from hunted import Hunted, Made, made
from mechc.compilation import Compilation
from mechc.formula.to_text import text
from mechc.source import Source
from mechc.study.common_zeros import may_lie_flat

FLAT = """
param phi = -30 deg in -35 deg .. 30 deg
pivot O at (0 mm, 0 mm)
pivot Q at (150 mm, 0 mm)
link OA
link QBD
link AB
OA = 100 mm @ phi
AB = {coupler} mm
QB = 120 mm
QD = 150 mm @ QB
assembly ABQ cw
torque M on OA
force F at D along 90 deg
find k = M/F
"""

RHOMBUS = """
param phi = -30 deg in -70 deg .. 30 deg
pivot O at (0 mm, 0 mm)
pivot Q at (200 mm, 0 mm)
link OA
link QBD
link AB
OA = 200 mm @ phi
AB = 200 mm
QB = 200 mm
QD = 100 mm @ -QB
assembly ABQ ccw
link DS
slider S along x through Q
DS = 200 mm
assembly S back
actuator N between O and B
force F at S along x
find k = N/F
"""

KITE = """
param a = 50 mm
param b = 100 mm
param phi = 45 deg
drive phi from 40 deg to 105 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -b)
link OA
link AB
link QBD
link DS
OA = a @ phi
AB = a
QB = b
QD = a @ perp QB
DS = a
slider S along 30 deg through O
assembly ABQ cw
assembly S back
force F at S along x
torque M on OA
find k = M/F
"""


def conditions(description):
    """Return the conditions of zeros and poles, each with those it leaves out."""
    (result,) = Compilation(Source("m.mech", description)).results
    limits = (*result.zeros, *result.poles)
    return {text(limit.factor): {text(other) for other in limit.except_where} for limit in limits}


@pytest.mark.parametrize(("coupler", "is_flat"), [(130, True), (129, False)])
def test_angles_of_a_four_bar_that_may_lie_flat_vanish_together(coupler, is_flat):
    """Frame and crank are together as long as the others: at 0 degrees all lies on the x axis."""
    description = FLAT.format(coupler=coupler)
    pose = Compilation(Source("m.mech", description)).pose
    near = {"phi": 0.3, "len_OA": 0.1}
    assert [may_lie_flat(limit, near) for limit in pose.limits] == [is_flat]
    assert conditions(description)["sin(mu_B)"] == ({"sin(phi - phi_AB)"} if is_flat else set())


def test_what_loops_find_vanishes_with_what_is_given():
    """A crossed parallelogram passes the same pose; where sin(φ) is not zero, k vanishes."""
    crossed = FLAT.format(coupler=150).replace("QB = 120 mm", "QB = 100 mm")
    found = conditions(crossed)
    assert found["sin(phi - 2*phi_AQ)"] == {"sin(phi)"}
    assert found["cos(phi - 2*phi_AQ)"] == set()


def test_a_place_is_stated_once_where_half_angles_have_two_causes():
    """k = l₁(l₃ − l₂)/l₂ · tan 2t · sin t was said to vanish at t = 0° twice."""
    found = conditions(made("chain of equal links", 812120001).text)
    assert [*found] == ["sin(t)", "cos(t)", "l2 - l3", "cos(2*t)"]


def test_a_pole_is_not_stated_where_there_is_no_pose_and_another_sine_is_zero():
    """At 90 degrees the kite lies flat, and the rod DS does not reach its guide."""
    assert "cos(phi)" not in conditions(KITE)
    reaching = KITE.replace("DS = a", "DS = 4*a")
    assert "cos(phi)" not in conditions(reaching)


def test_what_is_on_one_line_in_a_pose_of_the_range_is_looked_for():
    """At 0 degrees the rod DS lies along its guide, and the cylinder OB along the crank."""
    found = conditions(RHOMBUS)
    assert found["sin(beta_DS + phi)"] == {"sin(phi - phi_OB)"}
    assert found["sin(phi - phi_OB)"] == {"sin(beta_DS + phi)"}
    assert found["cos(beta_DS)"] == set()


SLIDER = """
param a = 60 mm in 20 mm .. 150 mm
param alpha = 120 deg in 75 deg .. {high} deg
param beta = 45 deg
pivot A
link AB
AB = a @ 180 deg + beta
slider C along alpha + beta
link BC
BC = 100 mm @ 135 deg - alpha
torque P on AB
force F at C along alpha + beta
find k = P/F
"""


@pytest.mark.parametrize(("high", "meet"), [(210, True), (85, False)])
def test_sines_that_vanish_together_along_any_parameter_leave_each_other_out(high, meet):
    """The pole is stated at beta = 225 deg - 2 alpha; along alpha both are zero at 90 deg."""
    found = conditions(SLIDER.format(high=high).replace("120", "80"))
    sine, cosine = "sin(alpha + beta + pi/4)", "cos(2*alpha + beta + pi/4)"
    assert found[sine] == {cosine}  # its only place, be it outside the range
    assert found[cosine] == ({sine} if meet else set())


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["equal lengths", "shared lengths"])
@pytest.mark.parametrize("seed", range(40))
def test_nothing_that_is_said_of_loops_of_equal_lengths_is_refuted(kind, seed, tmp_path):
    found = looked_at(kind, Hunted(Made(made(kind, seed).text), seed, tmp_path))
    assert not found.refuted
