"""Formulas as people read them: the small expression tree that is handed out.

Angle algebra (``angle``, ``product``, ``laurent``) computes; a :data:`Formula` is what
is then printed, sent to sympy or put into a straight-line program. It is never
rewritten behind its maker's back: what is built is what is printed.

Quantities are SI; angles are radians. A constant angle is a rational multiple of
:data:`PI`, so that a printer can write 40° exactly.

>>> from .to_text import text
>>> a, b, alpha = Symbol("a"), Symbol("b"), Symbol("alpha")
>>> k = product([(Number(Fraction(2)), 1), (b, 1), (a, -1), (Call("cot", (alpha,)), 1)])
>>> text(k)
'2*b*cot(alpha)/a'
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import prod
from typing import TypeGuard

from ..base.frozen import Hashed, frozen


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
class Constant(Symbol):
    """A number of the description under a name: printed as a symbol, but open in nothing."""

    value: "Formula"

    def __hash__(self) -> int:
        """Return the hash of the name, which no other value has: that of a fraction is dear."""
        return hash(self.name)


class Compound(Hashed):
    """A formula of parts; the names in it, and its length, are kept with it once they are known."""

    __slots__ = ("names_in_it", "operations_in_it")
    names_in_it: frozenset[str]
    operations_in_it: int


@frozen
class Sum(Compound):
    """Two or more terms; a subtracted term is a Product with a negative leading Number."""

    terms: tuple["Formula", ...]


@frozen
class Product(Compound):
    """Two or more factors in reading order; a divisor is a Power with a negative exponent."""

    factors: tuple["Formula", ...]


@frozen
class Power(Compound):
    """``base ** exponent``."""

    base: "Formula"
    exponent: "Formula"


@frozen
class Call(Compound):
    """One of :data:`~.functions.FUNCTIONS` applied to its arguments."""

    function: str
    arguments: tuple["Formula", ...]


def is_call(formula: object, *functions: str) -> TypeGuard[Call]:
    """Return whether a formula is one of some functions of its arguments.

    >>> is_call(Call("sign", (Symbol("k"),)), "sign"), is_call(Symbol("k"), "sign", "sense")
    (True, False)
    """
    return isinstance(formula, Call) and formula.function in functions


@frozen
class System:
    """Equations ``= 0`` in unknowns and outer symbols: a loop that no triangles close.

    ``anchor`` has the outer symbols and their values where the way begins, such as those at
    the default pose; None for what stays the same all along it. ``start`` are the unknowns
    there: numbers, or outer symbols that stay the same. Of several solutions they mark the
    branch that is meant. Both kinds of names are bound, as a function's arguments are; what
    outer symbols stand for in a formula is shown by the :class:`Implicit` that mentions the
    system. ``by_arcs``: where steps to it become short it is followed by its arc length, so that
    the end of the branch, if it is one, is a fold that was found. ``turning`` are outer symbols
    that are known but for whole turns, as a direction by ``atan2`` is: the way leads to the
    value that turns bring nearest to the anchor, so that no cut of ``atan2`` is crossed on it.
    """

    unknowns: tuple[str, ...]
    equations: tuple["Formula", ...]
    anchor: tuple[tuple[str, float | None], ...]
    start: tuple[float | str, ...]
    by_arcs: bool = False
    turning: tuple[str, ...] = ()

    def __hash__(self) -> int:
        """Return the hash of the unknowns' names, which few other systems share.

        With friction the equations have as many terms as there are pairs squared, and the
        formula of every unknown mentions them all.
        """
        return hash(self.unknowns)


@frozen
class Implicit(Compound):
    """One unknown of a system's solution, where the outer symbols have these values.

    It is the solution that is reached from ``start`` when the outer symbols go from the
    anchor to ``arguments`` (in the anchor's order, ``turning`` ones but for whole turns) on a
    straight line; it has no value (NaN) where the branch ends on the way. :func:`implicit` makes
    one.
    """

    system: System
    index: int
    arguments: tuple["Formula", ...]

    def __hash__(self) -> int:
        """Return the hash of the unknown; all unknowns of a system have the same arguments."""
        return hash((self.system, self.index))


Formula = Number | Pi | Symbol | Sum | Product | Power | Call | Implicit

Definitions = Sequence[tuple[str, Formula]]
"""Names and what they stand for, each after those it needs."""

ZERO, HALF, ONE, PI = Number(Fraction(0)), Number(Fraction(1, 2)), Number(Fraction(1)), Pi()


KEPT_NUMBERS = 64
"""Whole numbers below this stand in formulas again and again, and fractions are dear to make."""

_WHOLE: dict[int, Number] = {}


def number(value: int | Fraction) -> Number:
    """Return an exact number; of small whole ones there is one each."""
    if type(value) is not int or not -KEPT_NUMBERS < value < KEPT_NUMBERS:
        return Number(Fraction(value))
    if value not in _WHOLE:
        _WHOLE[value] = Number(Fraction(value))
    return _WHOLE[value]


def degrees(value: int | Fraction) -> Formula:
    """Return a constant angle given in degrees, as a rational multiple of π.

    >>> from .to_text import text
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
        elif not (isinstance(term, Number) and term.value == 0):
            flat.append(term)
    if not flat:
        return ZERO
    return flat[0] if len(flat) == 1 else Sum(tuple(flat))


def product(factors: Iterable[tuple[Formula, int]]) -> Formula:
    """Return the product of ``(factor, integer exponent)`` in the order given.

    Numbers are gathered into one leading coefficient; ``0`` and ``1`` disappear.
    """
    numbers: list[Fraction] = []
    rest: list[Formula] = []
    for factor, exponent in factors:
        if isinstance(factor, Number):
            numbers.append(factor.value if exponent == 1 else factor.value**exponent)
        elif exponent == 1 and isinstance(factor, Product):
            head, *tail = factor.factors
            if isinstance(head, Number):
                numbers.append(head.value)
                rest.extend(tail)
            else:
                rest.extend(factor.factors)
        elif exponent:
            rest.append(factor if exponent == 1 else power(factor, number(exponent)))
    coefficient = prod(numbers[1:], start=numbers[0]) if numbers else 1
    if coefficient == 0:
        return ZERO
    if coefficient != 1 or not rest:
        rest.insert(0, number(coefficient))
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


def implicit(system: System, index: int) -> Implicit:
    """Return an unknown of a system whose outer symbols stand for themselves."""
    return Implicit(system, index, tuple(Symbol(name) for name, _ in system.anchor))


def negative(formula: Formula) -> Formula:
    """Return ``-formula``; a sum is negated term by term."""
    if isinstance(formula, Sum):
        return Sum(tuple(negative(t) for t in formula.terms))
    return product([(number(-1), 1), (formula, 1)])


def quotient(above: Formula, below: Formula) -> Formula:
    """Return ``above / below``."""
    return product([(above, 1), (below, -1)])


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
