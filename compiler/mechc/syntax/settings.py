"""Parameters set from outside (``-D alpha=30deg``): put into the tree in place of the file's.

A setting is read with the project's own grammar, as the value of a ``param`` line of
its own, so that what may stand there is exactly what may stand in a file.
"""

import re
from collections.abc import Iterable, Mapping

from ..diagnostics import Report
from ..frozen import replace
from ..source import Source
from ..units import DIMENSIONS, NUMBER, UNITS
from . import ast
from .notation import read

Settings = Mapping[str, ast.Expr]
"""New values of parameters, by name."""

_UNIT = re.compile(r"(?<=[\d.])(?=[a-zA-Z])(?![eE][+-]?\d)")


def parse(text: str) -> tuple[str, ast.Expr]:
    """Return name and value of ``NAME=VALUE``; the space before a unit may be left out.

    Raises :class:`MechcError` where the value is no expression.

    >>> name, value = parse("alpha=30deg")
    >>> name, value.digits, value.unit
    ('alpha', '30', 'deg')
    """
    name, _, value = text.partition("=")
    line = f"param {name.strip()} = {_UNIT.sub(' ', ' '.join(value.split()))}\n"
    report = Report(Source(f"-D {text}", line))
    tree = read(report.source, report)
    report.stop_on_errors()
    return name.strip(), next(s.value for s in params(tree.statements) if s.value)


def put_in(tree: ast.File, settings: Settings) -> ast.File:
    """Return the tree with the values of the named parameters replaced."""
    if not settings:
        return tree
    return replace(tree, statements=tuple(_set(s, settings) for s in tree.statements))


def params(statements: Iterable[ast.Statement]) -> tuple[ast.Param, ...]:
    """Return the parameter declarations among statements, in order."""
    return tuple(s for s in statements if isinstance(s, ast.Param))


def _set(statement: ast.Statement, settings: Settings) -> ast.Statement:
    if not isinstance(statement, ast.Param) or statement.name.text not in settings:
        return statement
    value = _moved(settings[statement.name.text], statement)
    dimension = statement.dimension or _dimension(statement.value)
    return replace(statement, value=value, dimension=dimension)


def _dimension(value: ast.Expr | None) -> ast.Name | None:
    """Return what the value in the file measures, so that one without its unit is noticed."""
    match value:
        case ast.Number(unit=unit) | ast.Sum(terms=((_, ast.Number(unit=unit)),)):
            measured = UNITS[unit].dimension if unit else NUMBER
            names = (name for name, known in DIMENSIONS.items() if known == measured)
            return next((ast.Name(name, value.span) for name in names), None)
    return None


def _moved(value: ast.Expr, statement: ast.Param) -> ast.Expr:
    """Return the value with every span at the file's declaration, for messages."""
    span = (statement.value or statement.name).span
    match value:
        case ast.Number() | ast.Symbol():
            return replace(value, span=span)
        case ast.Sum(terms):
            return ast.Sum(tuple((sign, _moved(t, statement)) for sign, t in terms), span)
        case ast.Product(factors):
            return ast.Product(tuple((sign, _moved(f, statement)) for sign, f in factors), span)
        case ast.Power(base, exponent):
            return ast.Power(_moved(base, statement), _moved(exponent, statement), span)
        case ast.Call(function, arguments):
            return ast.Call(function, tuple(_moved(a, statement) for a in arguments), span)
