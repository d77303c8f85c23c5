"""Conditions on one name, and whether any value meets all of them."""

import math
from collections.abc import Mapping, Sequence

from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula, Symbol
from ...formula.walk import symbols

_TURNED = {"less": "more", "at_most": "at_least", "more": "less", "at_least": "at_most"}
"""A comparison read from its right side."""

Range = tuple[float, float]


def never_met(links: Sequence[Formula], ranges: Mapping[str, Range]) -> str:
    """Return the name of which no value in its range meets all comparisons with numbers, or ''.

    Comparisons of other things are not looked at.

    >>> from ...formula.tree import number
    >>> v = Symbol("v")
    >>> never_met([Call("more", (v, number(5)))], {"v": (0, 2)})
    'v'
    >>> never_met([Call("more", (v, number(5))), Call("less", (v, number(9)))], {})
    ''
    >>> never_met([Call("more", (v, number(5))), Call("at_most", (v, number(5)))], {})
    'v'
    """
    within: dict[str, tuple[float, float, bool]] = {}
    for name, comparison, value in filter(None, map(_about_a_name, links)):
        low, high, is_open = within.get(name, (*ranges.get(name, (-math.inf, math.inf)), False))
        if comparison in ("more", "at_least", "same") and value >= low:
            low, is_open = value, is_open or comparison == "more"
        if comparison in ("less", "at_most", "same") and value <= high:
            high, is_open = value, is_open or comparison == "less"
        is_empty = low > high or (low == high and is_open)
        within[name] = low, high, is_open
        if is_empty or not _meets(low, high, comparison, value):
            return name
    return ""


def _meets(low: float, high: float, comparison: str, value: float) -> bool:
    """Return whether some value between two meets a comparison."""
    match comparison:
        case "more":
            return high > value
        case "at_least":
            return high >= value
        case "less":
            return low < value
        case "at_most":
            return low <= value
        case "same":
            return low <= value <= high
    return True


def _about_a_name(link: Formula) -> tuple[str, str, float] | None:
    """Return a comparison of a name with a number: the name, the comparison, the number."""
    match link:
        case Call(comparison, (Symbol(name), right)) if not symbols(right):
            return name, comparison, evaluate(right, {})
        case Call(comparison, (left, Symbol(name))) if not symbols(left):
            return name, _TURNED.get(comparison, comparison), evaluate(left, {})
    return None
