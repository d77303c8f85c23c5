r"""Numbers, quantities with the user's unit, and directions, as LaTeX.

>>> from ...formula.tree import degrees, number
>>> from ...units import ANGLE, LENGTH
>>> from ..languages.en import LOCALE
>>> from .notation import notation
>>> quantity(number(Fraction(1, 10)), LENGTH, "mm", LOCALE, notation("en"))
'100\\,\\text{mm}'
>>> quantity(degrees(Fraction(25, 2)), ANGLE, "deg", LOCALE, notation("ru"))
'12{,}5^\\circ'
"""

from fractions import Fraction

from ...formula.evaluate import evaluate
from ...formula.layout import in_degrees
from ...formula.tree import ZERO, Constant, Formula, Number, Sum, negative, total
from ...model.mechanism import Absolute, AlongLine, Direction
from ...units import ANGLE, DEGREES, LENGTH, UNITS, Dimension, si_unit, size_of, small_angle
from ...units import in_unit as text_in_unit
from ..digits import VALUE_DIGITS
from ..languages.locale import Locale
from ..put_in import in_degrees as rounded
from .notation import LatexNotation, points
from .printer import latex, scientific
from .unit_symbols import UnitLetters, unit_symbol


def quantity(
    value: Formula, dimension: Dimension, unit: str, locale: Locale, style: LatexNotation
) -> str:
    """Return a constant, given in SI, in a unit (the SI unit when none was written)."""
    chosen = unit or usual_unit(dimension)
    size = _in_unit(value, chosen)
    figures = _degrees(size, style) if chosen in DEGREES else decimal(size, style)
    return figures + unit_symbol(chosen, locale)


def length_of(formula: Formula, locale: Locale, style: LatexNotation, unit: str = "") -> str:
    r"""Return a length; a number, also one that is added, with its unit: metre unless one is named.

    >>> from ...formula.tree import Symbol
    >>> from ..languages.registry import locale
    >>> from .notation import notation
    >>> by = total([Symbol("e"), Number(Fraction(-1, 250))])
    >>> length_of(by, locale("en"), notation("en"), "mm")
    'e-4\\,\\text{mm}'
    """
    match formula:
        case Number() if formula != ZERO:
            return quantity(formula, LENGTH, unit, locale, style)
        case Sum(terms):
            return latex(total(_with_unit(term, unit or "m") for term in terms), style)
        case _:
            return latex(formula, style)


def _with_unit(term: Formula, unit: str) -> Formula:
    """Return a length that is added; a number as one in its unit."""
    if not isinstance(term, Number):
        return term
    size = Number(abs(term.value))
    shown = Constant(text_in_unit(float(size.value), unit, VALUE_DIGITS), size)
    return shown if term.value > 0 else negative(shown)


def measured(value: float, dimension: Dimension, locale: Locale, style: LatexNotation) -> str:
    """Return a computed value, given in SI, in the usual unit of its dimension."""
    return in_unit(value, usual_unit(dimension), locale, style)


def in_unit(value: float, unit: str, words: UnitLetters, style: LatexNotation) -> str:
    """Return a computed value, given in SI, in a unit; degrees as :func:`rounded` has them."""
    if unit == "deg":
        turn = in_degrees(rounded(value, VALUE_DIGITS))
        return _degrees(turn or 0, style, VALUE_DIGITS + 1) + unit_symbol(unit, words)
    return decimal(value / size_of(unit), style) + unit_symbol(unit, words)


_USUAL = {ANGLE: "deg", UNITS["rad/s"].dimension: "rad/s"}
"""Units that people read instead of those of SI."""


def usual_unit(dimension: Dimension) -> str:
    """Return degrees for an angle, else the SI unit, made of base units where it has no name."""
    return _USUAL.get(dimension, si_unit(dimension))


def _in_unit(value: Formula, unit: str) -> Fraction | float:
    known = UNITS.get(unit)
    turn = in_degrees(value)
    if known is not None and known.pi and turn is not None:
        return turn / 180 / known.factor
    if isinstance(value, Number) and not (known and known.pi):
        return value.value / known.factor if known else value.value
    return evaluate(value, {}) / size_of(unit)


def decimal(value: Fraction | float, style: LatexNotation, figures: int = VALUE_DIGITS) -> str:
    r"""Return a number to so many significant digits, with the language's decimal sign.

    >>> from .notation import notation
    >>> decimal(2.5e-16, notation("uk"))
    '2{,}5\\cdot 10^{-16}'
    """
    return scientific(f"{float(value):.{figures}g}", style)


def in_a_line(shown: str) -> str:
    r"""Return a number within a sentence, with its power of ten on the same line.

    >>> in_a_line(r"2{,}5\cdot 10^{-16}"), in_a_line("2{,}5")
    ('${2{,}5\\cdot 10^{-16}}$', '$2{,}5$')
    """
    return f"${{{shown}}}$" if r"\cdot" in shown else f"${shown}$"


def _degrees(value: Fraction | float, style: LatexNotation, figures: int = VALUE_DIGITS) -> str:
    """Return a number of degrees; that of a small angle has no power of ten."""
    return scientific(small_angle(f"{float(value):.{figures}g}"), style)


def math(tex: str) -> str:
    """Return inline mathematics."""
    return f"${tex}$"


def spaced(cell: str) -> str:
    r"""Return a cell of a table with room about its fractions, so that those of two rows part.

    >>> spaced("$a$"), spaced(r"$\frac{a}{2}$")
    ('$a$', '\\rule[-1.4ex]{0pt}{4.2ex}$\\frac{a}{2}$')
    """
    return rf"\rule[-1.4ex]{{0pt}}{{4.2ex}}{cell}" if r"\frac" in cell else cell


def direction(given: Direction, style: LatexNotation) -> str:
    r"""Return a direction as mathematics: an angle, or that of a vector, turned or not."""
    if isinstance(given, Absolute):
        return r"0^\circ" if given.angle == ZERO else latex(given.angle, style, angle=True)
    vector = _vector(given)
    return rf"{vector}+90^\circ" if given.quarter % 2 else rf"\parallel {vector}"


def _vector(given: AlongLine) -> str:
    """Return the vector that a direction is that of, or is turned from by a quarter."""
    ends = (given.tail, given.head) if given.quarter < 2 else (given.head, given.tail)
    return rf"\overrightarrow{{{''.join(map(points, ends))}}}"


def spoken(given: Direction, locale: Locale, style: LatexNotation) -> str:
    """Return a direction as sentences say it, in words where the language has some."""
    if isinstance(given, Absolute):
        return locale.directions["absolute"].format(angle=math(direction(given, style)))
    kind = "turned" if given.quarter % 2 else "relative"
    return locale.directions[kind].format(angle=math(_vector(given)))
