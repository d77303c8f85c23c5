"""What slots, contacts, wheels and screws demand of velocities that others carry."""

from collections.abc import Callable, Iterator, Mapping
from typing import assert_never

from ..algebra.angle import Angle
from ..algebra.product import ONE
from ..algebra.sums import add
from ..model.mechanism import Contact, Feed, Joint, Pivot, Rope, Slider, Slot, WheelPair
from ..pose.pose import PointContact, Pose
from . import meshes
from .forms import combined, projection, spin, subtract, turned
from .graph import Form, Graph, Relation, Rule, Velocity

Velocities = Mapping[str, Velocity]
Spins = Mapping[str, int]


def relations(pose: Pose, velocities: Velocities, spins: Spins) -> Iterator[Relation]:
    """Yield the relation of every joint that holds no pin."""

    def turn(link: str) -> Form:
        return {spins[link]: ONE} if link in spins else {}

    for contact in pose.contacts:
        yield _contact(contact, velocities, spins)
    for joint in pose.mechanism.joints:
        relation = _relation(joint, pose, velocities, turn)
        if relation is not None:
            yield relation


def slipping(graph: Graph, pose: Pose, joint: Joint) -> Form:
    """Return the speed at which rims, a rack and its wheel, or nut and thread, part.

    A rope parts as all of its falls grow. It is what their relation demands to be nil.
    """
    relation = _relation(joint, pose, graph.velocities, lambda link: spin(graph, link))
    assert relation is not None, "no other joint meshes"
    return relation.form


def _relation(
    joint: Joint, pose: Pose, velocities: Velocities, turn: Callable[[str], Form]
) -> Relation | None:
    """Return the relation of a joint between velocities that others carry; None without any.

    ``turn`` gives the angular velocity of a link. Slots and contacts have theirs in the pose.
    """
    match joint:
        case WheelPair():
            return _mesh(joint, pose, turn)
        case Feed():
            return _feed(joint, pose, velocities, turn)
        case Rope():
            return _rope(joint, pose, velocities)
        case Slot(guided=guided) if guided:
            return _turning_together(joint, turn)
        case Pivot() | Slider() | Slot() | Contact():
            return None  # carriers of points, and contacts: see :func:`relations`
        case _:
            assert_never(joint)


def spinning(pose: Pose) -> set[str]:
    """Return the links whose angular velocity such a joint asks for."""
    named = {body for joint in pose.mechanism.joints for body in joint.bodies}
    slides = {slide.name for slide in pose.mechanism.slides}
    return (named - slides) | {t.body for t in pose.contacts}


def _contact(contact: PointContact, velocities: Velocities, spins: Spins) -> Relation:
    """(V_B − V of the body under B) · normal = 0."""
    under = velocities[contact.tail]
    if contact.body in spins:
        under = (*under, *turned(contact.reach, spins[contact.body]))
    own = projection(velocities[contact.point], contact.normal)
    form = subtract(own, projection(under, contact.normal))
    rule = Rule.SLOT if contact.kind == "slot" else Rule.CONTACT
    return Relation(rule, contact.body, (contact.point,), contact.normal, form, contact.span)


def _turning_together(slot: Slot, turn: Callable[[str], Form]) -> Relation:
    """ω of the link in the slot − ω of the link that has it = 0."""
    form = subtract(turn(slot.guided), turn(slot.link))
    return Relation(Rule.TURNING, slot.guided, (slot.point,), Angle(), form, slot.span, slot.id)


def _mesh(mesh: WheelPair, pose: Pose, turn: Callable[[str], Form]) -> Relation:
    first, second = meshes.rims(mesh, pose)
    sizes = (mesh.first_link, first), (mesh.second_link, second), (mesh.arm, -add((first, second)))
    form = combined((size, turn(link)) for link, size in sizes if link)
    return Relation(Rule.MESH, mesh.bodies[0], mesh.points, Angle(), form, mesh.span, mesh.id)


def _feed(feed: Feed, pose: Pose, velocities: Velocities, turn: Callable[[str], Form]) -> Relation:
    """V − ω · lead = 0, V the speed of a point along its guide, seen from a rack's pivot."""
    along = pose.moved_along(feed.point)
    form = meshes.travel(feed, pose, velocities, turn(feed.link))
    points = (feed.base, feed.point) if feed.base else (feed.point,)
    return Relation(Rule.MESH, feed.link, points, along, form, feed.span, feed.id)


def _rope(rope: Rope, pose: Pose, velocities: Velocities) -> Relation:
    """Σ (V_head − V_tail) · way = 0."""
    form = combined((ONE, growth) for growth in meshes.growths(rope, pose, velocities))
    return Relation(Rule.ROPE, "", rope.points, Angle(), form, rope.span)
