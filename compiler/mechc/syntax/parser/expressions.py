"""Nodes of expressions, directions and names from what the grammar matched.

The parser calls these while it reads, so that a sum of thousands of terms is one flat
node and no tree is walked afterwards.
"""

from fractions import Fraction
from typing import Any

from ...base.frozen import replace
from ...diagnostics import syntax, syntax_limits
from ...source import Span
from ...units import UNITS
from .. import ast, limits, text
from ..fault import Fault
from ..vocabulary import (
    CONSTANTS,
    FUNCTIONS,
    TWINS,
    apart,
    counted,
    in_capitals,
    of_used,
    points_of,
    split_quantity,
)
from . import unit_words
from .lalr import Token, span_of

SignedTerm = tuple[int, ast.Expr]


def number(token: Token) -> ast.Number:
    """Return the number that a token spells, with its unit."""
    digits, unit = split_quantity(token)
    return ast.Number(digits, unit, span_of(token))


def symbol(token: Token) -> ast.Symbol:
    """Return the symbol that a token spells."""
    return ast.Symbol(str(token), span_of(token))


def sum_of(first_sign: Token | None, *rest: ast.Expr | Token) -> ast.Expr:
    """Return the flat sum of ``[sign] term (sign term)*``."""
    terms = signed(first_sign, rest, minus="MINUS")
    match terms:
        case [(1, only)]:
            return only
    start = span_of(first_sign) if first_sign else terms[0][1].span
    span = start.to(terms[-1][1].span)
    return ast.Sum(tuple(flat(terms, ast.Sum)), span)


def product_of(*parts: ast.Expr | Token) -> ast.Expr:
    """Return the flat product of ``factor (sign factor)*``."""
    factors = signed(None, parts, minus="OVER")
    match factors:
        case [(1, only)]:
            return only
    span = factors[0][1].span.to(factors[-1][1].span)
    return ast.Product(tuple(flat(factors, ast.Product)), span)


def signed(first: Token | None, rest: tuple[ast.Expr | Token, ...], minus: str) -> list[SignedTerm]:
    """Pair each operand with +1, or with −1 where the operator before it is ``minus``."""
    found: list[SignedTerm] = []
    sign = -1 if first and first.type == minus else 1
    for part in rest:
        if isinstance(part, Token):
            sign = -1 if part.type == minus else 1
        else:
            found.append((sign, part))
    return found


def flat(parts: list[SignedTerm], kind: type[ast.Sum] | type[ast.Product]) -> list[SignedTerm]:
    """Take in the parts of a bracket that changes nothing: ``a + (b - c)``."""
    found: list[SignedTerm] = []
    for sign, part in parts:
        if sign == 1 and isinstance(part, kind):
            found.extend(part.terms if isinstance(part, ast.Sum) else part.factors)
        else:
            found.append((sign, part))
    return found


def negative(minus: Token, operand: ast.Expr) -> ast.Sum:
    """Return ``-operand``."""
    return ast.Sum(((-1, operand),), span_of(minus).to(operand.span))


def power(base: ast.Expr, exponent: ast.Expr) -> ast.Power:
    """Return ``base ^ exponent``; a large whole exponent is refused."""
    match exponent:
        case ast.Number(unit="") | ast.Sum(terms=((-1, ast.Number(unit="")),)):
            literal = exponent if isinstance(exponent, ast.Number) else exponent.terms[0][1]
            assert isinstance(literal, ast.Number)
            check_exponent(literal)
    return ast.Power(base, exponent, base.span.to(exponent.span))


def check_exponent(literal: ast.Number) -> None:
    """Refuse whole exponents beyond the limit; Fraction keeps ``64.0`` and ``6.4e1`` whole."""
    if Fraction(literal.digits) > limits.POWER:
        fault = syntax_limits.exponent_too_large(literal.span, literal.digits, limits.POWER)
        raise Fault(fault)


def call(name: Token, *rest: ast.Expr | Token) -> ast.Call:
    """Return the call of a function, by its canonical name."""
    function = TWINS.get(name, str(name))
    arguments = tuple(part for part in rest if not isinstance(part, Token))
    close = rest[-1]
    assert isinstance(close, Token)
    if function not in FUNCTIONS:
        raise Fault(syntax.unknown_function(span_of(name), str(name), [*FUNCTIONS, *TWINS]))
    arity = FUNCTIONS[function]
    span = span_of(name).to(span_of(close))
    if not arity.least <= len(arguments) <= (arity.most or len(arguments)):
        raise Fault(syntax.wrong_argument_count(span, str(name), len(arguments), counted(arity)))
    return ast.Call(function, arguments, span)


# ---------------------------------------------------------------------------- choices


def branch(value: ast.Expr, *conditions: tuple[Any, Any]) -> ast.Branch:
    """Return ``value when condition and condition``."""
    return ast.Branch(value, tuple(ast.Condition(*condition) for condition in conditions))


