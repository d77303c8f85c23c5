"""Ropes over pulleys, on axles that move or stand still."""

from collections.abc import Iterator
from itertools import pairwise

from ...diagnostics.model import joints as messages
from ...syntax import ast
from ..formulas.directions import read_direction
from ..mechanism import Along, Direction, Rope
from ..names.scope import Scope
from ..statements import every


def read_ropes(file: ast.File, scope: Scope) -> Iterator[Rope]:
    """Yield the ropes; their lengths determine no pose, so that none goes with a drive."""
    for statement in every(file, ast.Rope):
        rope = _rope(statement, scope)
        if rope:
            _warn_of_friction(rope, file, scope)
            yield rope
        for drive in every(file, ast.Drive):
            scope.report.add(messages.rope_with_drive(statement.span, drive.span))


def _rope(statement: ast.Rope, scope: Scope) -> Rope | None:
    names = [statement.start, *(point for point, _ in statement.falls)]
    route = [point[0] for point in map(scope.points.acting, names) if point]
    ways = [_way(tail, head, along, scope) for tail, (head, along) in _falls(statement)]
    if len(route) < len(names) or None in ways:
        return None
    for name, (tail, head) in zip(names[1:], pairwise(route), strict=True):
        if tail == head:
            scope.report.add(messages.fall_to_itself(name.span, head))
            return None
    return Rope(tuple(route), tuple(way for way in ways if way), statement.span)


def _warn_of_friction(rope: Rope, file: ast.File, scope: Scope) -> None:
    """Warn of friction that is given for pins on which pulleys turn."""
    axles = list(dict.fromkeys(rope.route[1:-1]))
    for friction in every(file, ast.PinFriction):
        meant = [p for p in axles if friction.point is None or p == friction.point.text]
        if meant:
            scope.report.add(messages.pulleys_without_friction(friction.span, meant))


def _falls(statement: ast.Rope) -> Iterator[tuple[ast.Name, ast.Fall]]:
    """Yield each fall with the point that it begins at."""
    starts = [statement.start, *(point for point, _ in statement.falls)]
    yield from zip(starts, statement.falls, strict=False)


def _way(
    tail: ast.Name, head: ast.Name, along: ast.Direction | None, scope: Scope
) -> Direction | None:
    """Return the direction of a fall: that which is written, else from point to point."""
    if along is not None:
        return read_direction(along, scope)
    return Along(tail.text, head.text, 0, head.span)
