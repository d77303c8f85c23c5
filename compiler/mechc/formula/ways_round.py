"""Differences of angles one way round in all formulas of a page.

Where one formula has sin(a − b) and another cos(b − a), a person has a − b in both.
"""

import math
from collections.abc import Iterable, Set

from .differences import LazyValues
from .evaluate import SharedEvaluation
from .layout import has_minus
from .positive_divisors import NO_SIGN, with_opposites
from .rewriting import (
    FUNCTIONS_OF_ANGLES,
    by_opposite,
    by_tangent,
    in_reading_order,
    opposite_angle,
    rewritten,
)
from .tree import Call, Formula, Product, Sum, negative, total
from .walk import symbols, walk

Difference = frozenset[Formula]
"""The terms of a difference of angles, but for angles by which friction turns it."""


def ways_round(
    formulas: Iterable[Formula], values: LazyValues, turns: Set[str] = frozenset()
) -> Set[Difference]:
    """Return those differences of angles that formulas have either way round, in the one to keep.

    Its sine is positive at the values. Angles by which friction ``turns`` a force make no other
    difference.

    >>> from .tree import Symbol, product
    >>> a, b = map(Symbol, "ab")
    >>> one, other = total([a, negative(b)]), total([b, negative(a)])
    >>> ways = ways_round([Call("cos", (one,)), Call("sin", (other,))], lambda: {"a": 1, "b": 2})
    >>> ways == {frozenset({b, negative(a)})}
    True
    """
    nodes = (node for formula in formulas for node in walk(formula))
    met = dict.fromkeys(found for node in nodes if (found := _difference(node, turns)))
    kept: set[Difference] = set()
    for one in met:
        if _opposite(one) in met and _opposite(one) not in kept:
            kept.add(_opposite(one) if _is_negative(one, values) else one)
    return kept


def written_round(formula: Formula, ways: Set[Difference], turns: Set[str]) -> Formula:
    """Return a formula whose differences of angles are the way round that they are in ``ways``.

    >>> from .tree import Symbol, product
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> one, other = total([a, negative(b)]), total([b, negative(a)])
    >>> slope = product([(Call("cos", (one,)), 1), (Call("sin", (other,)), -1)])
    >>> text(written_round(slope, {frozenset({b, negative(a)})}, set()))
    'cot(b - a)'
    >>> far = total([product([(Call("sin", (one,)), -1), (a, 1)]), negative(b)])
    >>> text(written_round(product([(far, 1), (a, 1)]), {frozenset({b, negative(a)})}, set()))
    '-(a/sin(b - a) + b)*a'
    """

    def turned(whole: Formula) -> Formula | None:
        match whole:
            case Call(function, (Sum() as angle,)) if found := _difference(whole, turns):
                if found not in ways and _opposite(found) in ways:
                    return by_opposite(function, opposite_angle(angle))
            case Product(factors):
                return _signs_before(by_tangent(factors) or whole)
        return None

    written = rewritten(formula, turned) if ways else formula
    return written if written == formula else _minus_into_sum(written)


def _minus_into_sum(formula: Formula) -> Formula:
    """Return a product without a minus where a sum in it has terms with one and without one.

    >>> from .tree import Symbol, product
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> text(_minus_into_sum(negative(product([(a, 1), (total([a, negative(b)]), 1)]))))
    'a*(b - a)'
    """
    if not isinstance(formula, Product) or not has_minus(formula):
        return formula
    sums = [(i, f) for i, f in enumerate(formula.factors) if isinstance(f, Sum)]
    mixed = [(i, f) for i, f in sums if len(set(map(has_minus, f.terms))) > 1]
    turned = {i: total(in_reading_order(map(negative, f.terms))) for i, f in mixed[:1]}
    return with_opposites(formula.factors, turned) if turned else formula


def _signs_before(formula: Formula) -> Formula:
    """Return a product with the minus before it that all terms of a sum in it have."""
    if not isinstance(formula, Product):
        return formula
    sums = [(i, f) for i, f in enumerate(formula.factors) if isinstance(f, Sum)]
    behind = {i: negative(f) for i, f in sums if all(map(has_minus, f.terms))}
    return with_opposites(formula.factors, behind) if behind else formula


def _difference(node: Formula, turns: Set[str]) -> Difference | None:
    """Return the terms of the difference that a function is taken of, but for turns; else None."""
    match node:
        case Call(function, (Sum(terms),)) if function in FUNCTIONS_OF_ANGLES:
            found = frozenset(term for term in terms if not symbols(term) or symbols(term) - turns)
            return found if len(set(map(has_minus, found))) > 1 else None
    return None


def _opposite(difference: Difference) -> Difference:
    return frozenset(map(negative, difference))


def _is_negative(difference: Difference, values: LazyValues) -> bool:
    """Return whether the sine of a difference is negative; False where it has no value."""
    try:
        return math.sin(SharedEvaluation(values()).of(total(difference))) < -NO_SIGN
    except KeyError:
        return False
