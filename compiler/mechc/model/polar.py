"""Vectors whose components are written by a length and an angle: ``(a*cos(t), a*sin(t))``."""

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from ..algebra.angle import Angle
from ..algebra.factors import Trig
from ..algebra.product import Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine


class Polar(NamedTuple):
    """A vector by its length and its direction."""

    length: Product
    angle: Angle


def polar(x: Product, y: Product, values: Mapping[str, float]) -> Polar | None:
    """Return the length and angle of a vector, None where it is not written by them.

    ``values`` tell the sign of the length.

    >>> a, t = Product.symbol("a"), Angle.of("t")
    >>> found = polar(a * sine(t), -a * cosine(t), {"a": 1.0})
    >>> found.length == a, str(found.angle)
    (True, 't - 90°')
    """
    length = _root(add([x * x, y * y]))
    if length is None or not length:
        return None
    if length.evaluate(values) < 0:
        length = -length
    ahead, across = x / length, y / length
    for trig in (factor for factor in ahead.factors if isinstance(factor, Trig)):
        turned = (
            trig.angle * sign + Angle.constant(q) for sign in (1, -1) for q in (0, 90, -90, 180)
        )
        for angle in turned:
            if cosine(angle) == ahead and sine(angle) == across:
                return Polar(length, angle)
    return None


def _root(square: Product) -> Product | None:
    """Return the square root of a product, None where it is no product."""
    number = Fraction(square.coefficient)
    above, below = math.isqrt(max(number.numerator, 0)), math.isqrt(number.denominator)
    is_square = Fraction(above, below) ** 2 == number
    if not is_square or any(exponent % 2 for exponent in square.factors.values()):
        return None
    factors = {factor: exponent // 2 for factor, exponent in square.factors.items()}
    return Product(Fraction(above, below), factors)
