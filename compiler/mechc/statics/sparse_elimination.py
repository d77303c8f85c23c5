"""Sparse linear systems, eliminated in an order of their own.

Rows are dictionaries from column to entry. Every row is first scaled to a largest entry
of 1, so that moments and forces weigh alike; the row with the fewest entries left goes
next, and in it the column with the fewest rows among the entries of at least a tenth of
the largest (Markowitz with threshold), which costs linear time on a chain of links.

A system may have more rows than it needs, and unknowns that nothing determines: the
reactions of a statically indeterminate linkage. Those are set to zero, and a solution
says of each unknown asked for whether it is determined.
"""

import heapq
import math
from collections.abc import Mapping, Sequence

from ..base.frozen import frozen
from ..base.named import NamedTuple
from .tolerances import DETERMINED, ELIMINATED, SAME_TERM

SparseRow = Mapping[int, float]

THRESHOLD = 0.1
"""A pivot is at least this part of the largest entry of its row."""


class RowAddition(NamedTuple):
    """One addition of the elimination: ``multiple`` of row ``source`` leaves row ``target``."""

    target: int
    source: int
    multiple: float


class PivotElement(NamedTuple):
    """The unknown ``column`` follows from ``row`` once the later pivots are known.

    It has the factor ``entry`` there; ``others`` are what is left of the row.
    """

    row: int
    column: int
    entry: float
    others: tuple[tuple[int, float], ...]


@frozen
class EliminatedSystem:
    """An eliminated system, ready for any right-hand side."""

    rows: tuple[SparseRow, ...]
    scales: tuple[float, ...]
    width: int
    steps: tuple[RowAddition, ...]
    pivots: tuple[PivotElement, ...]

    def solve(self, right: SparseRow) -> list[float]:
        """Return the unknowns for one right-hand side, refined once; undetermined ones are 0."""
        scaled = {i: v * self.scales[i] for i, v in right.items()}
        first = self._substitute(scaled)
        correction = self._substitute(dict(enumerate(self._residual(first, scaled))))
        return [x + d for x, d in zip(first, correction, strict=True)]

    def gap(self, unknowns: Sequence[float], right: SparseRow) -> float:
        """Return the largest residual of a row relative to its terms: 0 when consistent."""
        scaled = {i: v * self.scales[i] for i, v in right.items()}
        weights = self.weights(unknowns, right)
        heaviest = max(weights, default=0.0)
        residual = self._residual(unknowns, scaled)
        return max((abs(r) / heaviest for r in residual if heaviest), default=0.0)

    def weights(self, unknowns: Sequence[float], right: SparseRow) -> list[float]:
        """Return for each row a bound of the sum of its terms.

        Rows are scaled to a largest entry of 1, so that a term is at most as large as its unknown.
        """
        sizes = [abs(x) for x in unknowns]
        return [
            sum(sizes[column] for column in row) + abs(right.get(i, 0.0)) * self.scales[i]
            for i, row in enumerate(self.rows)
        ]

    def determined(self, column: int) -> bool:
        """Return whether an unknown stays the same whatever the free ones are."""
        pivotal = {p.column for p in self.pivots}
        drift = {j: 1.0 + 0.37 * math.sin(j + 1) for j in range(self.width) if j not in pivotal}
        if column in drift:
            return False
        shift = self._back({}, drift)
        return abs(shift[column]) <= DETERMINED * max(map(abs, shift), default=0.0)

    def adjoint(self, column: int) -> list[float]:
        """Return the weight with which each row's right-hand side enters an unknown."""
        wanted = {column: 1.0}
        weights = [0.0] * len(self.rows)
        for row, pivoted, pivot, others in self.pivots:
            weights[row] = share = wanted.get(pivoted, 0.0) / pivot
            if share:
                for j, entry in others:
                    wanted[j] = wanted.get(j, 0.0) - share * entry
        for target, source, multiple in reversed(self.steps):
            weights[source] -= multiple * weights[target]
        return weights

    def _residual(self, unknowns: Sequence[float], scaled: SparseRow) -> list[float]:
        return [
            math.fsum([scaled.get(i, 0.0), *[-a * unknowns[j] for j, a in row.items()]])
            for i, row in enumerate(self.rows)
        ]

    def _substitute(self, scaled: SparseRow) -> list[float]:
        right = dict(scaled)
        for target, source, multiple in self.steps:
            if source in right:
                right[target] = right.get(target, 0.0) - multiple * right[source]
        return self._back(right, {})

    def _back(self, right: SparseRow, free: SparseRow) -> list[float]:
        unknowns = [free.get(j, 0.0) for j in range(self.width)]
        for row, column, entry, others in reversed(self.pivots):
            rest = sum([a * unknowns[j] for j, a in others])
            unknowns[column] = (right.get(row, 0.0) - rest) / entry
        return unknowns


