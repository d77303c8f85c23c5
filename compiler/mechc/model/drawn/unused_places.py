"""Drawn places that give nothing, and that are compared with nothing."""

from collections.abc import Iterator

from ..entries import points_of
from ..mechanism import Drawn, Geometry, Mechanism, Offset, Pivot


def without_effect(before: Mechanism, drawn: Mechanism) -> Iterator[Drawn]:
    """Yield the drawn points of which no vector was made, and that no placed point is tied to.

    ``before`` is the mechanism without the vectors that its drawing gives.
    """
    own = set(map(id, before.geometry))
    made = [entry for entry in drawn.geometry if id(entry) not in own]
    used = {point for entry in made for point in points_of(entry)} | _tied(drawn.geometry)
    yield from (each for each in before.drawn if each.point not in used)


def _tied(geometry: tuple[Geometry, ...]) -> set[str]:
    """Return the points to which vectors lead from the origin of coordinates."""
    found, left = {""}, list(geometry)
    while near := [entry for entry in left if not found.isdisjoint(points_of(entry))]:
        found.update(point for entry in near for point in points_of(entry))
        left = [entry for entry in left if entry not in near]
    return found


def unplaced_pivot(mechanism: Mechanism) -> str:
    """Return the first pivot that has no place, '' where all have one."""
    placed = {g.head for g in mechanism.geometry if isinstance(g, Offset) and not g.tail}
    pivots = (pivot.point for pivot in mechanism.each(Pivot))
    return next((point for point in pivots if point not in placed), "")
