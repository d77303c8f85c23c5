"""The graph of vectors: which points hang together, and the loops that two unknowns close.

Edges are vectors between points, links, guides, slots. Edges without an unknown join
points into clusters; an Assur group of two links is a cycle of edges that mention two
unknowns between them, and no more.
"""

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from itertools import combinations
from typing import NamedTuple

from ...algebra.angle import Angle
from ...algebra.product import Product, Sum
from ...formula.walk import symbols
from ...source import Span
from ..pose import Arm, Vector, evaluate_vector, reverse

Names = frozenset[str]


class Edge(NamedTuple):
    """A vector from one point to another, and the place in the text that gives it."""

    tail: str
    head: str
    arms: Vector
    span: Span

    def turned(self) -> "Edge":
        """Return the edge walked the other way."""
        return Edge(self.head, self.tail, reverse(self.arms), self.span)


Cycle = tuple[Edge, ...]
"""Edges each of which begins where the one before it ends, back to the first."""


def mentioned(vector: Vector) -> Names:
    """Return the symbols of a vector, in lengths and in angles."""
    return frozenset(n for arm in vector for n in (*_names(arm.length), *arm.angle.names))


def _names(length: Product) -> Iterator[str]:
    for factor in length.factors:
        if isinstance(factor, Sum):
            for term in factor.terms:
                yield from _names(term)
        else:
            yield from symbols(factor.formula())


def points_around(cycle: Cycle) -> tuple[str, ...]:
    """Return the points of a loop in order, each once: no origin, and none made up for a guide."""
    return tuple(dict.fromkeys(e.tail for e in cycle if e.tail and "_" not in e.tail))


def loop_name(cycle: Cycle) -> str:
    """Return a loop by its points: ``O1-A-B-O2``."""
    return "-".join(points_around(cycle))


def chained(points: Iterable[str]) -> str:
    """Return points as messages name them, each once: no origin, and none made up for a guide.

    >>> chained(["O", "B_0", "", "B", "A", "O"])
    'O-B-A'
    """
    return "-".join(dict.fromkeys(p for p in points if p and "_" not in p))


def known_span(cycle: Cycle, unknown: Names) -> tuple[str, str] | None:
    """Return the ends of the known side of a loop ("0" is the origin), None of several sides."""
    fixed = [unknown.isdisjoint(mentioned(e.arms)) for e in cycle]
    starts = [i for i, k in enumerate(fixed) if k and not fixed[i - 1]]
    if len(starts) != 1:
        return None
    first = last = starts[0]
    while fixed[(last + 1) % len(fixed)]:
        last = (last + 1) % len(fixed)
    return cycle[first].tail or "0", cycle[last].head or "0"


