"""The order of solution: a matching of relations to unknowns, and its blocks.

The strongly connected components of the matched graph are the smallest sets of
relations that must be solved together (Dulmage and Mendelsohn 1958; Tarjan 1972).
These few lines stand for a graph library whose import takes longer than a compile.

In this order ``kinematics.planning`` finds speeds and ``pose.loops.groups`` closes what dyads leave
over; ``kinematics.locked`` takes the smallest block that holds itself fast.
"""

from collections.abc import Iterator, Mapping, Sequence

Columns = Sequence[frozenset[int]]
"""For each relation, the unknowns (drives apart) that it mentions."""


def match(columns: Columns) -> dict[int, int]:
    """Return a matching ``unknown → relation`` of greatest size, by augmenting paths."""
    matched: dict[int, int] = {}
    partner: dict[int, int] = {}
    for start in sorted(range(len(columns)), key=lambda r: len(columns[r])):
        _augment(start, columns, matched, partner)
    return matched


def _augment(
    start: int, columns: Columns, matched: dict[int, int], partner: dict[int, int]
) -> None:
    """Find an unmatched unknown from a relation along alternating edges; flip the path."""
    came: dict[int, int] = {}
    queue = [start]
    for relation in queue:
        for unknown in sorted(columns[relation]):
            if unknown in came:
                continue
            came[unknown] = relation
            if unknown not in matched:
                _flip(unknown, came, matched, partner)
                return
            queue.append(matched[unknown])


def _flip(
    unknown: int, came: Mapping[int, int], matched: dict[int, int], partner: dict[int, int]
) -> None:
    at: int | None = unknown
    while at is not None:
        relation = came[at]
        before = partner.get(relation)
        matched[at], partner[relation] = relation, at
        at = before


def blocks(columns: Columns, matched: Mapping[int, int]) -> list[list[int]]:
    """Return the unknowns in groups to be solved together, in order of solution.

    Tarjan's algorithm with an explicit stack: it yields a component after all those
    that it depends on, which is the order wanted.
    """
    search = _Search({u: sorted(columns[r] - {u}) for u, r in matched.items()})
    for root in sorted(search.needs):
        if root not in search.index:
            search.from_root(root)
    return search.found


class _Search:
    """A depth-first search: ``index`` counts nodes as they are met, ``low`` is how far back
    each of them leads, ``path`` holds those that are in no component yet.
    """

    def __init__(self, needs: Mapping[int, Sequence[int]]) -> None:
        self.needs = needs
        self.index: dict[int, int] = {}
        self.found: list[list[int]] = []
        self._low: dict[int, int] = {}
        self._path: list[int] = []
        self._done: set[int] = set()

    def from_root(self, root: int) -> None:
        """Find the components that a node leads to."""
        work = [self._met(root)]
        while work:
            node, others = work[-1]
            following = self._next(node, others)
            if following is not None:
                work.append(self._met(following))
                continue
            work.pop()
            if work:
                before, _ = work[-1]
                self._low[before] = min(self._low[before], self._low[node])
            if self._low[node] == self.index[node]:
                self._take(node)

    def _met(self, node: int) -> tuple[int, Iterator[int]]:
        self.index[node] = self._low[node] = len(self.index)
        self._path.append(node)
        return node, iter(self.needs[node])

    def _next(self, node: int, others: Iterator[int]) -> int | None:
        """Return the next node that has not been met, None where there is none."""
        for other in others:
            if other not in self.index:
                return other
            if other not in self._done:
                self._low[node] = min(self._low[node], self.index[other])
        return None

    def _take(self, node: int) -> None:
        """Take a component off the path: all from a node on."""
        start = len(self._path) - 1
        while self._path[start] != node:
            start -= 1
        self.found.append(sorted(self._path[start:]))
        del self._path[start:]
        self._done.update(self.found[-1])
