"""Bodies and joints beyond links, pins and guides: slides, telescopes, slots, gears, screws."""

import math
from collections.abc import Collection, Iterable, Sequence
from typing import TypeVar

from ..diagnostics.model import joints as messages
from ..diagnostics.model import names
from ..diagnostics.model.lowering import centre_of_another
from ..formula.tree import Formula
from ..syntax import ast
from ..units import LENGTH
from .directions import read_direction, value_of
from .expressions import Reader
from .mechanism import (
    ArcSlot,
    Contact,
    Geometry,
    Joint,
    Link,
    Offset,
    Rack,
    Screw,
    Slide,
    Slot,
    Telescope,
    WheelPair,
)
from .scope import DESCRIPTION, Scope
from .statements import every


def read_slides(file: ast.File, scope: Scope) -> tuple[Slide, ...]:
    """Return the bodies that only translate."""
    loose = {s.point.text for s in every(file, ast.Slider) if s.through is None}
    return tuple(found(_slide(s, loose, scope) for s in every(file, ast.Slide)))


def read_telescopes(file: ast.File, scope: Scope) -> tuple[Telescope, ...]:
    """Return the links of variable length."""
    return tuple(found(_telescope(s, scope) for s in every(file, ast.Telescope)))


def read_joints(file: ast.File, slides: Sequence[Slide], scope: Scope) -> tuple[Joint, ...]:
    """Return every joint of the description that is neither pin nor guide, kind by kind."""
    is_mirrored = bool(every(file, ast.Mirror))
    wheels = [s for s in file.statements if isinstance(s, ast.Gear | ast.Belt)]
    return (
        *found(_slot(s, slides, scope) for s in every(file, ast.Slot) if s.about is None),
        *found(_contact(s, slides, scope) for s in every(file, ast.Contact)),
        *found(_mesh(s, is_mirrored, scope) for s in wheels),
        *found(_rack(s, slides, scope) for s in every(file, ast.Rack)),
        *found(_screw(s, slides, scope) for s in every(file, ast.Screw)),
    )


T = TypeVar("T")


def found(items: Iterable[T | None]) -> Iterable[T]:
    """Yield what was read without an error."""
    return (item for item in items if item is not None)


def _slide(statement: ast.Slide, loose: Collection[str], scope: Scope) -> Slide | None:
    """Return a slide; a slider of its own that says where its guide lies is no repetition.

    ``loose`` are the sliders that do not.
    """
    points = scope.points.known(statement.points)
    along = read_direction(statement.along, scope)
    if not points or not along:
        return None
    for point in (p for p in points if p in loose):
        scope.report.add(messages.guided_twice(statement.span, statement.points.text, point))
    return Slide(statement.points.text, points, along, statement.span)


def _telescope(statement: ast.Telescope, scope: Scope) -> Telescope | None:
    points = scope.points.known(statement.points)
    if not points:
        return None
    if link := scope.points.bodies.get(frozenset(points)):
        scope.report.add(messages.link_again(statement.span, statement.points.text, link.span))
    return Telescope(statement.points.text, (points[0], points[1]), statement.span)


def _body(name: ast.Name, slides: Iterable[Slide], scope: Scope) -> Link | Slide | None:
    """Return the link or slide that points name."""
    points = scope.points.known(name)
    if not points:
        return None
    slide = next((s for s in slides if set(points) <= set(s.points)), None)
    return slide or scope.points.link(name)


def _on_line(
    point: ast.Name, line: ast.Name, slides: Iterable[Slide], scope: Scope
) -> tuple[str, Link | Slide, str, str] | None:
    """Return a pin, the body on whose line it slides, and the two points of the line."""
    acting = scope.points.acting(point)
    body = _body(line, slides, scope)
    ends = scope.points.acting(line) if body else None
    if not acting or body is None or not ends:
        return None
    if acting[0] in body.points:
        scope.report.add(messages.slides_in_itself(point.span, acting[0], body.name))
        return None
    return acting[0], body, ends[0], ends[1]


def _slot(statement: ast.Slot, slides: Iterable[Slide], scope: Scope) -> Slot | None:
    held = _on_line(statement.point, statement.line, slides, scope)
    if held is None:
        return None
    point, body, tail, head = held
    return Slot(point, body.name, tail, head, statement.span)


def read_arcs(file: ast.File, slides: Sequence[Slide], scope: Scope) -> list[tuple[str, ArcSlot]]:
    """Return the circular slots with the pins in them."""
    return list(found(_arc(s, slides, scope) for s in every(file, ast.Slot)))


def _arc(statement: ast.Slot, slides: Iterable[Slide], scope: Scope) -> tuple[str, ArcSlot] | None:
    if statement.about is None or statement.radius is None:
        return None
    held = _on_line(statement.point, statement.line, slides, scope)
    centre, radius = scope.points.acting(statement.about), _radius(statement.radius, scope)
    if held is None or not centre or radius is None:
        return None
    point, body = held[:2]
    if centre[0] not in body.points:
        at = statement.about.span
        scope.report.add(centre_of_another(at, centre[0], body.name))
        return None
    return point, ArcSlot(body.name, centre[0], radius, statement.span)


