"""Where results are least, greatest or infinite along a stroke, beside jams, and what is 0/0."""

import math

import numpy as np
import pytest

import mechc
from hunted import made
from mechc.formula.evaluate import evaluate
from mechc.formula.numeric.rounding import Rounding
from mechc.formula.tree import Call, Power, Product, Symbol, number, product, total
from mechc.study.stroke.extrema import with_values
from mechc.study.stroke.removable import RemovableSingularities
from small_mechanisms import slider_crank


def of(stroke, name):
    return [one for one in stroke.extrema if one.result == name]


def test_parts_on_which_a_result_has_values_end_where_it_has_none():
    grid = [0.0, 1.0, 2.0, 3.0, 4.0]
    assert [*with_values(grid, lambda _: 1.0)] == [grid]
    assert not [*with_values(grid, lambda _: math.nan)]
    (part,) = with_values(grid, lambda x: 1.0 if x > 1.5 else math.nan)
    inner = [2, 3, 3.53, 3.77, 3.9, 3.99, 4]
    assert part == pytest.approx([1.5, 1.51, 1.6, 1.73, 1.97, *inner], abs=1e-9)
    (island,) = with_values(grid, lambda x: 1.0 if abs(x - 1) < 0.25 else math.nan)
    beside = [0.75, 0.76, 0.78, 0.85, 0.98]
    assert island == pytest.approx([*beside, 1, *(2 - x for x in reversed(beside))], abs=1e-9)


JAMMED = """
param r = 50 mm
param phi = 0.5488 rad
pivot O at (0 mm, 0 mm)
link OA
OA = r @ phi
slot T in OA
pivot G at (27.922 mm, -72.803 mm)
slider T along 1.35167 rad through G
telescope AT
torque M on OA
actuator F between A and T
find k = M / F
drive phi from 0.2988 rad to 0.7988 rad
friction pins 0.004 diameter 6 mm
friction contact T 0.0048
"""


def test_a_result_that_turns_in_the_cell_next_to_a_jam_has_an_extremum():
    """It jams up to 0.31366 rad, and k_hold is greatest 0.0006 beyond: a cell is 0.0007."""
    mechanism = mechc.loads(JAMMED)
    places = [0.3138 + 1e-5 * i for i in range(100)]
    found = mechanism.evaluate(phi=places)["k_hold"]
    greatest = max(range(100), key=lambda i: found[i])
    assert 0 < greatest < 99
    tops = [e for e in of(mechanism.stroke(3), "k_hold") if e.drive > 0.3137]
    assert [(e.kind, e.drive, e.value) for e in tops] == [
        (
            "maximum",
            pytest.approx(places[greatest], abs=1e-5),
            pytest.approx(found[greatest], rel=1e-6),
        )
    ]


def test_the_cell_next_to_a_jam_is_looked_at_closely_whatever_places_are_at_its_end():
    """It jams up to 0.5, and a place of the grid is one millionth beyond."""
    grid = [0.0, 0.4, 0.5 + 1e-6, 0.8, 1.2]
    (part,) = with_values(grid, lambda x: x if x >= 0.5 else math.nan)
    assert part[0] == pytest.approx(0.5, abs=1e-9)
    assert part[-1] == 1.2
    close = [x for x in part if 0.501 < x < 0.8]
    assert close == pytest.approx([0.504, 0.54, 0.592, 0.688])


SQUARE = """
param phi = 75 deg
drive phi from {} to {}
pivot O at (0 mm, 0 mm)
link OA
link AK
slider K along y through O
OA = 50 mm @ phi
AK = 90 mm
assembly K {}
load F intensity 2 N/mm on OA along -y
force M at K along y
find k = M/F
"""
"""A crank that is square to its slider's line at 90 deg: neither load moves, and k runs on."""


@pytest.mark.parametrize(("low", "high"), [("30 deg", "150 deg"), ("60 deg", "141 deg")])
@pytest.mark.parametrize(
    ("side", "kind", "value"), [("back", "maximum", 9 / 8), ("forward", "minimum", 9 / 28)]
)
def test_a_result_may_turn_where_its_formula_is_undetermined(low, high, side, kind, value):
    """k = l/(2(l - r)) or l/(2(l + r)) there; rounding of 0/0 put the turn beside, or at once two.

    In the first stroke 90 deg is among the places looked at, in the second one it lies between.
    """
    stroke = mechc.loads(SQUARE.format(low, high, side)).stroke(3)
    (turn,) = stroke.extrema
    assert turn.kind == kind
    assert turn.drive == pytest.approx(math.pi / 2, abs=1e-8)
    assert turn.value == pytest.approx(value, rel=1e-10)
    assert not stroke.singular


