"""Formulas as sympy expressions, by hand: what sympy spells otherwise, or has no function for."""

import pytest
import sympy

from mechc.formula.to_sympy import to_sympy
from mechc.formula.tree import Call, Symbol, number, power

X, A = Symbol("x"), Symbol("a")
x, a = sympy.symbols("x a")


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (power(X, A), x**a),
        (Call("hypot", (X, A)), sympy.sqrt(x**2 + a**2)),
        (Call("min", (X, A)), sympy.Min(x, a)),
        (Call("abs", (X,)), sympy.Abs(x)),
        (Call("less", (X, A)), x < a),
    ],
)
def test_functions(formula, expected) -> None:
    assert to_sympy(formula) == expected


def test_a_choice_has_its_other_value_where_a_condition_fails() -> None:
    within = Call("both", (Call("more", (X, number(0))), Call("less", (X, A))))
    found = to_sympy(Call("choose", (within, number(3), X)))
    assert found == sympy.Piecewise((3, (x > 0) & (x < a)), (x, True))


def test_a_choice_without_another_value_is_undefined_elsewhere() -> None:
    found = to_sympy(Call("choose", (Call("more", (X, number(0))), X)))
    assert found.subs(x, 2) == 2
    assert found.subs(x, -2) is sympy.nan
