"""Drives that are held at their values while another one moves.

What a held drive would move is made fast: a link on a pivot is pinned to the ground at a second
point, links are joined by a rod between points of both, a telescope becomes a rod.
"""

from cmath import phase
from collections.abc import Iterator

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...diagnostics import Report
from ...diagnostics.model import held as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ..mechanism import (
    Absolute,
    Arrow,
    Drive,
    Geometry,
    Link,
    LoadForm,
    LoadRatio,
    Mechanism,
    Offset,
    Pivot,
    Slider,
    SpeedRatio,
    Turn,
)
from ..values import default_pose


class Pinned(NamedTuple):
    """A point that is at rest while a drive is held."""

    point: str


class Joined(NamedTuple):
    """Two points whose distance stays while a drive is held."""

    first: str
    second: str


Hold = Pinned | Joined

OUTSIDE = (LoadRatio, LoadForm, SpeedRatio)
"""What is asked for and does not rest on the forces by which something is held."""


def with_held(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism in which what parameters of held drives would move is fast.

    Reports E525 where that is undetermined, E527 where forces are asked for that are
    not known unless it is known what holds.
    """
    drives = [drive.parameter for drive in mechanism.drives]
    for drive in mechanism.held:
        others = frozenset(drives) - {drive.parameter}
        entries = mechanism.geometry
        found = (h for entry in entries for h in _holds(entry, drive, others, mechanism))
        mechanism = _held(mechanism, next(found, None), drive, report)
    return mechanism


def _held(mechanism: Mechanism, hold: Hold | None, drive: Drive, report: Report) -> Mechanism:
    """Return a mechanism with a drive held; as it is, and reported, where nothing can hold it."""
    if hold is None:
        report.add(messages.cannot_hold(drive.span, drive.parameter, _as_angle(drive, mechanism)))
        return mechanism
    inside = [f for f in mechanism.finds if not isinstance(f.target, OUTSIDE)]
    if inside and not _is_itself(hold, mechanism):
        report.add(messages.held_by_what(inside[0].span, drive.parameter, drive.span))
    return _with_hold(mechanism, hold, drive)


def _as_angle(drive: Drive, mechanism: Mechanism) -> tuple[str, float] | None:
    """Return the corner between a drawn link that drives and one that it is pinned to, as drawn.

    That is its name, OAB, and its angle in radians; None where there is none.
    """
    ends, places = set(drive.ends or ()), _places(mechanism)
    for link in mechanism.links if ends and places.keys() >= ends else ():
        shared, rest = ends & set(link.points), [p for p in link.points if p not in ends]
        first = next((p for p in rest if p in places), "")
        if len(shared) == 1 and first:
            (vertex,), (second,) = shared, ends - shared
            before, behind = (places[p] - places[vertex] for p in (first, second))
            return f"{first}{vertex}{second}", phase(behind / before) if before else 0.0
    return None


def _places(mechanism: Mechanism) -> dict[str, complex]:
    """Return where points are drawn, and pivots placed."""
    values = default_pose(mechanism)
    drawn = [(d.point, d.x, d.y) for d in mechanism.drawn]
    placed = [e for e in mechanism.geometry if isinstance(e, Offset) and not e.tail]
    given = [*((e.head, e.x, e.y) for e in placed), *drawn]
    known = [(p, x, y) for p, x, y in given if symbols(x, y) <= values.keys()]
    return {p: complex(evaluate(x, values), evaluate(y, values)) for p, x, y in known}


def _is_itself(hold: Hold, mechanism: Mechanism) -> bool:
    """Return whether a telescope or a slider is held, not links, which a couple would hold."""
    if isinstance(hold, Pinned):
        return any(slider.point == hold.point for slider in mechanism.each(Slider))
    return any(set(t.points) == set(hold) for t in mechanism.telescopes)


def _with_hold(mechanism: Mechanism, hold: Hold, drive: Drive) -> Mechanism:
    """Return a mechanism with a pivot where a point is held, or a rod in a telescope's place."""
    if isinstance(hold, Pinned):
        return replace(mechanism, joints=(*mechanism.joints, Pivot(hold.point, drive.span)))
    rod = Link("".join(hold), hold, drive.span)
    telescopes = tuple(t for t in mechanism.telescopes if set(t.points) != set(hold))
    return replace(mechanism, telescopes=telescopes, links=(*mechanism.links, rod))


def _holds(
    entry: Geometry, drive: Drive, others: frozenset[str], mechanism: Mechanism
) -> Iterator[Hold]:
    """Yield the holds that an entry gives which mentions a drive, while that is held."""

    def moves(formula: Formula | None) -> bool:
        return formula is not None and drive.parameter in symbols(formula)

    match entry:
        case Arrow(tail, head, length, _) if moves(length):
            yield from _of_length(tail, head, mechanism)
        case Arrow(tail, head, _, Absolute(angle)) if moves(angle):
            yield from _of_direction((tail, head), symbols(angle) & others, others, mechanism)
        case Turn(first, vertex, second, angle) if moves(angle):
            yield _of_turn(first, vertex, second, mechanism)


def _of_length(tail: str, head: str, mechanism: Mechanism) -> Iterator[Hold]:
    """Yield a slider that a length from the ground places, or the ends of a telescope."""
    fixed, guided = {"", *mechanism.fixed}, {s.point for s in mechanism.each(Slider)}
    for end, other in ((tail, head), (head, tail)):
        if end in fixed and other in guided:
            yield Pinned(other)
    if any(set(t.points) == {tail, head} for t in mechanism.telescopes):
        yield Joined(tail, head)


def _of_direction(
    ends: tuple[str, str], added: frozenset[str], others: frozenset[str], mechanism: Mechanism
) -> Iterator[Hold]:
    """Yield the holds where the direction of a link stays: against the ground, or a link.

    The other link has that part of the direction which other drives move.
    """
    loose = [point for point in ends if point not in mechanism.fixed]
    if not added and len(loose) == 1:
        yield Pinned(loose[0])
    for entry in mechanism.geometry if added else ():
        match entry:
            case Arrow(tail, head, _, Absolute(angle)) if symbols(angle) & others == added:
                shared = {tail, head} & set(ends)
                if len(shared) == 1:
                    first, second = (next(iter({*pair} - shared)) for pair in ((tail, head), ends))
                    yield Joined(first, second)


def _of_turn(first: str, vertex: str, second: str, mechanism: Mechanism) -> Hold:
    """Return the hold of a constant angle between two links, or a link and the ground."""
    fixed = mechanism.fixed
    for end, other in ((first, second), (second, first)):
        if {vertex, end} <= fixed:
            return Pinned(other)
    return Joined(first, second)
