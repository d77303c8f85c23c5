"""The values of a plot as a table: comma-separated, or as an Excel sheet by ``mechc[xlsx]``."""

import csv
import io
import math
from datetime import datetime
from importlib import import_module
from typing import Any

from ..diagnostics import MechcError
from ..diagnostics.drawing import no_library
from ..drawing.plots.describe_plot import shown as in_words
from ..plot.plot import Plot, PlotColumn

_IN_ASCII = {"−": "-", "°": " deg", "·": "*", "²": "^2", "³": "^3"}


def head(column: PlotColumn) -> str:
    """Return the name of a column, its setting and its unit: ``k (beta = 10 deg) [mm]``."""
    pairs = ((v.axis, plain(in_words(v.value, v.axis, 6))) for v in column.setting)
    settings = ", ".join(f"{axis.name} = {value}" for axis, value in pairs)
    unit = f" [{column.axis.unit}]" if column.axis.unit else ""
    return f"{column.axis.name}{f' ({settings})' if settings else ''}{unit}"


def plain(text: str) -> str:
    """Return a value in ASCII.

    >>> plain("−2.5°"), plain("3 kN·m²")
    ('-2.5 deg', '3 kN*m^2')
    """
    for sign, written in _IN_ASCII.items():
        text = text.replace(sign, written)
    return text


def values(column: PlotColumn) -> list[float | None]:
    """Return the values in the unit of the column to 15 digits, None where there is none."""
    shown = (v / column.axis.size for v in column.values)
    return [None if math.isnan(v) else float(f"{v:.15g}") for v in shown]


def to_csv(plot: Plot) -> str:
    """Return the table in the units shown, 15 digits, empty where there is no value."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(map(head, plot.columns))
    for row in zip(*map(values, plot.columns), strict=True):
        writer.writerow("" if value is None else repr(value) for value in row)
    return out.getvalue()


EPOCH = datetime(2000, 1, 1)
"""The date in the file, so that the same table makes the same bytes."""

NARROWEST = 14
"""The least width of a column, in letters."""


def to_xlsx(plot: Plot) -> bytes:
    """Return a workbook with one sheet; :class:`MechcError` (E721) without the library."""
    try:
        xlsxwriter: Any = import_module("xlsxwriter")
    except ImportError as error:
        raise MechcError([no_library("Excel", "xlsx", str(error))]) from None
    out = io.BytesIO()
    options = {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False}
    with xlsxwriter.Workbook(out, options) as book:
        book.set_properties({"title": plot.title, "created": EPOCH})
        _fill(book, plot)
    return out.getvalue()


def _fill(book: Any, plot: Plot) -> None:
    """Write the columns of a plot into a sheet, with what is not finite as text."""
    sheet = book.add_worksheet("values")
    bold = book.add_format({"bold": True, "align": "right"})
    sheet.freeze_panes(1, 1)
    for i, column in enumerate(plot.columns):
        sheet.set_column(i, i, max(NARROWEST, len(head(column)) + 1))
        sheet.write_string(0, i, head(column), bold)
        for row, value in enumerate(values(column), start=1):
            if value is not None and math.isfinite(value):
                sheet.write_number(row, i, value)
            elif value is not None:
                sheet.write_string(row, i, repr(value))
