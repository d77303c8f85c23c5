"""The graph of vectors: which points are connected, and the loops that two unknowns close.

Edges are vectors between points, links, guides, slots. Edges without an unknown join
points into clusters; an Assur group of two links is a cycle of edges that mention two
unknowns between them, and no more.
"""

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from itertools import combinations

from ..algebra.angle import Angle
from ..algebra.product import Product, Sum
from ..base.named import NamedTuple
from ..formula.walk import symbols
from ..source import Span
from .pose import Arm, Vector, evaluate_vector, reverse

NameSet = frozenset[str]


class Edge(NamedTuple):
    """A vector from one point to another, and the place in the text that gives it."""

    tail: str
    head: str
    arms: Vector
    span: Span

    def turned(self) -> "Edge":
        """Return the edge walked the other way."""
        return Edge(self.head, self.tail, reverse(self.arms), self.span)


EdgesByName = Mapping[str, list[Edge]]
"""The edges that lead away from each point, walked either way."""

Cycle = tuple[Edge, ...]
"""Edges each of which begins where the one before it ends, back to the first."""


def mentioned(vector: Vector) -> NameSet:
    """Return the symbols of a vector, in lengths and in angles."""
    return frozenset(n for arm in vector for n in (*names_in(arm.length), *arm.angle.names))


def names_in(value: Product) -> Iterator[str]:
    """Yield the symbols of a product, without writing it out as a formula."""
    for factor in value.factors:
        if isinstance(factor, Sum):
            for term in factor.terms:
                yield from names_in(term)
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


def known_span(cycle: Cycle, unknown: NameSet) -> tuple[str, str] | None:
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
        self._turned: list[Edge | None] = [None] * len(self.edges)
        self._open: dict[NameSet, EdgesByName] = {}

    def put(self, values: Mapping[str, Angle]) -> None:
        """Replace symbols in all directions by what they were found to be."""
        self._rewrite(lambda angle: angle.put(values), lambda names: not names.isdisjoint(values))

    def rewrite(self, written: Callable[[Angle], Angle]) -> None:
        """Write every direction in another way."""
        self._rewrite(written, lambda names: True)

    def _rewrite(
        self, written: Callable[[Angle], Angle], is_touched: Callable[[NameSet], bool]
    ) -> None:
        """Write the directions of the edges that mention certain names in another way."""
        self._open.clear()
        for i, edge in enumerate(self.edges):
            if is_touched(self._mentions[i]):
                arms = tuple(Arm(a.length, written(a.angle)) for a in edge.arms)
                self.edges[i], self._mentions[i] = edge._replace(arms=arms), mentioned(arms)
                self._turned[i] = None

    def _ways(self, is_way: Callable[[Edge, NameSet], bool]) -> EdgesByName:
        """Return the ways along edges, which are chosen by what they mention, too."""
        ways: dict[str, list[Edge]] = {}
        for i, edge in enumerate(self.edges):
            if is_way(edge, self._mentions[i]):
                turned = self._turned[i] = self._turned[i] or edge.turned()
                ways.setdefault(edge.tail, []).append(edge)
                ways.setdefault(edge.head, []).append(turned)
        return ways

    def pairs(self, within: Collection[str] | None = None) -> Iterator[tuple[NameSet, Cycle]]:
        """Yield each cycle of one or two unknowns, the fewest first.

        ``within`` restricts it to the points of one body. After the unknowns of a cycle
        were found the caller asks anew.
        """
        loose, ways = self._loose(within), self._known_ways(within)
        clusters, by_names = self._clusters(ways), _by_names(loose)
        for wanted in self._candidates(loose, clusters):
            edges = _mentioning(wanted, by_names)
            if _closes(edges, clusters) and (cycle := self._cycle(wanted, edges, clusters, ways)):
                yield wanted, cycle

    def _loose(self, within: Collection[str] | None) -> list[tuple[Edge, NameSet]]:
        """Return the edges that mention something sought, with what they do."""
        marked = ((e, m & self.sought) for e, m in zip(self.edges, self._mentions, strict=True))
        return [(e, m) for e, m in marked if m and _inside(e, within)]

    def _clusters(self, ways: EdgesByName) -> dict[str, int]:
        """Return for each point the number of its cluster."""
        number: dict[str, int] = {}
        for start in dict.fromkeys(p for e in self.edges for p in (e.tail, e.head)):
            if start not in number:
                for point in _reach(start, ways):
                    number[point] = len(number) if point == start else number[start]
        return number

    def _known_ways(self, within: Collection[str] | None) -> EdgesByName:
        return self._ways(lambda e, names: self.sought.isdisjoint(names) and _inside(e, within))

    def _candidates(
        self, loose: list[tuple[Edge, NameSet]], clusters: Mapping[str, int]
    ) -> Iterator[NameSet]:
        """Yield sets of one unknown, then of two whose edges meet in a cluster.

        Those of two in one cycle meet in two clusters, so that one of all, the greatest, need
        not be looked at: the frame, where the vectors of all loops meet.
        """
        small = [(e, m) for e, m in loose if len(m) <= 2]
        singles = {m for _, m in small if len(m) == 1}
        yield from sorted(singles, key=sorted)
        meeting: dict[int, set[NameSet]] = {}
        for edge, names in small:
            for point in (edge.tail, edge.head):
                meeting.setdefault(clusters[point], set()).add(names)
        found = {m for _, m in small if len(m) == 2}
        for groups in sorted(meeting.values(), key=len)[:-1]:
            found |= {a | b for a, b in combinations(groups, 2) if len(a | b) == 2}
        yield from sorted(found, key=sorted)

    def _cycle(
        self, wanted: NameSet, loose: Iterable[Edge], clusters: Mapping[str, int], ways: EdgesByName
    ) -> Cycle | None:
        """Return a cycle whose unknowns are just those wanted, of edges that mention no others."""
        forest: list[Edge] = []
        for edge in loose:
            path = _path(edge.head, edge.tail, forest, clusters)
            if path is not None:
                cycle = _joined((edge, *path), ways)
                if frozenset().union(*(mentioned(e.arms) for e in cycle)) & self.sought == wanted:
                    return cycle
            else:
                forest.append(edge)
        return None

    def fundamental(self) -> list[Cycle]:
        """Return independent cycles through edges with unknowns, small ones first."""
        loose = sorted(self._loose(None), key=lambda em: len(em[1]))
        ways, forest, found = self._known_ways(None), list[Edge](), list[Cycle]()
        clusters = self._clusters(ways)
        for edge, _ in loose:
            path = _path(edge.head, edge.tail, forest, clusters)
            if path is None:
                forest.append(edge)
            else:
                found.append(_joined((edge, *path), ways))
        return found

    def places(
        self, start: str, values: Mapping[str, float], wanted: Collection[str] = ()
    ) -> dict[str, tuple[float, float]]:
        """Return where the points are, seen from one, as far as values let them be placed.

        Where some are ``wanted``, no others are looked for once these are found.
        """
        ways, found, queue = self._open_ways(values), {start: (0.0, 0.0)}, deque([start])
        while queue and not (wanted and all(point in found for point in wanted)):
            point = queue.popleft()
            x, y = found[point]
            for edge in ways.get(point, ()):
                if edge.head not in found:
                    dx, dy = evaluate_vector(edge.arms, values)
                    found[edge.head] = (x + dx, y + dy)
                    queue.append(edge.head)
        return found

    def _open_ways(self, values: Mapping[str, float]) -> EdgesByName:
        """Return the ways along edges that have values."""
        names = frozenset(values)
        if names not in self._open:
            self._open[names] = self._ways(lambda _, mentions: mentions <= names)
        return self._open[names]


