"""The stroke as a table for people."""

import math
import sys
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from html import escape
from textwrap import wrap

from ...base.named import NamedTuple
from ...formula.letters import Letters, lettered, letters, of_unit
from ...formula.to_text import text
from ...study.analysis import DeadCentre
from ...study.locking_intervals import USUAL, EfficiencyRange, rounded_share
from ...study.stroke.stroke import (
    ChangePoint,
    Content,
    Extremum,
    Singular,
    StandstillInterval,
    Stroke,
    StrokeColumn,
    StrokeInterval,
    StrokeRow,
    ZeroInterval,
)
from ...study.tolerances import EXACT, NEARLY
from ...units import ANGLE, UNITS, Dimension, behind, in_unit, si_unit
from ..columns import legend, repeated
from ..digits import VALUE_DIGITS
from ..languages.registry import locale
from ..sentences.limits import dead_centre
from .character_sets import ASCII, tens

ENDS = {
    (False, False): "",
    (True, False): "lower out",
    (False, True): "upper out",
    (True, True): "both out",
}
"""The words for the ends of an interval that are left out, lower and upper."""


ENOUGH_DIGITS = 13
"""Digits beyond which the ends of an interval are one place."""


class WrittenStroke(NamedTuple):
    """A stroke and the words, numbers and units of the language in which it is written."""

    stroke: Stroke
    words: Mapping[str, str]
    letters: Letters

    def says(self, key: str, **names: object) -> str:
        """Return the words of a key with names in their places."""
        return self.words[key].format(**names)

    def number(self, figures: str) -> str:
        """Return a number, with its unit or without, in the letters of the language."""
        return lettered(tens(figures, ASCII), self.letters)

    def head(self, name: str, unit: str) -> str:
        """Return the head of a column with its unit in the letters of the language."""
        return headed(name, of_unit(unit, self.letters))


def written(stroke: Stroke, language: str) -> WrittenStroke:
    """Return a stroke to be written in a language."""
    known = locale(language)
    return WrittenStroke(stroke, known.along_stroke, letters(known))


def held(row: StrokeRow, shown: WrittenStroke) -> str:
    """Return which results stand still in a row: ``k_f jammed, k_hold locked``."""
    stroke = shown.stroke
    near = EXACT * (stroke.high - stroke.low)
    found = (s for s in stroke.standstills if _is_in(row.drive, s, near) and s.state != "free")
    return ", ".join(shown.says(_state(s), name=s.result) for s in found)


def _state(found: StandstillInterval) -> str:
    """Return the key of a state: what is said to drive and cannot is no self-locking."""
    return "driving" if found.driving and found.state == "locked" else found.state


def _is_in(x: float, found: StandstillInterval, near: float) -> bool:
    """Return whether a value is in an interval, or so near to an end that it is that end."""
    below, above = (-near if left_out else near for left_out in found.left_out)
    return found.low - below <= x <= found.high + above


def to_table(
    stroke: Stroke, velocities: bool = False, language: str = "en", width: int = sys.maxsize
) -> str:
    """Return the rows as a table, then stretches, singular poses and extrema, in users' units.

    With ``velocities`` the table has slopes and velocity ratios, too; one that is a result is
    said below. Sentences there are broken to ``width`` columns.
    """
    hidden: set[Content] = set() if velocities else {"slope", "velocity"}
    shown, columns = written(stroke, language), enumerate(stroke.columns)
    found = {i: repeated(i, stroke) for i, c in columns if c.content not in hidden}
    alike = {i: result for i, result in found.items() if result}
    values = (f"{stroke.columns[i].name} = {r.sign}{r.column.name}" for i, r in alike.items())
    lines = [shown.says("throughout", values=", ".join(values))] if alike else []
    lines += (*meanings(shown, hidden), *said(shown))
    return "\n".join((*_aligned(table(shown, hidden, alike)), *_broken(lines, width))) + "\n"


def _broken(lines: Iterable[str], width: int) -> Iterator[str]:
    for line in lines:
        yield from wrap(line, width, subsequent_indent="    ", break_long_words=False)


