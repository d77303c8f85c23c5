"""Where the resultant of a load spread over a link acts: a point of that link.

Everything behind the model knows forces at points alone.
"""

from collections.abc import Sequence
from itertools import count

from ...base.frozen import replace
from ...formula.tree import negative, product, total
from ..entries import drawn_places, ray_through, unit_of_drawing, vector_between
from ..mechanism import AlongLine, Arrow, Drawn, Force, Load, Mechanism, Spread
from ..names.scope import NameScope

MIDDLE = "M"
"""The letter of a point at which the resultant of a spread load acts."""


def with_points_of_resultants(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with a point on its link for the resultant of each spread load."""
    for load in mechanism.loads:
        if isinstance(load, Force) and load.spread:
            mechanism = _with_point(mechanism, load)
    return mechanism


def _with_point(mechanism: Mechanism, load: Force) -> Mechanism:
    """Add the point at which a spread load acts to its link, and the vector to it."""
    assert load.spread is not None
    link = load.spread.link
    return replace(
        _placed(mechanism, load, load.spread),
        links=tuple(
            replace(k, points=(*k.points, load.point)) if k.name == link else k
            for k in mechanism.links
        ),
        spans={**mechanism.spans, load.point: load.span},
    )


def _placed(mechanism: Mechanism, load: Force, spread: Spread) -> Mechanism:
    """Return the mechanism with a place for a spread load: between drawn ends, or by a vector.

    Ends on a ray from a third point have the place on that ray.
    """
    tail, head, span = spread.tail, spread.head, load.span
    places = drawn_places(mechanism)
    if places.keys() >= {tail, head}:
        x, y = (
            total([start, product([(spread.part, 1), (total([end, negative(start)]), 1)])])
            for start, end in zip(places[tail], places[head], strict=True)
        )
        drawn = Drawn(load.point, x, y, 0.0, unit_of_drawing(mechanism), span)
        return replace(mechanism, drawn=(*mechanism.drawn, drawn))
    arrow = Arrow(tail, load.point, spread.reach, AlongLine(tail, head, 0, span), span)
    ray = ray_through((tail, head), mechanism.geometry)
    if ray and vector_between((tail, head), mechanism.geometry) is None:
        way = total([ray.far, negative(ray.near)])
        reach = total([ray.near, product([(spread.part, 1), (way, 1)])])
        arrow = Arrow(ray.start, load.point, reach, ray.along, span)
    return replace(mechanism, geometry=(*mechanism.geometry, arrow))


def free_point(loads: Sequence[Load], scope: NameScope) -> str:
    """Return a name for a point that no other has: M, M1, M2 …"""
    taken = {*scope.points.places, *(k.point for k in loads if isinstance(k, Force))}
    names = (f"{MIDDLE}{n or ''}" for n in count())
    return next(name for name in names if name not in taken)