class VectorGraph:
    """Edges, and the unknowns that are still sought."""

    def __init__(self, edges: Iterable[Edge], sought: Iterable[str]) -> None:
        self.edges = list(edges)
        self.sought = set(sought)
        self._mentions = [mentioned(e.arms) for e in self.edges]

    def put(self, values: Mapping[str, Angle]) -> None:
        """Replace symbols in all directions by what they were found to be."""
        self.rewrite(lambda angle: angle.put(values))

    def rewrite(self, written: Callable[[Angle], Angle]) -> None:
        """Write every direction in another way."""

        def rewritten(edge: Edge) -> Edge:
            return edge._replace(arms=tuple(Arm(a.length, written(a.angle)) for a in edge.arms))

        self.edges = list(map(rewritten, self.edges))
        self._mentions = [mentioned(e.arms) for e in self.edges]

    def pairs(self, within: Collection[str] | None = None) -> Iterator[tuple[Names, Cycle]]:
        """Yield each cycle of one or two unknowns, the fewest first.

        ``within`` restricts it to the points of one body. After the unknowns of a cycle
        were found the caller asks anew.
        """
        loose = self._loose(within)
        clusters = self._clusters(within)
        for wanted in self._candidates(loose, clusters):
            if cycle := self._cycle(wanted, loose, clusters, within):
                yield wanted, cycle

    def _loose(self, within: Collection[str] | None) -> list[tuple[Edge, Names]]:
        """Return the edges that mention something sought, with what they do."""
        marked = ((e, m & self.sought) for e, m in zip(self.edges, self._mentions, strict=True))
        return [(e, m) for e, m in marked if m and _inside(e, within)]

    def _clusters(self, within: Collection[str] | None) -> dict[str, int]:
        """Return for each point the number of its cluster."""
        number: dict[str, int] = {}
        for start in dict.fromkeys(p for e in self.edges for p in (e.tail, e.head)):
            if start not in number:
                for point in self._reach(start, within):
                    number[point] = len(number) if point == start else number[start]
        return number

    def _reach(self, start: str, within: Collection[str] | None) -> Iterator[str]:
        ways = self._known_ways(within)
        seen, queue = {start}, deque([start])
        while queue:
            point = queue.popleft()
            yield point
            for edge in ways.get(point, ()):
                if edge.head not in seen:
                    seen.add(edge.head)
                    queue.append(edge.head)

    def _known_ways(self, within: Collection[str] | None) -> Mapping[str, list[Edge]]:
        ways: dict[str, list[Edge]] = {}
        for edge, names in zip(self.edges, self._mentions, strict=True):
            if self.sought.isdisjoint(names) and _inside(edge, within):
                ways.setdefault(edge.tail, []).append(edge)
                ways.setdefault(edge.head, []).append(edge.turned())
        return ways

    def _candidates(
        self, loose: list[tuple[Edge, Names]], clusters: Mapping[str, int]
    ) -> Iterator[Names]:
        """Yield sets of one unknown, then of two whose edges meet in a cluster."""
        small = [(e, m) for e, m in loose if len(m) <= 2]
        singles = {m for _, m in small if len(m) == 1}
        yield from sorted(singles, key=sorted)
        meeting: dict[int, set[Names]] = {}
        for edge, names in small:
            for point in (edge.tail, edge.head):
                meeting.setdefault(clusters[point], set()).add(names)
        found = {m for _, m in small if len(m) == 2}
        for groups in meeting.values():
            found |= {a | b for a, b in combinations(groups, 2) if len(a | b) == 2}
        yield from sorted(found, key=sorted)

    def _cycle(
        self,
        wanted: Names,
        loose: list[tuple[Edge, Names]],
        clusters: Mapping[str, int],
        within: Collection[str] | None,
    ) -> Cycle | None:
        """Return a cycle whose unknowns are just those wanted."""
        forest: list[Edge] = []
        for edge, names in loose:
            if not names <= wanted:
                continue
            path = _path(edge.head, edge.tail, forest, clusters)
            if path is not None:
                cycle = self._joined((edge, *path), within)
                if frozenset().union(*(mentioned(e.arms) for e in cycle)) & self.sought == wanted:
                    return cycle
            else:
                forest.append(edge)
        return None

    def _joined(self, steps: tuple[Edge, ...], within: Collection[str] | None) -> Cycle:
        """Fill the gaps between the edges of a cycle of clusters with known vectors."""
        ways = self._known_ways(within)
        cycle: list[Edge] = []
        for edge, following in zip(steps, (*steps[1:], steps[0]), strict=True):
            cycle += [edge, *_shortest(edge.head, following.tail, ways)]
        return tuple(cycle)

    def fundamental(self) -> list[Cycle]:
        """Return independent cycles through edges with unknowns, small ones first."""
        loose = sorted(self._loose(None), key=lambda em: len(em[1]))
        clusters, forest, found = self._clusters(None), list[Edge](), list[Cycle]()
        for edge, _ in loose:
            path = _path(edge.head, edge.tail, forest, clusters)
            if path is None:
                forest.append(edge)
            else:
                found.append(self._joined((edge, *path), None))
        return found

    def places(self, start: str, values: Mapping[str, float]) -> dict[str, tuple[float, float]]:
        """Return where the points are, seen from one, as far as values let them be placed."""
        ways: dict[str, list[Edge]] = {}
        for edge, names in zip(self.edges, self._mentions, strict=True):
            if names <= values.keys():
                ways.setdefault(edge.tail, []).append(edge)
                ways.setdefault(edge.head, []).append(edge.turned())
        found, queue = {start: (0.0, 0.0)}, deque([start])
        while queue:
            point = queue.popleft()
            x, y = found[point]
            for edge in ways.get(point, ()):
                if edge.head not in found:
                    dx, dy = evaluate_vector(edge.arms, values)
                    found[edge.head] = (x + dx, y + dy)
                    queue.append(edge.head)
        return found


def _inside(edge: Edge, within: Collection[str] | None) -> bool:
    return within is None or (edge.tail in within and edge.head in within)


def _path(
    start: str, goal: str, forest: Iterable[Edge], clusters: Mapping[str, int]
) -> tuple[Edge, ...] | None:
    """Return the edges of a forest of clusters that lead from one point's to another's."""
    ways: dict[int, list[Edge]] = {}
    for edge in forest:
        ways.setdefault(clusters[edge.tail], []).append(edge)
        ways.setdefault(clusters[edge.head], []).append(edge.turned())
    came: dict[int, Edge | None] = {clusters[start]: None}
    queue = deque([clusters[start]])
    while queue and clusters[goal] not in came:
        for edge in ways.get(queue.popleft(), ()):
            if clusters[edge.head] not in came:
                came[clusters[edge.head]] = edge
                queue.append(clusters[edge.head])
    if clusters[goal] not in came:
        return None
    path: list[Edge] = []
    at = came[clusters[goal]]
    while at is not None:
        path.append(at)
        at = came[clusters[at.tail]]
    return tuple(reversed(path))


def _shortest(start: str, goal: str, ways: Mapping[str, list[Edge]]) -> list[Edge]:
    came: dict[str, Edge | None] = {start: None}
    queue = deque([start])
    while queue and goal not in came:
        for edge in ways.get(queue.popleft(), ()):
            if edge.head not in came:
                came[edge.head] = edge
                queue.append(edge.head)
    path: list[Edge] = []
    at = came[goal]
    while at is not None:
        path.append(at)
        at = came[at.tail]
    return path[::-1]
