"""Formulas written another way: parts replaced, terms in reading order, sines as cosines."""

from collections.abc import Callable, Iterable

from .layout import has_minus, in_degrees
from .tree import (
    Call,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    degrees,
    negative,
    number,
    product,
    total,
)
from .walk import children, rebuild

Quarter = Callable[[Formula], int]
"""By how many degrees an angle is to be turned to be one that a person knows: 90, −90 or 0."""


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
    """Return a formula in whose sums a term without a minus leads.

    What is squared, or stands between bars, has no minus before it. A component of which all
    terms have a minus has one before it.

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
    >>> text(plus_first(Call("abs", (both,))))
    'abs(a + b)'
    """
    parts = tuple(map(plus_first, children(formula)))
    if isinstance(formula, Call) and formula.function in ("abs", "hypot", "atan2"):
        is_even = formula.function != "atan2"
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


def in_reading_order(terms: Iterable[Formula]) -> list[Formula]:
    """Return terms as they are read: those without a minus first, a constant last.

    A constant is the first where all others have a minus.
    """
    ordered = sorted(terms, key=lambda term: (in_degrees(term) is not None, has_minus(term)))
    return ordered[-1:] + ordered[:-1] if has_minus(ordered[0]) else ordered


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
                turned, sign = opposite_angle(turned), sign * (1 if other == "cos" else -1)
            return product([(number(sign), 1), (Call(other, (turned,)), 1)])
    return None


def _is_opposite(angle: Formula, function: str) -> bool:
    """Return whether a function is written of an angle's negative: a constant's, or a cosine's."""
    if isinstance(angle, Sum):
        return function == "cos" and has_minus(angle.terms[0])
    return bool(in_degrees(angle)) and has_minus(angle)


def opposite_angle(angle: Formula) -> Formula:
    """Return an angle of the other sign, its terms in reading order."""
    if isinstance(angle, Sum):
        return total(in_reading_order(map(negative, angle.terms)))
    return negative(angle)


_ODD, _EVEN = frozenset({"sin", "tan", "cot", "csc"}), frozenset({"cos", "sec"})

FUNCTIONS_OF_ANGLES = _ODD | _EVEN


def by_opposite(function: str, opposite: Formula) -> Formula:
    """Return a function of an angle, written by the opposite of that.

    >>> from .to_text import text
    >>> from .tree import Symbol
    >>> text(by_opposite("sin", Symbol("a"))), text(by_opposite("cos", Symbol("a")))
    ('-sin(a)', 'cos(a)')
    """
    written = Call(function, (opposite,))
    return negative(written) if function in _ODD else written


_QUOTIENTS = {("sin", "cos"): "tan", ("cos", "sin"): "cot"}


def by_tangent(factors: Iterable[Formula]) -> Formula | None:
    """Return a product with the tangent of an angle for its sine over its cosine; None if none.

    The cotangent stands for the cosine over the sine.
    """
    listed = list(factors)
    for factor in listed:
        for (above, below), function in _QUOTIENTS.items():
            if isinstance(factor, Call) and factor.function == above:
                under = Power(Call(below, factor.arguments), number(-1))
                if under in listed:
                    others = [f for f in listed if f not in (factor, under)]
                    return product((f, 1) for f in (*others, Call(function, factor.arguments)))
    return None


def _plus(angle: Formula, turn: int) -> Formula:
    """Return an angle with degrees added to its constant, which comes last."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    others = [term for term in terms if in_degrees(term) is None]
    constant = sum(size for term in terms if (size := in_degrees(term)) is not None)
    return total([*others, degrees(constant + turn)])
