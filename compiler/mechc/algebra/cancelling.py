"""What cancels in a product: sums against sums, sines and cosines, and these against one another.

Two measures fall, one after the other. The *width* of a product is what its factors
reach over, each as often as its exponent says: of a sum the exponents from lowest to
highest in every symbol, of a sine or cosine the coefficients of its angle, twice. It is
additive (Ostrowski 1921), so whatever divides and is cancelled takes its own width away on
both sides; coefficients of angles are multiples of a part that :data:`FINEST` bounds.
Where no width is left to take away, the number of sines falls by joining them and by
relations between constants, which leave the width as it is.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction

from ..base.named import NamedTuple
from ..work import kept, spend
from . import common_divisors, factoring, laurent, sine_divisors
from .angle import Angle, rational
from .constants import is_constant, without_relations
from .factors import Trig
from .multiples import joined, without_parts
from .product import Product, Sum, WrittenProduct, as_product
from .trigonometry import cosine, sine

MOST_MULTIPLIED_TERMS = 96
"""A sum with more terms than this when multiplied out keeps its inner sums whole."""


DIVIDED = 1024
"""A sum with more terms than this when multiplied out is not divided by sines."""


def canonical(product: Product) -> Product:
    """Return the product with all cancelled that divides, and few sines of constants."""
    spend(2 + len(product.factors))
    if product.is_canonical or not _may_cancel(product):
        return product
    return _cancel_until_stable(product.written())


@kept
def _cancel_until_stable(written: WrittenProduct) -> Product:
    """Return a product after all rules of cancelling, one after another until none changes it."""
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
    if (
        sum(map(laurent.size, upper.terms)) > MOST_MULTIPLIED_TERMS
        or sum(map(laurent.size, lower.terms)) > MOST_MULTIPLIED_TERMS
    ):
        return None
    if common_divisors.is_searchable(laurent.Ring([*upper.terms, *lower.terms])):
        return _reduced(list(upper.terms), list(lower.terms))
    quotient = _reduced([*map(named, upper.terms)], [*map(named, lower.terms)])
    if quotient is None or not _width(quotient) < _width(Product(1, {upper: 1, lower: -1})):
        return None
    return quotient


def _reduced(upper: list[Product], lower: list[Product]) -> Product | None:
    ring = laurent.Ring([*upper, *lower])
    cofactors = common_divisors.reduced(ring, ring.expand(upper), ring.expand(lower))
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
    while (less := next(_with_divided_sum(product), None)) is not None:
        spend(10 * len(product.factors))
        product = less
    return product


def _with_divided_sum(product: Product) -> Iterator[Product]:
    """Yield a product with a sum divided by a sine or cosine that is across the line from it."""
    for whole, e in product.factors.items():
        if isinstance(whole, Sum) and sum(map(laurent.size, whole.terms)) <= DIVIDED:
            opposite = [f for f, d in product.factors.items() if isinstance(f, Trig) and e * d < 0]
            mentioned = sine_divisors.names_in(whole) if opposite else set()
            for trig in (f for f in opposite if sine_divisors.turned_by(f) in mentioned):
                if (split := sine_divisors.split_by(whole, trig)) is not None:
                    above = 1 if e > 0 else -1
                    yield without_parts(product * (split * Product(1, {whole: -1})) ** above)


# ----------------------------------------------------------------------------------- fine constants


_GRID = 15
"""Multiples of so many degrees are no fine constants."""


def named(product: Product) -> Product:
    """Return a product with a symbol for each constant that is not on a grid, such as 12.34°.

    A sum whose constants have too many conjugates to look into them all still has its factors in
    common with others; what can be lost are divisors that rest on a relation between these very
    constants.

    >>> from ..formula.to_text import text
    >>> text(named(sine(Angle.of("t") + Angle.constant(33))).formula())
    'sin(3° + t + pi/6)'
    """
    return _rewritten(product, _named)


def valued(product: Product) -> Product:
    """Return a product with such symbols replaced by their values."""
    return _rewritten(product, _valued)


def is_fine(name: object) -> bool:
    """Return whether a symbol stands for a fine constant."""
    return isinstance(name, str) and name.endswith("°")


def _rewritten(product: Product, rule: Callable[[Angle], Angle]) -> Product:
    """Return a product in which a rule has changed every angle, those in its sums too."""
    result = Product(product.coefficient)
    for factor, e in product.factors.items():
        match factor:
            case Trig(function, angle):
                result = result * (sine if function == "sin" else cosine)(rule(angle)) ** e
            case Sum(terms=terms):
                inner = Sum(tuple(_rewritten(t, rule) for t in terms))
                result = result * Product.of(inner, e)
            case _:
                result = result * Product.of(factor, e)
    return result


def _named(angle: Angle) -> Angle:
    fine = angle.degrees % _GRID
    if not fine:
        return angle
    size, sign = (fine, 1) if 2 * fine <= _GRID else (_GRID - fine, -1)
    on_grid = Angle(angle.terms, rational(angle.degrees - sign * size))
    return on_grid + Angle.of(f"{size}°") * sign


def _valued(angle: Angle) -> Angle:
    known = Angle.constant(angle.degrees)
    for name, c in angle.terms:
        if is_fine(name):
            known = known + Angle.constant(Fraction(name[:-1]) * c)
    return Angle(tuple(t for t in angle.terms if not is_fine(t[0]))) + known
