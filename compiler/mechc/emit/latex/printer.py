r"""Formulas as LaTeX, as a textbook would set them.

Arms as one fraction and angles as another, ``\cos\alpha`` without parentheses,
constant angles in degrees. Every piece is a :class:`Box` that knows how wide it will
be, so that ``latex_display`` can break what no line would hold.

>>> from ...formula.tree import Symbol, quotient, number, product
>>> from .notation import notation
>>> a, b, alpha = Symbol("a"), Symbol("b"), Symbol("alpha")
>>> k = product([(number(2), 1), (b, 1), (a, -1), (Call("cot", (alpha,)), 1)])
>>> print(latex(k, notation("en")))
\frac{2b}{a}\cot\alpha
>>> print(latex(k, notation("uk")))
\frac{2b}{a}\operatorname{ctg}\alpha
"""

import re
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple, assert_never

from ...formula.layout import (
    TRIGONOMETRIC,
    decimal,
    fractions,
    in_degrees,
    is_angle,
    short_decimal,
    squares,
)
from ...formula.tree import (
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    number,
    power,
)
from ...formula.walk import equations
from .notation import Notation, name

SUM, FACTOR, BASE = 0, 1, 2
"""What stands around a formula: nothing or a sum, a product, a power."""

EM_PER_GLYPH = 0.58
"""Mean width of an italic letter with its share of space, in em of the text font."""


class Box(NamedTuple):
    """A piece of mathematics: its LaTeX, its estimated width in em, whether it is tall.

    ``open`` is True for a function with a bare argument and for a distance ``OA``, behind
    which a letter would be read as part of them.
    """

    tex: str
    width: float
    tall: bool = False
    open: bool = False


def latex(formula: Formula, style: Notation, angle: bool = False) -> str:
    """Return a formula as LaTeX mathematics, without delimiters."""
    return box(formula, style, angle).tex


def box(formula: Formula, style: Notation, angle: bool = False) -> Box:
    """Set a formula; one that is an angle, or is said to be one, has constants in degrees."""
    return _set(formula, style, SUM, angle or is_angle(formula, style.angles))


def plain(tex: str, tall: bool = False) -> Box:
    r"""Return a box for ready LaTeX, its width counted from what will be seen.

    >>> round(plain(r"\cos\alpha").width, 2)
    2.32
    """
    words = re.sub(r"\\(?:sin|cos|tan|cot|sec|csc|ln|min|max|exp)(?![a-z])", "xxx", tex)
    words = re.sub(r"\\(?:operatorname|mathrm|mathit|left|right|,)", "", words)
    words = re.sub(r"\\arc([a-z]+)", r"arc\1", words)
    glyphs = re.sub(r"[{}_^]", "", re.sub(r"\\[A-Za-z]+", "x", words))
    return Box(tex, EM_PER_GLYPH * len(glyphs), tall)


def row(boxes: Iterable[Box]) -> Box:
    """Return boxes side by side."""
    parts = tuple(boxes)
    tex = ""
    for part in parts:
        glued = re.search(r"\\[A-Za-z]+$", tex) and re.match("[A-Za-z]", part.tex)
        tex += (" " if glued else "") + part.tex
    is_open = bool(parts) and parts[-1].open
    return Box(tex, sum(p.width for p in parts), any(p.tall for p in parts), is_open)


def parentheses(inner: Box) -> Box:
    """Return a box in parentheses of its own height."""
    left, right = (r"\left(", r"\right)") if inner.tall else ("(", ")")
    return Box(left + inner.tex + right, inner.width + 0.9, inner.tall)


