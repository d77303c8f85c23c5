"""Exact tests for zero and equality, without expanding anything.

Every expression of angle algebra is a rational function of its lengths and of
z = exp(iα) for each angle α. At a random point of a prime field it can be evaluated
in one pass, and a non-zero expression vanishes there with probability about
(its degree)/p, some 1e-17 for what a mechanism gives (Schwartz 1980, Zippel 1979).
The prime is chosen so that i and the roots of unity of constant angles exist in the
field; a constant such as 40° is then what it is, not a free symbol.
"""

import random
from collections.abc import Callable
from functools import lru_cache
from typing import Literal

from .angle import Angle, Rational

_PARTS = 720720
"""Angles may be divided by any number that divides this (2⁴·3²·5·7·11·13)."""
_ORDER = 360 * _PARTS
PRIME = 4611686018276937601
"""A prime below 2⁶² with ``PRIME % _ORDER == 1``; a test proves both."""


@lru_cache(maxsize=1)
def _root_of_unity() -> int:
    """Return an element of order exactly ``_ORDER``: exp(i·1°/_PARTS)."""
    for base in range(2, 1000):
        root = pow(base, (PRIME - 1) // _ORDER, PRIME)
        if all(pow(root, _ORDER // q, PRIME) != 1 for q in (2, 3, 5, 7, 11, 13)):
            return root
    raise AssertionError("no generator below 1000")


class Point:
    """Random values for all symbols, made up as they are first asked for.

    Two points of the same seed give equal values to equal names, whatever the order.
    """

    prime = PRIME

    def __init__(self, seed: int = 0) -> None:
        self._seed = seed
        self._lengths: dict[str, int] = {}
        self._trig: dict[tuple[str, Angle], int] = {}
        self._bound: dict[str, int] = {}

    def length(self, name: str) -> int:
        """Return the random value of a symbol."""
        value = self._lengths.get(name)
        if value is None:
            value = random.Random(f"{self._seed}/{name}").randrange(1, PRIME)
            self._lengths[name] = value
        return value

    def bound(self, name: str, definition: Callable[["Point"], int]) -> int:
        """Return the value of a bound name, computed from its definition once."""
        if name not in self._bound:
            self._bound[name] = definition(self)
        return self._bound[name]

    def rational(self, value: Rational) -> int:
        """Return a rational number in the field."""
        if isinstance(value, int):
            return value % PRIME
        return value.numerator * pow(value.denominator, -1, PRIME) % PRIME

    def power(self, base: int, exponent: int) -> int:
        """Return ``base ** exponent``; raise ZeroDivisionError for a negative power of 0."""
        if exponent == 1:
            return base
        if exponent < 0 and not base:
            raise ZeroDivisionError
        return pow(base, exponent, PRIME)

    def trig(self, function: Literal["sin", "cos"], angle: Angle) -> int:
        """Return sin or cos from z = exp(i·angle)."""
        key = (function, angle)
        value = self._trig.get(key)
        if value is None:
            z = self.exponential(angle)
            conjugate = pow(z, -1, PRIME)
            i = pow(_root_of_unity(), 90 * _PARTS, PRIME)
            if function == "cos":
                value = (z + conjugate) * pow(2, -1, PRIME) % PRIME
            else:
                value = (z - conjugate) * pow(2 * i, -1, PRIME) % PRIME
            self._trig[key] = value
        return value

    def exponential(self, angle: Angle) -> int:
        """Return exp(i·angle): a power product of one random value per symbol."""
        z = pow(_root_of_unity(), self._parts(angle.degrees), PRIME)
        for name, coefficient in angle.terms:
            z = z * pow(self.length("z " + name), self._parts(coefficient), PRIME) % PRIME
        return z

    @staticmethod
    def _parts(value: Rational) -> int:
        """Return the value in ``1/_PARTS``; a finer part is rounded to a part of its own."""
        scaled = value * _PARTS
        return scaled.numerator if scaled.denominator == 1 else hash(scaled)
