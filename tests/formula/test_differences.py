"""Sines of differences as a person writes them: the same value, positive, of given directions."""

import random

import pytest

import mechc
from mechc.formula.differences import (
    factors_as_in,
    positive_sines,
    with_positive_sines,
    zero_as_written,
)
from mechc.formula.evaluate import evaluate
from mechc.formula.layout import has_minus, in_degrees
from mechc.formula.operations import count_operations
from mechc.formula.to_text import text
from mechc.formula.tree import (
    Call,
    Sum,
    Symbol,
    degrees,
    negative,
    number,
    power,
    product,
    quotient,
    total,
)

NAMES = ("a", "b", "c")
TURNS = {23: -90, -40: 90}


def some_formula(rng: random.Random):
    """Return a product or a sum of powers of sines and cosines of differences."""
    factors = [(number(rng.choice((-2, -1, 1, 3))), 1)]
    for _ in range(rng.randrange(1, 5)):
        one, other = (Symbol(name) for name in rng.sample(NAMES, 2))
        parts = [one, negative(other), degrees(rng.choice((0, 20, 23, -40)))][
            :: rng.choice((1, -1))
        ]
        factors.append((Call(rng.choice(("sin", "cos")), (total(parts),)), rng.choice((1, -1, 2))))
    whole = product(factors)
    return total([whole, some_formula(rng)]) if rng.random() < 0.4 else whole


def quarter(angle) -> int:
    """Turn angles with 23° to 67°, and those with −40° to 50°: the rest is as it is known."""
    terms = angle.terms if isinstance(angle, Sum) else ()
    return next((TURNS[size] for term in terms if (size := in_degrees(term)) in TURNS), 0)


@pytest.mark.parametrize("seed", range(200))
def test_the_value_stays_and_nothing_grows(seed):
    rng = random.Random(seed)
    formula, values = some_formula(rng), {name: rng.uniform(-3, 3) for name in NAMES}
    turned = with_positive_sines(formula, lambda: values, quarter)
    for _ in range(3):
        assert evaluate(turned, values) == pytest.approx(evaluate(formula, values), rel=1e-9)
        values = {name: rng.uniform(-3, 3) for name in NAMES}
    assert count_operations(turned) <= count_operations(formula)


def test_what_an_angle_is_of_stays_behind_its_constant():
    behind = Call("sin", (total([degrees(19), negative(Symbol("a"))]),))
    turned = with_positive_sines(behind, lambda: {"a": 0.1}, lambda angle: -90)
    assert text(turned) == "cos(a + 71*pi/180)"


@pytest.mark.parametrize("seed", range(50))
def test_a_condition_vanishes_where_the_factor_does(seed):
    rng = random.Random(seed)
    formula, values = some_formula(rng), {name: rng.uniform(-3, 3) for name in NAMES}
    turned = zero_as_written(formula, lambda: values, quarter)
    size = abs(evaluate(formula, values))
    assert abs(evaluate(turned, values)) == pytest.approx(size, rel=1e-9)
    assert not has_minus(turned) or has_minus(formula)


def test_slopes_have_differences_as_the_result_has_them():
    page = mechc.load("four_bar").emit("latex")
    slopes = page.partition("partial derivatives")[2].partition("Velocity ratio")[0]
    assert r"\sin(\psi-\theta)" not in slopes
    assert r"\frac{\partial k}{\partial c}&=-\frac{ad}{c^{2}}" in slopes


def test_an_equation_of_velocities_begins_without_a_minus():
    page = mechc.load("examples/press/press.mech").emit("latex")
    relations = page.partition("Velocities")[2].partition("Power equation")[0]
    assert r"V_B\cos(T_{\alpha}-\varphi_{AB})=V_A\sin(\varphi-\varphi_{AB})" in relations
    assert "-V_" not in relations


def test_a_velocity_is_projected_by_the_angle_between_the_links():
    """CB leans by theta + 60 deg: the projection is on the sine of an angle with that."""
    page = mechc.load("toggle_clamp").emit("latex")
    assert r"\sin(\varphi_{AB}-\theta-60^\circ)=V_B\sin\mu_B" in page
    assert r"30^\circ" not in page.partition("Velocities")[2].partition("Numerical")[0]


