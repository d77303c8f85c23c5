"""Formulas as sympy expressions, built node by node, never from text.

sympy is imported when the first expression is asked for: it costs more time than a
whole compilation.
"""

from functools import reduce
from typing import TYPE_CHECKING, Any, assert_never

from .tree import Call, Formula, Number, Pi, Power, Product, Sum, Symbol

if TYPE_CHECKING:
    import sympy

NAMES = {"abs": "Abs", "min": "Min", "max": "Max"}
"""Functions that sympy spells otherwise."""


def to_sympy(formula: Formula) -> "sympy.Expr":
    """Return the formula as a sympy expression over plain symbols (no assumptions).

    >>> import sympy
    >>> from .tree import Call, Symbol, quotient
    >>> to_sympy(quotient(Call("sin", (Symbol("alpha"),)), Symbol("a")))
    sin(alpha)/a
    """
    import sympy

    return _convert(formula, sympy)


def _convert(formula: Formula, sympy: Any) -> Any:
    match formula:
        case Number(value):
            return sympy.Rational(value.numerator, value.denominator)
        case Pi():
            return sympy.pi
        case Symbol(name):
            return sympy.Symbol(name)
        case Sum(terms):
            return sympy.Add(*(_convert(t, sympy) for t in terms))
        case Product(factors):
            return sympy.Mul(*(_convert(f, sympy) for f in factors))
        case Power(base, exponent):
            return sympy.Pow(_convert(base, sympy), _convert(exponent, sympy))
        case Call("hypot", arguments):
            squares = (sympy.Pow(_convert(a, sympy), 2) for a in arguments)
            return sympy.sqrt(reduce(lambda x, y: x + y, squares))
        case Call(function, arguments):
            call = getattr(sympy, NAMES.get(function, function))
            return call(*(_convert(a, sympy) for a in arguments))
        case _:
            assert_never(formula)
