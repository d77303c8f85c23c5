"""The order of a whole product where an angle takes a value: of its zero, or of its pole.

Near that value, at δ from it, a product is c·δ^order·(1 + …). It is evaluated as a power
series in δ over a finite field, all other symbols being random: exact, whatever the
factors have in common there.

>>> from .trigonometry import cosine
>>> a, right = Angle.of("a"), Angle.constant(90)
>>> order(cosine(a * 3) / cosine(a), "a", right), order(cosine(a * 3) / cosine(a) ** 2, "a", right)
(0, -1)
"""

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from fractions import Fraction
from math import gcd, lcm

from ..base.named import NamedTuple
from ..formula.walk import symbols
from ..work import kept, spend
from .angle import RADIAN, Angle, Rational
from .factors import Factor, Length, Opaque, Trig
from .modular import PARTS, PRIME, ModularPoint
from .product import Product, Sum
from .sine_divisors import GenericValues
from .sums import BoundSum
from .tolerances import PLAINLY_NOT_ZERO, POLE
from .trigonometry import sine

TERMS = (2, 8)
"""Terms of a series, first few: what is zero to the last order is not looked into any further."""


MOST_SINE_ROOTS = 64
"""Roots of one sine: those of 1.234·a and a are not distinguished."""


class AngleRoot(NamedTuple):
    """One of the values, half turns apart, at which a sine or cosine vanishes.

    ``factor`` vanishes there only; ``name`` is a symbol of its angle and ``value`` what
    the symbol is there.
    """

    factor: Trig
    name: str
    value: Angle


def roots(trig: Trig, *products: Product) -> list[AngleRoot]:
    """Return the roots of a sine or cosine, as far as products may distinguish them.

    Next to sin a, cos 3a has three, at 30°, 90° and 150°; next to sin(a/2) six, up to 360°. A sum
    may vanish at one end of a diameter only: next to one, roots are distinguished up to a whole
    turn of the finest angle. None are returned where these are more than :data:`MOST_SINE_ROOTS`.

    >>> from .trigonometry import cosine
    >>> (c,) = cosine(Angle.of("a") * 3).factors
    >>> [str(r.value) for r in roots(c, Product.of(c) * sine(Angle.of("a")))]
    ['30°', '90°', '150°']
    """
    step = _gcd(_common_step(trig, product) for product in products)
    own = [(n, c) for n, c in trig.angle.terms if n != RADIAN]
    parts = int(_gcd(c for _, c in own) / step)
    if parts > MOST_SINE_ROOTS:
        return []
    unit = Angle(tuple(own)) * Fraction(1, parts)
    offset = Angle.constant(90 if trig.function == "cos" else 0) - (trig.angle - Angle(tuple(own)))
    name, c = next((t for t in unit.terms if abs(t[1]) == 1), unit.terms[0])
    found = []
    for i in range(parts):
        place = (offset + Angle.constant(180 * i)) * Fraction(1, parts)
        value = (place - unit + Angle(((name, c),))) * (1 / Fraction(c))
        found.append(AngleRoot(_sine(unit - place), name, value))
    return found


def _sine(angle: Angle) -> Trig:
    """Return a sine, or a cosine that is the same but for its sign."""
    (factor,) = sine(angle).factors
    assert isinstance(factor, Trig)
    return factor


def half_turns(root: AngleRoot) -> tuple[AngleRoot, AngleRoot]:
    """Return the two within a whole turn of its angle that a root stands for.

    >>> from .trigonometry import cosine
    >>> (c,) = cosine(Angle.of("a")).factors
    >>> parts = half_turns(*roots(c, Product.of(c)))
    >>> [(str(r.value), r.factor.function, str(r.factor.angle)) for r in parts]
    [('90°', 'cos', '1/2*a + 45°'), ('270°', 'sin', '1/2*a + 45°')]
    """
    angle, name = root.factor.angle, root.name
    turn = Angle.constant(180 / Fraction(dict(angle.terms)[name]))

    def at(value: Angle) -> AngleRoot:
        return AngleRoot(_sine((angle - angle.put({name: value})) * Fraction(1, 2)), name, value)

    return at(root.value), at(root.value + turn)


def _common_step(trig: Trig, product: Product) -> Fraction:
    """Return of what all coefficients are multiples, in angles that share a symbol with a trig."""
    names = trig.angle.names
    inside = [a for a in angles(product) if not names.isdisjoint(n for n, _ in a.terms)]
    step = _gcd(c for a in (trig.angle, *inside) for n, c in a.terms if n != RADIAN)
    return step / 2 if any(isinstance(f, Sum | BoundSum) for f in product.factors) else step


def _gcd(values: Iterable[Rational]) -> Fraction:
    """Return the largest rational of which all are integer multiples."""
    parts = [Fraction(v) for v in values]
    below = lcm(*(p.denominator for p in parts))
    return Fraction(gcd(*(int(p * below) for p in parts)), below)


@kept
def angles(product: Product) -> tuple[Angle, ...]:
    """Return the angles that a product depends on, those inside of its sums included.

    What is bound to a name is gone into once: in a chain each name rests on the one before
    by several terms.
    """
    found: dict[Angle, None] = {}
    bound: set[str] = set()
    waiting = [product]
    while waiting:
        factors = waiting.pop().factors
        spend(1 + len(factors))
        for factor in factors:
            match factor:
                case Trig(angle=angle):
                    found[angle] = None
                case Sum(terms=terms):
                    waiting.extend(terms)
                case BoundSum(name=name) if name not in bound:
                    bound.add(name)
                    waiting.append(factor.definition)
    return tuple(found)


