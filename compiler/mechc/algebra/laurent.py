"""Laurent polynomials in z = exp(iα), polynomials in everything else.

A real sum of products of lengths, sines and cosines has one such form: that makes
equality decidable and lets factors z^u ± z^-u be found and turned back into cosines
and sines. A constant of a multiple of 90° is a power of i and goes into the
coefficient; other constants stay in the exponent, between 0° and 90°.

>>> from .product import sine, cosine
>>> a, b = Angle.of("alpha"), Angle.of("beta")
>>> expand(sine(a) * cosine(b)) + expand(cosine(a) * sine(b)) == expand(sine(a + b))
True
"""

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import NamedTuple

from .angle import Angle, Rational, rational
from .product import Factor, Product, Sum, Trig

Monomial = tuple[tuple[Factor, int], ...]
"""Powers of lengths and of whatever is not expanded, in reading order."""


class Gaussian(NamedTuple):
    """A complex number with rational parts."""

    re: Rational
    im: Rational


class Key(NamedTuple):
    """The exponents of one term: ``Π factor^e · exp(i·angle)``, angle.degrees in [0, 90)."""

    monomial: Monomial
    angle: Angle


Terms = Mapping[Key, Gaussian]
_POWERS_OF_I = (Gaussian(1, 0), Gaussian(0, 1), Gaussian(-1, 0), Gaussian(0, -1))


class Laurent:
    """A Laurent polynomial; immutable, no zero coefficients."""

    __slots__ = ("terms",)

    def __init__(self, terms: Terms) -> None:
        self.terms = terms

    @staticmethod
    def constant(value: Rational) -> "Laurent":
        """Return a constant polynomial."""
        return Laurent({Key((), Angle()): Gaussian(value, 0)} if value else {})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Laurent) and self.terms == other.terms

    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __len__(self) -> int:
        return len(self.terms)

    def __add__(self, other: "Laurent") -> "Laurent":
        return gather([*self.terms.items(), *other.terms.items()])

    def __mul__(self, other: "Laurent") -> "Laurent":
        return gather(
            _multiplied(key, value, k, v)
            for key, value in self.terms.items()
            for k, v in other.terms.items()
        )

    def scaled(self, factor: Rational) -> "Laurent":
        """Return the polynomial times a rational number."""
        by = Gaussian(factor, 0)
        return Laurent({k: _times(v, by) for k, v in self.terms.items()})

    def shifted(self, by: Monomial) -> "Laurent":
        """Return the polynomial times a monomial."""
        return Laurent({Key(_joined(k.monomial, by), k.angle): v for k, v in self.terms.items()})

    def grouped(self) -> dict[Monomial, "Laurent"]:
        """Return the trigonometric polynomial that stands before each monomial."""
        groups: dict[Monomial, dict[Key, Gaussian]] = {}
        for key, value in self.terms.items():
            groups.setdefault(key.monomial, {})[Key((), key.angle)] = value
        return {m: Laurent(terms) for m, terms in groups.items()}


def gather(terms: Iterable[tuple[Key, Gaussian]]) -> Laurent:
    """Add up terms of equal exponents and drop those that vanish."""
    sums: dict[Key, Gaussian] = {}
    for key, value in terms:
        old = sums.get(key)
        if old is not None:
            value = Gaussian(rational(old.re + value.re), rational(old.im + value.im))
        sums[key] = value
    return Laurent({k: v for k, v in sums.items() if v.re or v.im})


def _times(a: Gaussian, b: Gaussian) -> Gaussian:
    if not a.im and not b.im:
        return Gaussian(rational(a.re * b.re), 0)
    return Gaussian(rational(a.re * b.re - a.im * b.im), rational(a.re * b.im + a.im * b.re))


def _inverse(a: Gaussian) -> Gaussian:
    norm = a.re * a.re + a.im * a.im
    return Gaussian(rational(Fraction(a.re) / norm), rational(Fraction(-a.im) / norm))


