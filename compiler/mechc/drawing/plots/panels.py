"""How a panel of a plot is laid out: its frame and ticks, its curves as lines, what it says."""

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from ...base.frozen import frozen
from ...plot.plot import Curve, FamilyValue, Mark, Panel, Plot, PlotAxis
from ...pose.places import Plane
from ..drawing import TextRun
from ..lettering import name
from ..pens import Pen
from ..tolerances import SAME_WHOLE_NUMBER
from .axes import PanelFrame
from .describe_plot import shown
from .ticks import Scale, scale, widened

WIDE, HIGH, LOWER = 110.0, 72.0, 48.0
"""How wide and high a panel is; lower where there are several."""

ACROSS, UP, UP_LOWER = 9, 7, 5
"""How many spaces between ticks there are at most."""

CURVES = tuple(
    Pen(f"curve{i}", 0.55, colour, dashes)
    for i, (colour, dashes) in enumerate(
        (colour, dashes)
        for dashes in ((), (2.4, 1.0))
        for colour in ("#1f4e9e", "#c2410c", "#15803d", "#7e22ce", "#111111", "#0e7490")
    )
)
"""How curves are drawn: in colours of different lightness, then dashed."""


@frozen
class PanelLayout:
    """A panel with its frame, whose corners have values in the units shown, and its ticks."""

    plot: Plot
    panel: Panel
    frame: PanelFrame
    across: Scale
    up: Scale
    words: Mapping[str, str]

    def value(self, place: Plane) -> Plane:
        """Return a place in SI in the units shown."""
        return Plane(place.x / self.plot.x.size, place.y / self.panel.y.size)

    def at(self, place: Plane) -> Plane:
        """Return where a place in SI is on paper."""
        return self.frame.at(self.value(place))

    @property
    def shaded(self) -> Iterator[tuple[float, float]]:
        """Yield the stretches to be shaded, in the unit shown, as far as they are in the frame."""
        given = (self.plot.given,) if self.plot.given else ()
        stretches = self.plot.zone.stretches if self.plot.zone else given
        for ends in stretches:
            low, high = (self.value(Plane(end, 0.0)).x for end in ends)
            if max(low, self.frame.least.x) < min(high, self.frame.most.x):
                yield max(low, self.frame.least.x), min(high, self.frame.most.x)

    @property
    def pens(self) -> dict[Curve, Pen]:
        """Return the pen of each curve."""
        return dict(zip(self.panel.curves, CURVES, strict=False))

    @property
    def headed(self) -> tuple[PlotAxis, ...]:
        """Return the quantities on the vertical axis: the results, or the coordinate."""
        if self.plot.equal:
            return (self.panel.y,)
        names = dict.fromkeys(curve.name for curve in self.panel.curves)
        return tuple(self.panel.y._replace(name=n) for n in names)

    @property
    def has_legend(self) -> bool:
        """Return whether it must be said which line is which."""
        return len(self.panel.curves) > 1 or self.plot.equal

    @property
    def common(self) -> tuple[FamilyValue, ...]:
        """Return the setting of all curves; nothing where they have several."""
        settings = {curve.setting for curve in self.panel.curves}
        return settings.pop() if len(settings) == 1 else ()


def laid_out(plot: Plot, panel: Panel, words: Mapping[str, str]) -> PanelLayout:
    """Return the layout of a panel, in words of a language; axes of a path have one scale."""
    most = UP if len(plot.panels) == 1 else UP_LOWER
    frame = _equal(plot, panel) if plot.equal else _frame(plot, panel, most)
    across = scale(frame.least.x, frame.most.x, ACROSS, plot.x.unit == "deg")
    up = scale(frame.least.y, frame.most.y, most, panel.y.unit == "deg")
    if plot.equal:
        step = max(across.step, up.step)
        across, up = _every(across, step), _every(up, step)
    return PanelLayout(plot, panel, frame, across, up, words)


def _frame(plot: Plot, panel: Panel, most: int) -> PanelFrame:
    y, x = panel.y, plot.x
    low, high = widened(panel.low / y.size, panel.high / y.size, most, y.unit == "deg")
    height = HIGH if len(plot.panels) == 1 else LOWER
    corners = Plane(0.0, 0.0), Plane(WIDE, height)
    return PanelFrame(*corners, Plane(plot.low / x.size, low), Plane(plot.high / x.size, high))


def _equal(plot: Plot, panel: Panel) -> PanelFrame:
    """Return a frame with one scale along both axes, for the path of a point."""
    places = [p for curve in panel.curves for piece in curve.pieces for p in piece]
    xs, ys = [p.x / plot.x.size for p in places], [p.y / panel.y.size for p in places]
    extent = max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    step = scale(0.0, extent, UP).step
    (left, right), (low, high) = (
        (math.floor(min(c) / step - 0.1) * step, math.ceil(max(c) / step + 0.1) * step)
        for c in (xs, ys)
    )
    one = min(WIDE / (right - left), WIDE / (high - low))
    corners = Plane(0.0, 0.0), Plane(one * (right - left), one * (high - low))
    return PanelFrame(*corners, Plane(left, low), Plane(right, high))