def table(
    shown: WrittenStroke, hidden: Collection[Content], without: Collection[int] = ()
) -> list[list[str]]:
    """Return heading and rows, cell by cell; the last one of a row is what is wrong there.

    Columns of what is ``hidden``, and those at some places, are left out.
    """
    stroke, columns = shown.stroke, enumerate(shown.stroke.columns)
    indices = [i for i, c in columns if c.content not in hidden and i not in without]
    kept = [stroke.columns[i] for i in indices]
    head = [shown.head(stroke.drive, unit_of(stroke.dimension, stroke.unit))]
    head += [shown.head(c.name, unit_of(c.dimension, c.unit)) for c in kept]
    body = [
        [
            _value(row.drive, shown),
            *_cells([row.values[i] for i in indices], kept, row.undetermined, shown),
            shown.says(row.trouble) if row.trouble else held(row, shown),
        ]
        for row in stroke.rows
    ]
    return [[*head, ""], *body]


def meanings(shown: WrittenStroke, hidden: Collection[Content]) -> Iterator[str]:
    """Yield a line on what each speed and angle in the heading means."""
    columns = (c for c in shown.stroke.columns if c.content not in hidden)
    yield from legend(columns, shown.words, lambda about: about.name, str)


def said(shown: WrittenStroke) -> Iterator[str]:
    """Yield what happens along a stroke, line by line."""
    stroke = shown.stroke
    for stretch in stroke.stretches:
        yield from _stretch(stretch, shown)
    if not stroke.stretches:
        yield shown.says("nowhere")
    yield from (_without(name, loads, shown) for name, loads in stroke.without)
    yield from (_branch(b, shown) for b in stroke.branches)
    yield from (_zero_part(part, shown) for part in stroke.zero_intervals)
    yield from (_singular(s, shown) for s in stroke.singular)
    yield from (_extremum(e, shown) for e in stroke.extrema)
    yield from (_standstill(s, shown) for s in stroke.standstills)
    yield from (
        _efficiency_range(name, efficiency, shown) for name, efficiency in stroke.efficiency_ranges
    )
    if stroke.looked:
        yield shown.says("looked", count=stroke.looked)


def _cells(
    values: Sequence[float],
    columns: Sequence[StrokeColumn],
    undetermined: Collection[str],
    shown: WrittenStroke,
) -> list[str]:
    return [
        shown.says("undetermined") if c.name in undetermined else _cell(v, c, shown)
        for v, c in zip(values, columns, strict=True)
    ]


def _cell(value: float, column: StrokeColumn, shown: WrittenStroke) -> str:
    if not math.isfinite(value):
        return "" if math.isnan(value) else shown.says("infinite")
    return shown.number(_in(value, unit_of(column.dimension, column.unit), 9))


def unit_of(dimension: Dimension, wanted: str) -> str:
    """Return the unit shown: the user's, degrees for angles, SI for the rest."""
    if wanted in UNITS:
        return wanted
    return "deg" if dimension == ANGLE else si_unit(dimension)


def _in(value: float, unit: str, digits: int) -> str:
    """Return a value in a unit, without the unit."""
    return in_unit(value, unit, digits).removesuffix(behind(unit))


def headed(name: str, unit: str) -> str:
    """Return the head of a column, its unit in brackets."""
    return f"{name} [{unit}]" if unit else name


def _value(x: float, shown: WrittenStroke, digits: int = 9) -> str:
    stroke = shown.stroke
    return shown.number(_in(x, unit_of(stroke.dimension, stroke.unit), digits))


def _at(x: float, shown: WrittenStroke, digits: int = VALUE_DIGITS) -> str:
    """Return the drive and its value; what is nearer to zero than values are found is zero."""
    x = x if abs(x) > NEARLY * abs(shown.stroke.high - shown.stroke.low) else 0.0
    unit = unit_of(shown.stroke.dimension, shown.stroke.unit)
    turn = f" ({shown.number(in_unit(x, 'deg', digits))})" if unit == "rad" else ""
    return f"{shown.stroke.drive} = {shown.number(in_unit(x, unit, digits))}{turn}"


