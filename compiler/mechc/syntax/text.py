"""Expressions, directions and vectors as text, with no bracket that is not needed."""

from collections.abc import Iterable
from enum import IntEnum
from typing import assert_never

from ..units import behind
from . import ast


class Binds(IntEnum):
    """How tightly a node holds its parts together."""

    SUM = 0
    PRODUCT = 1
    POWER = 2
    ATOM = 3


def binding(node: ast.Expr) -> Binds:
    """Return how tightly a node binds; ``(5 mm)^2`` is not 5 mm²."""
    match node:
        case ast.Sum():
            return Binds.SUM
        case ast.Product():
            return Binds.PRODUCT
        case ast.Power():
            return Binds.POWER
        case ast.Number(unit=unit):
            return Binds.POWER if unit else Binds.ATOM
        case ast.Symbol() | ast.Call():
            return Binds.ATOM
        case _:
            assert_never(node)


def expression(node: ast.Expr, least: Binds = Binds.SUM) -> str:
    """Return the text of an expression, in brackets if it binds less than ``least``."""
    inside = bare(node)
    return inside if binding(node) >= least else f"({inside})"


def bare(node: ast.Expr) -> str:
    """Return the text of an expression without brackets around it."""
    match node:
        case ast.Number(digits=digits, unit=unit):
            return f"{digits}{behind(unit)}"
        case ast.Symbol(name=name):
            return name
        case ast.Sum(terms=terms):
            return sum_text(terms)
        case ast.Product(factors=factors):
            return product_text(factors)
        case ast.Power(base=base, exponent=exponent):
            return f"{expression(base, Binds.ATOM)}^{exponent_text(exponent)}"
        case ast.Call(function=function, arguments=arguments):
            return f"{function}({', '.join(map(expression, arguments))})"
        case _:
            assert_never(node)


def sum_text(terms: tuple[tuple[int, ast.Expr], ...]) -> str:
    """Return ``-a + b - c``."""
    (first_sign, first), *rest = terms
    parts = [("-" if first_sign < 0 else "") + expression(first, Binds.PRODUCT)]
    for sign, term in rest:
        parts.append("-" if sign < 0 else "+")
        parts.append(expression(term, Binds.PRODUCT))
    return " ".join(parts)


def product_text(factors: tuple[tuple[int, ast.Expr], ...]) -> str:
    """Return ``a*b/c``; with spaces where ``5 N*m`` would be read as a unit."""
    (first_sign, first), *rest = factors
    parts = ["1/" if first_sign < 0 else "", factor_text(first, first_sign)]
    apart = any(ends_in_unit(part) for _, part in factors[:-1])
    for sign, factor in rest:
        operator = "/" if sign < 0 else "*"
        parts.append(f" {operator} " if apart else operator)
        parts.append(factor_text(factor, sign))
    return "".join(parts)


def factor_text(factor: ast.Expr, sign: int) -> str:
    """Return a factor; ``F/(5 kN)`` says that the unit is that of the divisor."""
    is_measured = isinstance(factor, ast.Number) and bool(factor.unit)
    return expression(factor, Binds.ATOM if is_measured and sign < 0 else Binds.POWER)


def ends_in_unit(node: ast.Expr) -> bool:
    """Return whether a unit is the last word of a factor: of ``5 N``, and of ``a^5 N``, too."""
    match node:
        case ast.Number(unit=unit):
            return bool(unit)
        case ast.Power(exponent=ast.Sum(terms=((-1, exponent),)) | exponent):
            return ends_in_unit(exponent)
        case _:
            return False


def exponent_text(exponent: ast.Expr) -> str:
    """Return an exponent; ``a^-2`` needs no brackets."""
    match exponent:
        case ast.Sum(terms=((-1, operand),)) if binding(operand) >= Binds.POWER:
            return f"-{expression(operand)}"
        case _:
            return expression(exponent, Binds.POWER)


def direction(node: ast.Direction) -> str:
    """Return the text of a direction."""
    match node:
        case ast.Axis(axis=axis, sign=sign):
            return axis if sign > 0 else f"-{axis}"
        case ast.Toward(points=points, sign=sign, perp=perp):
            return f"{'-' if sign < 0 else ''}{'perp ' if perp else ''}{points.text}"
        case _:
            return expression(node)


