"""Sums of products in canonical form, and what cancels in a product.

>>> from .formula import text
>>> from .angle import Angle
>>> from .product import sine, cosine
>>> a, b = Angle.of("alpha"), Angle.of("beta")
>>> tan_a, tan_b = sine(a) / cosine(a), sine(b) / cosine(b)
>>> text(add([tan_a, tan_b]).formula())
'sin(alpha + beta)/(cos(alpha)*cos(beta))'
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from .angle import Angle, Rational, rational
from .factoring import factor, factored
from .laurent import Ring, size
from .product import ZERO, Factor, Product, Sum, Trig, cosine, sine

LIMIT = 96
"""A sum with more terms than this when multiplied out keeps its inner sums whole."""
_HALVINGS = 4
"""sin 16u / sin u is seen to cancel; sin 32u / sin u is not."""


def add(products: Iterable[Product]) -> Product:
    """Return the sum of products, factored, its common factors cancelled.

    Canonical while the sum has at most :data:`LIMIT` terms when multiplied out; beyond
    that it is kept as written (equality is then tested, not structural).
    """
    terms = _merged(products)
    if len(terms) <= 1:
        return terms[0] if terms else ZERO
    common = _common(terms)
    rests = [t / common for t in terms]
    for deep in (True, False):
        if sum(size(r, deep) for r in rests) <= LIMIT:
            return canonical(common * factored(rests, deep))
    return _kept(terms)


def _merged(products: Iterable[Product]) -> list[Product]:
    """Add up products that differ in their coefficient only."""
    sums: dict[frozenset[tuple[Factor, int]], Rational] = {}
    for p in products:
        name = frozenset(p.factors.items())
        sums[name] = rational(sums.get(name, 0) + p.coefficient)
    return [Product(c, dict(name)) for name, c in sums.items() if c]


def _common(terms: Sequence[Product]) -> Product:
    """Return the lowest power of each factor over all terms (0 where it is absent)."""
    factors = {f for t in terms for f in t.factors}
    lowest = {f: min(t.factors.get(f, 0) for t in terms) for f in factors}
    return Product(1, {f: e for f, e in lowest.items() if e})


def _shared(terms: Sequence[Product]) -> Product:
    """Return what all terms have above the line, or all below it."""
    first, *others = terms
    shared: dict[Factor, int] = {}
    for factor, e in first.factors.items():
        exponents = [e, *(t.factors.get(factor, 0) for t in others)]
        if min(exponents) > 0:
            shared[factor] = min(exponents)
        elif max(exponents) < 0:
            shared[factor] = max(exponents)
    return Product(1, shared)


def _kept(terms: Sequence[Product]) -> Product:
    """Return a long sum as it stands, its terms in a fixed order and the first one positive.

    Its terms are not brought over one denominator: that would multiply each by those of
    all the others.
    """
    shared = _shared(terms)
    return shared * _as_written([t / shared for t in terms])


def _as_written(rests: Sequence[Product]) -> Product:
    ordered = tuple(
        sorted(rests, key=lambda t: sorted((f.order(), e) for f, e in t.factors.items()))
    )
    if ordered[0].coefficient < 0:
        return Product(-1, {Sum(tuple(-t for t in ordered)): 1})
    return Product.of(Sum(ordered))


# --------------------------------------------------------------------------- cancelling


def canonical(product: Product) -> Product:
    """Return the product with sums cancelled against sums and double angles settled."""
    return _double_angles(_squares(_cancelled(product)))


def _cancelled(product: Product) -> Product:
    """Divide sums above the line by sums below it, and the other way round."""
    sums = [(f, e) for f, e in product.factors.items() if isinstance(f, Sum)]
    for upper, e in sums:
        for lower, d in sums:
            if e * d < 0 and upper.terms != lower.terms:
                quotient = _quotient(upper, lower)
                if quotient is not None:
                    times = Product(1, {upper: -1, lower: 1}) * quotient
                    return _cancelled(product * (times if e > 0 else times**-1))
    return product


def _quotient(upper: Sum, lower: Sum) -> Product | None:
    if sum(map(size, upper.terms)) > LIMIT or sum(map(size, lower.terms)) > LIMIT:
        return None
    ring = Ring((*upper.terms, *lower.terms))
    result = ring.divide_exactly(ring.expand(upper.terms), ring.expand(lower.terms))
    return None if result is None else factor(ring, result)


def _squares(product: Product) -> Product:
    """Replace cos² 45° by 1/2."""
    root = Trig("cos", Angle.constant(45))
    e = product.factors.get(root, 0)
    pairs = e // 2 if e > 0 else -(-e // 2)
    if not pairs:
        return product
    return product * Product(1, {root: -2 * pairs}) * Product(Fraction(1, 2)) ** pairs


def _double_angles(product: Product) -> Product:
    """Split sin 2u where a half of it cancels; then join sin u · cos u left together."""
    if not _shares_a_line(product):
        return product
    while (split := _split_one(product)) is not None:
        product = split
    while (joined := _join_one(product)) is not None:
        product = joined
    return product


def _shares_a_line(product: Product) -> bool:
    """Tell whether two angles are multiples of one another, their constants apart.

    Most products have no such pair, and a long one is not to be searched for nothing.
    """
    lines = set()
    for trig in product.factors:
        if isinstance(trig, Trig):
            terms = trig.angle.terms
            line = tuple((name, Fraction(c) / terms[0][1]) for name, c in terms)
            if line in lines:
                return True
            lines.add(line)
    return False


def _split_one(product: Product) -> Product | None:
    for trig, e in product.factors.items():
        if isinstance(trig, Trig) and any(product.factors.get(f, 0) * e < 0 for f in _halves(trig)):
            half = _doubled(trig).half()
            parts = sine(half) * cosine(half) * Product(2)
            return product * Product(1, {trig: -e}) * parts**e
    return None


def _doubled(trig: Trig) -> Angle:
    """Return B with trig = sin B."""
    quarter = Angle.constant(90) if trig.function == "cos" else Angle()
    return trig.angle + quarter


def _halves(trig: Trig) -> Iterator[Factor]:
    """Yield sines and cosines of B/2, B/4 … whose product with one another is in sin B."""
    angle = _doubled(trig)
    for _ in range(_HALVINGS):
        angle = angle.half()
        yield from sine(angle).factors
        yield from cosine(angle).factors


def _join_one(product: Product) -> Product | None:
    for trig, s in product.factors.items():
        if isinstance(trig, Trig) and trig.function == "sin":
            twin = Trig("cos", trig.angle)
            c = product.factors.get(twin, 0)
            if s * c > 0:
                both = min(s, c) if s > 0 else max(s, c)
                double = sine(trig.angle * 2) * Product(Fraction(1, 2))
                return product * (double * Product(1, {trig: -1, twin: -1})) ** both
    return None
