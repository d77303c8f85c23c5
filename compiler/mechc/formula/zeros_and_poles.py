"""A formula's zeros and poles, solved for an angle in it, ``tan(α − δ) − c``, or a factor.

What is not of such a form has no solution here.
"""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ..base.named import NamedTuple
from .evaluate import evaluate
from .layout import has_minus, in_degrees
from .tree import (
    ZERO,
    Call,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    degrees,
    negative,
    number,
    product,
    total,
)
from .walk import symbols

SAME_SOLUTION = 1e-9
"""By how many radians, or parts of it, a formula may miss the value that it is for."""


class AngleSolution(NamedTuple):
    """A value of an angle, and the degrees after which there is another; 0 for no angle."""

    value: Formula
    period: Fraction

    def at(self, x: float, values: Mapping[str, float]) -> Formula | None:
        """Return the formula of the value that lies at ``x``, None where none does.

        >>> AngleSolution(Symbol("delta"), Fraction(180)).at(0.1 - math.pi, {"delta": 0.1})
        Sum(terms=(Symbol(name='delta'), Product(factors=(Number(value=Fraction(-1, 1)), Pi()))))
        """
        if not symbols(self.value) <= values.keys():
            return None
        first, period = evaluate(self.value, values), math.radians(self.period)
        if not math.isfinite(first):
            return None
        if not period:
            return self.value if abs(first - x) <= SAME_SOLUTION * abs(x) else None
        turns = round((x - first) / period)
        if abs(first + turns * period - x) > SAME_SOLUTION:
            return None
        return _tidy((self.value, degrees(turns * self.period)))


def zeros(formula: Formula, name: str) -> Iterator[AngleSolution]:
    """Yield the values of ``name``, an angle or a factor, at which a formula vanishes.

    Zeros of parts that cannot be solved for it are left out.

    >>> from .to_text import text
    >>> a, d, c = (Symbol(n) for n in ("alpha", "delta", "c"))
    >>> ahead = Call("tan", (total([a, negative(d)]),))
    >>> [text(s.value) for s in zeros(total([ahead, negative(c)]), "alpha")]
    ['delta + atan(c)']
    """
    match formula:
        case Product(factors):
            for factor in factors:
                yield from zeros(factor, name)
        case Power(base, Number(exponent)):
            yield from zeros(base, name) if exponent > 0 else poles(base, name)
        case Call("sin" | "tan", (angle,)):
            yield from _where(angle, ZERO, 180, name)
        case Call("cos" | "cot", (angle,)):
            yield from _where(angle, degrees(90), 180, name)
        case Sum(terms):
            yield from _of_sum(terms, name)
        case _:
            return


def poles(formula: Formula, name: str) -> Iterator[AngleSolution]:
    """Yield the values of ``name`` at which a formula is infinite, as :func:`zeros` does.

    >>> from .to_text import text
    >>> [text(s.value) for s in poles(Call("tan", (Symbol("alpha"),)), "alpha")]
    ['pi/2']
    """
    match formula:
        case Product(parts) | Sum(parts):
            for part in parts:
                yield from poles(part, name)
        case Power(base, Number(exponent)):
            yield from poles(base, name) if exponent > 0 else zeros(base, name)
        case Call("cot" | "csc", (angle,)):
            yield from _where(angle, ZERO, 180, name)
        case Call("tan" | "sec", (angle,)):
            yield from _where(angle, degrees(90), 180, name)
        case _:
            return


def _where(angle: Formula, value: Formula, period: int, name: str) -> Iterator[AngleSolution]:
    """Yield where an angle has a value: it must be linear in the name."""
    linear = _linear(angle, name)
    if linear is not None:
        slope, rest = linear
        terms = (negative(rest), value) if slope > 0 else (rest, negative(value))
        found = product([(number(1 / abs(slope)), 1), (_tidy(terms), 1)])
        yield AngleSolution(found, abs(period / slope))


def _linear(angle: Formula, name: str) -> tuple[Fraction, Formula] | None:
    """Return c and r of the angle c·name + r."""
    slope, rest = Fraction(0), []
    for term in angle.terms if isinstance(angle, Sum) else (angle,):
        match term:
            case Symbol(n) if n == name:
                slope += 1
            case Product((Number(c), Symbol(n))) if n == name:
                slope += c
            case _:
                rest.append(term)
    if not slope or any(name in symbols(term) for term in rest):
        return None
    return slope, total(rest)


class _TrigonometricTerm(NamedTuple):
    """A term of a sum: a function of an angle that has the name in it, times the rest.

    It is the name itself where there is no function.
    """

    function: str
    angle: Formula
    coefficient: Formula


