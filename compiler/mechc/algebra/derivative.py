"""Partial derivatives of factored products, factored again.

>>> from .angle import Angle
>>> from ..formula.to_text import text
>>> from .trigonometry import sine, cosine
>>> t = Angle.of("t")
>>> text(derivative(sine(t) / cosine(t), "t").formula())
'1/cos(t)^2'
"""

from collections.abc import Collection
from fractions import Fraction

from ..formula.walk import symbols
from .angle import rational
from .factors import CIRCLE, Factor, Length, Trig
from .product import ZERO, Product, Sum
from .sums import add
from .trigonometry import cosine, sine


def derivative(product: Product, name: str) -> Product:
    """Return ∂product/∂name in canonical form.

    Only what angle algebra sees is differentiated: :func:`depends_openly` states whether
    a product depends on a name in other ways (through a root or a bound sum).
    """
    return add(
        product * Product(exponent, {factor: -1}) * of_factor
        for factor, exponent in product.factors.items()
        if (of_factor := _of_factor(factor, name))
    )


def _of_factor(factor: Factor, name: str) -> Product:
    """Return the derivative of one factor by a name."""
    match factor:
        case Length():
            return Product(int(factor.name == name))
        case Trig(function, angle):
            slope = dict(angle.terms).get(name, 0)
            turned = cosine(angle) if function == "sin" else -sine(angle)
            return turned.scaled(rational(Fraction(slope))) if slope else ZERO
        case Sum():
            return add(derivative(term, name) for term in factor.terms)
        case _:
            return ZERO


def depends_openly(product: Product, on: Collection[str] | None = None) -> bool:
    """Return whether every factor is one that can be differentiated here, by names or by any."""
    return all(
        isinstance(f, Length | Trig)
        or f == CIRCLE
        or (isinstance(f, Sum) and all(depends_openly(term, on) for term in f.terms))
        or (on is not None and symbols(f.formula()).isdisjoint(on))
        for f in product.factors
    )
