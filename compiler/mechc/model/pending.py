"""Statements of the language that are checked but not compiled yet.

Their names and dimensions are checked like those of any other statement, so that a
description stays right when the compiler catches up with it.
"""

from ..diagnostics.model import joints as words
from ..syntax import ast
from ..units import LENGTH, NUMBER, Dimension
from .expressions import Reader
from .scope import DESCRIPTION, Scope


def check_pending(file: ast.File, scope: Scope) -> None:
    """Check every such statement, and say of each that it is not compiled yet."""
    for statement in file.statements:
        if what := _friction(statement, scope):
            scope.report.add(words.not_compiled_yet(statement.span, what))


def _friction(statement: ast.Statement, scope: Scope) -> str:
    match statement:
        case ast.PinFriction(point=point, coefficient=f, diameter=diameter, link=link):
            if point:
                scope.points.acting(point)
            if link:
                scope.points.link(link)
            _quantity(f, NUMBER, "a coefficient of friction", scope)
            _quantity(diameter, LENGTH, "a diameter", scope)
        case ast.GuideFriction(point=point, coefficient=f, length=length, overhang=overhang):
            scope.points.acting(point)
            _quantity(f, NUMBER, "a coefficient of friction", scope)
            for part in (length, overhang):
                if part:
                    _quantity(part, LENGTH, "a length of a guide", scope)
        case ast.RollerFriction(point=point, coefficient=f, axle=axle, wheel=wheel):
            scope.points.acting(point)
            _quantity(f, NUMBER, "a coefficient of friction", scope)
            _quantity(axle, LENGTH, "a diameter", scope)
            _quantity(wheel, LENGTH, "a diameter", scope)
        case ast.ContactFriction(point=point, coefficient=f):
            scope.points.acting(point)
            _quantity(f, NUMBER, "a coefficient of friction", scope)
        case ast.Efficiency(value=value):
            _quantity(value, NUMBER, "an efficiency", scope)
            return "an efficiency ('efficiency')"
        case ast.Motion():
            return "the sense of motion ('motion')"
        case _:
            return ""
    return "friction ('friction')"


def _quantity(expression: ast.Expr, dimension: Dimension, what: str, scope: Scope) -> None:
    """Check the names and the dimension of an expression."""
    Reader(scope, DESCRIPTION).wanted(expression, dimension, what)
