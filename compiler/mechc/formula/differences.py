"""Sines of differences the way round in which a person writes them.

That is positive at the values given, and with the constants of the directions that they are of:
the angle between AB at psi and OA at delta − 67° is psi − delta + 67°, and no cosine of
delta − psi + 23° is made of its sine.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from .evaluate import SharedEvaluation
from .layout import has_minus, in_degrees
from .operations import count_operations
from .positive_divisors import (
    NO_SIGN,
    divisor,
    is_below,
    over_positive_differences,
    with_opposites,
)
from .rewriting import (
    FUNCTIONS_OF_ANGLES,
    Quarter,
    as_cofunction,
    by_opposite,
    in_reading_order,
    opposite_angle,
    rewritten,
    without_sign,
)
from .tree import (
    Call,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    degrees,
    is_call,
    negative,
    product,
    total,
)
from .walk import children, rebuild, walk

MOST_READ_OPERATIONS = 400
"""Formulas of more operations are read by machines alone."""


LazyValues = Callable[[], Mapping[str, float]]


def with_positive_sines(
    formula: Formula, values: LazyValues, quarter: Quarter | None = None, longer: int = 0
) -> Formula:
    """Write sin(a − b)/sin(c − b) as sin(b − a)/sin(b − c) where both are negative at the values.

    So are more of them, with a minus in front or in pairs; the formula's value is the same. A term
    of a sum that is negative by one such sine has a minus instead. A product with a minus and one
    such sine above the line is written without the minus. The ``values`` are asked for only where
    there are such sines. A sine or cosine of an angle that a ``quarter`` turns becomes the other
    one, if the formula grows no ``longer`` than by so many operations.

    >>> from .tree import Symbol, quotient
    >>> from .to_text import text
    >>> a, b, c = map(Symbol, "abc")
    >>> sines = [Call("sin", (total([one, negative(b)]),)) for one in (a, c)]
    >>> text(with_positive_sines(quotient(*sines), lambda: {"a": 0.1, "b": 0.5, "c": 0.3}))
    'sin(b - a)/sin(b - c)'
    >>> text(with_positive_sines(negative(sines[0]), lambda: {"a": 0.1, "b": 0.5}))
    'sin(b - a)'
    >>> text(with_positive_sines(negative(sines[0]), lambda: {"a": 0.5, "b": 0.1}))
    'sin(b - a)'
    >>> angle = total([a, negative(b), degrees(23)])
    >>> values = lambda: {"a": 0.1, "b": 0.5}
    >>> text(with_positive_sines(Call("cos", (angle,)), values, lambda angle: -90))
    'sin(b - a + 67*pi/180)'
    >>> whole = total([product([(b, 1), (sines[0], 1)]), c])
    >>> text(with_positive_sines(whole, lambda: {"a": 0.1, "b": 0.5, "c": 1.0}))
    'c - b*sin(b - a)'
    >>> below, values = product([(a, 1), (whole, -1)]), lambda: {"a": 0.1, "b": 2.0, "c": 1.0}
    >>> text(with_positive_sines(below, values))
    '-a/(b*sin(b - a) - c)'
    """
    if count_operations(formula) > MOST_READ_OPERATIONS:
        return formula
    positive = _positive(formula, values)
    turned = _with_cofunctions(formula, quarter) if quarter else formula
    if turned is formula or turned == formula:
        return positive
    found = _positive(turned, values)
    return found if _length(found) <= _length(positive) + longer else positive


def _length(formula: Formula) -> int:
    """Return how many operations a formula has outside its constants."""
    sizes = (degrees(abs(size)) for node in walk(formula) if (size := in_degrees(node)))
    return count_operations(formula) - sum(map(count_operations, sizes))


def _positive(formula: Formula, values: LazyValues) -> Formula:
    """Return a formula whose differences and divisors are the positive way round."""
    differences = [found for node in walk(formula) if (found := _difference(node))]
    divisors = [found for node in walk(formula) if (found := divisor(node))]
    if not differences and not divisors:
        return formula
    at = SharedEvaluation(values())
    behind = any(_is_negative_sine(d, at) for d in differences) or any(
        is_below(d, at) for d in divisors
    )
    return _sizes_as_beside(_without_minus(_sines_turned(formula, at) if behind else formula))


def _sizes_as_beside(formula: Formula) -> Formula:
    """Return a formula whose |sin(a − b)| have the way round that sines outside of them have."""
    if not any(is_call(node, "abs") for node in walk(formula)):
        return formula
    beside = [found for node in _outside_sizes(formula) if (found := _difference(node))]
    known = {frozenset(difference.terms): difference for difference in beside}

    def turned(whole: Formula) -> Formula | None:
        match whole:
            case Call("abs", (inner,)) if found := _difference_turned_as(inner, known):
                return Call("abs", (without_sign(found),))
        return None

    return rewritten(formula, turned) if known else formula


def _outside_sizes(formula: Formula) -> Iterator[Formula]:
    """Yield the parts of a formula, and it, that stand in no absolute value."""
    if not is_call(formula, "abs"):
        yield formula
        for part in children(formula):
            yield from _outside_sizes(part)


def _without_minus(formula: Formula) -> Formula:
    """Return a product with a minus and one sine of a difference with that turned instead.

    Below the line it stays as the ratios have it that the product is made of.
    """
    if not isinstance(formula, Product) or not has_minus(formula):
        return formula
    turned = {i: new for i, f in enumerate(formula.factors) if (new := _sine_turned(f))}
    if len(turned) != 1 or any(isinstance(formula.factors[i], Power) for i in turned):
        return formula
    return with_opposites(formula.factors, turned)


def zero_as_written(factor: Formula, values: LazyValues, quarter: Quarter | None) -> Formula:
    """Return a formula that is zero where a factor is, written as that is; its sign is free."""
    if not isinstance(factor, Sum):
        other = with_positive_sines(negative(factor), values, quarter)
        if not has_minus(other):
            return other
    return with_positive_sines(factor, values, quarter)


def _with_cofunctions(formula: Formula, quarter: Quarter) -> Formula:
    return rewritten(formula, lambda whole: as_cofunction(whole, quarter))


def differences_as_in(formula: Formula, *models: Formula) -> Formula:
    """Write functions of differences the way round in which other formulas have them.

    >>> from .tree import Symbol
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> one, other = total([a, negative(b)]), total([b, negative(a)])
    >>> slope = product([(Call("sin", (one,)), -2), (Call("cot", (one,)), 1)])
    >>> text(differences_as_in(slope, Call("sin", (other,))))
    '-cot(b - a)/sin(b - a)^2'
    """
    nodes = (node for model in models for node in walk(model))
    arguments = (node.arguments[0] for node in nodes if isinstance(node, Call))
    sums = (argument for argument in arguments if isinstance(argument, Sum))
    known = {frozenset(argument.terms): argument for argument in sums}
    return rewritten(formula, lambda whole: _difference_turned_as(whole, known))


def positive_sines(formulas: Iterable[Formula], values: LazyValues) -> list[Formula]:
    """Return the sines of differences in formulas that are positive at the values.

    There is none of what formulas have either way round.

    >>> from .tree import Symbol
    >>> a, b, c = map(Symbol, "abc")
    >>> one, two = (Call("sin", (total([x, negative(y)]),)) for x, y in ((a, b), (b, c)))
    >>> [found] = positive_sines([one, two], lambda: {"a": 1.0, "b": 0.5, "c": 0.7})
    >>> found == one
    True
    """
    sines = [node for formula in formulas for node in walk(formula)]
    found = [(sine, inside) for sine in sines if (inside := _difference(sine))]
    at = SharedEvaluation(values() if found else {})
    known = {frozenset(inside.terms) for _, inside in found}
    both = {terms for terms in known if frozenset(map(negative, terms)) in known}
    return [
        sine
        for sine, inside in found
        if frozenset(inside.terms) not in both and not _is_negative_sine(inside, at)
    ]


def terms_as_in(formula: Formula, *models: Formula) -> Formula:
    """Write the terms of a sum as :func:`factors_as_in` does."""
    if isinstance(formula, Sum):
        return total(factors_as_in(term, *models) for term in formula.terms)
    return factors_as_in(formula, *models)


def factors_as_in(formula: Formula, *models: Formula) -> Formula:
    """Write the factors of a product as :func:`differences_as_in` does, but for sums.

    >>> from .tree import Symbol
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> one, other = (Call("sin", (total([x, negative(y)]),)) for x, y in ((a, b), (b, a)))
    >>> text(factors_as_in(product([(one, 1), (total([a, one]), 1)]), other))
    '-sin(b - a)*(a + sin(a - b))'
    """
    match formula:
        case Product(factors):
            return product((factors_as_in(factor, *models), 1) for factor in factors)
        case Call() | Power(Call()):
            return differences_as_in(formula, *models)
        case _:
            return formula


def _difference_turned_as(
    formula: Formula, known: Mapping[frozenset[Formula], Sum]
) -> Formula | None:
    """Return a call of a difference the other way round, where that alone is ``known``."""
    match formula:
        case Call(function, (Sum(terms),)) if function in FUNCTIONS_OF_ANGLES:
            other = known.get(frozenset(map(negative, terms)))
            if other is not None and frozenset(terms) not in known:
                return by_opposite(function, other)
    return None


def _sines_turned(formula: Formula, at: SharedEvaluation) -> Formula:
    """Return a formula in which sines of negative differences are those of the opposite."""
    parts = tuple(_sines_turned(part, at) for part in children(formula))
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    match whole:
        case Product(factors):
            above = over_positive_differences(factors, at) or whole
            factors = above.factors if isinstance(above, Product) else factors
            return _turned_in_pairs(factors, at) or above
        case Sum(terms):
            return _terms_turned(terms, at) or whole
        case Power(base, Number(value) as exponent) if value.denominator == 1 and not value % 2:
            base = negative(base) if has_minus(base) else base
            return Power(_sine_turned(base, at) or base, exponent)
        case Call("abs", (inner,)) if turned := _sine_turned(inner, at):
            return Call("abs", (turned,))
        case _:
            return whole


def _terms_turned(terms: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a sum in which negative sines behind a plus are positive ones behind a minus.

    None where there are none, or nothing would be left without a minus to begin with.
    """
    turned = [_behind_minus(term, at) or term for term in terms]
    if turned == [*terms] or all(map(has_minus, turned)):
        return None
    return total(sorted(turned, key=has_minus) if has_minus(turned[0]) else turned)


