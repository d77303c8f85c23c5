"""What results come to beside a default pose in which a slip is zero for once, by hand."""

import math

import pytest

import mechc
from mechc.compilation import compile_source
from mechc.formula.tree import ONE, ZERO, Call, Power, Symbol, number, product, total
from mechc.friction.at_rest import limits, values_nearby
from mechc.friction.tolerances import NEAR_POSE
from mechc.model.result import Definition, Result
from mechc.source import Source
from mechc.units import NUMBER

CRANK = """mechanism crank
param phi = 0 deg
pivot O
link OA
OA = 1 m @ 40 deg + phi
force P at A along x
force F at A along y
find k = P/F
"""
SENSE = Definition("s", Call("sense", (Symbol("phi"), ONE)))
"""The sense of a slip that has the sign of the drive's angle."""


def found(formula, where=(SENSE,), drive="drive phi\n", text=CRANK):
    pose = compile_source(Source("crank.mech", text + drive)).pose
    return limits(Result("k_f", None, NUMBER, formula, where), pose)


def test_a_result_that_jumps_has_both_sides():
    assert found(Symbol("s")) == pytest.approx((-1.0, 1.0))


def test_one_that_does_not_has_one_limit():
    """Friction goes by the square of its sense: at the pose alone there is none of it."""
    assert found(Power(Symbol("s"), number(2))) == pytest.approx((1.0,))


def test_what_goes_to_zero_has_no_limit_that_is_rounding():
    odd = product([(Symbol("s"), 1), (Symbol("phi"), 1)])
    assert found(odd) == (0.0,)


def test_a_side_on_which_nothing_balances_has_no_value():
    assert found(Call("sqrt", (Symbol("s"),))) == pytest.approx((float("nan"), 1.0), nan_ok=True)


def test_without_a_drive_the_sides_are_those_of_an_angle():
    assert found(Symbol("s"), drive="") == pytest.approx((-1.0, 1.0))
    assert found(Power(Symbol("s"), number(2)), drive="") == pytest.approx((1.0,))


def test_a_sense_may_be_a_part_of_coupled_equations():
    inside = Definition("d", product([(number(2), 1), (SENSE.formula, 1)]))
    assert found(Symbol("d"), (inside,)) == pytest.approx((-2.0, 2.0))


def test_friction_of_coupled_equations_is_the_limit_too_where_a_slot_turns_back():
    """At 90 degrees k is 0, and k_f is found by iteration: it was 0.2024096 there."""
    lever = mechc.loads("""
param a = 50 mm
param phi = 90 deg
drive phi from 85 deg to 95 deg
pivot O at (0 mm, 0 mm)
pivot Q at (0 mm, -a)
link OA
link QSD
OA = a @ phi
slot A in QS
assembly A forward
QD = a @ perp QS
friction contact A 0.1
friction pins 0.1 diameter 8 mm
force F at D along -x
torque M on OA
find k = M/F
""")
    beside = lever.evaluate(phi=[math.pi / 2 - 1e-7, math.pi / 2 + 1e-7])["k_f"]
    k_f = lever.results["k_f"]
    assert k_f.default == pytest.approx(sum(beside) / 2, rel=1e-8)
    assert k_f.default != pytest.approx(lever.evaluate()["k_f"], rel=1e-6)
    assert k_f.sides == (k_f.default,)
    (curve,) = lever.plot(y=["k_f"]).plot.curves
    (mark,) = (m for m in curve.marks if m.kind == "default")
    assert mark.at.y == pytest.approx(k_f.default, rel=1e-8)


def test_beyond_the_range_of_what_moves_a_slip_there_is_no_side():
    ranged = CRANK.replace("= 0 deg\n", "= 0 deg in 0 deg .. 9 deg\n")
    assert found(Symbol("s"), drive="", text=ranged) == pytest.approx((1.0,))


def test_of_the_limits_along_several_parameters_there_are_the_least_and_the_greatest():
    """Along a length the slip has no other sense than along the angle, but its result has."""
    ranged = CRANK.replace("1 m @", "l @").replace("pivot", "param l = 1 m in 1 m .. 2 m\npivot")
    both = total([Symbol("phi"), Symbol("l"), number(-1)])
    where = (Definition("s", Call("sense", (both, ONE))),)
    jumping = total([Symbol("s"), Call("sign", (total([Symbol("l"), number(-1)]),))])
    assert found(jumping, where, "", ranged) == pytest.approx((-1.0, 2.0))
    assert found(Call("sqrt", (jumping,)), where, "", ranged)[1:] == pytest.approx((2.0**0.5,))


def test_there_is_nothing_to_be_said_without_a_slip_that_moves():
    assert found(Symbol("phi"), where=()) == ()
    assert found(Symbol("s"), where=(Definition("s", Call("sense", (ZERO, ONE))),)) == ()


def test_beside_the_pose_the_parameter_is_moved_by_which_a_slip_has_a_sense():
    pose = compile_source(Source("crank.mech", CRANK + "drive phi\n")).pose
    moved = values_nearby(Result("k_f", None, NUMBER, Symbol("s"), (SENSE,)), pose)
    assert {name: abs(x) for name, x in moved.items()} == {"phi": NEAR_POSE}
    assert not values_nearby(Result("k_f", None, NUMBER, Symbol("phi"), ()), pose)
