"""Pairs of forces: actuators, whose force is asked for or given, and springs."""

from fractions import Fraction

from ..diagnostics.model import loads as words
from ..diagnostics.model import names
from ..formula.tree import Symbol, negative, product, total
from ..syntax import ast
from ..units import LENGTH, STIFFNESS
from .directions import check_sign
from .expressions import Reader
from .mechanism import Thrust
from .scope import DESCRIPTION, Scope


def read_thrust(
    statement: ast.Actuator | ast.Spring, is_mirrored: bool, times: Fraction, scope: Scope
) -> Thrust | None:
    """Return a pair of forces between two points, or between a point and its twin.

    A spring's force is c·(l0 − len_AB): positive where it is pressed together.
    """
    ends = [_end(name, is_mirrored, scope) for name in (statement.first, statement.second)]
    if ends[0] is None or ends[1] is None:
        return None
    first, second = ends[0], ends[1]
    if first == second:
        both = statement.second.span
        scope.report.add(names.repeated_point(both, first + second, first))
        return None
    if (_is_twin(second, scope) and second != f"{first}'") or _is_twin(first, scope):
        scope.report.add(words.pair_across_the_mirror(statement.span, first, second))
        return None
    if isinstance(statement, ast.Actuator):
        return Thrust(statement.name.text, first, second, statement.span, None, times)
    reader = Reader(scope, DESCRIPTION)
    rate = reader.wanted(statement.rate, STIFFNESS, "the rate of a spring")
    free = reader.wanted(statement.free, LENGTH, "the free length of a spring")
    check_sign(rate, statement.rate.span, "the rate of a spring", scope)
    check_sign(free, statement.free.span, "the free length of a spring", scope)
    if not rate or not free:
        return None
    stretch = total([free, negative(Symbol(f"len_{first}{second}"))])
    force = product([(rate, 1), (stretch, 1)])
    return Thrust(spring_name(statement), first, second, statement.span, force, times, spring=True)


def spring_name(statement: ast.Spring) -> str:
    """Return the name of a spring's force: ``S_AB``."""
    return f"S_{statement.first.text}{statement.second.text}".replace("'", "p")


def _is_twin(point: str, scope: Scope) -> bool:
    return point not in scope.points.places


def _end(name: ast.Name, is_mirrored: bool, scope: Scope) -> str | None:
    """Return a point, or a twin whose point is described."""
    described = name.text.removesuffix("'")
    is_twin = is_mirrored and name.text not in scope.points.places
    known = ast.Name(described, name.span) if is_twin and described in scope.points.places else name
    return name.text if scope.points.acting(known) else None