def _behind_minus(term: Formula, at: SharedEvaluation) -> Formula | None:
    """Return a term that is negative by one sine of a difference with a minus; None for another."""
    if has_minus(term):
        return None
    factors = term.factors if isinstance(term, Product) else (term,)
    turned = {
        i: new
        for i, f in enumerate(factors)
        if not isinstance(f, Sum) and (new := _sine_turned(f, at))
    }
    if len(turned) != 1:
        return None
    return negative(product((turned.get(i, f), 1) for i, f in enumerate(factors)))


def _turned_in_pairs(factors: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a product with negative sines turned; None where an odd one would need a minus."""
    sign = -1 if has_minus(Product(tuple(factors))) else 1
    turned = {i: new for i, f in enumerate(factors) if (new := _sine_turned(f, at))}
    if len(turned) % 2 and sign > 0:
        turned = dict(list(turned.items())[:-1])
    if not turned:
        return None
    return with_opposites(factors, turned)


def _sine_turned(factor: Formula, at: SharedEvaluation | None = None) -> Formula | None:
    """Return an odd power of a sine of a difference with that turned round.

    None for another factor, and where the sine is not negative at the values, if these are given.
    """
    match factor:
        case Power(base, Number(value) as exponent) if value.denominator == 1 and value % 2:
            turned = _sine_turned(base, at)
            return Power(turned, exponent) if turned else None
        case Sum(terms):
            return None if at is None else _sum_turned(terms, at)
        case _ if difference := _difference(factor):
            if at is None or _is_negative_sine(difference, at):
                return Call("sin", (opposite_angle(difference),))
    return None


def _sum_turned(terms: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a sum turned round that is negative by a sine of a difference; None for another."""
    turned = [_without_minus(negative(term)) for term in terms]
    is_led = any(
        not has_minus(new) and (not has_minus(old) or _has_sine(new))
        for new, old in zip(turned, terms, strict=True)
    )
    try:
        return (
            total(in_reading_order(turned))
            if is_led and at.of(Sum(tuple(terms))) < -NO_SIGN
            else None
        )
    except KeyError:
        return None


def _has_sine(term: Formula) -> bool:
    """Return whether a factor of a term is the sine of a difference."""
    factors = term.factors if isinstance(term, Product) else (term,)
    return any(map(_sine_turned, factors))


def _is_negative_sine(difference: Sum, at: SharedEvaluation) -> bool:
    """Return whether the sine of a difference is negative; False where it has no value."""
    try:
        return math.sin(at.of(difference)) < -NO_SIGN
    except KeyError:
        return False


def _difference(formula: Formula) -> Sum | None:
    """Return the difference that a sine is taken of."""
    match formula:
        case Call("sin", (Sum(terms) as inside,)) if any(map(has_minus, terms)):
            return inside
    return None
