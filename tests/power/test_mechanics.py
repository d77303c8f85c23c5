"""What a mechanical engineer would notice: small mechanisms, one trap each."""

import math

import pytest

import mechc
from good_mechanisms import ALL
from mechanisms import sample
from mechc.diagnostics import MechcError
from mechc.formula.to_text import text
from mechc.report.kinds import StepRule

TIED = """
param a = 100 mm
param b = 80 mm
param f = 0.3
param alpha = 30 deg
pivot O
slider C along x
link AOB
link BC
OA = a @ 90 deg + alpha
OB = b @ alpha - 90 deg
BC = @ 10 deg
force P at A along -x
force N at C along -x
force T = f*N at B along y
"""

LADDER = """
param l = 100 mm
param m = 60 mm
param theta = 35 deg
slider A along x
slider B along y
link ACB
AB = l @ 180 deg - theta
AC = m @ 180 deg - theta
"""

CRANK = """
param a = 50 mm
param l = 150 mm
param alpha = 30 deg
param beta = asin(a/l*sin(alpha))
pivot O
link OA
link AB
OA = a @ alpha
AB = l @ -beta
torque M on OA
force F at B along x
find k = M/F
"""

OBLIQUE = """
param x = 60 mm
param y = 50 mm
param g = 70 deg
param b = 30 mm
param c = 20 mm
pivot O
link OAB
link BD
slider D along 20 deg
OA = (x, y)
angle AOB = g
OB = b
BD = @ OA
force F at D along 20 deg
"""


def solve(body):
    return mechc.loads("mechanism trap\n" + body, "trap.mech")


def k(solved, name="k"):
    return text(solved.results[name].formula)


def codes(body):
    with pytest.raises(MechcError) as caught:
        solve(body)
    return [d.code for d in caught.value.diagnostics if d.code[0] == "E"]


# ------------------------------------------------------------------------ tied loads


def test_a_ratio_may_be_of_a_tied_load():
    solved = solve(TIED + "find k = T/P\nfind q = P/T\nfind z = T/N\nfind w = P/N")
    values = {n: float(v) for n, v in solved.evaluate().items()}
    assert values["k"] == pytest.approx(1 / values["q"])
    assert values["k"] == pytest.approx(0.3 / values["w"])
    assert k(solved, "z") == "f"


DRAWN_LEVER = """
pivot O at (0 mm, 0 mm)
link AOB
A at (-100 mm, 0 mm)
B at (60 mm, 10 mm)
force P at A along -y
"""


def test_tied_loads_may_balance_by_drawn_places():
    """The arms are 100 and 60 mm but for rounding; with friction nothing moves them."""
    tied = DRAWN_LEVER + "force F = P/0.6 at B along -y\nfind k = P/F\n"
    assert mechc.loads(tied).evaluate()["k"] == pytest.approx(0.6)
    with pytest.raises(MechcError) as caught:
        mechc.loads(tied + "friction pins 0.1 diameter 10 mm\n")
    assert [d.code for d in caught.value.diagnostics] == ["E545"]


def test_a_spread_load_may_act_about_its_pivot():
    """From 2 to -1 N/mm over OB: its resultant is at O, and P has nothing to balance."""
    load = "load Q intensity 2 N/mm to -1 N/mm on OB along -y\nfind P\nfind R_O\n"
    found = mechc.loads(DRAWN_LEVER + load).evaluate()
    assert found["P"] == pytest.approx(0.0, abs=1e-9)
    assert found["R_O_y"] == pytest.approx(500 * math.hypot(0.06, 0.01))


def test_a_load_with_others_tied_to_it_need_not_stand_still_where_k_is_zero():
    (zero,) = solve(TIED + "find k = P/N").results["k"].zeros
    assert zero.cause == "other"


def test_a_second_motion_that_no_load_holds():
    body = """
    param a = 10 mm
    param p = 20 deg
    param q = 70 deg
    pivot O
    link OA
    link AB
    OA = a @ p
    AB = a @ q
    torque M on OA
    force F at B along x
    find k = M/F
    """
    assert codes(body) == ["E503"]


@pytest.mark.parametrize(
    "loads",
    ["torque N on QB\nfind k = M/N", "force N at B along -x\nfind k = N/M"],
)
def test_a_torque_has_no_arrow_to_turn(loads):
    body = """
    param a = 10 mm
    param alpha = 60 deg
    pivot O
    pivot Q
    link OA
    link AB
    link QB
    OA = a @ alpha
    QB = a @ alpha + 20 deg
    AB = @ 5 deg
    torque M on OA
    """
    solved = solve(body + loads)
    assert solved.evaluate()["k"] < 0
    assert "W502" not in {w.code for w in solved.warnings}


@pytest.mark.parametrize(
    ("stroke", "wrong"), [("20 deg to 80 deg", True), ("20 deg to 160 deg", False)]
)
def test_no_arrow_is_wrong_where_the_ratio_changes_its_sign_along_the_stroke(stroke, wrong):
    solved = solve(
        f"""
    param a = 10 mm
    param phi = 60 deg
    pivot O at (0 mm, 0 mm)
    link OA
    OA = a @ phi
    drive phi from {stroke}
    force P at A along x
    force F at A along -y
    find k = P/F
    """
    )
    assert solved.evaluate(phi=1.0)["k"] * solved.evaluate(phi=2.0)["k"] < 0
    assert ("W502" in {w.code for w in solved.warnings}) == wrong


