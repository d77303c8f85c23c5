"""Which factors of a ratio vanish in one pose with others, along what moves.

Sines of angles that loops find may all be zero where the whole linkage lies on one line: each by
itself is a zero or a pole of the ratio, together they are none.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from ..formula.roots import spaced
from ..formula.tree import Formula
from ..model.values import Chain, Values
from .ranges import last

CELLS = 73
"""Cells in which changes of sign are looked for."""

BEYOND = 0.01
"""The part of a range by which it is looked at beyond its ends, where factors may vanish."""

TOGETHER = 1e-6
"""What a factor may be at a zero of another one that it vanishes with."""


def meeting(
    factors: Sequence[Formula],
    defined: Mapping[str, Formula],
    given: Values,
    name: str,
    ends: tuple[float, float],
) -> Iterator[tuple[int, int]]:
    """Yield the places of two factors that pass zero at one value of a parameter.

    ``defined`` are the names in them, by those ``given`` and by one another.

    >>> from ..formula.tree import Call, Symbol, number, product
    >>> t, twice = Symbol("t"), product([(number(2), 1), (Symbol("t"), 1)])
    >>> sines = [Call("sin", (t,)), Call("sin", (Symbol("u"),)), Call("cos", (t,))]
    >>> list(meeting(sines, {"u": twice}, {}, "t", (-1.0, 2.0)))
    [(0, 1)]
    """
    own = {_place(i): factor for i, factor in enumerate(factors)}
    code = Chain({**defined, **own}).completion(frozenset((*given, name)), 1)

    def at(x: float) -> list[float]:
        found = code.complete({**given, name: x})
        return [found.get(place, 1.0) for place in own]

    beyond = BEYOND * (ends[1] - ends[0])
    rows = [(x, at(x)) for x in spaced(ends[0] - beyond, ends[1] + beyond, CELLS)]
    for (a, before), (b, after) in pairwise(rows):
        passing = [i for i, (u, v) in enumerate(zip(before, after, strict=True)) if u * v < 0]
        for i in passing if len(passing) > 1 else ():
            here = at(last(lambda x, i=i, u=before[i]: at(x)[i] * u > 0, a, b))  # type: ignore
            yield from ((i, j) for j in passing if j > i and abs(here[j]) < TOGETHER)


def _place(number: int) -> str:
    """Return a name that no description has."""
    return f"={number}"
