"""Tables of values in LaTeX: of a plot, and along the stroke."""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import assert_never

from ...report.columns import is_constant, legend, repeated
from ...report.languages.locale import Locale
from ...report.latex.notation import LatexNotation, name, of_result, points
from ...report.latex.quantity import decimal, usual_unit
from ...report.latex.results import LatexSpeller
from ...report.latex.unit_symbols import unit_symbol
from ...study.stroke.stroke import AngleAt, SpeedOf, Stroke, StrokeColumn
from ...units import size_of

D = r"\mathrm{d}"
"""The sign of a derivative, as in the formulas beside it."""

MOST_COLUMNS = 6
"""How many columns a table has at most besides that of the drive."""


NARROW, LONG = 4, 8
"""A table of so few columns and more rows than this is set in two halves beside each other."""


def tabular(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Yield a table of numbers in the middle of the page, on that of the line above it."""
    yield r"\par\nobreak\medskip{\centering"
    half = math.ceil(len(rows) / 2)
    if len(heads) <= NARROW and len(rows) > LONG:
        yield from _block(heads, rows[:half])
        yield r"\hspace{3em}"
        yield from _block(heads, rows[half:])
    else:
        yield from _block(heads, rows)
    yield r"\par}\medskip"


def _block(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    yield rf"\begin{{tabular}}[t]{{@{{}}{'r' * len(heads)}@{{}}}}"
    yield r"\toprule"
    yield f"{' & '.join(heads)} \\\\"
    yield r"\midrule"
    for row in rows:
        yield f"{' & '.join(row)} \\\\"
    yield r"\bottomrule"
    yield r"\end{tabular}"


def head(written: str, unit: str, locale: Locale) -> str:
    """Return the head of a column: what is in it, and its unit."""
    symbol = unit_symbol(unit, locale).removeprefix(r"\,")
    return f"${written}${f', ${symbol}$' if symbol else ''}"


def numbers(values: Sequence[float], style: LatexNotation) -> list[str]:
    r"""Return a column of numbers, all to the same decimals; a dash where there is none.

    The largest has five figures, one that is not zero three at least, and what all end with is
    left out. Where a column would take too many decimals each number is written by itself.

    >>> from ...report.latex.notation import notation
    >>> numbers([0.5, -12.25, math.nan], notation("en"))
    ['$0.50$', '$-12.25$', '--']
    >>> numbers([-5.0, 3e-15, 5.0], notation("en"))
    ['$-5$', '$0$', '$5$']
    """
    largest = max((abs(v) for v in values if math.isfinite(v)), default=0.0)
    sizes = [0.0 if abs(v) < COLUMN_ROUNDING * largest else v for v in values]
    decimals = _decimals([abs(v) for v in sizes if math.isfinite(v) and v])
    return [_number(size, decimals, style) for size in sizes]


COLUMN_ROUNDING = 1e-12
"""What is below this part of the largest number of a column is rounding where zero is meant."""

FIGURES, LEAST, MOST = 5, 3, 6
"""Figures of the largest number of a column, of the least one, and decimals that it may take."""


def _decimals(sizes: Sequence[float]) -> int | None:
    """Return the decimals of a column of numbers of these sizes, None where it takes too many."""
    if not sizes:
        return 0
    digits = [math.floor(math.log10(f(sizes))) + 1 for f in (max, min)]
    decimals = max(FIGURES - digits[0], LEAST - digits[1], 0)
    if decimals > MOST or digits[0] > MOST:
        return None
    written = [f"{size:.{decimals}f}".rstrip("0").partition(".")[2] for size in sizes]
    return max(map(len, written))


def _number(value: float, decimals: int | None, style: LatexNotation) -> str:
    if math.isnan(value):
        return "--"
    if math.isinf(value):
        return r"$\infty$"
    if decimals is None:
        return f"${decimal(value, style)}$"
    digits = f"{value:.{decimals}f}"
    return f"${(digits if float(digits) else digits.lstrip('-')).replace('.', style.decimal)}$"


def along_stroke(stroke: Stroke, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield all that is known along the stroke as tables, what is constant in a sentence.

    Several tables have the same number of columns, or nearly so.
    """
    shown = [i for i in range(len(stroke.columns)) if not _is_empty(i, stroke)]
    alike = {i: said for i in shown if (said := _repeated(i, stroke, style))}
    varying = [i for i in shown if i not in alike and not is_constant(i, stroke)]
    drive = stroke.unit or usual_unit(stroke.dimension)
    places = numbers([row.drive / size_of(drive) for row in stroke.rows], style)
    if shown:
        yield rf"\medskip\noindent {locale.pictures['stroke']}:"
    for part in _parts(varying):
        columns = [_column(i, stroke, locale, style) for i in part]
        first = [head(name(stroke.drive, style), drive, locale), *places]
        heads, *rows = zip(first, *columns, strict=True)
        yield from tabular(heads, rows)
    if said := " ".join(_said(stroke, shown, alike, varying, locale, style)):
        yield rf"\noindent {said}\par"


def _parts(columns: Sequence[int]) -> Iterator[Sequence[int]]:
    """Yield columns in as few parts as a page takes, none much shorter than another.

    >>> [len(part) for part in _parts(range(7))], [len(part) for part in _parts(range(6))]
    ([4, 3], [6])
    """
    count = math.ceil(len(columns) / MOST_COLUMNS)
    for part in range(count):
        ends = (math.ceil(len(columns) * i / count) for i in (part, part + 1))
        yield columns[slice(*ends)]


def _said(
    stroke: Stroke,
    shown: Sequence[int],
    alike: Mapping[int, str],
    varying: Sequence[int],
    locale: Locale,
    style: LatexNotation,
) -> Iterator[str]:
    """Yield what is the same at all places, then what the names in the tables mean."""
    constant = [i for i in shown if i not in varying]
    if constant:
        said = (alike.get(i) or _constant(i, stroke, locale, style) for i in constant)
        values = ", ".join(said)
        yield locale.along_stroke["throughout"].format(values=values)
    columns = [stroke.columns[i] for i in shown]
    meant = legend(columns, locale.along_stroke, partial(_symbol, style), LatexSpeller(style).point)
    yield from (f"{sentence}." for sentence in meant)


def _is_empty(index: int, stroke: Stroke) -> bool:
    return all(math.isnan(row.values[index]) for row in stroke.rows)


def _repeated(index: int, stroke: Stroke, style: LatexNotation) -> str:
    """Return a ratio of speeds as a result, or less it, that has its values; '' without one."""
    found = repeated(index, stroke)
    ratio = _written(stroke.columns[index], style)
    return f"${ratio}={found.sign}{_written(found.column, style)}$" if found else ""


def _constant(index: int, stroke: Stroke, locale: Locale, style: LatexNotation) -> str:
    """Return a column that has one value as an equation."""
    column = stroke.columns[index]
    unit = _unit(column)
    value = next(row.values[index] for row in stroke.rows if not row.trouble) / size_of(unit)
    return f"${_written(column, style)}={decimal(value, style)}{unit_symbol(unit, locale)}$"


def _unit(column: StrokeColumn) -> str:
    return column.unit or usual_unit(column.dimension)


def _column(index: int, stroke: Stroke, locale: Locale, style: LatexNotation) -> list[str]:
    """Return the head of a column and its values."""
    column, unit = stroke.columns[index], _unit(stroke.columns[index])
    values = [row.values[index] / size_of(unit) for row in stroke.rows]
    return [head(_written(column, style), unit, locale), *numbers(values, style)]


def _written(column: StrokeColumn, style: LatexNotation) -> str:
    """Return a column's name: a ratio of speeds, a slope, an angle, or a quantity."""
    if column.about:
        return "/".join(_tex(about, style) for about in column.about)
    above, over, below = column.name.partition("/")
    if not over or column.content != "slope":
        return of_result(column.name, style)
    result, below = of_result(above.removeprefix("d"), style), below.removeprefix("d")
    result = f"({result})" if "/" in result else result
    return f"{D}{result}/{D}{name(below, style)}"


def _symbol(style: LatexNotation, about: SpeedOf | AngleAt) -> str:
    return f"${_tex(about, style)}$"


def _tex(about: SpeedOf | AngleAt, style: LatexNotation) -> str:
    """Return a component of a velocity with its load, another speed, or a transmission angle."""
    alone, bracket, _ = about.name.partition("(")
    match about:
        case SpeedOf(of=point, load=load) if load:
            return f"V_{{{points(point)},{name(load, style)}}}"
        case SpeedOf():
            return name(alone, style)
        case AngleAt(_, _, rod, link):
            bodies = ",".join(points(body) for body in (rod, link) if body)
            return f"{name(alone, style)}^{{{bodies}}}" if bracket else name(alone, style)
        case _:
            assert_never(about)
