"""Sums of products in canonical form.

>>> from ..formula.to_text import text
>>> from .angle import Angle
>>> from .trigonometry import sine, cosine
>>> a, b = Angle.of("alpha"), Angle.of("beta")
>>> tan_a, tan_b = sine(a) / cosine(a), sine(b) / cosine(b)
>>> text(add([tan_a, tan_b]).formula())
'sin(alpha + beta)/(cos(alpha)*cos(beta))'
"""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import reduce
from operator import or_

from ..formula.operations import count_operations
from ..formula.tree import Formula
from ..formula.tree import Symbol as SymbolFormula
from ..formula.walk import symbols
from ..work import spend
from . import factoring, laurent, pairing
from .angle import Rational, rational
from .cancelling import MOST_MULTIPLIED_TERMS, canonical
from .factors import ConstantSymbol, Factor, Length
from .modular import ModularPoint
from .product import ZERO, Product, Sum


class BoundSum:
    """A sum bound to a name, so that what is built on it stays small.

    It counts as a symbol; numeric values of the name are put into ``values`` by whoever
    evaluates, in the order in which the names were bound.
    """

    __slots__ = ("_residues", "definition", "name")

    def __init__(self, name: str, definition: Product) -> None:
        self.name, self.definition = name, definition
        self._residues: dict[int, int] = {}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, BoundSum) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return f"Bound({self.name!r})"

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value bound to the name."""
        return values[self.name]

    def residue(self, point: ModularPoint) -> int:
        """Return the residue of the definition, computed once for each random point."""
        if point.seed not in self._residues:
            self._residues[point.seed] = self.definition.residue(point)
        return self._residues[point.seed]

    def formula(self) -> Formula:
        """Return the name."""
        return SymbolFormula(self.name)

    def order(self) -> tuple[int, str]:
        """Return the place in reading order."""
        return (2, self.name)


__all__ = ["MOST_MULTIPLIED_TERMS", "add", "canonical", "is_long", "put", "readable", "shortest"]


def add(products: Iterable[Product]) -> Product:
    """Return the sum of products, factored, its common factors cancelled.

    Canonical while the sum has at most :data:`MOST_MULTIPLIED_TERMS` terms when multiplied out;
    beyond that it is kept as written (equality is then tested, not structural).
    """
    terms = [p for p in products if p]
    spend(sum(1 + len(t.factors) for t in terms))
    if len(terms) > 1:
        terms = _merged(terms)
    if len(terms) <= 1:
        return canonical(terms[0]) if terms else ZERO
    common = _common(terms)
    rests = [t / common for t in terms]
    has_constants = any(map(_has_constants, terms))
    if has_constants and _vanishes(rests):
        return ZERO
    if sum(map(laurent.size, rests)) <= MOST_MULTIPLIED_TERMS and not any(
        map(_rests_on_names, rests)
    ):
        whole = canonical(common * factoring.factored(rests))
        return _without_equal_numbers(whole) if has_constants else whole
    if _vanishes(rests):
        return ZERO
    for deep in (True, False):
        if sum(laurent.size(r, deep) for r in rests) <= MOST_MULTIPLIED_TERMS:
            return canonical(common * factoring.factored(rests, deep))
    return _kept(terms)


def shortest(products: Iterable[Product], whole: Product | None = None) -> Product:
    """Return the sum of products multiplied out, or as it stands where that is shorter.

    ``whole`` is the sum multiplied out, where it is known.
    """
    terms = _merged(p for p in products if p)
    whole = add(terms) if whole is None else whole
    return _shortest(whole, [_kept(terms)]) if len(terms) > 1 and is_long(whole) else whole


def readable(whole: Product, others: Iterable[Product]) -> Product:
    """Return a product as it is read: its sums multiplied out, in pairs of sines, or as others."""
    if not is_long(whole):
        return whole
    return _shortest(whole, [*others, _with_sums(whole, pairing.paired)])


def _with_sums(product: Product, written: Callable[[Sum], Product]) -> Product:
    """Return a product with its sums written in another way."""
    result = Product(product.coefficient)
    for factor, exponent in product.factors.items():
        part = written(factor) if isinstance(factor, Sum) else Product.of(factor)
        result = result * part**exponent
    return result


def is_long(whole: Product) -> bool:
    """Return whether a sum in a product has more than two terms."""
    return any(isinstance(f, Sum) and len(f.terms) > 2 for f in whole.factors)


def _shortest(whole: Product, others: Iterable[Product]) -> Product:
    """Return the expanded form, or the shortest of the others if that is shorter.

    Another form is divided by nothing that cancels when it is multiplied out: it has a value
    wherever that has one. Nor does it mention what cancels.
    """
    found, formula, divisors = whole, whole.formula(), _divisors(whole)
    names, length = symbols(formula), count_operations(formula)
    for form in others:
        written = form.formula()
        is_safe = symbols(written) <= names and _divisors(form) <= divisors
        if is_safe and (shorter := count_operations(written)) < length:
            found, length = form, shorter
    return found


def _divisors(product: Product) -> Counter[Factor]:
    """Return the sines and sums that a product is divided by, also inside its sums."""
    found = Counter[Factor]()
    for factor, exponent in product.factors.items():
        if exponent < 0:
            found += _factors(factor, -exponent)
    inner = [_divisors(t) for f in product.factors if isinstance(f, Sum) for t in f.terms]
    return found + reduce(or_, inner, Counter[Factor]())


def _factors(factor: Factor, exponent: int) -> Counter[Factor]:
    """Return the factors that an expanded power has above the line, without lengths."""
    whole = add(factor.terms) if isinstance(factor, Sum) else Product.of(factor)
    parts = ((f, e * exponent) for f, e in whole.factors.items() if not isinstance(f, Length))
    return Counter({f: e for f, e in parts if e > 0})


def put(product: Product, values: Mapping[str, Product]) -> Product:
    """Return a product with symbols that stand outside angles replaced by products.

    >>> from ..formula.to_text import text
    >>> from .angle import Angle
    >>> from .trigonometry import cosine
    >>> a, g, s = map(Product.symbol, "ags")
    >>> text(put(add([s, a]), {"s": g / cosine(Angle.of("phi"))}).formula())
    'a + g/cos(phi)'
    """
    result = Product(product.coefficient)
    for factor, exponent in product.factors.items():
        match factor:
            case Length(name) if name in values:
                part = values[name]
            case Sum(terms=terms):
                part = add(put(term, values) for term in terms)
            case _:
                part = Product.of(factor)
        result = result * part**exponent
    return result


def _rests_on_names(product: Product) -> bool:
    """Return whether a product has a bound sum in it, about which the name says nothing."""
    return any(
        isinstance(f, BoundSum) or (isinstance(f, Sum) and any(map(_rests_on_names, f.terms)))
        for f in product.factors
    )


def _has_constants(product: Product) -> bool:
    """Return whether a product has a named number in it, which may cancel another one."""
    return any(
        isinstance(f, ConstantSymbol) or (isinstance(f, Sum) and any(map(_has_constants, f.terms)))
        for f in product.factors
    )


def _without_equal_numbers(product: Product) -> Product:
    """Return a product whose sums have no terms that cancel by what their named numbers are.

    So do those of opposite sides of a parallelogram: ``b*sin(beta) - d*sin(beta) + a`` is ``a``.
    """
    for factor, exponent in product.factors.items():
        if isinstance(factor, Sum):
            terms = _without_cancelled(factor.terms)
            if len(terms) < len(factor.terms) and (terms or exponent > 0):
                rest = product * Product(1, {factor: -exponent})
                return _without_equal_numbers(rest * add(terms) ** exponent)
    return product


def _without_cancelled(terms: Sequence[Product]) -> list[Product]:
    """Return the terms of a sum without those that differ by named numbers and come to zero."""
    groups: dict[Product, list[Product]] = {}
    for term in terms:
        groups.setdefault(term / _number_in(term), []).append(term)
    return [
        term
        for common, group in groups.items()
        if len(group) == 1 or not _vanishes([term / common for term in group])
        for term in group
    ]


def _number_in(term: Product) -> Product:
    """Return the coefficient of a term times the named numbers above its line."""
    numbers: dict[Factor, int] = {
        f: e for f, e in term.factors.items() if isinstance(f, ConstantSymbol) and e > 0
    }
    return Product(term.coefficient, numbers)


def _vanishes(terms: Sequence[Product]) -> bool:
    """Return whether a sum that is not multiplied out vanishes at a random point."""
    point = ModularPoint()
    return sum(t.residue(point) for t in terms) % point.prime == 0


def _merged(products: Iterable[Product]) -> list[Product]:
    """Add up products that differ in their coefficient only."""
    sums: dict[Product, Rational] = {}
    for p in products:
        monomial = Product(1, p.factors)
        sums[monomial] = rational(sums.get(monomial, 0) + p.coefficient)
    return [monomial.scaled(c) for monomial, c in sums.items() if c]


def _common(terms: Sequence[Product]) -> Product:
    """Return the lowest power of each factor over all terms (0 where it is absent)."""
    factors = dict.fromkeys(f for t in terms for f in t.factors)
    lowest = {f: min(t.factors.get(f, 0) for t in terms) for f in factors}
    return Product(1, {f: e for f, e in lowest.items() if e})


def _shared(terms: Sequence[Product]) -> Product:
    """Return the factors that all terms have above the line, or all below it."""
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
