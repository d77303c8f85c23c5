"""What a mechanism says of its geometry and its bodies: points, parameters, directions."""

from collections.abc import Collection, Iterable, Iterator
from typing import assert_never

from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..formula.walk import symbols
from .mechanism import (
    Absolute,
    Arrow,
    Contact,
    Direction,
    Force,
    Geometry,
    Link,
    Mechanism,
    Offset,
    Slider,
    Turn,
)
from .parts.holding import OnLine


def unit_of_drawing(mechanism: Mechanism) -> str:
    """Return the unit in which the first drawn point with one has its place, '' without any."""
    return next((drawn.unit for drawn in mechanism.drawn if drawn.unit), "")


def drawn_places(mechanism: Mechanism) -> dict[str, tuple[Formula, Formula]]:
    """Return the coordinates of the points that are drawn, pivots with a place among them."""
    places = {
        g.head: (g.x, g.y) for g in mechanism.geometry if isinstance(g, Offset) and not g.tail
    }
    return places | {drawn.point: (drawn.x, drawn.y) for drawn in mechanism.drawn}


def points_of(entry: Geometry) -> tuple[str, ...]:
    """Return the points of a vector or an angle."""
    match entry:
        case Arrow(tail, head) | Offset(tail, head):
            return tail, head
        case Turn(first, vertex, second):
            return first, vertex, second
        case _:
            assert_never(entry)


def vector_between(ends: Collection[str], geometry: Iterable[Geometry]) -> Arrow | Offset | None:
    """Return the vector that is given between two points, in whichever sense."""
    vectors = (g for g in geometry if isinstance(g, Arrow | Offset))
    return next((g for g in vectors if {g.tail, g.head} == set(ends)), None)


class Ray(NamedTuple):
    """Two points at two distances from a third one, in one direction."""

    start: str
    along: Absolute
    near: Formula
    far: Formula


def ray_through(ends: tuple[str, str], geometry: Iterable[Geometry]) -> Ray | None:
    """Return the ray that two points are on, as vectors of one written direction give it."""
    arms: dict[tuple[str, Formula], dict[str, Formula]] = {}
    for entry in geometry:
        match entry:
            case Arrow(start, head, length, Absolute(angle) as along) if length and head in ends:
                arm = arms.setdefault((start, angle), {})
                arm[head] = length
                if len(arm) > 1:
                    return Ray(start, along, arm[ends[0]], arm[ends[1]])
            case _:
                pass
    return None


def mentioned(entry: Geometry) -> frozenset[str]:
    """Return the parameters in what is given of a vector or an angle."""
    match entry:
        case Arrow(_, _, length, towards):
            given = [length] if length else []
            given += [towards.angle] if isinstance(towards, Absolute) else []
        case Offset(_, _, x, y):
            given = [x, y]
        case Turn(angle=angle):
            given = [angle]
        case _:
            assert_never(entry)
    return frozenset().union(*map(symbols, given))


def joined_to(start: str, geometry: Iterable[Geometry]) -> set[str]:
    """Return the points to which vectors lead from one, that one among them."""
    pairs = [{entry.tail, entry.head} for entry in geometry if not isinstance(entry, Turn)]
    found = {start}
    while more := set[str]().union(*(pair for pair in pairs if pair & found)) - found:
        found |= more
    return found


def directions(mechanism: Mechanism) -> Iterator[Direction]:
    """Yield every direction that is written down, of vectors, guides, faces, ropes and forces."""
    yield from (g.direction for g in mechanism.geometry if isinstance(g, Arrow) and g.direction)
    yield from (s.along for s in mechanism.each(Slider))
    yield from (s.along for s in mechanism.slides)
    yield from (c.normal for c in mechanism.each(Contact))
    yield from (way for rope in mechanism.ropes for way in rope.ways)
    yield from (k.along for k in mechanism.loads if isinstance(k, Force) and not k.weight)


def body_through(points: Iterable[str], mechanism: Mechanism) -> str:
    """Return the rigid body that two points are fast in: a link, a slide, the ground, or ''."""
    pair = set(points)
    if pair <= {"", *mechanism.fixed}:
        return "the ground"
    found = next((body for body in mechanism.rigid_bodies if pair <= set(body.points)), None)
    return f"{'link' if isinstance(found, Link) else 'slide'} {found.name}" if found else ""


# ------------------------------------------------------------- whether it matters where they are


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
