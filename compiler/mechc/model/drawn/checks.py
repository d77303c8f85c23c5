"""What is wrong with drawn places: points that are missing, at one place, or off their lines."""

import math
from collections.abc import Iterator
from itertools import pairwise

from ...diagnostics import Diagnostic
from ...diagnostics import drawn as messages
from ..entries import points_of
from ..mechanism import Mechanism, Slider, Slot
from .sketch import Sketch

BACKWARDS = -0.5
"""The cosine of the angle to the drawn fall below which a rope is said to run the wrong way."""


def faults(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield E321, E322, E327 and E345."""
    yield from _without_place(mechanism, sketch)
    yield from _coinciding(mechanism, sketch)
    yield from _off_line(mechanism, sketch)
    yield from _turned_falls(mechanism, sketch)


def _without_place(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points of links that are drawn nowhere, and that no vector leads to."""
    placed = sketch.places.keys() | {p for g in mechanism.geometry for p in points_of(g)}
    placed |= {slot.head for slot in mechanism.each(Slot)}  # it may but name the line
    for point in dict.fromkeys(p for link in mechanism.links for p in link.points):
        if mechanism.drawn and point not in placed:
            is_pivot = point in sketch.pivots
            yield messages.drawn_nowhere(mechanism.spans[point], point, is_pivot)


def _coinciding(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points of a body at the place of another one of it."""
    for points in (body.points for body in mechanism.bodies):
        for hub, point in sketch.arms(points):
            if sketch.coincide(hub, point):
                at, first = sketch.span(point), sketch.span(hub)
                yield messages.drawn_together(at, "".join(points), point, hub, first)


def _off_line(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the points that are drawn off the line along which they slide.

    One to which a vector leads is on its line where the loop closes: what is drawn gives way.
    """
    slack = {d.point: d.slack for d in mechanism.drawn}
    for point, start, line, turned in _lines(mechanism, sketch):
        x, y = sketch.way(start, point)
        gap = abs(y * math.cos(turned) - x * math.sin(turned))
        allowed = slack.get(point, 0.0) + slack.get(start, 0.0) + sketch.rounding
        if point not in sketch.led and gap > allowed:
            yield messages.drawn_off_guide(sketch.span(point), point, line, sketch.shown(gap))


def _lines(mechanism: Mechanism, sketch: Sketch) -> Iterator[tuple[str, str, str, float]]:
    """Yield each drawn point on a line, a point of the line, its name, and its direction."""
    for s in mechanism.each(Slider):
        turned = sketch.turned(s.along)
        if turned is not None and s.through and sketch.has_all((s.point, s.through)):
            yield s.point, s.through, f"the guide through {s.through}", turned
    for slot in mechanism.each(Slot):
        if sketch.has_all((slot.point, slot.tail, slot.head)):
            x, y = sketch.way(slot.tail, slot.head)
            line = f"the slot {slot.tail}{slot.head}"
            yield slot.point, slot.tail, line, math.atan2(y, x)


def _turned_falls(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the falls of ropes whose direction is against the way from point to point."""
    for rope in mechanism.ropes:
        for (tail, head), along in zip(pairwise(rope.route), rope.ways, strict=True):
            turned = sketch.turned(along)
            if turned is not None and sketch.has_all((tail, head)):
                x, y = sketch.way(tail, head)
                ahead = x * math.cos(turned) + y * math.sin(turned)
                if ahead < BACKWARDS * math.hypot(x, y):
                    yield messages.fall_drawn_backwards(along.span, tail, head)
