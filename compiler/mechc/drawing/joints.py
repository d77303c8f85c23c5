"""Joints on paper: sliders, slots, wheels, racks and screws, pins, and the guides of slides."""

import itertools
import math
from collections import Counter
from collections.abc import Iterator

from ..figure.figure import (
    ArcSlot,
    Belt,
    Contact,
    Force,
    Gears,
    Link,
    Part,
    Pivot,
    Rack,
    Rope,
    Screw,
    Slide,
    Slider,
    Slot,
    Telescope,
)
from ..pose.places import Plane
from . import symbols
from .bodies import ROLLER, faces_of, wedge
from .drawing import Arc, Polyline, Shape
from .paper import Paper
from .pens import AXIS, BODY, SYMBOL
from .sheet import Layer, Sheet
from .symbols import BLOCK, PIN, line, off
from .tolerances import ON_AXIS

STUB = 14.0
"""How far the rod of a slide reaches beyond it, through its guide."""

GUIDE_ROOM = 16.0
"""How far apart points of a slide are at least between which its guide has room."""

LENGTHWISE = 0.5
"""The cosine between a direction and a guide above which it is along the guide."""

Layered = Iterator[tuple[Layer, Shape]]


def joint(paper: Paper, part: Part) -> Layered:
    """Yield the shapes of a joint; none of another part."""
    match part:
        case Pivot():
            yield from _in(Layer.JOINTS, symbols.pivot(paper.at(part.point), part.ground))
        case Slider():
            yield Layer.AXES, line(*paper.ends(part.guide), AXIS)
            if not _on_slide(paper, part.point):
                yield from _in(Layer.GROUND, symbols.guide(paper.at(part.point), part.along))
                yield Layer.JOINTS, symbols.block(paper.at(part.point), part.along)
        case Slot():
            ends = paper.ends(part.groove)
            yield Layer.JOINTS, symbols.groove_floor(*ends)
            yield from _in(Layer.JOINTS, symbols.groove(*ends))
            if part.guided:
                yield Layer.JOINTS, symbols.block(paper.at(part.point), part.along)
        case ArcSlot():
            yield from _arc_slot(paper, part)
        case Gears():
            yield from _in(Layer.WHEELS, _gears(paper, part))
        case Belt():
            yield from _in(Layer.WHEELS, _belt(paper, part))
        case Rack():
            yield from _in(Layer.WHEELS, _rack(paper, part))
        case Screw():
            yield from _screw(paper, part)
        case Rope():
            yield from _in(Layer.WHEELS, (line(*paper.ends(run), SYMBOL) for run in part.runs))
            yield from _in(Layer.PINS, _pulleys(paper, part))
        case _:
            pass


def reach(paper: Paper, point: str, direction: Plane) -> float:
    """Return how far, in mm, what is drawn of the joints at a point reaches in a direction."""
    return max((_reach(paper, p, point, direction) for p in paper.figure.parts), default=0.0)


def _reach(paper: Paper, part: Part, point: str, direction: Plane) -> float:
    match part:
        case Slider() if part.point == point:
            return BLOCK if _is_along(part.along, direction) else PIN + 1.0
        case Rack(line=shown) | Screw(axis=shown) if part.point == point:
            is_along = _is_along(part.along, direction)
            return math.dist(*paper.ends(shown)) / 2 if is_along else 0.0
        case _:
            return 0.0


def _is_along(line: Plane, direction: Plane) -> bool:
    return abs(line.dot(direction)) > LENGTHWISE


def _in(layer: Layer, shapes: Iterator[Shape]) -> Layered:
    return ((layer, shape) for shape in shapes)


def _arc_slot(paper: Paper, part: ArcSlot) -> Layered:
    """Yield a groove along its circle, the arm by which the body carries it, and the radius."""
    centre, pin = paper.at(part.centre), paper.at(part.point)
    middle = pin.minus(centre).angle
    groove = symbols.arc_groove(centre, part.radius * paper.scale, middle)
    ends = [groove.at(0.0), groove.at(1.0)]
    body = [paper.at(point) for point in _body(paper, part.body).points]
    arm = min(((p, e) for p in body for e in ends), key=lambda pair: math.dist(*pair))
    yield Layer.AXES, line(centre, pin, AXIS)
    yield Layer.BODIES, line(*arm, BODY)
    yield from _in(Layer.JOINTS, symbols.groove_along(groove))


def _gears(paper: Paper, part: Gears) -> Iterator[Shape]:
    """Yield pitch circles; a sector of what is on a link, the ground at what is not."""
    touch = paper.place(part.touch)
    largest = max(part.first_radius, part.second_radius)
    for point, link, radius in _wheels(part):
        is_ring = part.inner and radius == largest
        if link and not is_ring:
            yield from symbols.sector(paper.at(point), radius * paper.scale, touch)
        yield from symbols.wheel(paper.at(point), radius * paper.scale, touch)
        if not link:
            side = 1 if is_ring else -1
            yield from symbols.standing(paper.at(point), radius * paper.scale, touch, side)


def _wheels(part: Gears | Belt) -> tuple[tuple[str, str, float], ...]:
    """Return centre, link and radius of both wheels; a wheel without a link stands still."""
    return (
        (part.first, part.first_link, part.first_radius),
        (part.second, part.second_link, part.second_radius),
    )


