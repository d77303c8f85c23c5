"""A mechanism that has no drive and nothing given besides: every link lies as it is drawn."""

from collections.abc import Iterator
from itertools import pairwise

from ...formula.walk import symbols
from ...frozen import replace
from ..entries import directions, joined_to
from ..mechanism import Along, Arrow, Contact, ForcePair, Geometry, Mechanism, Offset, Slider, Slot
from .sketch import Sketch


def as_drawn(mechanism: Mechanism, sketch: Sketch) -> Mechanism:
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
