"""From formulas to angle algebra: which part of a formula it can look into.

>>> from ..formula.tree import Symbol, Call, degrees, total, quotient
>>> from ..formula.to_text import text
>>> str(to_angle(total([Symbol("alpha"), degrees(-90)])))
'alpha - 90°'
>>> text(to_product(quotient(Call("sin", (Symbol("t"),)), Call("cos", (Symbol("t"),)))).formula())
'tan(t)'
"""

from fractions import Fraction
from typing import assert_never

from ..formula.tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
)
from .angle import HALF_TURN, RADIAN, Angle, rational
from .factors import ConstantSymbol, Opaque
from .modular import PARTS
from .product import Product as Factored
from .sums import add
from .trigonometry import cosine, sine

_QUOTIENTS = {"tan": (1, -1), "cot": (-1, 1), "sec": (0, -1), "csc": (-1, 0)}
"""Powers of (sin, cos) that a function stands for."""


def to_angle(formula: Formula) -> Angle | None:
    """Return a formula as an angle if it is linear in its symbols with rational coefficients.

    Constants are exact to twenty decimals of a degree, coefficients must be.
    """
    angle = _linear(formula)
    if angle is None or any((c * PARTS).denominator != 1 for _, c in angle.terms):
        return None
    return Angle(angle.terms, rational(Fraction(round(angle.degrees * PARTS), PARTS)))


def _linear(formula: Formula) -> Angle | None:
    """Return a formula as an angle; None where it is no sum of names with rational factors."""
    match formula:
        case Number(value):
            return Angle(((RADIAN, rational(value)),)) if value else Angle()
        case Pi():
            return HALF_TURN
        case Symbol(name):
            return Angle.of(name)
        case Sum(terms):
            return _sum_of_angles(terms)
        case Product(factors):
            return _scaled_angle(factors)
        case Power() | Call() | Implicit():
            return None
        case _:
            assert_never(formula)


def _sum_of_angles(terms: tuple[Formula, ...]) -> Angle | None:
    result = Angle()
    for term in terms:
        angle = _linear(term)
        if angle is None:
            return None
        result = result + angle
    return result


def _scaled_angle(factors: tuple[Formula, ...]) -> Angle | None:
    """Return a product as an angle times a number; None where two of its factors vary."""
    scale, angle = Fraction(1), None
    for factor in factors:
        if isinstance(factor, Number):
            scale *= factor.value
        elif angle is None:
            angle = _linear(factor)
            if angle is None:
                return None
        else:
            return None
    return angle * scale if angle is not None else _linear(Number(scale))


def to_product(formula: Formula) -> Factored:
    """Return any formula as a factored product; what is not algebra becomes opaque."""
    match formula:
        case Number(value):
            return Factored(rational(value))
        case Constant(name, value):
            return Factored.of(ConstantSymbol(name, value))
        case Symbol(name):
            return Factored.symbol(name)
        case Sum(terms):
            return add(map(to_product, terms))
        case Product(factors):
            result = Factored(1)
            for factor in factors:
                result = result * to_product(factor)
            return result
        case Power(base, Number(value)) if value.denominator == 1:
            return to_product(base) ** value.numerator
        case Call(function, (argument,)) if function in ("sin", "cos", *_QUOTIENTS):
            return _trigonometric(function, argument)
        case Call("exp", (argument,)):
            return _exponential(to_product(argument))
        case Pi() | Power() | Call() | Implicit():
            return Factored.of(Opaque(formula))
        case _:
            assert_never(formula)


def _trigonometric(function: str, argument: Formula) -> Factored:
    angle = to_angle(argument)
    if angle is None:
        return Factored.of(Opaque(Call(function, (argument,))))
    if function in _QUOTIENTS:
        s, c = _QUOTIENTS[function]
        return sine(angle) ** s * cosine(angle) ** c
    return sine(angle) if function == "sin" else cosine(angle)


def _exponential(argument: Factored) -> Factored:
    """Return e^x, as 1/e^(−x) where x has a minus, so that both are one."""
    size = -argument if argument.coefficient < 0 else argument
    whole = Factored.of(Opaque(Call("exp", (size.formula(),))))
    return whole if size is argument else whole**-1


def is_transparent(product: Factored) -> bool:
    """Return whether nothing in a product is opaque."""
    return not any(isinstance(f, Opaque) for f in product.factors)
