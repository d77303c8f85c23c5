"""Bodies on paper: bars with rigid corners, plates, telescopes, what is closed behind its faces."""

from collections.abc import Iterator, Sequence
from itertools import combinations

from ..figure.figure import Contact, Figure, Link, Slide, Telescope
from ..figure.outline import outline
from ..pose.places import Plane
from .drawing import Polyline, Shape
from .paper import Paper
from .pens import BODY
from .symbols import corner, cylinder, line
from .tolerances import ON_EDGE

ROLLER = 1.9
"""The radius of the roller or nose by which a point touches a face."""

THICK = 2.4
"""Half the thickness of a body behind the face that it pushes with."""

BodyOutline = tuple[Plane, ...]


def link(paper: Paper, body: Link) -> Iterator[Shape]:
    """Yield a link: a plate where bars enclose it, otherwise bars, rigid at their corners."""
    faces = faces_of(paper.figure, body.name)
    if faces:
        yield closed(paper, body.points, faces)
    if is_plate(body):
        yield Polyline(tuple(map(paper.at, body.outline)), BODY, closed=True, fill="light")
    for tail, head in body.rods:
        yield line(paper.at(tail), paper.at(head), BODY)
    if not is_plate(body):
        yield from _corners(paper, body)


def slide(paper: Paper, body: Slide) -> Iterator[Shape]:
    """Yield a body that only translates, closed behind its faces: wedge, cam, rack, plunger."""
    faces = faces_of(paper.figure, body.name)
    if faces:
        yield wedge(paper, body, faces)
    elif len(body.outline) > 2:
        yield Polyline(tuple(map(paper.at, body.outline)), BODY, closed=True, fill="light")
    for start, end in zip(body.points, body.points[1:], strict=False):
        yield line(paper.at(start), paper.at(end), BODY)


def telescope(paper: Paper, body: Telescope) -> Iterator[Shape]:
    """Yield a telescope: a cylinder with its rod."""
    return cylinder(*map(paper.at, body.points))


def is_plate(body: Link) -> bool:
    """Return whether a link is drawn as a plate: there are as many bars as corners, or more."""
    return len(body.outline) > 2 and len(body.rods) >= len(body.outline)


def faces_of(figure: Figure, body: str) -> list[Contact]:
    """Return the contacts in which a body pushes with a face."""
    return [part for part in figure.parts if isinstance(part, Contact) and part.body == body]


def closed(paper: Paper, points: Sequence[str], faces: Sequence[Contact]) -> Polyline:
    """Return a link's body behind its faces; it holds its own points."""
    places = [paper.at(point) for point in points]
    for face in faces:
        for end in _edge(paper, face):
            places += [end, end.minus(face.normal.times(2 * THICK))]
    return _cut(_hull(places), paper, faces)


def wedge(paper: Paper, body: Slide, faces: Sequence[Contact]) -> Polyline:
    """Return a slide's body: square to its path where it has no face."""
    places = [paper.at(point) for point in body.points]
    places += [end for face in faces for end in _edge(paper, face)]
    along, across = body.along, body.along.turned()
    low, high = min(map(along.dot, places)), max(map(along.dot, places))
    sides = [(min(map(across.dot, places)), -1), (max(map(across.dot, places)), 1)]
    right, left = (
        height if any(side * across.dot(f.normal) > 0 for f in faces) else height + side * THICK
        for height, side in sides
    )
    corners = ((low, right), (high, right), (high, left), (low, left))
    return _cut(tuple(along.times(x).plus(across.times(y)) for x, y in corners), paper, faces)


def _edge(paper: Paper, face: Contact) -> tuple[Plane, Plane]:
    """Return the ends of a face, which is touched by the outside of a roller."""
    start, end = (p.minus(face.normal.times(ROLLER)) for p in paper.ends(face.face))
    return start, end


def _cut(shape: BodyOutline, paper: Paper, faces: Sequence[Contact]) -> Polyline:
    """Return a body of which no part is before one of its faces."""
    for face in faces:
        shape = _behind(shape, _edge(paper, face)[0], face.normal)
    return Polyline(shape, BODY, closed=True, fill="light")


def _hull(places: Sequence[Plane]) -> BodyOutline:
    named = {str(i): at for i, at in enumerate(places)}
    return tuple(named[name] for name in outline(named, named))


def _behind(shape: BodyOutline, edge: Plane, normal: Plane) -> BodyOutline:
    """Return the part of a polygon that is not before an edge."""
    found: list[Plane] = []
    for here, there in zip(shape, (*shape[1:], shape[0]), strict=True):
        ahead, next_ahead = (normal.dot(p.minus(edge)) for p in (here, there))
        if ahead <= ON_EDGE:
            found.append(here)
        if (ahead > ON_EDGE) != (next_ahead > ON_EDGE):
            found.append(here.plus(there.minus(here).times(ahead / (ahead - next_ahead))))
    return tuple(found)


def _corners(paper: Paper, body: Link) -> Iterator[Shape]:
    """Yield the signs that neighbouring bars of a link are rigid with one another."""
    for point in body.points:
        ways = sorted(bars_at(paper, body, point), key=lambda unit: unit.angle)
        for first, second in combinations(ways, 2):
            if first.dot(second) < 0.999:
                yield corner(paper.at(point), first, second)


def bars_at(paper: Paper, body: Link, point: str) -> Iterator[Plane]:
    """Yield the unit directions in which the bars of a link leave a point."""
    for tail, head in body.rods:
        if point in (tail, head):
            other = head if point == tail else tail
            unit = paper.at(other).minus(paper.at(point)).unit()
            if unit is not None:
                yield unit
