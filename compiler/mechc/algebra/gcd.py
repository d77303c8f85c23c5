"""Greatest common divisors of polynomials over the prime field of ``modular``.

How far a divisor reaches in each variable is read off at a random point, where only one
variable is left (Brown 1971); coprime polynomials cost no more than that. Variables that
it does not reach are taken apart: it divides every coefficient. What remains goes
through remainders of primitive parts.
"""

import random
from functools import lru_cache

from ..work import spend
from .modular import PRIME

Poly = dict[tuple[int, ...], int]
"""Exponents, none negative, → residue, without zeros. The empty one is 0."""

MOST_REMAINDER_TERMS = 4000
"""A remainder with more terms than this costs more than what could cancel."""


HIGHEST = 4096
"""The degree beyond which no divisor is sought: of angles such as 1 and 1.0000001 rad."""


class TooLongError(Exception):
    """Raised for a degree beyond :data:`HIGHEST`, and where a remainder outgrows a limit."""


def common(f: Poly, g: Poly) -> Poly:
    """Return a greatest common divisor, but for monomials and a constant factor.

    >>> a, b = {(1, 0): 1, (0, 1): 1}, {(1, 0): 1, (0, 1): PRIME - 1}
    >>> common(times(a, b), times(a, a)) == a
    True
    """
    f, g = stripped(f), stripped(g)
    if any(degree > HIGHEST for degree in (*degrees(f), *degrees(g))):
        raise TooLongError
    reach = _reach(f, g)
    if not any(reach):
        return {(0,) * len(reach): 1}
    parts = sorted([*_coefficients(f, reach), *_coefficients(g, reach)], key=len)
    found = stripped(parts[0])
    for part in parts[1:]:
        if degrees(found) == reach:
            return _monic(found)
        found = common(found, part) if len(parts) > 2 else _by_remainders(found, part, reach)
    return _monic(found)


def _by_remainders(f: Poly, g: Poly, reach: list[int]) -> Poly:
    """Return the greatest common divisor of two polynomials by a sequence of remainders.

    ``reach`` is its degree in each variable.
    """
    if degrees(stripped(g)) == reach:
        return stripped(g)
    x = min((i for i, d in enumerate(reach) if d), key=lambda i: max(degrees(f)[i], degrees(g)[i]))
    contents = _content(f, x), _content(g, x)
    f, g = divided(f, contents[0]), divided(g, contents[1])
    for _ in range(reach[x], degrees(g)[x]):  # each remainder is of a lower degree
        if degrees(g)[x] == reach[x]:
            break
        rest = _remainder(f, g, x)
        f, g = g, stripped(divided(rest, _content(rest, x)))
    return times(g, common(*contents))


def _remainder(f: Poly, g: Poly, x: int) -> Poly:
    """Return the pseudo-remainder of f by g in the variable x."""
    degree = degrees(g)[x]
    lead = {_without(e, x): v for e, v in g.items() if e[x] == degree}
    for top in range(degrees(f)[x], degree - 1, -1):
        factor = {(*e[:x], top - degree, *e[x + 1 :]): v for e, v in f.items() if e[x] == top}
        if factor:
            f = _less(times(f, lead), times(factor, g))
        if len(f) > MOST_REMAINDER_TERMS:
            raise TooLongError
    return f


def _content(f: Poly, x: int) -> Poly:
    """Return the greatest common divisor of the coefficients of powers of x."""
    reach = [int(i == x) for i in range(len(next(iter(f))))]
    first, *others = sorted(_coefficients(f, [1 - r for r in reach]), key=len)
    for other in others:
        first = common(first, other)
    return first if others else _monic(first)


# ------------------------------------------------------------------------- arithmetic


def times(f: Poly, g: Poly) -> Poly:
    """Return a product."""
    spend(len(f) * len(g))
    result: Poly = {}
    for a, v in f.items():
        for b, w in g.items():
            e = tuple(map(int.__add__, a, b))
            result[e] = (result.get(e, 0) + v * w) % PRIME
    return {e: v for e, v in result.items() if v}