def test_sines_that_were_negative_both_are_turned_both():
    page = mechc.load("crank_rocker").emit("latex")
    assert r"\frac{\sin(\varphi-\psi)}{\sin(\theta-\psi)}" in page
    assert "sin(-" not in page


def test_steps_have_the_sines_of_their_result():
    """A step of Peaucellier's inversor had sin(γ − δ) beside sin(δ − γ) in k."""
    page = mechc.load("peaucellier").emit("latex")
    assert r"\gamma-\delta" not in page
    page = mechc.load("parallel_gripper").emit("latex")
    assert r"\gamma-\beta" not in page


@pytest.mark.parametrize("seed", range(50))
def test_factors_as_in_another_formula_keep_the_value(seed):
    rng = random.Random(seed)
    values = {name: rng.uniform(-3, 3) for name in NAMES}
    formula, model = some_formula(rng), some_formula(rng)
    turned = factors_as_in(formula, *positive_sines([model], lambda: values))
    assert evaluate(turned, values) == pytest.approx(evaluate(formula, values), rel=1e-9)


def test_a_negative_sum_over_a_negative_sine_is_turned_round():
    """k of Stephenson's linkage had sin(χ − φ) + … over sin(χ − δ), of −85° and −95°."""
    a, b, c = map(Symbol, NAMES)
    above, below = (Call("sin", (total([c, negative(x)]),)) for x in (a, b))
    formula = product([(total([above, b]), 1), (below, -1)])
    values = {"a": 1.9, "b": 0.2, "c": 0.1}
    assert text(with_positive_sines(formula, lambda: values)) == "(sin(a - c) - b)/sin(b - c)"
    upright = {"a": 0.1, "b": 0.2, "c": 0.9}
    assert with_positive_sines(formula, lambda: upright) == formula
    page = mechc.load("stephenson_six_bar").emit("latex")
    assert r"\chi-\varphi" not in page
    assert r"\sin(-" not in page


def test_a_size_is_that_of_the_positive_sine():
    """|sin(a − b)| is written the way round in which a person has sines elsewhere."""
    behind = Call("abs", (Call("sin", (total([Symbol("a"), negative(Symbol("b"))]),)),))
    assert text(with_positive_sines(behind, lambda: {"a": 0.1, "b": 0.5})) == "abs(sin(b - a))"
    assert text(with_positive_sines(behind, lambda: {"a": 0.5, "b": 0.1})) == "abs(sin(a - b))"


@pytest.mark.parametrize("at", [{"a": 0.1, "b": 0.5}, {"a": 0.5, "b": 0.1}])
def test_a_size_stands_as_the_sines_beside_it(at):
    """A root that has sin(a − b) twice was divided by |sin(b − a)|."""
    sine = Call("sin", (total([Symbol("a"), negative(Symbol("b"))]),))
    root = Call("sqrt", (total([Symbol("c"), power(sine, number(3)), power(sine, number(2))]),))
    opposite = Call("sin", (total([Symbol("b"), negative(Symbol("a"))]),))
    for one in (sine, opposite):
        shown = text(with_positive_sines(quotient(root, Call("abs", (one,))), lambda: at))
        assert len({side for side in ("sin(a - b)", "sin(b - a)") if side in shown}) == 1


def test_a_difference_below_the_line_is_positive() -> None:
    """What stands above it turns too; what has no value stays as it is."""
    a, b, c = map(Symbol, "abc")
    below = total([a, negative(b)])
    at = {"a": 1.0, "b": 3.0, "c": 2.0}
    assert text(with_positive_sines(quotient(c, below), lambda: at)) == "-c/(b - a)"
    both = product([(total([a, negative(c)]), 1), (below, -1)])
    assert text(with_positive_sines(both, lambda: at)) == "(c - a)/(b - a)"
    assert with_positive_sines(quotient(c, below), lambda: {"a": 1.0}) == quotient(c, below)
    assert with_positive_sines(quotient(c, below), lambda: {**at, "a": 4.0}) == quotient(c, below)
