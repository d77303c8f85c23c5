"""Assur groups of higher class: loops that only close together, as systems of equations.

What dyads leave over is split into the smallest sets of loops that must be solved at once
(triads, double butterflies). The closures at the default pose are found by Newton's method
from many starts; the one that the user named becomes the start of the branch.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from ..algebra.blocks import blocks, match
from .state import State
from .web import Cycle, mentioned

STARTS = 400
"""Random starts from which closures are looked for."""

STEPS = 40
"""Newton steps after which a start is given up."""

CLOSED = 1e-13
"""A gap below this part of the largest arm is closed."""

SAME = 1e-6
"""Closures whose unknowns differ by less are one."""


class Block(NamedTuple):
    """Loops that close together: equations (a loop, 0 for x or 1 for y) and their unknowns."""

    loops: tuple[Cycle, ...]
    equations: tuple[tuple[int, int], ...]
    unknown: frozenset[str]

    @property
    def cycle(self) -> Cycle:
        """Return all edges of the loops."""
        return tuple(dict.fromkeys(e for loop in self.loops for e in loop))


def remaining_blocks(state: State) -> Iterator[Block]:
    """Yield the blocks of what is left, each after those that it rests on."""
    loops = state.web.fundamental()
    equations = [(i, part) for i in range(len(loops)) for part in (0, 1)]
    names = sorted({n for loop in loops for n in _unknown(loop, state)})
    number = {n: i for i, n in enumerate(names)}
    columns = [frozenset(number[n] for n in _unknown(loops[i], state)) for i, _ in equations]
    matched = match(columns)
    determined = _determined(columns, matched, len(names))
    kept = {u: r for u, r in matched.items() if u in determined}
    inner = [c & determined for c in columns]
    for group in blocks(inner, kept):
        chosen = [equations[kept[u]] for u in group]
        used = sorted({i for i, _ in chosen})
        rows = tuple((used.index(i), part) for i, part in chosen)
        unknown = frozenset(names[u] for u in group)
        yield Block(tuple(loops[i] for i in used), rows, unknown)


def _unknown(loop: Cycle, state: State) -> set[str]:
    return {n for e in loop for n in mentioned(e.arms)} & state.web.sought


def _determined(
    columns: Sequence[frozenset[int]], matched: Mapping[int, int], size: int
) -> frozenset[int]:
    """Return the unknowns that the equations fix: no path leads to them from a free one."""
    partner = {r: u for u, r in matched.items()}
    free = [u for u in range(size) if u not in matched]
    open_ = set(free)
    while free:
        unknown = free.pop()
        for row, column in enumerate(columns):
            if unknown in column and row in partner and partner[row] not in open_:
                open_.add(partner[row])
                free.append(partner[row])
    return frozenset(range(size)) - open_
