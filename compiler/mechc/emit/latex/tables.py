"""Tables of values in LaTeX: of a plot, and along the stroke."""

import math
from collections.abc import Iterator, Sequence

from ...report.languages.locale import Locale
from ...report.latex.notation import Notation, name, of_result
from ...report.latex.quantity import decimal, usual_unit
from ...report.latex.unit_symbols import unit_symbol
from ...study.stroke.stroke import Column, Stroke
from ...units import size_of

D = r"\mathrm{d}"
"""The sign of a derivative, as in the formulas beside it."""

ABREAST = 6
"""How many columns a table has at most beside that of the drive."""


def tabular(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Yield a table of numbers in the middle of the page."""
    yield r"\begin{center}"
    yield rf"\begin{{tabular}}{{@{{}}{'r' * len(heads)}@{{}}}}"
    yield r"\toprule"
    yield f"{' & '.join(heads)} \\\\"
    yield r"\midrule"
    for row in rows:
        yield f"{' & '.join(row)} \\\\"
    yield r"\bottomrule"
    yield r"\end{tabular}"
    yield r"\end{center}"


def head(written: str, unit: str, locale: Locale) -> str:
    """Return the head of a column: what is in it, and its unit."""
    symbol = unit_symbol(unit, locale).removeprefix(r"\,")
    return f"${written}${f', ${symbol}$' if symbol else ''}"


def number(value: float, style: Notation) -> str:
    """Return a number; a dash where there is none."""
    if math.isnan(value):
        return "--"
    return f"${decimal(value, style)}$" if math.isfinite(value) else r"$\infty$"


def along_stroke(stroke: Stroke, locale: Locale, style: Notation) -> Iterator[str]:
    """Yield the tables of all that is known along the stroke, a few columns in each."""
    shown = [i for i in range(len(stroke.columns)) if not _is_empty(i, stroke)]
    drive = stroke.unit or usual_unit(stroke.dimension)
    places = [number(row.drive / size_of(drive), style) for row in stroke.rows]
    for start in range(0, len(shown), ABREAST):
        columns = [_column(i, stroke, locale, style) for i in shown[start : start + ABREAST]]
        first = [head(name(stroke.drive, style), drive, locale), *places]
        heads, *rows = zip(first, *columns, strict=True)
        yield from tabular(heads, rows)


def _is_empty(index: int, stroke: Stroke) -> bool:
    return all(math.isnan(row.values[index]) for row in stroke.rows)


def _column(index: int, stroke: Stroke, locale: Locale, style: Notation) -> list[str]:
    """Return the head of a column and its values."""
    column = stroke.columns[index]
    unit = column.unit or usual_unit(column.dimension)
    values = (row.values[index] / size_of(unit) for row in stroke.rows)
    return [head(_written(column, style), unit, locale), *(number(v, style) for v in values)]


def _written(column: Column, style: Notation) -> str:
    """Return a column's name: a ratio of speeds, a slope, or a quantity."""
    above, over, below = column.name.partition("/")
    if not over:
        return of_result(above, style)
    if column.content == "slope":
        result, below = of_result(above.removeprefix("d"), style), below.removeprefix("d")
        return rf"{D}{f'({result})' if '/' in result else result}/{D}{name(below, style)}"
    speed = f"{above.partition('(')[0]}_{column.load}" if column.load else above
    return f"{name(speed, style)}/{name(below, style)}"