X = Symbol("x")


def over_zero(formula):
    """Return the places at which a formula times sin x/sin x is 0/0, on a stroke of 0.6."""
    zero = Call("sin", (X,))
    whole = Product((zero, formula, Power(zero, number(-1))))

    def at(x):
        try:
            return evaluate(whole, {"x": x})
        except ZeroDivisionError:
            return math.nan

    return RemovableSingularities(at, lambda x: Rounding({"x": x}).of(whole).error, 0.6)


GRID = [-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3]


def test_places_at_which_a_formula_alone_is_undetermined_are_left_out():
    places = over_zero(total([number(2), X]))
    assert places.is_one(0.0)
    assert not places.is_one(0.1)
    assert places.left_out(GRID) == [x for x in GRID if x]
    assert places.turning(0.0) is None
    assert (places.value(0.0), places.value(0.1)) == (pytest.approx(2.0, rel=1e-12), None)


def test_beside_such_a_place_a_result_turns_where_it_does_from_both_sides():
    places = over_zero(total([number(2), product([(total([X, number("-1e-4")]), 2)])]))
    assert places.turning(0.0) == pytest.approx((1e-4, 2.0), abs=1e-9)
    assert places.turning(0.1) is None


@pytest.mark.parametrize("function", ["abs", "sign"])
def test_a_pole_a_kink_or_a_jump_is_no_such_place(function):
    assert not over_zero(total([number(2), Call(function, (X,))])).is_one(0.0)
    assert not over_zero(Power(X, number(-1))).is_one(0.0)


def test_in_the_row_of_such_a_place_is_the_value_from_both_sides():
    stroke = mechc.loads(SQUARE.format("30 deg", "150 deg", "back")).stroke(3)
    row = dict(zip((c.name for c in stroke.columns), stroke.rows[1].values, strict=True))
    assert row["k"] == pytest.approx(9 / 8, rel=1e-10)
    assert "k" not in stroke.rows[1].undetermined


TOGGLE = """
param phi = 135 deg
drive phi from 75 deg to 140 deg
pivot O at (0 mm, 0 mm)
link OA
link AK
slider K along y through O
OA = 50 mm @ phi
AK = 50 mm
assembly K forward
friction pins 0.1 diameter 8 mm
load F intensity 2 N/mm on OA along -y
force M at K along y
find k = M/F
"""
"""Equal links, the first of which bears a load: k is 1/4 where both are square to the line."""


def test_what_friction_makes_infinite_to_first_order_alone_is_stated():
    """Friction in the pins takes 3fd/(8r sin 2 phi), which is infinite at 90 deg."""
    (pole,) = mechc.loads(TOGGLE).stroke(3).singular
    assert (pole.result, pole.value, pole.kind) == ("k_f1", "infinite", "other")
    assert pole.drive == pytest.approx(math.pi / 2, abs=1e-12)


def test_what_is_infinite_without_friction_is_stated_once():
    """A slider drives its crank over both dead centres."""
    text = slider_crank("friction pin B 0.2 diameter 40 mm", "find k = F/M")
    poles = [s for s in mechc.loads(text).stroke(3).singular if s.value == "infinite"]
    assert {s.result for s in poles} == {"k"}


def test_where_a_load_is_infinite_is_stated():
    """A cylinder holds a weight on a crank; at 60 deg its line passes through the pivot."""
    text = """
drive phi from 20 deg to 100 deg
param phi = 30 deg
pivot O at (0 mm, 0 mm)
pivot Q at (50 mm, 86.60254037844386 mm)
link OA
telescope QA
OA = 40 mm @ phi
actuator N between Q and A
weight W mass 5 kg at A
find N
"""
    (pole,) = mechc.loads(text).stroke(3).singular
    assert (pole.result, pole.value) == ("N", "infinite")
    assert pole.drive == pytest.approx(math.radians(60), abs=1e-9)


