"""Sums that something is divided by, and factors next to them, the way round that is positive.

M/(a - b) is -M/(b - a) where a is smaller.
"""

from collections.abc import Mapping, Sequence

from .evaluate import SharedEvaluation
from .layout import has_minus
from .rewriting import in_reading_order, rewritten
from .tree import Call, Formula, Number, Power, Product, Sum, negative, number, product, total

NO_SIGN = 1e-9
"""A sine or a sum that is smaller is 0 but for rounding, and has no sign."""


def arcs_of_positive_divisors(formula: Formula, values: Mapping[str, float]) -> Formula:
    """Return −atan(a/(b − 1)) as atan(a/(1 − b)) where b − 1 is negative at the values.

    >>> from .tree import ONE, Symbol, quotient
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> bound = negative(Call("atan", (quotient(a, total([b, negative(ONE)])),)))
    >>> text(arcs_of_positive_divisors(bound, {"a": 0.1, "b": 0.2}))
    'atan(a/(1 - b))'
    """
    at = SharedEvaluation(values)

    def turned(whole: Formula) -> Formula | None:
        match whole:
            case Call("asin" | "atan" as function, (Product(factors),)):
                below = [i for i, f in enumerate(factors) if _is_below_zero(f, at)]
                inner = with_opposites(factors, {i: _opposite(factors[i]) for i in below})
                if has_minus(inner):
                    return negative(Call(function, (negative(inner),)))
                return Call(function, (inner,))
        return None

    return rewritten(formula, turned)


def _is_below_zero(factor: Formula, at: SharedEvaluation) -> bool:
    """Return whether a factor is a sum, or one over it, that is negative at the values."""
    match factor:
        case Power(Sum() as base, Number(value)) if value == -1:
            return is_below(base, at)
    return isinstance(factor, Sum) and is_below(factor, at)


def over_positive_differences(factors: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a product divided by positive differences, a minus before it if need be.

    M/(a − b) is −M/(b − a) where a is smaller; what is negative above the line is turned, too.
    None where no difference below the line is negative.
    """
    below = [i for i, f in enumerate(factors) if (d := divisor(f)) and is_below(d, at)]
    if not below:
        return None
    above = [i for i, f in enumerate(factors) if _is_mixed(f) and is_below(f, at)]
    turned = {i: _opposite(factors[i]) for i in (*below, *above)}
    return with_opposites(factors, turned)


def with_opposites(factors: Sequence[Formula], opposites: Mapping[int, Formula]) -> Formula:
    """Return a product with the opposites of some factors in their places, and their sign."""
    parts = [(opposites.get(i, factor), 1) for i, factor in enumerate(factors)]
    return product([(number((-1) ** len(opposites)), 1), *parts])


def _opposite(factor: Formula) -> Formula:
    """Return an odd power of a sum with all terms of the other sign."""
    if isinstance(factor, Power):
        return Power(_opposite(factor.base), factor.exponent)
    assert isinstance(factor, Sum)
    return total(in_reading_order(map(negative, factor.terms)))


def divisor(formula: Formula) -> Sum | None:
    """Return the difference that something is divided by, once or an odd number of times."""
    match formula:
        case Power(Sum() as base, Number(value)) if value < 0 and value % 2 == 1:
            return base if _is_mixed(base) else None
    return None


def _is_mixed(formula: Formula) -> bool:
    """Return whether something is a sum of terms of which some have a minus, not all."""
    signs = set(map(has_minus, formula.terms)) if isinstance(formula, Sum) else set()
    return len(signs) == 2


def is_below(formula: Formula, at: SharedEvaluation) -> bool:
    """Return whether a sum is negative; False where it has no value."""
    assert isinstance(formula, Sum)
    try:
        sizes = [at.of(term) for term in formula.terms]
    except KeyError:
        return False
    return sum(sizes) < -NO_SIGN * max(map(abs, sizes))
