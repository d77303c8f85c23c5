"""Drawn places: what they give of lengths, angles and directions.

``A at (20 mm, 34.64 mm)`` says where a pin is at the default pose. From here on there are
only vectors: each derived length and direction becomes a parameter with a name, a constant
where the coordinates are numbers (:class:`~.sketch.Sketch`).

Without a drive, and with no length or direction given besides, every link lies as it is
drawn. Otherwise links get their shapes only, and directions follow from the loops; what is
given holds, and of several closures the one nearest to the drawn places is meant.
"""

import math
from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise

from ...base.frozen import replace
from ...diagnostics import Diagnostic, Report
from ...diagnostics import drawn_places as messages
from ...formula.walk import symbols
from ..entries import directions, joined_to, points_of
from ..mechanism import (
    AlongLine,
    Arrow,
    Contact,
    Drawn,
    Drive,
    Force,
    ForcePair,
    Geometry,
    Mechanism,
    Offset,
    Parameter,
    Pivot,
    Slider,
    Slot,
)
from ..values import default_pose
from .closing import closing
from .driving import fault_of, is_outside, with_driven
from .ropes import falls_off_drums, turned_falls, wraps_otherwise
from .sketch import Sketch


def with_drawn(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with the geometry that the drawn places give.

    It is drawn with the values of the description: one from ``outside`` moves what is drawn, as
    an argument of the code does, and makes no other mechanism of it.

    Reports E320 and E323 where a link cannot be driven, E321, E322 and E327 where points
    coincide, are off their lines or have no place, E326 where a range leaves out a value.
    """
    described = tuple(map(_as_described, mechanism.parameters))
    return _with_drawn(replace(mechanism, parameters=described), report)


def _as_described(parameter: Parameter) -> Parameter:
    """Return a parameter with the value that its own line has, if it has one."""
    value = parameter.replaced
    if value is None:
        return parameter
    dependent = bool(symbols(value))
    return replace(parameter, value=value, dependent=dependent, outside=parameter.value)


def _with_drawn(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with what is driven as drawn, and the geometry of the drawing."""
    sketch = Sketch(mechanism, default_pose(mechanism))
    for fault in _faults(mechanism, sketch):
        report.add(fault)
    report.stop_on_errors()
    for drive in mechanism.drives:
        if drive.ends:
            if undriven := fault_of(drive, drive.ends, mechanism, sketch):
                raise report.fail(undriven)
            mechanism = with_driven(mechanism, drive, drive.ends, sketch.unit)
    is_given = _is_given(mechanism, sketch)
    drawn = closing(mechanism, sketch, report) if is_given else _as_drawn(mechanism, sketch)
    for point in without_effect(mechanism, drawn):
        report.add(messages.place_unused(point.span, point.point, unplaced_pivot(mechanism)))
    parameters = (*drawn.parameters, *sketch.parameters.values())
    given = {p.name for p in mechanism.parameters if p.value}
    return replace(drawn, parameters=_in_range(parameters, given, mechanism.drives, report))


def _in_range(
    parameters: Iterable[Parameter],
    given: Collection[str],
    drives: Iterable[Drive],
    report: Report,
) -> tuple[Parameter, ...]:
    """Report a value of the drawing outside the range given; a stroke is no such range.

    Values that are ``given`` are none of the drawing.
    """
    found = list[Parameter]()
    strokes = {drive.parameter for drive in drives if drive.ends}
    for parameter in parameters:
        outside = parameter.name not in given and is_outside(parameter)
        if outside and parameter.name not in strokes:
            report.add(messages.drawn_outside_range(parameter.span, parameter.name))
        found.append(replace(parameter, range=None) if outside else parameter)
    report.stop_on_errors()
    return tuple(found)


def _is_given(mechanism: Mechanism, sketch: Sketch) -> bool:
    """Return whether more is given of the pose than the places of points."""
    pairs = (g for g in mechanism.geometry if not isinstance(g, Offset) or g.tail)
    return mechanism.drive is not None or any(map(sketch.has, pairs))


def without_effect(before: Mechanism, drawn: Mechanism) -> Iterator[Drawn]:
    """Yield the drawn points of which no vector was made, and that no placed point is tied to.

    ``before`` is the mechanism without the vectors that its drawing gives.
    """
    own = set(map(id, before.geometry))
    made = [entry for entry in drawn.geometry if id(entry) not in own]
    used = {point for entry in made for point in points_of(entry)} | _tied(drawn.geometry)
    yield from (each for each in before.drawn if each.point not in used)


def _tied(geometry: tuple[Geometry, ...]) -> set[str]:
    """Return the points to which vectors lead from the origin of coordinates."""
    found, left = {""}, list(geometry)
    while near := [entry for entry in left if not found.isdisjoint(points_of(entry))]:
        found.update(point for entry in near for point in points_of(entry))
        left = [entry for entry in left if entry not in near]
    return found


def unplaced_pivot(mechanism: Mechanism) -> str:
    """Return the first pivot that has no place, '' where all have one."""
    placed = {g.head for g in mechanism.geometry if isinstance(g, Offset) and not g.tail}
    pivots = (pivot.point for pivot in mechanism.each(Pivot))
    return next((point for point in pivots if point not in placed), "")


# ----------------------------------------------------------------------------------------- as drawn


def _as_drawn(mechanism: Mechanism, sketch: Sketch) -> Mechanism:
    """Return the mechanism with every vector as it is drawn; a guide is then but a direction."""
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.tail, slot.head, slot.point)):
            sketch.lay_on_line(slot.point, slot.tail, slot.head)
    found: list[Geometry] = []
    for points in (*(body.points for body in mechanism.bodies), *_aims(mechanism)):
        for hub, point in sketch.arms(points):
            found.append(_drawn_vector(hub, point, sketch))
    for tail, point in _touching(mechanism):
        vectors = (*mechanism.geometry, *found)
        if sketch.has_all((tail, point)) and point not in joined_to(tail, vectors):
            found.append(_drawn_vector(tail, point, sketch))
    joints = tuple(
        replace(joint, through=None)
        if isinstance(joint, Slider) and joint.point in sketch.places
        else joint
        for joint in mechanism.joints
    )
    return replace(mechanism, joints=joints, geometry=(*mechanism.geometry, *found))


