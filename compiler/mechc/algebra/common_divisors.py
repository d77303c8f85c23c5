"""Cancelling what two sums have in common, from images over the prime field.

The constants of a ring are roots of unity ζ with n = 4·parts directions. The field has
them all, so a sum has one image for each of the φ(n) choices of ζ; the common divisor
is found in each, and the coefficients of the two cofactors are interpolated and read
back as rational numbers (Wang 1981). Proof: numerator times the other's cofactor is the
same both ways, multiplied out exactly.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from math import gcd, isqrt, lcm

from ..base.named import NamedTuple
from .cyclotomic import unique
from .gcd import Poly, TooLongError, common, divided
from .laurent import Polynomial, Ring
from .modular import PRIME, direction

CONJUGATES = 16
"""Constants of more than so many conjugates are not looked into."""


Cofactors = tuple[list[Poly], ...]
"""Numerator and denominator, each under every choice of ζ."""

Monomial = tuple[int, ...]
"""The exponents of a term."""

PolynomialQuotient = tuple[Polynomial, Polynomial]


class Images(NamedTuple):
    """A sum under each choice of ζ, and the lowest exponent of each variable."""

    polys: list[Poly]
    lowest: tuple[int, ...]


def reduced(ring: Ring, upper: Polynomial, lower: Polynomial) -> PolynomialQuotient | None:
    """Return two real sums of the same quotient, without their common divisor.

    None if there is none, or none that is real in these angles, or the search is too long.
    """
    if not is_searchable(ring):
        return None
    units = conjugates(ring.parts)
    try:
        cofactors = _cofactors(*(_images(ring, p, units) for p in (upper, lower)))
    except TooLongError:
        return None
    if cofactors is None:
        return None
    turned = _made_real(ring, cofactors, units)
    if turned is None:
        return None
    above, below = (_lifted(ring, images) for images in turned)
    above = Polynomial(above.scale * Fraction(upper.scale) / lower.scale, above.terms)
    return (above, below) if _is_proved(ring, (upper, lower), (above, below)) else None


def is_searchable(ring: Ring) -> bool:
    """Return whether the constants of a ring have few enough conjugates."""
    return len(conjugates(ring.parts)) <= CONJUGATES


@lru_cache(maxsize=64)
def conjugates(parts: int) -> tuple[int, ...]:
    """Return the choices of ζ, as powers of the first one; of too many only some."""
    found: list[int] = []
    for k in range(1, 4 * parts):
        if gcd(k, 4 * parts) == 1:
            found.append(k)
        if len(found) > CONJUGATES:
            break
    return tuple(found)


def _images(ring: Ring, p: Polynomial, units: Sequence[int]) -> Images:
    """Return a sum's images over the prime field, one for each choice of the root of unity ζ.

    ``units`` are these choices, as powers of the first ζ. Laurent polynomials have negative
    exponents and images have none: each variable's are counted from the lowest one in the sum.
    """
    exponents = {key: ring.exponents(key) for key in p.terms}
    lowest = tuple(min(column) for column in zip(*exponents.values(), strict=True))
    exponents_from_lowest = {
        key: tuple(e - least for e, least in zip(own, lowest, strict=True))
        for key, own in exponents.items()
    }
    return Images([_image(ring, p, exponents_from_lowest, unit) for unit in units], lowest)


def _image(ring: Ring, p: Polynomial, exponents: Mapping[int, Monomial], unit: int) -> Poly:
    """Return a sum under one choice of ζ, in which i is ζ to the power of a quarter's parts."""
    image: Poly = {}
    for key, (re, im) in p.terms.items():
        constant, monomial = ring.constant(key), exponents[key]
        turned = re * _root(ring, unit * constant)
        turned += im * _root(ring, unit * (constant + ring.parts))
        image[monomial] = (image.get(monomial, 0) + turned) % PRIME
    return {monomial: value for monomial, value in image.items() if value}


def _root(ring: Ring, power: int) -> int:
    return pow(direction(ring.parts), power, PRIME)


def _cofactors(upper: Images, lower: Images) -> Cofactors | None:
    """Return both sums without their common divisor, with the exponents they really have."""
    above: list[Poly] = []
    below: list[Poly] = []
    for f, g in zip(upper.polys, lower.polys, strict=True):
        divisor = common(f, g)
        if len(divisor) == 1:
            return None
        above.append(_shifted(divided(f, divisor), upper.lowest))
        below.append(_shifted(divided(g, divisor), lower.lowest))
    return above, below


# ------------------------------------------------------------------------- real again


