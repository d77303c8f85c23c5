"""Formulas as lines of text: where parentheses are needed, and where not."""

from fractions import Fraction

import pytest

from mechc.formula.to_text import text
from mechc.formula.tree import Call, Symbol, number, power, product, total

A, B = Symbol("a"), Symbol("b")
LESS_THAN_B = Call("less", (A, B))
INNER = Call("choose", (LESS_THAN_B, A, B))
LONG = Fraction(243549291, 250000000)
"""More digits than anybody reads as a fraction."""

TWICE, LESS = product([(number(2), 1), (B, 1)]), product([(number(-2), 1), (B, 1)])


@pytest.mark.parametrize(
    ("formula", "line"),
    [
        (total([A, TWICE]), "a + 2*b"),
        (total([A, LESS]), "a - 2*b"),
        (LESS, "-2*b"),
        (product([(A, 1), (total([A, B]), 1)]), "a*(a + b)"),
        (power(total([A, B]), number(2)), "(a + b)^2"),
        (product([(number(LONG), 1), (A, 1)]), "0.974197164*a"),
        (product([(number(-LONG), 1), (A, 1)]), "-0.974197164*a"),
        (INNER, "a when a < b else b"),
        (
            Call("choose", (LESS_THAN_B, number(2), INNER)),
            "2 when a < b else (a when a < b else b)",
        ),
        (product([(number(2), 1), (INNER, 1)]), "2*(a when a < b else b)"),
    ],
)
def test_parentheses_stand_where_they_are_needed(formula, line):
    assert text(formula) == line