def vector(node: ast.Polar | ast.Cartesian) -> str:
    """Return the text of a vector: ``length @ direction``, either alone, or ``(x, y)``."""
    match node:
        case ast.Cartesian(x=x, y=y):
            return f"({expression(x)}, {expression(y)})"
        case ast.Polar(length=length, direction=towards):
            left = [expression(length)] if length is not None else []
            right = ["@", direction(towards)] if towards is not None else []
            return " ".join(left + right)
        case _:
            assert_never(node)


def range_of(low: ast.Expr, high: ast.Expr) -> str:
    """Return ``low .. high``."""
    return f"{expression(low)} .. {expression(high)}"


def measure(value: ast.Expr, tolerance: ast.Expr | None) -> str:
    """Return ``value +- tolerance``."""
    within = f" +- {expression(tolerance)}" if tolerance else ""
    return f"{expression(value)}{within}"


def result(found: ast.Find) -> str:
    """Return ``k = P/F`` or ``R_B on AB``."""
    name = f"{found.name.text} = " if found.name else ""
    on = f" on {found.on.text}" if found.on else ""
    return f"{name}{expression(found.target)}{on}"


def end(point: ast.Name, link: ast.Name | None) -> str:
    """Return ``A``, or ``A on OA``."""
    return f"{point.text} on {link.text}" if link else point.text


def rim(radius: ast.Expr, link: ast.Name | None) -> str:
    """Return ``40 mm``, or ``40 mm on OA``."""
    return f"{expression(radius)} on {link.text}" if link else expression(radius)


def condition(required: ast.Require | ast.Condition) -> str:
    """Return ``a < b < c``."""
    first, *rest = map(expression, required.operands)
    pairs = zip(required.operators, rest, strict=True)
    return " ".join([first, *(f"{operator} {operand}" for operator, operand in pairs)])


def route(start: ast.Name, falls: Iterable[ast.Fall]) -> str:
    """Return ``A, K along -y, B along y``."""
    return ", ".join([start.text, *(_fall(*fall) for fall in falls)])


def _fall(point: ast.Name, along: ast.Direction | None) -> str:
    return point.text if along is None else f"{point.text} along {direction(along)}"


def let_value(value: ast.LetValue) -> str:
    """Return a user-defined formula: an expression, a choice, a size, a look-up."""
    match value:
        case ast.Choice(branches=branches, otherwise=otherwise):
            listed = ", ".join(map(branch, branches))
            return f"{listed} else {let_value(otherwise)}" if otherwise else listed
        case ast.Lookup(table=table, at=at, exactly=exactly):
            return f"{table.text} at {'exactly ' if exactly else ''}{expression(at)}"
        case ast.NextSize(least=least, sizes=sizes):
            return f"next {expression(least)} in {sizes.text}"
        case _:
            return expression(value)


def branch(chosen: ast.Branch) -> str:
    """Return ``value when a < b and c < d``."""
    return f"{expression(chosen.value)} when {' and '.join(map(condition, chosen.conditions))}"


def row(pair: tuple[ast.Expr, ast.Expr]) -> str:
    """Return ``1: 0.388``."""
    return f"{expression(pair[0])}: {expression(pair[1])}"


def settings(given: tuple[tuple[ast.Name, ast.Expr], ...]) -> str:
    """Return ``alpha = 35 deg, beta = 7 deg``."""
    return ", ".join(f"{name.text} = {expression(value)}" for name, value in given)


def reported(part: ast.Reported) -> str:
    """Return ``scheme``, or ``plot k over alpha``."""
    return part.name.text if part.over is None else f"plot {part.name.text} over {part.over.text}"


def joints(joined: tuple[tuple[ast.Name, ast.Name], ...]) -> str:
    """Return ``T.C = B, T.D = E``."""
    return ", ".join(f"{there.text} = {here.text}" for there, here in joined)


def expectation(expected: ast.Expect) -> str:
    """Return ``k = 7.1 at alpha = 35 deg``."""
    at = f" at {settings(expected.at)}" if expected.at else ""
    return f"{expression(expected.subject)} = {measure(expected.value, expected.tolerance)}{at}"
