"""The range of a part's parameter whose value a loop of the whole gives: a condition of use.

A loop gives an angle within half a turn either way. One that the part counts otherwise,
``in 170 deg .. 190 deg``, is held by its distance from the middle of the range, as a cosine.
"""

import math
from collections.abc import Iterator
from fractions import Fraction

from ...formula.evaluate import evaluate
from ...frozen import replace
from ...source import Span
from ...syntax import ast
from ...units import ANGLE
from ..mechanism import Interval, Parameter
from .framed import literal, negative, number, plus


def kept_range(statement: ast.Param, parameter: Parameter) -> Iterator[ast.Require]:
    """Yield the condition that a value found by a loop keeps to the range of a parameter."""
    if not parameter.range or not statement.low or not statement.high:
        return
    low, high = statement.low, statement.high
    name, place = (
        ast.Symbol(statement.name.text, statement.name.span),
        Span(low.span.start, high.span.end),
    )
    condition = ast.Require(place, (low, name, high), ("<=", "<="), remark=statement.label)
    if parameter.dimension != ANGLE or _in_half_turns(parameter.range):
        yield condition
    elif not _is_a_turn(parameter.range):
        middle, reach = _half(plus(high, low)), _half(plus(high, negative(low)))
        sides = _cosine(plus(name, negative(middle))), _cosine(reach)
        yield replace(condition, operands=sides, operators=(">=",))


def _in_half_turns(within: Interval) -> bool:
    return all(abs(evaluate(end, {})) < math.pi for end in within)


def _is_a_turn(within: Interval) -> bool:
    return evaluate(within.high, {}) - evaluate(within.low, {}) >= 2 * math.pi


def _half(value: ast.Expr) -> ast.Expr:
    """Return half a value: a number where it is one."""
    if known := literal(value):
        return number(known[0] / 2, known[1], value.span)
    return ast.Product(((1, value), (-1, number(Fraction(2), "", value.span))), value.span)


def _cosine(angle: ast.Expr) -> ast.Expr:
    return ast.Call("cos", (angle,), angle.span)
