"""Formulas for the terminal, on one line.

>>> from ..formula.tree import Symbol, number, product
>>> a, b, alpha, theta = map(Symbol, ("a", "b", "alpha", "theta"))
>>> k = product(
...     [(number(2), 1), (b, 1), (a, -1), (Call("cos", (alpha,)), 1)]
...     + [(Call("sin", (theta,)), 1), (Call("cos", (Sum((alpha, theta)),)), -1)]
... )
>>> print_formula(k, UNICODE)
'2b/a · cos α · sin θ / cos(α + θ)'
>>> print_formula(k, ASCII)
'2*b/a * cos(alpha) * sin(theta) / cos(alpha + theta)'
"""

from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise
from typing import assert_never

from ..formula.layout import (
    TRIGONOMETRIC,
    decimal,
    fractions,
    in_degrees,
    is_angle,
    short_decimal,
    squares,
)
from ..formula.names import GREEK, split_name
from ..formula.tree import (
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    number,
    power,
)
from ..formula.walk import equations
from ..frozen import frozen

SUM, FACTOR, BASE = 0, 1, 2
"""What stands around a formula: nothing or a sum, a product, a power."""

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


@frozen
class Signs:
    """The signs of one character set; ``fancy`` when it has Greek letters and raised digits."""

    fancy: bool
    times: str
    joint: str
    minus: str
    degree: str
    pi: str
    relations: Mapping[str, str]
    angles: frozenset[str] = frozenset()


UNICODE = Signs(True, " · ", "", "−", "°", "π", {"<=": "≤", ">=": "≥", "!=": "≠", "~": "∼"})
ASCII = Signs(False, " * ", "*", "-", " deg", "pi", {})


def print_formula(formula: Formula, signs: Signs, angle: bool = False) -> str:
    """Return a formula on one line; one that is an angle has its constants in degrees."""
    return _print(formula, signs, SUM, angle or is_angle(formula, signs.angles))


def print_side(formula: Formula, signs: Signs, angle: bool) -> str:
    """Return a side of a relation: a number alone is a decimal where it can be.

    >>> print_side(Number(Fraction(3, 4)), UNICODE, False)
    '0.75'
    """
    if isinstance(formula, Number) and not angle:
        return _number(formula.value, signs, SUM, decimal(formula.value))
    return print_formula(formula, signs, angle)


def print_name(name: str, signs: Signs) -> str:
    """Return a quantity's name.

    >>> [print_name(name, UNICODE) for name in ("alpha_1", "omega_O1B", "len_O1B")]
    ['α₁', 'ω_O₁B', 'O₁B']
    """
    if not signs.fancy:
        return name
    if name.startswith("len_"):
        return print_point(name.removeprefix("len_"), signs)
    head, primes, indices = split_name(name)
    letter = GREEK.get(head, head) + primes
    if indices and indices[0].isdigit():
        letter += indices[0].translate(_LOWERED)
        indices = indices[1:]
    return "_".join((letter, *(GREEK.get(i, print_point(i, signs)) for i in indices)))


def print_point(name: str, signs: Signs) -> str:
    """Return a point, a link or an index, its numbers lowered."""
    return name.translate(_LOWERED) if signs.fancy else name


def _print(formula: Formula, signs: Signs, around: int, angle: bool) -> str:
    constant = in_degrees(formula) if angle else None
    if constant is not None and formula != number(0):
        return _number(constant, signs, around, decimal(constant)) + signs.degree
    match formula:
        case Number(value):
            return _number(value, signs, around)
        case Pi():
            return signs.pi
        case Symbol(name):
            return print_name(name, signs)
        case Sum(terms):
            joined = "".join(_signed(t, signs, i == 0, angle) for i, t in enumerate(terms))
            return f"({joined})" if around else joined
        case Product():
            return _product(formula, signs, around, angle)
        case Power(base, exponent):
            return _power(base, exponent, signs, around)
        case Call(function, arguments):
            return _call(function, arguments, signs)
        case Implicit(system, index, _):
            zeros = ", ".join(f"{_print(e, signs, SUM, False)} = 0" for e in equations(formula))
            return f"({print_name(system.unknowns[index], signs)}: {zeros})"
        case _:
            assert_never(formula)


def _signed(term: Formula, signs: Signs, first: bool, angle: bool) -> str:
    printed = _print(term, signs, SUM, angle)
    if first:
        return printed
    if printed.startswith(signs.minus):
        return f" {signs.minus} {printed.removeprefix(signs.minus)}"
    return f" + {printed}"


