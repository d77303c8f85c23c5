"""How a formula is set on paper, before any printer chooses its signs.

A force transmission reads as an engineer writes it: the ratio of the arms first, the
factor of the angles behind it, ``2b/a · cos α sin θ / cos(α + θ)``. Constant angles
stand in degrees, and the decimal that leads a quotient, as 2.5a divided by 5a makes it, is whole
numbers above the line and below it. All is decided here once, for LaTeX and for the terminal.
"""

import math
from collections.abc import Iterable, Set
from fractions import Fraction

from ..base.named import NamedTuple
from .names import split_name
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
    degrees,
    negative,
    number,
    power,
    product,
    split_fraction,
    total,
)
from .walk import children, rebuild

LEAST, LARGEST = 1e-4, 1e12
"""Within these bounds a float is printed without a power of ten."""

GLANCED = 10
"""Whole numbers up to this are read at a glance, above a line and below it."""

INVERSE = frozenset({"asin", "acos", "atan", "atan2"})
"""Functions whose value is an angle."""

TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})
"""Functions whose argument is an angle."""


class Fractions(NamedTuple):
    """A product as up to two fractions: lengths, loads and speeds first, then the rest.

    ``sign`` is +1 or -1. Each fraction is the factors above and below the line; a
    whole number leads its row. The second is ``((), ())`` when one fraction will do.
    """

    sign: int
    first: tuple[tuple[Formula, ...], tuple[Formula, ...]]
    second: tuple[tuple[Formula, ...], tuple[Formula, ...]] = ((), ())


def fractions(formula: Product) -> Fractions:
    """Return a product as the fractions to be set.

    The two are kept apart where each looks like a fraction of its own: ``b/a · cot α``
    but ``a cos α / 2``, ``V_A sin θ / cos(α + θ)`` as a speed times a fraction. A
    coefficient of friction μ leads each row, letters follow, velocities behind lengths, then sums
    of lengths, then functions:
    ``a V_B sin α``, not ``sin α V_B a``.

    >>> from .tree import product
    >>> a, b, t = Symbol("a"), Symbol("b"), Call("cot", (Symbol("t"),))
    >>> fractions(product([(b, 1), (a, -1), (t, 1)])).second == ((t,), ())
    True
    >>> fractions(product([(t, 1), (a, 1)])).first == ((a, t), ())
    True
    >>> load, mu = Symbol("W"), Symbol("mu")
    >>> fractions(product([(load, 1), (mu, 1)])).first == ((mu, load), ())
    True
    """
    coefficient, above, below = _flat(formula)
    above, below = (diameters_behind(sorted(row, key=_place)) for row in (above, below))
    upper = _numeral(abs(coefficient.numerator))
    lower = _numeral(coefficient.denominator)
    sign = -1 if coefficient < 0 else 1
    plain_up, rich_up = _split(above)
    plain_low, rich_low = _split(below)
    ratio = bool(plain_low and (plain_up or upper) and rich_up)
    speed = bool(plain_up and not plain_low and not lower and rich_up and rich_low)
    if ratio or speed:
        return Fractions(sign, (upper + plain_up, lower + plain_low), (rich_up, rich_low))
    return Fractions(sign, (upper + tuple(above), lower + tuple(below)))


def unstacked(whole: Fractions) -> tuple[Fractions, tuple[Formula, ...]]:
    """Return fractions without the sums of fractions above their lines, and these sums.

    What is left is one fraction: ``a/sin(mu) (1 + b/c)``.

    >>> from .tree import product, total
    >>> a, b, c, s = *map(Symbol, "abc"), Call("sin", (Symbol("mu"),))
    >>> stacked = total([a, product([(b, 1), (c, -1)])])
    >>> rest, sums = unstacked(fractions(product([(a, 1), (stacked, 1), (s, -1)])))
    >>> rest.first == ((a,), (s,)), sums == (stacked,)
    (True, True)
    """
    above = (*whole.first[0], *whole.second[0])
    below = (*whole.first[1], *whole.second[1])
    stacked = tuple(f for f in above if isinstance(f, Sum) and any(map(_has_line, f.terms)))
    if not below or not stacked:
        return whole, ()
    return Fractions(whole.sign, (tuple(f for f in above if f not in stacked), below)), stacked


def diameters_behind(factors: Iterable[Formula]) -> list[Formula]:
    """Return factors with each diameter behind its coefficient of friction: f·d, never d·f.

    >>> b, d, f, f_c, rest = map(Symbol, ("b", "d_O", "f", "f_c", "S"))
    >>> diameters_behind((b, d, f, f_c, rest)) == [b, f, f_c, d, rest]
    True
    """
    row = list(factors)
    for i in range(len(row) - 1):
        if letter_of(row[i]) == "d" and letter_of(row[i + 1]) in _COEFFICIENTS:
            row[i : i + 2] = row[i + 1], row[i]
    return row


_COEFFICIENTS = ("f", "mu")

SIZES = "dDrR"
"""Letters of diameters and radii: a coefficient of friction stands apart from them, ``f·r``."""

