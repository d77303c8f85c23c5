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
    number,
    product,
    total,
)
from .walk import children, rebuild, walk

NO_SIGN = 1e-9
"""A sine that is smaller is 0 but for rounding, and has no sign."""

MOST_READ_OPERATIONS = 400
"""Formulas of more operations are read by machines alone."""


LazyValues = Callable[[], Mapping[str, float]]


Quarter = Callable[[Formula], int]
"""By how many degrees an angle is to be turned to be one that a person knows: 90, −90 or 0."""


def with_positive_sines(
    formula: Formula, values: LazyValues, quarter: Quarter | None = None, longer: int = 0
) -> Formula:
    """Write sin(a − b)/sin(c − b) as sin(b − a)/sin(b − c) where both are negative at the values.

    So are more of them, with a minus in front or in pairs; the formula's value is the same. A
    product with a minus and one such sine above the line is written without the minus. The
    ``values`` are asked for only where there are such sines. A sine or cosine of an angle that a
    ``quarter`` turns becomes the other one, if the formula grows no ``longer`` than by so many
    operations.

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
    differences = [found for node in walk(formula) if (found := _difference(node))]
    divisors = [found for node in walk(formula) if (found := _divisor(node))]
    if not differences and not divisors:
        return formula
    at = SharedEvaluation(values())
    behind = any(_is_negative_sine(d, at) for d in differences) or any(
        _is_below(d, at) for d in divisors
    )
    return _sizes_as_beside(_without_minus(_sines_turned(formula, at) if behind else formula))


def _sizes_as_beside(formula: Formula) -> Formula:
    """Return a formula whose |sin(a − b)| have the way round in which sines beside them stand."""
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
    factors = (turned.get(i, factor) for i, factor in enumerate(formula.factors))
    return product([(number(-1), 1), *((factor, 1) for factor in factors)])


def zero_as_written(factor: Formula, values: LazyValues, quarter: Quarter | None) -> Formula:
    """Return a formula that is zero where a factor is, written as that is; its sign is free."""
    if not isinstance(factor, Sum):
        other = with_positive_sines(negative(factor), values, quarter)
        if not has_minus(other):
            return other
    return with_positive_sines(factor, values, quarter)


def plus_first(formula: Formula) -> Formula:
    """Return a formula in whose sums a term without a minus leads; what is squared has none.

    A component of which all terms have a minus has one before it.

    >>> from .tree import Symbol
    >>> from .to_text import text
    >>> text(plus_first(total([negative(Symbol("a")), Symbol("b")])))
    'b - a'
    >>> text(plus_first(Power(negative(Symbol("a")), number(2))))
    'a^2'
    >>> both = Sum((negative(Symbol("a")), negative(Symbol("b"))))
    >>> text(plus_first(Call("hypot", (both, both))))
    'hypot(a + b, a + b)'
    >>> text(plus_first(Call("atan2", (both, Symbol("c")))))
    'atan2(-(a + b), c)'
    """
    parts = tuple(map(plus_first, children(formula)))
    if isinstance(formula, Call) and formula.function in ("hypot", "atan2"):
        is_even = formula.function == "hypot"
        parts = tuple(_after_minus(part, is_even) for part in parts)
    if isinstance(formula, Power) and _is_even(formula.exponent) and has_minus(parts[0]):
        return Power(negative(parts[0]), formula.exponent)
    if isinstance(formula, Sum) and has_minus(parts[0]):
        lead = next((i for i, part in enumerate(parts) if not has_minus(part)), 0)
        return total([parts[lead], *parts[:lead], *parts[lead + 1 :]])
    return rebuild(formula, parts) if parts != children(formula) else formula


def _after_minus(formula: Formula, is_even: bool) -> Formula:
    """Return a sum with its minuses before it, if it has nothing else, or without where even."""
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    if not all(map(has_minus, terms)):
        return formula
    return negative(formula) if is_even else product([(number(-1), 1), (negative(formula), 1)])


def _is_even(exponent: Formula) -> bool:
    return isinstance(exponent, Number) and exponent.value % 2 == 0


def _with_cofunctions(formula: Formula, quarter: Quarter) -> Formula:
    return rewritten(formula, lambda whole: as_cofunction(whole, quarter))


def rewritten(formula: Formula, turned: Callable[[Formula], Formula | None]) -> Formula:
    """Return a formula with what is turned in place of its parts, their signs put together."""
    parts = tuple(rewritten(part, turned) for part in children(formula))
    if isinstance(formula, Power) and isinstance(formula.exponent, Number):
        sign, base = _without_sign(parts[0])
        if sign < 0 and formula.exponent.value.denominator == 1:
            times = sign**formula.exponent.value.numerator
            return product([(number(int(times)), 1), (Power(base, formula.exponent), 1)])
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    return turned(whole) or whole


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


_ODD, _EVEN = frozenset({"sin", "tan", "cot", "csc"}), frozenset({"cos", "sec"})


def _difference_turned_as(
    formula: Formula, known: Mapping[frozenset[Formula], Sum]
) -> Formula | None:
    match formula:
        case Call(function, (Sum(terms),)) if function in _ODD | _EVEN:
            other = known.get(frozenset(map(negative, terms)))
            if other is None or frozenset(terms) in known:
                return None
            turned = Call(function, (other,))
            return negative(turned) if function in _ODD else turned
    return None


def without_sign(formula: Formula) -> Formula:
    """Return a function without the minus before it.

    >>> without_sign(negative(Call("sin", (number(1),)))) == Call("sin", (number(1),))
    True
    """
    return _without_sign(formula)[1]


def _without_sign(formula: Formula) -> tuple[int, Formula]:
    match formula:
        case Product((Number(value), Call() as call)) if value == -1:
            return -1, call
    return 1, formula


def as_cofunction(formula: Formula, quarter: Quarter) -> Formula | None:
    """Return a sine as a cosine, or the other way round, of its angle turned by a quarter.

    None where it is not to be turned, and for what is neither.

    >>> from .to_text import text
    >>> text(as_cofunction(Call("cos", (degrees(35),)), lambda angle: -90))
    'sin(11*pi/36)'
    """
    match formula:
        case Call("sin" | "cos" as function, (angle,)) if turn := quarter(angle):
            # cos x = sin(x + 90°), sin x = −cos(x + 90°)
            sign = (1 if function == "cos" else -1) * (1 if turn > 0 else -1)
            other = "sin" if function == "cos" else "cos"
            turned = _plus(angle, turn)
            if _is_opposite(turned, other):
                turned, sign = _negated(turned), sign * (1 if other == "cos" else -1)
            return product([(number(sign), 1), (Call(other, (turned,)), 1)])
    return None


def _is_opposite(angle: Formula, function: str) -> bool:
    """Return whether a function is written of an angle's negative: a constant's, or a cosine's."""
    if isinstance(angle, Sum):
        return function == "cos" and has_minus(angle.terms[0])
    return bool(in_degrees(angle)) and has_minus(angle)