def factor(rows: Sequence[SparseRow], width: int, last: int | None = None) -> EliminatedSystem:
    """Eliminate a system of ``width`` unknowns; column ``last`` is a pivot only if nothing else is.

    >>> factors = factor([{0: 1.0, 1: 1.0}, {0: 1.0, 1: -1.0}, {0: 2.0, 1: 2.0}], 2)
    >>> factors.solve({0: 3.0, 1: 1.0, 2: 6.0})
    [2.0, 1.0]
    >>> factors.determined(0)
    True
    """
    scales = tuple(scale_of(row) for row in rows)
    scaled = tuple(
        {j: v * s for j, v in row.items() if v} for row, s in zip(rows, scales, strict=True)
    )
    elimination = _Elimination(scaled, width, last)
    elimination.run()
    return EliminatedSystem(
        scaled,
        scales,
        width,
        tuple(elimination.steps),
        tuple(elimination.pivots),
    )


def scale_of(row: SparseRow) -> float:
    """Return the power of two that brings the largest entry near 1: scaling rounds nothing."""
    largest = max(map(abs, row.values()), default=0.0)
    return math.ldexp(1.0, -math.frexp(largest)[1]) if largest else 1.0


class _Elimination:
    """The rows while they are being eliminated."""

    def __init__(self, rows: Sequence[SparseRow], width: int, last: int | None) -> None:
        self.left = {i: dict(row) for i, row in enumerate(rows)}
        self.columns: list[set[int]] = [set() for _ in range(width)]
        for i, row in self.left.items():
            for j in row:
                self.columns[j].add(i)
        self.size = [1.0] * len(rows)
        self.last = last
        self.queue = [(len(row), i) for i, row in self.left.items()]
        self.steps: list[RowAddition] = []
        self.pivots: list[PivotElement] = []

    def run(self) -> None:
        """Take row after row, shortest first, until all are pivots or empty."""
        heapq.heapify(self.queue)
        while self.queue:
            length, i = heapq.heappop(self.queue)
            if i not in self.left or len(self.left[i]) != length:
                continue
            self._drop_rounded_zeros(i)
            if self.left[i]:
                self._eliminate(i, self._choose(self.left[i]))
            else:
                del self.left[i]

    def _drop_rounded_zeros(self, i: int) -> None:
        row = self.left[i]
        for j in [j for j, v in row.items() if abs(v) <= ELIMINATED * self.size[i]]:
            del row[j]
            self.columns[j].discard(i)

    def _choose(self, row: SparseRow) -> int:
        enough = THRESHOLD * max(map(abs, row.values()))
        fit = [j for j, v in row.items() if abs(v) >= enough]
        return min(fit, key=lambda j: (j == self.last, len(self.columns[j]), j))

    def _eliminate(self, i: int, column: int) -> None:
        row = self.left.pop(i)
        for j in row:
            self.columns[j].discard(i)
        for target in sorted(self.columns[column]):
            self._subtract(target, i, row, column)
        self.columns[column].clear()
        others = tuple((j, v) for j, v in row.items() if j != column)
        self.pivots.append(PivotElement(i, column, row[column], others))

    def _subtract(self, target: int, source: int, row: SparseRow, column: int) -> None:
        """Subtract a multiple of a row, so that the target has no entry in a column; note it."""
        into = self.left[target]
        multiple = into.pop(column) / row[column]
        for j, v in row.items():
            if j == column:
                continue
            old, term = into.get(j, 0.0), multiple * v
            self.size[target] = max(self.size[target], abs(term))
            if abs(old - term) <= SAME_TERM * abs(old):
                into.pop(j, None)
                self.columns[j].discard(target)
            else:
                into[j] = old - term
                self.columns[j].add(target)
        self.steps.append(RowAddition(target, source, multiple))
        heapq.heappush(self.queue, (len(into), target))
