"""What is inside the frame of a panel: curves, poles, marks, and values where there is room."""

import math
from collections.abc import Iterator
from itertools import takewhile

from ...base.named import NamedTuple
from ...plot.plot import Curve, Mark
from ...pose.places import Plane
from ..drawing import Arc, Fill, Label, Polyline, TextRun
from ..labels import AroundPoint
from ..lettering import SIZE, text_size
from ..occupied import Occupied, Rectangle
from ..pens import AXIS, SYMBOL, Pen
from .axes import at_zero, outline
from .panels import PanelLayout, place_of, steps, values_at, ways

NAMED = 6
"""How many marks of a panel have their values written beside them; more are only dots."""

BELOW = 5.0
"""How far below the upper edge it is written where a curve is infinite."""

DOT, THIN = 0.9, 0.3
"""The radius of a mark, and how wide the lines of marks and jumps are."""


def curves(layout: PanelLayout) -> Iterator[Polyline]:
    """Yield the curves as lines on paper, thin ones where they jump."""
    for curve, pen in layout.pens.items():
        for step in steps(curve, layout):
            yield Polyline(tuple(map(layout.frame.at, step)), thin(pen))
        for way in ways(curve, layout):
            yield Polyline(tuple(map(layout.frame.at, way)), pen)


def thin(pen: Pen) -> Pen:
    """Return the pen of a curve for what is drawn of it besides its line."""
    return pen._replace(width=THIN, dashes=())


def poles(layout: PanelLayout) -> Iterator[Polyline]:
    """Yield a broken line where a curve is infinite, from edge to edge."""
    frame = layout.frame
    for pole in _poles(layout):
        x = layout.at(Plane(pole, 0.0)).x
        yield Polyline((Plane(x, frame.low.y), Plane(x, frame.high.y)), AXIS)


def _poles(layout: PanelLayout) -> list[float]:
    """Return where a curve is infinite inside the frame."""
    frame = layout.frame
    every = sorted({pole for curve in layout.panel.curves for pole in curve.poles})
    return [p for p in every if frame.low.x < layout.at(Plane(p, 0.0)).x < frame.high.x]


def dots(layout: PanelLayout) -> Iterator[tuple[Arc, Mark, Curve]]:
    """Yield the marks inside the frame, and of which curve: rings, and dots for poses."""
    frame = layout.frame
    for curve, pen in layout.pens.items():
        for mark in curve.marks:
            if frame.least.y <= layout.value(mark.at).y <= frame.most.y:
                fill: Fill = "solid" if mark.kind in ("default", "station") else "white"
                yield Arc(layout.at(mark.at), DOT, thin(pen), fill=fill), mark, curve


def values_beside(layout: PanelLayout) -> tuple[Label, ...]:
    """Return the values at marks and poles, off curves and dots, as far as there is room."""
    marked, frame = list(dots(layout)), layout.frame
    lettered = [
        *_at_poles(layout),
        *(_at_mark(*m, layout) for m in marked if m[1].kind != "default"),
    ]
    if len(lettered) > NAMED and not layout.plot.equal:
        return ()
    occupied = Occupied([outline(frame), *at_zero(frame), *curves(layout), *poles(layout)])
    occupied.add(*(dot for dot, *_ in marked))
    labels = (_beside(one, layout, occupied) for one in lettered)
    return tuple(label for label in labels if label)


class _Lettered(NamedTuple):
    """A text to be written beside a point: ``texts`` from the best to the shortest."""

    at: Plane
    texts: tuple[str, ...]
    pen: Pen
    towards: float


def _at_mark(dot: Arc, mark: Mark, curve: Curve, layout: PanelLayout) -> _Lettered:
    towards = -math.pi / 2 if mark.kind == "minimum" else math.pi / 2
    return _Lettered(dot.centre, values_at(mark, curve, layout), dot.pen, towards)


def _at_poles(layout: PanelLayout) -> Iterator[_Lettered]:
    """Yield where curves are infinite, to be written beside the upper end of the broken line."""
    dead = {place for curve in layout.panel.curves for place in curve.dead_centres}
    for pole in _poles(layout):
        at = Plane(layout.at(Plane(pole, 0.0)).x, layout.frame.high.y - BELOW)
        yield _Lettered(at, place_of(pole, pole in dead, layout), SYMBOL, 0.0)


def _beside(lettered: _Lettered, layout: PanelLayout, occupied: Occupied) -> Label | None:
    """Return a text at a place in the first free room near it, which is then taken."""
    for text in lettered.texts:
        name = AroundPoint(lettered.at, (TextRun(text),), lettered.pen, lettered.towards, DOT)
        width, height = text_size(name.runs, SIZE)
        half = Plane(width / 2 + 0.5, height / 2 + 0.3)
        for place, _ in takewhile(lambda c: not c.far, name.candidates(width, height)):
            inside = layout.frame.holds(place.minus(half)) and layout.frame.holds(place.plus(half))
            if inside and occupied.free(place, width, height):
                occupied.write(Rectangle(place, width, height))
                return Label(place, name.runs, lettered.pen, SIZE, width, height)
    return None
