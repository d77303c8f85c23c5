"""Friction of ropes on pulleys that are held, and on drums that turn with a link."""

import math
from fractions import Fraction

from ...base.frozen import replace
from ...diagnostics.model import wheels as messages
from ...formula.tree import number, product
from ...syntax import ast
from ...units import ANGLE, LENGTH
from ..formulas.expressions import Reader
from ..mechanism import Absolute, Direction, Mechanism, Rope
from ..names.scope import DESCRIPTION, NameScope
from ..parts.friction import RopeFriction
from .coefficients import coefficient, positive_length, value_of


def read_rope_friction(
    statement: ast.RopeFriction, built: Mechanism, scope: NameScope
) -> RopeFriction | None:
    """Return the friction of a rope around a pulley; None where an error was reported."""
    point = statement.point.text
    f = coefficient(statement.coefficient, point, scope)
    wrap = Reader(scope, DESCRIPTION).wanted(statement.wrap, ANGLE, "an angle of wrap")
    found = _pulley(statement.point, built, scope)
    if found is None or f is None or wrap is None:
        return None
    rope, place = found
    size = value_of(wrap, scope)
    clockwise = size is not None and size < 0
    if size is not None and not _fits(statement, size, rope.ways[place - 1 : place + 1], scope):
        return None
    angle = product([(number(-1), 1), (wrap, 1)]) if clockwise else wrap
    held = RopeFriction(
        joint=rope.id,
        point=point,
        place=place,
        coefficient=f,
        wrap=angle,
        reach=None,
        link="",
        span=statement.span,
    )
    return _with_drum(held, statement, clockwise, scope)


def _pulley(point: ast.Name, built: Mechanism, scope: NameScope) -> tuple[Rope, int] | None:
    """Return the only rope that runs over a pulley on a point, and its place in the route."""
    if not scope.points.acting(point):
        return None
    inner = [(rope, i, p) for rope in built.ropes for i, p in list(enumerate(rope.route))[1:-1]]
    there = [(rope, i) for rope, i, p in inner if p == point.text]
    if len(there) == 1:
        return there[0]
    named = [p for _, _, p in inner]
    scope.report.add(messages.pulley_of_rope(point.span, point.text, len(there), named))
    return None


SAME_FALL = math.radians(0.5)
"""Directions that are no farther apart are taken for one."""


def _fits(
    statement: ast.RopeFriction, size: float, ways: tuple[Direction, ...], scope: NameScope
) -> bool:
    """Return whether a rope turns by its wrap, either way around a pulley that is held."""
    angles = [value_of(way.angle, scope) for way in ways if isinstance(way, Absolute)]
    known = [angle for angle in angles if angle is not None]
    if len(known) < 2:
        return True
    turn = known[1] - known[0]
    sizes = (size,) if statement.link else (size, -size)
    if any(abs(math.remainder(turn - angle, math.tau)) < SAME_FALL for angle in sizes):
        return True
    point = statement.point.text
    scope.report.add(messages.wrap_unlike_falls(statement.wrap.span, point, turn, size))
    return False


def _with_drum(
    held: RopeFriction, statement: ast.RopeFriction, clockwise: bool, scope: NameScope
) -> RopeFriction | None:
    """Return the friction of a rope around a drum that turns with a link."""
    if statement.link is None or statement.drum is None:
        return held
    diameter = positive_length(statement.drum, "the diameter of a drum", scope)
    link = scope.points.link(statement.link)
    if diameter is None or link is None:
        return None
    if held.point not in link.points:
        span = statement.link.span
        scope.report.add(messages.drum_of_another(span, held.point, link.name))
        return None
    scope.points.used.update(link.points)
    diameter = scope.named("d", held.point, diameter, LENGTH, statement.drum.span, "drum")
    half = number(Fraction(-1 if clockwise else 1, 2))
    return replace(held, reach=product([(half, 1), (diameter, 1)]), link=link.name)
