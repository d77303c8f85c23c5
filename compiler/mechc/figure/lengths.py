"""The lengths that nothing gives: chosen so that all loops close, positive where it can be.

Closure is linear in them. Among all choices that close the loops the one is wanted in
which every length is as near to a usual one as can be, and none is turned round.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..base.named import NamedTuple
from .linear_vectors import DrawnVector, Linear
from .tolerances import DEPENDENT, SAME_LENGTH

SHORTEST_ROD = 0.2
"""No rod is to be drawn shorter than this part of a usual length, where loops allow it."""

ROUNDS = 400
"""How often the choice goes from closed loops to positive lengths and back, at most."""

OpenLengths = dict[str, float]


class LengthEquation(NamedTuple):
    """Σ ``factors[name]`` · length = ``value``."""

    factors: Mapping[str, float]
    value: float

    def miss(self, lengths: Mapping[str, float]) -> float:
        """Return by how much lengths miss the equation."""
        return self.value - sum(f * lengths[name] for name, f in self.factors.items())


def choose(vectors: Sequence[DrawnVector], rods: Iterable[str], usual: float) -> OpenLengths:
    """Return all open lengths, in metres, near ``usual``, with which the vectors close.

    Those of ``rods`` come out positive if they can. A vector along a guide may have either sign.
    """
    rows = _independent(_equations(vectors))
    names = dict.fromkeys(name for one in vectors for name in one.vector.parts)
    lengths = {**dict.fromkeys(names, usual), **dict.fromkeys(rods, usual)}
    lengths = _closed(lengths, rows)
    for _ in range(ROUNDS):
        short = [name for name in rods if lengths[name] < SHORTEST_ROD * usual * (1 - SAME_LENGTH)]
        if not short:
            break
        lengths = _closed({**lengths, **dict.fromkeys(short, SHORTEST_ROD * usual)}, rows)
    return lengths


def _equations(vectors: Sequence[DrawnVector]) -> Iterator[LengthEquation]:
    """Yield the equations that close each loop, along x and y."""
    at = _laid_out(vectors)
    for tail, head, vector in vectors:
        gap = at[tail].plus(vector).plus(at[head], -1)
        yield LengthEquation({name: part.x for name, part in gap.parts.items()}, -gap.base.x)
        yield LengthEquation({name: part.y for name, part in gap.parts.items()}, -gap.base.y)


def _laid_out(vectors: Sequence[DrawnVector]) -> dict[str, Linear]:
    """Return where every point is, along the first vectors that lead there."""
    neighbours: dict[str, list[tuple[str, Linear]]] = {}
    for tail, head, vector in vectors:
        neighbours.setdefault(tail, []).append((head, vector))
        neighbours.setdefault(head, []).append((tail, Linear().plus(vector, -1)))
    at: dict[str, Linear] = {}
    for start in neighbours:
        at.setdefault(start, Linear())
        waiting = [start]
        while waiting:
            here = waiting.pop()
            for there, vector in neighbours[here]:
                if there not in at:
                    at[there] = at[here].plus(vector)
                    waiting.append(there)
    return at


def _independent(rows: Iterable[LengthEquation]) -> list[LengthEquation]:
    """Return the equations made orthogonal to one another and of unit size."""
    found: list[LengthEquation] = []
    for row in rows:
        if any(abs(factor) > DEPENDENT for factor in row.factors.values()):
            rest = _across(_across(row, found), found)
            size = math.hypot(*rest.factors.values())
            if size > DEPENDENT:
                factors = {n: f / size for n, f in rest.factors.items() if f}
                found.append(LengthEquation(factors, rest.value / size))
    return found


def _across(row: LengthEquation, others: Iterable[LengthEquation]) -> LengthEquation:
    """Return the component of an equation that is orthogonal to the others."""
    factors, value = dict(row.factors), row.value
    for other in others:
        shared = sum(f * factors.get(name, 0.0) for name, f in other.factors.items())
        if shared:
            for name, f in other.factors.items():
                factors[name] = factors.get(name, 0.0) - shared * f
            value -= shared * other.value
    return LengthEquation(factors, value)


def _closed(lengths: OpenLengths, rows: Iterable[LengthEquation]) -> OpenLengths:
    """Return the nearest lengths that close all loops."""
    found = dict(lengths)
    for row in rows:
        miss = row.miss(found)
        for name, factor in row.factors.items():
            found[name] += miss * factor
    return found
