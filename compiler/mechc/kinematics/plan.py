"""The plan: in which order the speeds follow from the drives, and what they are."""

import math
from collections.abc import Mapping
from types import MappingProxyType

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..algebra.sums import add
from ..base.frozen import frozen
from ..base.named import NamedTuple
from .forms import projection, spin
from .graph import Graph, LinearForm, Relation


class Block(NamedTuple):
    """Relations that give as many unknowns, all at once; a single one is a plain step."""

    relations: tuple[int, ...]
    unknowns: tuple[int, ...]


class Binding(NamedTuple):
    """A long sum bound to a name, so that what is built on it stays small."""

    name: str
    value: Product


SpeedFactors = tuple[Product, ...]
"""A speed as a linear form in the drives: one coefficient for each."""


@frozen
class Plan:
    """The solved graph.

    ``drives`` are the unknowns taken as given, as many as the mobility; ``speeds[u]``
    is unknown u per unit of each drive. ``relations`` are the independent ones, which
    ``blocks`` count. ``bindings`` are in order of use.
    ``redundant`` are relations that follow from the others. ``ratios`` are the names among the
    bindings that unknowns have per unit of the only drive, where the plan is one to read.
    """

    graph: Graph
    relations: tuple[Relation, ...]
    drives: tuple[int, ...]
    blocks: tuple[Block, ...]
    speeds: Mapping[int, SpeedFactors]
    bindings: tuple[Binding, ...]
    redundant: tuple[Relation, ...]
    ratios: Mapping[int, Binding] = MappingProxyType({})

    @property
    def mobility(self) -> int:
        """Return the number of independent motions."""
        return len(self.drives)

    def value(self, form: LinearForm) -> SpeedFactors:
        """Return a linear form in the unknowns as one in the drives."""
        moving = [(size, self.speeds[u]) for u, size in form.items() if any(self.speeds[u])]
        return tuple(add(size * speeds[i] for size, speeds in moving) for i in range(self.mobility))

    def component(self, point: str, direction: Angle) -> SpeedFactors:
        """Return the component of a point's velocity along a direction, per unit of each drive."""
        return self.value(projection(self.graph.velocities[point], direction))

    def spin(self, link: str) -> SpeedFactors:
        """Return a link's angular velocity, counter-clockwise, per unit of each drive."""
        return self.value(spin(self.graph, link))

    def spins_at(self, values: Mapping[str, float]) -> Mapping[str, float]:
        """Return every link's angular velocity per unit of the only drive, at a pose.

        May raise ZeroDivisionError where a speed has a pole.
        """
        speeds = {unknown: speed.evaluate(values) for unknown, (speed,) in self.speeds.items()}
        links = self.graph.pose.mechanism.links
        forms = {link.name: spin(self.graph, link.name) for link in links}
        return {
            name: math.fsum(size.evaluate(values) * speeds[u] for u, size in form.items())
            for name, form in forms.items()
        }
