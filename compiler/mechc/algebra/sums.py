"""Sums of products in canonical form, and what cancels in a product.

>>> from ..formula.to_text import text
>>> from .angle import Angle
>>> from .trigonometry import sine, cosine
>>> a, b = Angle.of("alpha"), Angle.of("beta")
>>> tan_a, tan_b = sine(a) / cosine(a), sine(b) / cosine(b)
>>> text(add([tan_a, tan_b]).formula())
'sin(alpha + beta)/(cos(alpha)*cos(beta))'
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from .angle import Angle, Rational, rational
from .factoring import factor, factored
from .factors import Factor, Trig
from .fine import named, valued
from .halving import split_by_half
from .laurent import Ring, size
from .modular import Point
from .product import ZERO, Bound, Product, Sum
from .reduction import is_searchable, reduced
from .trigonometry import cosine, sine

LIMIT = 96
"""A sum with more terms than this when multiplied out keeps its inner sums whole."""
ROOT = Trig("cos", Angle.constant(45))
"""The one constant whose square is rational while it is not."""
_HALVINGS = 4
"""sin 16u / sin u is seen to cancel; sin 32u / sin u is not."""


def add(products: Iterable[Product]) -> Product:
    """Return the sum of products, factored, its common factors cancelled.

    Canonical while the sum has at most :data:`LIMIT` terms when multiplied out; beyond
    that it is kept as written (equality is then tested, not structural).
    """
    terms = [p for p in products if p]
    if len(terms) > 1:
        terms = _merged(terms)
    if len(terms) <= 1:
        return canonical(terms[0]) if terms else ZERO
    common = _common(terms)
    rests = [t / common for t in terms]
    if sum(map(size, rests)) <= LIMIT and not any(map(_rests_on_names, rests)):
        return canonical(common * factored(rests))
    if _vanishes(rests):
        return ZERO
    for deep in (True, False):
        if sum(size(r, deep) for r in rests) <= LIMIT:
            return canonical(common * factored(rests, deep))
    return _kept(terms)


def _rests_on_names(product: Product) -> bool:
    """Tell whether a product has a bound sum in it, about which the name says nothing."""
    return any(
        isinstance(f, Bound) or (isinstance(f, Sum) and any(map(_rests_on_names, f.terms)))
        for f in product.factors
    )


def _vanishes(terms: Sequence[Product]) -> bool:
    """Tell at a random point whether a sum vanishes that is not multiplied out to the end."""
    point = Point()
    return sum(t.residue(point) for t in terms) % point.prime == 0


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
    for common, e in first.factors.items():
        exponents = [e, *(t.factors.get(common, 0) for t in others)]
        if min(exponents) > 0:
            shared[common] = min(exponents)
        elif max(exponents) < 0:
            shared[common] = max(exponents)
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
    if sum(isinstance(f, (Trig, Sum)) for f in product.factors) < 2 and ROOT not in product.factors:
        return product
    return _double_angles(_squares(_halved(_cancelled(product))))


def _cancelled(product: Product) -> Product:
    """Cancel what a sum above the line and one below it have in common."""
    sums = [(f, e) for f, e in product.factors.items() if isinstance(f, Sum)]
    for upper, e in sums:
        for lower, d in sums:
            if e > 0 > d and (quotient := _quotient(upper, lower)) is not None:
                return _cancelled(product * Product(1, {upper: -1, lower: 1}) * quotient)
    return product


def _quotient(upper: Sum, lower: Sum) -> Product | None:
    """Return the quotient of two sums without their common divisor, None if they have none."""
    if sum(map(size, upper.terms)) > LIMIT or sum(map(size, lower.terms)) > LIMIT:
        return None
    sums = upper.terms, lower.terms
    if not is_searchable(Ring([*upper.terms, *lower.terms])):
        sums = tuple(map(named, upper.terms)), tuple(map(named, lower.terms))
    ring = Ring([*sums[0], *sums[1]])
    cofactors = reduced(ring, *map(ring.expand, sums))
    if cofactors is None:
        return None
    above, below = (factored([valued(factor(ring, c))]) for c in cofactors)
    return above / below


def _halved(product: Product) -> Product:
    """Split off a sum what cancels against half the angle of a sine or cosine."""
    for whole, e in product.factors.items():
        if isinstance(whole, Sum) and sum(map(size, whole.terms)) <= LIMIT:
            opposite = [f for f, d in product.factors.items() if isinstance(f, Trig) and e * d < 0]
            split = next(filter(None, (split_by_half(whole, f) for f in opposite)), None)
            if split is not None:
                rest = product * (split * Product(1, {whole: -1})) ** (1 if e > 0 else -1)
                return _halved(_double_angles(rest))
    return product


def _squares(product: Product) -> Product:
    """Replace cos² 45° by 1/2."""
    e = product.factors.get(ROOT, 0)
    pairs = e // 2 if e > 0 else -(-e // 2)
    if not pairs:
        return product
    return product * Product(1, {ROOT: -2 * pairs}) * Product(Fraction(1, 2)) ** pairs


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
    lines: dict[tuple[str, ...], list[Angle]] = {}
    for trig in product.factors:
        if isinstance(trig, Trig):
            others = lines.setdefault(tuple(name for name, _ in trig.angle.terms), [])
            if any(_are_parallel(trig.angle, other) for other in others):
                return True
            others.append(trig.angle)
    return False


def _are_parallel(a: Angle, b: Angle) -> bool:
    """Tell whether angles of the same symbols are multiples, their constants apart."""
    if not a.terms:
        return True
    p, q = a.terms[0][1], b.terms[0][1]
    return all(c * q == d * p for (_, c), (_, d) in zip(a.terms, b.terms, strict=True))


def _split_one(product: Product) -> Product | None:
    trigs = [(f, e) for f, e in product.factors.items() if isinstance(f, Trig)]
    for whole, e in trigs:
        if any(d * e < 0 and _is_part(part, whole) for part, d in trigs):
            half = _as_sine(whole).half()
            parts = sine(half) * cosine(half) * Product(2)
            return product * Product(1, {whole: -e}) * parts**e
    return None


def _is_part(part: Trig, whole: Trig) -> bool:
    """Tell whether halving the angle of one, again and again, comes to the other."""
    angle, halvings = _as_sine(part), range(1, _HALVINGS + 1)
    if not angle.terms:
        return any(_as_sine(whole) == angle * 2**n for n in halvings)
    return any(whole in sine(angle * 2**n).factors for n in halvings)


def _as_sine(trig: Trig) -> Angle:
    """Return B with trig = sin B.

    Of constants it is at most 90°: doubled beyond that, they come round to where they began
    (10°, 20°, 40°, 80°, sin 160° = sin 20°), and what is split would be split again for ever.
    """
    if trig.function == "sin":
        return trig.angle
    quarter = Angle.constant(90)
    return trig.angle + quarter if trig.angle.terms else quarter - trig.angle


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