def _wrapped(angle: Angle, value: Gaussian) -> tuple[Angle, Gaussian]:
    """Move whole quarter turns of an exponent into the coefficient."""
    quarters = int(angle.degrees // 90)
    if quarters:
        angle = Angle(angle.terms, rational(angle.degrees - 90 * quarters))
        value = _times(value, _POWERS_OF_I[quarters % 4])
    return angle, value


def _multiplied(a: Key, value: Gaussian, b: Key, other: Gaussian) -> tuple[Key, Gaussian]:
    angle, result = _wrapped(a.angle + b.angle, _times(value, other))
    return Key(_joined(a.monomial, b.monomial), angle), result


def _joined(a: Monomial, b: Monomial) -> Monomial:
    if not a or not b:
        return a or b
    powers = dict(a)
    for factor, e in b:
        powers[factor] = powers.get(factor, 0) + e
    return monomial(powers)


def monomial(powers: Mapping[Factor, int]) -> Monomial:
    """Return powers in reading order, without those that vanish."""
    return tuple(sorted(((f, e) for f, e in powers.items() if e), key=lambda fe: fe[0].order()))


# -------------------------------------------------------------------------- expansion


def binomial(trig: Trig) -> Laurent:
    """Return a sine or cosine as (z^u ∓ z^-u)/2i or /2."""
    half = Fraction(1, 2)
    if trig.function == "cos":
        up, down = Gaussian(half, 0), Gaussian(half, 0)
    else:
        up, down = Gaussian(0, -half), Gaussian(0, half)
    pairs = (_wrapped(trig.angle, up), _wrapped(-trig.angle, down))
    return gather((Key((), angle), value) for angle, value in pairs)


def expand(product: Product, deep: bool = True) -> Laurent:
    """Return a product multiplied out; sums in it too if ``deep``, else they stay whole.

    Sines, cosines and sums must have positive exponents.
    """
    whole: dict[Factor, int] = {}
    result = Laurent.constant(product.coefficient)
    for factor, exponent in product.factors.items():
        if isinstance(factor, Trig):
            part = binomial(factor)
        elif isinstance(factor, Sum) and deep:
            part = expand_all(factor.terms)
        else:
            whole[factor] = exponent
            continue
        for _ in range(exponent):
            result = result * part
    return result.shifted(monomial(whole))


def expand_all(products: Iterable[Product], deep: bool = True) -> Laurent:
    """Return the sum of several products, multiplied out."""
    return gather(item for p in products for item in expand(p, deep).terms.items())


def size(product: Product, deep: bool = True) -> int:
    """Return how many terms a product has at most when it is multiplied out."""
    terms = 1
    for factor, exponent in product.factors.items():
        if isinstance(factor, Trig):
            terms *= 2**exponent
        elif isinstance(factor, Sum) and deep:
            terms *= sum(size(t) for t in factor.terms) ** exponent
    return terms


# --------------------------------------------------------------------------- division

Order = Callable[[Key], tuple[Rational, ...]]


def divide(dividend: Laurent, divisor: Laurent) -> Laurent | None:
    """Return the exact quotient, or None where there is none.

    Ordinary long division by the leading term; it ends because the lowest exponent of
    every symbol is known beforehand (lowest exponents add up in a product). The
    constant part of an angle takes no part in the order of terms, so a divisor whose
    leading coefficient is a sum of constants is refused (None).
    """
    order = _lexicographic(dividend, divisor)
    lead = _leading(divisor, order)
    if lead is None:
        return None
    inverse = Key(tuple((f, -e) for f, e in lead.monomial), -lead.angle)
    by = _inverse(divisor.terms[lead])
    lowest = [x - y for x, y in zip(_lowest(dividend, order), _lowest(divisor, order), strict=True)]
    quotient: list[tuple[Key, Gaussian]] = []
    rest = dividend
    while rest:
        top = max(map(order, rest.terms))
        part = [_multiplied(k, v, inverse, by) for k, v in rest.terms.items() if order(k) == top]
        if any(e < low for k, _ in part for e, low in zip(order(k), lowest, strict=True)):
            return None
        quotient.extend(part)
        rest = rest + (gather(part) * divisor).scaled(-1)
    return gather(quotient)


def _leading(p: Laurent, order: Order) -> Key | None:
    top = max(map(order, p.terms))
    keys = [k for k in p.terms if order(k) == top]
    return keys[0] if len(keys) == 1 else None


def _lowest(p: Laurent, order: Order) -> list[Rational]:
    """Return the lowest exponent of each symbol."""
    return [min(exponents) for exponents in zip(*map(order, p.terms), strict=True)]


def _lexicographic(*polynomials: Laurent) -> Order:
    """Return the order of exponents, name by name, over all names that occur."""
    keys = [k for p in polynomials for k in p.terms]
    factors = sorted({f for k in keys for f, _ in k.monomial}, key=lambda f: f.order())
    names = sorted({n for k in keys for n, _ in k.angle.terms})

    def order(key: Key) -> tuple[Rational, ...]:
        powers, turns = dict(key.monomial), dict(key.angle.terms)
        return (*(powers.get(f, 0) for f in factors), *(turns.get(n, 0) for n in names))

    return order
