"""The report's last part: what was found and what follows from it."""

from collections.abc import Iterable, Mapping
from math import isfinite
from typing import NamedTuple, assert_never

from ..algebra.formula import Formula, Symbol, product, quotient, total
from ..algebra.formula import number as exact
from ..algebra.layout import is_angle
from ..derivation.wording import enumeration
from ..model.mechanism import LoadForm, LoadRatio, Require, Speed, SpeedRatio
from ..power.result import Result, Trend, Vanishing
from ..statics.verdict import Verdict
from ..words.table import Words
from .latex_display import LINE, Line, display
from .latex_notation import Notation, name
from .latex_printer import Box, box, latex, plain
from .latex_quantity import decimal, measured


class ResultBlock(NamedTuple):
    """One result, ready for LaTeX: its heading, displays, remarks in sentences."""

    heading: str
    displays: tuple[str, ...]
    remarks: tuple[str, ...]
    derivatives: str


def result_block(result: Result, words: Words, style: Notation) -> ResultBlock:
    """Return everything the report says of one result."""
    return ResultBlock(
        heading(result, words),
        (*_main(result, words, style), *_where(result, words, style)),
        remarks(result, words, style),
        _derivatives(result, words, style),
    )


def heading(result: Result, words: Words) -> str:
    """Return what kind of thing was found."""
    match result.target:
        case LoadRatio():
            return words.force_ratio
        case LoadForm():
            return words.load
        case SpeedRatio():
            return words.speed_ratio
        case None:
            return ""
        case _:
            assert_never(result.target)


def asked(result: Result, style: Notation) -> str:
    """Return the result's own symbol; one without a name of its own is its ratio."""
    ratio = _ratio(result)
    if ratio is not None and "_over_" in result.name:
        return latex(ratio, style)
    return name(result.name, style)


def _ratio(result: Result) -> Formula | None:
    match result.target:
        case LoadRatio(above, below):
            return quotient(Symbol(above), Symbol(below))
        case SpeedRatio(above, below):
            return quotient(_speed(above), _speed(below))
        case _:
            return None


def _speed(speed: Speed) -> Formula:
    return Symbol(f"V_{speed.of}" if speed.kind == "point" else f"omega_{speed.of}")


def _left(result: Result, style: Notation) -> Box:
    """Return the left side, ``k = P/F`` for a ratio with a name of its own."""
    symbol, ratio = plain(asked(result, style)), _ratio(result)
    if ratio is None or "_over_" in result.name:
        return symbol
    below = box(ratio, style)
    return Box(f"{symbol.tex}={below.tex}", symbol.width + below.width + 1.2, tall=True)


def _main(result: Result, words: Words, style: Notation) -> tuple[str, ...]:
    left = _left(result, style)
    short = left.width + box(result.formula, style).width <= LINE
    if result.coefficients and not short:
        return _as_form(left, result.coefficients, words, style)
    return (display((Line(left, result.formula),), style, words.where, boxed=True),)


def _as_form(
    left: Box, coefficients: Mapping[str, Formula], words: Words, style: Notation
) -> tuple[str, ...]:
    """Return a long linear form with a name for the coefficient of every load."""
    named = {load: Symbol(f"c_{load}") for load in coefficients}
    form = total(product([(named[load], 1), (Symbol(load), 1)]) for load in coefficients)
    lines = tuple(Line(box(named[load], style), f) for load, f in coefficients.items())
    first = display((Line(left, form),), style, words.where, boxed=True)
    return first, words.where, display(lines, style, words.where)


def _where(result: Result, words: Words, style: Notation) -> tuple[str, ...]:
    if not result.where:
        return ()
    lines = tuple(
        Line(plain(name(d.name, style)), d.formula, d.name in style.angles) for d in result.where
    )
    return words.where, display(lines, style, words.where)


def _derivatives(result: Result, words: Words, style: Notation) -> str:
    symbol = asked(result, style)
    lines = tuple(
        Line(_partial(symbol, parameter, style), formula)
        for parameter, formula in (result.derivatives or {}).items()
        if formula != exact(0)
    )
    return display(lines, style, words.where) if lines else ""


