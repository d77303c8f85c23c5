"""The length of a formula: how many operations it takes."""

from typing import assert_never

from .tree import (
    Call,
    Compound,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    split_fraction,
)


def count_operations(formula: Formula) -> int:
    """Return the number of operations, counted as sympy's ``count_ops`` counts them.

    >>> from .tree import number, product
    >>> a, b, t = Symbol("a"), Symbol("b"), Symbol("t")
    >>> count_operations(product([(number(2), 1), (b, 1), (a, -1), (Call("cot", (t,)), 1)]))
    4
    """
    if not isinstance(formula, Compound):
        return _of_a_number(formula)
    known: int | None = getattr(formula, "operations_in_it", None)
    if known is None:
        known = _counted(formula)
        object.__setattr__(formula, "operations_in_it", known)
    return known


def _of_a_number(formula: Number | Pi | Symbol) -> int:
    """Count the minus sign and the division in a number; a name has none."""
    if not isinstance(formula, Number):
        return 0
    return (formula.value < 0) + (formula.value.denominator != 1)


def _counted(formula: Sum | Product | Power | Call | Implicit) -> int:
    """Return the operations of a formula that is made of others."""
    match formula:
        case Sum(terms):
            return sum(map(_term_operations, terms)) + len(terms) - 1
        case Product():
            return _product_operations(formula)
        case Power(base, exponent):
            return 1 + count_operations(base) + count_operations(exponent) - _negated(exponent)
        case Call(_, arguments):
            return 1 + sum(map(count_operations, arguments))
        case Implicit(system, _, arguments):
            return sum(map(count_operations, (*system.equations, *arguments)))
        case _:
            assert_never(formula)


def _negated(exponent: Formula) -> int:
    return 1 if isinstance(exponent, Number) and exponent.value < 0 else 0


def _term_operations(term: Formula) -> int:
    """Count a term of a sum: its minus sign is the subtraction itself."""
    negated = (isinstance(term, Number) and term.value < 0) or (
        isinstance(term, Product)
        and isinstance(term.factors[0], Number)
        and term.factors[0].value < 0
    )
    return count_operations(term) - bool(negated)


def _product_operations(formula: Product) -> int:
    coefficient, above, below = split_fraction(formula)
    upper = len(above) + (abs(coefficient.numerator) != 1)
    lower = len(below) + (coefficient.denominator != 1)
    operations = max(upper - 1, 0) + max(lower - 1, 0) + (lower > 0) + (coefficient < 0)
    return operations + sum(map(count_operations, above)) + sum(map(count_operations, below))
