"""The symbols of kinematic schemes after ISO 3952, in millimetres on paper."""

import math
from collections.abc import Iterator

from ..pose.places import Plane, direction
from .drawing import Arc, Polyline, Shape
from .pens import AXIS, BODY, FORCE, HATCH, SYMBOL, Pen

PIN = 1.3
"""The radius of a pin."""

GROUND = 4.6
"""How far the ground is from the pin of a pivot."""

BLOCK, BORE = 3.0, 1.9
"""Half the length and half the width of a sliding block."""

GUIDE = 5.5
"""Half the length of a guide beside its block."""

GROOVE = 11.0
"""Half the length of a circular slot."""

ARROW = 13.0
"""The length of a load's arrow in a scheme, where sizes are not to scale."""

LARGEST_ARROW, SHORTEST_ARROW = 24.0, 3.0
"""The longest arrow on free bodies, where forces are to scale, and the shortest that there is."""

GAP = 0.8
"""How far an arrow keeps off what it acts on."""

COUPLE = 6.0
"""The radius of a couple's arrow."""

WHOLE_WHEEL_RADIUS = 60.0
"""The largest radius of a wheel that is drawn all round."""

RIM = 16.0
"""How long the hatching is on a wheel that stands still."""

_HATCH, _STEP = 2.0, 1.6
"""How long the strokes of hatching are, and how far apart."""

_HEAD, _SPREAD = 3.2, 0.8
"""How long the head of an arrow is, and half how wide."""


def line(start: Plane, end: Plane, pen: Pen) -> Polyline:
    """Return a straight line."""
    return Polyline((start, end), pen)


def off(at: Plane, along: Plane, by: float, across: float = 0.0) -> Plane:
    """Return a place ahead of another along a unit direction, and to its left by ``across``."""
    return at.plus(along.times(by)).plus(along.turned().times(across))


def pin(at: Plane) -> Arc:
    """Return a pin."""
    return Arc(at, PIN, SYMBOL, fill="white")


def hatched(start: Plane, end: Plane, ground: Plane) -> Iterator[Shape]:
    """Yield the edge of the ground, hatched on the side in the direction ``ground``."""
    yield line(start, end, SYMBOL)
    length = math.dist(start, end)
    along = end.minus(start).times(1 / length)
    count = max(2, round(length / _STEP))
    lean = ground.minus(along).times(_HATCH / math.sqrt(2))
    for i in range(count):
        foot = start.plus(along.times((i + 0.75) * length / count))
        yield line(foot, foot.plus(lean), HATCH)


def pivot(at: Plane, ground: Plane) -> Iterator[Shape]:
    """Yield a pin on the ground, which is in the direction ``ground`` of it."""
    feet = [off(at, ground, GROUND, side) for side in (-2.6, 2.6)]
    yield Polyline((at, *feet), SYMBOL, closed=True, fill="white")
    yield from hatched(off(at, ground, GROUND, 4.2), off(at, ground, GROUND, -4.2), ground)


def block(at: Plane, along: Plane) -> Polyline:
    """Return a sliding block."""
    corners = ((-BLOCK, -BORE), (BLOCK, -BORE), (BLOCK, BORE), (-BLOCK, BORE))
    return Polyline(tuple(off(at, along, *c) for c in corners), SYMBOL, True, "white")


def guide(at: Plane, along: Plane) -> Iterator[Shape]:
    """Yield the two hatched edges between which something slides."""
    for side in (1, -1):
        start, end = (off(at, along, side * d, side * BORE) for d in (-GUIDE, GUIDE))
        yield from hatched(start, end, along.turned().times(side))


def groove(start: Plane, end: Plane) -> Iterator[Shape]:
    """Yield a slot with round ends; its pin is drawn over it."""
    along = end.minus(start).unit() or Plane(1.0, 0.0)
    for side in (1, -1):
        yield line(off(start, along, 0, side * PIN), off(end, along, 0, side * PIN), SYMBOL)
    yield Arc(start, PIN, SYMBOL, along.angle + math.pi / 2, math.pi)
    yield Arc(end, PIN, SYMBOL, along.angle - math.pi / 2, math.pi)


def arc_groove(centre: Plane, radius: float, middle: float) -> Arc:
    """Return the middle line of a circular slot around the direction of its pin."""
    half = min(math.radians(40), GROOVE / radius)
    return Arc(centre, radius, SYMBOL, middle - half, 2 * half)


