"""Statements of the language that are checked but not compiled yet.

Their names and dimensions are checked like those of any other statement, so that a
description stays right when the compiler catches up with it.
"""

from ..diagnostics.model import joints as words
from ..diagnostics.model import names
from ..syntax import ast
from ..units import LENGTH, NUMBER, STIFFNESS, Dimension
from .directions import read_direction
from .expressions import Reader
from .scope import DESCRIPTION, Scope


def check_pending(file: ast.File, scope: Scope) -> None:
    """Check every such statement, and say of each that it is not compiled yet."""
    mirrored = any(isinstance(s, ast.Mirror) for s in file.statements)
    for statement in file.statements:
        what = (
            _joint(statement, scope)
            or _transmission(statement, scope)
            or _load(statement, mirrored, scope)
            or _friction(statement, scope)
        )
        if what:
            scope.report.add(words.not_compiled_yet(statement.span, what))


def _joint(statement: ast.Statement, scope: Scope) -> str:
    points = scope.points
    match statement:
        case ast.Slide(along=along):
            read_direction(along, scope)
            return "a body that only translates ('slide')"
        case ast.Slot(point=point, line=line):
            points.acting(point)
            points.link(line)
            return "a pin in a slot ('slot')"
        case ast.Telescope():
            return "a link of variable length ('telescope')"
        case ast.Contact(point=point, line=line, normal=normal):
            points.acting(point)
            points.link(line)
            read_direction(normal, scope)
            return "a contact ('contact')"
    return ""


def _transmission(statement: ast.Statement, scope: Scope) -> str:
    match statement:
        case ast.Gear(first=first, second=second) | ast.Belt(first=first, second=second):
            scope.points.acting(first)
            scope.points.acting(second)
            _quantity(statement.first_radius, LENGTH, "a radius", scope)
            _quantity(statement.second_radius, LENGTH, "a radius", scope)
            gear = isinstance(statement, ast.Gear)
            return "a pair of gears ('gear')" if gear else "a belt or chain ('belt')"
        case ast.Rack(point=point, pivot=pivot, radius=radius):
            scope.points.acting(point)
            scope.points.acting(pivot)
            _quantity(radius, LENGTH, "a radius", scope)
            return "a rack ('rack')"
        case ast.Screw(point=point, pitch=pitch, link=link):
            scope.points.acting(point)
            scope.points.link(link)
            _quantity(pitch, LENGTH, "a pitch", scope)
            return "a screw ('screw')"
    return ""


def _load(statement: ast.Statement, mirrored: bool, scope: Scope) -> str:
    match statement:
        case ast.Actuator(first=first, second=second, times=times):
            _between(first, second, times, mirrored, scope)
            return "an actuator ('actuator')"
        case ast.Spring(first=first, second=second, times=times, rate=rate, free=free):
            _between(first, second, times, mirrored, scope)
            _quantity(rate, STIFFNESS, "the rate of a spring", scope)
            _quantity(free, LENGTH, "the free length of a spring", scope)
            return "a spring ('spring')"
    return ""


def _untwinned(name: ast.Name, scope: Scope) -> ast.Name:
    """Return the described point for its twin in the other half: A for A'."""
    point = name.text.removesuffix("'")
    is_twin = name.text not in scope.points.places and point in scope.points.places
    return ast.Name(point, name.span) if is_twin else name


def _between(
    first: ast.Name, second: ast.Name, times: ast.Expr | None, mirrored: bool, scope: Scope
) -> None:
    for name in (first, second):
        scope.points.acting(_untwinned(name, scope) if mirrored else name)
    if first.text == second.text:
        scope.report.add(names.repeated_point(second.span, first.text + second.text, first.text))
    if times:
        _quantity(times, NUMBER, "'times'", scope)


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
