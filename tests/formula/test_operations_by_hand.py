"""The length of a formula in operations, counted by hand."""

from fractions import Fraction

import pytest

from mechc.formula.operations import count_operations
from mechc.formula.tree import Call, Number, Pi, Power, Product, Sum, Symbol

A, B, C = map(Symbol, "abc")


def number(over: int, under: int = 1) -> Number:
    return Number(Fraction(over, under))


@pytest.mark.parametrize(
    ("formula", "operations"),
    [
        (A, 0),
        (Pi(), 0),
        (number(-2), 1),
        (number(1, 2), 1),
        (number(-1, 2), 2),
        (Sum((A, B, C)), 2),
        (Sum((A, Product((number(-1), B)))), 1),
        (Sum((A, Product((number(-2), B)))), 2),
        (Sum((A, number(-1))), 1),
        (Power(A, number(-1)), 1),
        (Power(A, number(-2)), 1),
        (Power(A, number(2)), 1),
        (Power(A, number(1, 2)), 2),
        (Power(A, number(-1, 2)), 2),
        (Power(Sum((A, B)), number(-1)), 2),
        (Power(A, Sum((B, number(1)))), 2),
        (Call("sin", (Sum((A, B)),)), 2),
        (Call("atan2", (A, B)), 1),
        (Product((A, B)), 1),
        (Product((number(-1), A)), 1),
        (Product((number(2), A, Power(B, number(-1)))), 2),
        (Product((number(1, 2), A, Power(B, number(-1)))), 2),
        (Product((A, Power(B, number(-2)))), 2),
    ],
)
def test_an_operation_is_a_sign_between_two_parts_or_a_function(formula, operations):
    assert count_operations(formula) == operations
