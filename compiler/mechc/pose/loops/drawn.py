"""What drawn places say of closures: how far each is from the drawing, and where to begin."""

import math
from collections.abc import Collection, Mapping, Sequence, Set
from itertools import combinations

from ...algebra.product import Product
from ..samples import Coordinates, Values, places_of
from ..tolerances import EQUALLY_NEAR
from ..vector_graph import Edge
from .groups import LoopGroup
from .state import LoopState


def nearest(
    poses: Sequence[Values],
    indices: Sequence[int],
    state: LoopState,
    within: Collection[str] | None,
) -> list[int]:
    """Return which of some closures is nearest to the drawing; none where several are.

    ``within`` are the points of a body that closes by itself, whose places are not known yet.
    """
    drawn = places_of(state.mechanism.drawn, state.base)
    if not drawn:
        return []
    if within is None:
        gaps = [_gap(poses[i], drawn, state) for i in indices]
    else:
        gaps = [_within(poses[i], drawn, state, within) for i in indices]
    size = max(math.dist(a, b) for a, b in combinations([*drawn.values(), (0.0, 0.0)], 2))
    slack = EQUALLY_NEAR * (size if within is None else size**2)
    order = sorted(range(len(indices)), key=lambda i: gaps[i])
    is_clear = len(order) > 1 and gaps[order[1]] - gaps[order[0]] > slack
    return [indices[order[0]]] if is_clear else []


def _gap(values: Values, drawn: Mapping[str, Coordinates], state: LoopState) -> float:
    """Return the way from the drawn places to those of a closure, of all points together."""
    places = state.graph.places("", values)
    return math.hypot(*(math.dist(places[p], at) for p, at in drawn.items() if p in places))


def _within(
    values: Values, drawn: Mapping[str, Coordinates], state: LoopState, points: Collection[str]
) -> float:
    """Return how much a body differs from the drawn one, by its triangles, which have a sense."""
    known = [p for p in points if p in drawn]
    places = state.graph.places(known[0], values) if known else {}
    triples = combinations([p for p in known if p in places], 3)
    return math.fsum(
        abs(_area([places[p] for p in triple]) - _area([drawn[p] for p in triple]))
        for triple in triples
    )


def _area(corners: Sequence[Coordinates]) -> float:
    (ax, ay), (bx, by), (cx, cy) = corners
    return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2


def start(block: LoopGroup, state: LoopState) -> Values:
    """Return the unknowns of a block as measured in the drawing, as far as it shows them."""
    if not state.mechanism.drawn:
        return {}
    places = {**places_of(state.mechanism.drawn, state.base), **state.graph.places("", state.base)}
    shown = [e for e in block.cycle if len(e.arms) == 1 and {e.tail, e.head} <= places.keys()]
    values = dict(state.base)
    for edge in shown:
        values |= _angle(edge, _between(places, edge), values)
    for edge in shown:
        values |= _length(edge, _between(places, edge), values, block.unknown)
    return {name: values[name] for name in block.unknown & values.keys()}


def _between(places: Mapping[str, Coordinates], edge: Edge) -> Coordinates:
    (ax, ay), (bx, by) = places[edge.tail], places[edge.head]
    return bx - ax, by - ay


def _angle(edge: Edge, drawn: Coordinates, values: Values) -> dict[str, float]:
    """Return the only angle of a drawn arm that has no value yet, as measured."""
    ((_, angle),) = edge.arms
    unknown = [(n, c) for n, c in angle.terms if n not in values]
    if len(unknown) != 1:
        return {}
    ((name, factor),) = unknown
    dx, dy = drawn
    at_zero = angle.evaluate({**values, name: 0.0})
    return {name: math.remainder(math.atan2(dy, dx) - at_zero, 2 * math.pi) / float(factor)}


def _length(edge: Edge, drawn: Coordinates, values: Values, unknown: Set[str]) -> dict[str, float]:
    """Return the unknown length of a drawn arm, as measured along its direction."""
    ((length, angle),) = edge.arms
    names = [n for n in unknown - values.keys() if length == Product.symbol(n)]
    if not names or not angle.names <= values.keys():
        return {}
    (dx, dy), turned = drawn, angle.evaluate(values)
    return {names[0]: dx * math.cos(turned) + dy * math.sin(turned)}
