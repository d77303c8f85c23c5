"""Assur groups of two links: a loop with two unknowns, taken apart, and how it closes.

A loop ``D + X + Y = 0`` has a known part D and two unknowns, each a direction or a length.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from ...algebra.angle import Angle, principal
from ...algebra.product import Product
from ...base.frozen import frozen
from ...base.named import NamedTuple
from ...formula.tree import Call
from ..pose import Limit, LoopKind, PoseDefinition, Vector, gathered
from ..vector_graph import Cycle, Edge, NameSet, mentioned


class Closure(NamedTuple):
    """One way in which a loop closes.

    ``definitions`` are new names with their formulas; ``directions`` are unknown angles as
    angles in known ones and in those names. ``across`` is the direction that mirrors another one
    in a line of symmetry, '' for none; ``alike`` are the unknown angles that are those of other
    vectors all the way, as in a parallelogram.
    """

    definitions: tuple[PoseDefinition, ...]
    directions: Mapping[str, Angle]
    across: str = ""
    alike: Mapping[str, Angle] = MappingProxyType({})


class Turning(NamedTuple):
    """The part of a loop that turns with an unknown angle x: ``size @ sense·x + offset``."""

    name: str
    sense: int
    size: Product
    offset: Angle

    def angle_at(self, direction: Angle) -> Angle:
        """Return x where the part points in a direction."""
        return principal((direction - self.offset) * self.sense)

    @property
    def direction(self) -> Angle:
        """Return the direction of the part."""
        return principal(Angle.of(self.name) * self.sense + self.offset)


class Reaching(NamedTuple):
    """The part of a loop of unknown length s: ``scale·s @ direction``."""

    name: str
    scale: Product
    direction: Angle


@frozen
class DyadLoop:
    """A loop with two unknowns; ``known`` is its known side, ``moving`` the rest."""

    cycle: Cycle
    unknown: NameSet
    known: Vector
    moving: Vector

    @classmethod
    def of(cls, cycle: Cycle, unknown: NameSet) -> "DyadLoop":
        """Take a loop apart."""
        arms = [(arm, unknown.isdisjoint(mentioned((arm,)))) for edge in cycle for arm in edge.arms]
        known = gathered(arm for arm, is_known in arms if is_known)
        return cls(cycle, unknown, known, tuple(arm for arm, is_known in arms if not is_known))

    def inner_pin(self) -> str:
        """Return the point between the two unknown edges, '' where they do not meet."""
        loose = self._loose()
        for i, edge in enumerate(self.cycle):
            if loose[i - 1] and loose[i]:
                return edge.tail
        return ""

    def base_point(self, name: str) -> str:
        """Return the point at which the part of an unknown leaves the known side."""
        loose = self._loose()
        for i, edge in enumerate(self.cycle):
            if name in mentioned(edge.arms):
                if not loose[i - 1]:
                    return edge.tail
                if not loose[(i + 1) % len(loose)]:
                    return edge.head
        return ""

    def _loose(self) -> list[bool]:
        return [not self.unknown.isdisjoint(mentioned(e.arms)) for e in self.cycle]

    def ends_between(self) -> tuple[str, str, str]:
        """Return three points whose turn distinguishes the closures: the pin, and what it joins."""
        inner_pin = self.inner_pin()
        loose = [e for e, is_loose in zip(self.cycle, self._loose(), strict=True) if is_loose]
        back = [e.turned() for e in reversed(loose)]
        before, after = (_end_from(inner_pin, way) for way in (back, loose))
        return before or loose[0].tail, inner_pin or loose[0].head, after or loose[-1].head


def _end_from(pin: str, edges: Sequence[Edge]) -> str:
    """Return where the edges from a pin on end that turn with the first of them, '' for none."""
    start = next((i for i, edge in enumerate(edges) if edge.tail == pin), len(edges))
    end = ""
    for edge in edges[start:]:
        if edge.tail != (end or pin) or mentioned(edge.arms) != mentioned(edges[start].arms):
            break
        end = edge.head
    return end


@frozen
class Dyad:
    """A loop of two unknowns with the ways in which it closes, one or two.

    ``kind`` is that of the unknowns, ``limit`` where the closures meet, and ``root`` what has no
    value where there is none.
    """

    loop: DyadLoop
    kind: LoopKind
    closures: tuple[Closure, ...]
    limit: Limit | None = None
    root: Call | None = None

    @property
    def cycle(self) -> Cycle:
        """Return the edges of the loop."""
        return self.loop.cycle

    @property
    def unknown(self) -> NameSet:
        """Return the two unknowns."""
        return self.loop.unknown

    def triples(self) -> list[tuple[str, str, str]]:
        """Return three points of the loop whose turn distinguishes the closures."""
        return [self.loop.ends_between()]
