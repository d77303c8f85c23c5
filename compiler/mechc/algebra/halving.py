"""Sines and cosines of half an angle that divide a sum.

cos θ + sin(θ − α) vanishes with cos α on one of the two branches on which cos α does:
both hold cos(45° + α/2). Sums are factored in the angles that they mention, so that only
what stands on the other side of the line tells that its half is wanted.
"""

import math
from zlib import crc32

from .angle import Angle
from .factoring import factor
from .factors import Trig
from .laurent import Polynomial, Ring
from .product import Product, Sum
from .trigonometry import cosine, sine

NIL = 1e-9


def split_by_half(sum_: Sum, trig: Trig) -> Product | None:
    """Return a sum as (half of the trig's angle) · (rest), None if no half divides it.

    >>> from ..formula.to_text import text
    >>> a, t = Angle.of("a"), Angle.of("t")
    >>> (c,) = cosine(a).factors
    >>> split = split_by_half(Sum((cosine(t), sine(t - a))), c)
    >>> text(split.formula())
    '2*cos(a/2 + pi/4)*cos(a/2 - t + pi/4)'
    """
    angle = trig.angle + (Angle.constant(90) if trig.function == "cos" else Angle())
    for half in (*sine(angle.half()).factors, *cosine(angle.half()).factors):
        if isinstance(half, Trig) and half.angle.terms and _vanishes_with(sum_, half):
            ring = Ring([*sum_.terms, Product.of(half)])
            scale, terms = ring.expand(sum_.terms)
            quotient = ring.divide(terms, half)
            if quotient is not None:
                return Product(2, {half: 1}) * factor(ring, Polynomial(scale, quotient))
    return None


def _vanishes_with(sum_: Sum, half: Trig) -> bool:
    """Tell by numbers, before the division, whether a sum is zero where a factor is."""
    values = _Anything()
    name, c = half.angle.terms[0]
    zero = 0.0 if half.function == "sin" else math.pi / 2
    values[name] += (zero - half.angle.evaluate(values)) / float(c)
    parts = [term.evaluate(values) for term in sum_.terms]
    return abs(math.fsum(parts)) <= NIL * max(map(abs, parts))


class _Anything(dict[str, float]):
    """A number between one and two for every name."""

    def __missing__(self, name: str) -> float:
        self[name] = value = 1 + crc32(name.encode()) / 2**32
        return value