def _contact(statement: ast.Contact, slides: Iterable[Slide], scope: Scope) -> Contact | None:
    held = _on_line(statement.point, statement.line, slides, scope)
    normal = read_direction(statement.normal, scope)
    if held is None or normal is None:
        return None
    point, body, tail, head = held
    return Contact(point, body.name, tail, head, normal, statement.span)


# ------------------------------------------------------------------------------ wheels


def _mesh(statement: ast.Gear | ast.Belt, is_mirrored: bool, scope: Scope) -> WheelPair | None:
    if is_mirrored and _joins_halves(statement, scope):
        return None
    first, second = (_wheel(name, scope) for name in (statement.first, statement.second))
    radii = [_radius(r, scope) for r in (statement.first_radius, statement.second_radius)]
    if first is None or second is None or radii[0] is None or radii[1] is None:
        return None
    pivots = statement.first.text, statement.second.text
    if pivots[0] == pivots[1]:
        scope.report.add(names.repeated_point(statement.second.span, "".join(pivots), pivots[0]))
        return None
    is_gear = isinstance(statement, ast.Gear)
    same = statement.inner if isinstance(statement, ast.Gear) else not statement.crossed
    return WheelPair(
        "gear" if is_gear else "belt",
        pivots[0],
        first.name,
        radii[0],
        pivots[1],
        second.name,
        radii[1],
        same,
        statement.span,
    )


def check_belts(joints: Iterable[Joint], places: Iterable[Geometry], scope: Scope) -> None:
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
        if apart < sum(radii) * (1 - 1e-9):
            pivots = f"{mesh.first} and {mesh.second}"
            scope.report.add(messages.wheels_overlap(mesh.span, pivots, apart, sum(radii)))


def _values(formulas: Iterable[Formula], scope: Scope) -> list[float] | None:
    """Return the values at the given parameters; None where one of them has none."""
    values = [value_of(formula, scope) for formula in formulas]
    known = [value for value in values if value is not None]
    return known if len(known) == len(values) else None


def _joins_halves(statement: ast.Gear | ast.Belt, scope: Scope) -> bool:
    """Tell whether a wheel is on the twin of a described point, which is reported."""
    first, second = statement.first.text, statement.second.text
    for name in (statement.first, statement.second):
        places, described = scope.points.places, name.text.removesuffix("'")
        if name.text not in places and described in places:
            are_twins = first.removesuffix("'") == second.removesuffix("'")
            scope.report.add(messages.wheels_across_the_mirror(name.span, first, second, are_twins))
            return True
    return False


def _wheel(pivot: ast.Name, scope: Scope) -> Link | None:
    """Return the one link on a pivot, to which the wheel there is fixed."""
    points = scope.points.acting(pivot)
    if not points:
        return None
    if points[0] not in scope.points.fixed:
        scope.report.add(messages.wheel_without_pivot(pivot.span, points[0]))
        return None
    links = scope.points.carried.get(points[0], [])
    if len(links) != 1:
        scope.report.add(messages.wheel_of_several(pivot.span, points[0], [k.name for k in links]))
        return None
    scope.points.used.update(links[0].points)
    return links[0]


def _radius(radius: ast.Expr, scope: Scope, signed: bool = False) -> Formula | None:
    formula = Reader(scope, DESCRIPTION).wanted(radius, LENGTH, "a radius")
    value = value_of(formula, scope) if formula else None
    if value is not None and (value == 0 or (value < 0 and not signed)):
        scope.report.add(messages.radius_not_positive(radius.span, f"{value * 1000:g} mm"))
        return None
    return formula


def _rack(statement: ast.Rack, slides: Iterable[Slide], scope: Scope) -> Rack | None:
    point = _guided(statement.point, slides, scope)
    link = _wheel(statement.pivot, scope)
    radius = _radius(statement.radius, scope, signed=True)
    if not point or not link or not radius:
        return None
    return Rack(point, statement.pivot.text, link.name, radius, statement.span)


def _screw(statement: ast.Screw, slides: Iterable[Slide], scope: Scope) -> Screw | None:
    point = _guided(statement.point, slides, scope)
    link = scope.points.link(statement.link)
    pitch = _radius(statement.pitch, scope, signed=True)
    if not point or not link or not pitch:
        return None
    if scope.points.fixed.isdisjoint(link.points):
        scope.report.add(messages.wheel_without_pivot(statement.link.span, link.name))
        return None
    scope.points.used.update(link.points)
    return Screw(point, pitch, link.name, statement.span)


def _guided(name: ast.Name, slides: Iterable[Slide], scope: Scope) -> str | None:
    """Return a slider, or a point of a body that only translates."""
    points = scope.points.acting(name)
    if not points:
        return None
    if points[0] not in scope.points.guided.union(*(s.points for s in slides)):
        scope.report.add(messages.rack_without_guide(name.span, points[0]))
        return None
    return points[0]