def _aligned(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = [cell.rjust(w) for cell, w in zip(row[:-1], widths, strict=False)]
        yield "  ".join([*cells, row[-1]]).rstrip()


def _stretch(stretch: StrokeInterval, shown: WrittenStroke) -> Iterator[str]:
    if stretch.before:
        yield shown.says("below", at=_at(stretch.low, shown), why=shown.says(stretch.before))
    if stretch.after:
        yield shown.says("above", at=_at(stretch.high, shown), why=shown.says(stretch.after))
    if not stretch.reached:
        yield shown.says("apart", span=_span(stretch.low, stretch.high, shown))


def _without(name: str, loads: Sequence[str], shown: WrittenStroke) -> str:
    values = shown.says("and").join(shown.says("give", load=load) for load in loads)
    return shown.says("without", name=name, loads=", ".join(loads), values=values)


def _branch(found: ChangePoint, shown: WrittenStroke) -> str:
    return shown.says("two ways", at=_at(found.drive, shown), loop=found.loop)


KINDS = {"branch point": "zero and infinite", "other": ""}
"""The words for kinds of singular poses, where they are not those of the kind itself."""


def _singular(found: Singular, shown: WrittenStroke) -> str:
    """Return the line of a singular pose: the value there, both where it jumps, and its cause."""
    does, names = f"is {found.value}", {"name": found.result, "at": _at(found.drive, shown)}
    if found.sides is not None:
        low, high = (_measured(side, found.result, shown, VALUE_DIGITS) for side in found.sides)
        does, names = "jumps", {**names, "low": low, "high": high}
    whole = shown.says(does, **names)
    if found.exact is not None:
        whole += shown.says("exactly", value=text(found.exact))
    if isinstance(found.kind, DeadCentre):
        return f"{whole}: {dead_centre(found.kind, shown.words, str)}"
    kind = KINDS.get(found.kind, found.kind)
    if kind == "jump" and found.sides:
        return whole
    return f"{whole}: {shown.says(kind)}" if kind else whole


def _zero_part(part: ZeroInterval, shown: WrittenStroke) -> str:
    return shown.says("zero part", name=part.result, span=_span(part.low, part.high, shown))


def _extremum(found: Extremum, shown: WrittenStroke) -> str:
    """Return where a result is least or greatest, be it on one side of a jump alone."""
    value = _measured(found.value, found.result, shown, VALUE_DIGITS)
    is_beside = any(
        one.result == found.result and one.drive == found.drive and found.value in (one.sides or ())
        for one in shown.stroke.singular
    )
    kind = f"{found.kind} beside jump" if is_beside else found.kind
    return shown.says(kind, name=found.result, value=value, at=_at(found.drive, shown))


def _measured(value: float, result: str, shown: WrittenStroke, digits: int) -> str:
    """Return a value of a result in the unit of its column."""
    column = next(c for c in shown.stroke.columns if c.name == result)
    return shown.number(in_unit(value, unit_of(column.dimension, column.unit), digits))


def _standstill(found: StandstillInterval, shown: WrittenStroke) -> str:
    span, left_out = _span(found.low, found.high, shown), ENDS[found.left_out]
    ends = shown.says(left_out) if left_out else ""
    names = {"name": found.result, "load": found.driving, "span": span, "ends": ends}
    return shown.says(f"{_state(found)} part", **names)


def _efficiency_range(name: str, efficiency: EfficiencyRange, shown: WrittenStroke) -> str:
    parts = [shown.says("from", span=_span(*part, shown)) for part in efficiency.usual]
    reached = (efficiency.least, efficiency.greatest, *USUAL)
    least, greatest, low, high = (shown.number(rounded_share(x)) for x in reached)
    where = shown.says("and").join(parts) or shown.says("no part")
    if not efficiency.is_of_joints:
        return shown.says("course alone", name=name, least=least, greatest=greatest)
    return shown.says(
        "course", name=name, least=least, greatest=greatest, low=low, high=high, parts=where
    )


def _span(low: float, high: float, shown: WrittenStroke) -> str:
    """Return an interval, with as many digits as its ends take to be two."""
    for digits in range(VALUE_DIGITS, ENOUGH_DIGITS + 1):
        ends = _at(low, shown, digits), _at(high, shown, digits)
        if len({*ends}) == 2:
            break
    return shown.says("span", low=ends[0], high=ends[1])


def to_html(stroke: Stroke) -> str:
    """Return the table that ``mechc stroke`` prints, and the lines below it.

    The last column says what is wrong in a row; there is none where nothing is.
    """
    shown = written(stroke, "en")
    hidden: set[Content] = {"slope", "velocity"}
    cells = table(shown, hidden)
    if not any(row[-1] for row in cells):
        cells = [row[:-1] for row in cells]
    head, *body = cells
    rows = [_row("th", head), *(_row("td", row) for row in body)]
    lines = "".join(f"<li>{escape(line)}</li>" for line in (*meanings(shown, hidden), *said(shown)))
    return f"<table>{''.join(rows)}</table><ul>{lines}</ul>"


def _row(tag: str, cells: list[str]) -> str:
    return "<tr>{}</tr>".format("".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells))
