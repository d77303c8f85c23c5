"""Wheels: which links they are fixed to, and which link, the arm, carries their centres."""

import math
from collections.abc import Iterable, Iterator
from typing import Literal

from ...diagnostics.model import names
from ...diagnostics.model import wheels as messages
from ...formula.tree import Formula
from ...syntax import ast
from ...syntax.vocabulary import GROUND, points_of
from ...units import LENGTH
from ..formulas.directions import value_of
from ..formulas.expressions import Reader
from ..mechanism import Geometry, Joint, Link, Offset, WheelPair
from ..names.scope import DESCRIPTION, NameScope
from ..parts.linkage import without_prime
from ..statements import every
from ..tolerances import SAME_VALUE


def read_wheels(file: ast.File, scope: NameScope) -> Iterator[WheelPair]:
    """Yield the pairs of gears and the belts, in the order of the text."""
    is_mirrored = bool(every(file, ast.Mirror))
    for statement in file.statements:
        if not isinstance(statement, ast.Gear | ast.Belt):
            continue
        if not (is_mirrored and _joins_halves(statement, scope)):
            pair = _wheel_pair(statement, scope)
            yield from (pair,) if pair else ()


def _wheel_pair(statement: ast.Gear | ast.Belt, scope: NameScope) -> WheelPair | None:
    """Return a pair of gears or a belt; None where what is wrong with it is reported."""
    centres = [scope.points.acting(name) for name in (statement.first, statement.second)]
    radii = [radius_of(r, scope) for r in (statement.first_radius, statement.second_radius)]
    if not all(centres) or radii[0] is None or radii[1] is None:
        return None
    first, second = statement.first.text, statement.second.text
    if first == second:
        at = statement.second.span
        scope.report.add(names.repeated_point(at, first + second, first))
        return None
    if isinstance(statement, ast.Gear) and statement.inner and _alike(radii, scope):
        size = value_of(radii[0], scope) or 0.0
        scope.report.add(messages.inner_of_one_radius(statement.span, first, second, size))
        return None
    arm = _arm(statement, scope)
    links = _links(statement, arm, scope) if arm is not None else None
    if arm is None or links is None:
        return None
    wheels = (first, links[0], radii[0]), (second, links[1], radii[1])
    kind: Literal["gear", "belt"] = "gear" if isinstance(statement, ast.Gear) else "belt"
    return WheelPair(kind, *wheels[0], *wheels[1], _same_sense(statement), statement.span, arm)


def _same_sense(statement: ast.Gear | ast.Belt) -> bool:
    """Return whether both wheels turn one way: an inner gear does that, and an open belt."""
    return statement.inner if isinstance(statement, ast.Gear) else not statement.crossed


def _alike(radii: Iterable[Formula | None], scope: NameScope) -> bool:
    """Return whether two radii are one and the same, by their values or as they are written."""
    first, second = (radius for radius in radii if radius)
    sizes = value_of(first, scope), value_of(second, scope)
    return first == second or (None not in sizes and sizes[0] == sizes[1])


def _arm(statement: ast.Gear | ast.Belt, scope: NameScope) -> str | None:
    """Return the link that carries both centres, '' for the ground; None where it is reported.

    A slide that carries them does not turn, as the ground does not. Pivots at one place are
    one axis: a sun, a ring and the arm may each have a pivot of their own there.
    """
    pivots = {statement.first.text, statement.second.text}
    if pivots <= scope.points.fixed or any(pivots <= slide for slide in scope.points.slides):
        return ""
    named = [n.text for n in (statement.first_link, statement.second_link) if n]
    wheels = {text: points_of(text) for text in named if text != GROUND}
    axes = [scope.points.coaxial(point) for point in sorted(pivots)]
    both = [k for k in scope.points.links.values() if all(axis & {*k.points} for axis in axes)]
    turning = {text for text, w in wheels.items() if any({*k.points} >= {*w} for k in both)}
    arms = [k.name for k in both if not any({*k.points} >= {*wheels[text]} for text in turning)]
    if len(arms) == 1:
        return arms[0]
    at, ends = statement.second.span, (statement.first.text, statement.second.text)
    if arms:
        scope.report.add(messages.several_arms(at, *ends, arms))
    else:
        scope.report.add(messages.no_arm(at, *ends, next(iter(turning), "")))
    return None


