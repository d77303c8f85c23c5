"""Sines and cosines of multiples of one angle: cancelled by one another, and joined.

>>> from ..formula.to_text import text
>>> from .angle import Angle
>>> a = Angle.of("a")
>>> text(without_parts(cosine(a * 3) / cosine(a)).formula())
'2*cos(2*a) - 1'
>>> text(without_parts(sine(a * 4) / sine(a)).formula())
'4*cos(2*a)*cos(a)'
"""

from collections.abc import Iterator
from fractions import Fraction

from ..base.named import NamedTuple
from ..work import spend
from . import factoring
from .angle import QUARTER
from .factors import Trig
from .product import ONE, Product
from .trigonometry import cosine, sine

_DOUBLINGS = (2, 4, 8, 16)
"""sin 16u / sin u is seen to cancel; sin 32u / sin u is not."""


class _Pair(NamedTuple):
    """Two trigs on either side of the line, and how often they are."""

    whole: Trig
    part: Trig
    times: int


def without_parts(product: Product) -> Product:
    """Return a product without sines that divide the sine of a multiple across the line.

    Measure: the sum of |exponent · coefficient of a symbol| over all sines and cosines,
    those inside of sums left out: sin 4u/sin u is 5, 4 cos u cos 2u is 3. Each step takes
    twice the part's own away, and never makes a coefficient that is no multiple of it.
    """
    while (less := _one_part_less(product)) is not None:
        spend(10 * len(product.factors))
        product = less
    return product


def _one_part_less(product: Product) -> Product | None:
    for pair in _pairs(product):
        if (ratio := _ratio(pair.whole, pair.part)) is not None:
            times = pair.times if product.factors[pair.whole] > 0 else -pair.times
            return product * Product(1, {pair.whole: -times, pair.part: times}) * ratio**times
    return None


def _pairs(product: Product) -> Iterator[_Pair]:
    """Yield a sine and one across the line whose angle is a part of its own."""
    lines: dict[tuple[str, ...], list[tuple[Trig, int]]] = {}
    for factor, e in product.factors.items():
        if isinstance(factor, Trig) and factor.angle.terms:
            names = tuple(name for name, _ in factor.angle.terms)
            lines.setdefault(names, []).append((factor, e))
    for trigs in lines.values():
        for whole, e in trigs:
            for part, d in trigs:
                if e * d < 0:
                    yield _Pair(whole, part, min(abs(e), abs(d)))


def _ratio(whole: Trig, part: Trig) -> Product | None:
    """Return sin(n·u)/sin(u) for n = 2, 4, 8, 16 and 3, None if that is not what both are.

    With n = 2^m it is 2^m · cos u · cos 2u · cos 4u · … · cos(n/2·u), and sin 3u/sin u is
    1 + 2 cos 2u. A cosine is the sine of an angle of a quarter turn more.
    """
    n = Fraction(whole.angle.terms[0][1]) / part.angle.terms[0][1]
    if n not in _DOUBLINGS and n != 3:
        return None
    angle = part.angle if part.function == "sin" else part.angle + QUARTER
    multiple, below = sine(angle * int(n)), sine(angle)
    if whole not in multiple.factors:
        return None
    sign = multiple.coefficient * below.coefficient
    if n == 3:
        return factoring.factored([ONE, cosine(angle * 2).scaled(2)]).scaled(sign)
    quotient = Product(sign)
    for doubling in (1, *_DOUBLINGS):
        if doubling < n:
            quotient = quotient * cosine(angle * doubling).scaled(2)
    return quotient


def joined(product: Product) -> Product:
    """Return a product with sin u · cos u on one side of the line written as sin 2u / 2.

    Measure: the number of sines and cosines of what varies, which each step lessens.
    """
    while (fewer := _join_one(product)) is not None:
        spend(10 * len(product.factors))
        product = fewer
    return product


def _join_one(product: Product) -> Product | None:
    """Return a product with the first sin x·cos x in it as sin(2x)/2; None without one."""
    for trig, s in product.factors.items():
        if isinstance(trig, Trig) and trig.function == "sin" and trig.angle.terms:
            twin = Trig("cos", trig.angle)
            c = product.factors.get(twin, 0)
            if s * c > 0:
                both = min(s, c) if s > 0 else max(s, c)
                double = sine(trig.angle * 2) * Product(Fraction(1, 2))
                return product * (double * Product(1, {trig: -1, twin: -1})) ** both
    return None
