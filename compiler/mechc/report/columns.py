"""Columns along a stroke: what their names mean in words, and which of them say nothing new.

A column says nothing new that has one value, or the values of a result.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import assert_never

from ..base.named import NamedTuple
from ..study.stroke.stroke import AngleAt, SpeedOf, Stroke, StrokeColumn

SAME_ALONG_STROKE = 1e-9
"""Values along a stroke that differ by less than this part are one: rounding of operations."""

CHANCE_MEETINGS = 5
"""Places at which curves may meet by chance; what they say of all the stroke takes so many."""


class RepeatedColumn(NamedTuple):
    """The column of a result whose values another column repeats, all of them or all negative."""

    column: StrokeColumn
    sign: str
    """``-`` where the other column has the negative values, else ''."""


def is_constant(index: int, stroke: Stroke) -> bool:
    """Return whether a column has one value at all places that have any."""
    values = [row.values[index] for row in stroke.rows if not row.trouble]
    size = max(map(abs, values), default=math.nan)
    return math.isfinite(size) and max(values) - min(values) <= SAME_ALONG_STROKE * size


def repeated(index: int, stroke: Stroke) -> RepeatedColumn | None:
    """Return the result of which a ratio of speeds has the values, or those with a minus.

    None where the stroke is looked at in a few places only.
    """
    ratio = stroke.columns[index]
    if (
        ratio.content != "velocity"
        or len(stroke.rows) < CHANCE_MEETINGS
        or is_constant(index, stroke)
    ):
        return None
    for other, column in enumerate(stroke.columns):
        if column.content == "result" and column.dimension == ratio.dimension:
            for sign, factor in (("", 1), ("-", -1)):
                if _are_alike(index, other, factor, stroke):
                    return RepeatedColumn(column, sign)
    return None


def _are_alike(index: int, other: int, factor: int, stroke: Stroke) -> bool:
    """Return whether a column has the values of another times a factor, at all places."""
    pairs = [(row.values[index], factor * row.values[other]) for row in stroke.rows]
    size = max((abs(v) for pair in pairs for v in pair if math.isfinite(v)), default=math.nan)
    return all(
        a == b or abs(a - b) <= SAME_ALONG_STROKE * size or (math.isnan(a) and math.isnan(b))
        for a, b in pairs
    )


Spelled = Callable[[str], str]


def legend(
    columns: Iterable[StrokeColumn],
    words: Mapping[str, str],
    symbol: Callable[[SpeedOf | AngleAt], str],
    spell: Spelled,
) -> Iterator[str]:
    """Yield a sentence without its stop on each speed and each transmission angle.

    ``symbol`` writes what it is called, ``spell`` points, links, loads and parameters.
    """
    for about in dict.fromkeys(about for column in columns for about in column.about):
        yield _meaning(about, words, symbol(about), spell)


def _meaning(
    about: SpeedOf | AngleAt, words: Mapping[str, str], symbol: str, spell: Spelled
) -> str:
    """Return the sentence that says what a column's name means: a speed, or an angle at a pin."""
    match about:
        case SpeedOf(_, kind, of, load):
            said = words[f"means {kind}"]
            return said.format(name=symbol, of=spell(of), load=spell(load) if load else "")
        case AngleAt(_, pin, rod, link):
            said = words["means angle" if link else "means at guide"]
            other = spell(link) if link else ""
            return said.format(name=symbol, of=spell(pin), rod=spell(rod), link=other)
        case _:
            assert_never(about)
