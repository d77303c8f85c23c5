"""Conditions under which the signs in a formula with friction stay: it holds while they do."""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Literal

from ...algebra.from_formula import to_product
from ...algebra.intervals import IntervalBox, sign
from ...algebra.product import Product, Sum
from ...algebra.sums import add
from ...base.named import NamedTuple
from ...formula import tree
from ...formula.layout import has_minus
from ...formula.operations import count_operations
from ...formula.to_text import text
from ...formula.tree import Formula, negative, total
from .at_one_pose import SignsAtOnePose
from .names import bare, exact_sign, is_root

Operator = Literal["<", "<=", ">", ">=", "="]


class SignCondition(NamedTuple):
    """A force that keeps its ideal sign in the formula: ``sign · force > 0``."""

    sign: Product
    force: Product


def positive(conditions: Iterable[SignCondition]) -> tuple[Formula, ...]:
    """Return the formulas that must be positive for the forces to keep their senses."""
    kept = dict.fromkeys(c.sign * c.force for c in conditions)
    return tuple(force.formula() for force in kept if bare(force).factors)


def signed_part(formula: Formula, box: IntervalBox) -> tuple[Formula, Operator] | None:
    """Return which part of a product must have a sign for it to be positive; None where it is."""
    telling = bare(to_product(formula))
    known = {f: 1 if is_root(Product.of(f)) else sign(Product.of(f), box) for f in telling.factors}
    side = exact_sign(telling.coefficient) * math.prod(s for s in known.values() if s)
    left = Product(1, {f: 1 for f, s in known.items() if not s})
    return (left.formula(), ">" if side > 0 else "<") if left.factors else None


def conditions(signs: SignsAtOnePose) -> tuple[tuple[Formula, Operator], ...]:
    """Return the conditions under which signs stay what they are, the short ones first.

    They are met in an order that the lines of a description may have a part in.
    """
    met = (_condition(value, sign) for value, sign in _not_implied(signs).items())
    return tuple(sorted(met, key=lambda c: (count_operations(c[0]), text(c[0]))))


def _condition(value: Formula, sign: int) -> tuple[Formula, Operator]:
    """Return that a value has a sign; a sum of which it is negative is turned to be positive.

    One that would have minuses only stays as it is.
    """
    if sign < 0 and isinstance(value, tree.Sum) and any(map(has_minus, value.terms)):
        return total(sorted(map(negative, value.terms), key=has_minus)), ">"
    operators: Mapping[int, Operator] = {-1: "<", 0: "=", 1: ">"}
    return value, operators[sign]


def _not_implied(signs: SignsAtOnePose) -> Mapping[Formula, int]:
    """Return the signs that were noted, but for those that another one of them implies."""
    kept = dict(signs.conditions)
    products = {one: to_product(one).scaled(side) for one, side in kept.items() if side}
    for one, value in list(products.items()):
        others = (by for other, by in products.items() if other != one)
        if any(_implies(by, value, signs.box) for by in others):
            del kept[one], products[one]
    return kept


def _implies(value: Product, other: Product, box: IntervalBox) -> bool:
    """Return whether another value is positive where one is: it is that so many times, or more.

    Where h·s − ρ > 0, s is (h·s − ρ)/h + ρ/h.
    """
    ratios = (two / one for one in _terms(value) for two in _terms(other))
    for times in (ratio for ratio in ratios if sign(ratio, box) == 1):
        more = add((other, -(times * value)))
        if not more or sign(more, box) == 1:
            return True
    return False


def _terms(value: Product) -> Sequence[Product]:
    """Return the terms of a sum, or the product itself."""
    match list(value.factors.items()):
        case [(Sum() as only, 1)]:
            return [term.scaled(value.coefficient) for term in only.terms]
        case _:
            return [value]
