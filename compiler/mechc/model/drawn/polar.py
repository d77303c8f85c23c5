"""Vectors whose components are written by a length and an angle: ``(a*cos(t), a*sin(t))``."""

from collections.abc import Mapping

from ...algebra.angle import Angle
from ...algebra.factors import Trig
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...named import NamedTuple


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
