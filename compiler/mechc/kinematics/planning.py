"""From the graph to the plan: mobility, drives, blocks, speeds."""

from collections.abc import Iterable, Mapping, Sequence

from ..algebra.matrices import Echelon, Residues, independent, residues
from ..algebra.modular import ModularPoint
from ..algebra.product import ONE, ZERO, weight
from ..algebra.solution_order import blocks, match
from ..algebra.sums import canonical
from ..diagnostics import Report
from ..diagnostics import kinematics as messages
from . import locked
from .graph import Graph, LinearForm, Relation, SpeedKind
from .plan import Block, Plan, SpeedFactors
from .solving import Binder, Memory, by_one_other, solve

MOTIONS = 64
"""Independent motions of a description: each speed has a term for every one of them."""


def plan_of(
    graph: Graph, report: Report, taken: frozenset[str] = frozenset(), may_stand: bool = False
) -> Plan:
    """Return the solved graph; report what is held twice, or cannot move unless it ``may_stand``.

    Long sums get names that are neither parameters nor ``taken``.
    """
    point = ModularPoint()
    rows = [residues(r.form, point) for r in graph.relations]
    kept = independent(rows)
    relations = [r for r, keep in zip(graph.relations, kept, strict=True) if keep]
    redundant = tuple(r for r, keep in zip(graph.relations, kept, strict=True) if not keep)
    mobility = len(graph.unknowns) - len(relations)
    stands = mobility == 0 and may_stand and bool(graph.unknowns)
    if mobility <= 0 and not stands:
        raise report.fail(messages.nothing_can_move(*locked.locked(graph, relations)))
    for relation in redundant:
        what = locked.described(relation, graph.pose.mechanism)
        report.add(messages.redundant_constraint(relation.span, what))
    if stands:
        return _standing(graph, relations, redundant)
    if mobility > MOTIONS:
        span = graph.pose.mechanism.span
        raise report.fail(messages.too_many_motions(span, mobility, MOTIONS))
    drives = _drives(graph, [residues(r.form, point) for r in relations])
    return _solved(graph, relations, drives, redundant, taken)


def _standing(graph: Graph, relations: Sequence[Relation], redundant: tuple[Relation, ...]) -> Plan:
    """Return the plan of a frame: no drives, and no step that leads to a speed."""
    speeds: dict[int, SpeedFactors] = dict.fromkeys(range(len(graph.unknowns)), ())
    return Plan(graph, tuple(relations), (), (), speeds, (), redundant)


def _drives(graph: Graph, rows: Sequence[Residues]) -> tuple[int, ...]:
    """Choose unknowns that determine all others, those that move the first loads before others.

    Columns are taken in order of preference from the back: a column is a drive if the
    relations leave it free once all less preferred columns are determined.
    """
    order = sorted(range(len(graph.unknowns)), key=lambda u: _preference(graph, u), reverse=True)
    place = {u: i for i, u in enumerate(reversed(order))}
    echelon = Echelon()
    for row in rows:
        echelon.take({place[u]: v for u, v in row.items()})
    return tuple(u for u in order if place[u] not in echelon.pivots)


def _preference(graph: Graph, unknown: int) -> tuple[int, int]:
    """Return how well an unknown serves as a drive: it moves an early load, and is no component."""
    loads = graph.pose.mechanism.loads
    kind = graph.unknowns[unknown].kind
    for place, load in enumerate(loads):
        if unknown in _movers(graph, load):
            return (len(loads) - place, kind is not SpeedKind.COMPONENT)
    return (0, kind is not SpeedKind.COMPONENT)


def _movers(graph: Graph, load: object) -> Iterable[int]:
    point = getattr(load, "point", None)
    if point is not None:
        return {flow.unknown for flow in graph.velocities.get(point, ())}
    link = getattr(load, "link", "")
    return {graph.spins[link]} if link in graph.spins else set()


def _solved(
    graph: Graph,
    relations: Sequence[Relation],
    drives: tuple[int, ...],
    redundant: tuple[Relation, ...],
    taken: frozenset[str],
) -> Plan:
    """Return the plan: all speeds by those of the drives, block after block of relations."""
    columns = [frozenset(r.form) - set(drives) for r in relations]
    matched = match(columns)
    speeds: dict[int, SpeedFactors] = {
        d: tuple(ONE if d == e else ZERO for e in drives) for d in drives
    }
    binder = Binder(taken.union(p.name for p in graph.pose.mechanism.parameters))
    memory = Memory(drives, {*graph.spins.values()})
    for drive in drives:
        memory.note(drive, speeds[drive])
    steps: list[Block] = []
    for group in blocks(columns, matched):
        step = Block(tuple(matched[unknown] for unknown in group), tuple(group))
        forms = [relations[r].form for r in step.relations]
        for unknown, values in _speeds_of(step.unknowns, forms, speeds, len(drives), memory):
            speeds[unknown] = tuple(binder.bound(canonical(v)) for v in values)
            memory.note(unknown, speeds[unknown])
        steps.append(step)
    bindings = tuple(binder.bindings)
    return Plan(graph, tuple(relations), drives, tuple(steps), speeds, bindings, redundant)


def _speeds_of(
    group: Sequence[int],
    forms: Sequence[LinearForm],
    known: Mapping[int, SpeedFactors],
    drives: int,
    memory: Memory,
) -> Iterable[tuple[int, SpeedFactors]]:
    """Return the speeds of a block's unknowns: one that is known again, or all as solved.

    One that a single other gives stays by that where this is as short: it may be known again by
    equal numbers alone, and the two arms OA and OB of 200 mm are not to stand next to each other.
    """
    recalled = memory.recall(forms[0], group[0]) if len(group) == 1 else None
    if recalled is None:
        return zip(group, solve(forms, group, known, drives), strict=True)
    direct = by_one_other(forms[0], group[0], known)
    if direct is None or _size(direct) > _size(recalled):
        return [(group[0], recalled)]
    return [(group[0], direct)]


def _size(speeds: SpeedFactors) -> int:
    """Return of how many factors speeds are made, those of sums included."""
    return sum(len(speed.factors) + weight(speed) for speed in speeds)
