"""Walking over formulas: parts, symbols, substitution, the value on floats."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from typing import assert_never

from .derivative import jacobian
from .newton import Equations, Matrix, Status, follow, side_of
from .tree import (
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
    power,
    product,
    total,
)


def _cot(x: float) -> float:
    return math.cos(x) / math.sin(x)


FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": _cot,
    "sec": lambda x: 1 / math.cos(x),
    "csc": lambda x: 1 / math.sin(x),
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "sqrt": math.sqrt,
    "hypot": math.hypot,
    "abs": abs,
    "sign": lambda x: math.copysign(1.0, x) if x else x,
    "min": min,
    "max": max,
    "exp": math.exp,
    "log": math.log,
}
"""Every function of the language, and ``sign``, with its meaning on floats."""


def children(formula: Formula) -> tuple[Formula, ...]:
    """Return the parts of a formula, left to right."""
    match formula:
        case Number() | Pi() | Symbol():
            return ()
        case Sum(terms):
            return terms
        case Product(factors):
            return factors
        case Power(base, exponent):
            return (base, exponent)
        case Call(_, arguments) | Implicit(_, _, arguments):
            return arguments
        case _:
            assert_never(formula)


def rebuild(formula: Formula, parts: tuple[Formula, ...]) -> Formula:
    """Return the formula with its children replaced (same kind, same number)."""
    match formula:
        case Number() | Pi() | Symbol():
            return formula
        case Sum():
            return total(parts)
        case Product():
            return product((p, 1) for p in parts)
        case Power():
            return power(*parts)
        case Call(function, _):
            return Call(function, parts)
        case Implicit(system, index, _):
            return Implicit(system, index, parts)
        case _:
            assert_never(formula)


def walk(formula: Formula) -> Iterator[Formula]:
    """Yield the formula and all its parts, parents first."""
    stack = [formula]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(children(node)))


def symbols(formula: Formula) -> frozenset[str]:
    """Return the names that a formula depends on."""
    return frozenset(f.name for f in walk(formula) if isinstance(f, Symbol))


def substitute(formula: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return the formula with symbols replaced by formulas."""
    if isinstance(formula, Symbol):
        return values.get(formula.name, formula)
    parts = children(formula)
    return rebuild(formula, tuple(substitute(p, values) for p in parts)) if parts else formula


def evaluate(formula: Formula, values: Mapping[str, float]) -> float:
    """Return the value on floats; NaN where a function is not defined there.

    >>> from .tree import degrees
    >>> round(evaluate(Call("sin", (degrees(30),)), {}), 12)
    0.5
    """
    return Evaluation(values).of(formula)


class Evaluation:
    """Formulas on floats at one set of values: a part that several share is found once.

    Parts are known by their identity, as large formulas are put together of the same ones.
    Names may be added to ``values`` later on, but not change.
    """

    def __init__(self, values: Mapping[str, float]) -> None:
        self._values = values
        self._known: dict[int, float] = {}
        self._alive: list[Formula] = []

    def of(self, formula: Formula) -> float:
        """Return the value of a formula; NaN where a function is not defined there."""
        self._alive.append(formula)
        try:
            return self._of(formula)
        except (ZeroDivisionError, ValueError, OverflowError):
            return math.nan

    def _of(self, formula: Formula) -> float:
        match formula:
            case Symbol(name):
                return self._values[name]
            case Number(value):
                return value.numerator / value.denominator
            case Pi():
                return math.pi
        known = self._known.get(id(formula))
        if known is None:
            known = self._known[id(formula)] = self._compute(formula)
        return known

    def _compute(self, formula: Sum | Product | Power | Call | Implicit) -> float:
        match formula:
            case Sum(terms):
                return math.fsum(map(self._of, terms))
            case Product(factors):
                return math.prod(map(self._of, factors))
            case Power(base, exponent):
                result = self._of(base) ** self._of(exponent)
                return result if isinstance(result, float) else math.nan
            case Call(function, arguments):
                return float(FUNCTIONS[function](*map(self._of, arguments)))
            case Implicit(system, index, arguments):
                return solution(system, tuple(map(self._of, arguments)))[index]
            case _:
                assert_never(formula)


# ------------------------------------------------------------------------- systems


def equations(formula: Implicit) -> tuple[Formula, ...]:
    """Return what is zero, in the unknowns and what the outer symbols stand for."""
    names = (name for name, _ in formula.system.anchor)
    values = dict(zip(names, formula.arguments, strict=True))
    return tuple(substitute(e, values) for e in formula.system.equations)


def solution(system: System, outer: tuple[float, ...]) -> tuple[float, ...]:
    """Return the unknowns at values of the outer symbols; NaN where the branch ends."""
    status, found = _followed(system, outer)
    return found if status == 0 else (math.nan,) * len(found)


def status(formula: Implicit, values: Mapping[str, float]) -> Status:
    """Return how a solution was found, or why it was not."""
    here = Evaluation(values)
    return _followed(formula.system, tuple(map(here.of, formula.arguments)))[0]


@lru_cache(maxsize=64)
def _followed(system: System, outer: tuple[float, ...]) -> tuple[Status, tuple[float, ...]]:
    anchor, start = _beginning(system, outer)
    return follow(numeric(system), anchor, start, outer)


def _beginning(system: System, outer: Sequence[float]) -> tuple[list[float], list[float]]:
    """Return the values of outer symbols and unknowns where the way begins."""
    pairs = zip(system.anchor, outer, strict=True)
    anchor = {name: end if value is None else value for (name, value), end in pairs}
    return list(anchor.values()), [anchor[s] if isinstance(s, str) else s for s in system.start]


def side(system: System) -> int:
    """Return the sign of the Jacobian's determinant where the way begins.

    It does not depend on what stays the same along it.
    """
    anchor, start = _beginning(system, (0.0,) * len(system.anchor))
    return side_of(numeric(system), start, anchor)


@cache
def numeric(system: System) -> Equations:
    """Return residuals and Jacobian as a function of floats."""
    rows = jacobian(system.equations, system.unknowns)
    names = (*system.unknowns, *(name for name, _ in system.anchor))

    def at(unknowns: Sequence[float], outer: Sequence[float]) -> tuple[list[float], Matrix]:
        here = Evaluation(dict(zip(names, (*unknowns, *outer), strict=True)))
        return list(map(here.of, system.equations)), [list(map(here.of, row)) for row in rows]

    return at
