"""The values of a plot as comma-separated values."""

import csv
import io

from ...plot.plot import Plot
from .heads import head, values


def to_csv(plot: Plot) -> str:
    """Return the table in the units shown, 15 digits, empty where there is no value."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(map(head, plot.columns))
    for row in zip(*map(values, plot.columns), strict=True):
        writer.writerow("" if value is None else repr(value) for value in row)
    return out.getvalue()