def _partial(symbol: str, parameter: str, style: Notation) -> Box:
    whole = rf"\frac{{\partial {symbol}}}{{\partial {name(parameter, style)}}}"
    return Box(whole, 0.6 + plain(symbol).width, tall=True)


def remarks(result: Result, words: Words, style: Notation) -> tuple[str, ...]:
    """Return what follows from a result: limits, proportions, symmetries, trends."""
    symbol = f"${asked(result, style)}$"
    said = [_limit(words.zero, symbol, v, words, style) for v in result.zeros]
    said += [_limit(words.pole, symbol, v, words, style) for v in result.poles]
    said += _proportions(result, words, style)
    if result.independent:
        names = _symbols(result.independent, words, style)
        said.append(words.independent.format(result=symbol, names=names))
    for first, second in result.swaps:
        one, other = (f"${name(n, style)}$" for n in (first, second))
        said.append(words.swaps.format(result=symbol, first=one, second=other))
    return tuple(said + _trends(result, symbol, words, style))


def _limit(template: str, symbol: str, limit: Vanishing, words: Words, style: Notation) -> str:
    said = template.format(result=symbol, condition=f"${latex(limit.factor, style)}=0$")
    if limit.at:
        parameter, value = limit.at
        solved = latex(value, style, parameter in style.angles)
        said += ", " + words.when.format(condition=f"${name(parameter, style)}={solved}$")
    kind = words.centres[limit.kind]
    return f"{said} ({kind})." if kind else f"{said}."


def _proportions(result: Result, words: Words, style: Notation) -> list[str]:
    powers = {n: e for n, e in (result.proportional or {}).items() if e}
    if not powers:
        return []
    ratio = product((Symbol(n), e) for n, e in powers.items())
    return [rf"{words.proportional} ${asked(result, style)}\sim {latex(ratio, style)}$."]


def _symbols(names: Iterable[str], words: Words, style: Notation) -> str:
    return enumeration([f"${name(n, style)}$" for n in names], words)


def _trends(result: Result, symbol: str, words: Words, style: Notation) -> list[str]:
    groups: dict[Trend, list[str]] = {}
    for parameter, trend in (result.trends or {}).items():
        groups.setdefault(trend, []).append(parameter)
    return [
        words.trends[trend].format(result=symbol, names=_symbols(names, words, style))
        for trend, names in groups.items()
        if words.trends[trend]
    ]


# ------------------------------------------------------------ conditions, numbers, check

_SIGNS = {"<": "<", "<=": r"\leq ", ">": ">", ">=": r"\geq ", "=": "=", "!=": r"\neq "}


def conditions(requires: Iterable[Require], style: Notation) -> str:
    """Return the conditions of use, the links of a chain joined again."""
    chains: list[str] = []
    last: Formula | None = None
    for require in requires:
        sides = (require.left, require.right)
        angle = any(is_angle(side, style.angles) for side in sides)
        left, right = (latex(side, style, angle) for side in sides)
        tail = _SIGNS[require.operator] + right
        if chains and require.left == last:
            chains[-1] += tail
        else:
            chains.append(left + tail)
        last = require.right
    return ", ".join(f"${chain}$" for chain in chains)


def numbers(results: Iterable[Result], words: Words, style: Notation) -> tuple[str, ...]:
    """Return the results at the default pose."""
    return tuple(
        f"${asked(r, style)}={measured(r.default, r.dimension, words, style)}$"
        for r in results
        if r.default is not None and isfinite(r.default)
    )


def check(verdict: Verdict, words: Words, style: Notation) -> str:
    """Return the referee's line."""
    if not verdict.trials:
        return words.pending
    poses = {tuple(sorted(trial.values.items())) for trial in verdict.trials}
    template = words.agrees if verdict.agrees else words.disagrees
    return template.format(count=len(poses), error=f"${decimal(_rounded(verdict.worst), style)}$")


def _rounded(error: float) -> float:
    return float(f"{error:.1e}")