def _reach(start: str, ways: EdgesByName) -> Iterator[str]:
    """Yield the points to which ways lead from one, itself the first."""
    seen, queue = {start}, deque([start])
    while queue:
        point = queue.popleft()
        yield point
        for edge in ways.get(point, ()):
            if edge.head not in seen:
                seen.add(edge.head)
                queue.append(edge.head)


_ByNames = Mapping[NameSet, list[tuple[int, Edge]]]
"""Edges, each with its place among all, by what they mention that is sought."""


def _by_names(loose: Iterable[tuple[Edge, NameSet]]) -> _ByNames:
    found: dict[NameSet, list[tuple[int, Edge]]] = {}
    for i, (edge, names) in enumerate(loose):
        found.setdefault(names, []).append((i, edge))
    return found


def _mentioning(wanted: NameSet, by_names: _ByNames) -> list[Edge]:
    """Return the edges that mention one or two names and no others, in their order."""
    parts = {wanted, *(frozenset((name,)) for name in wanted)}
    places = dict(place for part in parts for place in by_names.get(part, ()))
    return [places[i] for i in sorted(places)]


def _closes(edges: Iterable[Edge], clusters: Mapping[str, int]) -> bool:
    """Return whether edges between clusters make a cycle."""
    joined: dict[int, int] = {}
    for edge in edges:
        first, second = clusters[edge.tail], clusters[edge.head]
        while first in joined:
            first = joined[first]
        while second in joined:
            second = joined[second]
        if first == second:
            return True
        joined[first] = second
    return False


def _joined(steps: tuple[Edge, ...], ways: EdgesByName) -> Cycle:
    """Fill the gaps between the edges of a cycle of clusters with known vectors."""
    cycle: list[Edge] = []
    for edge, following in zip(steps, (*steps[1:], steps[0]), strict=True):
        cycle += [edge, *_shortest(edge.head, following.tail, ways)]
    return tuple(cycle)


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


def _shortest(start: str, goal: str, ways: EdgesByName) -> list[Edge]:
    """Return the fewest edges that lead from one point to another."""
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
