"""Factored products: a coefficient and a map factor → integer exponent.

A factor is a length (or any other symbol), a sine or cosine of an angle, a canonical
sum, or something opaque. Products are multiplied and divided, never added here:
``sums.add`` does that.
"""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ..formula.operations import count_operations
from ..formula.tree import Call, Formula, number, product, total
from .angle import Rational, rational
from .factors import Factor, FactorRank, Length, Trig
from .modular import ModularPoint


class Product:
    """``coefficient · Π factor ** exponent``; immutable.

    >>> from .angle import Angle
    >>> from .trigonometry import cosine, sine
    >>> a, b = Product.symbol("a"), Product.symbol("b")
    >>> k = a / b * sine(Angle.of("alpha")) / cosine(Angle.of("alpha"))
    >>> from ..formula.to_text import text
    >>> text(k.formula())
    'a*tan(alpha)/b'
    """

    __slots__ = ("coefficient", "factors", "is_canonical")

    def __init__(
        self, coefficient: Rational = 1, factors: Mapping[Factor, int] | None = None
    ) -> None:
        self.coefficient = coefficient
        self.factors: Mapping[Factor, int] = factors if factors and coefficient else {}
        self.is_canonical = False
        """Whether it is known that nothing cancels, whatever the coefficient."""

    @staticmethod
    def symbol(name: str) -> "Product":
        """Return the product that is one symbol."""
        return Product(1, {Length(name): 1})

    @staticmethod
    def of(factor: Factor, exponent: int = 1) -> "Product":
        """Return one factor as a product."""
        return Product(1, {factor: exponent})

    def __mul__(self, other: "Product") -> "Product":
        """Return the product of both, equal factors joined."""
        if not other.factors:
            return self.scaled(other.coefficient)
        if not self.factors:
            return other.scaled(self.coefficient)
        factors = dict(self.factors)
        for factor, exponent in other.factors.items():
            left = factors.get(factor, 0) + exponent
            if left:
                factors[factor] = left
            else:
                del factors[factor]
        return Product(rational(self.coefficient * other.coefficient), factors)

    def __pow__(self, exponent: int) -> "Product":
        powers = {f: e * exponent for f, e in self.factors.items()} if exponent else {}
        return Product(rational(Fraction(self.coefficient) ** exponent), powers)

    def __truediv__(self, other: "Product") -> "Product":
        return self * other**-1

    def __neg__(self) -> "Product":
        return self.scaled(-1)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Product):
            return NotImplemented
        return self.coefficient == other.coefficient and self.factors == other.factors

    def __hash__(self) -> int:
        return hash((self.coefficient, frozenset(self.factors.items())))

    def __bool__(self) -> bool:
        return self.coefficient != 0

    def __repr__(self) -> str:
        return f"Product({self.coefficient}, {dict(self.factors)!r})"

    def written(self) -> "WrittenProduct":
        """Return coefficient and factors in their order, in which equal products may differ."""
        return self.coefficient, tuple(self.factors.items())

    def root(self) -> "Product | None":
        """Return the square root but for its sign, None where this is no square.

        >>> a = Product.symbol("a")
        >>> (a * a).scaled(4).root() == a.scaled(2), a.root() is None
        (True, True)
        """
        square = Fraction(self.coefficient)
        if square < 0 or any(exponent % 2 for exponent in self.factors.values()):
            return None
        size = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
        factors = {factor: exponent // 2 for factor, exponent in self.factors.items()}
        return Product(size, factors) if size * size == square else None

    def scaled(self, factor: Rational) -> "Product":
        """Return the product times a rational number."""
        if factor == 1:
            return self
        scaled = Product(rational(self.coefficient * factor), self.factors)
        scaled.is_canonical = self.is_canonical
        return scaled

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value on floats (may raise ZeroDivisionError at a pole)."""
        result = float(self.coefficient)
        for factor, exponent in self.factors.items():
            if not -_HIGH <= exponent <= _HIGH:
                return self._evaluated_in_ratios(values)
            result *= factor.evaluate(values) ** exponent
        return result

    def _evaluated_in_ratios(self, values: Mapping[str, float]) -> float:
        """Return the value where a high power may be too large, or too small, by itself."""
        result = float(self.coefficient)
        ratio, power, rest = _high_power(self.factors)
        for factor, exponent in rest.items():
            result *= factor.evaluate(values) ** exponent
        return result * Product(1, ratio).evaluate(values) ** power if ratio else result

    def residue(self, point: ModularPoint) -> int:
        """Return the value at a random point of a finite field."""
        result = point.rational(self.coefficient)
        for factor, exponent in self.factors.items():
            result = result * point.power(factor.residue(point), exponent) % point.prime
        return result

    def formula(self) -> Formula:
        """Return the product as a reader writes it: coefficient, lengths, trig, sums."""
        others = [_written(p) for p in _divided_through(self)]
        return min(_written(self), *others, key=count_operations) if others else _written(self)


ONE, ZERO = Product(1), Product(0)

WrittenProduct = tuple[Rational, tuple[tuple[Factor, int], ...]]
"""What a product is made of, in order."""


def as_product(written: WrittenProduct) -> Product:
    """Return the product that is made of factors in an order."""
    return Product(written[0], dict(written[1]))


class Sum:
    """A canonical sum as a factor: two or more terms in reading order, the first positive.

    Made by ``sums.add`` only, which takes out whatever is common to the terms.
    """

    __slots__ = ("_formula", "_hash", "_text", "terms", "weight")

    def __init__(self, terms: tuple[Product, ...]) -> None:
        self.terms = terms
        self.weight = sum(map(weight, terms))
        """How many terms there are, those of inner sums included."""
        self._hash = hash(terms)
        self._formula: Formula | None = None
        self._text = ""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sum) and self._hash == other._hash and self.terms == other.terms

    def __hash__(self) -> int:
        return self._hash

    def __repr__(self) -> str:
        return f"Sum({self.text})"

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value on floats."""
        return math.fsum(t.evaluate(values) for t in self.terms)

    def residue(self, point: ModularPoint) -> int:
        """Return the value at a random point of a finite field."""
        return sum(t.residue(point) for t in self.terms) % point.prime

    def formula(self) -> Formula:
        """Return the sum as a formula."""
        if self._formula is None:
            self._formula = _square(self.terms) or total(_gathered(self.terms))
        return self._formula

    @property
    def text(self) -> str:
        """Return the terms in full, which take long to write where sums are nested."""
        if not self._text:
            self._text = repr(self.terms)
        return self._text

    def order(self) -> tuple[int, "_Text"]:
        """Return the place in reading order: by the terms in full, where there are two sums."""
        return (3, _Text(self))


class _Text:
    """The terms of a sum in full, not written before they are compared."""

    __slots__ = ("_of",)

    def __init__(self, of: Sum) -> None:
        self._of = of

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Text) and self._of.text == other._of.text

    def __lt__(self, other: "_Text") -> bool:
        return self._of.text < other._of.text


