"""Vectors by their components: as a length and an angle, and with lengths of exact ratios."""

from collections.abc import Mapping
from fractions import Fraction
from math import isqrt, sqrt

from ...algebra.angle import Angle
from ...algebra.factors import Trig
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...base.named import NamedTuple
from ..constants import decimal


class Polar(NamedTuple):
    """A vector by its length and its direction."""

    length: Product
    angle: Angle


def polar(x: Product, y: Product, values: Mapping[str, float]) -> Polar | None:
    """Return the length and angle of a vector, None where it is not written by them.

    ``values`` decide the sign of the length.

    >>> a, t = Product.symbol("a"), Angle.of("t")
    >>> found = polar(a * sine(t), -a * cosine(t), {"a": 1.0})
    >>> found.length == a, str(found.angle)
    (True, 't - 90°')
    """
    length = add([x * x, y * y]).root()
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


class DrawnLengths:
    """The lengths so far: of those in a rational ratio the first decides the digits.

    Where AD is drawn twice as long as AE, both have a decimal for a root, and the digits of the
    one need not be twice those of the other. What moves only since they are in this ratio, as a
    pair of scissors whose guides hold it twice, must be seen to move: the later length is
    the ratio times the earlier one.
    """

    def __init__(self) -> None:
        self._known = [(Fraction(1), Fraction(1))]

    def of(self, x: Fraction, y: Fraction) -> Fraction:
        """Return the length of a vector: exact where it is rational, else a decimal of it.

        >>> lengths = DrawnLengths()
        >>> lengths.of(Fraction(3), Fraction(4))
        Fraction(5, 1)
        >>> once, thrice = (lengths.of(Fraction(n, 10), Fraction(n, 10)) for n in (7, 21))
        >>> float(once), thrice / once
        (0.9899494936611666, Fraction(3, 1))
        """
        square = x * x + y * y
        for known, length in self._known:
            if ratio := rational_root(square / known):
                return ratio * length
        length = decimal(sqrt(square)).value
        self._known.append((square, length))
        return length


def rational_root(square: Fraction) -> Fraction | None:
    """Return the square root of a positive number where it is rational.

    >>> rational_root(Fraction(9, 4)), rational_root(Fraction(2))
    (Fraction(3, 2), None)
    """
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None