# ---------------------------------------------------------------------------- speeds


def test_the_speed_of_a_ladder_s_rung():
    solved = solve(LADDER + "find v = V_C/V_A\nfind w = V_A/V_C")
    values = {n: float(v) for n, v in solved.evaluate(theta=2.5).items()}
    assert values["v"] > 0
    assert values["v"] * values["w"] == pytest.approx(1)
    assert solved.evaluate(m=0.1)["v"] == pytest.approx(1.4281480067)  # C at B: cot(theta)


def test_a_speed_about_a_pivot_is_positive_counter_clockwise_below_it_too():
    solved = solve("""
    param y = -40 mm
    pivot O
    link OA
    link AD
    slider D along x
    OA = (0 mm, y)
    AD = @ 20 deg
    find v = V_A/V_D
    """)
    assert k(solved, "v") == "1"


# ------------------------------------------------------------------------ directions


@pytest.mark.parametrize("guide", ["slider B along x through O", "slider B along x\nOB = @ 0 deg"])
def test_an_angle_may_be_defined_so_that_the_loop_closes(guide):
    solved = solve(CRANK + guide)
    assert k(solved) == "a*sin(alpha + beta)/cos(beta)"


@pytest.mark.parametrize("wrong", ["0.97*a/l*sin(alpha)", "a/l*sin(30 deg)"])
def test_a_definition_that_does_not_close_the_loop_is_stated(wrong):
    body = CRANK.replace("a/l*sin(alpha)", wrong) + "slider B along x through O"
    assert codes(body)[0] in {"E303", "E304"}


def test_a_vector_of_two_components_has_a_direction():
    solved = solve(OBLIQUE + "force P at A along perp OA\nfind k = P/F")
    assert k(solved) == "b*sin(g)/(len_OA*cos(phi_OA - pi/9))"
    where = {d.name: text(d.formula) for d in solved.results["k"].where}
    assert where == {"phi_OA": "atan2(y, x)", "len_OA": "hypot(x, y)"}


def test_the_direction_of_a_sum_of_vectors():
    """A force along the line from the pivot does no work, one across it has the full arm."""
    body = OBLIQUE.replace("OAB", "OABC") + "BC = c @ OA\nforce P at C along perp OC\n"
    solved = solve(body + "force Q at C along OC\nfind k = P/F")
    assert k(solved) == "b*sin(g)/(len_OC*cos(phi_OA - pi/9))"
    assert [d.code for d in solved.warnings] == ["W501"]


def test_the_direction_of_a_sum_of_open_vectors_is_open():
    body = OBLIQUE.replace("OAB", "OABC") + "BC = @ OA\nforce P at C along OC\nfind k = P/F"
    assert codes(body) == ["E305"]


# ------------------------------------------------------------------ zeros, derivation


def test_a_constant_never_vanishes():
    solved = solve(TIED.replace("force T", "# force T") + "find k = P/N")
    result = solved.results["k"]
    assert [text(v.factor) for v in (*result.zeros, *result.poles)] == [
        "cos(alpha - pi/18)",
        "cos(alpha)",
    ]


def test_a_pole_at_which_the_sum_above_vanishes_too_is_none():
    """M balances F on its rod: cos(theta) + sin(theta - alpha) and cos(alpha) share a half."""
    path = ALL["mirror_beam_torque"]
    result = mechc.load(path).results["k"]
    assert text(result.formula) == "b*cos(alpha/2 - theta + pi/4)/(2*sin(alpha/2 + pi/4))"
    assert [text(v.factor) for v in result.poles] == ["sin(alpha/2 + pi/4)"]


def test_a_long_sum_by_a_name_may_vanish():
    result = mechc.loads(sample(49216).text, "random.mech").results["k"]
    (named,) = result.where
    assert named.name in {text(zero.factor) for zero in result.zeros}


def test_projection_on_a_side_of_a_ternary_link_is_called_so():
    rules = [s.rule for s in mechc.loads(TERNARY, "ternary.mech").derivation.steps]
    assert StepRule.PROJECTION in rules[:2]


def test_speeds_alone_need_no_power_equation():
    assert solve(LADDER + "find v = V_B/V_A").derivation.balances == ()


TERNARY = """mechanism ternary
param a = 80 mm
param b = 100 mm
param c = 60 mm
param t1 = 60 deg
param t2 = 10 deg
param t3 = 50 deg
param t4 = 5 deg
param t5 = 40 deg
param u1 = 95 deg
param u2 = 80 deg
pivot O
pivot Q
pivot R
slider G along x
link OA
link ABC
link BQ
link CDE
link DR
link EG
OA = a @ t1
AB = b @ t2
AC = c @ t3
BQ = @ u1
CD = b @ t4
CE = c @ t5
DR = @ u2
EG = @ -30 deg
torque M on OA
force F at G along x
find k = M/F
"""