def _set(formula: Formula, style: Notation, around: int, angle: bool) -> Box:
    constant = in_degrees(formula) if angle else None
    if constant is not None and formula != number(0):
        return _degrees(constant, style, around)
    match formula:
        case Number(value):
            return _number(value, style, around)
        case Pi():
            return plain(r"\pi")
        case Symbol(symbol):
            return plain(name(symbol, style))._replace(open=symbol.startswith("len_"))
        case Sum(terms):
            joined = row(signed(t, style, i == 0, angle) for i, t in enumerate(terms))
            return parentheses(joined) if around else joined
        case Product():
            return _product(formula, style, around, angle)
        case Power(base, exponent):
            return _power(base, exponent, style, around)
        case Call(function, arguments):
            return _call(function, arguments, style)
        case Implicit(system, index, _):
            return parentheses(_solution(system.unknowns[index], equations(formula), style))
        case _:
            assert_never(formula)


def _solution(unknown: str, zeros: Iterable[Formula], style: Notation) -> Box:
    """Set an unknown and its equations in a row; where they are defined they have lines."""
    lines = [row((_set(zero, style, SUM, False), plain("=0"))) for zero in zeros]
    rest = (row((plain(r",\;"), line)) for line in lines[1:])
    return row((plain(name(unknown, style) + r":\;"), lines[0], *rest))


def signed(term: Formula, style: Notation, first: bool, angle: bool = False) -> Box:
    """Return a term of a sum with the sign that joins it to what stands before."""
    inner = _set(term, style, SUM, angle)
    if first or inner.tex.startswith("-"):
        return inner
    return inner._replace(tex="+" + inner.tex, width=inner.width + 1.2)


def _degrees(value: Fraction, style: Notation, around: int) -> Box:
    figures = decimal(value)
    inner = plain(figures.replace(".", style.decimal)) if figures else _number(value, style, SUM)
    ends = inner.tex.find("}") if inner.tall else len(inner.tex)
    whole = rf"{inner.tex[:ends]}^\circ{inner.tex[ends:]}"
    marked = inner._replace(tex=whole, width=inner.width + 0.4)
    return parentheses(marked) if value < 0 and around else marked


def _number(value: Fraction, style: Notation, around: int) -> Box:
    decimal = short_decimal(value)
    if decimal is not None:
        inner = plain(decimal.replace(".", style.decimal))
    elif value.denominator == 1:
        inner = plain(str(value))
    else:
        sign = "-" if value < 0 else ""
        inner = plain(rf"{sign}\frac{{{abs(value.numerator)}}}{{{value.denominator}}}", tall=True)
    needed = (value < 0 and around) or (around == BASE and inner.tall)
    return parentheses(inner) if needed else inner


def _product(formula: Product, style: Notation, around: int, angle: bool) -> Box:
    whole = _as_decimal(formula, style, angle) or _as_fractions(formula, style, angle)
    closed = around == BASE or (around == FACTOR and whole.tex.startswith("-"))
    return parentheses(whole) if closed else whole


def _as_decimal(formula: Product, style: Notation, angle: bool) -> Box | None:
    """Set a product that a short decimal leads, ``0.3 a cos α``; None for any other."""
    match formula.factors:
        case (Number(value), *rest) if short_decimal(value) is not None:
            lead = _number(value, style, SUM)
            tail = _product(Product(tuple(rest)), style, FACTOR, angle)
            dot = r"\cdot " if tail.tex[0].isdigit() else r"\,"
            return row((lead, plain(dot), tail))
        case _:
            return None


def _as_fractions(formula: Product, style: Notation, angle: bool) -> Box:
    sign, first, second = fractions(formula)
    parts = [fraction(*first, style, angle)]
    if second != ((), ()):
        follows = fraction(*second, style, angle)
        both = parts[0].tall and follows.tall
        parts += [plain(r"\cdot" if both else r"\," if follows.tall else ""), follows]
    minus = (plain("-"),) if sign < 0 else ()
    return row((*minus, *parts))


def fraction(
    above: tuple[Formula, ...], below: tuple[Formula, ...], style: Notation, angle: bool = False
) -> Box:
    """Return the factors above and below one line, or side by side when nothing is below."""
    if not below:
        return factors(above, style, angle, FACTOR)
    top = factors(above, style, angle)
    bottom = factors(below, style, angle)
    tex = rf"\frac{{{top.tex}}}{{{bottom.tex}}}"
    return Box(tex, max(top.width, bottom.width) + 0.3, tall=True)


