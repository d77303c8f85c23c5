"""What locks a mechanism of mobility 0: the smallest group of parts that hold one another."""

from collections.abc import Iterator, Sequence

from ..algebra.solution_order import blocks, match
from ..base.named import NamedTuple
from ..model.mechanism import Mechanism, Meshing
from ..source import Span
from .graph import Graph, Relation, Rule, SpeedKind


class Locked(NamedTuple):
    """Parts that leave one another no motion, and where the first of them stands."""

    parts: tuple[str, ...]
    span: Span


def locked(graph: Graph, relations: Sequence[Relation]) -> Locked:
    """Return the smallest group whose relations by themselves hold all speeds they mention.

    ``relations`` are independent, and as many as the unknowns.
    """
    columns = [frozenset(r.form) for r in relations]
    matched = match(columns)
    groups = (
        (group, [matched[u] for u in group])
        for group in blocks(columns, matched)
        if all(columns[matched[u]] <= set(group) for u in group)
    )
    smallest = min(groups, key=lambda g: len(g[0]), default=None)
    if smallest is None:
        return Locked((), graph.pose.mechanism.span)
    unknowns, rows = smallest
    held = sorted((relations[r] for r in rows), key=lambda r: r.span)
    return Locked(tuple(dict.fromkeys(_parts(graph, unknowns, held))), held[0].span)


def _parts(graph: Graph, unknowns: Sequence[int], held: Sequence[Relation]) -> Iterator[str]:
    """Yield the links that turn, then those whose pins and guides hold them."""
    for unknown in unknowns:
        kind, of, _ = graph.unknowns[unknown]
        if kind is SpeedKind.SPIN:
            yield f"link {of}"
        elif kind is SpeedKind.SLIDE:
            yield f"slider {of}"
    mirror = graph.pose.mechanism.mirror
    for relation in held:
        if mirror and relation.span == mirror.span:
            yield f"the mirror line, along which the shared {relation.points[0]} moves,"
        elif relation.rule is not Rule.HELD:
            yield described(relation, graph.pose.mechanism)


def described(relation: Relation, mechanism: Mechanism) -> str:
    """Return the part of the mechanism that demands a relation."""
    if relation.rule is Rule.HELD:
        return "a load that is held still"
    point, body = relation.points[0], relation.link
    match relation.rule:
        case Rule.TURNING:
            return f"the block that is fast in {body}"
        case Rule.SLOT:
            return f"the slot of {point} in {body}"
        case Rule.CONTACT:
            return f"the contact of {point} with {body}"
        case Rule.MESH:
            mesh = mechanism.joint(relation.joint)
            assert isinstance(mesh, Meshing), "no other joint meshes"
            return mesh.described
        case Rule.ROPE:
            return f"the rope over {', '.join(relation.points)}"
        case _:
            return f"link {body}" if body else f"the guide of {point}"
