"""How targets write powers: squares and cubes of names as products, which take no library call."""

import pytest

from mechc.emit.python.printer import PythonPrinter
from mechc.formula.tree import Formula, Symbol, number, power, total

X = Symbol("x")


@pytest.mark.parametrize(
    ("formula", "code"),
    [
        (power(X, number(2)), "x*x"),
        (power(X, number(3)), "x*x*x"),
        (power(X, number(4)), "np.power(x, 4.0)"),
        (power(total([X, number(1)]), number(2)), "np.power(x + 1.0, 2.0)"),
        (power(X, number(-1)), "1.0/x"),
        (power(X, number(-3)), "1.0/(x*x*x)"),
    ],
)
def test_powers(formula: Formula, code: str) -> None:
    assert PythonPrinter({"x": "x"}).print(formula) == code
