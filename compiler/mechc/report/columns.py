"""Columns along a stroke that say nothing new: of one value, or of the values of a result."""

import math

from ..named import NamedTuple
from ..study.stroke.stroke import Column, Stroke

SAME = 1e-9
"""Values along a stroke that differ by less than this part are one: rounding of operations."""

FEW = 5
"""Places at which curves may meet by chance; what they say of all the stroke takes so many."""


class Repeated(NamedTuple):
    """The column of a result that another one repeats, and ``-`` where it is less it."""

    column: Column
    sign: str


def is_constant(index: int, stroke: Stroke) -> bool:
    """Return whether a column has one value at all places that have any."""
    values = [row.values[index] for row in stroke.rows if not row.trouble]
    size = max(map(abs, values), default=math.nan)
    return math.isfinite(size) and max(values) - min(values) <= SAME * size


def repeated(index: int, stroke: Stroke) -> Repeated | None:
    """Return the result of which a ratio of speeds has the values, or those with a minus.

    None where the stroke is looked at in a few places only.
    """
    ratio = stroke.columns[index]
    if ratio.content != "velocity" or len(stroke.rows) < FEW or is_constant(index, stroke):
        return None
    for other, column in enumerate(stroke.columns):
        if column.content == "result" and column.dimension == ratio.dimension:
            for sign, factor in (("", 1), ("-", -1)):
                if _are_alike(index, other, factor, stroke):
                    return Repeated(column, sign)
    return None


def _are_alike(index: int, other: int, factor: int, stroke: Stroke) -> bool:
    """Return whether a column has the values of another times a factor, at all places."""
    pairs = [(row.values[index], factor * row.values[other]) for row in stroke.rows]
    size = max((abs(v) for pair in pairs for v in pair if math.isfinite(v)), default=math.nan)
    return all(
        a == b or abs(a - b) <= SAME * size or (math.isnan(a) and math.isnan(b)) for a, b in pairs
    )
