"""Formulas with parts of them replaced, and with a term without a minus first."""

from collections.abc import Callable

from .layout import has_minus
from .tree import Call, Formula, Number, Power, Product, Sum, negative, number, product, total
from .walk import children, rebuild


def rewritten(formula: Formula, turned: Callable[[Formula], Formula | None]) -> Formula:
    """Return a formula with what is turned in place of its parts, their signs put together."""
    parts = tuple(rewritten(part, turned) for part in children(formula))
    if isinstance(formula, Power) and isinstance(formula.exponent, Number):
        sign, base = _sign_apart(parts[0])
        if sign < 0 and formula.exponent.value.denominator == 1:
            times = sign**formula.exponent.value.numerator
            return product([(number(int(times)), 1), (Power(base, formula.exponent), 1)])
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    return turned(whole) or whole


def without_sign(formula: Formula) -> Formula:
    """Return a function without the minus before it.

    >>> without_sign(negative(Call("sin", (number(1),)))) == Call("sin", (number(1),))
    True
    """
    return _sign_apart(formula)[1]


def _sign_apart(formula: Formula) -> tuple[int, Formula]:
    match formula:
        case Product((Number(value), Call() as call)) if value == -1:
            return -1, call
    return 1, formula


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
