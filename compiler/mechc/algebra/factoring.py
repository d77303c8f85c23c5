"""From a Laurent polynomial back to a product: contents, sines, cosines, one primitive sum.

What is found: the rational content, the common monomial, every factor sin u or cos u
with u in the lattice of the angles that occur, and a pure length factor that splits
off as a whole. What remains is one canonical :class:`~.product.Sum`, written as
(monomial) · (its trigonometric coefficient, itself factored), first term positive.
"""

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import gcd, lcm

from .angle import Angle, Rational, rational
from .laurent import Gaussian, Key, Laurent, Monomial, binomial, divide, monomial
from .product import ONE, ZERO, Factor, Product, Sum, Trig, cosine, sine


def factor(p: Laurent) -> Product:
    """Return a real polynomial as a factored product.

    >>> from .product import cosine
    >>> from .laurent import expand_all
    >>> a, b = Angle.of("alpha"), Angle.of("beta")
    >>> difference = expand_all([cosine(a - b), -cosine(a + b)])
    >>> factor(difference) == sine(a) * sine(b) * Product(2)
    True
    """
    if not p:
        return ZERO
    content, common, p = _primitive(p)
    head = Product(content, dict(common))
    lengths, p = _separate(p)
    trigs, p = _extract(p)
    for part in (lengths, p):
        head = head * _as_sum(part)
    return head * trigs


def _primitive(p: Laurent) -> tuple[Rational, Monomial, Laurent]:
    """Split off the rational content and the common monomial."""
    content = _content(x for v in p.terms.values() for x in v if x)
    powers: dict[Factor, int] | None = None
    for key in p.terms:
        here = dict(key.monomial)
        if powers is None:
            powers = here
        else:
            powers = {f: min(e, here[f]) for f, e in powers.items() if f in here}
        if not powers:
            break
    common = monomial(powers or {})
    rest = p.shifted(tuple((f, -e) for f, e in common)).scaled(rational(1 / Fraction(content)))
    return content, common, rest


def _content(values: Iterable[Rational]) -> Rational:
    """Return the largest positive rational of which all values are integer multiples."""
    parts = [Fraction(x) for x in values]
    return rational(
        Fraction(gcd(*(x.numerator for x in parts)), lcm(*(x.denominator for x in parts)))
    )


def _separate(p: Laurent) -> tuple[Laurent, Laurent]:
    """Split p into (lengths) · (angles) if it is such a product, else into 1 · p."""
    groups = list(p.grouped().items())
    first = groups[0][1]
    if len(groups) == 1 or len(first) == 1:
        return Laurent.constant(1), p
    unit = Key((), Angle())
    ratios: dict[Key, Gaussian] = {}
    for powers, group in groups:
        ratio = _proportion(group, first)
        if ratio is None:
            return Laurent.constant(1), p
        ratios[Key(powers, unit.angle)] = Gaussian(ratio, 0)
    return Laurent(ratios), first


def _proportion(a: Laurent, b: Laurent) -> Rational | None:
    """Return r with a = r·b, if there is such a rational."""
    if a.terms.keys() != b.terms.keys():
        return None
    key = next(iter(b.terms))
    index = 0 if b.terms[key].re else 1
    ratio = rational(Fraction(a.terms[key][index]) / Fraction(b.terms[key][index]))
    return ratio if ratio and b.scaled(ratio) == a else None


# ------------------------------------------------------------------- sines and cosines


def _extract(p: Laurent) -> tuple[Product, Laurent]:
    """Divide out every sine and cosine that divides p."""
    groups = p.grouped().values()
    found = ONE
    for trig in _candidates(min(groups, key=len)):
        pair = binomial(trig)
        while len(p) > 1 and (quotient := divide(p, pair)) is not None:
            found, p = found * Product.of(trig), quotient
    return found, p


def _candidates(p: Laurent) -> Iterator[Trig]:
    """Yield the sines and cosines that could divide a trigonometric polynomial.

    Such a factor makes an edge of the polytope of exponents, so twice its angle is a
    part of the difference between an extreme exponent and another one.
    """
    angles = [key.angle for key in p.terms]
    if len(angles) < 2:
        return
    extreme = max(angles, key=lambda a: _vector(a, angles))
    scale = lcm(*(Fraction(c).denominator for a in angles for _, c in a.terms))
    shifts = (0, 90) if any(a.degrees for a in angles) else (0,)
    seen: set[Angle] = set()
    for other in sorted(angles, key=str):
        span = extreme - other
        for parts in _divisors(span, scale):
            for shift in shifts:
                half = (span + Angle.constant(shift)) * Fraction(1, 2 * parts)
                if half not in seen:
                    seen.add(half)
                    yield from _both(half)


def _vector(angle: Angle, angles: Iterable[Angle]) -> list[Rational]:
    turns = dict(angle.terms)
    return [turns.get(n, 0) for n in sorted({n for a in angles for n, _ in a.terms})]


def _divisors(span: Angle, scale: int) -> Iterator[int]:
    """Yield the numbers of parts into which half a span can be cut within the lattice."""
    if not span.terms:
        return
    whole = gcd(*(int(c * scale) for _, c in span.terms))
    for parts in range(1, whole // 2 + 1):
        if whole % (2 * parts) == 0:
            yield parts


def _both(angle: Angle) -> Iterator[Trig]:
    for product in (sine(angle), cosine(angle)):
        yield from (f for f in product.factors if isinstance(f, Trig))


# ---------------------------------------------------------------------- the sum itself


def _as_sum(p: Laurent) -> Product:
    """Return a primitive polynomial as a constant or as one canonical sum."""
    terms = _readable(p)
    if len(terms) == 1:
        return terms[0]
    content = _content(t.coefficient for t in terms)
    if terms[0].coefficient < 0:
        content = -content
    return Product(content, {Sum(tuple(t.scaled(1 / Fraction(content)) for t in terms)): 1})


def _readable(p: Laurent) -> list[Product]:
    """Return the terms as they are read: by monomials, each coefficient factored."""
    groups = p.grouped()
    if len(groups) == 1:
        ((powers, group),) = groups.items()
        terms = [Product(1, dict(powers)) * t for t in _linear(group)]
    else:
        terms = [Product(1, dict(powers)) * factor(group) for powers, group in groups.items()]
    return sorted(terms, key=_place)


def _place(term: Product) -> tuple[int, list[tuple[tuple[int, str], int]]]:
    degree = sum(e for f, e in term.factors.items() if not isinstance(f, Trig))
    return degree, sorted((f.order(), e) for f, e in term.factors.items())


def _linear(p: Laurent) -> list[Product]:
    """Return a real trigonometric polynomial as a sum of single sines and cosines."""
    sums: dict[frozenset[tuple[Factor, int]], Rational] = {}
    for key, value in p.terms.items():
        for part in (cosine(key.angle).scaled(value.re), -sine(key.angle).scaled(value.im)):
            if part:
                name = frozenset(part.factors.items())
                sums[name] = rational(sums.get(name, 0) + part.coefficient)
    return [Product(c, dict(name)) for name, c in sums.items() if c]