_VELOCITIES = ("V", "omega")


def letter_of(factor: Formula) -> str:
    """Return the letter of a factor that is a quantity, '' of others."""
    return split_name(factor.name).head if isinstance(factor, Symbol) else ""


def _has_line(term: Formula) -> bool:
    """Return whether a term is a fraction by more than a number, or has a sum of such."""
    if not isinstance(term, Product):
        return False
    sums = (factor for factor in term.factors if isinstance(factor, Sum))
    return bool(split_fraction(term)[2]) or any(_has_line(t) for s in sums for t in s.terms)


def _flat(formula: Product) -> tuple[Fraction, list[Formula], list[Formula]]:
    """Split a product, and the products below its line too."""
    coefficient, above, lower = split_fraction(formula)
    below: list[Formula] = []
    for factor in lower:
        if isinstance(factor, Product):
            inner, up, down = _flat(factor)
            coefficient /= inner
            below += up
            above += down
        else:
            below.append(factor)
    return coefficient, above, below


def _numeral(value: int) -> tuple[Formula, ...]:
    return (Number(Fraction(value)),) if value != 1 else ()


def _split(factors: list[Formula]) -> tuple[tuple[Formula, ...], tuple[Formula, ...]]:
    """Separate symbols, sums of them, and their powers from functions, keeping the order."""
    plain = tuple(f for f in factors if _is_plain(f))
    return plain, tuple(f for f in factors if not _is_plain(f))


def _is_plain(factor: Formula) -> bool:
    return _place(factor) < _FUNCTIONS


_NUMBERS, _COEFFICIENT, _LETTERS, _SPEEDS, _LENGTHS, _FUNCTIONS = range(6)


def _place(factor: Formula) -> int:
    """Return where a factor stands: ``mu``, ``a``, ``V_A``, ``(a + b)``, ``sin(alpha)``."""
    base = factor.base if isinstance(factor, Power) else factor
    if letter_of(base) == "mu":
        return _COEFFICIENT
    if letter_of(base) in _VELOCITIES:
        return _SPEEDS
    if isinstance(factor, Number) or isinstance(base, Pi):
        return _NUMBERS
    if isinstance(base, Number | Symbol):
        return _LETTERS
    return _FUNCTIONS if _has_function(base) else _LENGTHS


def _has_function(formula: Formula) -> bool:
    return isinstance(formula, Call | Implicit) or any(map(_has_function, children(formula)))


def in_degrees(formula: Formula) -> Fraction | None:
    """Return a rational multiple of π in degrees, None for anything else.

    >>> from .tree import degrees
    >>> in_degrees(degrees(40))
    Fraction(40, 1)
    """
    match formula:
        case Pi():
            return Fraction(180)
        case Product((Number(value), Pi())):
            return 180 * value
        case Number(value) if value == 0:
            return Fraction(0)
        case _:
            return None


def turned_to_degrees(angle: Formula) -> Formula:
    """Return an angle whose constant is in radians with that in degrees, to six decimals.

    >>> phi = Symbol("phi")
    >>> _, constant = turned_to_degrees(total([phi, Number(Fraction(1, 5))])).terms
    >>> float(in_degrees(constant)), turned_to_degrees(phi) == phi
    (11.459156, True)
    """
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    radians = [term.value for term in terms if isinstance(term, Number) and term.value]
    if not radians:
        return angle
    others = [term for term in terms if in_degrees(term) is None and not isinstance(term, Number)]
    exact = sum(size for term in terms if (size := in_degrees(term)) is not None)
    turn = math.degrees(sum(radians)) + float(exact)
    constant = degrees(Fraction(f"{turn:.{DECIMALS}f}"))
    is_led = bool(others) and not all(map(has_minus, others))
    return total([*others, constant] if is_led else [constant, *others])


def multiple_of_sum(angle: Formula) -> Formula:
    """Return an angle of which each term is so many times a name as so many times their sum.

    >>> from .to_text import text
    >>> from .tree import product
    >>> one, other = (product([(number(2), 1), (Symbol(name), 1)]) for name in ("phi", "mu_B"))
    >>> text(multiple_of_sum(total([one, negative(other)]))), text(multiple_of_sum(one))
    ('2*(phi - mu_B)', '2*phi')
    >>> text(multiple_of_sum(total([negative(one), negative(other)])))
    '-2*(phi + mu_B)'
    """
    sizes = [_multiple(t) for t in angle.terms] if isinstance(angle, Sum) else [1]
    if len({*sizes}) > 1 or sizes[0] == 1 or not isinstance(angle, Sum):
        return angle
    times = -sizes[0] if all(map(has_minus, angle.terms)) else sizes[0]
    once = [product([(number(Fraction(1, times)), 1), (term, 1)]) for term in angle.terms]
    return Product((number(times), Sum(tuple(once))))


def _multiple(term: Formula) -> int:
    """Return how many times a name stands in a term, 1 of what is no whole multiple of one."""
    match term:
        case Product((Number(value), Symbol())) if value.denominator == 1:
            return abs(value.numerator)
        case _:
            return 1


