"""Pairs of forces: actuators, whose force is asked for or given, and springs."""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from ...base.frozen import replace
from ...diagnostics.model import loads as messages
from ...diagnostics.model import names
from ...formula.tree import Formula, Symbol, negative, product, total
from ...syntax import ast
from ...units import LENGTH, STIFFNESS
from ..formulas.directions import check_sign
from ..formulas.expressions import Reader
from ..mechanism import ForcePair, Load, Mechanism, PinFriction
from ..names.scope import DESCRIPTION, NameScope
from ..parts.linkage import PRIME, primed, without_prime


def read_force_pair(
    statement: ast.Actuator | ast.Spring, is_mirrored: bool, times: Fraction, scope: NameScope
) -> ForcePair | None:
    """Return a pair of forces between two points, or between a point and its twin."""
    ends = _ends(statement, is_mirrored, scope)
    links = _links(statement, scope) if ends else None
    if ends is None or links is None:
        return None
    across = _is_twin(ends[1], scope)
    if isinstance(statement, ast.Actuator):
        name = statement.name.text
        return ForcePair(name, *ends, statement.span, None, times, False, *links, across)
    force = _of_spring(statement, "".join(ends), scope)
    if force is None:
        return None
    name = spring_name(statement)
    return ForcePair(name, *ends, statement.span, force, times, True, *links, across)


def _ends(
    statement: ast.Actuator | ast.Spring, is_mirrored: bool, scope: NameScope
) -> tuple[str, str] | None:
    """Return the points of a pair of forces; None where an error is reported."""
    first, second = (_end(n, is_mirrored, scope) for n in (statement.first, statement.second))
    if first is None or second is None:
        return None
    if first == second:
        both = statement.second.span
        scope.report.add(names.repeated_point(both, first + second, first))
        return None
    if (_is_twin(second, scope) and second != primed(first)) or _is_twin(first, scope):
        scope.report.add(messages.pair_across_the_mirror(statement.span, first, second))
        return None
    return first, second


def _of_spring(statement: ast.Spring, vector: str, scope: NameScope) -> Formula | None:
    """Return the force of a spring, c·(l0 − len_AB): positive where it is in compression."""
    reader = Reader(scope, DESCRIPTION)
    rate = reader.wanted(statement.rate, STIFFNESS, "the rate of a spring")
    free = reader.wanted(statement.free, LENGTH, "the free length of a spring")
    check_sign(rate, statement.rate.span, "the rate of a spring", scope)
    check_sign(free, statement.free.span, "the free length of a spring", scope)
    if not rate or not free:
        return None
    rate = scope.named("c", vector, rate, STIFFNESS, statement.rate.span, "rate")
    free = scope.named("l", vector, free, LENGTH, statement.free.span, "free")
    stretch = total([free, negative(Symbol(f"len_{vector}"))])
    return product([(rate, 1), (stretch, 1)])


def _links(statement: ast.Actuator | ast.Spring, scope: NameScope) -> tuple[str, str] | None:
    """Return the links that carry the ends, '' for a pin; None where an error was reported."""
    first = carrying(statement.first_link, statement.first, scope)
    second = carrying(statement.second_link, statement.second, scope)
    return None if first is None or second is None else (first, second)


def carrying(name: ast.Name | None, point: ast.Name, scope: NameScope) -> str | None:
    """Return the link that is said to carry a load, '' where none is; report a wrong one."""
    if name is None:
        return ""
    link = scope.points.link(name)
    if link is None:
        return None
    if point.text not in link.points:
        scope.report.add(messages.load_on_another_link(name.span, point.text, link.name))
        return None
    return link.name


def inside_telescopes(
    loads: Sequence[Load], built: Mechanism, scope: NameScope
) -> tuple[Load, ...]:
    """Return the loads; those in a telescope with friction at its ends act on its two parts."""
    rough = {r.point for r in built.friction.joints if isinstance(r, PinFriction)}
    bent = {frozenset(t.points): t.name for t in built.telescopes if rough & {*t.points}}
    return tuple(_inside(load, bent, scope) for load in loads)


def _inside(load: Load, bent: Mapping[frozenset[str], str], scope: NameScope) -> Load:
    if not isinstance(load, ForcePair):
        return load
    name = bent.get(frozenset((load.first, load.second)), "")
    if name and (load.first_link or load.second_link):
        scope.report.add(messages.load_inside_telescope(load.span, load.name, name))
    return replace(load, first_link=name, second_link=name) if name else load


def spring_name(statement: ast.Spring) -> str:
    """Return the name of a spring's force: ``S_AB``."""
    return f"S_{statement.first.text}{statement.second.text}".replace(PRIME, "p")


def _is_twin(point: str, scope: NameScope) -> bool:
    return point not in scope.points.places


def _end(name: ast.Name, is_mirrored: bool, scope: NameScope) -> str | None:
    """Return a point, or a twin whose point is described."""
    described = without_prime(name.text)
    is_twin = is_mirrored and name.text not in scope.points.places
    known = ast.Name(described, name.span) if is_twin and described in scope.points.places else name
    return name.text if scope.points.acting(known) else None
