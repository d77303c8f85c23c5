"""The slope of every function is the limit of its differences."""

import pytest

from mechc.formula.derivative import _OF_ONE, along, derivative
from mechc.formula.evaluate import evaluate
from mechc.formula.tree import Call, Symbol, number, power, product, total

X, Y, Z = map(Symbol, "xyz")
VALUES = {"x": 0.37, "y": -0.61, "z": 0.22}
STEP = 1e-6

OF_SEVERAL = [
    Call("atan2", (Y, X)),
    Call("hypot", (X, Y, Z)),
    *(Call(name, order) for name in ("min", "max") for order in ((X, Y, Z), (Z, X, Y), (Y, Z, X))),
]


def difference(formula, name):
    ends = (evaluate(formula, {**VALUES, name: VALUES[name] + s * STEP}) for s in (1, -1))
    ahead, behind = ends
    return (ahead - behind) / (2 * STEP)


@pytest.mark.parametrize("function", sorted(_OF_ONE))
def test_a_function_of_one_argument_takes_the_slope_of_that_along(function):
    formula = Call(function, (product([(number(2), 1), (X, 2)]),))
    slope = evaluate(derivative(formula, "x"), VALUES)
    assert slope == pytest.approx(difference(formula, "x"), rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("formula", OF_SEVERAL, ids=str)
@pytest.mark.parametrize("name", "xyz")
def test_a_function_of_several_arguments_leans_on_each(formula, name):
    slope = evaluate(derivative(formula, name), VALUES)
    assert slope == pytest.approx(difference(formula, name), rel=1e-6, abs=1e-9)


def test_along_a_way_the_changes_of_all_names_add_up():
    formula = total([power(X, number(3)), product([(X, 1), (Y, -1)])])
    (slope,) = along([formula], {"x": number(2), "y": number(-1)})
    by_parts = [evaluate(derivative(formula, name), VALUES) for name in "xy"]
    assert evaluate(slope, VALUES) == pytest.approx(2 * by_parts[0] - by_parts[1])
