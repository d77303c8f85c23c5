"""Sines and cosines in canonical form."""

from fractions import Fraction
from functools import lru_cache

from .angle import Angle, Rational, rational
from .factors import Trig
from .product import Product


@lru_cache(maxsize=4096)
def sine(angle: Angle) -> Product:
    """Return sin(angle) in canonical form: a sign and a first-quadrant-like factor.

    >>> sine(Angle.constant(-30))
    Product(-1/2, {})
    """
    return _trig(angle, 0)


@lru_cache(maxsize=4096)
def cosine(angle: Angle) -> Product:
    """Return cos(angle) in canonical form.

    >>> cosine(Angle.of("t") - Angle.constant(90)) == sine(Angle.of("t"))
    True
    """
    return _trig(angle, 1)


def _trig(angle: Angle, quarter: int) -> Product:
    """Return sin(angle + quarter · 90°) with the leading coefficient of the angle positive.

    The constant is brought to (−45°, 45°] by quarter turns; sine and cosine change
    places on the way.
    """
    sign = 1
    if _leads_negative(angle):
        angle = -angle
        sign, quarter = (-1, quarter) if quarter % 2 == 0 else (1, quarter)
    turns = -((45 - angle.degrees) // 90)
    angle = Angle(angle.terms, rational(angle.degrees - 90 * turns))
    quarter = (quarter + turns) % 4
    if quarter >= 2:
        sign, quarter = -sign, quarter - 2
    if not angle.terms:
        return _constant(angle.degrees, quarter).scaled(sign)
    return Product(sign, {Trig("cos" if quarter else "sin", angle): 1})


def _leads_negative(angle: Angle) -> bool:
    """Return whether more coefficients are negative than positive, the first one deciding ties."""
    balance = sum(1 if c > 0 else -1 for _, c in angle.terms)
    if balance:
        return balance < 0
    return bool(angle.terms) and angle.terms[0][1] < 0


def _constant(degrees: Rational, quarter: int) -> Product:
    """Return sin or cos of a constant in (−45°, 45°], rational where it is."""
    if degrees < 0:
        return _constant(-degrees, quarter).scaled(1 if quarter else -1)
    if degrees == 0:
        return Product(quarter)
    if degrees == 30 and not quarter:
        return Product(Fraction(1, 2))
    if degrees == 45:
        quarter = 1  # sin 45° = cos 45°, which needs one name
    return Product(1, {Trig("cos" if quarter else "sin", Angle.constant(degrees)): 1})