def _belt(paper: Paper, part: Belt) -> Iterator[Shape]:
    mates = paper.at(part.second), paper.at(part.first)
    for (point, link, radius), mate in zip(_wheels(part), mates, strict=True):
        yield Arc(paper.at(point), radius * paper.scale, SYMBOL)
        if not link:
            yield from symbols.standing(paper.at(point), radius * paper.scale, mate, -1)
    for run in part.runs:
        yield line(*paper.ends(run), BODY)


def _rack(paper: Paper, part: Rack) -> Iterator[Shape]:
    start, end = paper.ends(part.line)
    yield from symbols.teeth(start, end, 1 if part.radius > 0 else -1)
    radius = abs(part.radius) * paper.scale
    yield from symbols.sector(paper.at(part.pivot), radius, paper.place(part.touch))
    yield from symbols.wheel(paper.at(part.pivot), radius, paper.place(part.touch))


def _pulleys(paper: Paper, part: Rope) -> Iterator[Shape]:
    """Yield the pulleys of a rope, in front of the blocks of sliders that carry them."""
    for point, radius in dict.fromkeys(zip(part.points[1:-1], part.pulleys, strict=True)):
        yield Arc(paper.at(point), radius * paper.scale, SYMBOL)


def _screw(paper: Paper, part: Screw) -> Layered:
    """Yield nut and thread, and the shaft from the link that turns it, if that is on the axis."""
    at, link = paper.at(part.point), _body(paper, part.link)
    places = [paper.at(point) for point in link.points]
    ends = [*paper.ends(part.axis), *(p for p in places if _on_axis(p, at, part.along))]
    ends.sort(key=part.along.dot)
    yield Layer.AXES, line(ends[0], ends[-1], BODY)
    yield from _in(Layer.WHEELS, symbols.thread(*paper.ends(part.axis)))
    yield Layer.JOINTS, symbols.nut(at, part.along)


def _body(paper: Paper, name: str) -> Link | Slide:
    return next(p for p in paper.figure.parts if isinstance(p, Link | Slide) and p.name == name)


def _on_slide(paper: Paper, point: str) -> bool:
    """Return whether a point is one of a slide, whose guide is drawn by itself."""
    return any(isinstance(part, Slide) and point in part.points for part in paper.figure.parts)


def _on_axis(place: Plane, at: Plane, along: Plane) -> bool:
    return abs(along.turned().dot(place.minus(at))) < ON_AXIS


def pins(paper: Paper) -> Iterator[Shape]:
    """Yield the pins; a point of one body alone is none, one that touches a face is a roller."""
    count: Counter[str] = Counter()
    rollers = set[str]()
    for part in paper.figure.parts:
        match part:
            case Link() | Slide() | Telescope():
                count.update(part.points)
            case Slider() if _on_slide(paper, part.point):
                pass
            case Pivot() | Slider() | Slot() | ArcSlot():
                count[part.point] += 2
            case Contact():
                rollers.add(part.point)
            case _:
                pass
    for point, bodies in count.items():
        if point in rollers:
            yield Arc(paper.at(point), ROLLER, SYMBOL, fill="white")
        elif bodies > 1:
            yield symbols.pin(paper.at(point))


# -------------------------------------------------------------- the guides of slides


def draw_slide_guides(sheet: Sheet, paper: Paper) -> None:
    """Draw a guide on each body that only translates, where there is most room for it."""
    for part in paper.figure.parts:
        if isinstance(part, Slide):
            stubs = list(_stubs(paper, part))
            guides = [(rod, tuple(symbols.guide(at, part.along))) for at, rod in stubs]
            cost = [_cost(sheet, paper, *pair) for pair in guides]
            rod, guide = guides[cost.index(min(cost))]
            sheet.draw(Layer.BODIES, [rod])
            sheet.draw(Layer.GROUND, guide)


def _stubs(paper: Paper, body: Slide) -> Iterator[tuple[Plane, Polyline]]:
    """Yield where a guide can be, and the rod in it: between points, before, behind."""
    along, places = body.along, [paper.at(point) for point in body.points]
    faces = faces_of(paper.figure, body.name)
    places.sort(key=along.dot)
    if not faces:
        for start, end in itertools.pairwise(places):
            if along.dot(end.minus(start)) > GUIDE_ROOM and _on_axis(end, start, along):
                yield start.plus(end).times(0.5), line(start, end, BODY)
    outline = [*places, *(wedge(paper, body, faces).points if faces else ())]
    low, high = min(map(along.dot, outline)), max(map(along.dot, outline))
    for end, edge, sense in ((places[-1], high, 1), (places[0], low, -1)):
        start = off(end, along, edge - along.dot(end))
        tip = off(start, along, sense * STUB)
        yield off(start, along, sense * STUB / 2), line(start, tip, BODY)


def _cost(sheet: Sheet, paper: Paper, rod: Polyline, guide: tuple[Shape, ...]) -> int:
    """Return the cost of a guide: lines that it crosses, and a force at its end of the rod."""
    forces = [f for f in paper.figure.parts if isinstance(f, Force)]
    pushed = any(math.dist(paper.at(f.point), p) < 1 for f in forces for p in rod.points)
    return sheet.occupied.crossed(guide) + 2 * pushed
