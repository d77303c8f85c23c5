"""Conditions as they are stated: turned round where what is compared with zero has a minus."""

import pytest

from by_hand import HERE
from mechc.formula.to_text import text
from mechc.formula.tree import ZERO, Sum, Symbol, negative, product
from mechc.model.mechanism import Require
from mechc.report.definitions import plus_condition

A, B = map(Symbol, "ab")
LESS = Sum((A, negative(B)))
MINUS = negative(product([(A, 1), (B, 1)]))


@pytest.mark.parametrize(
    ("left", "operator", "stated"),
    [
        (MINUS, "<", "a*b > 0"),
        (MINUS, "<=", "a*b >= 0"),
        (MINUS, ">", "a*b < 0"),
        (MINUS, ">=", "a*b <= 0"),
        (MINUS, "=", "a*b = 0"),
        (LESS, "<", "b - a > 0"),
        (LESS, "<=", "b - a >= 0"),
        (LESS, ">", "a - b > 0"),
        (LESS, ">=", "a - b >= 0"),
        (A, "<", "a < 0"),
        (Sum((A, B)), "<=", "a + b <= 0"),
    ],
)
def test_both_sides_of_a_condition_change_their_signs(left, operator, stated):
    found = plus_condition(Require(left, operator, ZERO, HERE))
    assert f"{text(found.left)} {found.operator} {text(found.right)}" == stated


@pytest.mark.parametrize("left", [MINUS, LESS])
def test_what_is_compared_with_another_size_stays(left):
    condition = Require(left, "<", B, HERE)
    assert plus_condition(condition) == condition