def groove_along(way: Arc) -> Iterator[Shape]:
    """Yield a slot with round ends along an arc."""
    for side in (1, -1):
        yield way._replace(radius=way.radius + side * PIN)
    end = way.start + way.sweep
    yield Arc(way.at(0.0), PIN, SYMBOL, way.start - math.pi, math.pi)
    yield Arc(way.at(1.0), PIN, SYMBOL, end, math.pi)


def groove_floor(start: Plane, end: Plane) -> Polyline:
    """Return the inside of a slot, which covers what is drawn below it."""
    along = end.minus(start).unit() or Plane(1.0, 0.0)
    left, right = (along.turned().times(side * PIN) for side in (1, -1))
    corners = (start.plus(left), end.plus(left), end.plus(right), start.plus(right))
    return Polyline(corners, Pen("none", 0.0, "#ffffff"), True, "white")


def cylinder(first: Plane, second: Plane) -> Iterator[Shape]:
    """Yield a cylinder pinned at the first point, its rod at the second."""
    length = math.dist(first, second)
    along = second.minus(first).unit() or Plane(1.0, 0.0)
    back, front, piston = 0.18 * length, 0.62 * length, 0.45 * length
    half = min(2.4, 0.12 * length)
    yield line(first, off(first, along, back), BODY)
    yield line(off(first, along, piston), second, BODY)
    corners = ((back, -half), (front, -half), (front, half), (back, half))
    yield Polyline(tuple(off(first, along, *c) for c in corners), SYMBOL, closed=True)
    yield line(off(first, along, piston, half), off(first, along, piston, -half), BODY)


def spring(first: Plane, second: Plane) -> Iterator[Shape]:
    """Yield a coil spring between two points."""
    length = math.dist(first, second)
    along = second.minus(first).unit() or Plane(1.0, 0.0)
    turns = max(4, min(9, round(0.6 * length / 3.0)))
    start, coil = 0.2 * length, 0.6 * length
    across = min(2.2, coil / turns)
    heights = [0.0, *(across * (-1) ** i for i in range(2 * turns)), 0.0]
    places = [0.0, *(i + 0.5 for i in range(2 * turns)), 2 * turns]
    coils = (
        off(first, along, start + coil * p / (2 * turns), h)
        for p, h in zip(places, heights, strict=True)
    )
    yield Polyline((first, *coils, second), SYMBOL)


def head(tip: Plane, along: Plane, pen: Pen, length: float = _HEAD) -> Polyline:
    """Return the head of an arrow."""
    spread = _SPREAD * length / _HEAD
    feet = (off(tip, along, -length, side) for side in (spread, -spread))
    return Polyline((tip, *feet), pen, closed=True, fill="solid")


def arrow(tail: Plane, tip: Plane, pen: Pen = FORCE) -> Iterator[Shape]:
    """Yield the line and the head of an arrow between places in mm; by default that of a force.

    The head ends at the tip, and is smaller where the arrow is short.
    """
    along = tip.minus(tail).unit() or Plane(1.0, 0.0)
    size = min(_HEAD, 0.6 * math.dist(tail, tip))
    yield line(tail, off(tip, along, -size), pen)
    yield head(tip, along, pen, size)


def couple(
    at: Plane, start: float, counterclockwise: bool, radius: float = COUPLE
) -> Iterator[Shape]:
    """Yield the round arrow of a couple, whose middle is in the direction ``start``."""
    sense = 1 if counterclockwise else -1
    half = math.radians(70)
    arc = Arc(at, radius, FORCE, start - sense * half, sense * 2 * half)
    end = arc.start + arc.sweep
    back = _HEAD / radius
    yield arc._replace(sweep=arc.sweep - sense * back)
    towards = direction(end - sense * back / 2).turned().times(sense)
    yield head(arc.at(1.0), towards, FORCE)


def wheel(centre: Plane, radius: float, touch: Plane) -> Iterator[Shape]:
    """Yield a gear: its pitch circle, of a large one the part next to its pitch point, its hub."""
    if radius <= WHOLE_WHEEL_RADIUS:
        yield Arc(centre, radius, AXIS)
    else:
        yield _rim(centre, radius, touch)
    if radius > 3 * PIN:
        yield Arc(centre, 2 * PIN, SYMBOL, fill="white")


