"""The stroke as a table for people."""

import math
from collections.abc import Collection, Iterator, Sequence

from ...formula.to_text import text
from ...model.locking import USUAL, EfficiencyRange
from ...study.stroke.stroke import (
    Branch,
    Column,
    Content,
    Extremum,
    JammedInterval,
    Row,
    Singular,
    Stretch,
    Stroke,
)
from ...study.tolerances import EXACT
from ...units import ANGLE, UNITS, Dimension, behind, in_unit, si_unit


def held(row: Row, stroke: Stroke) -> str:
    """Return which results stand still in a row: ``k_f jammed, k_hold locked``."""
    near = EXACT * (stroke.high - stroke.low)
    found = (s for s in stroke.standstills if _is_in(row.drive, s, near))
    return ", ".join(f"{s.result} {s.state}" for s in found)


def _is_in(x: float, found: JammedInterval, near: float) -> bool:
    """Return whether a value is in an interval, or so near to an end that it is that end."""
    below, above = (-near if left_out else near for left_out in found.left_out)
    return found.low - below <= x <= found.high + above


def to_table(stroke: Stroke, velocities: bool = False) -> str:
    """Return the rows as a table, then stretches, singular poses and extrema, in users' units.

    With ``velocities`` the table has slopes and velocity ratios, too.
    """
    hidden: set[Content] = set() if velocities else {"slope", "velocity"}
    return "\n".join(_lines(stroke, hidden)) + "\n"


def _lines(stroke: Stroke, hidden: Collection[Content]) -> Iterator[str]:
    yield from _aligned(table(stroke, hidden))
    yield from said(stroke)


def table(stroke: Stroke, hidden: Collection[Content]) -> list[list[str]]:
    """Return heading and rows, cell by cell; the last one of a row is what is wrong there."""
    shown = [i for i, c in enumerate(stroke.columns) if c.content not in hidden]
    columns = [stroke.columns[i] for i in shown]
    head = [headed(stroke.drive, unit_of(stroke.dimension, stroke.unit))]
    head += [headed(c.name, unit_of(c.dimension, c.unit)) for c in columns]
    body = [
        [
            _value(row.drive, stroke),
            *_cells([row.values[i] for i in shown], columns, row.undetermined),
            row.trouble or held(row, stroke),
        ]
        for row in stroke.rows
    ]
    return [[*head, ""], *body]


def said(stroke: Stroke) -> Iterator[str]:
    """Yield the lines below the table of a stroke."""
    for stretch in stroke.stretches:
        yield from _stretch(stretch, stroke)
    if not stroke.stretches:
        yield "There is no pose anywhere on the stroke."
    yield from (_without(name, loads) for name, loads in stroke.without)
    yield from (_branch(b, stroke) for b in stroke.branches)
    yield from (_singular(s, stroke) for s in stroke.singular)
    yield from (_extremum(e, stroke) for e in stroke.extrema)
    yield from (_standstill(s, stroke) for s in stroke.standstills)
    yield from (_course(name, course, stroke) for name, course in stroke.courses)
    yield from _looked(stroke)


def _cells(
    values: Sequence[float], columns: Sequence[Column], undetermined: Collection[str]
) -> list[str]:
    return [
        "undetermined" if c.name in undetermined else _cell(v, c)
        for v, c in zip(values, columns, strict=True)
    ]


def _cell(value: float, column: Column) -> str:
    if not math.isfinite(value):
        return "" if math.isnan(value) else "infinite"
    return _in(value, unit_of(column.dimension, column.unit), 9)


def unit_of(dimension: Dimension, wanted: str) -> str:
    """Return the unit shown: the user's, degrees for angles, SI for the rest."""
    if wanted in UNITS:
        return wanted
    return "deg" if dimension == ANGLE else si_unit(dimension)


def _in(value: float, unit: str, digits: int) -> str:
    """Return a value in a unit, without the unit."""
    return in_unit(value, unit, digits).removesuffix(behind(unit))


