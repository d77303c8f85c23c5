"""Loads as linear forms in others, written with what their coefficients share outside."""

import math
from collections.abc import Mapping
from fractions import Fraction
from functools import reduce

from ..algebra.product import Product
from ..formula.operations import count_operations
from ..formula.tree import Formula, Symbol, product, total

Amounts = Mapping[str, Product]
"""How often each load enters, by its name."""


def linear_form(amounts: Amounts) -> Formula:
    """Return the sum of loads times their coefficients, in the shorter form.

    That is term by term, or with the factors that coefficients have in common outside.

    >>> from ..formula.to_text import text
    >>> a, b, c = map(Product.symbol, "abc")
    >>> text(linear_form({"P": a / c, "Q": (-b / c)}))
    '(a*P - b*Q)/c'
    >>> text(linear_form({"P": a / c, "Q": (a / c).scaled(Fraction(1, 2)), "W": b / c}))
    '(a*(P + Q/2) + b*W)/c'
    >>> text(linear_form({"P": a, "Q": b}))
    'a*P + b*Q'
    """
    kept = {load: amount for load, amount in amounts.items() if amount}
    plain = total(_terms(kept))
    if len(kept) < 2:
        return plain
    return min(plain, _gathered(kept), key=count_operations)


def _terms(amounts: Amounts) -> list[Formula]:
    return [product([(a.formula(), 1), (Symbol(load), 1)]) for load, a in amounts.items()]


def _gathered(amounts: Amounts) -> Formula:
    """Return the shared factors times the rest, loads of like coefficients together in it."""
    shared, rests = _parted(amounts)
    groups: dict[Product, dict[str, Product]] = {}
    for load, rest in rests.items():
        groups.setdefault(Product(1, rest.factors), {})[load] = rest
    return product([(shared.formula(), 1), (total(map(_group, groups.values())), 1)])


def _group(amounts: Amounts) -> Formula:
    """Return loads, each times a number, times what they have in common."""
    shared, numbers = _parted(amounts)
    return product([(shared.formula(), 1), (total(_terms(numbers)), 1)])


def _parted(amounts: Amounts) -> tuple[Product, Amounts]:
    """Return the factors that all coefficients share, with a number that all have, and the rest.

    Not all of the rest has a minus; what has none is first.
    """
    shared = Product(1, reduce(common, amounts.values()).factors)
    first, *others = (max(a.coefficient, -a.coefficient) for a in amounts.values())
    size = first if all(other == first for other in others) else 1
    is_negative = all(amount.coefficient < 0 for amount in amounts.values())
    shared = shared.scaled(-size if is_negative else size)
    rests = {load: amount / shared for load, amount in amounts.items()}
    return shared, dict(sorted(rests.items(), key=lambda item: item[1].coefficient < 0))


def common(x: Product, y: Product) -> Product:
    """Return the factors that two products have in common, the number with those of fractions.

    >>> a, b = map(Product.symbol, "ab")
    >>> common(a * a / b, a.scaled(2) / b) == a / b, common(a, a**-1) == Product()
    (True, True)
    """
    both = {f: min(e, y.factors[f], key=abs) for f, e in x.factors.items() if f in y.factors}
    one, other = (Fraction(p.coefficient) for p in (x, y))
    above = math.gcd(one.numerator, other.numerator)
    size = Fraction(above, math.lcm(one.denominator, other.denominator))
    alike = {f: e for f, e in both.items() if e * y.factors[f] > 0 < e * x.factors[f]}
    return Product(size, alike)
