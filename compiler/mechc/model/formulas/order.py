"""An order in which each name follows those it needs, and the circles where there is none."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

CIRCLES = 8
"""Circles found in one run; more are a broken generator's work."""

Needs = Mapping[str, set[str]]


def ordered(needs: Needs) -> tuple[list[str], list[list[str]]]:
    """Return the names in order, without those in circles, and the circles as ``a b a``.

    >>> ordered({"a": {"b"}, "b": set(), "c": {"d"}, "d": {"c"}})[0]
    ['b', 'a']
    >>> ordered({"a": {"a"}})
    ([], [['a', 'a']])
    """
    circles: list[list[str]] = []
    while len(circles) < CIRCLES:
        try:
            return list(_sorter(needs).static_order()), circles
        except CycleError as error:
            circle: list[str] = error.args[1]
            # The sorter gives each name before the one that needs it.
            circles.append(circle[::-1])
            gone = set(circle)
            needs = {name: wanted - gone for name, wanted in needs.items() if name not in gone}
    return list(_free(needs)), circles


def _sorter(needs: Needs) -> TopologicalSorter[str]:
    """Return a sorter that is given the names in an order that no hash decides."""
    return TopologicalSorter({name: sorted(wanted) for name, wanted in needs.items()})


def _free(needs: Needs) -> Iterator[str]:
    """Yield the names that no circle blocks."""
    sorter = _sorter(needs)
    with suppress(CycleError):
        sorter.prepare()
    while ready := sorter.get_ready():
        yield from ready
        sorter.done(*ready)
