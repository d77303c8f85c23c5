"""What carries each moving point: a link on a pivot, a translating body, a guide, a free body.

Every moving point gets one *carrier* that defines its velocity: the ground (pivots), a
link that turns about a pivot, a guide, a body that floats, or, for a pin that only rods
hold, its projections on two of them. Everything else that holds the point becomes a
relation.
"""

from collections.abc import Mapping, Sequence

from ..algebra.angle import QUARTER, Angle
from ..algebra.product import ONE
from ..algebra.trigonometry import sine
from ..model.mechanism import Link, Mechanism, Pivot, Slider
from ..pose.pose import Pose, Vector
from ..source import Span
from .contacts import relations, spinning
from .draft import Draft
from .forms import projection, subtract, turned
from .graph import Flow, Graph, LinearForm, Rule, SpeedKind, Velocity


def graph_of(pose: Pose) -> Graph:
    """Return the velocity-constraint graph of a pose."""
    draft = Draft(pose)
    pivoted, floating = _by_pivots(pose.mechanism)
    _rest_pivots(draft)
    _turn_about_pivots(draft, pivoted)
    _move_slides(draft)
    _guide_sliders(draft)
    at = _links_at_points(pose.mechanism.links)
    bodies, rods = _bodies_and_rods(floating, draft, at)
    _carry_bodies(draft, bodies, rods)
    _carry_ends(draft, rods, at)
    _carry_loose_pins(draft)
    _relate_ends(draft, rods)
    draft.relations.extend(relations(pose, draft.velocities, draft.spins))
    return draft.graph()


def _by_pivots(mechanism: Mechanism) -> tuple[list[Link], list[Link]]:
    """Return the links that have a pivot, and the others."""
    fixed, links = mechanism.fixed, mechanism.links
    pivoted = [link for link in links if not fixed.isdisjoint(link.points)]
    return pivoted, [link for link in links if fixed.isdisjoint(link.points)]


def _rest_pivots(draft: Draft) -> None:
    for pivot in draft.mechanism.each(Pivot):
        draft.velocities[pivot.point] = ()


def _turn_about_pivots(draft: Draft, links: Sequence[Link]) -> None:
    for link in links:
        pivot = next(p for p in link.points if draft.velocities.get(p) == ())
        spin = draft.spin(link)
        for point in link.points:
            if point != pivot:
                draft.carry(link, point, turned(draft.pose.vector(link.name, pivot, point), spin))


def _move_slides(draft: Draft) -> None:
    """Give all points of a body that only translates one speed."""
    for slide in draft.mechanism.slides:
        along = draft.pose.slides[slide.name]
        velocity = (Flow(ONE, along, draft.unknown(SpeedKind.SLIDE, slide.points[0], along)),)
        for point in slide.points:
            known = draft.velocities.setdefault(point, velocity)
            if known != velocity:
                _relate_translation(draft, slide.name, point, velocity, slide.span)


def _relate_translation(
    draft: Draft, body: str, point: str, velocity: Velocity, span: Span
) -> None:
    """Let a point that something else carries have the velocity of a translating body too."""
    along = draft.pose.slides[body]
    for heading in (along, along + QUARTER):
        known = projection(draft.velocities[point], heading)
        form = subtract(projection(velocity, heading), known)
        draft.relate(Rule.JOINT, body, (point,), heading, form, span)


def _guide_sliders(draft: Draft) -> None:
    """Give each guided point its speed along the guide, or relate the velocity that it has."""
    for point, along in draft.guides.items():
        velocity = draft.velocities.get(point)
        if velocity is None:
            slide = draft.unknown(SpeedKind.SLIDE, point, along)
            draft.velocities[point] = (Flow(ONE, along, slide),)
        else:
            across = along + QUARTER
            form = projection(velocity, across)
            draft.relate(Rule.GUIDE, "", (point,), across, form, _span_of_guide(draft, point))


def _span_of_guide(draft: Draft, point: str) -> Span:
    spans = {s.point: s.span for s in draft.mechanism.each(Slider)}
    mirror = draft.mechanism.mirror
    return spans.get(point, mirror.span if mirror else Span(0, 0))


