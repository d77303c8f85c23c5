"""Bodies and joints beyond links, pins and guides: slides, telescopes, slots, gears, screws."""

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TypeVar

from ...base.frozen import replace
from ...diagnostics.model import circular_slots as slot_messages
from ...diagnostics.model import joints as messages
from ...diagnostics.model import wheels
from ...syntax import ast
from ..formulas.directions import read_direction
from ..mechanism import (
    AlongLine,
    ArcSlot,
    Contact,
    Direction,
    Joint,
    Link,
    Rack,
    Rope,
    Screw,
    Slide,
    Slot,
    Telescope,
)
from ..names.scope import NameScope
from ..statements import every
from .wheels import radius_of, read_wheels, wheel_on


def read_slides(file: ast.File, scope: NameScope) -> tuple[Slide, ...]:
    """Return the bodies that only translate."""
    loose = {s.point.text for s in every(file, ast.Slider) if s.through is None}
    return tuple(found(_slide(s, loose, scope) for s in every(file, ast.Slide)))


def read_telescopes(file: ast.File, scope: NameScope) -> tuple[Telescope, ...]:
    """Return the links of variable length."""
    return tuple(found(_telescope(s, scope) for s in every(file, ast.Telescope)))


def read_joints(file: ast.File, slides: Sequence[Slide], scope: NameScope) -> tuple[Joint, ...]:
    """Return every joint of the description that is neither pin nor guide, kind by kind."""
    return (
        *found(_slot(s, slides, scope) for s in every(file, ast.Slot) if s.about is None),
        *found(_contact(s, slides, scope) for s in every(file, ast.Contact)),
        *read_wheels(file, scope),
        *found(_rack(s, slides, scope) for s in every(file, ast.Rack)),
        *found(_screw(s, slides, scope) for s in every(file, ast.Screw)),
        *read_ropes(file, scope),
    )


T = TypeVar("T")


def found(items: Iterable[T | None]) -> Iterable[T]:
    """Yield the parts that were read without an error."""
    return (item for item in items if item is not None)


def _slide(statement: ast.Slide, loose: Collection[str], scope: NameScope) -> Slide | None:
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


def _telescope(statement: ast.Telescope, scope: NameScope) -> Telescope | None:
    points = scope.points.known(statement.points)
    if not points:
        return None
    if link := scope.points.bodies.get(frozenset(points)):
        scope.report.add(messages.link_again(statement.span, statement.points.text, link.span))
    return Telescope(statement.points.text, (points[0], points[1]), statement.span)


def _body(name: ast.Name, slides: Iterable[Slide], scope: NameScope) -> Link | Slide | None:
    """Return the link or slide that points name."""
    points = scope.points.known(name)
    if not points:
        return None
    slide = next((s for s in slides if set(points) <= set(s.points)), None)
    return slide or scope.points.link(name)


def _on_line(
    point: ast.Name, line: ast.Name, slides: Iterable[Slide], scope: NameScope
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


def _slot(statement: ast.Slot, slides: Iterable[Slide], scope: NameScope) -> Slot | None:
    held = _on_line(statement.point, statement.line, slides, scope)
    if held is None:
        return None
    point, body, tail, head = held
    slot = Slot(point, body.name, tail, head, statement.span)
    return _guiding(slot, statement.guided, scope) if statement.guided else slot


def _guiding(slot: Slot, name: ast.Name, scope: NameScope) -> Slot | None:
    """Return a slot whose block is fast in a link, which has to have the pin."""
    guided = scope.points.link(name)
    if guided is None:
        return None
    if slot.point not in guided.points:
        scope.report.add(wheels.joint_of_another(name.span, slot.point, guided.name, "slides"))
        return None
    scope.points.used.update(guided.points)
    return replace(slot, guided=guided.name)


def read_arcs(
    file: ast.File, slides: Sequence[Slide], scope: NameScope
) -> list[tuple[str, ArcSlot]]:
    """Return the circular slots with the pins in them."""
    return list(found(_arc(s, slides, scope) for s in every(file, ast.Slot)))


def _arc(
    statement: ast.Slot, slides: Iterable[Slide], scope: NameScope
) -> tuple[str, ArcSlot] | None:
    """Return a circular slot with its pin; None where an error was reported."""
    if statement.about is None or statement.radius is None:
        return None
    held = _on_line(statement.point, statement.line, slides, scope)
    centre, radius = scope.points.acting(statement.about), radius_of(statement.radius, scope)
    if held is None or not centre or radius is None:
        return None
    point, body = held[:2]
    if centre[0] not in body.points:
        at = statement.about.span
        scope.report.add(slot_messages.centre_of_another(at, centre[0], body.name))
        return None
    return point, ArcSlot(body.name, centre[0], radius, statement.span)


def _contact(statement: ast.Contact, slides: Iterable[Slide], scope: NameScope) -> Contact | None:
    held = _on_line(statement.point, statement.line, slides, scope)
    normal = read_direction(statement.normal, scope)
    if held is None or normal is None:
        return None
    point, body, tail, head = held
    return Contact(point, body.name, tail, head, normal, statement.span)


# ------------------------------------------------------------------- racks, screws


def _rack(statement: ast.Rack, slides: Iterable[Slide], scope: NameScope) -> Rack | None:
    point = _guided(statement.point, slides, scope)
    link = wheel_on(statement.pivot, scope)
    radius = radius_of(statement.radius, scope, signed=True)
    if not point or not link or not radius:
        return None
    return Rack(point, statement.pivot.text, link.name, radius, statement.span)


def _screw(statement: ast.Screw, slides: Iterable[Slide], scope: NameScope) -> Screw | None:
    """Return a screw; None where an error was reported."""
    point = _guided(statement.point, slides, scope)
    link = scope.points.link(statement.link)
    pitch = radius_of(statement.pitch, scope, signed=True, what="a pitch")
    if not point or not link or not pitch:
        return None
    if scope.points.fixed.isdisjoint(link.points):
        scope.report.add(wheels.wheel_without_pivot(statement.link.span, link.name))
        return None
    scope.points.used.update(link.points)
    return Screw(point, pitch, link.name, statement.span)


def _guided(name: ast.Name, slides: Iterable[Slide], scope: NameScope) -> str | None:
    """Return a slider, or a point of a body that only translates."""
    points = scope.points.acting(name)
    if not points:
        return None
    if points[0] not in scope.points.guided.union(*(s.points for s in slides)):
        scope.report.add(wheels.rack_without_guide(name.span, points[0]))
        return None
    return points[0]


def read_ropes(file: ast.File, scope: NameScope) -> Iterator[Rope]:
    """Yield the ropes; their lengths determine no pose, so that none goes with a drive."""
    for statement in every(file, ast.Rope):
        rope = _rope(statement, scope)
        if rope:
            _warn_of_friction(rope, file, scope)
            yield rope
        for drive in every(file, ast.Drive):
            scope.report.add(messages.rope_with_drive(statement.span, drive.span))


def _rope(statement: ast.Rope, scope: NameScope) -> Rope | None:
    """Return a rope; None where an error was reported."""
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


def _warn_of_friction(rope: Rope, file: ast.File, scope: NameScope) -> None:
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
    tail: ast.Name, head: ast.Name, along: ast.Direction | None, scope: NameScope
) -> Direction | None:
    """Return the direction of a fall: that which is written, else from point to point."""
    if along is not None:
        return read_direction(along, scope)
    return AlongLine(tail.text, head.text, 0, head.span)
