"""How exact a computed value is: every operation's rounding, carried along.

>>> from .tree import Call, Symbol, degrees, negative, total
>>> sixty = total([Call("asin", (Call("sin", (Symbol("a"),)),)), negative(degrees(60))])
>>> found = rounded(Call("tan", (sixty,)), {"a": exactly(math.pi / 3)})
>>> abs(found.value) < found.error < 1e-14
True
"""

import math
from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple, assert_never

from .tree import Call, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol
from .walk import FUNCTIONS, evaluate, solution

EPS = 2.0**-52

ITERATED = 1e-12
"""The relative error of what is found by iteration."""


class Rounded(NamedTuple):
    """A value, and how far at most rounding has carried it from the true one."""

    value: float
    error: float


def exactly(value: float) -> Rounded:
    """Return a value that is known to the last digit."""
    return Rounded(value, EPS * abs(value))


def completed(
    values: Mapping[str, float], definitions: Iterable[tuple[str, Formula]]
) -> dict[str, Rounded]:
    """Return values, and what definitions in order make of them, with their errors."""
    found = {name: exactly(value) for name, value in values.items()}
    for name, formula in definitions:
        found[name] = rounded(formula, found)
    return found


def rounded(formula: Formula, values: Mapping[str, Rounded]) -> Rounded:
    """Return the value of a formula, NaN where it has none, with the error of rounding."""
    match formula:
        case Number() | Pi():
            return exactly(evaluate(formula, {}))
        case Symbol(name):
            return values[name]
        case Sum(terms):
            parts = [rounded(t, values) for t in terms]
            size = sum(abs(p.value) for p in parts)
            return Rounded(math.fsum(p.value for p in parts), _sum(parts) + EPS * size)
        case Product(factors):
            result = Rounded(1.0, 0.0)
            for factor in factors:
                result = _times(result, rounded(factor, values))
            return result
        case Power(base, exponent):
            return _shifted(_power, [rounded(base, values), rounded(exponent, values)])
        case Call(function, arguments):
            return _shifted(FUNCTIONS[function], [rounded(a, values) for a in arguments])
        case Implicit(system, index, arguments):
            found = _shifted(
                lambda *outer: solution(system, outer)[index],
                [rounded(a, values) for a in arguments],
            )
            return Rounded(found.value, found.error + ITERATED * abs(found.value))
        case _:
            assert_never(formula)


def _sum(parts: Iterable[Rounded]) -> float:
    return sum(p.error for p in parts)


def _times(a: Rounded, b: Rounded) -> Rounded:
    value = a.value * b.value
    error = abs(a.value) * b.error + abs(b.value) * a.error + a.error * b.error
    return Rounded(value, error + EPS * abs(value))


def _shifted(function: Callable[..., float], arguments: list[Rounded]) -> Rounded:
    """Return a function's value, and how far it moves with each argument's error."""
    values = [a.value for a in arguments]
    here = _value(function, values)
    error = 2 * EPS * abs(here)
    for i, argument in enumerate(arguments):
        for end in (argument.value - argument.error, argument.value + argument.error):
            moved = abs(_value(function, [*values[:i], end, *values[i + 1 :]]) - here)
            error += moved if math.isfinite(moved) else 0.0
    return Rounded(here, error)


def _power(base: float, exponent: float) -> float:
    result = base**exponent
    return result if isinstance(result, float) else math.nan


def _value(function: Callable[..., float], arguments: list[float]) -> float:
    try:
        return float(function(*arguments))
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan
