"""What stands in an expression, and the exact value of a constant formula."""

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import assert_never

from ..formula.evaluate import evaluate
from ..formula.tree import Formula, Number, Power, Product, Sum
from ..syntax import ast
from ..units import ANGLE, LENGTH, UNITS, Dimension

LARGEST_EXPONENT = 64
"""Beyond, a constant power is refused: powers of powers would fill the memory."""

LARGEST_DOUBLE = 10**308
"""What a double can hold."""

LARGEST_BITS = 4096
"""Size of a constant's denominator; that of a literal has 1,200 at most."""

LARGEST_QUANTITY = 1e60
"""Quantities lie between this and its reciprocal, in SI: cubes of them are still doubles."""

LONG_WAY = 1e6
"""Lengths lie between this and its reciprocal, in metres: sums of them keep their digits."""

MANY_TURNS = math.radians(1_000_000)
"""Beyond this angle sines lose their digits."""


def out_of_reach(value: float, dimension: Dimension) -> bool:
    """Return whether a quantity, in SI or radians, is none that a mechanism can have.

    >>> from mechc.units import NUMBER
    >>> out_of_reach(1e70, NUMBER), out_of_reach(1e7, NUMBER), out_of_reach(1e7, ANGLE)
    (True, False, True)
    """
    if not math.isfinite(value):
        return False
    if dimension == ANGLE:
        return abs(value) > MANY_TURNS
    far = LONG_WAY if dimension == LENGTH else LARGEST_QUANTITY
    return value != 0 and not 1 / far <= abs(value) <= far


def names_in_let_value(value: ast.LetValue) -> Iterator[ast.Symbol]:
    """Yield the symbols of a user-defined formula, left to right."""
    for expression in expressions_in(value):
        yield from names_in(expression)


def expressions_in(value: ast.LetValue) -> Iterator[ast.Expr]:
    """Yield the expressions that a user-defined formula is made of."""
    match value:
        case ast.Choice(branches, otherwise):
            for branch in branches:
                yield branch.value
                yield from (side for c in branch.conditions for side in c.operands)
            yield from expressions_in(otherwise) if otherwise else ()
        case ast.Lookup(_, at):
            yield at
        case ast.NextSize(least):
            yield least
        case _:
            yield value


def names_in(expression: ast.Expr) -> Iterator[ast.Symbol]:
    """Yield the symbols of an expression, left to right."""
    return (leaf for leaf in leaves(expression) if isinstance(leaf, ast.Symbol))


def leaves(expression: ast.Expr) -> Iterator[ast.Symbol | ast.Number]:
    """Yield the symbols and numbers of an expression, left to right."""
    stack: list[ast.Expr] = [expression]
    while stack:
        node = stack.pop()
        match node:
            case ast.Symbol() | ast.Number():
                yield node
            case ast.Sum(parts) | ast.Product(parts):
                stack.extend(part for _, part in reversed(parts))
            case ast.Power(base, exponent):
                stack += (exponent, base)
            case ast.Call(_, arguments):
                stack.extend(reversed(arguments))
            case _:
                assert_never(node)


def too_large(value: Fraction) -> bool:
    """Return whether an exact number is beyond what a double or the memory should hold.

    >>> too_large(Fraction(9) ** 64), too_large(Fraction(9) ** 640)
    (False, True)
    """
    return abs(value) > LARGEST_DOUBLE or value.denominator.bit_length() > LARGEST_BITS


def last_digit(number: ast.Number) -> Fraction:
    """Return the value of one unit in the last digit of a number, in SI.

    >>> from ..source import Span
    >>> last_digit(ast.Number("34.64", "mm", Span(0, 5)))
    Fraction(1, 100000)
    """
    mantissa, _, exponent = number.digits.lower().partition("e")
    _, _, decimals = mantissa.partition(".")
    unit = UNITS.get(number.unit)
    factor = unit.factor if unit else Fraction(1)
    factor *= Fraction(math.pi) if unit and unit.pi else 1
    return Fraction(10) ** (int(exponent or 0) - len(decimals)) * factor


def decimal(value: float) -> Number:
    """Return a float as the number that its shortest decimal is.

    >>> decimal(0.1).value
    Fraction(1, 10)
    """
    return Number(Fraction(repr(value)))


def number_of(formula: Formula) -> Number:
    """Return the value of a formula without symbols: exactly, or in the digits of a float."""
    exact = rational(formula)
    return decimal(evaluate(formula, {})) if exact is None else Number(exact)


def rational(formula: Formula) -> Fraction | None:
    """Return the value of a formula of exact numbers only, else None."""
    match formula:
        case Number(value):
            return value
        case Sum(terms):
            values = _rationals(terms)
            return None if values is None else sum(values, Fraction(0))
        case Product(factors):
            values = _rationals(factors)
            return None if values is None else math.prod(values, start=Fraction(1))
        case Power(base, Number(e)) if e.denominator == 1 and abs(e) <= LARGEST_EXPONENT:
            inner = rational(base)
            return inner**e.numerator if inner else inner
        case _:
            return None


def _rationals(formulas: Sequence[Formula]) -> list[Fraction] | None:
    values = [value for value in map(rational, formulas) if value is not None]
    return values if len(values) == len(formulas) else None
