"""A joint released: the mechanism with one freedom more, along which a reaction does work.

By release of constraints the force at a joint becomes a load once the joint is taken away.
With the driving loads held still, what is left has one freedom, and the balance of power in
it gives that force alone, as short as k itself.

A joint is a *pin* of a link on what it meets there, a point on the *ground* (a pivot, a
guide), the guide of a *slide*, a *contact* (slot, contact), or a *mesh* (wheels, rack, screw).
Released along a direction, it keeps everything else: a pin does not part across it, a pivot
moves along it only.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import assert_never

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import Product
from ..base.frozen import frozen, replace
from ..diagnostics import MechcError, Report
from ..model.mechanism import (
    Force,
    ForcePair,
    Joint,
    Link,
    Load,
    Mechanism,
    Pivot,
    Rack,
    Slider,
)
from ..pose.pose import Pose
from ..source import Source, Span
from .carriers import graph_of
from .contacts import slipping
from .forms import combined, projection, relative_speed, speed_of_load, spin, subtract
from .graph import Graph, LinearForm, Relation, Rule
from .joint_refs import JointRef, contact_at
from .plan import Plan, SpeedFactors
from .planning import plan_of

SpeedReading = Callable[[Graph], LinearForm]
"""A speed that is read off a graph, as a linear form in its unknowns."""


@frozen
class Released:
    """A pose with a joint released, the speed at which it parts, and what still holds there."""

    pose: Pose
    parting: SpeedReading
    holding: tuple[SpeedReading, ...] = ()


@frozen
class ReleasedLinkage:
    """The plan of a mechanism with a joint released, and the speed at which the joint parts."""

    plan: Plan
    parting: SpeedFactors


LoadShare = tuple[Product, Load]
"""A load by how much of it there is for a unit of the free load that it is tied to."""


def released_linkage(
    pose: Pose,
    joint: JointRef,
    along: Angle,
    held: Iterable[Sequence[LoadShare]],
    taken: frozenset[str],
) -> ReleasedLinkage | None:
    """Return the motions that are left with a joint released along a direction.

    Each free load in ``held`` does no work in them, with all that are tied to it. None where
    nothing moves: then other joints do the same as this one. Long sums get names that are not
    ``taken``.
    """
    released = _released(pose, joint, along)
    moved = {load.name: load for load in released.pose.mechanism.loads}
    shares = [[(part, moved[load.name]) for part, load in free] for free in held]
    measures = [*released.holding, *map(work_of, shares)]
    graph = _held_still(graph_of(released.pose), measures, pose.mechanism.span)
    try:
        plan = plan_of(graph, Report(Source("", "")), taken)
    except MechcError:
        return None
    return ReleasedLinkage(plan, plan.value(released.parting(graph)))


def work_of(shares: Sequence[LoadShare]) -> SpeedReading:
    """Return the speed with which a free load does its work, with all that are tied to it."""
    if len(shares) == 1:
        ((_, load),) = shares
        return lambda graph: speed_of_load(graph, load)
    return lambda graph: combined((part, speed_of_load(graph, load)) for part, load in shares)


def _held_still(graph: Graph, measures: Iterable[SpeedReading], span: Span) -> Graph:
    forms = (measure(graph) for measure in measures)
    more = (Relation(Rule.HELD, "", (), Angle(), form, span) for form in forms if form)
    return replace(graph, relations=(*graph.relations, *more))


def _released(pose: Pose, joint: JointRef, along: Angle) -> Released:
    """Return the linkage without one component of what a joint transmits."""
    match joint.kind:
        case "pin":
            return _without_pin(pose, joint, along)
        case "ground":
            return _without_ground(pose, joint.point, along)
        case "slide":
            return _without_slide(pose, joint, along)
        case "mesh":
            return _without_mesh(pose, joint)
        case "contact":
            return _without_contact(pose, joint.point)
        case "thrust":
            raise AssertionError("a thrust is given")
        case _:
            assert_never(joint.kind)


def _without_pin(pose: Pose, joint: JointRef, along: Angle) -> Released:
    """Return the linkage in which the link has a point of its own that leaves the pin one way.

    What acts on the link there goes with it. A telescope holds its ends at no distance, so
    that its own point moves like a body.
    """
    own, point = joint.loose, joint.point
    apart = _with_pin(_with_pin(_with_own_point(pose, joint), point), own)

    def gap(graph: Graph, direction: Angle = along) -> LinearForm:
        ahead, behind = (projection(graph.velocities[p], direction) for p in (own, point))
        return subtract(ahead, behind)

    return Released(apart, gap, (lambda graph: gap(graph, along + QUARTER),))


def _with_own_point(pose: Pose, joint: JointRef) -> Pose:
    """Return a pose whose link has a point of its own at the pin, with all that acts there."""
    link, point, own, mechanism = joint.of, joint.point, joint.loose, pose.mechanism

    def on_own_point(part: Joint) -> Joint:
        is_there = isinstance(part, Rack) and (part.link, part.pivot) == (link, point)
        return replace(part, pivot=own) if is_there else part

    frame = {own if p == point else p: vector for p, vector in pose.frames[link].items()}
    return replace(
        pose,
        mechanism=replace(
            _sharing(mechanism, joint),
            links=tuple(_renamed(k, point, own) if k.name == link else k for k in mechanism.links),
            joints=tuple(map(on_own_point, mechanism.joints)),
            loads=_carried(mechanism, joint),
        ),
        frames={**pose.frames, link: frame},
        contacts=tuple(
            t._replace(tail=own) if (t.body, t.tail) == (link, point) else t for t in pose.contacts
        ),
    )


def _carried(mechanism: Mechanism, joint: JointRef) -> tuple[Load, ...]:
    """Return the loads, those on a link itself at the point that it has for itself now."""

    def moved(load: Load) -> Load:
        there = (joint.of, joint.point)
        match load:
            case Force() if (load.link, load.point) == there:
                return replace(load, point=joint.loose)
            case ForcePair() if (load.first_link, load.first) == there:
                return replace(load, first=joint.loose)
            case ForcePair() if (load.second_link, load.second) == there:
                return replace(load, second=joint.loose)
            case _:
                return load

    return tuple(map(moved, mechanism.loads))


def _with_pin(pose: Pose, point: str) -> Pose:
    """Return a pose in which a pin is a body of its own where nothing is left that holds it."""
    if any(point in held for held in _holding(pose)):
        return pose
    mechanism = pose.mechanism
    pin = Link(f"pin {point}", (point,), mechanism.span)
    with_pin = replace(mechanism, links=(*mechanism.links, pin))
    return replace(pose, mechanism=with_pin, frames={**pose.frames, pin.name: {point: ()}})


def _holding(pose: Pose) -> Iterator[Collection[str]]:
    """Yield the points of whatever gives a point its velocity."""
    mechanism = pose.mechanism
    yield mechanism.fixed
    yield pose.guides.keys()
    yield from (link.points for link in mechanism.links)
    yield from (slide.points for slide in mechanism.slides)


def _renamed(link: Link, point: str, own: str) -> Link:
    return replace(link, points=tuple(own if p == point else p for p in link.points))


def _sharing(mechanism: Mechanism, joint: JointRef) -> Mechanism:
    """Return the mechanism with the link's own point shared by both halves if the link is."""
    mirror = mechanism.mirror
    points = next(b.points for b in mechanism.bodies if b.name == joint.of)
    if mirror is None or not mirror.shares(points):
        return mechanism
    return replace(mechanism, mirror=replace(mirror, sharing=(*mirror.sharing, joint.loose)))


