"""The values of a plot as an Excel sheet, by a library that ``mechc[xlsx]`` installs."""

import io
import math
from datetime import datetime
from importlib import import_module
from typing import Any

from ...diagnostics import MechcError
from ...diagnostics.drawing import no_library
from ...plot.plot import Plot
from .heads import head, values

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