def divided(f: Poly, g: Poly) -> Poly:
    """Return the quotient of a polynomial by one of its divisors.

    Its degrees are those of the one less those of the other, and the highest exponents of what is
    left fall with each of its terms: there are no more of them than monomials of such degrees.
    """
    lead, most = max(g), list(map(int.__sub__, degrees(f), degrees(g)))
    inverse = pow(g[lead], -1, PRIME)
    rest, quotient = dict(f), Poly()
    while rest:
        spend(len(rest) + len(g))
        top = max(rest)
        at, value = tuple(map(int.__sub__, top, lead)), rest[top] * inverse % PRIME
        quotient[at] = value
        for e, v in g.items():
            place = tuple(map(int.__add__, e, at))
            left = (rest.pop(place, 0) - v * value) % PRIME
            if left:
                rest[place] = left
        assert all(0 <= a <= m for a, m in zip(at, most, strict=True)), "not a divisor"
        assert top not in rest, "the highest term is left"
    return quotient


def _less(f: Poly, g: Poly) -> Poly:
    spend(len(f) + len(g))
    result = {e: (f.get(e, 0) - g.get(e, 0)) % PRIME for e in f.keys() | g.keys()}
    return {e: v for e, v in result.items() if v}


def _monic(f: Poly) -> Poly:
    inverse = pow(f[max(f)], -1, PRIME)
    return {e: v * inverse % PRIME for e, v in f.items()}


def stripped(f: Poly) -> Poly:
    """Return a polynomial without the monomial that all terms share."""
    lowest = [min(column) for column in zip(*f, strict=True)]
    return {tuple(map(int.__sub__, e, lowest)): v for e, v in f.items()} if any(lowest) else f


def degrees(f: Poly) -> list[int]:
    """Return the highest exponent of each variable."""
    return [max(column) for column in zip(*f, strict=True)]


def _without(exponents: tuple[int, ...], x: int) -> tuple[int, ...]:
    return (*exponents[:x], 0, *exponents[x + 1 :])


def _coefficients(f: Poly, kept: list[int]) -> list[Poly]:
    """Return the coefficients of f, a polynomial in the variables that are not kept."""
    found: dict[tuple[int, ...], Poly] = {}
    for e, v in f.items():
        outside = tuple(0 if k else n for n, k in zip(e, kept, strict=True))
        inside = tuple(n if k else 0 for n, k in zip(e, kept, strict=True))
        found.setdefault(outside, {})[inside] = v
    return list(found.values())


# ----------------------------------------------------------------------- one variable


def _reach(f: Poly, g: Poly) -> list[int]:
    """Return the degree of the common divisor in each variable, others at random values."""
    here = [_values(p) for p in (f, g)]
    highest = zip(degrees(f), degrees(g), strict=True)
    return [
        _common_degree(*(_along(values, x) for values in here)) if all(both) else 0
        for x, both in enumerate(highest)
    ]


def _values(f: Poly) -> Poly:
    """Return the value of each term at a random point."""
    result: Poly = {}
    for exponents, value in f.items():
        for variable, e in enumerate(exponents):
            if e:
                value = value * _power(variable, e) % PRIME
        result[exponents] = value
    return result


@lru_cache(maxsize=4096)
def _power(variable: int, exponent: int) -> int:
    return pow(random.Random(f"variable {variable}").randrange(1, PRIME), exponent, PRIME)


def _along(values: Poly, x: int) -> list[int]:
    """Return the coefficients of powers of x, the lowest first, x in units of its value."""
    line = [0] * (1 + max(e[x] for e in values))
    for e, v in values.items():
        line[e[x]] += v
    return [v % PRIME for v in line]


def _common_degree(f: list[int], g: list[int]) -> int:
    """Return the degree of the common divisor: of two that are divided, the lower one falls."""
    while g:
        spend(1 + max(len(f) - len(g), 0) * len(g))
        rest = _rest(f, g)
        assert len(rest) < len(g), "a remainder is shorter"
        f, g = g, rest
    return len(f) - 1


def _rest(f: list[int], g: list[int]) -> list[int]:
    """Return the remainder of f by g, shorter than g."""
    rest, inverse = list(f), pow(g[-1], -1, PRIME)
    for at in range(len(f) - len(g), -1, -1):
        factor = rest.pop() * inverse % PRIME
        for i, v in enumerate(g[:-1]):
            rest[at + i] = (rest[at + i] - factor * v) % PRIME
    while rest and not rest[-1]:
        rest.pop()
    return rest