def _number(value: Fraction, signs: Signs, around: int, figures: str | None = None) -> str:
    plain = (figures or short_decimal(value) or str(value)).replace("-", signs.minus)
    return f"({plain})" if (value < 0 and around) or ("/" in plain and around) else plain


def _product(formula: Product, signs: Signs, around: int, angle: bool) -> str:
    match formula.factors:
        case (Number(value), *rest) if decimal := short_decimal(abs(value)):
            follows = _row(tuple(rest), signs, angle)
            line = f"{signs.minus if value < 0 else ''}{decimal}{signs.times}{follows}"
            return f"({line})" if around == BASE or (around and value < 0) else line
    sign, first, second = fractions(formula)
    pieces = [_fraction(*part, signs, angle) for part in (first, second) if part != ((), ())]
    whole = ("" if sign > 0 else signs.minus) + signs.times.join(pieces)
    return f"({whole})" if around == BASE or (around and sign < 0) else whole


def _fraction(
    above: tuple[Formula, ...], below: tuple[Formula, ...], signs: Signs, angle: bool
) -> str:
    top = _row(above, signs, angle)
    if not below:
        return top
    bottom = _row(below, signs, angle)
    short = not (" " in top or " " in bottom)
    if len(below) > 1:
        bottom = f"({bottom})"
    return f"{top}/{bottom}" if short else f"{top} / {bottom}"


def _row(factors: tuple[Formula, ...], signs: Signs, angle: bool) -> str:
    """Return factors side by side, letters close together and functions apart."""
    if not factors:
        return "1"
    around = FACTOR if len(factors) > 1 else SUM
    if len(factors) == 1 and isinstance(factors[0], Sum):
        around = FACTOR
    line = _print(factors[0], signs, around, angle)
    for before, factor in pairwise(factors):
        close = _is_letter(before) and _is_letter(factor)
        line += (signs.joint if close else signs.times) + _print(factor, signs, around, angle)
    return line


def _is_letter(factor: Formula) -> bool:
    """Return whether a factor may stand close: a number, a letter, a letter's power."""
    base = factor.base if isinstance(factor, Power) else factor
    if isinstance(base, Symbol):
        head, _, indices = split_name(base.name)
        return (head in GREEK or len(head) == 1) and all(map(str.isdigit, indices))
    return isinstance(base, Number | Pi)


def _power(base: Formula, exponent: Formula, signs: Signs, around: int) -> str:
    match base, exponent:
        case _, Number(value) if value < 0:
            whole = _fraction((), (power(base, Number(-value)),), signs, False)
            return f"({whole})" if around else whole
        case _, Number(value) if value == Fraction(1, 2):
            return _call("sqrt", (base,), signs)
        case Call(function, (argument,)), Number(value) if (
            signs.fancy and function in TRIGONOMETRIC and value.denominator == 1
        ):
            return _applied(f"{function}{str(value).translate(_RAISED)}", argument, signs, True)
    inner = _print(base, signs, BASE, False)
    if isinstance(base, Power):
        inner = f"({inner})"
    if signs.fancy and isinstance(exponent, Number) and exponent.value.denominator == 1:
        return inner + str(exponent.value).translate(_RAISED)
    return f"{inner}^{_print(exponent, signs, BASE, False)}"


_INVERSE = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def _call(function: str, arguments: tuple[Formula, ...], signs: Signs) -> str:
    if function == "hypot":
        return _call("sqrt", (squares(arguments),), signs)
    if signs.fancy and function == "sqrt":
        return f"√({_print(arguments[0], signs, SUM, False)})"
    if signs.fancy and function == "abs":
        return f"|{print_formula(arguments[0], signs)}|"
    word = _INVERSE.get(function, function) if signs.fancy else function
    if len(arguments) == 1:
        return _applied(word, arguments[0], signs, function in TRIGONOMETRIC)
    return f"{word}({', '.join(print_formula(a, signs) for a in arguments)})"


def _applied(function: str, argument: Formula, signs: Signs, angle: bool) -> str:
    """Return a function of one argument, ``cos α`` without parentheses."""
    inner = print_formula(argument, signs, angle)
    bare = angle and signs.fancy and inner.replace("°", "").isalnum()
    return f"{function} {inner}" if bare else f"{function}({inner})"
