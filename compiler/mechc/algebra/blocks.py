"""The order of solution: a matching of relations to unknowns, and its blocks.

The strongly connected components of the matched graph are the smallest sets of
relations that must be solved together (Dulmage and Mendelsohn 1958; Tarjan 1972).
These few lines stand for a graph library whose import takes longer than a compile.
"""

from collections.abc import Mapping, Sequence

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
    needs = {u: sorted(columns[r] - {u}) for u, r in matched.items()}
    index: dict[int, int] = {}
    low: dict[int, int] = {}
    path: list[int] = []
    done: set[int] = set()
    found: list[list[int]] = []
    for root in sorted(needs):
        if root in index:
            continue
        work = [(root, iter(needs[root]))]
        index[root] = low[root] = len(index)
        path.append(root)
        while work:
            node, others = work[-1]
            for other in others:
                if other not in index:
                    index[other] = low[other] = len(index)
                    path.append(other)
                    work.append((other, iter(needs[other])))
                    break
                if other not in done:
                    low[node] = min(low[node], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    found.append(_popped(path, node))
                    done.update(found[-1])
    return found


def _popped(path: list[int], node: int) -> list[int]:
    group: list[int] = []
    while not group or group[-1] != node:
        group.append(path.pop())
    return sorted(group)
