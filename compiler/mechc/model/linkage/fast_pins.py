"""Which link a pin is fast in where nobody says so: whatever the order of lines, and the names.

A pin at a pivot stands still, one at a slider goes with the slider, and one that mirrored
halves or branches share does not turn by symmetry. Any other pin is taken to be fast in

1. a body that its loads can bend, before a rod that only pulls or pushes: a lever through
   three points, a link with a couple or a load of its own, with a wheel or a slot;
2. the link that fewest links separate from a pivot, then from a slider;
3. the first one by how the mechanism hangs together, seen from each link in turn;
4. the longer one, as far as lengths are given;
5. the one that is first by its direction, as far as that is given.

So a load at the end of a crank acts on the crank, and the coupler stays a rod.
"""

import math
from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any, assert_never

from ...formula.evaluate import evaluate
from ...formula.tree import Call
from ...formula.walk import symbols
from ..mechanism import (
    Absolute,
    Arrow,
    Feed,
    Force,
    ForcePair,
    Link,
    Load,
    LoadForm,
    LoadRatio,
    Mechanism,
    Offset,
    Pivot,
    Rope,
    Slider,
    Telescope,
    WheelPair,
)
from ..parts.holding import OnLink

UNCONNECTED = 10**6
"""So many links separate what hangs on no pivot."""

SAME_LENGTH_DIGITS = 9
"""Lengths that agree in so many digits are equal."""

CarrierNode = tuple[str, str]
"""A ``point`` or a ``body`` by its name."""

Adjacency = tuple[CarrierNode, CarrierNode, Hashable]


def is_held(point: str, mechanism: Mechanism) -> bool:
    """Return whether a pin is fast in the ground, a slider, a slide, or stands by symmetry."""
    return (
        any(isinstance(j, Pivot | Slider) and j.point == point for j in mechanism.joints)
        or bool(mechanism.slides_at(point))
        or point in mechanism.shared
    )


class FastPins:
    """Finds the link that a pin is fast in; ``values`` are those of parameters."""

    def __init__(self, mechanism: Mechanism, values: Mapping[str, float]) -> None:
        self._mechanism, self._values = mechanism, values
        self._bodies: list[Link | Telescope] = [*mechanism.rigid_links, *mechanism.telescopes]
        self._ranks: dict[str, tuple[Any, ...]] = {}

    def of(self, point: str) -> str:
        """Return the link that a pin is fast in, '' for the ground, a slider, or a standing one."""
        if is_held(point, self._mechanism):
            return ""
        ranks = self._ranked()
        return min((b.name for b in self._bodies if point in b.points), key=ranks.__getitem__)

    def _ranked(self) -> Mapping[str, tuple[Any, ...]]:
        """Return the rank of each link, the least being the first choice."""
        if not self._ranks:
            m = self._mechanism
            pivots = self._distances(set(m.fixed))
            guides = self._distances({s.point for s in m.each(Slider)} | _all(m.slides))
            bent = {*_bent(m)}
            nodes = self._labels()
            structure = refined(nodes, list(self._edges()))
            sized = [*self._edges(), *self._lengths()]
            lengths = refined(nodes, sized)
            drawn = refined(nodes, [*sized, *self._directions()])
            for body in self._bodies:
                near = (pivots.get(body.name, UNCONNECTED), guides.get(body.name, UNCONNECTED))
                place = [ranks["body", body.name] for ranks in (structure, lengths, drawn)]
                rigid = isinstance(body, Telescope), body.name not in bent
                self._ranks[body.name] = (*rigid, *near, *place, body.name)
        return self._ranks

    def _distances(self, held: set[str]) -> dict[str, int]:
        """Return how many links separate each link from some points; each is reached once."""
        found: dict[str, int] = {}
        reached, steps = set(held), 0
        while True:
            rim = [b for b in self._bodies if b.name not in found and reached & {*b.points}]
            if not rim:
                return found
            found |= {b.name: steps for b in rim}
            reached |= _all(rim)
            steps += 1

    # ----------------------------------------------------------------- how all hangs together

    def _labels(self) -> dict[CarrierNode, Hashable]:
        """Return the label of each point and body by itself, apart from its neighbours."""
        m = self._mechanism
        labels: dict[CarrierNode, Hashable] = {}
        for point in {p for b in (*self._bodies, *m.slides) for p in b.points}:
            at = [self._role(k) for k in m.loads if isinstance(k, Force) and k.point == point]
            labels["point", point] = ("point", is_held(point, m), _counted(at))
        for body in (*self._bodies, *m.slides):
            on = [self._role(k) for k in m.loads if getattr(k, "link", "") == body.name]
            labels["body", body.name] = (type(body).__name__, len(body.points), _counted(on))
        for pivot in m.each(Pivot):
            labels["point", pivot.point] = ("pivot", labels.get(("point", pivot.point)))
        return labels

    def _role(self, load: Load) -> Hashable:
        """Return the role of a load, independent of its name."""
        asked = []
        for find in self._mechanism.finds:
            match find.target:
                case LoadRatio(above, below):
                    asked += ["above"] * (above == load.name) + ["below"] * (below == load.name)
                case LoadForm(found):
                    asked += ["found"] * (found == load.name)
        return type(load).__name__, load.tie is not None, str(load.times), tuple(sorted(set(asked)))

    def _edges(self) -> Iterator[Adjacency]:
        """Yield the edges between points, joints and bodies."""
        mechanism = self._mechanism
        for body in (*self._bodies, *mechanism.slides):
            yield from ((("point", p), ("body", body.name), "on") for p in body.points)
        for joint in mechanism.joints:
            match joint:
                case Pivot() | Slider():
                    pass
                case WheelPair(kind):
                    first, *others = joint.bodies
                    yield from ((("body", first), ("body", other), kind) for other in others)
                case Feed():
                    yield ("point", joint.point), ("body", joint.link), joint.kind
                case OnLink():
                    word = type(joint).__name__
                    yield from ((("point", p), ("body", joint.link), word) for p in joint.points)
                case Rope(route):
                    yield from ((("point", a), ("point", b), "rope") for a, b in pairwise(route))
                case _:
                    assert_never(joint)
        for load in mechanism.loads:
            if isinstance(load, ForcePair) and not load.joins_twins:
                yield ("point", load.first), ("point", load.second), self._role(load)

    def _lengths(self) -> Iterator[Adjacency]:
        """Yield the distances that are given, by their places from the longest one on."""
        found = dict(self._distances_given())
        places = {value: i for i, value in enumerate(sorted({*found.values()}, reverse=True))}
        for (tail, head), value in found.items():
            yield ("point", tail), ("point", head), ("length", f"{places[value]:06d}")

    def _directions(self) -> Iterator[Adjacency]:
        """Yield the directions that are given, of either end of a vector alike, in degrees."""
        for entry in self._mechanism.geometry:
            match entry:
                case Arrow(tail, head, _, Absolute(angle)):
                    pass
                case Offset(tail, head, x, y) if tail:
                    angle = Call("atan2", (y, x))
                case _:
                    continue
            if symbols(angle) <= self._values.keys():
                turned = round(math.degrees(evaluate(angle, self._values)), 6) % 180
                yield ("point", tail), ("point", head), ("direction", f"{turned:010.6f}")

    def _distances_given(self) -> Iterator[tuple[tuple[str, str], float]]:
        """Yield the values of the lengths that are given, in any notation."""
        for entry in self._mechanism.geometry:
            match entry:
                case Arrow(tail, head, length, _):
                    pass
                case Offset(tail, head, x, y) if tail:
                    length = Call("hypot", (x, y))
                case _:
                    continue
            if length is not None and symbols(length) <= self._values.keys():
                size = abs(evaluate(length, self._values))
                yield (tail, head), float(f"{size:.{SAME_LENGTH_DIGITS}g}")


