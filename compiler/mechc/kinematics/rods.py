"""Rods: links held at both ends, whose spin is not needed; their ends have equal projections."""

from collections.abc import Mapping, Sequence

from ..algebra.angle import Angle
from ..algebra.trigonometry import sine
from ..model.mechanism import Link
from ..pose.pose import Pose, Vector
from .contacts import spinning
from .draft import Draft
from .forms import QUARTER, projection, subtract
from .graph import Flow, Form, Rule, Velocity

LinksAt = Mapping[str, Sequence[Link]]
"""The links that each point belongs to."""


def links_at_points(links: Sequence[Link]) -> LinksAt:
    """Return the links that each point belongs to."""
    at: dict[str, list[Link]] = {}
    for link in links:
        for point in link.points:
            at.setdefault(point, []).append(link)
    return at


def bodies_and_rods(
    links: Sequence[Link], draft: Draft, at: LinksAt
) -> tuple[list[Link], list[Link]]:
    """Return the links that need a spin of their own, and the rods among them."""
    spun = spinning(draft.pose)

    def is_held(point: str) -> bool:
        return point in draft.velocities or len(at[point]) > 1

    def is_rod(link: Link) -> bool:
        return len(link.points) == 2 and link.name not in spun and all(map(is_held, link.points))

    return [k for k in links if not is_rod(k)], [k for k in links if is_rod(k)]


def direction(rod: Link, pose: Pose) -> Angle:
    """Return the direction of a rod, from its first point to the other one."""
    return pose.vector(rod.name, rod.points[0], rod.points[1])[0].angle


def carry_ends(draft: Draft, rods: Sequence[Link], at: LinksAt) -> None:
    """Carry each end that nothing else carries by its projections on two rods."""
    for rod in rods:
        for point in rod.points:
            if point not in draft.velocities:
                draft.free(point, *_two_directions(at[point], draft.pose))


def relate_ends(draft: Draft, rods: Sequence[Link]) -> None:
    """Demand of the ends of every rod that they keep their distance."""
    for rod in rods:
        along, velocities = direction(rod, draft.pose), draft.velocities
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
    first, *others = (direction(link, pose) for link in links)
    for other in others:
        if sine(other - first):
            return first, other
    return first, first + QUARTER


def _dot(velocity: Velocity, arms: Vector) -> Form:
    """Return the scalar product of a velocity and a vector."""
    along_each = (
        Flow(flow.size * arm.length, flow.direction - arm.angle, flow.unknown)
        for flow in velocity
        for arm in arms
    )
    return projection(tuple(along_each), Angle())
