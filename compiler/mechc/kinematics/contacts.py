"""What slots, contacts, wheels and screws demand of velocities that others carry."""

from collections.abc import Iterator, Mapping
from typing import assert_never

from ..algebra.angle import Angle
from ..algebra.product import ONE, Product
from ..algebra.sums import add
from ..model.mechanism import Contact, Feed, Pivot, Rope, Slider, Slot, WheelPair
from ..pose.pose import PointContact, Pose
from . import meshes
from .forms import combined, projection, subtract, turned
from .graph import Relation, Rule, Velocity

Velocities = Mapping[str, Velocity]
Spins = Mapping[str, int]


def relations(pose: Pose, velocities: Velocities, spins: Spins) -> Iterator[Relation]:
    """Yield the relation of every joint that holds no pin."""
    for contact in pose.contacts:
        yield _contact(contact, velocities, spins)
    for joint in pose.mechanism.joints:
        match joint:
            case WheelPair():
                yield _mesh(joint, pose, spins)
            case Feed():
                yield _feed(joint, pose, velocities, spins)
            case Rope():
                yield _rope(joint, pose, velocities)
            case Slot(guided=guided) if guided:
                yield _turning_together(joint, spins)
            case Pivot() | Slider() | Slot() | Contact():
                pass  # carriers of points; slots and contacts are relations of their own
            case _:
                assert_never(joint)


def spinning(pose: Pose) -> set[str]:
    """Return the links whose angular velocity such a joint asks for."""
    mechanism = pose.mechanism
    guiding = [slot for slot in mechanism.each(Slot) if slot.guided]
    together = {link for joint in (*mechanism.meshes, *guiding) for link in joint.bodies}
    slides = {slide.name for slide in mechanism.slides}
    return (together - slides) | {t.body for t in pose.contacts}


def _contact(contact: PointContact, velocities: Velocities, spins: Spins) -> Relation:
    """(V_B − V of the body under B) · normal = 0."""
    under = velocities[contact.tail]
    if contact.body in spins:
        under = (*under, *turned(contact.reach, spins[contact.body]))
    own = projection(velocities[contact.point], contact.normal)
    form = subtract(own, projection(under, contact.normal))
    rule = Rule.SLOT if contact.kind == "slot" else Rule.CONTACT
    return Relation(rule, contact.body, (contact.point,), contact.normal, form, contact.span)


def _turning_together(slot: Slot, spins: Spins) -> Relation:
    """ω of the link in the slot − ω of the link that has it = 0."""
    form = {spins[slot.guided]: ONE}
    if slot.link in spins:
        form[spins[slot.link]] = Product(-1)
    return Relation(Rule.TURNING, slot.guided, (slot.point,), Angle(), form, slot.span, slot.id)


def _mesh(mesh: WheelPair, pose: Pose, spins: Spins) -> Relation:
    first, second = meshes.rims(mesh, pose)
    sizes = (mesh.first_link, first), (mesh.second_link, second), (mesh.arm, -add((first, second)))
    form = {spins[link]: size for link, size in sizes if link and size}
    return Relation(Rule(mesh.kind), mesh.bodies[0], mesh.points, Angle(), form, mesh.span, mesh.id)


def _feed(feed: Feed, pose: Pose, velocities: Velocities, spins: Spins) -> Relation:
    """V − ω · lead = 0, V the speed of a point along its guide, seen from a rack's pivot."""
    along = pose.moved_along(feed.point)
    form = meshes.travel(feed, pose, velocities, {spins[feed.link]: ONE})
    points = (feed.base, feed.point) if feed.base else (feed.point,)
    return Relation(Rule(feed.kind), feed.link, points, along, form, feed.span, feed.id)


def _rope(rope: Rope, pose: Pose, velocities: Velocities) -> Relation:
    """Σ (V_head − V_tail) · way = 0."""
    form = combined((ONE, growth) for growth in meshes.growths(rope, pose, velocities))
    return Relation(Rule.ROPE, "", rope.points, Angle(), form, rope.span)
