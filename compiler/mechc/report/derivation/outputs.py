"""What a derivation has to find: the speeds that loads and questions ask for."""

from collections.abc import Iterator

from ...kinematics.forms import spin
from ...kinematics.graph import Graph
from ...model.mechanism import Force, ForcePair, Speed, SpeedRatio, Torque
from ...power.balance import Balance


def acting_on(load: Force | ForcePair, graph: Graph) -> tuple[str, ...]:
    """Return the described points on which a force or a pair of forces acts."""
    if isinstance(load, Force):
        return (load.point,)
    return tuple(p for p in (load.first, load.second) if p in graph.velocities)


def output_points(balance: Balance) -> Iterator[str]:
    """Yield the points whose velocities loads and speeds asked for rest on."""
    graph = balance.plan.graph
    for term in balance.terms:
        if any(term.power) and not isinstance(term.load, Torque):
            yield from acting_on(term.load, graph)
    yield from (speed.of for speed in _speeds_asked(graph) if speed.kind == "point")


def needed_unknowns(balance: Balance) -> set[int]:
    """Return the unknown speeds that loads and speeds asked for depend on."""
    plan, graph = balance.plan, balance.plan.graph
    needed = {f.unknown for p in output_points(balance) for f in graph.velocities[p]}
    links = [t.load.link for t in balance.terms if isinstance(t.load, Torque)]
    links += [speed.of for speed in _speeds_asked(graph) if speed.kind == "link"]
    needed |= {u for link in links for u in spin(graph, link)}
    for block in reversed(plan.blocks):
        if not needed.isdisjoint(block.unknowns):
            needed |= {u for r in block.relations for u in plan.relations[r].form}
    return needed


def _speeds_asked(graph: Graph) -> Iterator[Speed]:
    for find in graph.pose.mechanism.finds:
        if isinstance(find.target, SpeedRatio):
            yield find.target.above
            yield find.target.below
