"""A mechanism that moves: its bodies have the shapes of the drawing, and loops close them."""

from collections.abc import Collection, Iterator

from ...base.frozen import replace
from ...diagnostics import Report
from ...formula.tree import Formula
from ...formula.walk import substitute, symbols
from ..mechanism import (
    AlongLine,
    Arrow,
    Geometry,
    Joint,
    Link,
    Mechanism,
    Offset,
    Pivot,
    Slide,
    Slider,
    Slot,
    Turn,
)
from ..values import following
from .coordinates import with_coordinates
from .geared import with_named_sizes
from .rigidity import Independent, distance, rows_of, turn
from .sketch import Sketch


def closing(mechanism: Mechanism, sketch: Sketch, report: Report) -> Mechanism:
    """Return the mechanism with the shapes of its bodies as drawn, for loops to close.

    Coordinates that the drive is in say how it moves; for all else they are those of the
    default pose.
    """
    driven = _driven(mechanism)
    moved = tuple(_moved(mechanism, driven.keys(), sketch))
    sketch.put(driven)
    guided = frozenset(entry.head for entry in moved if not entry.tail)
    mechanism = with_named_sizes(_through_places(mechanism, sketch, guided), sketch)
    geometry = [*mechanism.geometry, *moved]
    for link in mechanism.links:
        _shape(link, geometry, sketch)
    for slide in mechanism.slides:
        _lay_out(slide, geometry, sketch)
    geometry += _guided(mechanism, sketch)
    known = {frozenset((g.tail, g.head)) for g in geometry if not isinstance(g, Turn)}
    for telescope in mechanism.telescopes:
        if frozenset(telescope.points) not in known and sketch.has_all(telescope.points):
            geometry.append(Arrow(*telescope.points, None, None, telescope.span))
    return with_coordinates(replace(mechanism, geometry=tuple(geometry)), sketch, report)


def _driven(mechanism: Mechanism) -> dict[str, Formula]:
    """Return the values of the driving parameter and of all that follows from it."""
    drive = mechanism.drive_name
    found = {p.name: p.value for p in mechanism.parameters if p.name == drive and p.value}
    for name, formula in following(mechanism).definitions:
        if found and not found.keys().isdisjoint(symbols(formula)):
            found[name] = substitute(formula, found)
    return found


def _moved(
    mechanism: Mechanism, driven: Collection[str], sketch: Sketch
) -> Iterator[Arrow | Offset]:
    """Yield the entries by which the drive moves points: arms of links, sliders on any guide."""
    for link in mechanism.links:
        for hub, point in sketch.arms(link.points):
            found = sketch.polar(hub, point)
            if found and not found.angle.names.isdisjoint(driven):
                direction = sketch.direction(hub, point)
                yield Arrow(hub, point, sketch.length(hub, point), direction, sketch.span(point))
    for slider in mechanism.each(Slider):
        place = sketch.places.get(slider.point)
        if place and not place.symbols.isdisjoint(driven):
            yield Offset("", slider.point, place.x, place.y, place.span)


def _through_places(mechanism: Mechanism, sketch: Sketch, placed: Collection[str]) -> Mechanism:
    """Return the mechanism with guides that had no place through points drawn, or ``placed``.

    Where arrows lead to a point from the ground its guide is but a direction, drawn or not.
    """
    pivots, offsets, joints = list[Pivot](), list[Geometry](), list[Joint]()
    shown = sketch.places.keys() - sketch.given
    for joint in (*mechanism.joints, *_guides_of_slides(mechanism, sketch)):
        is_open = isinstance(joint, Slider) and not joint.through and joint.point not in placed
        if isinstance(joint, Slider) and is_open and joint.point in shown:
            name, span = f"{joint.point}_0", sketch.span(joint.point)
            place = sketch.places[joint.point]
            pivots.append(Pivot(name, span))
            offsets.append(Offset("", name, place.x, place.y, span))
            joint = replace(joint, through=name)
        joints.append(joint)
    geometry = (*mechanism.geometry, *offsets)
    return replace(mechanism, joints=(*pivots, *joints), geometry=geometry)


def _guides_of_slides(mechanism: Mechanism, sketch: Sketch) -> Iterator[Slider]:
    """Yield a guide for each drawn slide whose guide no slider places."""
    guided = {slider.point for slider in mechanism.each(Slider)}
    for slide in mechanism.slides:
        drawn = next((p for p in slide.points if p in sketch.places), None)
        if drawn and guided.isdisjoint(slide.points):
            yield Slider(drawn, slide.along, slide.span, is_of_slide=True)


def _shape(link: Link, geometry: list[Geometry], sketch: Sketch) -> None:
    """Add the lengths and angles of a body that are not given."""
    arms = list(sketch.arms(link.points))
    given = Independent(row for g in geometry if _inside(g, link) for row in rows_of(g, sketch))
    for hub, point in arms:
        if given.takes(distance(hub, point, sketch)):
            _give_length(geometry, hub, point, sketch)
    for hub, point in arms[1:]:
        first = arms[0][1]
        if given.takes(turn(first, hub, point, sketch)):
            angle = sketch.turn(first, hub, point)
            geometry.append(Turn(first, hub, point, angle, sketch.span(point)))


def _guided(mechanism: Mechanism, sketch: Sketch) -> Iterator[Geometry]:
    """Yield the drawn angles between slots and the links that are fast in their blocks."""
    for slot in mechanism.each(Slot):
        points = mechanism.link(slot.guided).points if slot.guided else ()
        for other in (p for p in points if p != slot.point):
            if sketch.has_all((slot.tail, slot.point, other)):
                angle = sketch.turn(slot.tail, slot.point, other)
                yield Turn(slot.tail, slot.point, other, angle, slot.span)
                break


def _inside(entry: Geometry, link: Link) -> bool:
    match entry:
        case Turn(first, vertex, second):
            return {first, vertex, second} <= set(link.points)
        case Arrow(tail, head, _, AlongLine(start, end)):
            return {tail, head, start, end} <= set(link.points)
        case _:
            return {entry.tail, entry.head} <= set(link.points)


def _give_length(geometry: list[Geometry], hub: str, point: str, sketch: Sketch) -> None:
    """Give a vector its length: the entry that has its direction, or one of its own."""
    for i, entry in enumerate(geometry):
        if isinstance(entry, Arrow) and {entry.tail, entry.head} == {hub, point}:
            geometry[i] = replace(entry, length=sketch.length(entry.tail, entry.head))
            return
    geometry.append(Arrow(hub, point, sketch.length(hub, point), None, sketch.span(point)))


def _lay_out(slide: Slide, geometry: list[Geometry], sketch: Sketch) -> None:
    """Add the vectors of a slide, which does not turn."""
    known = {frozenset((g.tail, g.head)) for g in geometry if not isinstance(g, Turn)}
    for hub, point in sketch.arms(slide.points):
        if frozenset((hub, point)) not in known:
            geometry.append(Offset(hub, point, *sketch.offset(hub, point), sketch.span(point)))
