"""Partial derivatives of formulas as they stand.

>>> from .to_text import text
>>> x, y = Symbol("x"), Symbol("y")
>>> text(derivative(product([(Call("sin", (x,)), 1), (y, 2)]), "x"))
'cos(x)*y^2'
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import assert_never

from .tree import (
    ONE,
    ZERO,
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    negative,
    number,
    power,
    product,
    quotient,
    total,
)
from .walk import Once

Differentiate = Callable[[Formula], Formula]


def jacobian(formulas: Sequence[Formula], names: Sequence[str]) -> tuple[tuple[Formula, ...], ...]:
    """Return the derivative of each formula with respect to each name, a row for a formula."""
    slopes = [_by(name) for name in names]
    return tuple(tuple(slope(f) for slope in slopes) for f in formulas)


def derivative(formula: Formula, name: str) -> Formula:
    """Return ∂formula/∂name.

    Raises ``ValueError`` for a solution of a system that depends on the name: its
    derivative is no formula.
    """
    return _by(name)(formula)


def along(formulas: Sequence[Formula], changes: Mapping[str, Formula]) -> tuple[Formula, ...]:
    """Return by how much formulas change for a share of a way, on which names change by so much.

    >>> from .to_text import text
    >>> x, y = Symbol("x"), Symbol("y")
    >>> text(*along([product([(x, 1), (y, 2)])], {"x": Symbol("d"), "y": number(3)}))
    'd*y^2 + 6*x*y'
    """
    return tuple(map(_along(changes), formulas))


def _by(name: str) -> Differentiate:
    return _along({name: ONE})


def _along(changes: Mapping[str, Formula]) -> Differentiate:
    """Return the slope where names change by so much, found once of parts that formulas share."""

    def slope_of(formula: Formula) -> Formula:
        """Return the slope of a formula by those of its parts, one rule for each kind of node."""
        match formula:
            case Number() | Pi():
                return ZERO
            case Symbol(name):
                return changes.get(name, ZERO)
            case Sum(terms):
                return total(map(slope, terms))
            case Product(factors):
                return _of_product(factors, slope)
            case Power(base, exponent):
                return _of_power(base, exponent, slope)
            case Call(function, arguments):
                return _of_call(function, arguments, slope)
            case Implicit(_, _, arguments):
                if any(slope(a) != ZERO for a in arguments):
                    names = ", ".join(changes)
                    raise ValueError(
                        f"what depends on {names} by a system has no formula for its slope"
                    )
                return ZERO
            case _:
                assert_never(formula)

    slope = Once(slope_of)
    return slope


def _of_product(factors: tuple[Formula, ...], slope: Differentiate) -> Formula:
    slopes = [slope(f) for f in factors]
    return total(
        product((own if i == j else f, 1) for j, f in enumerate(factors))
        for i, own in enumerate(slopes)
        if own != ZERO
    )


def _of_power(base: Formula, exponent: Formula, slope: Differentiate) -> Formula:
    below, above = slope(base), slope(exponent)
    lower = power(base, total([exponent, number(-1)]) if above != ZERO else _less_one(exponent))
    first = product([(exponent, 1), (lower, 1), (below, 1)])
    if above == ZERO:
        return first
    return total(
        [first, product([(Power(base, exponent), 1), (_call("log", base), 1), (above, 1)])]
    )


def _less_one(exponent: Formula) -> Formula:
    if isinstance(exponent, Number):
        return Number(exponent.value - 1)
    return total([exponent, number(-1)])


def partials(function: str, arguments: tuple[Formula, ...]) -> list[Formula]:
    """Return the derivative of a function by each of its arguments."""
    size = len(arguments)
    units = ([ONE if i == j else ZERO for j in range(size)] for i in range(size))
    return [_with_slopes(function, arguments, unit) for unit in units]


def _of_call(function: str, arguments: tuple[Formula, ...], slope: Differentiate) -> Formula:
    slopes = [slope(a) for a in arguments]
    if all(slope == ZERO for slope in slopes):
        return ZERO
    return _with_slopes(function, arguments, slopes)


def _with_slopes(
    function: str, arguments: tuple[Formula, ...], slopes: Sequence[Formula]
) -> Formula:
    if function in _OF_ONE:
        return product([(_OF_ONE[function](arguments[0]), 1), (slopes[0], 1)])
    return _OF_SEVERAL[function](arguments, slopes)


def _call(function: str, argument: Formula) -> Formula:
    return Call(function, (argument,))


def _square(formula: Formula) -> Formula:
    return power(formula, number(2))


def _root(sign: int, x: Formula) -> Formula:
    """Return ``1/√(1 - x²)`` with a sign."""
    inside = total([ONE, negative(_square(x))])
    return product([(number(sign), 1), (_call("sqrt", inside), -1)])


_OF_ONE: Mapping[str, Callable[[Formula], Formula]] = {
    "sin": lambda x: _call("cos", x),
    "cos": lambda x: negative(_call("sin", x)),
    "tan": lambda x: power(_call("cos", x), number(-2)),
    "cot": lambda x: negative(power(_call("sin", x), number(-2))),
    "sec": lambda x: product([(_call("sin", x), 1), (_call("cos", x), -2)]),
    "csc": lambda x: product([(number(-1), 1), (_call("cos", x), 1), (_call("sin", x), -2)]),
    "asin": lambda x: _root(1, x),
    "acos": lambda x: _root(-1, x),
    "atan": lambda x: power(total([ONE, _square(x)]), number(-1)),
    "sqrt": lambda x: product([(number(Fraction(1, 2)), 1), (_call("sqrt", x), -1)]),
    "abs": lambda x: _call("sign", x),
    "sign": lambda x: ZERO,
    "exp": lambda x: _call("exp", x),
    "log": lambda x: power(x, number(-1)),
}
"""The slopes of functions of one argument."""


def _of_atan2(arguments: Sequence[Formula], slopes: Sequence[Formula]) -> Formula:
    y, x = arguments
    above = total([product([(x, 1), (slopes[0], 1)]), negative(product([(y, 1), (slopes[1], 1)]))])
    return quotient(above, total([_square(x), _square(y)]))


def _of_hypot(arguments: Sequence[Formula], slopes: Sequence[Formula]) -> Formula:
    above = total(product([(a, 1), (s, 1)]) for a, s in zip(arguments, slopes, strict=True))
    return quotient(above, Call("hypot", tuple(arguments)))


def _of_extreme(sign: int, arguments: Sequence[Formula], slopes: Sequence[Formula]) -> Formula:
    """Return the slope of the largest (``sign`` 1) or smallest (-1): ``(a + b ± |a - b|)/2``."""

    def join(
        one: tuple[Formula, Formula], other: tuple[Formula, Formula]
    ) -> tuple[Formula, Formula]:
        gap, slope = (total([a, negative(b)]) for a, b in zip(one, other, strict=True))
        bend = product([(number(sign), 1), (gap, 1), (_call("abs", gap), -1), (slope, 1)])
        function = "max" if sign > 0 else "min"
        half = (number(Fraction(1, 2)), 1)
        return Call(function, (one[0], other[0])), product(
            [half, (total([one[1], other[1], bend]), 1)]
        )

    return reduce(join, zip(arguments, slopes, strict=True))[1]


_OF_SEVERAL: Mapping[str, Callable[[Sequence[Formula], Sequence[Formula]], Formula]] = {
    "atan2": _of_atan2,
    "hypot": _of_hypot,
    "min": lambda a, s: _of_extreme(-1, a, s),
    "max": lambda a, s: _of_extreme(1, a, s),
    "sense": lambda a, s: ZERO,
}
"""The slopes of functions of several arguments, from those of the arguments."""
