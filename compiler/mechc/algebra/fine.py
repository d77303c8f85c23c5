"""Fine constants as symbols: where an angle such as 12.34° need not be known by value.

A sum whose constants have too many conjugates to look into them all still has its
factors in common with others; what can be lost are divisors that rest on a relation
between these very constants.

>>> from ..formula.to_text import text
>>> text(named(sine(Angle.of("t") + Angle.constant(33))).formula())
'sin(3° + t + pi/6)'
"""

from collections.abc import Callable
from fractions import Fraction

from .angle import Angle, rational
from .factors import Trig
from .product import Product, Sum
from .trigonometry import cosine, sine

_GRID = 15
"""Multiples of so many degrees are no fine constants."""


def named(product: Product) -> Product:
    """Return a product with a symbol for each constant that is not on a grid."""
    return _rewritten(product, _named)


def valued(product: Product) -> Product:
    """Return a product with such symbols replaced by their values."""
    return _rewritten(product, _valued)


def is_fine(name: object) -> bool:
    """Return whether a symbol stands for a fine constant."""
    return isinstance(name, str) and name.endswith("°")


def _rewritten(product: Product, rule: Callable[[Angle], Angle]) -> Product:
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
