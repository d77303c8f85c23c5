"""What is drawn of each joint, in one half or its twin, and where to draw it."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import assert_never

from ..base.frozen import replace
from ..model import mechanism as model
from ..pose.places import Plane, direction
from ..pose.pose import PointContact
from . import figure as drawn
from .figure import Part
from .half import Half
from .linear_vectors import DrawnVector, Linear, LinearVectors, open_vector
from .wheels import Circle, pitch_point, rope_runs, runs

DOWN, UP, LEFT, RIGHT = Plane(0.0, -1.0), Plane(0.0, 1.0), Plane(-1.0, 0.0), Plane(1.0, 0.0)
GROUNDS = (DOWN, UP, LEFT, RIGHT, *(direction(math.radians(45 + 90 * i)) for i in (2, 3, 1, 0)))
"""Where the ground may be, seen from a pivot: the usual places first."""

APART = math.radians(50)
"""The angle between the ground of a pivot and the bars that leave it, where there is room."""

PIN_BESIDE_SLIDE = 0.25
"""How far from a slide a pin is drawn that touches it, in usual lengths."""

PULLEY = 0.07
"""The radius at which a pulley is drawn, in usual lengths."""


def joints_shown(mechanism: model.Mechanism) -> Iterator[model.Joint]:
    """Yield the joints of a mechanism; a place that a guide goes through is no pivot."""
    places = {s.through for s in mechanism.each(model.Slider)} - mechanism.spans.keys()
    guided = [s.point for s in mechanism.each(model.Slider)]
    guided += [point for slide in mechanism.slides for point in slide.points]
    places |= {f"{point}_0" for point in guided}
    for joint in mechanism.joints:
        if not isinstance(joint, model.Pivot) or joint.point not in places:
            yield joint


def lost_places(mechanism: model.Mechanism) -> Iterator[str]:
    """Yield the places of guides that no longer name them: ``C_0`` of slider C.

    Nothing of a drawn mechanism that stands still shows where they are.
    """
    for slider in mechanism.each(model.Slider):
        if slider.through is None:
            yield f"{slider.point}_0"


# --------------------------------------------------------------------- where it is drawn


def loose_vectors(vectors: LinearVectors) -> Iterator[DrawnVector]:
    """Yield where to draw what touches, meshes or slides, where nothing else says it."""
    mechanism, slides = vectors.pose.mechanism, vectors.pose.slides
    for contact in vectors.pose.contacts:
        if contact.kind == "contact" and not contact.reach:
            yield open_vector(contact.tail, contact.point, _beside(contact, vectors))
    for joint in mechanism.joints:
        yield from _loose(joint, vectors)
    for slide in mechanism.slides:
        first, *others = slide.points
        line = vectors.unit(slides[slide.name])
        yield from (open_vector(first, p, line.times(i)) for i, p in enumerate(others, 1))


def _loose(joint: model.Joint, vectors: LinearVectors) -> Iterator[DrawnVector]:
    """Yield the vectors by which a joint holds points together that no link joins."""
    match joint:
        case model.WheelPair(first=first, second=second):
            yield DrawnVector(
                first, second, Linear(_away(joint, vectors).times(_apart(joint, vectors)))
            )
        case model.Rack(point, pivot):
            yield DrawnVector(pivot, point, Linear(vectors.right(joint)))
        case model.Screw():
            yield _beside_screw(joint, vectors)
        case model.Rope(route):
            lines = zip(pairwise(route), vectors.pose.falls[joint.id], strict=True)
            yield from (open_vector(tail, head, vectors.unit(line)) for (tail, head), line in lines)
        case model.Pivot() | model.Slider() | model.Slot() | model.Contact():
            pass
        case _:
            assert_never(joint)


def _beside_screw(screw: model.Screw, vectors: LinearVectors) -> DrawnVector:
    """Return where to draw a nut: nuts on one screw stand in a row."""
    mechanism = vectors.pose.mechanism
    link = mechanism.link(screw.link)
    number = mechanism.each(model.Screw).index(screw) + 1
    return open_vector(link.points[0], screw.point, vectors.guide(screw.point).times(number))


def _beside(contact: PointContact, vectors: LinearVectors) -> Plane:
    """Return where a pin touches a slide, from its first point: on the side it is pushed to."""
    frame = vectors.pose.frames[contact.body]
    row = 0 if any(frame.values()) else len(frame) - 1
    middle = vectors.unit(vectors.pose.slides[contact.body]).times(row / 2)
    return middle.plus(vectors.unit(contact.normal).times(PIN_BESIDE_SLIDE))


def _away(mesh: model.WheelPair, vectors: LinearVectors) -> Plane:
    """Return in which direction wheels stand in a row: away from a rack, if there is one."""
    racks = vectors.pose.mechanism.each(model.Rack)
    driven = [vectors.right(r).unit() for r in racks if r.pivot in (mesh.first, mesh.second)]
    right = (driven[0] if driven else None) or Plane(-1.0, 0.0)
    on_first = any(r.pivot == mesh.first for r in racks) or not driven
    return right.times(-1 if on_first else 1)


def _apart(mesh: model.WheelPair, vectors: LinearVectors) -> float:
    """Return how far apart two wheels are drawn: gears touch, a belt needs room."""
    radii = vectors.pose.radii
    first = radii[mesh.first_radius].evaluate(vectors.values)
    second = radii[mesh.second_radius].evaluate(vectors.values)
    if mesh.kind == "belt":
        return 2 * (first + second)
    return abs(first - second) if mesh.same else first + second


# --------------------------------------------------------------------------- what is drawn


def drawn_joint(joint: model.Joint, half: Half) -> Part:
    """Return the drawn part of a joint."""
    match joint:
        case model.Pivot(point):
            return drawn.Pivot(half.point(point), half.vector(_ground(point, half)))
        case model.Slider():
            return _slider(joint, half)
        case model.Slot():
            return _slot(joint, half)
        case model.Contact():
            return _contact(joint, half)
        case model.WheelPair():
            return _wheels(joint, half)
        case model.Rack():
            return _rack(joint, half)
        case model.Screw():
            return _screw(joint, half)
        case model.Rope():
            return _rope(joint, half)
        case _:
            assert_never(joint)


def _ground(point: str, half: Half) -> Plane:
    """Return where the ground of a pivot is: down, where no bar of the described half is."""
    there = replace(half, sense=1)
    bars = [there.at(other).minus(there.at(point)).unit() for other in there.neighbours(point)]
    vectors = [unit for unit in bars if unit is not None]
    if point in half.shared and half.mirror is not None:
        vectors += [unit.reflected(half.mirror.along) for unit in vectors]
    room = {g: min((_angle(g, unit) for unit in vectors), default=math.pi) for g in GROUNDS}
    return max(GROUNDS, key=lambda ground: min(room[ground], APART))


def _slider(slider: model.Slider, half: Half) -> drawn.Slider:
    along = half.unit(half.vectors.pose.guides[slider.point])
    if slider.through is None:
        return drawn.Slider(half.point(slider.point), along, half.line(along, slider.point), "")
    line = half.line(along, slider.point, slider.through)
    return drawn.Slider(half.point(slider.point), along, line, half.point(slider.through))


def _slot(slot: model.Slot, half: Half) -> drawn.Slot:
    """Return a slot as it is drawn, its direction from the tail of its line to the head."""
    along = half.vector(half.vectors.face(_touch("slot", slot.point, half)))
    if along.dot(half.at(slot.head).minus(half.at(slot.tail))) < 0:
        along = along.times(-1)
    return drawn.Slot(
        half.point(slot.point),
        half.link(slot.link),
        half.point(slot.tail),
        half.point(slot.head),
        along,
        half.line(along, slot.point),
        slot.guided and half.link(slot.guided),
    )


def _contact(contact: model.Contact, half: Half) -> drawn.Contact:
    touch = _touch("contact", contact.point, half)
    face = half.line(half.vector(half.vectors.face(touch)), contact.point)
    normal = half.unit(touch.normal)
    return drawn.Contact(half.point(contact.point), half.link(contact.link), normal, face)


def _touch(kind: str, point: str, half: Half) -> PointContact:
    contacts = half.vectors.pose.contacts
    return next(t for t in contacts if (t.kind, t.point) == (kind, point))


def _wheels(mesh: model.WheelPair, half: Half) -> drawn.Gears | drawn.Belt:
    """Return two gears with the point where their circles touch, or a belt with its runs."""
    first, second = half.point(mesh.first), half.point(mesh.second)
    radius, other = half.length(mesh.first_radius), half.length(mesh.second_radius)
    circles = Circle(half.points[first], radius), Circle(half.points[second], other)
    wheels = (
        *(first, mesh.first_link and half.link(mesh.first_link), radius),
        *(second, mesh.second_link and half.link(mesh.second_link), other),
    )
    if mesh.kind == "gear":
        touch = pitch_point(*circles, inner=mesh.same)
        return drawn.Gears(*wheels, mesh.same, touch)
    crossed = not mesh.same
    return drawn.Belt(*wheels, crossed, runs(*circles, crossed=crossed))


def _rack(rack: model.Rack, half: Half) -> drawn.Rack:
    """Return a rack along its guide, with the point where it touches the gear's pitch circle."""
    along = half.guide(rack.point)
    touch = half.at(rack.pivot).plus(half.vector(half.vectors.right(rack)))
    line = half.through(along, (touch, half.at(rack.point)))
    return drawn.Rack(
        half.point(rack.point),
        half.point(rack.pivot),
        half.link(rack.link),
        half.sense * half.length(rack.radius),
        along,
        line,
        touch,
    )