DECIMALS = 6
"""Decimals of an angle in degrees that is given in radians.

With fewer, a formula read off a page near a dead centre would miss the value printed with it.
"""


def is_angle(formula: Formula, angles: Set[str]) -> bool:
    """Return whether a formula is an angle, given the names that are.

    Angle is a dimension in sums only; in products it is a number, so that ``r·phi`` is
    a length and ``2·phi`` an angle.
    """
    match formula:
        case Symbol(name):
            return name in angles or name.startswith("phi_")
        case Sum(terms):
            return any(is_angle(t, angles) for t in terms)
        case Product((Number(), factor)):
            return is_angle(factor, angles)
        case Call(function, arguments):
            passes = function in {"abs", "min", "max"}
            return function in INVERSE or (passes and any(is_angle(a, angles) for a in arguments))
        case Implicit(system, index, _):
            return is_angle(Symbol(system.unknowns[index]), angles)
        case _:
            return False


def squares(arguments: Iterable[Formula]) -> Formula:
    """Return the sum of squares under the root that a hypotenuse is.

    >>> from .to_text import text
    >>> from .tree import negative, number
    >>> text(squares((negative(Symbol("x")), number(1))))
    'x^2 + 1'
    """
    return total(power(unsigned(a), Number(Fraction(2))) for a in arguments)


def unsigned(formula: Formula) -> Formula:
    """Return a formula with the same square, without a minus in front."""
    match formula:
        case Number(value):
            return Number(abs(value))
        case Product((Number(value), *_)) if value < 0:
            return negative(formula)
        case _:
            return formula


def short_decimal(value: Fraction) -> str | None:
    """Return a decimal that is exact and reads better than the fraction, else None.

    Halves, quarters and so on stay fractions, as in ``pi*d^4/64``; at most six decimals.

    >>> short_decimal(Fraction(98, 10)), short_decimal(Fraction(1, 64))
    ('9.8', None)
    """
    return None if value.denominator in {1, 2, 4, 8, 16, 32, 64} else decimal(value)


MOST_FRACTION_DIGITS = 12
"""Digits of a fraction, above and below the line, beyond which it is given as a decimal."""


def decimal(value: Fraction) -> str | None:
    """Return a decimal that is exact in six digits behind the point, else None.

    One by tens is exact in twelve, and a fraction longer than anybody reads is rounded to twelve.

    >>> decimal(Fraction(45, 2)), decimal(Fraction(10)), decimal(Fraction(1, 3))
    ('22.5', '10', None)
    >>> decimal(Fraction(243549291, 250000000))
    '0.974197164'
    >>> decimal(Fraction(1567, 2000000)), decimal(Fraction(1, 128))
    ('0.0007835', None)
    """
    if is_long(value):
        return f"{float(value):.12g}"
    places = 6 if value.denominator % 10 else 12
    if 10**places % value.denominator:
        return None
    size = str(abs(value.numerator) * (10**places // value.denominator)).rjust(places + 1, "0")
    whole, decimals = size[:-places], size[-places:].rstrip("0")
    return f"{'-' if value < 0 else ''}{whole}{'.' if decimals else ''}{decimals}"


def is_long(value: Fraction) -> bool:
    """Return whether a fraction has more digits than anybody reads, and a float is as near.

    >>> is_long(Fraction(9806650, 1)), is_long(Fraction(243549291, 250000000))
    (False, True)
    """
    digits = len(str(abs(value.numerator))) + len(str(value.denominator))
    return (
        value.denominator != 1
        and digits > MOST_FRACTION_DIGITS
        and LEAST <= abs(float(value)) < LARGEST
    )


def has_minus(term: Formula) -> bool:
    """Return whether a term is printed with a minus in front."""
    match term:
        case Number(value) | Product((Number(value), *_)):
            return value < 0
        case _:
            return False


def over_line(formula: Formula) -> Formula:
    """Return a formula whose quotients have small whole numbers for a decimal.

    >>> from .to_text import text
    >>> from fractions import Fraction
    >>> from .tree import Call, Symbol, product
    >>> sines = [(Call("sin", (Symbol("b"),)), 1), (Call("sin", (Symbol("c"),)), -1)]
    >>> [text(over_line(product([(number(Fraction(n, 5)), 1), *sines]))) for n in (1, 2)]
    ['sin(b)/(5*sin(c))', '2*sin(b)/(5*sin(c))']
    """
    parts = tuple(map(over_line, children(formula)))
    whole = rebuild(formula, parts) if parts != children(formula) else formula
    match whole:
        case Product((Number(value), *rest)) if any(map(_divides, rest)):
            above, below = value.numerator, value.denominator
            if below in (5, 10) and abs(above) < GLANCED:
                lead = () if above == 1 else (number(above),)
                return Product((*lead, Power(number(below), number(-1)), *rest))
    return whole


def _divides(factor: Formula) -> bool:
    """Return whether a factor stands below the line."""
    match factor:
        case Power(_, Number(value)):
            return value < 0
    return False
