"""Collars of screws and on pivots: the radius at which the friction of a ring acts."""

from ...diagnostics.model import collars as messages
from ...diagnostics.model import friction as friction_messages
from ...formula.tree import Formula, number, power, product, total
from ...formula.walk import symbols
from ...syntax import ast
from ...units import FORCE, LENGTH, NUMBER
from ..formulas.expressions import Reader
from ..mechanism import Link, Mechanism
from ..names.scope import DESCRIPTION, TIE, NameScope
from ..parts.friction import PivotFriction
from .coefficients import checked, coefficient, positive_length, value_of
from .loads import degree


def read_collar(
    statement: ast.CollarFriction, built: Mechanism, scope: NameScope
) -> PivotFriction | None:
    """Return the friction of a collar on a pivot; None where an error was reported."""
    point = statement.point
    f = coefficient(statement.coefficient, point.text, scope)
    if not scope.points.acting(point) or f is None:
        return None
    thrust = _thrust(statement, scope)
    faces = _faces(statement.faces, scope) if statement.faces else number(1)
    radius, link = collar_radius(statement, scope), _turning(statement, built, scope)
    if thrust is None or faces is None or radius is None or link is None:
        return None
    scope.points.used.update(link.points)
    factor = product([(f, 1), (faces, 1)])
    return PivotFriction(point.text, link.name, factor, radius, thrust, statement.span)


def _thrust(statement: ast.CollarFriction, scope: NameScope) -> Formula | None:
    """Return the force along the axis: given, or a multiple of one load."""
    if statement.thrust is None:
        scope.report.add(messages.collar_without_thrust(statement.span, statement.point.text))
        return None
    force = Reader(scope, TIE).wanted(statement.thrust, FORCE, "the thrust of a collar")
    loads = symbols(force) & set(scope.names({"load"})) if force else set()
    if force and loads and (len(loads) != 1 or degree(force, frozenset(loads)) != 1):
        scope.report.add(messages.thrust_of_several(statement.thrust.span, sorted(loads)))
        return None
    return force


def _faces(expression: ast.Expr, scope: NameScope) -> Formula | None:
    what = "a number of faces"
    found = Reader(scope, DESCRIPTION).wanted(expression, NUMBER, what)
    return checked(found, expression.span, what, _is_a_number, scope)


def _is_a_number(value: float) -> bool:
    return value >= 1 and value == int(value)


def _turning(statement: ast.CollarFriction, built: Mechanism, scope: NameScope) -> Link | None:
    """Return the link that turns on the pivot with the collar."""
    point = statement.point
    there = [link for link in built.rigid_links if point.text in link.points]
    if statement.link is None:
        if len(there) == 1:
            return there[0]
        names = [link.name for link in there]
        scope.report.add(messages.collar_of_which_link(point.span, point.text, names))
        return None
    link = scope.points.link(statement.link)
    if link and link not in there:
        found = friction_messages.pin_of_another(statement.link.span, point.text, link.name)
        scope.report.add(found)
    return link if link in there else None


def collar_radius(statement: ast.CollarFriction, scope: NameScope) -> Formula | None:
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


def _called(kind: str, size: Formula, statement: ast.CollarFriction, scope: NameScope) -> Formula:
    """Return a diameter, by a name where it is a number."""
    return scope.named(kind, statement.point.text, size, LENGTH, statement.span)


def _of_ring(
    statement: ast.CollarFriction, diameters: tuple[ast.Expr, ast.Expr], scope: NameScope
) -> Formula | None:
    """Return the mean radius of a ring by its diameters, under the law of its pressure."""
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
        return _of_even_pressure(outer, inner)
    return product([(total([outer, inner]), 1), (number(4), -1)])


def _of_even_pressure(outer: Formula, inner: Formula) -> Formula:
    """Return (D² + D·d + d²)/(D + d)/3, which is (D³ − d³)/(D² − d²)/3."""
    squares = [power(outer, number(2)), product([(outer, 1), (inner, 1)]), power(inner, number(2))]
    return product([(total(squares), 1), (total([outer, inner]), -1), (number(3), -1)])
