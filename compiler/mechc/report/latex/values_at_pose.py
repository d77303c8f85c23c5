"""The values of formulas at the default pose, as LaTeX."""

from collections.abc import Collection, Iterable, Iterator
from math import isfinite, isnan

from ...formula.layout import decimal
from ...formula.operations import count_operations
from ...formula.tree import ZERO, Formula, Number
from ...study.analysis import Analysis
from ...units import NUMBER
from ..by_parts import by_parts
from ..evaluated import Evaluated
from ..languages.locale import Locale
from ..sections import is_idle_direction
from ..sentences.remarks import asked, is_direction
from .display import LINE_WIDTH, DisplayLine, aligned, broken
from .notation import LatexNotation, name
from .printer import Box, box, latex, plain
from .quantity import in_unit, measured, usual_unit

LONGEST_DERIVATIVE = 34
"""A derivative of more operations than this is given by its value."""


def values(found: Iterable[Evaluated], locale: Locale, style: LatexNotation) -> str:
    """Return formulas with the numbers put in, below each other.

    Where they are too long for a line, the sums that have names on the page come first.
    """
    split = by_parts(found, style.made.sums, lambda item: bool(_parts(item, style)))
    lines = [_line(item, locale, style) for item in split]
    return aligned(lines) if lines else ""


def _parts(item: Evaluated, style: LatexNotation) -> list[Box]:
    """Return the numbers of a formula as the lines that they take; none where they fit on none."""
    left = box(item.left, style)
    return broken(DisplayLine(left, item.numbers, item.angle), style) if item.numbers else []


def in_line(item: Evaluated, locale: Locale, style: LatexNotation) -> str:
    """Return a name and its value, to stand in a line of text."""
    value = in_unit(item.value.value, item.value.unit, locale, style)
    return f"${latex(item.left, style)}={value}$"


def _line(item: Evaluated, locale: Locale, style: LatexNotation) -> tuple[str, float]:
    """Return a formula in numbers and its value, on several lines where one is too short.

    With it comes its width.
    """
    left, value = box(item.left, style), in_unit(item.value.value, item.value.unit, locale, style)
    parts = _parts(item, style)
    if not parts:
        return f"{left.tex}&={value}", left.width + plain(value).width + 1.2
    width = left.width + parts[-1].width + plain(value).width + 2.4
    between = r" \\ &=" if width > LINE_WIDTH else "="
    numbers = r" \\ &\quad{}".join(part.tex for part in parts)
    whole = f"{left.tex}&={numbers}{between}{value}"
    return whole, width if len(parts) == 1 else LINE_WIDTH


def numbers(
    results: Iterable[Analysis], shown: Collection[Formula], locale: Locale, style: LatexNotation
) -> tuple[str, ...]:
    """Return the results at the default pose, and those of their derivatives that are long.

    Those that are ``shown`` with their formulas are left out, and those whose formula is the value.
    """
    found: list[str] = []
    before = ""
    for result in results:
        idle = is_own_value(result) or is_idle_direction(result)
        if asked(result) not in shown and not idle:
            found.append(_number(result, locale, style))
        heading = locale.slope if result.where else locale.derivatives
        slopes = [*_slopes(result, locale, style)]
        if slopes and heading != before:
            called = heading[0].lower() + heading[1:] if any(found) else heading
            slopes[0], before = f"{called}: {slopes[0]}", heading
        found += slopes
    return tuple(filter(None, found))


def is_own_value(result: Analysis) -> bool:
    """Return whether a formula is a number without unit that needs no digits, such as 0 or 1/2."""
    formula, is_bare = result.formula, result.dimension == NUMBER
    if result.undetermined or not isinstance(formula, Number):
        return False
    return formula == ZERO or (is_bare and decimal(formula.value) is not None)


def _number(result: Analysis, locale: Locale, style: LatexNotation) -> str:
    """Return a result's value at the values given: none, 0/0, one, or two where it jumps."""
    symbol = latex(asked(result), style)
    if result.undetermined:
        why = locale.no_direction if is_direction(result) else rf"{locale.undetermined} ($0/0$)"
        return f"${symbol}$ {why}"
    if len(result.sides) > 1 and not any(map(isnan, result.sides)):
        low, high = (measured(s, result.dimension, locale, style) for s in result.sides)
        return f"${symbol}$: {locale.checked['jumps'].format(low=f'${low}$', high=f'${high}$')}"
    if len(result.sides) > 1:
        return f"${symbol}$ {locale.undetermined}"
    if result.default is None or not isfinite(result.default):
        return ""
    return f"${symbol}={measured(result.default, result.dimension, locale, style)}$"


def _slopes(result: Analysis, locale: Locale, style: LatexNotation) -> Iterator[str]:
    symbol, short = latex(asked(result), style), dict(short_derivatives(result))
    for parameter, (value, dimension, unit) in result.slopes.items():
        if parameter not in short and (result.derivatives or {})[parameter] != ZERO:
            left = slope(symbol, parameter, style, total=bool(result.where)).tex
            shown = in_unit(value, unit or usual_unit(dimension), locale, style)
            yield f"${left}={shown}$"


def short_derivatives(result: Analysis) -> Iterator[tuple[str, Formula]]:
    """Yield the derivatives that a person would write down; of others the value is given."""
    for parameter, formula in (result.derivatives or {}).items():
        if formula != ZERO and count_operations(formula) <= LONGEST_DERIVATIVE:
            yield parameter, formula


def slope(symbol: str, parameter: str, style: LatexNotation, total: bool) -> Box:
    """Return the sign of a derivative: a total one where other angles follow the parameter."""
    d = r"\mathrm{d}" if total else r"\partial"
    whole = rf"\frac{{{d} {symbol}}}{{{d} {name(parameter, style)}}}"
    return Box(whole, 0.6 + plain(symbol).width, tall=True)
