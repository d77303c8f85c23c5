"""What cancels in a product: sums against sums, sines and cosines, and these against one another.

Two measures fall, one after the other. The *width* of a product is what its factors
reach over, each as often as its exponent says: of a sum the exponents from lowest to
highest in every symbol, of a sine or cosine the coefficients of its angle, twice. It is
additive (Ostrowski 1921), so whatever divides and is cancelled takes its own width away on
both sides; coefficients of angles are multiples of a part that :data:`FINEST` bounds.
Where no width is left to take away, the number of sines falls by joining them and by
relations between constants, which leave the width as it is.
"""

from collections.abc import Iterator
from fractions import Fraction

from ..named import NamedTuple
from ..work import kept, spend
from . import factoring, halving, laurent, reduction
from .constants import is_constant, without_relations
from .factors import Trig
from .fine import is_fine, named, valued
from .multiples import joined, without_parts
from .product import Product, Sum, Written, as_product

LIMIT = 96
"""A sum with more terms than this when multiplied out keeps its inner sums whole."""


DIVIDED = 1024
"""A sum with more terms than this when multiplied out is not divided by sines."""


def canonical(product: Product) -> Product:
    """Return the product with all cancelled that divides, and few sines of constants."""
    spend(2 + len(product.factors))
    if product.is_canonical or not _may_cancel(product):
        return product
    return _cancelled(product.written())


@kept
def _cancelled(written: Written) -> Product:
    product, before = as_product(written), None
    while product is not before:
        spend(10 * len(product.factors))
        before = product
        product = joined(without_parts(_without_divisors(_without_common(product))))
    related = without_relations(product)
    related.is_canonical = related is product
    return related


def _may_cancel(product: Product) -> bool:
    """Return whether there are two sines, cosines or sums in a product."""
    found = [(f, e) for f, e in product.factors.items() if isinstance(f, (Trig, Sum))]
    return len(found) > 1 or any(abs(e) > 1 and is_constant(f) for f, e in found)


# ----------------------------------------------------------------------- sums by sums


def _without_common(product: Product) -> Product:
    """Cancel what a sum above the line and one below it have in common.

    Measure: the width of the two, which their quotient has less of.
    """
    sums = [(f, e) for f, e in product.factors.items() if isinstance(f, Sum)]
    for upper, e in sums:
        for lower, d in sums:
            if e > 0 > d and (quotient := _quotient(upper, lower)) is not None:
                return _without_common(product * Product(1, {upper: -1, lower: 1}) * quotient)
    return product


def _quotient(upper: Sum, lower: Sum) -> Product | None:
    """Return the quotient of two sums without their common divisor, None if they have none."""
    if sum(map(laurent.size, upper.terms)) > LIMIT or sum(map(laurent.size, lower.terms)) > LIMIT:
        return None
    if reduction.is_searchable(laurent.Ring([*upper.terms, *lower.terms])):
        return _reduced(list(upper.terms), list(lower.terms))
    quotient = _reduced([*map(named, upper.terms)], [*map(named, lower.terms)])
    if quotient is None or not _width(quotient) < _width(Product(1, {upper: 1, lower: -1})):
        return None
    return quotient


def _reduced(upper: list[Product], lower: list[Product]) -> Product | None:
    ring = laurent.Ring([*upper, *lower])
    cofactors = reduction.reduced(ring, ring.expand(upper), ring.expand(lower))
    if cofactors is None:
        return None
    above, below = (factoring.factored([valued(factoring.factor(ring, c))]) for c in cofactors)
    return above / below


class _Width(NamedTuple):
    """The width of a product in its symbols, then with fine constants as symbols, too."""

    symbols: Fraction
    all: Fraction


def _width(product: Product) -> _Width:
    """Return the width of a product."""
    factors = [(named(Product.of(f)), abs(e)) for f, e in product.factors.items()]
    ring = laurent.Ring([f for f, _ in factors])
    widths = [(ring.width(ring.expand([f]).terms), e) for f, e in factors]
    every = [(name, e * w) for width, e in widths for name, w in width.items()]
    total = sum((w for _, w in every), Fraction())
    fine = sum((w for name, w in every if is_fine(name)), Fraction())
    return _Width(total - fine, total)


# ---------------------------------------------------------------------- sums by sines


def _without_divisors(product: Product) -> Product:
    """Cancel what a sum has in common with a sine or cosine across the line, or with half of it.

    Measure: the width of the sum, which that of the sine, or half of it, is taken from.
    """
    while (less := next(_divided(product), None)) is not None:
        spend(10 * len(product.factors))
        product = less
    return product


def _divided(product: Product) -> Iterator[Product]:
    for whole, e in product.factors.items():
        if isinstance(whole, Sum) and sum(map(laurent.size, whole.terms)) <= DIVIDED:
            opposite = [f for f, d in product.factors.items() if isinstance(f, Trig) and e * d < 0]
            mentioned = halving.names_in(whole) if opposite else set()
            for trig in (f for f in opposite if halving.turned_by(f) in mentioned):
                if (split := halving.split_by(whole, trig)) is not None:
                    above = 1 if e > 0 else -1
                    yield without_parts(product * (split * Product(1, {whole: -1})) ** above)
