"""Choices, tables and lists of sizes in formulas: calls whose value depends on conditions.

``choose(c1, v1, c2, v2, …, otherwise)`` is the value behind the first condition that holds; it
has none (NaN) where none holds and nothing is said otherwise. A condition is a call that is 1
where it holds and else 0, and NaN where a side of it is. ``interpolate(x, x1, y1, x2, y2, …)``
lies between two rows of a table in proportion, ``row(x, x1, y1, …)`` is the value of the row at x
(to :data:`SAME_ROW`), ``next(x, s1, s2, …)`` the smallest size that is no less than x; they have no
value elsewhere. ``met(x, x1, x2, …)`` is x at a row, else that of the rows which lies nearest.
``sense(x, size)`` is the sign of x, and 0 where nothing but rounding is left of it against
``size``. Machines know the first only (:func:`spelled_out`).
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TypeGuard, TypeVar

from .tree import ZERO, Call, Formula, is_call, negative, number, product, quotient, total

T = TypeVar("T")

SAME_ROW = Fraction(1, 10**9)
"""How far from a row, in parts of it, a value may lie that is meant: half of 63 mm, 31.5 mm."""

SIGNS: Mapping[str, str] = {
    "less": "<",
    "at_most": "<=",
    "more": ">",
    "at_least": ">=",
    "same": "=",
    "differs": "!=",
}
"""Conditions by the sign between their sides."""

SENSELESS = 2.0**-40
"""What is below this part of its size, some 1e-12, is a zero that was rounded: it has no sense.

A power of two that no user writes, so that code in single precision finds it (``emit.c.real``).
"""

EQUAL = 2.0**-30
"""By what part of themselves, some 1e-9, two sides may differ that are equal but for rounding.

A power of two for the same reason; where both are near 0 they may differ by :data:`SENSELESS`.
"""

CONDITIONS: Mapping[str, str] = {sign: name for name, sign in SIGNS.items()}

LOOKED_UP = frozenset({"choose", "interpolate", "row", "next"})
"""Functions that have their tables, or their cases, for arguments."""

IN_WORDS = LOOKED_UP | {*SIGNS, "both", "count", "met"}
"""Functions that are written in words and signs, ``a when x > b else c``, and not as calls."""


def equal_within(left: Formula, right: Formula) -> tuple[Formula, Formula]:
    """Return by how much two sides differ, and how much they may where they are to be equal."""
    gap = Call("abs", (total([left, negative(right)]),))
    sizes = total([Call("abs", (left,)), Call("abs", (right,))])
    part = product([(number(Fraction(EQUAL)), 1), (sizes, 1)])
    return gap, total([part, number(Fraction(SENSELESS))])


def is_choice(formula: Formula) -> TypeGuard[Call]:
    """Return whether a formula chooses between values."""
    return is_call(formula, "choose")


def is_looked_up(formula: Formula) -> bool:
    """Return whether a formula chooses, or takes a value from a table or a list."""
    return isinstance(formula, Call) and formula.function in LOOKED_UP


def chosen(parts: Sequence[T], value: Callable[[T], float]) -> T | None:
    """Return the part that ``choose`` chooses, so that no other need have a value."""
    for condition, part in zip(parts[::2], parts[1::2], strict=False):
        holds = value(condition)
        if math.isnan(holds):
            return None
        if holds:
            return part
    return parts[-1] if len(parts) % 2 else None


def is_sense(formula: Formula) -> bool:
    """Return whether a formula is the sense of a slip in the terms of simpler calls.

    >>> from .tree import Symbol
    >>> is_sense(spelled_out("sense", (Symbol("v"), Symbol("a")))), is_sense(Symbol("v"))
    (True, False)
    """
    match formula:
        case Call("choose", (Call("more"), Call("sign"), otherwise)):
            return otherwise == ZERO
        case _:
            return False


def spelled_out(function: str, arguments: tuple[Formula, ...]) -> Formula | None:
    """Return a call of this module in terms of simpler ones; None where it is simple.

    Those are conditions of two sides, products and sums, and choices of one or two values.
    """
    match function, arguments:
        case "interpolate", (x, *rows):
            return _between_rows(x, rows)
        case "met", (x, *rows):
            return _halved(x, [(limit, _at_row(x, row, x, row)) for limit, row in _about(rows)])
        case "row", (x, *rows):
            values = dict(zip(rows[::2], rows[1::2], strict=True))
            about = _about(rows[::2])
            return _halved(x, [(limit, _at_row(x, row, values[row])) for limit, row in about])
        case "next", (x, *sizes):
            found = _halved(x, [(size, size) for size in sizes])
            return Call("choose", (Call("at_most", (x, sizes[-1])), found))
        case "sense", (x, size):
            least = product([(number(Fraction(SENSELESS)), 1), (size, 1)])
            is_more = Call("more", (Call("abs", (x,)), least))
            return Call("choose", (is_more, Call("sign", (x,)), ZERO))
        case "both", _:
            return product((condition, 1) for condition in arguments)
        case "count", _:
            return total(arguments)
        case "choose", (condition, value, *rest) if len(rest) > 1:
            return Call("choose", (condition, value, Call("choose", tuple(rest))))
        case _:
            return None


def _between_rows(x: Formula, rows: Sequence[Formula]) -> Formula:
    """Return a table x₁, y₁, x₂, y₂ … as a choice of lines, without a value beyond its ends."""
    places, values = rows[::2], rows[1::2]
    lines: list[tuple[Formula, Formula]] = []
    for (low, start), (high, end) in pairwise(zip(places, values, strict=True)):
        slope = quotient(total([end, negative(start)]), total([high, negative(low)]))
        rise = product([(total([x, negative(low)]), 1), (slope, 1)])
        lines.append((high, total([start, rise])))
    inside = Call("both", (Call("at_most", (places[0], x)), Call("at_most", (x, places[-1]))))
    return Call("choose", (inside, _halved(x, lines)))


def _about(rows: Sequence[Formula]) -> Iterator[tuple[Formula, Formula]]:
    """Yield each row behind the limit up to which it is the nearest; the last has any."""
    for row, following in pairwise(rows):
        yield product([(total([row, following]), 1), (number(2), -1)]), row
    yield rows[-1], rows[-1]


def _at_row(x: Formula, row: Formula, *values: Formula) -> Formula:
    """Return the first value where x is a row, the second, if there is one, elsewhere."""
    away = Call("abs", (total([x, negative(row)]),))
    near = product([(number(SAME_ROW), 1), (Call("abs", (row,)), 1)])
    return Call("choose", (Call("at_most", (away, near)), *values))


def _halved(x: Formula, values: Sequence[tuple[Formula, Formula]]) -> Formula:
    """Return the value up to whose limit x is, by halves, so that long lists nest no deeper."""
    if len(values) == 1:
        return values[0][1]
    half = len(values) // 2
    below, above = _halved(x, values[:half]), _halved(x, values[half:])
    return Call("choose", (Call("at_most", (x, values[half - 1][0])), below, above))