def choice(*parts: ast.Branch | ast.Expr | ast.Choice | None) -> ast.Choice:
    """Return ``value when condition, value when condition else value``."""
    branches = tuple(part for part in parts if isinstance(part, ast.Branch))
    last = parts[-1]
    otherwise = None if isinstance(last, ast.Branch) else last
    end = otherwise.span if otherwise else branches[-1].conditions[-1].operands[-1].span
    return ast.Choice(branches, otherwise, branches[0].value.span.to(end))


def lookup(table: Token, at: ast.Expr) -> ast.Lookup:
    """Return ``m49 at 2*r/d``."""
    span = span_of(table)
    return ast.Lookup(ast.Name(str(table), span), at, span.to(at.span))


def row_lookup(table: Token, at: ast.Expr) -> ast.Lookup:
    """Return ``pitches at exactly d``."""
    return replace(lookup(table, at), exactly=True)


def next_size(least: ast.Expr, sizes: ast.Name) -> ast.NextSize:
    """Return ``next d_min in pins``."""
    return ast.NextSize(least, sizes, least.span.to(sizes.span))


def unit(spelled: ast.Expr) -> ast.Name:
    """Return the unit that an expression of units spells."""
    name = text.bare(spelled).replace(" ", "")
    if name not in UNITS:
        plain = [known for known in UNITS if known.isalpha()]
        hint = unit_words.hint_of(name)
        raise Fault(syntax.unknown_unit(spelled.span, name, plain, hint, where=""))
    return ast.Name(name, spelled.span)


# ---------------------------------------------------------------------------- vectors


def direction_of(value: ast.Expr) -> ast.Direction:
    """Read ``x``, ``-x`` and ``-AB`` as directions: they come before parameters."""
    match value:
        case ast.Symbol(name=name):
            return bare_direction(name, 1, value.span) or value
        case ast.Sum(terms=((-1, ast.Symbol(name=name)),)):
            return bare_direction(name, -1, value.span) or value
        case _:
            return value


def bare_direction(name: str, sign: int, span: Span) -> ast.Direction | None:
    """Return the axis or the vector of this name, if it names one."""
    match name:
        case "x" | "y":
            return ast.Axis(name, sign, span)
    if len(points_of(of_used(name)[1])) != 2:
        return None
    start = span.end - len(name)
    return ast.Toward(ast.Name(name, Span(start, span.end)), sign, False, span)


def perpendicular(minus: Token | None, word: Token, rod: ast.Name) -> ast.Toward:
    """Return ``perp AB``, AB turned by +90 degrees, or its reverse."""
    span = span_of(minus or word).to(rod.span)
    return ast.Toward(rod, -1 if minus else 1, True, span)


def cartesian(left: Token, x: ast.Expr, y: ast.Expr, right: Token) -> ast.Cartesian:
    """Return ``(x, y)``."""
    return ast.Cartesian(x, y, span_of(left).to(span_of(right)))


def polar(
    length: ast.Expr, sign: Token | None = None, direction: ast.Direction | None = None
) -> ast.Polar:
    """Return ``length`` or ``length @ direction``."""
    return ast.Polar(length, direction, length.span.to((direction or length).span))


def bearing(sign: Token, direction: ast.Direction) -> ast.Polar:
    """Return ``@ direction``."""
    return ast.Polar(None, direction, span_of(sign).to(direction.span))


# ------------------------------------------------------------------------------ names


def new_name(text: str, span: Span) -> ast.Name:
    """Return a name that the user may give; functions and ``pi`` are taken."""
    if text in FUNCTIONS or text in TWINS or text in CONSTANTS:
        raise Fault(syntax.reserved_word(span, text))
    if "." in text:
        expected = "a name without a dot"
        raise Fault(syntax.not_a_name(span, text, expected))
    return ast.Name(text, span)


COUNTED = {
    "point": (1, 1, "a point"),
    "rod": (2, 2, "the two points of a vector or rod"),
    "corner": (3, 3, "three points, the corner in the middle"),
    "points": (2, None, "two or more points"),
    "body": (1, None, "the points of a body"),
}


def point_name(kind: str, text: str, span: Span) -> ast.Name:
    """Return a name made of points, as many as its kind wants."""
    least, most, expected = COUNTED[kind]
    found = len(points_of(of_used(text)[1]))
    if not found:
        hint = apart(text, kind == "point") or in_capitals(text)
        raise Fault(syntax.not_a_point(span, text, expected, hint))
    if found < least or (most and found > most):
        raise Fault(syntax.wrong_point_count(span, text, found, expected))
    return ast.Name(text, span)


def chain(*parts: ast.Expr | Token) -> tuple[tuple[ast.Expr, ...], tuple[str, ...]]:
    """Return operands and operators of ``a < b < c``."""
    operands = tuple(part for part in parts if not isinstance(part, Token))
    operators = tuple(str(part) for part in parts if isinstance(part, Token))
    return operands, operators
