"""Sines and cosines that divide a sum, or half the angle of which does.

cos θ + sin(θ − α) vanishes with cos α on one of the two branches on which cos α does:
both hold cos(45° + α/2). Sums are factored in the angles and constants that they mention,
so that only what is on the other side of the line decides what else is wanted.
"""

import math
from collections.abc import Iterable, Iterator
from zlib import crc32

from ..formula.walk import symbols
from . import factoring, laurent
from .angle import QUARTER, Angle
from .factors import Trig
from .product import Product, Sum
from .tolerances import ROUNDED_SUM
from .trigonometry import cosine, sine

FINEST_PART = 64
"""Angles are halved down to this part of a symbol, and no further."""


def split_by(sum_: Sum, trig: Trig) -> Product | None:
    """Return a sum as (the trig, or half of its angle's) · (rest), None if none divides it.

    >>> from ..formula.to_text import text
    >>> a, t = Angle.of("a"), Angle.of("t")
    >>> (c,) = cosine(a).factors
    >>> split = split_by(Sum((cosine(t), sine(t - a))), c)
    >>> text(split.formula())
    '2*cos(a/2 + pi/4)*cos(a/2 - t + pi/4)'
    """
    for part in _parts(trig):
        if (rest := _divided(sum_, part)) is not None:
            return Product.of(part) * rest
    return None


def names_in(sum_: Sum) -> set[str]:
    """Return the names that a sum depends on, those of bound sums among them."""
    found: set[str] = set()
    for part in {part for term in sum_.terms for part in term.factors}:
        match part:
            case Trig(_, angle):
                found.update(angle.names)
            case Sum():
                found |= names_in(part)
            case _:
                found |= symbols(part.formula())
    return found


def turned_by(trig: Trig) -> str:
    """Return the name by which a sine or cosine is brought to zero; '' for a constant one.

    It divides no sum in which this name does not occur.
    """
    return trig.angle.terms[0][0] if trig.angle.terms else ""


def without(sum_: Sum, trigs: Iterable[Trig]) -> Product:
    """Return a sum divided by each of some sines and cosines as often as it can be.

    Measure: the width of the sum.
    """
    rest = Product.of(sum_)
    for trig in trigs:
        while (split := _split_off(rest, trig)) is not None:
            rest = split
    return rest


def _split_off(product: Product, trig: Trig) -> Product | None:
    """Return a product with one of its sums divided by a trig, None if that divides none."""
    for whole in product.factors:
        if isinstance(whole, Sum) and (rest := _divided(whole, trig)) is not None:
            return product * Product(1, {whole: -1}) * rest
    return None


def _divided(sum_: Sum, part: Trig) -> Product | None:
    """Return a sum divided by a sine or cosine, None if it is no divisor."""
    if not _vanishes_with(sum_, part):
        return None
    ring = laurent.Ring([*sum_.terms, Product.of(part)])
    scale, terms = ring.expand(sum_.terms)
    quotient = ring.divide(terms, part)
    if quotient is None:
        return None
    return Product(2) * factoring.factor(ring, laurent.Polynomial(scale, quotient))


def _parts(trig: Trig) -> Iterator[Trig]:
    """Yield a sine or cosine of what varies, and the two that it is the double product of."""
    if not trig.angle.terms:
        return
    yield trig
    angle = trig.angle + (QUARTER if trig.function == "cos" else Angle())
    half = angle.half()
    if all(c.denominator <= FINEST_PART for _, c in half.terms):
        for part in (*sine(half).factors, *cosine(half).factors):
            assert isinstance(part, Trig)
            yield part


def _vanishes_with(sum_: Sum, part: Trig) -> bool:
    """Return whether, in numbers, a sum is zero where a factor is: before the division.

    It is measured by its terms somewhere else: there all of them may be zero.
    """
    values = GenericValues()
    size = max(abs(term.evaluate(values)) for term in sum_.terms)
    name, c = part.angle.terms[0]
    zero = 0.0 if part.function == "sin" else math.pi / 2
    values[name] += (zero - part.angle.evaluate(values)) / float(c)
    return abs(math.fsum(term.evaluate(values) for term in sum_.terms)) <= ROUNDED_SUM * size


class GenericValues(dict[str, float]):
    """A value between one and two for every name, at which nothing vanishes by chance."""

    def __missing__(self, name: str) -> float:
        self[name] = value = 1 + crc32(name.encode()) / 2**32
        return value
