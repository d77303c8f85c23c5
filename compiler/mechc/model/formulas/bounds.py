"""Conditions on one name, and whether any value meets all of them."""

import math
from collections.abc import Mapping, Sequence

from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula, Symbol
from ...formula.walk import symbols

_TURNED = {"less": "more", "at_most": "at_least", "more": "less", "at_least": "at_most"}
"""A comparison read from its right side."""

ValueRange = tuple[float, float]

OpenOrClosed = tuple[float, bool]
"""An end of an interval, the upper one with its sign turned, and whether it is left out.

Of two ends the stricter one is the greater.
"""


def never_met(links: Sequence[Formula], ranges: Mapping[str, ValueRange]) -> str:
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
    >>> never_met([Call(c, (v, number(n))) for c, n in (("more", 3), ("same", 5))], {})
    ''
    """
    ends: dict[str, tuple[OpenOrClosed, OpenOrClosed]] = {}
    for name, comparison, value in filter(None, map(_about_a_name, links)):
        first, last = ranges.get(name, (-math.inf, math.inf))
        low, high = ends.get(name, ((first, False), (-last, False)))
        if comparison in ("more", "at_least", "same"):
            low = max(low, (value, comparison == "more"))
        if comparison in ("less", "at_most", "same"):
            high = max(high, (-value, comparison == "less"))
        ends[name] = low, high
        width = -high[0] - low[0]
        if width < 0 or (width == 0 and (low[1] or high[1])):
            return name
    return ""


def _about_a_name(link: Formula) -> tuple[str, str, float] | None:
    """Return a comparison of a name with a number: the name, the comparison, the number."""
    match link:
        case Call(comparison, (Symbol(name), right)) if not symbols(right):
            return name, comparison, evaluate(right, {})
        case Call(comparison, (left, Symbol(name))) if not symbols(left):
            return name, _TURNED.get(comparison, comparison), evaluate(left, {})
    return None
