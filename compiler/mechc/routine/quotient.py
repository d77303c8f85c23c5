"""How a product is computed, so that every target and the interpreter round alike.

Numerator and denominator are each multiplied from left to right, and one division
follows. A coefficient that is a short decimal (0.3) stays one number above the line;
any other is split, so that 1/2 and 2/3 are exact on both sides of it.
"""

from fractions import Fraction

from ..base.named import NamedTuple
from ..formula.tree import Formula, Number, Product, split_fraction

LARGEST_DENOMINATOR = 10**22
"""The largest power of ten that is a float; a decimal finer than that is no measured number."""


class Quotient(NamedTuple):
    """``± above / below``, the factors in order; ``below`` is empty where nothing divides."""

    negative: bool
    above: tuple[Formula, ...]
    below: tuple[Formula, ...]


def quotient_of(formula: Product) -> Quotient:
    """Return a product as numerator and denominator, coefficients leading.

    >>> quotient_of(Product((Number(Fraction(-2, 3)), Number(Fraction(1, 2)))))
    Quotient(negative=True, above=(), below=(Number(value=Fraction(3, 1)),))
    """
    coefficient, above, below = _apart(formula)
    size = abs(coefficient)
    if is_decimal(size) and size.denominator % 5 == 0:
        return Quotient(coefficient < 0, (Number(size), *above), tuple(below))
    return Quotient(
        coefficient < 0,
        (*_unless_one(size.numerator), *above),
        (*_unless_one(size.denominator), *below),
    )


def _apart(formula: Product) -> tuple[Fraction, list[Formula], list[Formula]]:
    """Return coefficient, numerator and denominator, products in them taken apart as well.

    They have no parentheses where they are printed: 1/(300·(a·b)) is computed as 1/(300·a·b).
    """
    coefficient, *sides = split_fraction(formula)
    parts: tuple[list[Formula], list[Formula]] = [], []
    for factors, (same, other) in zip(sides, (parts, parts[::-1]), strict=True):
        for factor in factors:
            if not isinstance(factor, Product):
                same.append(factor)
                continue
            inner, above, below = _apart(factor)
            coefficient *= inner if same is parts[0] else 1 / inner
            same.extend(above)
            other.extend(below)
    return coefficient, *parts


def is_decimal(value: Fraction) -> bool:
    """Return whether a rational is a finite decimal that is not too long to be printed.

    >>> is_decimal(Fraction(1, 8)), is_decimal(Fraction(1, 3))
    (True, False)
    """
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1 and value.denominator <= LARGEST_DENOMINATOR


def _unless_one(value: int) -> tuple[Number, ...]:
    return () if value == 1 else (Number(Fraction(value)),)