def factors(
    formulas: tuple[Formula, ...], style: Notation, angle: bool = False, single: int = SUM
) -> Box:
    """Return factors side by side, with a dot where they would run together.

    ``single`` is what stands around a factor that is alone.
    """
    if not formulas:
        return plain("1")
    around = FACTOR if len(formulas) > 1 else single
    boxes: list[Box] = []
    for formula in formulas:
        current = _set(formula, style, around, angle)
        if boxes and _runs_together(boxes[-1], formula, current):
            boxes.append(plain(r"\cdot "))
        elif boxes and _are_words(boxes[-1], current):
            boxes.append(plain(r"\,"))
        boxes.append(current)
    return row(boxes)


def _runs_together(before: Box, formula: Formula, after: Box) -> bool:
    is_function = isinstance(formula, Call) and not after.tex.startswith(("(", r"\left"))
    raised = isinstance(formula, Power) and isinstance(formula.base, Call)
    return (before.open and not (is_function or raised)) or (
        before.tex[-1].isdigit() and after.tex[0].isdigit()
    )


def _are_words(before: Box, after: Box) -> bool:
    """Tell whether a name of several letters would be read as one with the next letter."""
    words = (re.match(r"\\math(rm|it)", box.tex) for box in (before, after))
    return any(words) and before.tex[-1] not in ")]" and after.tex[0] not in "(["


def _power(base: Formula, exponent: Formula, style: Notation, around: int) -> Box:
    match base, exponent:
        case _, Number(value) if value < 0:
            return fraction((), (power(base, Number(-value)),), style)
        case _, Number(value) if value == Fraction(1, 2):
            return _root(_set(base, style, SUM, False))
        case Call(function, (argument,)), Number(value) if (
            function in TRIGONOMETRIC and value.denominator == 1
        ):
            return _applied(f"{style.functions[function]}^{{{value}}}", argument, style)
    raised = _set(exponent, style, SUM, False)
    inner = _set(base, style, BASE, False)
    if isinstance(base, Power | Call) and not inner.tex.startswith(r"\left|"):
        inner = parentheses(inner)
    whole = Box(f"{inner.tex}^{{{raised.tex}}}", inner.width + 0.7 * raised.width, inner.tall)
    return parentheses(whole) if around == BASE else whole


def _root(inner: Box) -> Box:
    return Box(rf"\sqrt{{{inner.tex}}}", inner.width + 0.9, tall=True)


def _call(function: str, arguments: tuple[Formula, ...], style: Notation) -> Box:
    match function:
        case "sqrt":
            return _root(_set(arguments[0], style, SUM, False))
        case "hypot":
            return _root(_set(squares(arguments), style, SUM, False))
        case "abs":
            inner = box(arguments[0], style)
            return Box(rf"\left|{inner.tex}\right|", inner.width + 0.6, inner.tall)
        case _ if len(arguments) == 1:
            return _applied(style.functions[function], arguments[0], style)
    inner = row(
        Box(("," if i else "") + (part := box(a, style)).tex, part.width + 0.5, part.tall)
        for i, a in enumerate(arguments)
    )
    return row((plain(style.functions[function]), parentheses(inner)))


def _applied(function: str, argument: Formula, style: Notation) -> Box:
    """Set a function of one argument, without parentheses where none are needed."""
    angle = function.partition("^")[0] in {style.functions[f] for f in TRIGONOMETRIC}
    inner = _set(argument, style, SUM, angle)
    if inner.tall or not _is_bare(argument, angle):
        return row((plain(function), parentheses(inner)))
    return row((plain(function), inner))._replace(open=True)


def _is_bare(argument: Formula, angle: bool) -> bool:
    match argument:
        case Symbol() | Pi():
            return True
        case Number(value):
            return value >= 0
        case Product((Number(value), Symbol())):
            return value > 0 and value.denominator == 1
        case _:
            constant = in_degrees(argument) if angle else None
            return constant is not None and constant >= 0