def _every(found: Scale, step: float) -> Scale:
    """Return a scale with ticks at multiples of a step alone."""
    ticks = (t for t in found.ticks if abs(t / step - round(t / step)) < SAME_WHOLE_NUMBER)
    return found._replace(ticks=tuple(ticks))


# -------------------------------------------------------------------------------- curves


def ways(curve: Curve, layout: PanelLayout) -> Iterator[tuple[Plane, ...]]:
    """Yield a curve as far as it lies inside the panel, in the units shown, by few places."""
    frame = layout.frame
    for piece in curve.pieces:
        for inside in cut([layout.value(p) for p in piece], frame.least.y, frame.most.y):
            on_paper = [frame.at(p) for p in inside]
            yield tuple(inside[i] for i in kept(on_paper))


def steps(curve: Curve, layout: PanelLayout) -> Iterator[tuple[Plane, ...]]:
    """Yield the jumps of a curve as far as they lie inside the panel, in the units shown."""
    frame = layout.frame
    for ends in curve.steps:
        yield from map(tuple, cut([*map(layout.value, ends)], frame.least.y, frame.most.y))


def cut(places: Sequence[Plane], low: float, high: float) -> Iterator[list[Plane]]:
    """Yield the parts of a curve between two heights.

    >>> list(cut([Plane(0, 0), Plane(1, 2)], 0, 1))
    [[Plane(x=0, y=0), Plane(x=0.5, y=1)]]
    """
    part: list[Plane] = []
    for start, end in pairwise(places):
        if max(start.y, end.y) < low or min(start.y, end.y) > high:
            continue
        first, last = _brought(start, end, low, high), _brought(end, start, low, high)
        if part and part[-1] != first:
            yield part
            part = []
        part += [last] if part else [first, last]
    if part:
        yield part


def _brought(place: Plane, towards: Plane, low: float, high: float) -> Plane:
    """Return a place brought between two heights along the line to another."""
    edge = min(max(place.y, low), high)
    if edge == place.y:
        return place
    part = (edge - place.y) / (towards.y - place.y)
    return Plane(place.x + part * (towards.x - place.x), edge)


def kept(places: Sequence[Plane], off: float = 0.01) -> Iterator[int]:
    """Yield the numbers of the places by which a line is drawn: none other is off by more.

    >>> list(kept([Plane(0, 0), Plane(1, 0.001), Plane(2, 0)]))
    [0, 2]
    """
    yield 0
    start = 0
    for between in range(1, len(places) - 1):
        if _leaves_out(places, start, between + 1, off):
            yield between
            start = between
    yield len(places) - 1


def _leaves_out(places: Sequence[Plane], start: int, end: int, off: float) -> bool:
    """Return whether a straight line is off from something that it stands for."""
    way = places[end].minus(places[start])
    length = math.hypot(*way)
    if length == 0:
        return True
    across = way.turned().times(1 / length)
    return any(abs(across.dot(p.minus(places[start]))) > off for p in places[start + 1 : end])


# ------------------------------------------------------------------------- what it says


def values_at(mark: Mark, curve: Curve, layout: PanelLayout) -> tuple[str, ...]:
    """Return the possible labels of a mark, the longest first."""
    plot = layout.plot
    if mark.kind == "station":
        return (shown(mark.station, plot.varied),)
    if mark.kind == "zero":
        return place_of(mark.at.x, mark.at.x in curve.dead_centres, layout)
    x = shown(mark.at.x, plot.x)
    y = shown(mark.at.y, layout.panel.y)
    return f"({x}; {y})", y


def place_of(x: float, is_dead_centre: bool, layout: PanelLayout) -> tuple[str, ...]:
    """Return the possible labels of a zero or a pole, the longest first."""
    at = shown(x, layout.plot.x)
    return (f"{layout.words['dead_centre']}, {at}", at) if is_dead_centre else (at,)


def entry(curve: Curve, layout: PanelLayout) -> tuple[TextRun, ...]:
    """Return a curve's entry in the legend: its name if there are several, its setting."""
    several = len({c.name for c in layout.panel.curves}) > 1 or layout.plot.equal
    settings = () if layout.common else curve.setting
    return _listed([*([name(curve.name)] if several else []), *map(_set_to, settings)])


def common_entry(layout: PanelLayout) -> tuple[TextRun, ...]:
    """Return the legend's entry for all curves: the setting that they have in common."""
    return _listed(list(map(_set_to, layout.common)))


def _listed(parts: Sequence[tuple[TextRun, ...]]) -> tuple[TextRun, ...]:
    runs = [run for part in parts for run in (TextRun(", "), *part)]
    return tuple(runs[1:])


def _set_to(value: FamilyValue) -> tuple[TextRun, ...]:
    return (*name(value.axis.name), TextRun(f" = {shown(value.value, value.axis)}"))
