"""Vectors and angles between points."""

import math

from ...base.named import NamedTuple
from ...diagnostics.model import joints as messages
from ...formula.tree import Formula, Symbol
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...units import ANGLE, LENGTH
from ..formulas.directions import check_reach, read_direction, read_place, value_of
from ..formulas.expressions import Reader
from ..mechanism import Arrow, Geometry, Offset, Turn
from ..names.scope import DESCRIPTION, NameScope


class VectorEnds(NamedTuple):
    """The two points of a vector."""

    tail: str
    head: str


def read_geometry(file: ast.File, scope: NameScope) -> list[Geometry]:
    """Return every vector and angle of the description."""
    found: list[Geometry] = []
    first: dict[frozenset[str] | tuple[str, frozenset[str]], Span] = {}
    for statement in file.statements:
        match statement:
            case ast.Vector(points=name):
                points = scope.points.known(name)
                entry = _vector(statement, VectorEnds(*points), scope) if points else None
                key: frozenset[str] | tuple[str, frozenset[str]] = frozenset(points or ())
            case ast.Turn(points=name):
                points = scope.points.known(name)
                entry = _turn(statement, points, scope) if points else None
                key = (points[1], frozenset(points)) if points else frozenset()
            case _:
                continue
        if points and first.setdefault(key, name.span) != name.span:
            scope.report.add(
                messages.vector_again(name.span, name.text, len(points) == 3, first[key])
            )
        elif entry:
            found.append(entry)
    _count_uses(found, scope)
    return found


def _vector(statement: ast.Vector, ends: VectorEnds, scope: NameScope) -> Geometry | None:
    match statement.value:
        case ast.Cartesian() as place:
            offset = read_place(*ends, place, scope)
            return offset if offset and _long_enough(offset, statement, scope) else None
        case ast.Polar() as polar:
            return _arrow(polar, ends, statement, scope)


def _arrow(
    polar: ast.Polar, ends: VectorEnds, statement: ast.Vector, scope: NameScope
) -> Arrow | None:
    length = _length(polar.length, statement, scope) if polar.length else None
    towards = polar.direction
    direction = read_direction(towards, scope, "the direction") if towards else None
    if (polar.length and not length) or (polar.direction and not direction):
        return None
    return Arrow(*ends, length, direction, statement.span)


def _length(length: ast.Expr, statement: ast.Vector, scope: NameScope) -> Formula | None:
    """Read a length, which is positive at the given parameters."""
    formula = Reader(scope, DESCRIPTION).wanted(length, LENGTH, "the length")
    value = value_of(formula, scope) if formula else None
    check_reach(formula, LENGTH, length.span, scope)
    if formula and value is not None and value <= 0:
        if isinstance(formula, Symbol) and not scope.first_misfit(formula.name, LENGTH):
            return None  # it is said where the name is first a length
        shown, cause = f"{value * 1000:g} mm", scope.cause(formula, length.span)
        name = statement.points.text
        scope.report.add(messages.length_not_positive(length.span, name, shown, cause))
        return None
    return formula


def _long_enough(offset: Offset, statement: ast.Vector, scope: NameScope) -> bool:
    """Return whether a vector has a length; a coordinate that varies may pass zero.

    Reports E203 where it has none.
    """
    if value_of(offset.x, scope) == value_of(offset.y, scope) == 0 and not _runs(offset):
        scope.report.add(
            messages.length_not_positive(offset.span, statement.points.text, "0", offset.span)
        )
        return False
    return True


def _runs(offset: Offset) -> bool:
    return bool(symbols(offset.x) | symbols(offset.y))


def _turn(statement: ast.Turn, points: tuple[str, ...], scope: NameScope) -> Turn | None:
    """Return an angle between vectors; None where it is more than a turn, which is reported."""
    angle = Reader(scope, DESCRIPTION).wanted(statement.angle, ANGLE, "the angle")
    if angle is None:
        return None
    value = value_of(angle, scope)
    if value is not None and abs(value) > 2 * math.pi:
        shown = f"{math.degrees(value):g} deg"
        scope.report.add(
            messages.turn_out_of_range(statement.angle.span, statement.points.text, shown)
        )
        return None
    first, vertex, second = points
    return Turn(first, vertex, second, angle, statement.span)


def _count_uses(found: list[Geometry], scope: NameScope) -> None:
    """Count a point as used where two entries meet in it, or one with the ground.

    It places something else: a pivot may be but the origin of vectors.
    """
    seen = set(scope.points.fixed)
    for entry in found:
        match entry:
            case Arrow(tail, head) | Offset(tail, head):
                ends = {tail, head}
            case Turn(first, vertex, second):
                ends = {first, vertex, second}
        scope.points.used.update(seen & ends)
        seen |= ends