def _carry_bodies(draft: Draft, bodies: Sequence[Link], rods: Sequence[Link]) -> None:
    """Give bodies that float a spin, and their points velocities.

    A body with points whose velocity is known comes first, so that it can be based on
    one of them.
    """
    waiting = list(bodies)
    while waiting:
        link = max(waiting, key=lambda body: sum(p in draft.velocities for p in body.points))
        waiting.remove(link)
        _float(draft, link, rods)


def _float(draft: Draft, link: Link, rods: Sequence[Link]) -> None:
    """Express a body's points by the velocity of one of them and the body's spin."""
    known = [p for p in link.points if p in draft.velocities]
    base = known[0] if known else _loosen(draft, link, rods)
    draft.name_if_long(base)
    spin = draft.spin(link)
    for point in link.points:
        if point != base:
            arms = draft.pose.vector(link.name, base, point)
            draft.carry(link, point, (*draft.velocities[base], *turned(arms, spin)), base)


def _loosen(draft: Draft, link: Link, rods: Sequence[Link]) -> str:
    """Give one point of a body that nothing known touches two unknown components."""
    for point in link.points:
        for rod in rods:
            if point in rod.points:
                along = _direction(rod, draft.pose)
                draft.free(point, along, along + QUARTER)
                return point
    draft.free(link.points[0], Angle(), QUARTER)
    return link.points[0]


def _carry_loose_pins(draft: Draft) -> None:
    """Let a pin that has left its guide, and that no body has, move in its slot and off it."""
    for contact in draft.pose.contacts:
        if contact.point not in draft.velocities:
            draft.free(contact.point, contact.normal, contact.normal + QUARTER)


# --------------------------------------------------------------------------------------------- rods


LinksAt = Mapping[str, Sequence[Link]]
"""The links that each point belongs to."""


def _links_at_points(links: Sequence[Link]) -> LinksAt:
    """Return the links that each point belongs to."""
    at: dict[str, list[Link]] = {}
    for link in links:
        for point in link.points:
            at.setdefault(point, []).append(link)
    return at


def _bodies_and_rods(
    links: Sequence[Link], draft: Draft, at: LinksAt
) -> tuple[list[Link], list[Link]]:
    """Return the links that need a spin of their own, and the rods among them."""
    spun = spinning(draft.pose)

    def is_held(point: str) -> bool:
        return point in draft.velocities or len(at[point]) > 1

    def is_rod(link: Link) -> bool:
        return len(link.points) == 2 and link.name not in spun and all(map(is_held, link.points))

    return [k for k in links if not is_rod(k)], [k for k in links if is_rod(k)]


def _direction(rod: Link, pose: Pose) -> Angle:
    """Return the direction of a rod, from its first point to the other one."""
    return pose.vector(rod.name, rod.points[0], rod.points[1])[0].angle


def _carry_ends(draft: Draft, rods: Sequence[Link], at: LinksAt) -> None:
    """Carry each end that nothing else carries by its projections on two rods."""
    for rod in rods:
        for point in rod.points:
            if point not in draft.velocities:
                draft.free(point, *_two_directions(at[point], draft.pose))


def _relate_ends(draft: Draft, rods: Sequence[Link]) -> None:
    """Demand of the ends of every rod that they keep their distance."""
    for rod in rods:
        along, velocities = _direction(rod, draft.pose), draft.velocities
        arms = draft.pose.vector(rod.name, *rod.points)
        ends = [velocities[point] for point in rod.points]
        if len(arms) == 1:
            tail, head = (projection(velocity, along) for velocity in ends)
        else:
            tail, head = (_dot(velocity, arms) for velocity in ends)
        form = subtract(tail, head)
        draft.relate(Rule.PROJECTION, rod.name, rod.points, along, form, rod.span)


def _two_directions(links: Sequence[Link], pose: Pose) -> tuple[Angle, Angle]:
    """Return the directions of two rods at a point that are not always parallel."""
    first, *others = (_direction(link, pose) for link in links)
    for other in others:
        if sine(other - first):
            return first, other
    return first, first + QUARTER


def _dot(velocity: Velocity, arms: Vector) -> LinearForm:
    """Return the scalar product of a velocity and a vector."""
    along_each = (
        Flow(flow.size * arm.length, flow.direction - arm.angle, flow.unknown)
        for flow in velocity
        for arm in arms
    )
    return projection(tuple(along_each), Angle())