def headed(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


def _value(x: float, stroke: Stroke, digits: int = 9) -> str:
    return _in(x, unit_of(stroke.dimension, stroke.unit), digits)


def _at(x: float, stroke: Stroke) -> str:
    unit = unit_of(stroke.dimension, stroke.unit)
    return f"{stroke.drive} = {in_unit(x, unit, 13)}"


def _aligned(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = [cell.rjust(w) for cell, w in zip(row[:-1], widths, strict=False)]
        yield "  ".join([*cells, row[-1]]).rstrip()


def _stretch(stretch: Stretch, stroke: Stroke) -> Iterator[str]:
    if stretch.before:
        yield f"below {_at(stretch.low, stroke)}: {stretch.before}"
    if stretch.after:
        yield f"above {_at(stretch.high, stroke)}: {stretch.after}"
    if not stretch.reached:
        span = _span(stretch.low, stretch.high, stroke)
        yield f"{span} cannot be reached from the default pose without taking a loop apart"


def _without(name: str, loads: Sequence[str]) -> str:
    values = " and ".join(f"`let {load} = …`" for load in loads)
    return f"{name} is not shown: it rests on {', '.join(loads)}, without a value; add {values}"


def _branch(found: Branch, stroke: Stroke) -> str:
    at = _at(found.drive, stroke)
    return f"branch point at {at}: the loop {found.loop} can go on in two ways"


def _singular(found: Singular, stroke: Stroke) -> str:
    kinds = {
        "output still": "dead centre, the output stands still while the drive moves",
        "drive locked": "dead centre, the drive stands still while the output can move",
        "branch point": "zero and infinite at once",
        "perpendicular load": "a load perpendicular to the velocity of its point, no dead centre",
        "jump": "" if found.sides else "finite on either side, but not the same",
        "far": "a point that the loops close at is infinitely far away there",
        "other": "",
    }
    exact = f", exactly {text(found.exact)}" if found.exact is not None else ""
    why = f": {kinds[found.kind]}" if kinds[found.kind] else ""
    does = f"= {found.value}"
    if found.sides is not None:
        low, high = (_measured(side, found.result, stroke, 6) for side in found.sides)
        does = f"jumps from {low} to {high}"
    return f"{found.result} {does} at {_at(found.drive, stroke)}{exact}{why}"


def _extremum(found: Extremum, stroke: Stroke) -> str:
    value = _measured(found.value, found.result, stroke, 13)
    return f"{found.result} has a {found.kind} {value} at {_at(found.drive, stroke)}"


def _measured(value: float, result: str, stroke: Stroke, digits: int) -> str:
    """Return a value of a result in the unit of its column."""
    column = next(c for c in stroke.columns if c.name == result)
    return in_unit(value, unit_of(column.dimension, column.unit), digits)


def _standstill(found: JammedInterval, stroke: Stroke) -> str:
    says = {
        "free": "",
        "locked": "self-locking, the load alone moves nothing,",
        "jammed": "jammed, no force of the drive moves anything,",
    }
    ends = {
        (False, False): "",
        (True, False): ", the lower end left out",
        (False, True): ", the upper end left out",
        (True, True): ", both ends left out",
    }
    span = _span(found.low, found.high, stroke)
    return f"{found.result}: {says[found.state]} from {span}{ends[found.left_out]}"


def _course(name: str, course: EfficiencyRange, stroke: Stroke) -> str:
    parts = " and ".join(f"from {_span(*part, stroke)}" for part in course.usual)
    return (
        f"{name} runs from {round(course.least, 3):g} to {round(course.greatest, 3):g}; "
        f"it is between {USUAL[0]} and {USUAL[1]} {parts or 'nowhere'}"
    )


def _looked(stroke: Stroke) -> Iterator[str]:
    """Yield at how many values the stroke was looked at, and what that means."""
    most = max((count for _, count in stroke.looked), default=0)
    fewer: dict[int, list[str]] = {}
    for name, count in stroke.looked:
        fewer.setdefault(count, []).append(name)
    others = [f"; {', '.join(fewer[n])} at {n}" for n in fewer if n < most]
    if most:
        yield (
            f"Looked at {most} places{''.join(others)}: zeros, poles and extrema between "
            "neighbouring ones are refined, two of them closer together may be missed."
        )


def _span(low: float, high: float, stroke: Stroke) -> str:
    return f"{_at(low, stroke)} to {_at(high, stroke)}"
