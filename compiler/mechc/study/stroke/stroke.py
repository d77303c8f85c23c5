"""The stroke as data: rows, the stretches on which it can be run, singular poses, extrema."""

from collections.abc import Mapping
from typing import Literal

from ...base.frozen import frozen
from ...base.named import NamedTuple
from ...formula.tree import Formula
from ...units import Dimension
from ..analysis import Cause
from ..locking_intervals import DriveState, EfficiencyRange

OnTheWay = Literal["branch point", "jump", "far"]
"""What only a stroke meets."""

StrokeEvent = Cause | OnTheWay
Content = Literal["result", "slope", "velocity", "angle", "path"]


class StrokeRow(NamedTuple):
    """One pose: the drive, each column's value (NaN where it has none), and what is wrong.

    ``trouble`` is '' at a pose that stands. Columns that are 0/0 there are ``undetermined``;
    what is infinite has no sign.
    """

    drive: float
    values: tuple[float, ...]
    trouble: str
    undetermined: tuple[str, ...] = ()


class SpeedOf(NamedTuple):
    """A speed by what it is ``of``: a point, the two ends of a distance, a link, a parameter.

    That of a point is its component along a ``load``, or along the guide; that of a distance
    is positive while it grows, that of a link counter-clockwise.
    """

    name: str
    kind: Literal["load", "guide", "distance", "spin", "rate"]
    of: str
    load: str = ""


class AngleAt(NamedTuple):
    """A transmission angle at a pin, between a rod and a link, or the normal of a guide if ''."""

    name: str
    pin: str
    rod: str
    link: str


class StrokeColumn(NamedTuple):
    """A result, its slope along the drive, a velocity ratio, a transmission angle, or a path.

    ``about`` has what the names of ratios and angles mean.
    """

    name: str
    dimension: Dimension
    content: Content = "result"
    unit: str = ""
    about: tuple[SpeedOf | AngleAt, ...] = ()


class StrokeInterval(NamedTuple):
    """A part of the stroke that can be run; what ends it at either side, '' at the stroke's end.

    It is ``reached`` unless the loops would have to be taken apart to get there from the
    default pose.
    """

    low: float
    high: float
    before: str
    after: str
    reached: bool = True


class Singular(NamedTuple):
    """A pose in which a result is zero or infinite, or jumps, and which kind of pose that is.

    ``exact`` is the drive as a formula, where a factor that vanishes can be solved for it.
    The drive lies within ``bracket``. A result that jumps, where something is infinitely ``far``
    or for another reason, comes to both ``sides`` and is undetermined between them.
    """

    result: str
    value: Literal["0", "infinite", "undetermined"]
    kind: StrokeEvent
    drive: float
    bracket: float
    exact: Formula | None
    sides: tuple[float, float] | None = None


class ChangePoint(NamedTuple):
    """A pose in which two closures of a loop are one and it can go on in two ways: a change point.

    Results may well be finite there. The drive lies within ``bracket``.
    """

    loop: str
    drive: float
    bracket: float


class ZeroInterval(NamedTuple):
    """A part of the stroke, between branch points if there are any, on which a result is zero.

    It is zero there but for rounding, and has neither zeros nor extrema of its own.
    """

    result: str
    low: float
    high: float


class Extremum(NamedTuple):
    """A pose in which a result is least or greatest nearby."""

    result: str
    kind: Literal["minimum", "maximum"]
    drive: float
    value: float


class StandstillInterval(NamedTuple):
    """A part of the stroke on which nothing moves: a result with friction is locked, or jammed."""

    result: str
    state: DriveState
    low: float
    high: float
    left_out: tuple[bool, bool] = (False, False)
    """Whether a dead centre at its lower, at its upper end is no part of it."""

    driving: str = ""
    """The load below the line, where that drives and yet nothing moves: no self-locking."""


@frozen
class Stroke:
    """Everything along the stroke of one mechanism; all in SI and radians.

    ``efficiency_ranges`` are the values that each efficiency runs through. ``without`` are the
    loads asked for that rest on loads without a value, with these. ``looked`` states
    at how many values results were looked at: what is found between two of them is refined.
    Ratios are zero all over the ``zero_intervals``.
    """

    drive: str
    dimension: Dimension
    unit: str
    low: float
    high: float
    columns: tuple[StrokeColumn, ...]
    rows: tuple[StrokeRow, ...]
    stretches: tuple[StrokeInterval, ...]
    singular: tuple[Singular, ...]
    branches: tuple[ChangePoint, ...]
    extrema: tuple[Extremum, ...]
    standstills: tuple[StandstillInterval, ...]
    efficiency_ranges: tuple[tuple[str, EfficiencyRange], ...]
    defaults: Mapping[str, float]
    without: tuple[tuple[str, tuple[str, ...]], ...] = ()
    looked: int = 0
    zero_intervals: tuple[ZeroInterval, ...] = ()
