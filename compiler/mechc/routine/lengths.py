"""Lengths of vectors, and what is known of them without another root.

``hypot(x, y)`` guards against overflow, which no length in metres comes near; a root does
the same in a fraction of the time, and where the square is asked for it is there already.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from typing import TypeGuard

from ..algebra.factors import Length
from ..algebra.from_formula import is_transparent, to_product
from ..algebra.product import Product as Factored
from ..algebra.sums import add
from ..formula.evaluate import evaluate
from ..formula.sharing import each_part
from ..formula.tree import (
    Call,
    Constant,
    Definitions,
    Formula,
    Number,
    Power,
    Product,
    Sum,
    Symbol,
    is_call,
    negative,
    number,
    power,
    product,
    total,
)
from ..formula.walk import Once, children, rebuild

SizeNames = Mapping[frozenset[Formula], str]
"""The lengths that have a name, by the components of their vectors, signs aside."""

TWO = number(2)


def with_roots(
    definitions: Definitions, formulas: Sequence[Formula], taken: set[str]
) -> tuple[list[tuple[str, Formula]], list[Formula]]:
    """Return definitions and formulas in which lengths of vectors are roots of their squares.

    A length whose square is asked for has the square defined before it.
    """
    in_squares = squaring(sizes(definitions).values())
    paired = [(name, in_squares(formula)) for name, formula in definitions]
    results = [in_squares(f) for f in formulas]
    asked = set(_squared([*(f for _, f in paired), *results]))
    squares: dict[Formula, Formula] = {}
    put = _putting(squares)
    written: list[tuple[str, Formula]] = []
    for name, formula in paired:
        if not _is_length(formula):
            written.append((name, put(formula)))
            continue
        square = _sum_of_squares(map(put, formula.arguments))
        if name in asked:
            title = fresh(f"{name}_squared", taken)
            written.append((title, square))
            square = squares[Power(Symbol(name), TWO)] = Symbol(title)
            put.forget()
        written.append((name, Call("sqrt", (square,))))
    return written, [put(f) for f in results]


def _squared(formulas: Iterable[Formula]) -> Iterator[str]:
    for part in each_part(formulas):
        match part:
            case Power(Symbol(name), exponent) if exponent == TWO:
                yield name


def _putting(squares: Mapping[Formula, Formula]) -> Once[Formula]:
    """Return how formulas are written with squares by their names, and roots for lengths."""

    def written(formula: Formula) -> Formula:
        if isinstance(formula, Power) and formula in squares:
            return squares[formula]
        parts = tuple(map(once, children(formula)))
        if _is_length(formula):
            return Call("sqrt", (_sum_of_squares(parts),))
        return rebuild(formula, parts) if parts else formula

    once = Once(written)
    return once


def _is_length(formula: Formula) -> TypeGuard[Call]:
    return is_call(formula, "hypot")


def _sum_of_squares(parts: Iterable[Formula]) -> Formula:
    return total(power(unsigned(part), TWO) for part in parts)


def squaring(lengths: Collection[str]) -> Once[Formula]:
    """Return how formulas are written with ``u² - r²`` for ``(u + r)·(u - r)``, r such a length.

    As r is the root of a square, nothing cancels that had not cancelled already: u² is as
    close to r² as u + r and u - r are to what the rounded r makes them.
    """

    def written(formula: Formula) -> Formula:
        parts = tuple(map(once, children(formula)))
        if isinstance(formula, Product):
            return _in_squares(parts, lengths)
        return rebuild(formula, parts) if parts else formula

    once = Once(written)
    return once


def _in_squares(factors: Iterable[Formula], lengths: Collection[str]) -> Formula:
    """Return a product in which (a - b)·(a + b) is a difference of squares, b such a length."""
    left, found = [*factors], list[Formula]()
    while left:
        first = left.pop(0)
        pairs = ((p, d) for p in left if (d := _difference(first, p, lengths)))
        partner, difference = next(pairs, (None, first))
        if partner:
            left.remove(partner)
        found.append(difference)
    return product((f, 1) for f in found)


def _difference(one: Formula, other: Formula, lengths: Collection[str]) -> Formula | None:
    """Return the product of ``u + r`` and ``u - r``, or of ``u + r`` and ``r - u``."""
    if not (isinstance(one, Sum) and isinstance(other, Sum)):
        return None
    r, u = _parted(one, lengths)
    s, v = _parted(other, lengths)
    if not r or not s:
        return None
    if r == s and {*map(negative, u)} == {*v}:
        return total([power(r, TWO), negative(power(total(u), TWO))])
    if r == negative(s) and {*u} == {*v}:
        return total([power(total(u), TWO), negative(power(unsigned(r), TWO))])
    return None


def _parted(formula: Sum, lengths: Collection[str]) -> tuple[Formula | None, list[Formula]]:
    """Return the term of a sum that is such a length, and the others."""
    for i, term in enumerate(formula.terms):
        bare = unsigned(term)
        if isinstance(bare, Symbol) and bare.name in lengths:
            return term, [*formula.terms[:i], *formula.terms[i + 1 :]]
    return None, []


def sizes(definitions: Definitions) -> SizeNames:
    """Return the lengths that are defined as those of vectors."""
    return {
        frozenset(map(unsigned, formula.arguments)): name
        for name, formula in definitions
        if is_call(formula, "hypot")
    }


def size(x: Formula, y: Formula, positive: Collection[str] = ()) -> Formula | None:
    """Return ``hypot(x, y)`` without a root, where algebra sees that it is a product.

    As in a triangle, where x and y come from the three sides and their hypotenuse is twice
    the product of two of them. ``positive`` names need no absolute value.

    >>> from ..formula.to_text import text
    >>> a, b = Symbol("a"), Symbol("b")
    >>> squares = product([(total([a, b]), 1), (total([a, negative(b)]), 1)])
    >>> text(size(Call("sqrt", (squares,)), b))
    'abs(a)'
    """
    squares = [_square(x), _square(y)]
    if not all(map(is_transparent, squares)):
        return None
    square = add(squares)
    scale = _root(Fraction(square.coefficient))
    if scale is None or any(not isinstance(f, Length) or e % 2 for f, e in square.factors.items()):
        return None
    roots = [(_absolute(f.formula(), positive), e // 2) for f, e in square.factors.items()]
    return product([(Number(scale), 1), *roots])


def _absolute(formula: Formula, positive: Collection[str]) -> Formula:
    if isinstance(formula, Constant):
        return formula if evaluate(formula, {}) > 0 else negative(formula)
    known = isinstance(formula, Symbol) and formula.name in positive
    return formula if known else Call("abs", (formula,))


def _square(formula: Formula) -> Factored:
    bare = unsigned(formula)
    if is_call(bare, "sqrt"):
        return to_product(bare.arguments[0])
    return to_product(bare) ** 2


def _root(value: Fraction) -> Fraction | None:
    """Return the root of a rational number where it is rational."""
    if value <= 0:
        return None
    root = Fraction(isqrt(value.numerator), isqrt(value.denominator))
    return root if root * root == value else None


def signed(term: Formula) -> tuple[int, Formula]:
    """Return the sign in front of a formula, and the formula without it."""
    match term:
        case Product((Number(value), *rest)) if value == -1:
            return -1, rest[0] if len(rest) == 1 else Product(tuple(rest))
        case _:
            return 1, term


def unsigned(term: Formula) -> Formula:
    """Return a formula without the minus sign in front."""
    return signed(term)[1]


def fresh(name: str, taken: set[str]) -> str:
    """Return a name like this one that is not taken, and take it."""
    while name in taken:
        name += "_"
    taken.add(name)
    return name