def weight(term: Product) -> int:
    """Return how many terms a product has, those of sums in it included."""
    return 1 + sum(f.weight for f in term.factors if isinstance(f, Sum))


_HIGH = 16
"""Powers beyond this are taken of a ratio: r^200/R^200 is 0/0 in doubles, (r/R)^200 is not."""

_FEW = 3
"""Sums of so many terms are short enough to be divided through."""


def _written(value: Product) -> Formula:
    coefficient, factors = _without_minus(value)
    ratio, power, factors = _high_power(factors)
    ordered = sorted(_with_tangents(factors), key=lambda fe: fe[0])
    high = [(_written(Product(1, ratio)), power)] if ratio else []
    plain = (_exponential(f, e) for _, f, e in ordered)
    return product([*([(number(coefficient), 1)] if coefficient != 1 else []), *plain, *high])


def _exponential(formula: Formula, exponent: int) -> tuple[Formula, int]:
    """Return a power as it is written: e^(−x) rather than 1/e^x, e^(2x) rather than (e^x)²."""
    match formula:
        case Call("exp", (argument,)) if exponent != 1:
            return Call("exp", (product([(number(exponent), 1), (argument, 1)]),)), 1
        case _:
            return formula, exponent


def _high_power(
    factors: Mapping[Factor, int],
) -> tuple[Mapping[Factor, int], int, Mapping[Factor, int]]:
    """Return a ratio, the high power in which it is a part of a product, and what is left."""
    high = {f: e for f, e in factors.items() if abs(e) > _HIGH}
    if not high or min(high.values()) > 0 or max(high.values()) < 0:
        return {}, 0, factors
    power = min(map(abs, high.values()))
    ratio = {f: (abs(e) // power) * (1 if e > 0 else -1) for f, e in high.items()}
    left = {f: e - power * ratio.get(f, 0) for f, e in factors.items()}
    return ratio, power, {f: e for f, e in left.items() if e}


def _divided_through(value: Product) -> Iterator[Product]:
    """Yield a product with what one term of a sum shares with the divisor divided through.

    (x·y + z)/(x·w) is (y + z/x)/w.
    """
    below = {f: -e for f, e in value.factors.items() if e < 0}
    for factor, exponent in value.factors.items():
        if isinstance(factor, Sum) and exponent == 1 and len(factor.terms) <= _FEW:
            for term in factor.terms:
                common = {f: min(e, below[f]) for f, e in term.factors.items() if f in below}
                if common and min(common.values()) > 0:
                    shared = Product(1, common)
                    through = Sum(tuple(t / shared for t in factor.terms))
                    yield value * shared * Product(1, {factor: -1, through: 1})


def _square(terms: Sequence[Product]) -> Formula | None:
    """Return the square of a sum that three terms make, as it is written; None where they do not.

    >>> from ..formula.to_text import text
    >>> c = Product.symbol("c")
    >>> text(_square([c * c, c.scaled(-2), Product()])), _square([c * c, c, Product()])
    ('(1 - c)^2', None)
    """
    for middle in terms if len(terms) == _FEW else ():
        roots = [term.root() for term in terms if term is not middle]
        found = sorted(filter(None, roots), key=lambda root: bool(root.factors))
        if len(found) < len(roots):
            continue
        one, other = found
        twice = (one * other).scaled(2)
        if middle in (twice, -twice):
            inner = total([one.formula(), (other if middle == twice else -other).formula()])
            return product([(inner, 2)])
    return None


def _gathered(terms: Sequence[Product]) -> Iterator[Formula]:
    """Yield a sum's terms, the factor that most of them have taken out of these, and so on."""
    counts = Counter(f for t in terms for f, e in t.factors.items() if e > 0)
    most = max(counts.values(), default=0)
    if most < 2:
        yield from (t.formula() for t in terms)
        return
    factor = min((f for f, n in counts.items() if n == most), key=lambda f: f.order())
    having = [t for t in terms if t.factors.get(factor, 0) > 0]
    shared = _shared(having)
    inside = Sum(tuple(t / shared for t in having))
    yield (shared * Product.of(inside)).formula()
    yield from _gathered([t for t in terms if t.factors.get(factor, 0) <= 0])


def _shared(terms: Sequence[Product]) -> Product:
    """Return the greatest common factor of terms, with the sign of the first."""
    sizes = [Fraction(t.coefficient) for t in terms]
    above = math.gcd(*(size.numerator for size in sizes))
    below = math.lcm(*(size.denominator for size in sizes))
    first, *others = (t.factors for t in terms)
    common = {f: min(e, *(o.get(f, 0) for o in others)) for f, e in first.items()}
    size = Fraction(above if sizes[0] > 0 else -above, below)
    return Product(rational(size), {f: e for f, e in common.items() if e > 0})


def _without_minus(product: Product) -> tuple[Rational, Mapping[Factor, int]]:
    """Let a minus sign turn a difference round: −sin(a − b) is read as sin(b − a)."""
    if product.coefficient < 0:
        above_first = sorted(product.factors.items(), key=lambda fe: (fe[1] < 0, fe[0].order()))
        for factor, exponent in above_first:
            turned = _turned(factor) if exponent % 2 else None
            if turned is not None:
                factors = {turned if f == factor else f: e for f, e in product.factors.items()}
                return -product.coefficient, factors
    return product.coefficient, product.factors


def _turned(factor: Factor) -> Factor | None:
    """Return the negative of a factor where that is no longer to read."""
    match factor:
        case Trig("sin", angle) if any(c < 0 for _, c in angle.terms):
            return Trig("sin", -angle)
        case Sum(terms=terms) if any(t.coefficient < 0 for t in terms) and not _square(terms):
            return Sum(tuple(sorted((-t for t in terms), key=lambda t: t.coefficient < 0)))
    return None


def _with_tangents(
    factors: Mapping[Factor, int],
) -> Iterable[tuple[FactorRank, Formula, int]]:
    """Yield (place, formula, exponent), a sine over its own cosine being a tangent."""
    left = dict(factors)
    cosines = {f.angle: f for f in factors if isinstance(f, Trig) and f.function == "cos"}
    for factor in factors if cosines else ():
        if not (isinstance(factor, Trig) and factor.function == "sin" and factor.angle in cosines):
            continue
        twin = cosines[factor.angle]
        s, c = left[factor], left[twin]
        if s * c >= 0:
            continue
        common = min(abs(s), abs(c))
        name = "tan" if s > 0 else "cot"
        yield factor.order(), Call(name, (factor.angle.formula(),)), common
        left[factor] -= common if s > 0 else -common
        left[twin] -= common if c > 0 else -common
    for factor, exponent in left.items():
        if exponent:
            yield factor.order(), factor.formula(), exponent