class Series(NamedTuple):
    """``δ^order · Σ coefficients[i]·δ^i``, the first coefficient not zero."""

    order: int
    coefficients: tuple[int, ...]


class UnknownError(Exception):
    """Raised where a series begins beyond its known terms, or with something opaque."""


def order(product: Product, name: str, value: Angle) -> int | None:
    """Return the order of a product where a symbol has a value, which may rest on others.

    Positive for a zero, negative for a pole; None where that is not found out.
    """
    if not product:
        return None
    plain = _plain_order(product, name, value)
    if plain is not None:
        return plain
    for terms in TERMS:
        with suppress(UnknownError, ZeroDivisionError):
            return _SymbolValue(name, value, terms).series(product).order
    return None


def _plain_order(product: Product, name: str, value: Angle) -> int | None:
    """Return the order where all but sines and cosines are plainly not zero; else None.

    A sum whose value at any one place is no rounding is not zero everywhere.
    """
    generic = GenericValues()
    sizes = {f: _size(f, generic) for f in product.factors if isinstance(f, Sum)}
    values = GenericValues(generic)
    values[name] = value.evaluate(values)
    total = 0
    for factor, exponent in product.factors.items():
        match factor:
            case Trig(function, angle):
                here = angle.put({name: value})
                zero = 0 if function == "sin" else 90
                total += exponent if not here.terms and here.degrees % 180 == zero else 0
            case Sum() if POLE * _size(factor, values) < sizes[factor]:
                if abs(factor.evaluate(values)) < PLAINLY_NOT_ZERO * sizes[factor]:
                    return None
            case Length() if factor.name != name:
                pass
            case _:
                return None
    return total


def _size(sum_: Sum, values: Mapping[str, float]) -> float:
    """Return the largest of a sum's terms; infinite where one of them is."""
    try:
        return max(abs(term.evaluate(values)) for term in sum_.terms)
    except ZeroDivisionError:
        return math.inf


class _SymbolValue:
    """The value of one symbol, on the way through it; everything else is random."""

    def __init__(self, name: str, value: Angle, terms: int) -> None:
        self._name, self._value, self._terms = name, {name: value}, terms
        self._point = ModularPoint()
        self._bound: dict[str, Series] = {}

    def series(self, product: Product) -> Series:
        """Return the series of a product."""
        result = self._constant(self._point.rational(product.coefficient))
        for factor, exponent in product.factors.items():
            result = _times(result, _power(self._factor(factor), exponent))
        return result

    def _factor(self, factor: Factor) -> Series:
        """Return the series of one factor."""
        match factor:
            case Trig(function, angle):
                return self._trig(function == "cos", angle)
            case Sum(terms=terms):
                return _sum([self.series(t) for t in terms])
            case BoundSum(name=name):
                if name not in self._bound:
                    self._bound[name] = self.series(factor.definition)
                return self._bound[name]
            case Length(name=name) if name == self._name:
                raise UnknownError
            case Opaque(inside=inside) if self._name in symbols(inside):
                raise UnknownError
            case _:
                return self._constant(factor.residue(self._point))

    def _trig(self, is_cosine: bool, angle: Angle) -> Series:
        """Return sin(A + cδ) or cos(A + cδ) by Taylor's theorem."""
        speed = self._point.rational(dict(angle.terms).get(self._name, 0))
        here = angle.put(self._value)
        if any(PARTS % Fraction(x).denominator for x in (here.degrees, *dict(here.terms).values())):
            raise UnknownError
        sin, cos = self._point.trig("sin", here), self._point.trig("cos", here)
        slopes = [cos, -sin, -cos, sin] if is_cosine else [sin, cos, -sin, -cos]
        values, scale = list[int](), 1
        for i in range(self._terms):
            values.append(slopes[i % 4] * scale % PRIME)
            scale = scale * speed * pow(i + 1, -1, PRIME) % PRIME
        return _led(0, values)

    def _constant(self, value: int) -> Series:
        if not value:
            raise UnknownError
        return Series(0, (value, *[0] * (self._terms - 1)))


def _led(order_: int, values: list[int]) -> Series:
    """Return a series without leading zeros; the terms that are lost count as unknown."""
    first = next((i for i, v in enumerate(values) if v), None)
    if first is None:
        raise UnknownError
    return Series(order_ + first, tuple(values[first:]))


def _times(a: Series, b: Series) -> Series:
    known = min(len(a.coefficients), len(b.coefficients))
    spend(known * known)
    values = [
        sum(a.coefficients[j] * b.coefficients[i - j] for j in range(i + 1)) % PRIME
        for i in range(known)
    ]
    return Series(a.order + b.order, tuple(values))


def _power(a: Series, exponent: int) -> Series:
    result = base = a if exponent > 0 else _inverse(a)
    for _ in range(abs(exponent) - 1):
        result = _times(result, base)
    return result


def _inverse(a: Series) -> Series:
    first = pow(a.coefficients[0], -1, PRIME)
    values = [first]
    for i in range(1, len(a.coefficients)):
        tail = sum(a.coefficients[j] * values[i - j] for j in range(1, i + 1))
        values.append(-tail * first % PRIME)
    return Series(-a.order, tuple(values))


def _sum(terms: list[Series]) -> Series:
    """Return a sum, as far as all of its terms are known."""
    lowest = min(t.order for t in terms)
    known = min(t.order + len(t.coefficients) for t in terms)
    values = [0] * (known - lowest)
    for t in terms:
        for i, v in enumerate(t.coefficients):
            if t.order + i < known:
                values[t.order + i - lowest] += v
    return _led(lowest, [v % PRIME for v in values])
