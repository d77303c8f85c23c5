"""A ratio that is a multiple of an earlier one by lengths and numbers: what is said holds again."""

from collections.abc import Collection, Mapping

from ..algebra.factors import ConstantSymbol, Factor, Length
from ..algebra.from_formula import to_product
from ..formula.operations import count_operations
from ..formula.tree import Formula
from ..study.analysis import Multiple

MOST_DIVIDED_OPERATIONS = 100
"""Formulas of more operations are not divided by each other."""


def multiple(
    formula: Formula, earlier: Mapping[str, Formula], positive: Collection[str]
) -> Multiple | None:
    """Return of which earlier formula, by its name, one is a multiple, and how many times it.

    The factor is made of numbers and of lengths that are ``positive``, so that it has one sign.

    >>> from ..formula.tree import Call, Symbol, product
    >>> a, c, sine = Symbol("a"), Symbol("c"), Call("sin", (Symbol("phi"),))
    >>> k, i = product([(a, 1), (sine, 1)]), product([(a, -1), (c, -1), (sine, 1)])
    >>> multiple(i, {"k": k}, {"a", "c"}).name, multiple(i, {"k": k}, {"a"})
    ('k', None)
    """
    own = to_product(formula) if count_operations(formula) <= MOST_DIVIDED_OPERATIONS else None
    for name, other in earlier.items() if own and own.coefficient else ():
        known = to_product(other) if count_operations(other) <= MOST_DIVIDED_OPERATIONS else None
        if own and known and known.coefficient:
            factor = own / known
            if all(_is_positive(part, positive) for part in factor.factors):
                return Multiple(name, factor.formula(), factor.coefficient < 0)
    return None


def _is_positive(part: Factor, positive: Collection[str]) -> bool:
    match part:
        case ConstantSymbol():
            return part.evaluate({}) > 0
        case Length(name):
            return name in positive
        case _:
            return False