GEARED = """
param phi = 90 deg
drive phi from 30 deg to 95 deg
pivot O at (0 mm, 0 mm)
pivot Q at (50 mm, 0 mm)
link OA
link QB
link BC
OA = 60 mm @ phi
QB = 60 mm @ 90 deg - phi
BC = 120 mm
slider C along y through O
gear O 25 mm, Q 25 mm
assembly C back
friction gear O 0.03
friction slider C 0.1
force F at C along 30 deg
torque M on OA
find k = M/F
"""
"""A slider-crank behind a pair of gears: the guide is pressed anew where BC is along the load."""


@pytest.fixture(scope="module")
def geared():
    return mechc.loads(GEARED)


def test_an_efficiency_is_greatest_at_a_kink_where_the_force_on_a_guide_turns_round(geared):
    """sin 60 deg = (sin phi + 5/6)/2: the sign of what presses it is but rounding there."""
    (top, _) = of(geared.stroke(3), "eta_k")
    assert (top.kind, top.drive) == (
        "maximum",
        pytest.approx(math.asin(math.sqrt(3) - 5 / 6), abs=1e-9),
    )
    sides = geared.evaluate(phi=[top.drive - 1e-6, top.drive + 1e-6])["eta_k"]
    assert top.value == pytest.approx(max(sides), abs=1e-6)


def test_an_efficiency_is_no_more_than_one_beside_a_dead_centre(geared):
    """At 56.4427 deg rounding leaves 2e-15 m of k, and k_f was taken a billionth beside."""
    ((name, found),) = geared.stroke(3).efficiency_ranges
    assert name == "eta_k"
    assert found.greatest == pytest.approx(0.97087, abs=1e-5)


def test_a_result_turns_on_both_sides_of_a_kink_within_one_cell():
    """The slot turns back at 112.51 degrees, where k_hold is greatest, and is least beside it."""
    lever = mechc.loads("""
param phi = 2.6007616399321822 rad
pivot O at (0 m, 0 m)
link OA
OA = 0.05 m @ phi
slot T in OA
pivot G at (0.13133484372809268 m, 0.06253306864766871 m)
slider T along 3.5344188125636355 rad through G
torque M on OA
force F at T along 0.12676779784318537 rad
find k = M/F
drive phi from 1.1007616399321822 rad to 4.100761639932182 rad
friction pins 0.003 diameter 6 mm coulomb
friction contact T 0.0038
""")
    least, most, again = of(lever.stroke(3), "k_hold")
    assert [e.kind for e in (least, most, again)] == ["minimum", "maximum", "minimum"]
    assert most.drive == pytest.approx(3.5344188125636355 - math.pi / 2, abs=1e-8)
    values = lever.evaluate(phi=np.linspace(least.drive - 2e-3, most.drive, 41))["k_hold"]
    assert least.value == pytest.approx(values.min(), abs=1e-9)
    assert again.value < most.value - 1e-8


TURNS_ROUND = """
param phi = -9.0704 deg
pivot O at (0 mm, 0 mm)
link OA
OA = 50 mm @ phi
pivot C at (106.7107573 mm, 0.8735113619 mm)
link AB
AB = 78.41534788 mm
link CB
CB = 119.1346288 mm
assembly ABC ccw
torque M on OA
force F at B along -2.124274012915527 rad
find k = M / F
drive phi from -5 deg to 5 deg
param q = 0.2
friction pins 0.174*q diameter 6 mm journal
friction pin B 0.15*q diameter 8 mm on AB
friction pin A 0.15*q diameter 8 mm on AB
"""


def test_a_jump_too_small_to_be_shown_has_no_minimum_and_maximum():
    """Where CB turns back eta jumps from 0.99209865 to 0.99209938 and falls on both sides."""
    mechanism = mechc.loads(TURNS_ROUND)
    before, after = mechanism.evaluate(phi=[0.00818, 0.00819])["eta_k"]
    assert 1e-7 < after - before < 1e-6
    extrema = of(mechanism.stroke(3), "eta_k")
    assert [(e.kind, round(e.value, 4)) for e in extrema] == [("maximum", 0.9922)]


def test_a_sign_that_is_rounding_all_along_hides_no_extremum():
    """Nothing presses the pins of a rod in its own slot: the sign of that is none at all."""
    mechanism = mechc.loads(made("closed with friction", 220000953).text)
    before, here, after = mechanism.evaluate(phi=[2.8999, 2.9019, 2.9039])["k_f"]
    assert before > here < after
    assert [e.kind for e in of(mechanism.stroke(3), "k_f") if abs(e.drive - 2.9019) < 1e-3] == [
        "minimum"
    ]
