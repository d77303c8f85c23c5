"""Drawn places: what they give of lengths, angles and directions.

``A at (20 mm, 34.64 mm)`` says where a pin is at the default pose. From here on there are
only vectors: each derived length and direction becomes a parameter with a name, a constant
where the coordinates are numbers (:class:`~.sketch.Sketch`).

Without a drive, and with no length or direction given besides, every link lies as it is
drawn. Otherwise links get their shapes only, and directions follow from the loops; what is
given holds, and of several closures the one nearest to the drawn places is meant.
"""

import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise

from ...diagnostics import Report
from ...diagnostics import drawn as messages
from ...formula.tree import Formula
from ...formula.walk import substitute, symbols
from ...frozen import replace
from ..doubts import directions
from ..entries import joined_to, mentioned
from ..mechanism import (
    Along,
    Arrow,
    Contact,
    Drive,
    ForcePair,
    Geometry,
    Joint,
    Link,
    Mechanism,
    Offset,
    Parameter,
    Pivot,
    Slide,
    Slider,
    Slot,
    Turn,
)
from ..values import Chain, defaults, dependent
from .checks import faults
from .driving import drawn_value, fault_of, is_outside, with_driven, with_value
from .geared import Train, with_named_sizes
from .rigidity import Independent, Row, direction, distance, fixed, rows_of, turn
from .sketch import Sketch


