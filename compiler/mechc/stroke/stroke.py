"""The stroke as data: rows, the stretches on which it can be run, singular poses, extrema."""

from collections.abc import Mapping
from typing import Literal, NamedTuple

from ..formula.tree import Formula
from ..frozen import frozen
from ..units import Dimension

Kind = Literal["output still", "drive locked", "branch point", "perpendicular load", "other"]


class Row(NamedTuple):
    """One place: the drive, each column's value (NaN where it has none), and what is wrong.

    ``trouble`` is '' at a pose that stands.
    """

    drive: float
    values: tuple[float, ...]
    trouble: str


class Column(NamedTuple):
    """A result, the speed of a load's point per unit of the drive, or a transmission angle."""

    name: str
    dimension: Dimension


class Stretch(NamedTuple):
    """A part of the stroke that can be run; what ends it at either side, '' at the stroke's end."""

    low: float
    high: float
    before: str
    after: str


class Singular(NamedTuple):
    """A place at which a result is zero or infinite, and which kind of pose that is.

    ``exact`` is the drive as a formula, where a factor that vanishes can be solved for it.
    The place lies within ``bracket``.
    """

    result: str
    value: Literal["0", "infinite", "undetermined"]
    kind: Kind
    drive: float
    bracket: float
    exact: Formula | None


class Extremum(NamedTuple):
    """A place at which a result is least or greatest nearby."""

    result: str
    kind: Literal["minimum", "maximum"]
    drive: float
    value: float


@frozen
class Stroke:
    """Everything along the stroke of one mechanism; all in SI and radians."""

    drive: str
    dimension: Dimension
    unit: str
    low: float
    high: float
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    stretches: tuple[Stretch, ...]
    singular: tuple[Singular, ...]
    extrema: tuple[Extremum, ...]
    defaults: Mapping[str, float]
