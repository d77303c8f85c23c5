"""Where loads act, as the derivation asks for the velocities there."""

from ...kinematics.graph import Graph
from ...model.mechanism import Force, ForcePair


def acting_on(load: Force | ForcePair, graph: Graph) -> tuple[str, ...]:
    """Return the described points on which a force or a pair of forces acts."""
    if isinstance(load, Force):
        return (load.point,)
    return tuple(p for p in (load.first, load.second) if p in graph.velocities)