def with_drawn(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with the geometry that the drawn places give.

    Reports E320 and E323 where a link cannot be driven, E321, E322 and E327 where points
    coincide, are off their lines or have no place, E326 where a range leaves out a value.
    """
    sketch = Sketch(mechanism, Chain(dependent(mechanism)).complete(defaults(mechanism)))
    for fault in faults(mechanism, sketch):
        report.add(fault)
    report.stop_on_errors()
    drive = mechanism.drive
    if drive and drive.ends:
        if undriven := fault_of(drive, drive.ends, mechanism, sketch):
            raise report.fail(undriven)
        mechanism = with_driven(mechanism, drive, drive.ends, sketch.unit)
    is_given = _is_given(mechanism, sketch)
    drawn = _closing(mechanism, sketch, report) if is_given else _as_drawn(mechanism, sketch)
    parameters = (*drawn.parameters, *sketch.parameters.values())
    given = {p.name for p in mechanism.parameters if p.value}
    return replace(drawn, parameters=_in_range(parameters, given, drive, report))


def _in_range(
    parameters: Iterable[Parameter], given: Collection[str], drive: Drive | None, report: Report
) -> tuple[Parameter, ...]:
    """Report a value of the drawing outside the range given; a stroke is no such range.

    Values that are ``given`` are none of the drawing.
    """
    found = list[Parameter]()
    for parameter in parameters:
        outside = parameter.name not in given and is_outside(parameter)
        is_stroke = drive is not None and drive.ends and parameter.name == drive.parameter
        if outside and not is_stroke:
            report.add(messages.drawn_outside_range(parameter.span, parameter.name))
        found.append(replace(parameter, range=None) if outside else parameter)
    report.stop_on_errors()
    return tuple(found)


def _is_given(mechanism: Mechanism, sketch: Sketch) -> bool:
    """Return whether more is given of the pose than the places of points."""
    pairs = (g for g in mechanism.geometry if not isinstance(g, Offset) or g.tail)
    return mechanism.drive is not None or any(map(sketch.has, pairs))


# ------------------------------------------------------------------------ as it is drawn


def _as_drawn(mechanism: Mechanism, sketch: Sketch) -> Mechanism:
    """Return the mechanism with every vector as it is drawn; a guide is then but a direction."""
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.tail, slot.head, slot.point)):
            sketch.lay_on_line(slot.point, slot.tail, slot.head)
    found: list[Geometry] = []
    for points in (*(body.points for body in mechanism.bodies), *_aims(mechanism)):
        for hub, point in sketch.arms(points):
            found.append(_vector(hub, point, sketch))
    for tail, point in _touching(mechanism):
        vectors = (*mechanism.geometry, *found)
        if sketch.has_all((tail, point)) and point not in joined_to(tail, vectors):
            found.append(_vector(tail, point, sketch))
    joints = tuple(
        replace(joint, through=None)
        if isinstance(joint, Slider) and joint.point in sketch.places
        else joint
        for joint in mechanism.joints
    )
    return replace(mechanism, joints=joints, geometry=(*mechanism.geometry, *found))


def _vector(tail: str, head: str, sketch: Sketch) -> Geometry:
    """Return a vector by length and direction; by components where these are formulas."""
    x, y = sketch.offset(tail, head)
    if sketch.polar(tail, head):
        direction = sketch.direction(tail, head)
        return Arrow(tail, head, sketch.length(tail, head), direction, sketch.span(head))
    if symbols(x) | symbols(y):
        return Offset(tail, head, x, y, sketch.span(head))
    return Arrow(tail, head, *sketch.vector(tail, head), sketch.span(head))


def _aims(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield two points between which a pair of forces or a rope acts, or which give a direction.

    A slot has the direction of its pin where it is drawn by that only.
    """
    yield from ((t.first, t.second) for t in mechanism.loads if isinstance(t, ForcePair))
    yield from ((d.tail, d.head) for d in directions(mechanism) if isinstance(d, Along))
    yield from (ends for rope in mechanism.ropes for ends in pairwise(rope.route))
    drawn = {d.point for d in mechanism.drawn}
    yield from ((s.tail, s.point) for s in mechanism.each(Slot) if s.head not in drawn)


def _touching(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield the arms on which links are pushed by what touches them, or slides in them."""
    turning = {link.name for link in mechanism.links}
    yield from ((s.tail, s.point) for s in mechanism.each(Slot) if s.link in turning)
    yield from ((c.tail, c.point) for c in mechanism.each(Contact) if c.link in turning)


# ------------------------------------------------------------------- by closing the loops


def _closing(mechanism: Mechanism, sketch: Sketch, report: Report) -> Mechanism:
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
    return _with_coordinates(replace(mechanism, geometry=tuple(geometry)), sketch, report)


def _driven(mechanism: Mechanism) -> dict[str, Formula]:
    """Return the values of the driving parameter and of all that follows from it."""
    drive = mechanism.drive.parameter if mechanism.drive else ""
    found = {p.name: p.value for p in mechanism.parameters if p.name == drive and p.value}
    for name, formula in Chain(dependent(mechanism)).definitions:
        if found and not found.keys().isdisjoint(symbols(formula)):
            found[name] = substitute(formula, found)
    return found


def _moved(
    mechanism: Mechanism, driven: Collection[str], sketch: Sketch
) -> Iterator[Arrow | Offset]:
    """Yield the entries by which the drive moves points: arms of links, sliders."""
    for link in mechanism.links:
        for hub, point in sketch.arms(link.points):
            found = sketch.polar(hub, point)
            if found and not found.angle.names.isdisjoint(driven):
                direction = sketch.direction(hub, point)
                yield Arrow(hub, point, sketch.length(hub, point), direction, sketch.span(point))
    for slider in mechanism.each(Slider):
        place = sketch.places.get(slider.point)
        if place and not slider.through and not place.symbols.isdisjoint(driven):
            yield Offset("", slider.point, place.x, place.y, place.span)


def _through_places(mechanism: Mechanism, sketch: Sketch, placed: Collection[str]) -> Mechanism:
    """Let guides that have no place pass through where their points are drawn, or ``placed``."""
    pivots, offsets, joints = list[Pivot](), list[Geometry](), list[Joint]()
    for joint in (*mechanism.joints, *_guides_of_slides(mechanism, sketch)):
        is_open = isinstance(joint, Slider) and not joint.through and joint.point not in placed
        if isinstance(joint, Slider) and is_open and joint.point in sketch.places:
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
            yield Slider(drawn, slide.along, slide.span)


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
        case Arrow(tail, head, _, Along(start, end)):
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


def _with_coordinates(mechanism: Mechanism, sketch: Sketch, report: Report) -> Mechanism:
    """Return the mechanism with all that moves it standing as drawn.

    The drive has its value of the drawing, where it has none. Where all pins are drawn, so
    has a parameter that no loop gives one; what wheels alone lead moves as they do, and a
    link that nothing turns has the direction of the drawing. Reports E516.
    """
    waiting = {p.name: p for p in mechanism.parameters if p.value is None}
    held = Independent(_held(mechanism, waiting, sketch))
    is_whole = sketch.has_all(_pins(mechanism))
    found = {
        name: with_value(waiting[name], value)
        for name, value in _drawn_values(mechanism, waiting, held, sketch)
        if is_whole or (mechanism.drive and name == mechanism.drive.parameter)
    }
    parameters = tuple(found.get(p.name, p) for p in mechanism.parameters)
    valued = replace(mechanism, parameters=parameters)
    if not is_whole:
        return valued
    standing = (*_led(valued, held, sketch, report), *_standing(mechanism, held, sketch))
    return replace(valued, geometry=(*mechanism.geometry, *standing))


def _drawn_values(
    mechanism: Mechanism, waiting: Collection[str], held: Independent, sketch: Sketch
) -> Iterator[tuple[str, float]]:
    """Yield parameters as measured in the drawing: the drive, and those that no loop gives.

    What ``waiting`` parameters give is held from then on.
    """
    drive = mechanism.drive.parameter if mechanism.drive else ""
    parts = [part for entry in mechanism.geometry for part in _parts(entry)]
    left = {n: _of(n, parts) for part in parts for n in sorted(mentioned(part) & set(waiting))}
    while left:
        by_loop = [n for n in left if any(_follows(part, held, sketch) for part in left[n])]
        name = drive if drive in left else next(iter(by_loop or left))
        given = left.pop(name)
        value = _measured(name, given, sketch)
        if value is not None and (name == drive or name not in by_loop):
            yield name, value
        for part in given:
            if mentioned(part).isdisjoint(left):
                _hold(part, held, sketch)


def _measured(name: str, parts: Iterable[Geometry], sketch: Sketch) -> float | None:
    """Return a parameter as measured in the drawing, by the first part that shows it."""
    values = (drawn_value(name, part, sketch) for part in parts)
    return next((value for value in values if value is not None), None)


def _hold(part: Geometry, held: Independent, sketch: Sketch) -> None:
    for row in rows_of(part, sketch):
        held.takes(row)


def _parts(entry: Geometry) -> tuple[Geometry, ...]:
    """Return the length and the direction of a vector by themselves."""
    if isinstance(entry, Arrow) and entry.length and entry.direction:
        return replace(entry, direction=None), replace(entry, length=None)
    return (entry,)


def _of(name: str, parts: Iterable[Geometry]) -> list[Geometry]:
    return [part for part in parts if name in mentioned(part)]


def _follows(part: Geometry, held: Independent, sketch: Sketch) -> bool:
    """Return whether what an entry gives is held already."""
    rows = list(rows_of(part, sketch))
    return bool(rows) and not any(map(held.lacks, rows))


def _led(
    mechanism: Mechanism, held: Independent, sketch: Sketch, report: Report
) -> Iterator[Geometry]:
    """Yield where links and sliders are that wheels alone lead, as the drive moves."""
    if mechanism.drive is None:
        return
    values = Chain(dependent(mechanism)).complete(defaults(mechanism))
    train = Train(mechanism, sketch, values)
    yield from train.followers(held)
    train.check(held, report)


def _pins(mechanism: Mechanism) -> frozenset[str]:
    """Return the points at which bodies are joined."""
    carried = Counter(p for body in mechanism.bodies for p in body.points)
    ground = mechanism.fixed | {s.point for s in mechanism.each(Slider)}
    return frozenset(p for p, number in carried.items() if number > 1 or p in ground)


def _standing(mechanism: Mechanism, held: Independent, sketch: Sketch) -> Iterator[Geometry]:
    """Yield the drawn directions of links that nothing turns."""
    for link in mechanism.links:
        arm = next(sketch.arms(link.points), None)
        if arm and held.takes(direction(*arm, sketch)):
            yield Arrow(*arm, None, sketch.direction(*arm), sketch.span(arm[1]))


def _held(mechanism: Mechanism, waiting: Collection[str], sketch: Sketch) -> Iterator[Row]:
    """Yield the rows that hold the drawn points: pivots, guides, slots, vectors.

    A vector holds none while a parameter in it is ``waiting`` for its value.
    """
    for pivot in mechanism.each(Pivot):
        yield from (fixed(pivot.point, turned) for turned in (0.0, math.pi / 2))
    guided = [(s.point, s.along) for s in mechanism.each(Slider)]
    guided += [(s.points[0], s.along) for s in mechanism.slides]
    for point, along in guided:
        if (turned := sketch.turned(along)) is not None:
            yield fixed(point, turned)
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.tail, slot.head, slot.point)):
            yield turn(slot.head, slot.tail, slot.point, sketch)
    for entry in mechanism.geometry:
        for part in _parts(entry):
            if mentioned(part).isdisjoint(waiting):
                yield from rows_of(part, sketch)
