"""Collars of screws: the radius at which the friction of a ring acts."""

from ..diagnostics.model import friction as messages
from ..formula.tree import Formula, number, power, product, total
from ..syntax import ast
from ..units import LENGTH
from .coefficients import positive_length, value_of
from .scope import Scope


def collar_radius(statement: ast.CollarFriction, scope: Scope) -> Formula | None:
    """Return the mean radius of a collar; None where an error was reported.

    A ring that is worn in wears evenly, so that p·r is the same at each radius and the mean
    radius is (D + d)/4. On a new one the pressure is even: (D³ − d³)/(D² − d²)/3.
    """
    if (statement.mean is None) == (statement.outer is None):
        scope.report.add(messages.collar_without_size(statement.span, statement.mean is not None))
    elif statement.mean is not None:
        mean = positive_length(statement.mean, "the mean diameter of a collar", scope)
        return mean and product([(_called("D", mean, statement, scope), 1), (number(2), -1)])
    elif statement.outer is not None and statement.inner is not None:
        return _of_ring(statement, (statement.outer, statement.inner), scope)
    return None


def _called(kind: str, size: Formula, statement: ast.CollarFriction, scope: Scope) -> Formula:
    """Return a diameter, by a name where it is a number."""
    return scope.named(kind, statement.point.text, size, LENGTH, statement.span)


def _of_ring(
    statement: ast.CollarFriction, diameters: tuple[ast.Expr, ast.Expr], scope: Scope
) -> Formula | None:
    outer = positive_length(diameters[0], "the outer diameter of a collar", scope)
    inner = positive_length(diameters[1], "the inner diameter of a collar", scope)
    if outer is None or inner is None:
        return None
    wide, narrow = value_of(outer, scope), value_of(inner, scope)
    if wide is not None and narrow is not None and wide <= narrow:
        scope.report.add(messages.collar_inside_out(diameters[1].span, wide, narrow))
        return None
    outer, inner = (_called(*of, statement, scope) for of in (("D", outer), ("D_i", inner)))
    if statement.law == "pressure":
        return _evenly_pressed(outer, inner)
    return product([(total([outer, inner]), 1), (number(4), -1)])


def _evenly_pressed(outer: Formula, inner: Formula) -> Formula:
    """Return (D² + D·d + d²)/(D + d)/3, which is (D³ − d³)/(D² − d²)/3."""
    squares = [power(outer, number(2)), product([(outer, 1), (inner, 1)]), power(inner, number(2))]
    return product([(total(squares), 1), (total([outer, inner]), -1), (number(3), -1)])
