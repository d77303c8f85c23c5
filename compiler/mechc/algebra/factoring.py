"""From a polynomial back to a product: contents, sines, cosines, one primitive sum.

What is found: the rational content, the common monomial, every factor sin u or cos u
with u in the lattice of the angles that occur, and a pure length factor that splits
off as a whole. What remains is one canonical :class:`~.product.Sum`, written as
(monomial) · (its trigonometric coefficient, itself factored), first term positive.

>>> a, b = Angle.of("alpha"), Angle.of("beta")
>>> difference = [cosine(a - b), -cosine(a + b)]
>>> factored(difference) == sine(a) * sine(b) * Product(2)
True
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from math import gcd, lcm

from ..work import kept
from .angle import Angle, Rational, rational
from .factors import Factor, FactorRank, Trig
from .laurent import Polynomial, Ring, Terms
from .product import ONE, ZERO, Product, Sum, WrittenProduct, as_product
from .trigonometry import cosine, sine

MULTIPLES = 8
"""sin 8u is the highest multiple angle whose factors are looked for."""


def factored(products: Sequence[Product], deep: bool = True) -> Product:
    """Return a sum of products, multiplied out and factored.

    Sums inside the products are multiplied out if ``deep``, else they stay whole.
    """
    return _factored(tuple(p.written() for p in products), deep)


@kept
def _factored(written: tuple[WrittenProduct, ...], deep: bool) -> Product:
    products = list(map(as_product, written))
    ring = Ring(products, deep)
    return factor(ring, ring.expand(products))


def factor(ring: Ring, p: Polynomial) -> Product:
    """Return a real polynomial as a product: its content, lengths, sines and cosines, and sums.

    Sums are split as far as lengths and angles separate; 0 is the product ZERO.
    """
    if not p.terms:
        return ZERO
    content, common, terms = _primitive(ring, p.terms)
    lengths, terms = _separate(ring, terms)
    trigs, terms = _extract(ring, terms)
    head = Product(rational(p.scale * content), common) * trigs
    return head * _as_sum(ring, lengths) * _as_sum(ring, terms)


def _primitive(ring: Ring, terms: Terms) -> tuple[int, dict[Factor, int], Terms]:
    """Split off the integer content and the common monomial."""
    content = gcd(*(x for value in terms.values() for x in value))
    powers: dict[Factor, int] | None = None
    for key in terms:
        here = ring.monomial(key)
        powers = here if powers is None else _lower(powers, here)
        if not powers:
            break
    common = powers or {}
    shift = sum(ring.factor_shift(f, e) for f, e in common.items())
    rest = {k - shift: (re // content, im // content) for k, (re, im) in terms.items()}
    return content, common, rest


def _lower(a: dict[Factor, int], b: dict[Factor, int]) -> dict[Factor, int]:
    return {f: min(e, b[f]) for f, e in a.items() if f in b}


def grouped(ring: Ring, terms: Terms) -> dict[int, Terms]:
    """Return the trigonometric polynomial that stands before each (packed) monomial."""
    groups: dict[int, Terms] = {}
    for key, value in terms.items():
        monomial, angle = ring.split(key)
        groups.setdefault(monomial, {})[angle] = value
    return groups


def _separate(ring: Ring, terms: Terms) -> tuple[Terms, Terms]:
    """Split a polynomial into (lengths) · (angles) if it is such a product, else into 1 · p."""
    one: Terms = {0: (1, 0)}
    groups = grouped(ring, terms)
    if len(groups) == 1 or any(len(g) == 1 for g in groups.values()):
        return one, terms
    contents = {m: gcd(*(x for v in g.values() for x in v)) for m, g in groups.items()}
    base = {
        k: _divided(v, contents[m]) for m, g in [next(iter(groups.items()))] for k, v in g.items()
    }
    lengths: Terms = {}
    for monomial, group in groups.items():
        ratio = _ratio({k: _divided(v, contents[monomial]) for k, v in group.items()}, base)
        if not ratio:
            return one, terms
        lengths[monomial] = (ratio * contents[monomial], 0)
    return lengths, base


def _divided(value: tuple[int, int], by: int) -> tuple[int, int]:
    """Return a complex integer without a factor that both of its parts have."""
    return value[0] // by, value[1] // by


def _ratio(a: Terms, b: Terms) -> int:
    """Return +1 or −1 if a = ±b, else 0."""
    if a == b:
        return 1
    return -1 if a == {k: (-re, -im) for k, (re, im) in b.items()} else 0


# ------------------------------------------------------------------- sines and cosines


def _extract(ring: Ring, terms: Terms) -> tuple[Product, Terms]:
    """Divide out every sine and cosine that divides a polynomial."""
    found = ONE
    smallest = min(grouped(ring, terms).values(), key=len)
    for trig in _candidates(ring, ring.short(smallest)):
        while len(terms) > 1 and (quotient := ring.divide(terms, trig)) is not None:
            found, terms = found * Product(2, {trig: 1}), quotient
    return found, terms


def _candidates(ring: Ring, terms: Terms) -> Iterator[Trig]:
    """Yield the sines and cosines that could divide a trigonometric polynomial.

    Such a factor makes an edge of the polytope of exponents, so twice its angle is a
    part of the difference between an extreme exponent and another one.
    """
    if len(terms) < 2:
        return
    top = max(terms)
    extreme = ring.angle(top)
    shifts = (0, 90) if ring.has_constants else (0,)
    seen: set[Angle] = set()
    for key in sorted(terms):
        span = extreme - ring.angle(key)
        for parts in _divisors(span, ring.scale):
            for shift in shifts:
                half = (span + Angle.constant(shift)) * Fraction(1, 2 * parts)
                if half not in seen and ring.holds(half):
                    seen.add(half)
                    yield from _both(half)


def _divisors(span: Angle, scale: int) -> Iterator[int]:
    """Yield the numbers of parts into which half a span can be cut within the lattice."""
    if not span.terms:
        return
    whole = gcd(*(int(c * scale) for _, c in span.terms))
    for parts in range(1, min(whole // 2, MULTIPLES) + 1):
        if whole % (2 * parts) == 0:
            yield parts


def _both(angle: Angle) -> Iterator[Trig]:
    for product in (sine(angle), cosine(angle)):
        yield from (f for f in product.factors if isinstance(f, Trig))


# ---------------------------------------------------------------------- the sum itself


def _as_sum(ring: Ring, terms: Terms) -> Product:
    """Return a primitive polynomial as a constant or as one canonical sum."""
    if terms == {0: (1, 0)}:
        return ONE
    read = _readable(ring, terms)
    if len(read) == 1:
        return read[0]
    content = content_of(t.coefficient for t in read)
    if read[0].coefficient < 0:
        content = -content
    return Product(content, {Sum(tuple(t.scaled(1 / Fraction(content)) for t in read)): 1})


def content_of(values: Iterable[Rational]) -> Rational:
    """Return the largest positive rational of which all values are integer multiples."""
    parts = [Fraction(x) for x in values]
    return rational(
        Fraction(gcd(*(x.numerator for x in parts)), lcm(*(x.denominator for x in parts)))
    )


def _readable(ring: Ring, terms: Terms) -> list[Product]:
    """Return the terms as they are read: by monomials, each coefficient factored."""
    groups = grouped(ring, terms)
    if len(groups) == 1:
        ((monomial, group),) = groups.items()
        powers = Product(1, ring.monomial(monomial))
        read = [powers * t for t in _linear(ring, group)]
    else:
        read = [
            Product(1, ring.monomial(m)) * factor(ring, Polynomial(1, g)) for m, g in groups.items()
        ]
    return sorted(read, key=_place)


def _place(term: Product) -> tuple[int, list[tuple[FactorRank, int]]]:
    degree = sum(e for f, e in term.factors.items() if not isinstance(f, Trig))
    return degree, sorted((f.order(), e) for f, e in term.factors.items())


def _linear(ring: Ring, terms: Terms) -> list[Product]:
    """Return a real trigonometric polynomial as a sum of single sines and cosines."""
    sums: dict[Product, Rational] = {}
    for key, value in ring.short(terms).items():
        for part in ring.single(key, value):
            monomial = Product(1, part.factors)
            sums[monomial] = rational(sums.get(monomial, 0) + part.coefficient)
    return [monomial.scaled(c) for monomial, c in sums.items() if c]
