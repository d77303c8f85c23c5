"""Formulas as sympy expressions, built node by node, never from text.

sympy is imported when the first expression is asked for: it costs more time than a
whole compilation.
"""

from functools import cache, reduce
from typing import TYPE_CHECKING, Any, assert_never

from .choices import SIGNS, spelled_out
from .evaluate import solution
from .tree import Call, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol, System
from .walk import constants

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
    """Return a formula as an expression of SymPy."""
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
        case Call(function, arguments) if simpler := spelled_out(function, arguments):
            return _convert(simpler, sympy)
        case Call(function, (left, right)) if function in SIGNS:
            return sympy.Rel(_convert(left, sympy), _convert(right, sympy), _RELATIONS[function])
        case Call("choose", (condition, value, *rest)):
            other = _convert(rest[0], sympy) if rest else sympy.nan
            both = (_convert(value, sympy), _holds(condition, sympy)), (other, True)
            return sympy.Piecewise(*both)
        case Call("hypot", arguments):
            squares = (sympy.Pow(_convert(a, sympy), 2) for a in arguments)
            return sympy.sqrt(reduce(lambda x, y: x + y, squares))
        case Call(function, arguments):
            call = getattr(sympy, NAMES.get(function, function))
            return call(*(_convert(a, sympy) for a in arguments))
        case Implicit(system, index, arguments):
            return _solution(system, index)(*(_convert(a, sympy) for a in arguments))
        case _:
            assert_never(formula)


_RELATIONS = {**SIGNS, "same": "==", "differs": "!="}


def _holds(condition: Formula, sympy: Any) -> Any:
    """Return a condition as sympy's logic has it."""
    match condition:
        case Call("both", parts):
            return sympy.And(*(_holds(part, sympy) for part in parts))
        case _:
            return _convert(condition, sympy)


@cache
def _solution(system: System, index: int) -> Any:
    """Return an unknown as a function of sympy's, to any precision where numbers are put in.

    The branch is chosen in floats; from there ``nsolve`` goes on.
    """
    import sympy

    named = constants(system.equations)

    def _eval_evalf(self: Any, precision: int) -> Any:
        """Return an unknown to so many bits, solved again from its value in floats."""
        outer = [a.evalf(n=15) for a in self.args]
        if not all(a.is_Float or a.is_Integer for a in outer):
            return None
        near = solution(system, tuple(map(float, outer)))
        if near[index] != near[index]:
            return sympy.nan
        values = {sympy.Symbol(n): a for (n, _), a in zip(system.anchor, self.args, strict=True)}
        values |= {sympy.Symbol(c.name): _convert(c.value, sympy) for c in named}
        exact = [_convert(e, sympy).subs(values) for e in system.equations]
        unknowns = [sympy.Symbol(name) for name in system.unknowns]
        digits = sympy.core.evalf.prec_to_dps(precision) + 2
        return sympy.nsolve(exact, unknowns, near, prec=digits)[index]

    body = {"_eval_evalf": _eval_evalf, "nargs": len(system.anchor)}
    return type(f"solution_{system.unknowns[index]}", (sympy.Function,), body)
