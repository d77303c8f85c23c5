"""Numbers put into a report's formulas: what they come to is what stands behind them."""

import math
from fractions import Fraction

import pytest

from good_mechanisms import CLOSED, compiled, loaded
from mechc.compilation import compile_source
from mechc.data_folders import data
from mechc.formula.evaluate import evaluate
from mechc.formula.layout import TRIGONOMETRIC
from mechc.formula.to_text import text
from mechc.formula.tree import Call, Constant, Number, Symbol, number, product, total
from mechc.formula.walk import children, rebuild, symbols
from mechc.report.evaluated import evaluated
from mechc.report.put_in import GivenQuantity, put_in
from mechc.report.sections import outline
from mechc.report.text.derivation import render
from mechc.source import Source


def found(name):
    mechanism, derivation = compiled(name).mechanism, compiled(name).derivation
    return list(evaluated(outline(derivation, mechanism), mechanism))


def shown(name):
    return {text(item.left): item for item in found(name)}


def test_units_that_cancel_are_left_out():
    k = shown("karpenko_fig9_packet_clamp")["k"]
    assert text(k.numbers) == "100*sin(19*pi/180)/(2*250*cos(pi/15)*cos(7*pi/180))"


def test_a_force_with_a_minus_is_its_own_value():
    """R_O_x = −F stood as −2 kN = −2 kN."""
    lever = """
pivot O
link OA
OA = 100 mm @ 30 deg
force P at A along y
force F at A along x
let F = 2 kN
find R_O
"""
    said = compile_source(Source("lever.mech", lever))
    values = evaluated(outline(said.derivation, said.mechanism), said.mechanism)
    (item,) = (item for item in values if text(item.left) == "R_O_x")
    assert item.numbers is None
    assert item.value.text(6) == "-2 kN"


def test_units_that_do_not_cancel_stand():
    items = shown("crank_rocker")
    assert text(items["k"].numbers).startswith("40 mm*sin(")
    assert items["k"].value.text(6) == "36.5879 mm"
    assert items["theta"].value.unit == "deg"


def test_what_an_account_calls_by_the_users_name_has_its_value_before_the_result():
    """Fedoriv: W = Q/(tan(α + β) + tan φ₁ᵣ), β the user's own, as is the roller's f_r."""
    items = shown("fedoriv_fig1_with_friction")
    names = list(items)
    assert text(items["k_f"].numbers) == "tan(53581*pi/900000) + 0.0333333"  # 10.7162 deg
    assert names.index("beta") < names.index("f_r") < names.index("k_f")
    assert [text(item.left) for item in found("fedoriv_fig1_with_friction")] == names


def test_they_can_be_switched_off():
    compilation = compiled("crank_rocker")
    derivation, mechanism = compilation.derivation, compilation.mechanism
    assert "At the values given" in render(derivation, mechanism)
    assert "At the values given" not in render(derivation, mechanism, numbers=False)


def in_figures(formula):
    """Return a formula of quantities with the figures that are printed, all in one unit."""
    if isinstance(formula, Constant):
        return Number(Fraction(formula.name.strip("()").split()[0]))
    parts = children(formula)
    return rebuild(formula, tuple(map(in_figures, parts))) if parts else formula


def gap(item):
    """Return by what part the figures printed miss the value, of an angle by how many radians."""
    printed = evaluate(in_figures(item.numbers), {})
    if item.value.unit == "deg":
        return math.remainder(printed - item.value.value, 2 * math.pi)
    value = float(item.value.text(12).split()[0])
    return (printed - value) / value


WITH_FRICTION = [p.stem for p in sorted(data("library").glob("[fk]*_with_friction.mech"))]
"""The clamps of two papers with friction; what others give has units in which figures mix."""


@pytest.mark.parametrize("name", [*CLOSED, *WITH_FRICTION])
def test_the_figures_come_to_the_value(name):
    items = [item for item in found(name) if item.numbers is not None]
    for item in items:
        assert abs(gap(item)) < 0.0015, text(item.left)


def angles(formula):
    """Return the angles in degrees of the sines and cosines in a formula of numbers."""
    inner = [angle for part in children(formula) for angle in angles(part)]
    if isinstance(formula, Call) and formula.function in TRIGONOMETRIC:
        return [*inner, math.degrees(evaluate(formula.arguments[0], {}))]
    return inner


@pytest.mark.parametrize("name", CLOSED)
def test_angles_have_no_whole_turns_and_nothing_stands_twice(name):
    for item in found(name):
        assert not isinstance(item.numbers, Constant)
        assert all(-180 <= a <= 360 for a in angles(item.numbers or item.left))
        if item.value.unit == "deg":
            assert item.value.value == 0 or abs(item.value.value) > 1e-12


def test_a_result_that_is_a_parameter_is_given_once():
    assert shown("pantograph")["k"].numbers is None


@pytest.mark.parametrize("name", CLOSED)
def test_a_slope_mentions_nothing_that_is_not_introduced(name):
    mechanism = compiled(name).mechanism
    listed = (*mechanism.parameters, *mechanism.literals, *mechanism.loads)
    for result in compiled(name).derivation.results:
        known = {each.name for each in (*listed, *result.where)}
        assert all(symbols(slope) <= known for slope in (result.derivatives or {}).values())


