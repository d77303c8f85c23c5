"""Angles as rational combinations of symbols plus a constant, exact.

The cosine of a difference of two such angles is the dot product of two directions and
its sine their determinant: that is why nothing is ever expanded.

>>> alpha, beta = Angle.of("alpha"), Angle.of("beta")
>>> str(alpha - beta + Angle.constant(90))
'alpha - beta + 90°'
"""

import math
from collections.abc import Mapping
from fractions import Fraction

from ..base.frozen import Hashed, frozen
from ..formula.tree import Formula, Symbol, degrees, number, product, total

Rational = int | Fraction
"""An exact rational, kept as ``int`` where it is one: Fractions are ten times slower."""

RADIAN = "1 rad"
"""The name under which a constant given in radians enters: no parameter can be called so."""


def rational(value: Rational) -> Rational:
    """Return the value as ``int`` where it is one."""
    return value.numerator if value.denominator == 1 else value


@frozen
class Angle(Hashed):
    """``Σ coefficient · symbol + degrees``; terms sorted by name, no zero coefficients."""

    terms: tuple[tuple[str, Rational], ...] = ()
    degrees: Rational = 0

    @staticmethod
    def of(name: str) -> "Angle":
        """Return the angle that is one symbol."""
        return Angle(((name, 1),))

    @staticmethod
    def constant(degrees: Rational) -> "Angle":
        """Return a constant angle."""
        return Angle((), rational(degrees))

    def __add__(self, other: "Angle") -> "Angle":
        if not other.terms:
            return Angle(self.terms, rational(self.degrees + other.degrees))
        sums = dict(self.terms)
        for name, c in other.terms:
            sums[name] = sums.get(name, 0) + c
        terms = tuple(sorted((n, rational(c)) for n, c in sums.items() if c))
        return Angle(terms, rational(self.degrees + other.degrees))

    def __neg__(self) -> "Angle":
        return Angle(tuple((n, -c) for n, c in self.terms), -self.degrees)

    def __sub__(self, other: "Angle") -> "Angle":
        return self + -other

    def __mul__(self, factor: Rational) -> "Angle":
        if not factor:
            return Angle()
        terms = tuple((n, rational(c * factor)) for n, c in self.terms)
        return Angle(terms, rational(self.degrees * factor))

    def __str__(self) -> str:
        parts = [n if c == 1 else f"-{n}" if c == -1 else f"{c}*{n}" for n, c in self.terms]
        if self.degrees or not parts:
            parts.append(f"{self.degrees}°")
        return " + ".join(parts).replace("+ -", "- ")

    @property
    def names(self) -> frozenset[str]:
        """Return the symbols, a constant in radians apart."""
        return frozenset(name for name, _ in self.terms if name != RADIAN)

    def put(self, values: Mapping[str, "Angle"]) -> "Angle":
        """Return the angle with symbols replaced by angles.

        >>> str(Angle.of("psi").put({"psi": Angle.of("phi") + Angle.constant(90)}))
        'phi + 90°'
        """
        if values.keys().isdisjoint(name for name, _ in self.terms):
            return self
        result = Angle((), self.degrees)
        for name, c in self.terms:
            result = result + values.get(name, Angle.of(name)) * c
        return result

    def half(self) -> "Angle":
        """Return half the angle."""
        return self * Fraction(1, 2)

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the angle in radians at values of its symbols (radians)."""
        turn = math.radians(self.degrees)
        for name, c in self.terms:
            turn += float(c) * (1.0 if name == RADIAN else values[name])
        return turn

    def formula(self) -> Formula:
        """Return the angle as a formula in radians, constants last where another has no minus."""
        only = all(c < 0 for name, c in self.terms if name != RADIAN)
        ordered = sorted(self.terms, key=lambda term: (term[0] == RADIAN and not only, term[1] < 0))
        parts = [
            _symbol(name) if c == 1 else product([(number(c), 1), (_symbol(name), 1)])
            for name, c in ordered
        ]
        return total([*parts, degrees(self.degrees)]) if self.degrees else total(parts)


def _symbol(name: str) -> Formula:
    return number(1) if name == RADIAN else Symbol(name)


QUARTER, HALF_TURN = Angle.constant(90), Angle.constant(180)


def principal(angle: Angle) -> Angle:
    """Return an angle with its constant between −180° and 180°."""
    return Angle(angle.terms, -((180 - angle.degrees) % 360 - 180))
