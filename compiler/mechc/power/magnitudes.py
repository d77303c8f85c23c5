"""Magnitudes: absolute values of products, lengths of vectors, square roots."""

import math
from collections.abc import Iterator
from fractions import Fraction

from ..algebra.angle import Rational, rational
from ..algebra.factors import Factor, Opaque, Trig
from ..algebra.from_formula import to_product
from ..algebra.intervals import IntervalBox, sign
from ..algebra.product import Product, Sum
from ..algebra.sums import add
from ..algebra.trigonometry import cosine
from ..formula.tree import ONE, Call, Formula, Number, Power, number, power, product, total
from ..formula.tree import Product as Factors
from ..formula.tree import Sum as Terms
from ..model.boxes import allowed_box
from ..model.mechanism import Mechanism
from ..pose.pose import Vector


def magnitude(value: Product, mechanism: Mechanism) -> Product:
    """Return the absolute value of a product.

    A length, or a sum of lengths, keeps the sign that it has over the ranges given, and
    without ranges for whatever the lengths may be; what else changes its sign, such as the
    difference of two lengths, or what depends on angles beyond a dead centre, is put
    between bars.
    """
    box, barred = allowed_box(mechanism), Product(1)
    result = Product(value.coefficient).scaled(1 if value.coefficient > 0 else -1)
    for factor, exponent in value.factors.items():
        part = Product.of(factor, exponent)
        sense = 1 if exponent % 2 == 0 or _is_root(factor) else _sense(Product.of(factor), box)
        result, barred = (result * part.scaled(sense), barred) if sense else (result, barred * part)
    return result * _bars(barred)


def _sense(factor: Product, box: IntervalBox) -> int:
    """Return the sign of a factor that no angle enters, 0 for others and where it is open."""
    if any(isinstance(f, Trig) and f.angle.terms for f in _leaves(factor)):
        return 0
    return sign(factor, box) or 0


def _leaves(value: Product) -> Iterator[Factor]:
    for factor in value.factors:
        if isinstance(factor, Sum):
            for term in factor.terms:
                yield from _leaves(term)
        else:
            yield factor


def _is_root(factor: Factor) -> bool:
    return (
        isinstance(factor, Opaque)
        and isinstance(factor.inside, Call)
        and (factor.inside.function == "sqrt")
    )


def _bars(value: Product) -> Product:
    above = Product(1, {f: e for f, e in value.factors.items() if e > 0})
    below = Product(1, {f: -e for f, e in value.factors.items() if e < 0})
    return _barred(above) / _barred(below)


def _barred(value: Product) -> Product:
    if not value.factors:
        return value
    return Product.of(Opaque(Call("abs", (value.formula(),))))


def even(value: Product) -> Product:
    """Return a product without bars around what has an even power."""
    result = value
    for factor, exponent in value.factors.items():
        match factor:
            case Opaque(Call("abs", (inner,))) if exponent % 2 == 0:
                result = result * Product.of(factor, -exponent) * to_product(inner) ** exponent
    return result


def largest_size(formula: Formula) -> Formula:
    """Return the size of a value, were every sine 1 and all terms of sums of one sign.

    >>> from ..formula.to_text import text
    >>> from ..formula.tree import Symbol, degrees, total
    >>> text(largest_size(total([Symbol("a"), Call("sin", (degrees(20),))])))
    'abs(a) + 1'
    """
    match formula:
        case Terms(terms):
            return total(map(largest_size, terms))
        case Factors(factors):
            return product((largest_size(factor), 1) for factor in factors)
        case Power(base, Number(exponent)) if exponent > 0:
            return power(largest_size(base), formula.exponent)
        case Call("sin" | "cos"):
            return ONE
        case Number(value):
            return number(abs(value))
        case _:
            return Call("abs", (formula,))


def length(vector: Vector) -> Product:
    """Return the length of a vector: an arm as it stands, else a root."""
    if len(vector) == 1:
        return vector[0].length
    square = add(a.length * b.length * cosine(a.angle - b.angle) for a in vector for b in vector)
    return root(square)


def root(square: Product) -> Product:
    """Return a square root, its sign open: even powers outside, the rest under the root.

    >>> from ..formula.to_text import text
    >>> text(root(Product.symbol("a").scaled(Fraction(3, 2))).formula())
    'sqrt(6*a)/2'
    """
    outside = Product(1, {f: e // 2 for f, e in square.factors.items() if e % 2 == 0})
    inside = {f: e for f, e in square.factors.items() if e % 2}
    size, coefficient = _without_fraction(square.coefficient)
    outside = outside.scaled(size)
    if coefficient == 1 and not inside:
        return outside
    under = Product(coefficient, inside).formula()
    return outside * Product.of(Opaque(Call("sqrt", (under,))))


WRITTEN_DENOMINATORS = 100
"""The denominators up to which a fraction under a root is a number that a person wrote."""


def _without_fraction(radicand: Rational) -> tuple[Rational, Rational]:
    """Return the factor before the root of a number, and what is left under it: 1 of a square."""
    whole, below = (math.isqrt(abs(n)) for n in (radicand.numerator, radicand.denominator))
    if Fraction(whole * whole, below * below) == radicand:
        return rational(Fraction(whole, below)), 1
    if radicand.denominator > WRITTEN_DENOMINATORS:
        return 1, radicand
    outside = below if below * below == radicand.denominator else radicand.denominator
    return rational(Fraction(1, outside)), rational(Fraction(radicand) * outside * outside)