def _negated(angle: Formula) -> Formula:
    if isinstance(angle, Sum):
        return total(_in_reading_order(map(negative, angle.terms)))
    return negative(angle)


def _plus(angle: Formula, turn: int) -> Formula:
    """Return an angle with degrees added to its constant, which comes last."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    others = [term for term in terms if in_degrees(term) is None]
    constant = sum(size for term in terms if (size := in_degrees(term)) is not None)
    return total([*others, degrees(constant + turn)])


def _sines_turned(formula: Formula, at: SharedEvaluation) -> Formula:
    parts = tuple(_sines_turned(part, at) for part in children(formula))
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    match whole:
        case Product(factors):
            above = _over_positive(factors, at) or whole
            factors = above.factors if isinstance(above, Product) else factors
            return _turned_in_pairs(factors, at) or above
        case Power(base, Number(value) as exponent) if value.denominator == 1 and not value % 2:
            return Power(negative(base), exponent) if has_minus(base) else whole
        case Call("abs", (inner,)) if turned := _sine_turned(inner, at):
            return Call("abs", (turned,))
        case _:
            return whole


def _over_positive(factors: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a product divided by positive differences, a minus before it if need be.

    M/(a − b) is −M/(b − a) where a is smaller; what is negative above the line is turned, too.
    None where no difference below the line is negative.
    """
    below = [i for i, f in enumerate(factors) if (d := _divisor(f)) and _is_below(d, at)]
    if not below:
        return None
    above = [i for i, f in enumerate(factors) if _is_mixed(f) and _is_below(f, at)]
    turned = {i: _opposite(factors[i]) for i in (*below, *above)}
    parts = [(turned.get(i, factor), 1) for i, factor in enumerate(factors)]
    return product([(number((-1) ** len(turned)), 1), *parts])


