"""What is inside the frame of a panel: curves, poles, marks, and values where there is room."""

import math
from collections.abc import Iterator
from itertools import takewhile

from ..plot.plot import Mark
from ..pose.places import Plane
from .axes import outline
from .drawing import AXIS, Arc, Fill, Label, Pen, Polyline, Run
from .labels import Around
from .lettering import SIZE, box
from .occupied import Box, Occupied
from .panels import Layout, steps, values_at, ways

NAMED = 6
"""How many marks of a panel have their values written beside them; more are only dots."""

DOT, THIN = 0.9, 0.3
"""The radius of a mark, and how wide the lines of marks and jumps are."""


def curves(layout: Layout) -> Iterator[Polyline]:
    """Yield the curves as lines on paper, thin ones where they jump."""
    for curve, pen in layout.pens.items():
        for step in steps(curve, layout):
            yield Polyline(tuple(map(layout.frame.at, step)), thin(pen))
        for way in ways(curve, layout):
            yield Polyline(tuple(map(layout.frame.at, way)), pen)


def thin(pen: Pen) -> Pen:
    """Return the pen of a curve for what is drawn of it beside its line."""
    return pen._replace(width=THIN, dashes=())


def poles(layout: Layout) -> Iterator[Polyline]:
    """Yield a broken line where a curve is infinite, from edge to edge."""
    frame = layout.frame
    for pole in sorted({pole for curve in layout.panel.curves for pole in curve.poles}):
        x = layout.at(Plane(pole, 0.0)).x
        if frame.low.x < x < frame.high.x:
            yield Polyline((Plane(x, frame.low.y), Plane(x, frame.high.y)), AXIS)


def dots(layout: Layout) -> Iterator[tuple[Arc, Mark]]:
    """Yield the marks inside the frame: rings, and dots for poses."""
    frame = layout.frame
    for curve, pen in layout.pens.items():
        for mark in curve.marks:
            if frame.least.y <= layout.value(mark.at).y <= frame.most.y:
                fill: Fill = "solid" if mark.kind in ("default", "station") else "white"
                yield Arc(layout.at(mark.at), DOT, thin(pen), fill=fill), mark


def values_beside(layout: Layout) -> tuple[Label, ...]:
    """Return the values at marks, off curves and dots, as far as there is room for them."""
    marked = list(dots(layout))
    told = [(dot.pen, mark) for dot, mark in marked if mark.kind != "default"]
    if len(told) > NAMED and not layout.plot.equal:
        return ()
    occupied = Occupied([outline(layout.frame), *curves(layout), *poles(layout)])
    occupied.add(*(dot for dot, _ in marked))
    labels = (_beside(mark, pen, layout, occupied) for pen, mark in told)
    return tuple(label for label in labels if label)


def _beside(mark: Mark, pen: Pen, layout: Layout, occupied: Occupied) -> Label | None:
    """Return the values at a mark in the first free place near it, which is then taken."""
    at, towards = layout.at(mark.at), -math.pi / 2 if mark.kind == "minimum" else math.pi / 2
    for text in values_at(mark, layout):
        name = Around(at, (Run(text),), pen, towards, DOT)
        width, height = box(name.runs, SIZE)
        half = Plane(width / 2 + 0.5, height / 2 + 0.3)
        for place, _ in takewhile(lambda c: not c.far, name.candidates(width, height)):
            inside = layout.frame.holds(place.minus(half)) and layout.frame.holds(place.plus(half))
            if inside and occupied.free(place, width, height):
                occupied.write(Box(place, width, height))
                return Label(place, name.runs, pen, SIZE, width, height)
    return None