def _drawn_vector(tail: str, head: str, sketch: Sketch) -> Geometry:
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
    yield from ((d.tail, d.head) for d in directions(mechanism) if isinstance(d, AlongLine))
    yield from (ends for rope in mechanism.ropes for ends in pairwise(rope.route))
    drawn = {d.point for d in mechanism.drawn}
    yield from ((s.tail, s.point) for s in mechanism.each(Slot) if s.head not in drawn)


def _touching(mechanism: Mechanism) -> Iterator[tuple[str, str]]:
    """Yield the arms on which links are pushed by what touches them, or slides in them."""
    turning = {link.name for link in mechanism.links}
    yield from ((s.tail, s.point) for s in mechanism.each(Slot) if s.link in turning)
    yield from ((c.tail, c.point) for c in mechanism.each(Contact) if c.link in turning)


# ------------------------------------------------------------------------------------------- checks


def _faults(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield E321, E322, E327, E345 and W349 to W352."""
    yield from _without_place(mechanism, sketch)
    yield from _coinciding(mechanism, sketch)
    yield from _off_line(mechanism, sketch)
    yield from turned_falls(mechanism, sketch)
    yield from wraps_otherwise(mechanism, sketch)
    yield from falls_off_drums(mechanism, sketch)


def _without_place(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points of links that are drawn nowhere, and that no vector leads to."""
    placed = sketch.places.keys() | {p for g in mechanism.geometry for p in points_of(g)}
    placed |= {slot.head for slot in mechanism.each(Slot)}  # it may but name the line
    for point in dict.fromkeys(p for link in mechanism.links for p in link.points):
        if mechanism.drawn and point not in placed:
            is_pivot = point in sketch.pivots
            yield messages.drawn_nowhere(mechanism.spans[point], point, is_pivot)


def _coinciding(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points of a body at the place of another one of it.

    The resultant of a load that is spread may act there: its point is nobody's.
    """
    made = {k.point for k in mechanism.loads if isinstance(k, Force) and k.spread}
    for points in (body.points for body in mechanism.bodies):
        for hub, point in sketch.arms(points):
            if point not in made and sketch.coincide(hub, point):
                at, first = sketch.span(point), sketch.span(hub)
                yield messages.drawn_together(at, "".join(points), point, hub, first)


def _off_line(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points that are drawn off the line along which they slide.

    One to which a vector leads is on its line where the loop closes: what is drawn gives way.
    """
    slack = {d.point: d.slack for d in mechanism.drawn}
    for point, start, line, turned in _lines(mechanism, sketch):
        x, y = sketch.way(start, point)
        gap = abs(y * math.cos(turned) - x * math.sin(turned))
        allowed = slack.get(point, 0.0) + slack.get(start, 0.0) + sketch.rounding
        if point not in sketch.led and gap > allowed:
            yield messages.drawn_off_guide(sketch.span(point), point, line, sketch.shown(gap))


def _lines(mechanism: Mechanism, sketch: Sketch) -> Iterator[tuple[str, str, str, float]]:
    """Yield each drawn point on a line, a point of the line, its name, and its direction."""
    for s in mechanism.each(Slider):
        turned = sketch.turned(s.along)
        if turned is not None and s.through and sketch.has_all((s.point, s.through)):
            yield s.point, s.through, f"the guide through {s.through}", turned
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.point, slot.tail, slot.head)):
            x, y = sketch.way(slot.tail, slot.head)
            line = f"the slot {slot.tail}{slot.head}"
            yield slot.point, slot.tail, line, math.atan2(y, x)