@pytest.mark.parametrize("name", ["lever_clamp_with_friction", "karpenko_fig9_with_friction"])
def test_results_with_friction_have_their_numbers_put_in(name):
    items = shown(name)
    assert all(items[n].numbers is not None for n in ("k_f", "k_hold", "eta_k"))
    assert items["rho"].value.unit == "mm"
    order = [text(item.left) for item in found(name)]
    assert order.index("rho") < order.index("k_f") < order.index("eta_k")
    assert len(order) == len(set(order))


def test_a_ratio_of_some_fifty_operations_has_its_numbers_put_in():
    assert text(shown("double_butterfly")["k"].numbers).startswith("40*70*sin(")


def test_a_negative_number_at_the_beginning_of_a_sum_has_no_bracket():
    given = {"k": GivenQuantity(-0.0157846, "mm"), "b": GivenQuantity(-0.001, "mm")}
    whole = total([Symbol("k"), product([(Symbol("b"), 1), (number(2), 1)]), Symbol("b")])
    assert text(put_in(whole, given)) == "-15.7846 mm + 2*(-1 mm) - 1 mm"


ROD = """
mechanism rod "A rod between two guides"
param beta = 12 deg in 2 deg .. 40 deg
slider A along y
slider B along x
link AB
AB = 200 mm @ 180 deg - beta
force P at A along -y
force F at B along -x
friction pins 0.1 diameter 20 mm
let F = 1000 N
find {asked}
find N_AB
"""


@pytest.mark.parametrize(("asked", "whole"), [("P", "S_AB"), ("k = P/F", "S_AB_f")])
def test_the_force_that_a_component_is_of_has_its_value_before_it(asked, whole):
    """Of a ratio the steps have a force for a unit of load, and then one in newtons."""
    compilation = compile_source(Source("rod.mech", ROD.format(asked=asked)))
    mechanism, derivation = compilation.mechanism, compilation.derivation
    values = evaluated(outline(derivation, mechanism), mechanism)
    items = {text(item.left): item for item in values}
    order = list(items)
    assert order.index(whole) < order.index("N_AB_f")
    turned = math.radians(12) + math.asin(0.01)
    assert items[whole].value.value == pytest.approx(1000 / math.cos(turned))
    assert items["N_AB_f"].value.value < items[whole].value.value


def test_a_number_without_unit_is_not_stated_again_as_its_value():
    """n = 1/2 of racks, M = 0 of a brake without friction; a third has digits."""
    pages = {name: loaded(name).emit("latex") for name in ("d45_09_racks_pinion", "band_brake")}
    assert "$n=0.5$" not in pages["d45_09_racks_pinion"]
    assert "Numerical values" not in pages["d45_09_racks_pinion"]
    assert "$M=0" not in pages["band_brake"]
    assert "$k=0.333333$" in loaded("block_and_tackle").emit("latex")


def test_a_direction_that_mirrors_another_has_no_value_where_nothing_rests_on_it():
    """Of Peaucellier's inversor the position states the direction of AC; k is told without it."""
    page = loaded("peaucellier_closed").emit("latex")
    position, values = page.split(r"\section*{Numerical values}")
    assert r"\varphi_{AC}" in position
    assert r"\varphi_{AC}" not in values
    assert r"\varphi_{AB}" in values


SINE = Call("sin", (Symbol("phi"),))
AT = {"a": GivenQuantity(0.05, "mm"), "phi": GivenQuantity(math.radians(-100), "deg")}


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (SINE, "-sin(5*pi/9)"),
        (product([(Symbol("a"), 1), (SINE, 1)]), "-50 mm*sin(5*pi/9)"),
        (product([(Symbol("a"), 1), (SINE, -1)]), "-50 mm/sin(5*pi/9)"),
        (product([(Symbol("a"), 1), (SINE, 2)]), "50 mm*sin(5*pi/9)^2"),
        (product([(number(-2), 1), (Symbol("a"), 1), (SINE, 1)]), "2*50 mm*sin(5*pi/9)"),
        (total([Symbol("a"), product([(Symbol("a"), 1), (SINE, 1)])]), "50 mm - 50 mm*sin(5*pi/9)"),
        (Call("abs", (SINE,)), "abs(sin(5*pi/9))"),
        (Call("cos", (Symbol("phi"),)), "cos(5*pi/9)"),
    ],
)
def test_a_negative_angle_of_a_sine_is_a_minus_before_the_product(formula, expected):
    found = put_in(formula, AT)
    assert text(found) == expected


def test_minuses_of_numbers_stand_before_the_product():
    force, arm = Symbol("F"), Symbol("a")
    given = {"F": GivenQuantity(-5.0, "N"), "a": GivenQuantity(0.02, "mm")}
    sine = Call("sin", (Symbol("alpha"),))
    given["alpha"] = GivenQuantity(math.radians(30), "deg")
    turning = product([(force, 1), (sine, 1)])
    assert text(put_in(turning, given)) == "-5 N*sin(pi/6)"
    assert text(put_in(product([(force, 1), (force, 1), (arm, -1)]), given)) == "5 N*5 N/20 mm"
    assert text(put_in(total([turning, product([(number(-1), 1), (turning, 1)])]), given)) == (
        "-5 N*sin(pi/6) + 5 N*sin(pi/6)"
    )
    over = product([(sine, 1), (force, -1)])
    assert text(put_in(over, given)) == "-sin(pi/6)/5 N"