def _counted(items: Iterable[Hashable]) -> Hashable:
    """Return how often each item is there, in an order of their own."""
    return tuple(sorted(Counter(map(repr, items)).items()))


def _all(bodies: Iterable[Any]) -> set[str]:
    return {point for body in bodies for point in body.points}


def _bent(mechanism: Mechanism) -> Iterator[str]:
    """Yield the links that more than two forces in one line act on."""
    m = mechanism
    yield from (k.name for k in m.links if len(k.points) > 2)
    yield from (name for load in m.loads for name in load.links)
    yield from (name for joint in m.joints for name in joint.bodies)


def refined(
    labels: Mapping[CarrierNode, Hashable], edges: Sequence[Adjacency]
) -> Mapping[CarrierNode, int]:
    """Return the place of each node among all, by its label and by those that surround it.

    Nodes that differ are distinguished by their neighbours round after round. The number of
    classes grows in each round but the last, and there are no more classes than nodes.
    """
    ranks = _ranked({node: repr(label) for node, label in labels.items()})
    near: dict[CarrierNode, list[tuple[str, CarrierNode]]] = {node: [] for node in labels}
    for first, second, label in edges:
        if first in near and second in near:
            near[first].append((repr(label), second))
            near[second].append((repr(label), first))
    while True:
        seen = {
            node: (ranks[node], sorted((label, ranks[other]) for label, other in near[node]))
            for node in labels
        }
        finer = _ranked(seen)
        if len({*finer.values()}) == len({*ranks.values()}):
            return finer
        ranks = finer


def _ranked(labels: Mapping[CarrierNode, Any]) -> dict[CarrierNode, int]:
    """Return the place of each label among the different ones."""
    order: list[Any] = []
    for label in sorted(labels.values()):
        if not order or order[-1] != label:
            order.append(label)
    places = {repr(label): i for i, label in enumerate(order)}
    return {node: places[repr(label)] for node, label in labels.items()}
