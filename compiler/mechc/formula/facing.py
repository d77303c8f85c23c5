"""Sines of differences the way round in which a person writes them: positive at the values."""

import math
from collections.abc import Callable, Mapping, Sequence

from .evaluate import Evaluation
from .layout import has_minus
from .operations import count_operations
from .tree import Call, Formula, Number, Power, Product, Sum, negative, number, product, total
from .walk import children, rebuild, walk

ROUNDING = 1e-9
"""A sine that is smaller is 0 but for rounding, and has no sign."""

LONG = 400
"""Formulas of more operations are read by machines alone."""


def facing(formula: Formula, values: Callable[[], Mapping[str, float]]) -> Formula:
    """Write sin(a − b)/sin(c − b) as sin(b − a)/sin(b − c) where both are negative at the values.

    So are more of them, with a minus in front or in pairs; the formula's value is the same. The
    ``values`` are asked for only where there are such sines.

    >>> from .tree import Symbol, quotient
    >>> from .to_text import text
    >>> a, b, c = map(Symbol, "abc")
    >>> sines = [Call("sin", (total([one, negative(b)]),)) for one in (a, c)]
    >>> text(facing(quotient(*sines), lambda: {"a": 0.1, "b": 0.5, "c": 0.3}))
    'sin(b - a)/sin(b - c)'
    >>> text(facing(negative(sines[0]), lambda: {"a": 0.1, "b": 0.5}))
    'sin(b - a)'
    """
    if not any(map(_difference, walk(formula))) or count_operations(formula) > LONG:
        return formula
    return _faced(formula, Evaluation(values()))


def _faced(formula: Formula, at: Evaluation) -> Formula:
    parts = tuple(_faced(part, at) for part in children(formula))
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    return _paired(whole.factors, at) or whole if isinstance(whole, Product) else whole


def _paired(factors: Sequence[Formula], at: Evaluation) -> Formula | None:
    """Return a product with negative sines turned; None where an odd one would need a minus."""
    sign = -1 if has_minus(Product(tuple(factors))) else 1
    turned = {i: new for i, factor in enumerate(factors) if (new := _turned(factor, at))}
    if len(turned) % 2 and sign > 0:
        turned = dict(list(turned.items())[:-1])
    if not turned:
        return None
    parts = [(turned.get(i, factor), 1) for i, factor in enumerate(factors)]
    return product([(number((-1) ** len(turned)), 1), *parts])


def _turned(factor: Formula, at: Evaluation) -> Formula | None:
    """Return an odd power of a sine with its difference turned round, if it is negative."""
    match factor:
        case Power(base, Number(value) as exponent) if value.denominator == 1 and value % 2:
            turned = _turned(base, at)
            return Power(turned, exponent) if turned else None
        case _ if difference := _difference(factor):
            try:
                is_negative = math.sin(at.of(difference)) < -ROUNDING
            except KeyError:
                return None
            terms = sorted(map(negative, difference.terms), key=has_minus)
            return Call("sin", (total(terms),)) if is_negative else None
    return None


def _difference(formula: Formula) -> Sum | None:
    """Return the difference that a sine is taken of."""
    match formula:
        case Call("sin", (Sum(terms) as inside,)) if any(map(has_minus, terms)):
            return inside
    return None
