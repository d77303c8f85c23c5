"""Sines of constant angles in a product: what they have to do with one another.

All relations used have the form Π sin(xᵢ)^eᵢ = rational: of doubled angles,
sin 2x = 2 sin x sin(90° − x), of trebled ones, sin 3x = 4 sin x sin(60° − x) sin(60° + x),
and sin² 60° = 3/4. One is put in only where fewer sines are left than before.

>>> from ..formula.to_text import text
>>> from .trigonometry import cosine, sine
>>> forty, twenty = Angle.constant(40), Angle.constant(20)
>>> text(without_relations(sine(forty) / sine(twenty)).formula())
'2*cos(pi/9)'
"""

from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from ..base.named import NamedTuple
from ..work import spend
from .angle import Angle, Rational, rational
from .factors import Factor, Trig
from .product import Product
from .trigonometry import sine

Sines = Mapping[Rational, int]
"""Degrees between 0 and 90 → exponent of their sine."""


class SineRelation(NamedTuple):
    """The product of powers of sines that is a rational number."""

    sines: Sines
    value: Fraction


def is_constant(factor: Factor) -> bool:
    """Return whether a factor is a sine or cosine of a constant angle."""
    return isinstance(factor, Trig) and not factor.angle.terms


def without_relations(product: Product) -> Product:
    """Return a product with as few sines of constants as relations between them leave.

    Measure: the number of these sines, each counted as often as its exponent says. It
    falls by every relation that is put in.
    """
    sines: Sines = {_degrees(f): e for f, e in product.factors.items() if is_constant(f)}
    if sum(map(abs, sines.values())) < 2:
        return product
    rest = Product(
        product.coefficient, {f: e for f, e in product.factors.items() if not is_constant(f)}
    )
    while (fewer := _fewer(sines)) is not None:
        spend(100 * len(sines))
        sines, value = fewer
        rest = rest.scaled(rational(value))
    for degrees, e in sines.items():
        rest = rest * sine(Angle.constant(degrees)) ** e
    return rest


def _degrees(trig: Factor) -> Rational:
    """Return the angle between 0 and 90 degrees of which a constant factor is the sine."""
    assert isinstance(trig, Trig)
    return trig.angle.degrees if trig.function == "sin" else rational(90 - trig.angle.degrees)


def _fewer(sines: Sines) -> SineRelation | None:
    """Return fewer sines and the number that goes with them; None if no relation helps."""
    count = sum(map(abs, sines.values()))
    for degrees in sorted(sines):
        for relation, value in _relations(degrees):
            for way in (1, -1):
                left = _times(sines, relation, -way)
                if sum(map(abs, left.values())) < count:
                    return SineRelation(left, value**way)
    return None


@lru_cache(maxsize=1024)
def _relations(degrees: Rational) -> tuple[SineRelation, ...]:
    """Return the relations in which the sine of an angle occurs."""
    doubled = [_of_multiple(2, x) for x in (Fraction(degrees), Fraction(degrees) / 2)]
    trebled = [_of_multiple(3, x) for x in (Fraction(degrees), Fraction(degrees) / 3)]
    found = [*doubled, *trebled, SineRelation({60: 2}, Fraction(3, 4))]
    return tuple(r for r in found if r is not None and degrees in r.sines)


def _of_multiple(n: int, x: Fraction) -> SineRelation | None:
    """Return sin(n·x) / Π sin(x + i·180°/n) = 2^(n − 1); None where these are zero."""
    if n * x % 180 == 0:
        return None
    parts = ((x + Fraction(180 * i, n), -1) for i in range(n))
    value, sines = Fraction(2 ** (n - 1)), dict[Rational, int]()
    for angle, e in ((n * x, 1), *parts):
        degrees, sign = _acute(angle)
        known = {30: Fraction(1, 2), 90: Fraction(1)}.get(int(degrees))
        value *= sign
        if known is not None and degrees == int(degrees):
            value /= known**e
        else:
            sines = _times(sines, {degrees: 1}, e)
    return SineRelation(sines, value) if sines else None


def _acute(angle: Fraction) -> tuple[Rational, int]:
    """Return (degrees, sign) with sin(angle) = sign · sin(degrees), degrees up to 90."""
    sign = 1 if angle % 360 < 180 else -1
    folded = angle % 180
    return rational(min(folded, 180 - folded)), sign


def _times(sines: Sines, others: Sines, power: int) -> dict[Rational, int]:
    """Return sines times a power of others."""
    result = dict(sines)
    for degrees, e in others.items():
        result[degrees] = result.get(degrees, 0) + power * e
    return {d: e for d, e in result.items() if e}
