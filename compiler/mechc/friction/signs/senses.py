"""The sense of a slip or a force: which way it goes, and whether it goes at all.

A slip that is zero at the values given (a guide square to a link) comes out as a rounding of
zero, of either sign. It has a sense where it is more than that against its size: what it would
be were every sine 1 and all terms of one sign. Page and code have no friction in a joint without a
sense, and nothing is said there of how a joint at rest may hold. Where a slip is zero for once
along the drive, that is the limit of neither side: the value at the default pose is taken from
:mod:`..at_rest`, that along a stroke from its sides.
"""

from collections.abc import Iterator
from fractions import Fraction

from ...algebra.factors import CIRCLE, ConstantSymbol, Factor, Opaque, Trig
from ...algebra.product import Product, Sum
from ...algebra.sums import BoundSum
from ...formula.tree import ONE, Call, Formula, number, product, total

POSITIVE = frozenset({"sqrt", "hypot", "abs", "exp"})
"""Functions that have no negative values."""


def sense_of(value: Product) -> Formula:
    """Return 1, -1, or 0 where nothing but rounding is left of a value.

    >>> from ...algebra.angle import Angle
    >>> from ...algebra.trigonometry import sine
    >>> from ...formula.to_text import text
    >>> text(sense_of(Product.symbol("a") * sine(Angle.of("t"))))
    'sense(a*sin(t), abs(a))'
    """
    odd = {f: e for f, e in value.factors.items() if e % 2 and not _is_positive(f)}
    sign = number(int(value.coefficient > 0) - int(value.coefficient < 0))
    if not odd:
        return sign
    signed = Product(1, dict.fromkeys(odd, 1)).formula()
    sizes = [(_size(f) if e > 0 else _absolute(f), 1) for f, e in odd.items()]
    return product([(sign, 1), (Call("sense", (signed, product(sizes))), 1)])


def size_of(value: Product) -> Formula:
    """Return the size of a value, were every sine 1, and all terms of sums of one sign."""
    sizes = ((_size(f) if e > 0 else _absolute(f), e) for f, e in value.factors.items())
    return product([(number(abs(Fraction(value.coefficient))), 1), *sizes])


def _size(factor: Factor) -> Formula:
    """Return a factor as large as it gets: a sine is 1, all terms of a sum have one sign."""
    match factor:
        case Trig():
            return ONE
        case Sum(terms=terms):
            return total(_alike(terms))
        case BoundSum(definition=definition):
            return size_of(definition)
        case _:
            return _absolute(factor)


def _alike(terms: tuple[Product, ...]) -> Iterator[Formula]:
    """Yield the sizes of terms, each once where several are alike."""
    sizes = [size_of(term) for term in terms]
    for size in dict.fromkeys(sizes):
        yield product([(number(sizes.count(size)), 1), (size, 1)])


def _absolute(factor: Factor) -> Formula:
    return factor.formula() if _is_positive(factor) else Call("abs", (factor.formula(),))


def _is_positive(factor: Factor) -> bool:
    """Return whether a factor is a given length, or a root or the like that never is negative."""
    match factor:
        case ConstantSymbol():
            return factor.evaluate({}) > 0
        case Opaque(Call(function)):
            return function in POSITIVE
        case _:
            return factor == CIRCLE
