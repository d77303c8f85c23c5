"""Formulas as people read them: the small expression tree that is handed out.

Angle algebra (``angle``, ``product``, ``laurent``) computes; a :data:`Formula` is what
is then printed, sent to sympy or put into a straight-line program. It is never
rewritten behind its maker's back: what is built is what is printed.

Quantities are SI; angles are radians. A constant angle is a rational multiple of
:data:`PI`, so that a printer can write 40° exactly.

>>> a, b, alpha = Symbol("a"), Symbol("b"), Symbol("alpha")
>>> k = product([(Number(Fraction(2)), 1), (b, 1), (a, -1), (Call("cot", (alpha,)), 1)])
>>> text(k)
'2*b*cot(alpha)/a'
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import reduce
from typing import assert_never

from ..frozen import frozen


@frozen
class Number:
    """An exact rational."""

    value: Fraction


@frozen
class Pi:
    """The number π."""


@frozen
class Symbol:
    """A named quantity: a parameter, a load, an intermediate angle, a velocity ``V_A``."""

    name: str


@frozen
class Sum:
    """Two or more terms; a subtracted term is a Product with a negative leading Number."""

    terms: tuple["Formula", ...]


@frozen
class Product:
    """Two or more factors in reading order; a divisor is a Power with a negative exponent."""

    factors: tuple["Formula", ...]


@frozen
class Power:
    """``base ** exponent``."""

    base: "Formula"
    exponent: "Formula"


@frozen
class Call:
    """One of :data:`FUNCTIONS` applied to its arguments."""

    function: str
    arguments: tuple["Formula", ...]


Formula = Number | Pi | Symbol | Sum | Product | Power | Call

ZERO, ONE, PI = Number(Fraction(0)), Number(Fraction(1)), Pi()


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
    "min": min,
    "max": max,
    "exp": math.exp,
    "log": math.log,
}
"""Every function of the language and its meaning on floats."""


# ------------------------------------------------------------------------ builders


def number(value: int | Fraction) -> Number:
    """Return an exact number."""
    return Number(Fraction(value))


def degrees(value: int | Fraction) -> Formula:
    """Return a constant angle given in degrees, as a rational multiple of π.

    >>> text(degrees(40))
    '2*pi/9'
    """
    return product([(number(Fraction(value) / 180), 1), (PI, 1)])


def total(terms: Iterable[Formula]) -> Formula:
    """Return the sum of the terms, flat, without zeros, in the order given."""
    flat: list[Formula] = []
    for term in terms:
        if isinstance(term, Sum):
            flat.extend(term.terms)
        elif term != ZERO:
            flat.append(term)
    if not flat:
        return ZERO
    return flat[0] if len(flat) == 1 else Sum(tuple(flat))


def product(factors: Iterable[tuple[Formula, int]]) -> Formula:
    """Return the product of ``(factor, integer exponent)`` in the order given.

    Numbers are gathered into one leading coefficient; ``0`` and ``1`` disappear.
    """
    coefficient = Fraction(1)
    rest: list[Formula] = []
    for factor, exponent in factors:
        if isinstance(factor, Number):
            coefficient *= factor.value**exponent
        elif exponent == 1 and isinstance(factor, Product):
            head, *tail = factor.factors
            if isinstance(head, Number):
                coefficient *= head.value
                rest.extend(tail)
            else:
                rest.extend(factor.factors)
        elif exponent:
            rest.append(factor if exponent == 1 else power(factor, number(exponent)))
    if coefficient == 0:
        return ZERO
    if coefficient != 1 or not rest:
        rest.insert(0, Number(coefficient))
    return rest[0] if len(rest) == 1 else Product(tuple(rest))


def power(base: Formula, exponent: Formula) -> Formula:
    """Return ``base ** exponent``, with exponents 0 and 1 and nested integer powers resolved."""
    match base, exponent:
        case _, Number(value) if value == 1:
            return base
        case _, Number(value) if value == 0:
            return ONE
        case Number(b), Number(e) if e.denominator == 1 and abs(e) <= 64 and b:
            return Number(b**e.numerator)
        case Power(inner, Number(e1)), Number(e2) if e1.denominator == e2.denominator == 1:
            return power(inner, Number(e1 * e2))
    return Power(base, exponent)


def negative(formula: Formula) -> Formula:
    """Return ``-formula``; a sum is negated term by term."""
    if isinstance(formula, Sum):
        return Sum(tuple(negative(t) for t in formula.terms))
    return product([(number(-1), 1), (formula, 1)])


def quotient(above: Formula, below: Formula) -> Formula:
    """Return ``above / below``."""
    return product([(above, 1), (below, -1)])


# ------------------------------------------------------------------------- walking


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
        case Call(_, arguments):
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

    >>> round(evaluate(Call("sin", (degrees(30),)), {}), 12)
    0.5
    """
    try:
        return _evaluate(formula, values)
    except (ZeroDivisionError, ValueError, OverflowError):
        return math.nan


