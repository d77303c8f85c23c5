"""What stands above the columns of a table, and the values in the units shown."""

import math

from ...drawing.describe_plot import shown as in_words
from ...plot.plot import Column

_IN_ASCII = {"−": "-", "°": " deg", "·": "*", "²": "^2", "³": "^3"}


def head(column: Column) -> str:
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


def values(column: Column) -> list[float | None]:
    """Return the values in the unit of the column to 15 digits, None where there is none."""
    shown = (v / column.axis.size for v in column.values)
    return [None if math.isnan(v) else float(f"{v:.15g}") for v in shown]
