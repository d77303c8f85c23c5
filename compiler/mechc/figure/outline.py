"""How a body is drawn: as bars between its points, or as a plate with corners."""

from collections.abc import Iterable, Mapping
from itertools import pairwise

from ..model.mechanism import Arrow, Geometry, Link, Offset
from ..pose.places import Plane
from .tolerances import ON_ONE_LINE


def outline(names: Iterable[str], points: Mapping[str, Plane]) -> tuple[str, ...]:
    """Return the names at the corners of a body, counter-clockwise; two if it is straight.

    >>> points = {"A": Plane(0, 0), "B": Plane(2, 0), "C": Plane(1, 1), "D": Plane(1, 0)}
    >>> outline("ABCD", points), outline("ADB", points)
    (('A', 'B', 'C'), ('A', 'B'))
    """
    ordered = sorted(names, key=lambda name: points[name])
    lower, upper = _chain(ordered, points), _chain(ordered[::-1], points)
    return (*lower[:-1], *upper[:-1])


def _chain(names: Iterable[str], points: Mapping[str, Plane]) -> list[str]:
    """Return the corners on the right of the way through points that are in order."""
    chain: list[str] = []
    for name in names:
        while len(chain) > 1 and not _turns_left(*(points[n] for n in (*chain[-2:], name))):
            chain.pop()
        chain.append(name)
    return chain


def _turns_left(a: Plane, b: Plane, c: Plane) -> bool:
    first, second = b.minus(a), c.minus(b)
    across = first.turned().dot(second)
    return across > ON_ONE_LINE * (first.dot(first) + second.dot(second))


def rods(link: Link, geometry: Iterable[Geometry]) -> tuple[tuple[str, str], ...]:
    """Return between which points of a link bars are drawn: its vectors, if they join it all.

    Otherwise they go from point to point as the link is written.
    """
    pairs = {
        frozenset((g.tail, g.head)): (g.tail, g.head)
        for g in geometry
        if isinstance(g, Arrow | Offset) and {g.tail, g.head} <= set(link.points)
    }
    bars = tuple(pairs.values())
    return bars if _joined(bars, link.points) else tuple(pairwise(link.points))


def _joined(bars: Iterable[tuple[str, str]], points: Iterable[str]) -> bool:
    group = {point: {point} for point in points}
    for first, second in bars:
        both = group[first] | group[second]
        group |= dict.fromkeys(both, both)
    return len({frozenset(members) for members in group.values()}) == 1
