"""Whether it matters for the forces where a link stands, or how far a slider has moved."""

from collections.abc import Iterator

from .mechanism import Link, Mechanism
from .parts.holding import OnLine


def direction_matters(link: Link, mechanism: Mechanism) -> bool:
    """Return whether anything but a couple acts on a link, so that its direction matters."""
    pins = set(link.points) - mechanism.fixed
    return not pins.isdisjoint(_at_work(link, mechanism))


def _at_work(link: Link, mechanism: Mechanism) -> Iterator[str]:
    """Yield the points at which something other than the link is."""
    for body in mechanism.bodies:
        yield from body.points if body is not link else ()
    for joint in mechanism.joints:
        yield from joint.points
        if isinstance(joint, OnLine):
            yield from (joint.tail, joint.head)
    for load in mechanism.loads:
        yield from load.points


def place_matters(point: str, mechanism: Mechanism) -> bool:
    """Return whether a guided point, or the body that slides with it, leads any other body."""
    slides = mechanism.slides_at(point)
    points = {point}.union(*(slide.points for slide in slides))
    others = (body for body in mechanism.bodies if body not in slides)
    return any(not points.isdisjoint(body.points) for body in others)
