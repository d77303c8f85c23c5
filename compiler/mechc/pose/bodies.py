"""Bodies at a pose: their frames, directions along bodies, and where pins touch them."""

from collections.abc import Callable, Iterator, Mapping, Sequence

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import Product
from ..diagnostics import Report
from ..diagnostics import pose as messages
from ..model.entries import vector_between
from ..model.mechanism import (
    AlongLine,
    Arrow,
    Contact,
    Direction,
    Geometry,
    Link,
    Mechanism,
    Offset,
    Slide,
    Slot,
    Telescope,
)
from .closure_check import ClosureCondition, across
from .directions import Directions
from .pose import Arm, BodyFrame, PointContact, Vector
from .vector_graph import chained
from .vectors import Missing, Vectors

FindDirection = Callable[[Direction, str, str], Angle]
"""Resolves a direction: its name, and what it is wanted for."""


def aligned(mechanism: Mechanism) -> tuple[Geometry, ...]:
    """Return the geometry with the line of a slot and the vector to its pin in one direction.

    Where only one of ``OC`` and ``OB`` (pin B in the slot OC) has a direction, the other
    has the same: the pin is on the side of O on which C is.
    """
    found = list(mechanism.geometry)
    for slot in mechanism.each(Slot):
        line, pin = (slot.tail, slot.head), (slot.tail, slot.point)
        given, placed = vector_between(line, found), vector_between(pin, found)
        if _directed(placed) and not _directed(given):
            _lay(found, given, line, AlongLine(*pin, 0, slot.span))
        elif _directed(given) and placed is not None and not _directed(placed):
            _lay(found, placed, pin, AlongLine(*line, 0, slot.span))
    return tuple(found)


def _directed(entry: Arrow | Offset | None) -> bool:
    return isinstance(entry, Offset) or (entry is not None and entry.direction is not None)


def _lay(
    geometry: list[Geometry], entry: Arrow | Offset | None, ends: tuple[str, str], along: AlongLine
) -> None:
    """Give a vector a direction, and an entry if it has none yet."""
    length = entry.length if isinstance(entry, Arrow) else None
    arrow = Arrow(*ends, length, along, entry.span if entry else along.span)
    if entry is None:
        geometry.append(arrow)
    else:
        geometry[geometry.index(entry)] = arrow


def contacts(
    mechanism: Mechanism, directions: Directions, vectors: Vectors, find: FindDirection
) -> Iterator[PointContact]:
    """Yield every pin that slides along a body."""
    slides = {s.name for s in mechanism.slides}
    for slot in mechanism.each(Slot):
        line = _slot_direction(slot, slot.link in slides, directions, vectors, find)
        reach = () if slot.link in slides else _reach(slot.tail, slot.point, line, vectors)
        yield PointContact("slot", slot.point, slot.link, slot.tail, reach, across(line), slot.span)
    for contact in mechanism.each(Contact):
        point, tail = contact.point, contact.tail
        normal = find(contact.normal, f"theta_{point}", f"the contact at {point}")
        face = normal - QUARTER
        reach = () if contact.link in slides else _reach(tail, point, face, vectors)
        yield PointContact("contact", point, contact.link, tail, reach, normal, contact.span)


ANY = Angle()
"""The direction of a link that has none: that is reported with the link's frame."""


def _slot_direction(
    slot: Slot, on_slide: bool, directions: Directions, vectors: Vectors, find: FindDirection
) -> Angle:
    """Return the direction of a slot, any where its own link has none."""
    if not on_slide and vectors.path(slot.tail, slot.head) is None:
        return directions.of(slot.tail, slot.head) or ANY
    name = f"{slot.tail}{slot.head}"
    return find(AlongLine(slot.tail, slot.head, 0, slot.span), f"theta_{name}", f"the slot {name}")


def _reach(tail: str, point: str, line: Angle, vectors: Vectors) -> Vector:
    """Return the vector to a pin: given, or along the line, its length noted as left open."""
    given = vectors.reach(tail, point)
    if given:
        return given
    name = f"len_{tail}{point}"
    if name not in vectors.placeholders:
        vectors.placeholders.append(name)
    return (Arm(Product.symbol(name), line),)


def on_the_line(slots: Sequence[PointContact], vectors: Vectors) -> list[ClosureCondition]:
    """Return the condition of every pin in a slot that has a place: it stands on the line."""
    conditions = []
    for slot in slots:
        chain = vectors.chain(slot.tail, slot.point)
        if chain:
            arms = vectors.arms(chain)
            name = chained(chain)
            conditions.append(ClosureCondition(name, arms, (slot.normal,), slot.span))
    return conditions


def frames(
    mechanism: Mechanism, vectors: Vectors, missing: Missing, report: Report
) -> Mapping[str, BodyFrame]:
    """Return the frame of every link, slide and telescope; E301 where a vector is missing."""
    found = {k.name: _of_link(k, mechanism, vectors, missing, report) for k in mechanism.links}
    found |= {slide.name: _of_slide(slide, vectors) for slide in mechanism.slides}
    return found | {t.name: _of_telescope(t, vectors) for t in mechanism.cylinders}


def _of_link(
    link: Link, mechanism: Mechanism, vectors: Vectors, missing: Missing, report: Report
) -> BodyFrame:
    """Return the vectors from a link's first point; a rod of which nothing is given lacks a length.

    With a drive that is enough for a loop to close.
    """
    base = link.points[0]
    frame: dict[str, Vector] = {base: ()}
    for point in link.points[1:]:
        vector = vectors.path(base, point, link.points) or vectors.path(base, point)
        if vector is None and missing.add(base, point):
            what, arm = f"link {link.name}", f"{base}{point}"
            rod = arm if mechanism.drive and len(link.points) == 2 else ""
            report.add(messages.missing_direction(link.span, arm, what, rod=rod))
        elif vector == ():
            report.add(messages.points_coincide(link.span, f"{base}{point}"))
        frame[point] = vector or ()
    return frame


def _of_slide(slide: Slide, vectors: Vectors) -> BodyFrame:
    """Return the frame of a slide, as far as it is given.

    Velocities need none of it; where a vector is missing the guide's couple is open.
    """
    base = slide.points[0]
    paths = {p: vectors.path(base, p) or () for p in slide.points}
    return {p: () if vectors.is_open(path) else path for p, path in paths.items()}


def _of_telescope(telescope: Telescope, vectors: Vectors) -> BodyFrame:
    """Return the vector between the ends of a telescope as one arm along it.

    The pair of forces inside has seen to that, or reported what is missing.
    """
    first, second = telescope.points
    return {first: (), second: vectors.path(first, second) or ()}
