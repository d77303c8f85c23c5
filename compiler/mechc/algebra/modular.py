"""Exact tests for zero and equality, without expanding anything.

Every expression of angle algebra is a rational function of its lengths and of
z = exp(iα) for each angle α. At a random point of a prime field it can be evaluated
in one pass, and a non-zero expression vanishes there with probability about
(its degree)/p, some 1e-32 for what a mechanism gives (Schwartz 1980, Zippel 1979).
The prime is chosen so that i and the roots of unity of constant angles exist in the
field; a constant such as 40° is then what it is, not a free symbol.
"""

from functools import lru_cache
from random import Random
from typing import Literal

from .angle import Angle, Rational

PARTS = 10**20 * 16 * 9009
"""Angles are exact in this part of a degree: twenty decimals, and 3²·7·11·13 besides."""
_ORDER = 360 * PARTS
PRIME = 5441342018112000000000000000000001
"""A prime of 113 bits with ``PRIME % _ORDER == 1``; a test proves both."""


@lru_cache(maxsize=1)
def _root_of_unity() -> int:
    """Return an element of order exactly ``_ORDER``: exp(i·1°/PARTS)."""
    for base in range(2, 1000):
        root = pow(base, (PRIME - 1) // _ORDER, PRIME)
        if all(pow(root, _ORDER // q, PRIME) != 1 for q in (2, 3, 5, 7, 11, 13)):
            return root
    raise AssertionError("no generator below 1000")


@lru_cache(maxsize=256)
def direction(parts: int) -> int:
    """Return exp(i·90°/parts)."""
    return pow(_root_of_unity(), 90 * PARTS // parts, PRIME)


_HALF = pow(2, -1, PRIME)


@lru_cache(maxsize=1)
def _half_over_i() -> int:
    return pow(2 * direction(1), -1, PRIME)


class ModularPoint:
    """Random values for all symbols, made up as they are first asked for.

    Two points of the same seed give equal values to equal names, whatever the order.
    """

    prime = PRIME

    def __init__(self, seed: int = 0) -> None:
        self.seed = seed
        self._lengths: dict[str, int] = {}

    def length(self, name: str) -> int:
        """Return the random value of a symbol."""
        value = self._lengths.get(name)
        if value is None:
            value = self._lengths[name] = _drawn(self.seed, name)
        return value

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
        z, conjugate = _turn(self.seed, angle)
        if function == "cos":
            return (z + conjugate) * _HALF % PRIME
        return (z - conjugate) * _half_over_i() % PRIME

    def exponential(self, angle: Angle) -> int:
        """Return exp(i·angle): a power product of one random value per symbol."""
        return _turn(self.seed, angle)[0]


@lru_cache(maxsize=4096)
def _turn(seed: int, angle: Angle) -> tuple[int, int]:
    """Return exp(i·angle) and exp(−i·angle), which all points of a seed share."""
    z = pow(_root_of_unity(), _parts(angle.degrees), PRIME) if angle.degrees else 1
    for name, coefficient in angle.terms:
        root, whole = _exponentials(seed, name)
        if isinstance(coefficient, int):
            z = z * pow(whole, coefficient, PRIME) % PRIME
        else:
            z = z * pow(root, _parts(coefficient), PRIME) % PRIME
    return z, pow(z, -1, PRIME)


@lru_cache(maxsize=4096)
def _drawn(seed: int, name: str) -> int:
    """Return a number other than 0 that only the seed and the name decide."""
    return Random(f"{seed}/{name}").randrange(1, PRIME)


@lru_cache(maxsize=4096)
def _exponentials(seed: int, name: str) -> tuple[int, int]:
    """Return exp(i·symbol/PARTS), a random value, and exp(i·symbol), its power."""
    root = _drawn(seed, f"angle {name}")
    return root, pow(root, PARTS, PRIME)


def _parts(value: Rational) -> int:
    """Return the value in ``1/PARTS``; :func:`~.from_formula.to_angle` lets no finer one pass."""
    scaled = value * PARTS
    assert scaled.denominator == 1, value
    return scaled.numerator
