"""Laurent polynomials in z = exp(iα), polynomials in everything else.

A real sum of products of lengths, sines and cosines has one such form: that makes
equality decidable and lets factors z^u ± z^-u be found and turned back into cosines
and sines.

A term's exponents are packed into one integer: see :mod:`.exponents`.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from math import gcd, lcm

from ..base.named import NamedTuple
from ..work import spend
from .angle import Angle, Rational, rational
from .cyclotomic import Gaussian, GaussianDirections, accumulate, rotated, short, stars, unique
from .exponents import Exponents
from .factors import Factor, Trig
from .product import Product, Sum
from .trigonometry import cosine, sine

MOST_QUOTIENT_TERMS = 256
"""Terms of a quotient that is still simpler: sin(1000001·u)/sin u is not multiplied out."""

Terms = dict[int, Gaussian]
"""Packed exponents → coefficient, without zero coefficients."""


class Polynomial(NamedTuple):
    """``scale · Σ coefficient · Π factor^e · exp(i·angle)`` over the terms of a ring."""

    scale: Rational
    terms: Terms


class Binomial(NamedTuple):
    """z^u ± z^-u as two packed shifts, each with a power of i; the first one leads."""

    up: int
    up_power: int
    down: int
    down_power: int


class Ring(Exponents):
    """The arithmetic on sums of terms, with the exponents that some products need.

    >>> from .trigonometry import sine, cosine
    >>> a, b = Angle.of("alpha"), Angle.of("beta")
    >>> ring = Ring([sine(a + b)])
    >>> ring.expand([sine(a) * cosine(b), cosine(a) * sine(b)]) == ring.expand([sine(a + b)])
    True
    """

    def __init__(self, products: Sequence[Product], deep: bool = True) -> None:
        super().__init__(*_generators(products, deep))
        self.deep = deep

    def unique(self, terms: Terms) -> Terms:
        """Return a sum of terms in the form that no other sum of the same value has."""
        return self._rewritten(terms, unique)

    def short(self, terms: Terms) -> Terms:
        """Return a sum of terms in unique form with fewer constants, for reading."""
        return self._rewritten(terms, short)

    def _rewritten(
        self, terms: Terms, rule: Callable[[GaussianDirections, int], GaussianDirections]
    ) -> Terms:
        """Rewrite the constants that stand before each monomial."""
        if not self.wrap or not stars(self.wrap):
            return terms
        groups: dict[int, GaussianDirections] = {}
        for key, value in terms.items():
            constant = self.constant(key)
            groups.setdefault(key - constant, {})[constant] = value
        rewritten = ((base, rule(group, self.wrap)) for base, group in groups.items())
        return {base + c: value for base, group in rewritten for c, value in group.items()}

    # ------------------------------------------------------------------ expansion

    def expand(self, products: Iterable[Product]) -> Polynomial:
        """Return a sum of products multiplied out, its integer content in the scale.

        Sines, cosines and (if the ring is deep) sums must have positive exponents.
        """
        parts = [self._expanded(p) for p in products]
        scale = Fraction(1, lcm(*(Fraction(p.scale).denominator for p in parts)))
        total: Terms = {}
        for part in parts:
            times = int(part.scale / scale)
            for key, (re, im) in part.terms.items():
                accumulate(total, key, (re * times, im * times))
        return _primitive(scale, self.unique(total))

    def _expanded(self, product: Product) -> Polynomial:
        """Return a product as a polynomial, its sines and cosines multiplied out."""
        scale: Rational = product.coefficient
        terms: Terms = {0: (1, 0)}
        for factor, exponent in product.factors.items():
            if isinstance(factor, Trig):
                binomial = self.binomial(factor)
                scale = rational(scale * Fraction(1, 2**exponent))
                for _ in range(exponent):
                    terms = self._times_binomial(terms, binomial)
            elif isinstance(factor, Sum) and self.deep:
                inner = self.expand(factor.terms)
                scale = rational(scale * Fraction(inner.scale) ** exponent)
                for _ in range(exponent):
                    terms = self.times(terms, inner.terms)
            else:
                shift = self.factor_shift(factor, exponent)
                terms = {key + shift: value for key, value in terms.items()}
        return Polynomial(scale, terms)

    def binomial(self, trig: Trig) -> Binomial:
        """Return twice a cosine, z^u + z^-u, or twice a sine, −i·z^u + i·z^-u."""
        up, up_power = self.packed_angle(trig.angle)
        down, down_power = self.packed_angle(-trig.angle)
        if trig.function == "sin":
            up_power, down_power = up_power - 1, down_power + 1
        if self.without_constant(up) < self.without_constant(down):
            return Binomial(down, down_power, up, up_power)
        return Binomial(up, up_power, down, down_power)

    def _times_binomial(self, terms: Terms, by: Binomial) -> Terms:
        spend(2 * len(terms))
        result: Terms = {}
        for key, value in terms.items():
            accumulate(result, *self.shifted(key, value, by.up, by.up_power))
            accumulate(result, *self.shifted(key, value, by.down, by.down_power))
        return result

    def times(self, left: Terms, right: Terms) -> Terms:
        """Return the product of two sums of terms."""
        spend(len(left) * len(right))
        result: Terms = {}
        for key, value in right.items():
            for k, (re, im) in left.items():
                product = (re * value[0] - im * value[1], re * value[1] + im * value[0])
                accumulate(result, *self.shifted(k, product, key, 0))
        return result

    # ------------------------------------------------------------------- division

    def divide(self, terms: Terms, trig: Trig) -> Terms | None:
        """Return the quotient by twice a sine or cosine, or None if it does not divide.

        Long division by z^u ± z^-u: each term of the highest exponents, divided by z^u, is one of
        the quotient; what z^-u makes of that is taken off the rest, and so on until nothing
        is left. The exponent along the angle's first symbol falls at each step and is bounded
        below, so this ends.
        """
        by = self.binomial(trig)
        field = max(self.fields[name] for name, _ in trig.angle.terms)
        lowest = min(self.exponent(key, field) for key in terms)
        lowest += abs(self.exponent(by.up, field))
        rest, quotient = dict(terms), Terms()
        while rest:
            for key, value in self._top(rest).items():
                quotient_key, quotient_value = self._lowered(key, value, by)
                is_too_low = self.exponent(quotient_key, field) < lowest
                if is_too_low or len(quotient) == MOST_QUOTIENT_TERMS:
                    return None
                quotient[quotient_key] = quotient_value
                re, im = quotient_value
                accumulate(rest, *self.shifted(quotient_key, (-re, -im), by.down, by.down_power))
        return self.unique(quotient)

    def _top(self, terms: Terms) -> Terms:
        """Take the terms with the highest exponents out of a sum."""
        spend(len(terms))
        top = self.without_constant(max(terms))
        highest = [key for key in terms if self.without_constant(key) == top]
        return self.unique({key: terms.pop(key) for key in highest})

    def _lowered(self, key: int, value: Gaussian, by: Binomial) -> tuple[int, Gaussian]:
        """Return a term divided by the leading term of a binomial."""
        key, power = key - by.up, -by.up_power
        if self.wrap and self.constant(key) >= self.wrap:
            key, power = key + self.wrap, power - 1
        return key, rotated(value, power)

    # -------------------------------------------------------------------- reading

    def single(self, key: int, value: Gaussian) -> Iterator[Product]:
        """Yield the real part of one term: a cosine and a sine of its angle."""
        angle = self.angle(key)
        re, im = value
        if re:
            yield cosine(angle).scaled(re)
        if im:
            yield sine(angle).scaled(-im)


def _primitive(scale: Fraction, terms: Terms) -> Polynomial:
    content = gcd(*(x for value in terms.values() for x in value)) or 1
    terms = {k: (re // content, im // content) for k, (re, im) in terms.items()}
    return Polynomial(rational(scale * content), terms)


def _generators(products: Iterable[Product], deep: bool) -> tuple[list[Angle], list[Factor]]:
    """Return the angles and the whole factors that occur in products."""
    angles: list[Angle] = []
    factors: dict[Factor, None] = {}
    waiting = list(products)
    while waiting:
        for factor in waiting.pop().factors:
            if isinstance(factor, Trig):
                angles.append(factor.angle)
            elif isinstance(factor, Sum) and deep:
                waiting.extend(factor.terms)
            else:
                factors[factor] = None
    return angles, list(factors)


ENDLESS = 1 << 30
"""The size of what can't be multiplied out: a sum with denominators."""


def size(product: Product, deep: bool = True) -> int:
    """Return how many terms a product has at most when it is multiplied out."""
    terms = 1
    for factor, exponent in product.factors.items():
        if isinstance(factor, Trig):
            terms *= 2**exponent if exponent > 0 else ENDLESS
        elif isinstance(factor, Sum) and deep:
            terms *= sum(size(t) for t in factor.terms) ** exponent if exponent > 0 else ENDLESS
        elif exponent < 0:
            terms *= ENDLESS
        if terms >= ENDLESS:
            return ENDLESS
    return terms
