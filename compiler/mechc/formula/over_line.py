"""Numbers of quotients as whole numbers above and below the line, for formulas that mechc derives.

A decimal that leads a quotient was made by multiplying lengths such as 2.5a and 5a.
"""

from .tree import Formula, Number, Power, Product, number
from .walk import children, rebuild

LARGEST = 10
"""Whole numbers up to this are read at a glance, above a line and below it."""


def over_line(formula: Formula) -> Formula:
    """Return a formula whose quotients have small whole numbers for a decimal.

    >>> from .to_text import text
    >>> from fractions import Fraction
    >>> from .tree import Call, Symbol, product
    >>> sines = [(Call("sin", (Symbol("b"),)), 1), (Call("sin", (Symbol("c"),)), -1)]
    >>> [text(over_line(product([(number(Fraction(n, 5)), 1), *sines]))) for n in (1, 2)]
    ['sin(b)/(5*sin(c))', '2*sin(b)/(5*sin(c))']
    """
    parts = tuple(map(over_line, children(formula)))
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    match whole:
        case Product((Number(value), *rest)) if any(map(_divides, rest)):
            above, below = value.numerator, value.denominator
            if below in (5, 10) and abs(above) < LARGEST:
                lead = () if above == 1 else (number(above),)
                return Product((*lead, Power(number(below), number(-1)), *rest))
    return whole


def _divides(factor: Formula) -> bool:
    """Return whether a factor stands below the line."""
    match factor:
        case Power(_, Number(value)):
            return value < 0
    return False
