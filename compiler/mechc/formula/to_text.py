"""Formulas in the notation of the language."""

from fractions import Fraction
from functools import reduce
from typing import assert_never

from . import choices
from .evaluate import equations
from .layout import TRIGONOMETRIC, decimal, diameters_behind, in_degrees, is_long
from .tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    degrees,
    is_call,
    negative,
    number,
    power,
    split_fraction,
    total,
)
from .walk import children, rebuild


def text(formula: Formula) -> str:
    """Return the formula in the notation of the language (``^`` for powers).

    >>> from .tree import number, product, total
    >>> x = Symbol("x")
    >>> text(total([x, product([(number(-2), 1), (Call("sin", (x,)), 1)])]))
    'x - 2*sin(x)'
    """
    return _solution(formula) if isinstance(formula, Implicit) else _text(formula, 0)


def text_in_degrees(formula: Formula) -> str:
    """Return the formula in the notation of the language, constant angles in degrees.

    These are what a sine or cosine is of, and the constants of a sum.

    >>> from .tree import negative, total
    >>> half_turn, phi = Pi(), Symbol("phi")
    >>> text_in_degrees(Call("cos", (total([phi, negative(degrees(Fraction(29, 2)))]),)))
    'cos(phi - 14.5 deg)'
    >>> text_in_degrees(total([phi, half_turn])), text_in_degrees(power(half_turn, number(-1)))
    ('phi + 180 deg', '1/pi')
    >>> text_in_degrees(Call("sin", (total([phi, negative(number(Fraction(6, 5)))]),)))
    'sin(phi - 1.2 rad)'
    """
    return text(_turned(formula) if isinstance(formula, Sum) else _with_degrees(formula))


def _with_degrees(formula: Formula) -> Formula:
    """Return a formula with the constants of its sines and cosines in degrees."""
    parts = tuple(map(_with_degrees, children(formula)))
    match formula:
        case Call(function, (argument,)) if function in TRIGONOMETRIC and formula not in _ROOTS:
            return Call(function, (_turned(_with_radians(argument)),))
        case Call() if formula in _ROOTS:
            return formula
        case _:
            return rebuild(formula, parts) if parts else formula


def _with_radians(angle: Formula) -> Formula:
    """Return an angle whose constant in radians has that unit."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    return total(_radians(t) if isinstance(t, Number) and t.value else t for t in terms)


def _radians(size: Number) -> Formula:
    figures = decimal(abs(size.value)) or text(Number(abs(size.value)))
    shown = Constant(f"{figures} rad", Number(abs(size.value)))
    return negative(shown) if size.value < 0 else shown


def _turned(angle: Formula) -> Formula:
    """Return an angle with its constant in degrees."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    return total(map(_constant_turn, terms))


def _constant_turn(term: Formula) -> Formula:
    """Return a constant angle in degrees, any other as it is."""
    turn = in_degrees(term)
    figures = decimal(abs(turn)) if turn else None
    if not turn or figures is None:
        return _with_degrees(term)
    size = Constant(f"{figures} deg", degrees(abs(turn)))
    return negative(size) if turn < 0 else size


def _text(formula: Formula, level: int) -> str:
    """Print; ``level`` is 0 in a sum, 1 in a product, 2 under a power or a division."""
    match formula:
        case Number(value):
            plain = repr(float(value)) if is_long(value) else str(value)
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
        case Call(_, (Product(),)) if formula in _ROOTS:
            return _product_text(Product((formula,)), level)
        case Call(function, arguments) if function in choices.IN_WORDS:
            chosen = _choice(function, [_figures(a) for a in arguments])
            return f"({chosen})" if level else chosen
        case Call(function, arguments):
            return f"{function}({', '.join(_text(a, 0) for a in arguments)})"
        case Implicit():
            return f"({_solution(formula)})"
        case _:
            assert_never(formula)


def _figures(formula: Formula) -> str:
    """Print a part of a choice, table or list; a number alone as a decimal, a choice in brackets.

    >>> from .tree import number
    >>> text(Call("next", (Symbol("d"), number(Fraction(63, 1000)), number(2))))
    'next d in list(0.063, 2)'
    """
    shown = decimal(formula.value) if isinstance(formula, Number) else None
    return shown or _text(formula, 1 if is_call(formula, "choose") else 0)


def _solution(formula: Implicit) -> str:
    zeros = ", ".join(f"{_text(e, 0)} = 0" for e in equations(formula))
    return f"solution of ({zeros}) for {formula.system.unknowns[formula.index]}"


def _choice(function: str, parts: list[str]) -> str:
    """Return a condition, a choice, or a value of a table or list, in the language's words."""
    match function, parts:
        case "choose", _:
            pairs = zip(parts[1::2], parts[::2], strict=False)
            cases = ", ".join(f"{value} when {condition}" for value, condition in pairs)
            return f"{cases} else {parts[-1]}" if len(parts) % 2 else cases
        case "both", _:
            return " and ".join(parts)
        case "interpolate", [x, *rows]:
            pairs = zip(rows[::2], rows[1::2], strict=True)
            return f"table({', '.join(f'{a}: {value}' for a, value in pairs)}) at {x}"
        case "row", [x, *rows]:
            pairs = zip(rows[::2], rows[1::2], strict=True)
            return f"table({', '.join(f'{a}: {value}' for a, value in pairs)}) at exactly {x}"
        case "met", [x, *rows]:
            return f"row({', '.join(rows)}) at {x}"
        case "next", [least, *sizes]:
            return f"next {least} in list({', '.join(sizes)})"
        case "count", _:
            return f"count({', '.join(parts)})"
    return f" {choices.SIGNS[function]} ".join(parts)


_ROOTS = {
    Call(function, (degrees(angle),)): Call("sqrt", (number(square),))
    for function, angle, square in (("sin", 45, 2), ("cos", 45, 2), ("sin", 60, 3), ("cos", 30, 3))
}
"""Sines and cosines that are half a root of a whole number, and that root."""


def _with_roots(factors: list[Formula]) -> tuple[Fraction, list[Formula]]:
    """Return factors with known sines and cosines as roots, these first, and the number before all.

    >>> from .tree import product
    >>> text(product([(Symbol("a"), 1), (Call("cos", (degrees(45),)), 1)]))
    'sqrt(2)*a/2'
    """
    known = [f for f in factors if isinstance(f, Call) and f in _ROOTS]
    others = [f for f in factors if f not in known]
    return Fraction(1, 2 ** len(known)), [*(_ROOTS[f] for f in known), *others]


def _join(left: str, right: str) -> str:
    return f"{left} - {right[1:]}" if right.startswith("-") else f"{left} + {right}"


def _product_text(formula: Product, level: int) -> str:
    """Return a product on one line, ``2*a/(3*b)``; in brackets where ``level`` asks for them."""
    coefficient, above, below = split_fraction(formula)
    half, above = _with_roots(diameters_behind(above))
    double, below = _with_roots(diameters_behind(below))
    coefficient *= half / double
    upper = [_text(f, 1) for f in above]
    if is_long(coefficient):
        upper.insert(0, repr(abs(float(coefficient))))
        coefficient = Fraction(1 if coefficient > 0 else -1)
    elif abs(coefficient.numerator) != 1 or not upper:
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
