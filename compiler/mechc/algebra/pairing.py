"""Sines of a long sum in pairs: sin u + sin v is 2 sin((u + v)/2) cos((u − v)/2).

>>> from ..formula.to_text import text
>>> a, b, c = map(Angle.of, "abc")
>>> terms = [sine(a + b), sine(a - b), cosine(c)]
>>> text(paired(Sum(tuple(terms))).formula())
'2*sin(a)*cos(b) + cos(c)'
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from ..base.named import NamedTuple
from ..formula.operations import count_operations
from . import factoring
from .angle import QUARTER, Angle
from .factors import Trig
from .product import Product, Sum
from .trigonometry import cosine, sine

MOST_PAIRED_TERMS = 24
"""Sums of more terms are left as they are."""


class Wave(NamedTuple):
    """A term with one sine in it: ``rest · sin(angle)``."""

    rest: Product
    angle: Angle


def paired(whole: Sum) -> Product:
    """Return a sum with its sines in pairs, those first that come out shortest."""
    left = list(whole.terms)
    found: list[Product] = []
    while (
        len(left) + len(found) > 2
        and len(left) <= MOST_PAIRED_TERMS
        and (best := _best(left)) is not None
    ):
        one, other, product = best
        left = [term for term in left if term not in (one, other)]
        found.append(product)
    terms = sorted([*found, *left], key=lambda t: t.coefficient < 0)
    if not found:
        return Product.of(whole)
    sign = 1 if terms[0].coefficient > 0 else -1
    content = factoring.content_of(t.coefficient for t in terms) * sign
    return Product(content, {Sum(tuple(t.scaled(1 / Fraction(content)) for t in terms)): 1})


def _best(terms: Sequence[Product]) -> tuple[Product, Product, Product] | None:
    """Return two terms and the product that they are, the shortest one."""
    pairs = (
        (one, other, product)
        for one, other in combinations(terms, 2)
        for product in _product(one, other)
    )
    return min(pairs, key=lambda p: count_operations(p[2].formula()), default=None)


def _product(one: Product, other: Product) -> Iterator[Product]:
    first, second = _wave(one), _wave(other)
    if first is None or second is None or first.rest not in (second.rest, -second.rest):
        return
    half, apart = (first.angle + second.angle).half(), (first.angle - second.angle).half()
    if half.degrees % 90 == 0 and all(c.denominator == 1 for _, c in half.terms):
        alike = first.rest == second.rest
        sines = sine(half) * cosine(apart) if alike else cosine(half) * sine(apart)
        yield first.rest.scaled(2) * sines


def _wave(term: Product) -> Wave | None:
    trigs = [(f, e) for f, e in term.factors.items() if isinstance(f, Trig)]
    match trigs:
        case [(Trig(function, angle) as trig, 1)]:
            turned = angle if function == "sin" else angle + QUARTER
            return Wave(term / Product.of(trig), turned)
    return None
