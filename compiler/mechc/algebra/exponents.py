"""Exponents packed into one integer, so that multiplying terms is adding integers.

Comparing such integers is the lexicographic order of exponents. The lowest field holds the
constant part of the angle, in units of a common part of 90°, and is always wrapped into
[0°, 90°): a quarter turn is a factor i of the coefficient.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd, lcm

from .angle import Angle, rational
from .cyclotomic import Gaussian, rotated
from .factors import Factor

SPARE = 10
"""Bits of a field beyond the largest coefficient of an angle: products of 500 such fit."""


class Exponents:
    """The exponents of angles and factors that some products need, and how they are packed.

    ``scale`` is the common denominator of the coefficients of angles. ``wrap`` steps of the
    constants make a quarter turn, 0 where there are none; the ``low`` bits hold them, and
    ``fields`` has the first bit of each exponent.
    """

    def __init__(self, angles: Sequence[Angle], factors: Iterable[Factor]) -> None:
        self._names = sorted({name for a in angles for name, _ in a.terms})
        self._factors = sorted(factors, key=lambda f: f.order())
        self.scale = lcm(*(c.denominator for a in angles for _, c in a.terms))
        self._part = _common_part(angles)
        self.wrap = int(90 / self._part) if self._part else 0
        places = (*self._names, *self._factors)
        largest = max((abs(int(c * self.scale)) for a in angles for _, c in a.terms), default=1)
        self._bits = largest.bit_length() + SPARE
        self.low = self.wrap.bit_length() + 2
        self.fields: dict[object, int] = {
            x: self.low + self._bits * i for i, x in enumerate(places)
        }
        self._half, self._mask = 1 << (self._bits - 1), (1 << self._bits) - 1
        self._bias = sum(self._half << field for field in self.fields.values())

    def packed_angle(self, angle: Angle) -> tuple[int, int]:
        """Return the packed exponents of exp(i·angle) and the power of i that goes with it."""
        key = 0
        for name, c in angle.terms:
            key += int(c * self.scale) << self.fields[name]
        if not self.wrap:
            return key, int(angle.degrees // 90)
        quarters, part = divmod(int(Fraction(angle.degrees) / self._part), self.wrap)
        return key + part, quarters

    def factor_shift(self, factor: Factor, exponent: int) -> int:
        """Return the packed exponents of a power of a factor."""
        return exponent << self.fields[factor]

    def packed(self, exponents: Iterable[int], constant: int) -> int:
        """Return the key of a term: the reverse of :meth:`exponents` and :meth:`constant`."""
        fields = zip(exponents, self.fields.values(), strict=True)
        return constant + sum(e << field for e, field in fields)

    def exponents(self, key: int) -> list[int]:
        """Return all exponents but the constant's, symbols of angles first, as integers."""
        biased, mask, half = key + self._bias, self._mask, self._half
        return [(biased >> field & mask) - half for field in self.fields.values()]

    def exponent(self, key: int, field: int) -> int:
        """Return one exponent, that of the symbol whose field begins there."""
        return (key + self._bias >> field & self._mask) - self._half

    def constant(self, key: int) -> int:
        """Return the constant of a term's angle, in parts of 90°/``parts``."""
        return key & ((1 << self.low) - 1)

    def without_constant(self, key: int) -> int:
        """Return the exponents of a term, by which terms are in order, without the constant."""
        return key >> self.low

    def split(self, key: int) -> tuple[int, int]:
        """Return the packed factors and the packed angle of a term."""
        width = self.low + self._bits * len(self._names)
        half = 1 << (width - 1)
        angle = ((key + half) & ((1 << width) - 1)) - half
        return key - angle, angle

    def angle(self, key: int) -> Angle:
        """Return the angle of a term."""
        turns = self.exponents(key)
        terms = (
            (name, rational(Fraction(c, self.scale)))
            for name, c in zip(self._names, turns, strict=False)
            if c
        )
        constant = self.constant(key) * self._part if self.wrap else 0
        return Angle(tuple(terms), rational(constant))

    def monomial(self, key: int) -> dict[Factor, int]:
        """Return the powers of factors of a term."""
        powers = self.exponents(key)[len(self._names) :]
        return {f: e for f, e in zip(self._factors, powers, strict=True) if e}

    def width(self, terms: Iterable[int]) -> dict[object, Fraction]:
        """Return how far the exponents of a sum reach, for each symbol and factor."""
        columns = zip(*map(self.exponents, terms), strict=True)
        parts = [self.scale] * len(self._names) + [1] * len(self._factors)
        places = zip(self.fields, columns, parts, strict=True)
        return {x: Fraction(max(c) - min(c), part) for x, c, part in places}

    @property
    def angles(self) -> int:
        """Return how many of the exponents are those of symbols of angles."""
        return len(self._names)

    @property
    def parts(self) -> int:
        """Return how many steps of the constants make a quarter turn."""
        return self.wrap or 1

    @property
    def has_constants(self) -> bool:
        """Return whether some angle has a constant that is no multiple of 90°."""
        return bool(self.wrap)

    def holds(self, angle: Angle) -> bool:
        """Return whether the constant of an angle is one of the ring's."""
        return not (angle.degrees % self._part if self.wrap else angle.degrees % 90)

    def shifted(self, key: int, value: Gaussian, shift: int, power: int) -> tuple[int, Gaussian]:
        """Return a term times i^power and a packed shift, its constant wrapped."""
        key += shift
        if self.wrap and self.constant(key) >= self.wrap:
            key, power = key - self.wrap, power + 1
        return key, rotated(value, power) if power & 3 else value


def _common_part(angles: Iterable[Angle]) -> Fraction:
    """Return a part of 90° of which all halves of constants are multiples; 0 if none is needed."""
    constants = [Fraction(a.degrees) for a in angles if a.degrees % 90]
    if not constants:
        return Fraction(0)
    below = lcm(*(c.denominator for c in constants))
    return Fraction(gcd(90 * below, *(int(c * below) for c in constants)), 2 * below)