def _made_real(ring: Ring, cofactors: Cofactors, units: Sequence[int]) -> Cofactors | None:
    """Multiply both by the c·z^m that makes them real, if there is one in these angles.

    A sum is real if z → 1/z, i → -i leave it alone. The cofactors of real sums are left
    alone up to one factor, which is read off where the exponents end.
    """
    first = cofactors[0][0]
    end = max(first, key=lambda e: (e[ring.angles :], e))
    other_end = min(first, key=lambda e: (e[ring.angles :] != end[ring.angles :], e))
    sums = [a + b for a, b in zip(end[: ring.angles], other_end[: ring.angles], strict=True)]
    if any(s % 2 for s in sums):
        return None
    factors = _halved(ring, _ratios(ring, cofactors[0], (end, other_end), units), units)
    to_the_middle = (*(-s // 2 for s in sums), *(0 for _ in end[ring.angles :]))
    return tuple(
        [_shifted(f, to_the_middle, c) for f, c in zip(images, factors, strict=True)]
        for images in cofactors
    )


def _ratios(
    ring: Ring, images: Sequence[Poly], ends: tuple[Monomial, Monomial], units: Sequence[int]
) -> list[int]:
    """Return, image by image, the mirrored coefficient of one end over the other's."""
    end, other_end = ends
    order = 4 * ring.parts
    mirrored = (images[units.index(order - k)][other_end] for k in units)
    return [m * pow(f[end], -1, PRIME) % PRIME for m, f in zip(mirrored, images, strict=True)]


def _halved(ring: Ring, ratios: Sequence[int], units: Sequence[int]) -> list[int]:
    """Return the λ of each image with λ / conjugate(λ) = ratio, a root of unity if possible."""
    for power in range(2 * ring.parts):
        if _root(ring, 2 * power) == ratios[0]:
            return [_root(ring, unit * power) for unit in units]
    return [(1 + ratio) % PRIME for ratio in ratios]


def _shifted(f: Poly, shift: tuple[int, ...], factor: int = 1) -> Poly:
    return {tuple(map(int.__add__, e, shift)): v * factor % PRIME for e, v in f.items()}


# ---------------------------------------------------------------------- rational again


def _lifted(ring: Ring, images: list[Poly]) -> Polynomial:
    """Return the sum whose images these are."""
    basis = _basis(ring.parts)
    inverse = _interpolation(ring.parts)
    values: dict[int, tuple[Fraction, Fraction]] = {}
    for place in {e for image in images for e in image}:
        here = [image.get(place, 0) for image in images]
        found = [_rational(sum(map(int.__mul__, row, here)) % PRIME) for row in inverse]
        for i, at in enumerate(basis):
            values[ring.packed(place, at)] = found[2 * i], found[2 * i + 1]
    below = lcm(*(x.denominator for v in values.values() for x in v))
    terms = {k: (int(re * below), int(im * below)) for k, (re, im) in values.items() if re or im}
    return Polynomial(Fraction(1, below), terms)


@lru_cache(maxsize=64)
def _basis(parts: int) -> tuple[int, ...]:
    """Return the directions that occur in the unique form of sums."""
    return tuple(j for j in range(parts) if j in unique({j: (1, 0)}, parts))


@lru_cache(maxsize=64)
def _interpolation(parts: int) -> list[list[int]]:
    """Return the matrix that leads from the images of a sum of constants to the sum."""
    powers = [p for j in _basis(parts) for p in (j, j + parts)]
    root = direction(parts)
    return _inverse([[pow(root, k * p, PRIME) for p in powers] for k in conjugates(parts)])


def _inverse(matrix: list[list[int]]) -> list[list[int]]:
    """Return the inverse of a regular matrix of residues, by elimination."""
    size = len(matrix)
    rows = [[*row, *(int(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    for column in range(size):
        pivot = next(i for i in range(column, size) if rows[i][column])
        rows[column], rows[pivot] = rows[pivot], rows[column]
        scale = pow(rows[column][column], -1, PRIME)
        rows[column] = [v * scale % PRIME for v in rows[column]]
        for i in range(size):
            if i != column and (factor := rows[i][column]):
                pairs = zip(rows[i], rows[column], strict=True)
                rows[i] = [(v - factor * w) % PRIME for v, w in pairs]
    return [row[size:] for row in rows]


def _rational(residue: int) -> Fraction:
    """Return the rational number of small terms that a residue stands for."""
    bound = isqrt(PRIME // 2)
    a, b, s, t = PRIME, residue, 0, 1
    while b > bound:
        q = a // b
        a, b, s, t = b, a - q * b, t, s - q * t
    return Fraction(b, t)


def _is_proved(ring: Ring, whole: PolynomialQuotient, parts: PolynomialQuotient) -> bool:
    """Return whether the quotients are equal, multiplied out over one denominator."""
    (upper, lower), (above, below) = whole, parts
    left = ring.unique(ring.times(upper.terms, below.terms))
    right = ring.unique(ring.times(above.terms, lower.terms))
    ratio = Fraction(above.scale * lower.scale) / (upper.scale * below.scale)
    p, q = ratio.numerator, ratio.denominator
    return left.keys() == right.keys() and all(
        (v[0] * q, v[1] * q) == (right[k][0] * p, right[k][1] * p) for k, v in left.items()
    )
