"""What slots, contacts, wheels and screws demand of velocities that others carry.

What meshes: the rims of wheels, a rack and its wheel, a thread, a rope; and how fast they slip.
"""

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from typing import assert_never

from ..algebra.angle import Angle
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..algebra.sums import add
from ..formula.tree import PI
from ..model.mechanism import (
    Contact,
    Feed,
    Joint,
    Mesh,
    Meshing,
    Pivot,
    Rope,
    Slider,
    Slot,
    WheelPair,
)
from ..pose.pose import PointContact, Pose
from .forms import combined, projection, scaled, spin, subtract, turned
from .graph import Graph, LinearForm, Relation, Rule, Velocity

VelocityForms = Mapping[str, Velocity]
Spins = Mapping[str, int]


def relations(pose: Pose, velocities: VelocityForms, spins: Spins) -> Iterator[Relation]:
    """Yield the relation of every joint that holds no pin."""

    def turn(link: str) -> LinearForm:
        return {spins[link]: ONE} if link in spins else {}

    for contact in pose.contacts:
        yield _contact(contact, velocities, spins)
    for joint in pose.mechanism.joints:
        relation = _relation(joint, pose, velocities, turn)
        if relation is not None:
            yield relation


def slipping(graph: Graph, pose: Pose, joint: Joint) -> LinearForm:
    """Return the speed at which rims, a rack and its wheel, or nut and thread, part.

    A rope parts as all of its falls grow. It is what their relation demands to be zero.
    """
    relation = _relation(joint, pose, graph.velocities, lambda link: spin(graph, link))
    assert relation is not None, "no other joint meshes"
    return relation.form


def _relation(
    joint: Joint, pose: Pose, velocities: VelocityForms, turn: Callable[[str], LinearForm]
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


def _contact(contact: PointContact, velocities: VelocityForms, spins: Spins) -> Relation:
    """(V_B − V of the body under B) · normal = 0."""
    under = velocities[contact.tail]
    if contact.body in spins:
        under = (*under, *turned(contact.reach, spins[contact.body]))
    own = projection(velocities[contact.point], contact.normal)
    form = subtract(own, projection(under, contact.normal))
    rule = Rule.SLOT if contact.kind == "slot" else Rule.CONTACT
    return Relation(rule, contact.body, (contact.point,), contact.normal, form, contact.span)


def _turning_together(slot: Slot, turn: Callable[[str], LinearForm]) -> Relation:
    """ω of the link in the slot − ω of the link that has it = 0."""
    form = subtract(turn(slot.guided), turn(slot.link))
    return Relation(Rule.TURNING, slot.guided, (slot.point,), Angle(), form, slot.span, slot.id)


def _mesh(mesh: WheelPair, pose: Pose, turn: Callable[[str], LinearForm]) -> Relation:
    first, second = rims(mesh, pose)
    sizes = (mesh.first_link, first), (mesh.second_link, second), (mesh.arm, -add((first, second)))
    form = combined((size, turn(link)) for link, size in sizes if link)
    return Relation(Rule.MESH, mesh.bodies[0], mesh.points, Angle(), form, mesh.span, mesh.id)


def _feed(
    feed: Feed, pose: Pose, velocities: VelocityForms, turn: Callable[[str], LinearForm]
) -> Relation:
    """V − ω · lead = 0, V the speed of a point along its guide, seen from a rack's pivot."""
    along = pose.moved_along(feed.point)
    form = travel(feed, pose, velocities, turn(feed.link))
    points = (feed.base, feed.point) if feed.base else (feed.point,)
    return Relation(Rule.MESH, feed.link, points, along, form, feed.span, feed.id)


def _rope(rope: Rope, pose: Pose, velocities: VelocityForms) -> Relation:
    """Σ (V_head − V_tail) · way = 0."""
    form = combined((ONE, growth) for growth in growths(rope, pose, velocities))
    return Relation(Rule.ROPE, "", rope.points, Angle(), form, rope.span)


# --------------------------------------------------------------------------- what meshes


def mesh_of(pose: Pose, id: str) -> Mesh | Rope:
    """Return the wheels, the rack, the screw or the rope of an id."""
    mesh = pose.mechanism.joint(id)
    assert isinstance(mesh, Meshing | Rope), "no other joint meshes"
    return mesh


def rims(mesh: WheelPair, pose: Pose) -> tuple[Product, Product]:
    """Return the radii of two wheels, the second one negative where both turn alike."""
    first, second = pose.radii[mesh.first_radius], pose.radii[mesh.second_radius]
    return first, -second if mesh.same else second


def lead(feed: Feed, pose: Pose) -> Product:
    """Return how far a link moves a point while it turns by a radian, as the guide points."""
    way = pose.radii[feed.way]
    return way / to_product(PI).scaled(2) if feed.is_per_turn else way


def travel(
    feed: Feed, pose: Pose, velocities: Mapping[str, Velocity], turn: LinearForm
) -> LinearForm:
    """Return V of the point along its guide, less ω · lead, less that of what it is seen from."""
    along = pose.moved_along(feed.point)
    ahead = subtract(projection(velocities[feed.point], along), scaled(turn, lead(feed, pose)))
    base = velocities[feed.base] if feed.base else ()
    return subtract(ahead, projection(base, along))


def turning(graph: Graph, link: str, carrier: str) -> LinearForm:
    """Return the rotation of a link relative to what carries it; '' is the ground."""
    own, under = (spin(graph, name) if name else {} for name in (link, carrier))
    return subtract(own, under)


def growths(rope: Rope, pose: Pose, velocities: Mapping[str, Velocity]) -> list[LinearForm]:
    """Return the speed at which each fall of a rope grows."""
    ends = zip(pairwise(rope.route), pose.falls[rope.id], strict=True)
    return [
        subtract(projection(velocities[head], way), projection(velocities[tail], way))
        for (tail, head), way in ends
    ]