def _without_ground(pose: Pose, point: str, along: Angle) -> Released:
    """Return the linkage in which a pivot moves one way, or a slider leaves its guide."""
    mechanism = pose.mechanism
    joints = tuple(
        j for j in mechanism.joints if not (isinstance(j, Pivot | Slider) and j.point == point)
    )
    guides = {p: direction for p, direction in pose.guides.items() if p != point}
    left = {p: direction for p, direction in pose.guides.items() if p not in guides}
    if point in mechanism.fixed:
        guides[point] = along
    free = replace(mechanism, joints=joints)
    return Released(
        _with_pin(replace(pose, mechanism=free, guides=guides, left=left), point),
        lambda graph: projection(graph.velocities[point], along),
    )


def _without_slide(pose: Pose, joint: JointRef, along: Angle) -> Released:
    """Return the linkage in which a body leaves its guide; it still does not turn."""
    mechanism = pose.mechanism
    slide = next(s for s in mechanism.slides if s.name == joint.of)
    slides = tuple(s for s in mechanism.slides if s is not slide)
    link = Link(slide.name, slide.points, slide.span)
    free = replace(mechanism, slides=slides, links=(*mechanism.links, link))
    left = dict.fromkeys(slide.points, pose.slides[slide.name])
    return Released(
        replace(pose, mechanism=free, left=left),
        lambda graph: projection(graph.velocities[joint.point], along),
        (lambda graph: spin(graph, slide.name),),
    )


def _without_mesh(pose: Pose, joint: JointRef) -> Released:
    """Return the linkage in which rims, a rack or a thread slip, or a rope stretches."""
    joints = tuple(j for j in pose.mechanism.joints if j.id != joint.of)
    free = replace(pose, mechanism=replace(pose.mechanism, joints=joints))
    mesh = pose.mechanism.joint(joint.of)
    return Released(free, lambda graph: slipping(graph, pose, mesh))


def _without_contact(pose: Pose, point: str) -> Released:
    contact = contact_at(pose, point)
    left = tuple(t for t in pose.contacts if t is not contact)
    return Released(
        replace(pose, contacts=left),
        lambda graph: relative_speed(graph, contact, contact.normal),
    )
