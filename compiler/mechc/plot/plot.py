"""A plot as data: curves in panels above one another, what is marked on them, the table."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Literal

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..pose.places import Plane
from ..units import UNITS, Dimension

MarkKind = Literal["minimum", "maximum", "zero", "default", "station"]
"""``default`` is the pose of the description, ``station`` a point along the path of a point."""


class PlotAxis(NamedTuple):
    """A quantity along an axis or in a column: what it measures, and the unit it is shown in."""

    name: str
    dimension: Dimension
    unit: str = ""

    @property
    def size(self) -> float:
        """Return one of its unit in SI."""
        return UNITS[self.unit].size if self.unit in UNITS else 1.0


class FamilyValue(NamedTuple):
    """A parameter of a family, and the value that it is set to."""

    axis: PlotAxis
    value: float


class Mark(NamedTuple):
    """A marked point of a curve: an extremum, a zero, the default pose, or a station of a path."""

    kind: MarkKind
    at: Plane
    station: float = 0.0
    """The value of the parameter that varies along the path, at a station."""


class Zone(NamedTuple):
    """Stretches of the axis on which conditions hold, and what they are."""

    conditions: tuple[str, ...]
    stretches: tuple[tuple[float, float], ...]


@frozen
class Curve:
    """One result with one setting of the family, in pieces without a break.

    It is infinite at its ``poles``, and goes from one value to another at its ``jumps``. Of its
    zeros and poles some are ``dead_centres``.
    """

    name: str
    setting: tuple[FamilyValue, ...]
    pieces: tuple[tuple[Plane, ...], ...]
    marks: tuple[Mark, ...] = ()
    poles: tuple[float, ...] = ()
    jumps: tuple[float, ...] = ()
    dead_centres: tuple[float, ...] = ()

    @property
    def steps(self) -> Iterator[tuple[Plane, Plane]]:
        """Yield from where to where it jumps."""
        for before, after in pairwise(self.pieces):
            start, end = before[-1], after[0]
            if any(start.x <= jump <= end.x for jump in self.jumps):
                yield start, end


@frozen
class Panel:
    """Curves of one dimension over the same axis, and the part of the other axis that is shown.

    Near a pole no axis is long enough: what is beyond ``low`` and ``high`` is cut off.
    """

    y: PlotAxis
    curves: tuple[Curve, ...]
    low: float
    high: float


@frozen
class PlotColumn:
    """A column of the table: its values in SI, NaN where there is none."""

    axis: PlotAxis
    setting: tuple[FamilyValue, ...]
    values: tuple[float, ...]


@frozen
class Plot:
    """Panels over one axis from ``low`` to ``high``.

    ``varied`` is what runs: the axis itself, but for the path of a point, whose axes are
    ``equal``. ``given`` is the range that the description gives, where the plot goes beyond it;
    ``zone`` is what else is marked.
    """

    title: str
    x: PlotAxis
    varied: PlotAxis
    low: float
    high: float
    panels: tuple[Panel, ...]
    columns: tuple[PlotColumn, ...]
    given: tuple[float, float] | None = None
    equal: bool = False
    zone: Zone | None = None

    @property
    def curves(self) -> tuple[Curve, ...]:
        """Return the curves of all panels, in order."""
        return tuple(curve for panel in self.panels for curve in panel.curves)