def _links(statement: ast.Gear | ast.Belt, arm: str, scope: NameScope) -> tuple[str, str] | None:
    """Return the bodies that the wheels are fixed to, '' for the ground."""
    first = _fixed_to(statement.first, statement.first_link, arm, scope)
    second = _fixed_to(statement.second, statement.second_link, arm, scope)
    return None if first is None or second is None else (first, second)


def _fixed_to(centre: ast.Name, on: ast.Name | None, arm: str, scope: NameScope) -> str | None:
    """Return the body that one wheel turns with, '' for the ground; None where that is reported.

    It is the one that the statement names behind ``on``, else the only link at the centre.
    """
    if on is None:
        link = _only_link(centre, arm, scope)
    elif on.text == GROUND:
        if centre.text in scope.points.fixed:
            return ""
        scope.report.add(messages.wheel_without_pivot(centre.span, centre.text))
        return None
    else:
        link = scope.points.link(on)
        if link and centre.text not in link.points:
            scope.report.add(
                messages.joint_of_another(on.span, centre.text, link.name, "turns with the wheel")
            )
            return None
    if link is None:
        return None
    scope.points.used.update(link.points)
    return link.name


def wheel_on(pivot: ast.Name, scope: NameScope) -> Link | None:
    """Return the one link on a pivot, to which the wheel there is fixed."""
    points = scope.points.acting(pivot)
    if not points:
        return None
    if points[0] not in scope.points.fixed:
        scope.report.add(messages.wheel_without_pivot(pivot.span, points[0]))
        return None
    link = _only_link(pivot, "", scope)
    if link:
        scope.points.used.update(link.points)
    return link


def _only_link(centre: ast.Name, arm: str, scope: NameScope) -> Link | None:
    """Return the one link on a centre besides the arm."""
    links = [k for k in scope.points.carried.get(centre.text, []) if k.name != arm]
    if len(links) == 1:
        return links[0]
    found = [link.name for link in links]
    scope.report.add(messages.wheel_of_several(centre.span, centre.text, found, arm))
    return None


def radius_of(
    radius: ast.Expr, scope: NameScope, signed: bool = False, what: str = "a radius"
) -> Formula | None:
    """Return a radius or a pitch; only one that is ``signed`` may be negative."""
    formula = Reader(scope, DESCRIPTION).wanted(radius, LENGTH, what)
    value = value_of(formula, scope) if formula else None
    if formula and value is not None and (value == 0 or (value < 0 and not signed)):
        shown, cause = f"{value * 1000:g} mm", scope.cause(formula, radius.span)
        scope.report.add(messages.radius_not_positive(radius.span, shown, cause))
        return None
    return formula


def check_belts(joints: Iterable[Joint], places: Iterable[Geometry], scope: NameScope) -> None:
    """Report belts whose wheels overlap, where the places of both pivots are given."""
    known = [place for place in places if isinstance(place, Offset)]
    located = {place.head: _values((place.x, place.y), scope) for place in known}
    for mesh in joints:
        if not isinstance(mesh, WheelPair) or mesh.kind != "belt":
            continue
        ends = [located.get(pivot) for pivot in mesh.points]
        radii = _values((mesh.first_radius, mesh.second_radius), scope)
        if ends[0] is None or ends[1] is None or radii is None:
            continue
        apart = math.dist(ends[0], ends[1])
        if apart < sum(radii) * (1 - SAME_VALUE):
            pivots = f"{mesh.first} and {mesh.second}"
            scope.report.add(messages.wheels_overlap(mesh.span, pivots, apart, sum(radii)))


def _values(formulas: Iterable[Formula], scope: NameScope) -> list[float] | None:
    """Return the values at the given parameters; None where one of them has none."""
    values = [value_of(formula, scope) for formula in formulas]
    known = [value for value in values if value is not None]
    return known if len(known) == len(values) else None


def _joins_halves(statement: ast.Gear | ast.Belt, scope: NameScope) -> bool:
    """Return whether a wheel is on the twin of a described point, which is reported."""
    first, second = statement.first.text, statement.second.text
    for name in (statement.first, statement.second):
        places, described = scope.points.places, without_prime(name.text)
        if name.text not in places and described in places:
            are_twins = without_prime(first) == without_prime(second)
            scope.report.add(messages.wheels_across_the_mirror(name.span, first, second, are_twins))
            return True
    return False
