"""The axes of a panel: where a value is on paper, frame, grid, ticks and what they say."""

from collections.abc import Iterator

from ...base.frozen import frozen
from ...plot.plot import PlotAxis
from ...pose.places import Plane
from ..drawing import Fill, Label, Polyline, Shape, TextRun
from ..lettering import SIZE, name, text_size
from ..pens import SYMBOL, Pen
from .ticks import Scale

GRID = Pen("grid", 0.12, "#c9c9c9")
ZERO = Pen("zero", 0.25, "#777777")
PAPER = Pen("paper", 0.0)

_SMALL = 3.3
"""The size of the numbers at ticks."""

BELOW, BESIDE = 2.0, 1.2
"""How far these are from the frame, in millimetres: letters leave room above them, not beside."""


@frozen
class PanelFrame:
    """A panel on paper: its lower left and upper right corner, and the values there."""

    low: Plane
    high: Plane
    least: Plane
    most: Plane

    def at(self, value: Plane) -> Plane:
        """Return where values, in the units of the axes, are on paper."""
        return Plane(
            _between(value.x, self.least.x, self.most.x, self.low.x, self.high.x),
            _between(value.y, self.least.y, self.most.y, self.low.y, self.high.y),
        )

    def holds(self, place: Plane) -> bool:
        """Return whether a place on paper is inside."""
        across = self.low.x < place.x < self.high.x
        return across and self.low.y < place.y < self.high.y


def _between(value: float, least: float, most: float, low: float, high: float) -> float:
    return low + (value - least) / (most - least) * (high - low)


def outline(frame: PanelFrame) -> Polyline:
    """Return the frame of a panel."""
    return rectangle(frame.low, frame.high, "", SYMBOL)


def rectangle(low: Plane, high: Plane, fill: Fill, pen: Pen = PAPER) -> Polyline:
    """Return a rectangle between two corners, without a border unless a pen is given."""
    corners = (low, Plane(high.x, low.y), high, Plane(low.x, high.y))
    return Polyline(corners, pen, closed=True, fill=fill)


def grid(frame: PanelFrame, across: Scale, up: Scale) -> Iterator[Shape]:
    """Yield the lines at ticks, and that at 0 if it lies inside."""
    for value in across.ticks:
        x = frame.at(Plane(value, frame.least.y)).x
        if frame.low.x < x < frame.high.x:
            yield Polyline((Plane(x, frame.low.y), Plane(x, frame.high.y)), GRID)
    for value in up.ticks:
        y = frame.at(Plane(frame.least.x, value)).y
        if frame.low.y < y < frame.high.y:
            yield Polyline((Plane(frame.low.x, y), Plane(frame.high.x, y)), GRID)
    yield from at_zero(frame)


def at_zero(frame: PanelFrame) -> Iterator[Polyline]:
    """Yield the line at 0, if it lies inside."""
    y = frame.at(Plane(frame.least.x, 0.0)).y
    if frame.low.y < y < frame.high.y:
        yield Polyline((Plane(frame.low.x, y), Plane(frame.high.x, y)), ZERO)


def numbers_below(frame: PanelFrame, across: Scale) -> Iterator[Label]:
    """Yield the numbers at the ticks of the lower side."""
    for value in across.ticks:
        at = frame.at(Plane(value, frame.least.y))
        yield _number(across.text(value), at.minus(Plane(0.0, BELOW)), Plane(0.0, -0.5))


def numbers_beside(frame: PanelFrame, up: Scale) -> Iterator[Label]:
    """Yield the numbers at the ticks of the left side."""
    for value in up.ticks:
        at = frame.at(Plane(frame.least.x, value))
        yield _number(up.text(value), at.minus(Plane(BESIDE, 0.0)), Plane(-0.5, 0.0))


def _number(text: str, at: Plane, away: Plane) -> Label:
    """Return a number whose box has its middle so many widths and heights away from a place."""
    runs = (TextRun(text),)
    width, height = text_size(runs, _SMALL)
    middle = at.plus(Plane(away.x * width, away.y * height))
    return Label(middle, runs, SYMBOL, _SMALL, width, height)


def label(at: Plane, runs: tuple[TextRun, ...], pen: Pen = SYMBOL) -> Label:
    """Return a label whose box begins at a place, in the middle of its height."""
    width, height = text_size(runs, SIZE)
    return Label(Plane(at.x + width / 2, at.y), runs, pen, SIZE, width, height)


def heading(axes: tuple[PlotAxis, ...], scale: Scale) -> tuple[TextRun, ...]:
    """Return the title of an axis: names, and the unit with a power of ten."""
    runs: tuple[TextRun, ...] = ()
    for i, axis in enumerate(axes):
        runs += ((TextRun(", "),) if i else ()) + name(axis.name)
    factor = (TextRun("10"), TextRun(str(scale.exponent).replace("-", "−"), level=1)) * bool(
        scale.exponent
    )
    unit = in_words(axes[0].unit)
    if not factor and not unit:
        return runs
    space = (TextRun("\u2009"),) if factor and unit else ()
    return (*runs, TextRun(", "), *factor, *space, *unit)


def in_words(unit: str) -> tuple[TextRun, ...]:
    """Return a unit as it is set: upright, a power raised.

    >>> [(run.text, run.level) for run in in_words("N*m^2")], in_words("deg")[0].text
    ([('N·m', 0), ('2', 1)], '°')
    >>> [(run.text, run.level) for run in in_words("1/m")]
    [('m', 0), ('−1', 1)]
    """
    if unit in ("deg", ""):
        return (TextRun("°"),) if unit else ()
    if unit.startswith("1/") and unit[2:].isalpha():
        return TextRun(unit[2:], unit=True), TextRun("−1", level=1)
    pieces = unit.replace("*", "·").split("^")
    runs = [TextRun(pieces[0], unit=True)]
    for piece in pieces[1:]:
        runs.append(TextRun(piece[0], level=1))
        runs += [TextRun(piece[1:], unit=True)] if piece[1:] else []
    return tuple(runs)
