"""Decimals that lead a quotient: whole numbers stand above its line and below it."""

from fractions import Fraction

import pytest

import mechc
from mechc.formula.evaluate import evaluate
from mechc.formula.layout import over_line
from mechc.formula.tree import Call, Symbol, number, product, total
from mechc.report.text.character_sets import UNICODE
from mechc.report.text.printer import print_formula

A, B = Symbol("a"), Symbol("b")
SINE = Call("sin", (B,))
WIDE = total([A, B])


@pytest.mark.parametrize(
    ("times", "factors", "shown"),
    [
        (Fraction(2, 5), [(SINE, 1), (A, -1)], "2/(5a) · sin b"),
        (Fraction(1, 5), [(B, 1), (A, -1)], "b/(5a)"),
        (Fraction(-3, 10), [(B, 1), (A, -1)], "−3b/(10a)"),
        (Fraction(1, 10), [(WIDE, 1), (SINE, -1)], "(a + b) / (10 · sin b)"),
        (Fraction(2, 5), [(A, 1), (SINE, 1)], "0.4 · a · sin b"),
        (Fraction(17, 20), [(B, 1), (A, -1)], "0.85 · b/a"),
        (Fraction(12, 5), [(B, 1), (A, -1)], "2.4 · b/a"),
    ],
)
def test_small_whole_numbers_stand_in_a_quotient(times, factors, shown):
    formula = product([(number(times), 1), *factors])
    found = over_line(formula)
    assert print_formula(found, UNICODE) == shown
    values = {"a": 0.7, "b": 1.3}
    assert evaluate(found, values) == pytest.approx(evaluate(formula, values))


def test_a_quotient_inside_a_function_has_whole_numbers_in_numbers_too():
    page = mechc.load("hoeken").emit("latex")
    assert r"\arccos\left(\frac{AQ}{5a}\right)" in page
    assert r"\arccos\left(\frac{60}{5\cdot 20}\right)" in page
    assert r"&=\frac{2}{5}\cdot\frac{\sin" in page


def test_decimals_of_a_formula_of_ones_own_stay():
    text = "param M = 5 N*m\nparam d = 20 mm\nlet F = 0.4*M/d\n"
    page = mechc.loads(f"sheet s\n{text}", "s.mech").emit("latex")
    assert "0.4" in page