def sector(centre: Plane, radius: float, touch: Plane) -> Iterator[Shape]:
    """Yield the sides of a large gear, of which a part at ``touch`` is drawn; lengths are in mm.

    A gear that is drawn all round has none.
    """
    if radius > WHOLE_WHEEL_RADIUS:
        rim = _rim(centre, radius, touch)
        for end in (rim.at(0.0), rim.at(1.0)):
            yield line(centre, end, SYMBOL)


def _rim(centre: Plane, radius: float, touch: Plane) -> Arc:
    """Return the part of a pitch circle next to its pitch point."""
    half = 0.5 * WHOLE_WHEEL_RADIUS / radius
    return Arc(centre, radius, AXIS, touch.minus(centre).angle - half, 2 * half)


def standing(centre: Plane, radius: float, touch: Plane, ground: int) -> Iterator[Shape]:
    """Yield hatching on the rim of a wheel that stands still, where it is away from its mate.

    The ground is outside of the rim for a ``ground`` of 1, as of a ring, inside for −1.
    """
    half = min(0.5 * RIM / radius, math.pi / 3)
    middle = touch.minus(centre).angle + (math.pi if radius <= WHOLE_WHEEL_RADIUS else 0.0)
    yield Arc(centre, radius, SYMBOL, middle - half, 2 * half)
    count = max(3, round(2 * half * radius / _STEP))
    for i in range(count):
        out = direction(middle + half * ((2 * i + 1) / count - 1))
        foot = off(centre, out, radius)
        yield line(
            foot, off(foot, out, ground * _HATCH / math.sqrt(2), -_HATCH / math.sqrt(2)), HATCH
        )


def teeth(start: Plane, end: Plane, side: int) -> Iterator[Shape]:
    """Yield a rack whose teeth are on the left of its direction, for a side of 1."""
    length = math.dist(start, end)
    along = end.minus(start).times(1 / length)
    count = max(3, round(length / 2.4))
    profile = ((0.0, -0.8), (0.25, -0.8), (0.4, 0.8), (0.65, 0.8), (0.8, -0.8))
    points = [
        off(start, along, (i + x) * length / count, side * y)
        for i in range(count)
        for x, y in profile
    ]
    back = (off(end, along, 0, side * y) for y in (-0.8, -3.2))
    yield Polyline((*points, *back, off(start, along, 0, side * -3.2)), SYMBOL, True, "light")
    yield line(start, end, AXIS)


def thread(start: Plane, end: Plane) -> Iterator[Shape]:
    """Yield a threaded rod."""
    length = math.dist(start, end)
    along = end.minus(start).times(1 / length)
    half, count = 1.4, max(4, round(length / 2.0))
    corners = [off(p, along, 0, s) for p, s in ((start, half), (end, half), (end, -half))]
    yield Polyline((*corners, off(start, along, 0, -half)), SYMBOL, True, "white")
    step = length / count
    for i in range(count):
        yield line(
            off(start, along, i * step, -half), off(start, along, (i + 1) * step, half), HATCH
        )


def nut(at: Plane, along: Plane) -> Polyline:
    """Return the nut of a screw."""
    return block(at, along)._replace(fill="light")


def corner(at: Plane, first: Plane, second: Plane) -> Polyline:
    """Return the sign that two bars, in these unit directions of a point, are one body.

    Of bars in one line it is on the right of the first.
    """
    size = 3.4
    ends = [at.plus(first.times(size)), at.plus(second.times(size))]
    if abs(first.turned().dot(second)) < 0.2:
        ends.append(at.plus(first.turned().times(-1.1 * size / 2)))
    return Polyline((*([] if len(ends) > 2 else [at]), *ends), BODY, True, "solid")


def centre_of_gravity(at: Plane) -> Iterator[Shape]:
    """Yield the sign of a centre of gravity: a circle, two of its quarters black."""
    yield Arc(at, 1.6, SYMBOL, fill="white")
    for quarter in (0, 2):
        sector = Arc(at, 1.6, SYMBOL, quarter * math.pi / 2, math.pi / 2)
        yield Polyline((at, *sector.way()), SYMBOL, closed=True, fill="solid")
