"""Differences below a line, turned the way round that is positive: the value stays as it is."""

import pytest

from mechc.formula.evaluate import SharedEvaluation, evaluate
from mechc.formula.positive_divisors import over_positive_differences
from mechc.formula.to_text import text
from mechc.formula.tree import Power, Product, Sum, Symbol, negative, number

A, B, C, M = map(Symbol, "abcM")
VALUES = {"a": 1.0, "b": 2.0, "c": 4.0, "M": 7.0}


def less(one, other):
    return Sum((one, negative(other)))


def over(divisor, power=1):
    return Power(divisor, number(-power))


@pytest.mark.parametrize(
    ("factors", "found"),
    [
        ((M, over(less(A, B))), "-M/(b - a)"),
        ((M, over(less(A, B), 3)), "-M/(b - a)^3"),
        ((less(A, C), over(less(A, B))), "(c - a)/(b - a)"),
        ((less(C, A), over(less(A, B))), "-(c - a)/(b - a)"),
        ((over(less(A, B)), over(less(B, C))), "1/((b - a)*(c - b))"),
    ],
)
def test_what_is_negative_below_the_line_is_turned(factors, found):
    turned = over_positive_differences(factors, SharedEvaluation(VALUES))
    assert text(turned) == found
    assert evaluate(turned, VALUES) == pytest.approx(evaluate(Product(factors), VALUES))


@pytest.mark.parametrize(
    "factors",
    [
        (M, over(less(B, A))),
        (M, over(less(A, B), 2)),  # a square has one sign either way
        (M, less(A, B)),
        (M, over(Sum((negative(A), negative(B))))),  # no difference
        (M, over(less(A, Symbol("unknown")))),
    ],
)
def test_other_factors_stay_as_they_are(factors):
    assert over_positive_differences(factors, SharedEvaluation(VALUES)) is None