def _of_sum(terms: Sequence[Formula], name: str) -> Iterator[AngleSolution]:
    """Yield the angles at which a sum is zero, of one or two terms that have the name."""
    flat = [part for term in terms for part in _expanded(term, name)]
    constant = total(t for t in flat if name not in symbols(t))
    parts = _gathered([_part(t, name) for t in flat if name in symbols(t)])
    match parts:
        case [_TrigonometricTerm("", _, a)]:
            yield AngleSolution(_over(constant, a), Fraction(0))
        case [_TrigonometricTerm(function, angle, a)]:
            for value, period in _inverse(function, a, constant):
                yield from _where(angle, value, period, name)
        case [_TrigonometricTerm("sin", angle, a), _TrigonometricTerm("cos", other, b)] if (
            angle == other
        ):
            if constant == ZERO:
                yield from _where(angle, _odd("atan", _over(b, a)), 180, name)
        case _:
            return


def _expanded(term: Formula, name: str) -> Iterator[Formula]:
    """Yield a term, or the terms of a sum in it times its other factors."""
    factors = term.factors if isinstance(term, Product) else (term,)
    sums = [f for f in factors if isinstance(f, Sum) and name in symbols(f)]
    if len(sums) != 1:
        yield term
        return
    others = [(f, 1) for f in factors if f is not sums[0]]
    for part in sums[0].terms:
        yield from _expanded(product([*others, (part, 1)]), name)


def _gathered(parts: Sequence[_TrigonometricTerm | None]) -> list[_TrigonometricTerm] | None:
    """Return parts with the coefficients of equal functions added, sines first; none that is 0."""
    found: dict[tuple[str, Formula], list[Formula]] = {}
    for part in parts:
        if part is None:
            return None
        found.setdefault((part.function, part.angle), []).append(part.coefficient)
    ordered = sorted(found, key=lambda key: key[0] != "sin")
    gathered = [
        _TrigonometricTerm(*key, total(sorted(_left(found[key]), key=has_minus))) for key in ordered
    ]
    return [part for part in gathered if part.coefficient != ZERO]


def _left(coefficients: Iterable[Formula]) -> list[Formula]:
    """Return coefficients without those that are opposite to another."""
    left: list[Formula] = []
    for coefficient in coefficients:
        opposite = negative(coefficient)
        if opposite in left:
            left.remove(opposite)
        else:
            left.append(coefficient)
    return left


def _part(term: Formula, name: str) -> _TrigonometricTerm | None:
    """Return a term as a function of an angle, times what is without the name; else None."""
    factors = term.factors if isinstance(term, Product) else (term,)
    inside = [f for f in factors if name in symbols(f)]
    rest = product(Counter(f for f in factors if name not in symbols(f)).items())
    match inside:
        case [Call("sin" | "cos" | "tan" | "cot" as function, (angle,))]:
            return _TrigonometricTerm(function, angle, rest)
        case [Symbol() as itself]:
            return _TrigonometricTerm("", itself, rest)
        case _:
            return None


def _inverse(function: str, a: Formula, c: Formula) -> Iterator[tuple[Formula, int]]:
    """Yield the angles u, and their periods, at which a·function(u) + c = 0."""
    value = _over(c, a)
    match function:
        case "tan":
            yield _odd("atan", value), 180
        case "cot":
            yield degrees(90) if c == ZERO else _odd("atan", _over(a, c)), 180
        case "sin":
            yield _odd("asin", value), 360
            yield total((degrees(180), negative(_odd("asin", value)))), 360
        case _:
            yield Call("acos", (value,)), 360
            yield negative(Call("acos", (value,))), 360


def _odd(function: str, value: Formula) -> Formula:
    """Return an odd function of a value, a minus in front of it."""
    match value:
        case Number(first) | Product((Number(first), *_)) if first < 0:
            return negative(Call(function, (negative(value),)))
        case _:
            return Call(function, (value,))


def _over(above: Formula, below: Formula) -> Formula:
    """Return -above/below, the numbers of both as one."""
    factors = below.factors if isinstance(below, Product) else (below,)
    return product([(number(-1), 1), (above, 1), *((f, -1) for f in factors)])


def _tidy(terms: Sequence[Formula]) -> Formula:
    """Return a sum of angles with its constants as one."""
    flat = total(terms)
    parts = flat.terms if isinstance(flat, Sum) else (flat,)
    constants = [in_degrees(p) for p in parts]
    whole = sum((c for c in constants if c is not None), Fraction(0))
    others = [p for p, c in zip(parts, constants, strict=True) if c is None]
    return total([*others, degrees(whole)])
