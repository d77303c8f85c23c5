"""Laurent polynomials in z = exp(iα), polynomials in everything else.

A real sum of products of lengths, sines and cosines has one such form: that makes
equality decidable and lets factors z^u ± z^-u be found and turned back into cosines
and sines.

A term's exponents are packed into one integer, so that multiplying terms is adding
integers and comparing them is the lexicographic order of exponents. The lowest field
holds the constant part of the angle, in units of a common part of 90°, and is always
wrapped into [0°, 90°): a quarter turn is a factor i of the coefficient.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from math import gcd, lcm

from ..named import NamedTuple
from ..work import spend
from .angle import Angle, Rational, rational
from .cyclotomic import Directions, Gaussian, accumulate, rotated, short, stars, unique
from .factors import Factor, Trig
from .product import Product, Sum
from .trigonometry import cosine, sine

SPARE = 10
"""Bits of a field beyond the largest coefficient of an angle: products of 500 such fit."""

LONGEST = 256
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


class Ring:
    """The exponents that some products need, and the arithmetic on their packed form.

    >>> from .trigonometry import sine, cosine
    >>> a, b = Angle.of("alpha"), Angle.of("beta")
    >>> ring = Ring([sine(a + b)])
    >>> ring.expand([sine(a) * cosine(b), cosine(a) * sine(b)]) == ring.expand([sine(a + b)])
    True
    """

    def __init__(self, products: Sequence[Product], deep: bool = True) -> None:
        self.deep = deep
        angles, factors = _generators(products, deep)
        self._names = sorted({name for a in angles for name, _ in a.terms})
        self._factors = sorted(factors, key=lambda f: f.order())
        self._scale = lcm(*(c.denominator for a in angles for _, c in a.terms))
        self._part = _common_part(angles)
        self._wrap = int(90 / self._part) if self._part else 0
        places = (*self._names, *self._factors)
        largest = max((abs(int(c * self._scale)) for a in angles for _, c in a.terms), default=1)
        self._bits = largest.bit_length() + SPARE
        self._low = self._wrap.bit_length() + 2
        self._fields: dict[object, int] = {
            x: self._low + self._bits * i for i, x in enumerate(places)
        }
        self._half, self._mask = 1 << (self._bits - 1), (1 << self._bits) - 1
        self._bias = sum(self._half << field for field in self._fields.values())

    # -------------------------------------------------------------------- packing

    def _packed(self, angle: Angle) -> tuple[int, int]:
        """Return the packed exponents of exp(i·angle) and the power of i that goes with it."""
        key = 0
        for name, c in angle.terms:
            key += int(c * self._scale) << self._fields[name]
        if not self._wrap:
            return key, int(angle.degrees // 90)
        quarters, part = divmod(int(Fraction(angle.degrees) / self._part), self._wrap)
        return key + part, quarters

    def factor_shift(self, factor: Factor, exponent: int) -> int:
        """Return the packed exponents of a power of a factor."""
        return exponent << self._fields[factor]

    def packed(self, exponents: Iterable[int], constant: int) -> int:
        """Return the key of a term: the reverse of :meth:`exponents` and :meth:`constant`."""
        fields = zip(exponents, self._fields.values(), strict=True)
        return constant + sum(e << field for e, field in fields)

    def exponents(self, key: int) -> list[int]:
        """Return all exponents but the constant's, symbols of angles first, as integers."""
        biased, mask, half = key + self._bias, self._mask, self._half
        return [(biased >> field & mask) - half for field in self._fields.values()]

    def _exponent(self, key: int, field: int) -> int:
        """Return one exponent, that of the symbol whose field begins there."""
        return (key + self._bias >> field & self._mask) - self._half

    def constant(self, key: int) -> int:
        """Return the constant of a term's angle, in parts of 90°/``parts``."""
        return key & ((1 << self._low) - 1)

    def split(self, key: int) -> tuple[int, int]:
        """Return the packed factors and the packed angle of a term."""
        width = self._low + self._bits * len(self._names)
        half = 1 << (width - 1)
        angle = ((key + half) & ((1 << width) - 1)) - half
        return key - angle, angle

    def angle(self, key: int) -> Angle:
        """Return the angle of a term."""
        turns = self.exponents(key)
        terms = (
            (name, rational(Fraction(c, self._scale)))
            for name, c in zip(self._names, turns, strict=False)
            if c
        )
        constant = self.constant(key) * self._part if self._wrap else 0
        return Angle(tuple(terms), rational(constant))

    def monomial(self, key: int) -> dict[Factor, int]:
        """Return the powers of factors of a term."""
        powers = self.exponents(key)[len(self._names) :]
        return {f: e for f, e in zip(self._factors, powers, strict=True) if e}

    def width(self, terms: Terms) -> dict[object, Fraction]:
        """Return how far the exponents of a sum reach, for each symbol and factor."""
        columns = zip(*map(self.exponents, terms), strict=True)
        parts = [self._scale] * len(self._names) + [1] * len(self._factors)
        places = zip(self._fields, columns, parts, strict=True)
        return {x: Fraction(max(c) - min(c), part) for x, c, part in places}

    @property
    def scale(self) -> int:
        """Return the common denominator of the coefficients of angles."""
        return self._scale

    @property
    def angles(self) -> int:
        """Return how many of the exponents are those of symbols of angles."""
        return len(self._names)

    @property
    def parts(self) -> int:
        """Return how many steps of the constants make a quarter turn."""
        return self._wrap or 1

    @property
    def has_constants(self) -> bool:
        """Return whether some angle has a constant that is no multiple of 90°."""
        return bool(self._wrap)

    def holds(self, angle: Angle) -> bool:
        """Return whether the constant of an angle is one of the ring's."""
        return not (angle.degrees % self._part if self._wrap else angle.degrees % 90)

    def shifted(self, key: int, value: Gaussian, shift: int, power: int) -> tuple[int, Gaussian]:
        """Return a term times i^power and a packed shift, its constant wrapped."""
        key += shift
        if self._wrap and self.constant(key) >= self._wrap:
            key, power = key - self._wrap, power + 1
        return key, rotated(value, power) if power & 3 else value

    def unique(self, terms: Terms) -> Terms:
        """Return a sum of terms in the form that no other sum of the same value has."""
        return self._rewritten(terms, unique)

    def short(self, terms: Terms) -> Terms:
        """Return a sum of terms in unique form with fewer constants, for reading."""
        return self._rewritten(terms, short)

    def _rewritten(self, terms: Terms, rule: Callable[[Directions, int], Directions]) -> Terms:
        """Rewrite the constants that stand before each monomial."""
        if not self._wrap or not stars(self._wrap):
            return terms
        groups: dict[int, Directions] = {}
        for key, value in terms.items():
            constant = self.constant(key)
            groups.setdefault(key - constant, {})[constant] = value
        rewritten = ((base, rule(group, self._wrap)) for base, group in groups.items())
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
        up, up_power = self._packed(trig.angle)
        down, down_power = self._packed(-trig.angle)
        if trig.function == "sin":
            up_power, down_power = up_power - 1, down_power + 1
        if up >> self._low < down >> self._low:
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

        The exponent along the angle's first symbol falls at each step and is bounded
        below, so this ends.
        """
        by = self.binomial(trig)
        field = max(self._fields[name] for name, _ in trig.angle.terms)
        lowest = min(self._exponent(key, field) for key in terms)
        lowest += abs(self._exponent(by.up, field))
        rest, quotient = dict(terms), Terms()
        while rest:
            for key, value in self._top(rest).items():
                k, value = self._lowered(key, value, by)
                if self._exponent(k, field) < lowest or len(quotient) == LONGEST:
                    return None
                quotient[k] = value
                re, im = value
                accumulate(rest, *self.shifted(k, (-re, -im), by.down, by.down_power))
        return self.unique(quotient)

    def _top(self, terms: Terms) -> Terms:
        """Take the terms with the highest exponents out of a sum."""
        spend(len(terms))
        top = max(terms) >> self._low
        return self.unique({k: terms.pop(k) for k in [k for k in terms if k >> self._low == top]})

    def _lowered(self, key: int, value: Gaussian, by: Binomial) -> tuple[int, Gaussian]:
        """Return a term divided by the leading term of a binomial."""
        key, power = key - by.up, -by.up_power
        if self._wrap and self.constant(key) >= self._wrap:
            key, power = key + self._wrap, power - 1
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


def _common_part(angles: Iterable[Angle]) -> Fraction:
    """Return a part of 90° of which all halves of constants are multiples; 0 if none is needed."""
    constants = [Fraction(a.degrees) for a in angles if a.degrees % 90]
    if not constants:
        return Fraction(0)
    below = lcm(*(c.denominator for c in constants))
    return Fraction(gcd(90 * below, *(int(c * below) for c in constants)), 2 * below)


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
