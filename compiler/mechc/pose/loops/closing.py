"""Closing the loops: directions and places that follow from lengths and the drive.

Here is found what is sought; where that is nothing, nothing more is imported. How it is closed
is in :mod:`.by_groups`.
"""

from collections import Counter
from collections.abc import Iterable, Sequence

from ...diagnostics import Report
from ...model.mechanism import Mechanism, Parameter
from ...units import ANGLE, LENGTH
from ..directions import Directions
from ..pose import ALL_CLOSED, Closed
from ..terms import AlgebraicTerms
from ..vector_graph import Edge, NameSet, VectorGraph, mentioned
from ..vectors import Vectors
from . import by_groups, state
from .guide_lines import GuideLine, guide_lines


def close(
    mechanism: Mechanism,
    terms: AlgebraicTerms,
    directions: Directions,
    vectors: Vectors,
    report: Report,
) -> Closed:
    """Close all loops that mention a sought direction, and put the directions in.

    Reports E303 where given data disagree, E307 and E308 where the closure is not chosen,
    E309 where there is none at the default pose.
    """
    named, lines = _sought_parameters(mechanism), list(guide_lines(mechanism, directions))
    edges = [*vectors.edges, *(line.edge for line in lines)]
    lengths = _open_lengths(edges, terms) - {p.name for p in mechanism.parameters}
    if not (directions.sought or named or (lines and mechanism.drive)):
        crossed = _crossed(lines, edges, lengths)
        if not crossed:
            return Closed(mechanism, frozenset(), {}, (), (), ALL_CLOSED, mechanism.assemblies)
        edges = [e for e in edges if mentioned(e.arms) & lengths <= crossed]
        lengths = crossed
    angles = frozenset(directions.sought) | _turning(mechanism, named)
    graph = VectorGraph(edges, {*angles, *named, *lengths})
    sought = state.LoopState(mechanism, terms, graph, lines, angles, named)
    return by_groups.closed(sought, directions, vectors, report)


def _turning(mechanism: Mechanism, named: NameSet) -> NameSet:
    """Return the parameters among some that are angles."""
    return named & mechanism.angles


def _open_lengths(edges: Iterable[Edge], terms: AlgebraicTerms) -> NameSet:
    named = {n for e in edges for n in mentioned(e.arms) if n.startswith("len_")}
    return frozenset(named - {d.name for d in terms.definitions})


def _crossed(lines: Sequence[GuideLine], edges: Iterable[Edge], lengths: NameSet) -> NameSet:
    """Return the distances along lines to the pins that two lines give a place.

    They follow with all directions given, with no drive, and tie nothing. The second line of a
    slot's pin may be a vector of open length.
    """
    number, along = Counter(line.pin for line in lines), {line.length for line in lines}
    crossed = {line.length for line in lines if number[line.pin] == 2}
    open_ = [(e, mentioned(e.arms) & lengths) for e in edges]
    rods = [(e, names) for e, names in open_ if names and names.isdisjoint(along)]
    for line in (line for line in lines if line.in_slot and number[line.pin] == 1):
        beside = [names for e, names in rods if line.pin in (e.tail, e.head)]
        crossed |= {line.length, *beside[0]} if len(beside) == 1 else set()
    return frozenset(crossed)


def _sought_parameters(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters without a value that a loop may give, once something drives it."""
    if mechanism.drive is None and not mechanism.assemblies:
        return frozenset()
    drive = mechanism.drive_name
    return frozenset(p.name for p in mechanism.parameters if _is_open(p) and p.name != drive)


def _is_open(parameter: Parameter) -> bool:
    """Return whether a parameter waits for a value from a loop; a length with a range is given."""
    is_length = parameter.dimension == LENGTH and parameter.range is None
    return parameter.value is None and (is_length or parameter.dimension == ANGLE)
