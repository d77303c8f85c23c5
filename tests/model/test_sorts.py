"""Dimensions of formulas: the rules, and laws that they keep."""

import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mechc.diagnostics import MechcError, Report
from mechc.formula.evaluate import evaluate
from mechc.model.formulas.sorts import Nature, Sort, agreed, multiplied, raised
from mechc.model.from_syntax import resolve
from mechc.model.mechanism import Let
from mechc.source import Source
from mechc.syntax.notation import read
from mechc.units import (
    ANGLE,
    DIMENSIONS,
    FORCE,
    LENGTH,
    NUMBER,
    PRESSURE,
    TORQUE,
    UNITS,
    Dimension,
    described,
)

PARAMETERS = """\
param a = 40 mm
param r = 25 mm
param n = 3
param alpha = 30 deg
param P = 200 N
param m = 2 kg
"""
VALUES = {"a": 0.04, "r": 0.025, "n": 3.0, "alpha": math.pi / 6, "P": 200.0, "m": 2.0}


def read_let(expression: str) -> Let:
    source = Source("sheet.mech", f"{PARAMETERS}let it = {expression}\n")
    report = Report(source)
    tree = read(source, report)
    report.stop_on_errors()
    return resolve(tree, report).lets[0]


def code(expression: str) -> str:
    with pytest.raises(MechcError) as caught:
        read_let(expression)
    return ",".join(d.code for d in caught.value.diagnostics if d.code[0] == "E")


@pytest.mark.parametrize(
    ("expression", "dimension"),
    [
        ("2*alpha - 90 deg", ANGLE),
        ("(alpha + 5 deg)/2", ANGLE),
        ("r*alpha", LENGTH),
        ("alpha^2", NUMBER),
        ("a/r", NUMBER),
        ("360 deg/n", ANGLE),
        ("exp(alpha/n)", NUMBER),
        ("1 + alpha/n", NUMBER),
        ("r*(alpha/n)", LENGTH),
        ("alpha + a/r", ANGLE),
        ("atan2(a, r) + alpha", ANGLE),
        ("asin(a/r/2)", ANGLE),
        ("sin(a/r)", NUMBER),
        ("tan(alpha) - alpha", ANGLE),
        ("alpha + 2*sin(alpha)", ANGLE),
        ("sin(alpha) + 1", NUMBER),
        ("exp(n*alpha)", NUMBER),
        ("exp(0.2*alpha)", NUMBER),
        ("exp(-alpha/2 - 0.1*alpha)", NUMBER),
        ("exp(0.25*210 deg)", NUMBER),
        ("2^(0.5*alpha)", NUMBER),
        ("1 + n*alpha", NUMBER),
        ("sqrt(a^2 + r^2) + hypot(a, r)", LENGTH),
        ("sqrt(a*r)*P", TORQUE),
        ("a^(1/2)*a^0.5", LENGTH),
        ("a^-2*P", PRESSURE),
        ("4*P/(pi*a^2)", PRESSURE),
        ("P*a", TORQUE),
        ("min(a, r, 3 mm)", LENGTH),
        ("max(abs(P), 0)", FORCE),
        ("0 + a", LENGTH),
        ("n^n", NUMBER),
        ("2^n", NUMBER),
        ("5 N*m", TORQUE),
        ("m*9.81 m/s^2", FORCE),
        ("1/a", Dimension(-1)),
    ],
)
def test_dimension_of(expression: str, dimension: Dimension) -> None:
    assert read_let(expression).dimension == dimension


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("a + alpha", "E220"),
        ("a - P", "E220"),
        ("sin(sin(alpha))", "E221"),
        ("exp(alpha)", "E221"),
        ("exp(-alpha)", "E221"),
        ("exp(0.2*alpha + alpha)", "E221"),
        ("exp(0.2*a)", "E221"),
        ("log(a)", "E221"),
        ("asin(alpha)", "E221"),
        ("alpha + 30", "E222"),
        ("30 - alpha", "E222"),
        ("a + 2*3", "E222"),
        ("cos(90)", "E222"),
        ("min(a, 3)", "E222"),
        ("hypot(a, alpha)", "E220"),
        ("2^a", "E221"),
        ("a^n", "E223"),
        ("9^9^9^9", "E224"),
        ("n^(60 + 5)", "E224"),
        ("((n^40)^40)", "E224"),
        ("1e300*1e300", "E224"),
        ("alpha + 1e300 + 1e308 + 1e308", "E222"),
        ("cos(1e308 + 1e308)", "E222"),
        ("1/0", "E225"),
        ("aa + a + alpha", "E201,E220"),
    ],
)
def test_wrong_dimensions(expression: str, expected: str) -> None:
    assert code(expression) == expected


NATURES = st.sampled_from(
    [
        Sort(NUMBER, Nature.ZERO),
        Sort(NUMBER, Nature.BARE),
        Sort(NUMBER, Nature.LOOSE),
        Sort(NUMBER, Nature.VALUE),
        Sort(NUMBER),
        Sort(ANGLE),
        Sort(LENGTH),
        Sort(FORCE),
    ]
)


@given(NATURES, NATURES)
def test_order_of_a_sum_does_not_matter(a: Sort, b: Sort) -> None:
    assert agreed(a, b) == agreed(b, a)


@given(NATURES)
def test_a_quantity_agrees_with_itself_and_with_zero(a: Sort) -> None:
    assert agreed(a, a) == a
    assert agreed(a, Sort(NUMBER, Nature.ZERO)) == a


@given(st.permutations([Sort(LENGTH), Sort(ANGLE), Sort(FORCE), Sort(NUMBER, Nature.BARE)]))
def test_order_of_a_product_does_not_matter(factors: list[Sort]) -> None:
    assert multiplied([(f, 1) for f in factors]) == Sort(TORQUE)


@given(NATURES, st.integers(1, 5))
def test_a_power_is_a_repeated_product(base: Sort, exponent: int) -> None:
    repeated = multiplied([(base, 1)] * exponent)
    assert raised(base, Fraction(exponent)).dimension == repeated.dimension


EXPRESSIONS = st.recursive(
    st.sampled_from([*VALUES, "2", "0.5", "7"]),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("*/"), inner).map(lambda t: f"({t[0]}{t[1]}{t[2]})"),
        inner.map(lambda e: f"(2*{e} - {e})"),
        inner.map(lambda e: f"sqrt({e}^2)"),
        inner.map(lambda e: f"max({e}, {e}/2)"),
    ),
    max_leaves=8,
)


@given(EXPRESSIONS)
@settings(max_examples=60, deadline=None)
def test_a_formula_has_the_value_of_its_expression(expression: str) -> None:
    """Quantities are in SI: the same expression on the SI values gives the same number."""
    names = {**VALUES, "sqrt": math.sqrt, "max": max}
    expected = eval(expression.replace("^", "**"), {"__builtins__": {}}, names)
    assert evaluate(read_let(expression).value, VALUES) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("unit", sorted(UNITS))
def test_every_unit_can_be_written(unit: str) -> None:
    let = read_let(f"3 {unit}")
    factor = float(UNITS[unit].factor) * (math.pi if UNITS[unit].pi else 1)
    assert let.dimension == UNITS[unit].dimension
    assert evaluate(let.value, {}) == pytest.approx(3 * factor, rel=1e-15)


@pytest.mark.parametrize("name", sorted(DIMENSIONS))
def test_every_dimension_has_words(name: str) -> None:
    words = described(DIMENSIONS[name])
    assert name in words
    unit = words.partition("(")[2].rstrip(")")
    assert not unit or UNITS[unit].dimension == DIMENSIONS[name]
