"""The stroke as comma-separated values, for programs and for spreadsheets."""

import csv
import io
import math
from collections.abc import Iterator

from ...base.named import NamedTuple
from ...study.stroke.stroke import Stroke, StrokeRow
from ...units import size_of
from .stroke import headed, held, unit_of, written

DOUBLE_DIGITS = 15
"""The digits of a number: with fewer, values would be lost, with more, 30° come out as 29.99…"""


class Dialect(NamedTuple):
    """What stands between the fields of CSV, and before the decimals of a number."""

    separator: str
    decimal: str


DIALECTS = {"point": Dialect(",", "."), "comma": Dialect(";", ",")}
"""CSV with a decimal point, and as spreadsheets have it where decimals follow a comma."""


def to_csv(stroke: Stroke, dialect: Dialect = DIALECTS["point"]) -> str:
    """Return the rows as CSV, in the units of its heading.

    There is nothing where there is no value, and no column where there is none at all; what is
    infinite is ``inf``, whichever sign it has nearby. A column says what is in trouble, and one
    what does not move, where anything is.
    """
    columns = [_drive(stroke, dialect), *_values(stroke, dialect), *_remarks(stroke)]
    out = io.StringIO()
    writer = csv.writer(out, delimiter=dialect.separator, lineterminator="\n")
    writer.writerows(zip(*columns, strict=True))
    return out.getvalue()


def _drive(stroke: Stroke, dialect: Dialect) -> list[str]:
    unit = unit_of(stroke.dimension, stroke.unit)
    places = (_number(row.drive, unit, dialect) for row in stroke.rows)
    return [headed(stroke.drive, unit), *places]


def _values(stroke: Stroke, dialect: Dialect) -> Iterator[list[str]]:
    """Yield the columns that have a value somewhere, each with its heading."""
    for i, column in enumerate(stroke.columns):
        unit = unit_of(column.dimension, column.unit)
        cells = [_number(row.values[i], unit, dialect) for row in stroke.rows]
        if any(cells):
            yield [headed(column.name, unit), *cells]


def _number(value: float, unit: str, dialect: Dialect) -> str:
    shown = "" if math.isnan(value) else f"{value / size_of(unit):.{DOUBLE_DIGITS}g}"
    return shown.replace(".", dialect.decimal)


def _remarks(stroke: Stroke) -> Iterator[list[str]]:
    """Yield the columns of words, where there are any words."""
    for heading, cells in (
        ("trouble", [_trouble(row) for row in stroke.rows]),
        ("stuck", [held(row, written(stroke, "en")) for row in stroke.rows]),
    ):
        if any(cells):
            yield [heading, *cells]


def _trouble(row: StrokeRow) -> str:
    """Return the reason why a row lacks values, ``k undetermined`` too."""
    words = [row.trouble] if row.trouble else []
    return ", ".join((*words, *(f"{name} undetermined" for name in row.undetermined)))