def with_positive_divisors(formula: Formula, values: Mapping[str, float]) -> Formula:
    """Return −atan(a/(b − 1)) as atan(a/(1 − b)) where b − 1 is negative at the values.

    >>> from .tree import ONE, Symbol, quotient
    >>> from .to_text import text
    >>> a, b = map(Symbol, "ab")
    >>> bound = negative(Call("atan", (quotient(a, total([b, negative(ONE)])),)))
    >>> text(with_positive_divisors(bound, {"a": 0.1, "b": 0.2}))
    'atan(a/(1 - b))'
    """
    at = SharedEvaluation(values)

    def turned(whole: Formula) -> Formula | None:
        match whole:
            case Call("asin" | "atan" as function, (Product(factors),)):
                below = [i for i, f in enumerate(factors) if _is_below_zero(f, at)]
                parts = [_opposite(f) if i in below else f for i, f in enumerate(factors)]
                sign = number((-1) ** len(below))
                inner = product([(sign, 1), *((part, 1) for part in parts)])
                if has_minus(inner):
                    return negative(Call(function, (negative(inner),)))
                return Call(function, (inner,))
        return None

    return rewritten(formula, turned)


def _is_below_zero(factor: Formula, at: SharedEvaluation) -> bool:
    """Return whether a factor is a sum, or one over it, that is negative at the values."""
    match factor:
        case Power(Sum() as base, Number(value)) if value == -1:
            return _is_below(base, at)
    return isinstance(factor, Sum) and _is_below(factor, at)


def _opposite(factor: Formula) -> Formula:
    """Return an odd power of a sum with all terms of the other sign."""
    if isinstance(factor, Power):
        return Power(_opposite(factor.base), factor.exponent)
    assert isinstance(factor, Sum)
    return total(_in_reading_order(map(negative, factor.terms)))


def _divisor(formula: Formula) -> Sum | None:
    """Return the difference that something is divided by, once or an odd number of times."""
    match formula:
        case Power(Sum() as base, Number(value)) if value < 0 and value % 2 == 1:
            return base if _is_mixed(base) else None
    return None


def _is_mixed(formula: Formula) -> bool:
    """Return whether something is a sum of terms of which some have a minus, not all."""
    signs = set(map(has_minus, formula.terms)) if isinstance(formula, Sum) else set()
    return len(signs) == 2


def _is_below(formula: Formula, at: SharedEvaluation) -> bool:
    """Return whether a sum is negative; False where it has no value."""
    assert isinstance(formula, Sum)
    try:
        sizes = [at.of(term) for term in formula.terms]
    except KeyError:
        return False
    return sum(sizes) < -NO_SIGN * max(map(abs, sizes))


def _turned_in_pairs(factors: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a product with negative sines turned; None where an odd one would need a minus."""
    sign = -1 if has_minus(Product(tuple(factors))) else 1
    turned = {i: new for i, f in enumerate(factors) if (new := _sine_turned(f, at))}
    if len(turned) % 2 and sign > 0:
        turned = dict(list(turned.items())[:-1])
    if not turned:
        return None
    parts = [(turned.get(i, factor), 1) for i, factor in enumerate(factors)]
    return product([(number((-1) ** len(turned)), 1), *parts])


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
                return Call("sin", (_negated(difference),))
    return None


def _sum_turned(terms: Sequence[Formula], at: SharedEvaluation) -> Formula | None:
    """Return a sum turned round that is negative by a sine of a difference; None for another."""
    turned = [_without_minus(negative(term)) for term in terms]
    is_led = any(
        not has_minus(new) and not has_minus(old) for new, old in zip(turned, terms, strict=True)
    )
    try:
        return (
            total(_in_reading_order(turned))
            if is_led and at.of(Sum(tuple(terms))) < -NO_SIGN
            else None
        )
    except KeyError:
        return None


def _is_negative_sine(difference: Sum, at: SharedEvaluation) -> bool:
    """Return whether the sine of a difference is negative; False where it has no value."""
    try:
        return math.sin(at.of(difference)) < -NO_SIGN
    except KeyError:
        return False


def _in_reading_order(terms: Iterable[Formula]) -> list[Formula]:
    """Return terms as they are read: those without a minus first, a constant last.

    A constant is the first where all others have a minus.
    """
    ordered = sorted(terms, key=lambda term: (in_degrees(term) is not None, has_minus(term)))
    return ordered[-1:] + ordered[:-1] if has_minus(ordered[0]) else ordered


def _difference(formula: Formula) -> Sum | None:
    """Return the difference that a sine is taken of."""
    match formula:
        case Call("sin", (Sum(terms) as inside,)) if any(map(has_minus, terms)):
            return inside
    return None