def _evaluate(formula: Formula, values: Mapping[str, float]) -> float:
    match formula:
        case Number(value):
            return value.numerator / value.denominator
        case Pi():
            return math.pi
        case Symbol(name):
            return values[name]
        case Sum(terms):
            return math.fsum(_evaluate(t, values) for t in terms)
        case Product(factors):
            return math.prod(_evaluate(f, values) for f in factors)
        case Power(base, exponent):
            result = _evaluate(base, values) ** _evaluate(exponent, values)
            return result if isinstance(result, float) else math.nan
        case Call(function, arguments):
            return float(FUNCTIONS[function](*(_evaluate(a, values) for a in arguments)))
        case _:
            assert_never(formula)


# -------------------------------------------------------------------------- length


def split_fraction(formula: Product) -> tuple[Fraction, list[Formula], list[Formula]]:
    """Split a product into its coefficient, the factors above the line and those below.

    The factors below are given with positive exponents.
    """
    coefficient = Fraction(1)
    above: list[Formula] = []
    below: list[Formula] = []
    for factor in formula.factors:
        match factor:
            case Number(value):
                coefficient *= value
            case Power(base, Number(value)) if value < 0:
                below.append(power(base, Number(-value)))
            case _:
                above.append(factor)
    return coefficient, above, below


def count_operations(formula: Formula) -> int:
    """Return the number of operations, counted as sympy's ``count_ops`` counts them.

    >>> a, b, t = Symbol("a"), Symbol("b"), Symbol("t")
    >>> count_operations(product([(number(2), 1), (b, 1), (a, -1), (Call("cot", (t,)), 1)]))
    4
    """
    match formula:
        case Number(value):
            return (value < 0) + (value.denominator != 1)
        case Pi() | Symbol():
            return 0
        case Sum(terms):
            return sum(map(_term_operations, terms)) + len(terms) - 1
        case Product():
            return _product_operations(formula)
        case Power(base, Number(value)) if value == -1:
            return 1 + count_operations(base)
        case Power(base, exponent):
            return 1 + count_operations(base) + count_operations(exponent) - _negated(exponent)
        case Call(_, arguments):
            return 1 + sum(map(count_operations, arguments))
        case _:
            assert_never(formula)


def _negated(exponent: Formula) -> int:
    return 1 if isinstance(exponent, Number) and exponent.value < 0 else 0


def _term_operations(term: Formula) -> int:
    """Count a term of a sum: its minus sign is the subtraction itself."""
    negated = (isinstance(term, Number) and term.value < 0) or (
        isinstance(term, Product)
        and isinstance(term.factors[0], Number)
        and term.factors[0].value < 0
    )
    return count_operations(term) - bool(negated)


def _product_operations(formula: Product) -> int:
    coefficient, above, below = split_fraction(formula)
    upper = len(above) + (abs(coefficient.numerator) != 1)
    lower = len(below) + (coefficient.denominator != 1)
    operations = max(upper - 1, 0) + max(lower - 1, 0) + (lower > 0) + (coefficient < 0)
    return operations + sum(map(count_operations, above)) + sum(map(count_operations, below))


# ---------------------------------------------------------------------------- text


def text(formula: Formula) -> str:
    """Return the formula in the notation of the language (``^`` for powers).

    >>> x = Symbol("x")
    >>> text(total([x, product([(number(-2), 1), (Call("sin", (x,)), 1)])]))
    'x - 2*sin(x)'
    """
    return _text(formula, 0)


def _text(formula: Formula, level: int) -> str:
    """Print; ``level`` is 0 in a sum, 1 in a product, 2 under a power or a division."""
    match formula:
        case Number(value):
            plain = str(value)
            return f"({plain})" if level and (value < 0 or (level > 1 and "/" in plain)) else plain
        case Pi():
            return "pi"
        case Symbol(name):
            return name
        case Sum(terms):
            joined = reduce(_join, (_text(t, 0) for t in terms))
            return f"({joined})" if level else joined
        case Product():
            return _product_text(formula, level)
        case Power(base, Number(value)) if value < 0:
            below = f"1/{_text(power(base, Number(-value)), 2)}"
            return f"({below})" if level > 1 else below
        case Power(base, exponent):
            raised = f"{_text(base, 3)}^{_text(exponent, 3)}"
            return f"({raised})" if level > 2 else raised
        case Call(function, arguments):
            return f"{function}({', '.join(_text(a, 0) for a in arguments)})"
        case _:
            assert_never(formula)


def _join(left: str, right: str) -> str:
    return f"{left} - {right[1:]}" if right.startswith("-") else f"{left} + {right}"


def _product_text(formula: Product, level: int) -> str:
    coefficient, above, below = split_fraction(formula)
    upper = [_text(f, 1) for f in above]
    if abs(coefficient.numerator) != 1 or not upper:
        upper.insert(0, str(abs(coefficient.numerator)))
    lower = [_text(f, 2 if len(below) == 1 and coefficient.denominator == 1 else 1) for f in below]
    if coefficient.denominator != 1:
        lower.insert(0, str(coefficient.denominator))
    line = "*".join(upper)
    if lower:
        line += "/" + (lower[0] if len(lower) == 1 else f"({'*'.join(lower)})")
    if coefficient < 0:
        line = "-" + line
    return f"({line})" if level > 1 or (level and coefficient < 0) else line