def _screw(screw: model.Screw, half: Half) -> drawn.Screw:
    along, turn = half.guide(screw.point), half.sense * half.length(screw.pitch)
    line = half.line(along, screw.point)
    return drawn.Screw(half.point(screw.point), half.link(screw.link), turn, along, line)


def _rope(rope: model.Rope, half: Half) -> drawn.Rope:
    drums = {k.place: k.reach for k in _sliding_ropes(half) if k.joint == rope.id}
    reaches = [drums.get(i) for i in range(len(rope.route))]
    radii = [None if r is None else half.sense * half.length(r) for r in reaches]
    pulley = PULLEY * half.size
    runs = tuple(rope_runs([half.at(point) for point in rope.route], radii, pulley))
    sizes = tuple(pulley if radius is None else abs(radius) for radius in radii[1:-1])
    return drawn.Rope(tuple(map(half.point, rope.route)), runs, sizes)


def _sliding_ropes(half: Half) -> Iterator[model.RopeFriction]:
    """Yield the friction of ropes around pulleys."""
    joints = half.vectors.pose.mechanism.friction.joints
    yield from (joint for joint in joints if isinstance(joint, model.RopeFriction))


def _angle(one: Plane, other: Plane) -> float:
    """Return the angle between two unit vectors, without its sense."""
    return abs(math.atan2(one.turned().dot(other), one.dot(other)))
