"""Why a direction is open: what is missing for a loop to give it.

First what hides the loop (pivots that have no place, guides that have no line), then what
leaves too much open in it; a direction of its own is asked for only where no loop is there.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence

from ..diagnostics import Diagnostic
from ..diagnostics import open_loops as messages
from ..diagnostics import pose as plain
from ..model.mechanism import (
    AlongLine,
    Arrow,
    Link,
    Mechanism,
    Parameter,
    Pivot,
    Slider,
    Slot,
    Turn,
)
from ..model.values import bounds
from ..source import Span
from ..units import ANGLE, LENGTH, in_unit
from .pose import OpenUnknowns
from .vector_graph import NameSet, mentioned
from .vectors import Vectors

SoughtVectors = Mapping[str, tuple[str, str, Span]]


def explained(
    mechanism: Mechanism,
    vectors: Vectors,
    sought: SoughtVectors,
    needed: Mapping[str, Link],
    left: OpenUnknowns,
) -> Iterator[Diagnostic]:
    """Yield why directions are open that nothing gives: ``needed`` of them by links.

    ``sought`` are the directions that only a loop can give, with the points and the place
    in the text that ask for each.
    """
    if not needed:
        return
    causes = (
        _cycles(mechanism),
        _without_value(mechanism.parameters, left.unknown),
        _without_place(mechanism, vectors),
        _without_input(mechanism, needed, sought, left),
        _ends_on_guides(mechanism, [sought[name][:2] for name in needed]),
    )
    for cause in causes:
        if found := list(cause):
            yield from found
            return
    # With a drive one missing pivot or vector opens every loop that it is in.
    for name, link in [*needed.items()][: 1 if mechanism.drive else None]:
        tail, head, _ = sought[name]
        guided = _nearest_guide_without_line(mechanism, {tail, head})
        what, near = f"link {link.name}", _near(mechanism)
        rod, loose = _without_length(mechanism), _placed_and_loose(mechanism)
        points = f"{tail}{head}"
        yield plain.missing_direction(link.span, points, what, guided, near, rod, loose=loose)


def unfound_angles(
    mechanism: Mechanism, vectors: Vectors, found: Collection[str], left: OpenUnknowns
) -> Iterator[Diagnostic]:
    """Yield the reasons why loops do not give the angles that the user left open, with a drive."""
    used = {n for edge in vectors.edges for n in mentioned(edge.arms)}
    open_ = [p for p in mechanism.parameters if _is_open(p) and p.name in used - {*found}]
    drive = mechanism.drive
    if drive is None or all(p.name == drive.parameter for p in open_):
        return
    causes = (
        _without_value(mechanism.parameters, left.unknown),
        _without_place(mechanism, vectors),
        _without_line(mechanism),
    )
    for cause in causes:
        if reasons := list(cause):
            yield from reasons
            return
    for parameter in open_:
        if parameter.name != drive.parameter:
            yield messages.angle_not_found(parameter.span, parameter.name, drive.parameter)


def _is_open(parameter: Parameter) -> bool:
    return parameter.dimension == ANGLE and parameter.value is None and parameter.range is None


def _without_value(parameters: Sequence[Parameter], unknown: NameSet) -> Iterator[Diagnostic]:
    """Yield the lengths that loops wait for, and the angles of which a range alone is given."""
    for parameter in parameters:
        if parameter.name in unknown and parameter.dimension == LENGTH:
            yield messages.length_without_value(parameter.span, parameter.name)
        elif parameter.name in unknown and parameter.range:
            middle = sum(bounds(parameter)) / 2
            shown = in_unit(middle, parameter.unit or "deg", 4)
            yield messages.angle_without_value(parameter.span, parameter.name, shown)


def _without_place(mechanism: Mechanism, vectors: Vectors) -> Iterator[Diagnostic]:
    """Yield the pivots from which no vectors on the ground lead to the others."""
    ground = {"", *mechanism.fixed}
    ground |= {s.through for s in mechanism.each(Slider) if s.through}
    pivots = mechanism.each(Pivot)
    joined = [{q for q in ground if vectors.chain(p.point, q, ground)} for p in pivots]
    home = max(joined, key=len, default=set())
    parts = mechanism.subassemblies
    own_names = {here: (there, part.prefix) for part in parts for there, here in part.points}
    for pivot, others in zip(pivots, joined, strict=True):
        if pivot.point not in home and others.isdisjoint(home):
            point = pivot.point
            own = own_names.get(point, (point, ""))
            yield messages.pivot_without_place(pivot.span, point, _beside(home, mechanism), *own)


def _beside(ground: Collection[str], mechanism: Mechanism) -> str:
    """Return the first of some places on the ground: a pivot, else a guide by its slider."""
    guides = {s.through: f"the guide of {s.point}" for s in mechanism.each(Slider)}
    pivots = [point for point in ground if point and point not in guides]
    return min(pivots or [guides[p] for p in ground if p in guides], default="")


def _without_line(mechanism: Mechanism) -> Iterator[Diagnostic]:
    for slider in mechanism.each(Slider):
        if not slider.through:
            yield messages.guide_without_line(slider.span, slider.point, _near(mechanism))


def _ends_on_guides(
    mechanism: Mechanism, vectors: Sequence[tuple[str, str]]
) -> Iterator[Diagnostic]:
    """Yield the guides without a line at which rods end whose directions a drive is to give."""
    ends = {point for pair in vectors for point in pair}
    for slider in _guides_without_line(mechanism, ends) if mechanism.drive else ():
        yield messages.guide_without_line(slider.span, slider.point, _near(mechanism))


def _guides_without_line(mechanism: Mechanism, ends: Collection[str]) -> Iterator[Slider]:
    """Yield the sliders among some points whose guides have no line."""
    sliders = mechanism.each(Slider)
    return (s for s in sliders if s.point in ends and not s.through)


def _nearest_guide_without_line(mechanism: Mechanism, ends: Collection[str]) -> str:
    """Return the slider without a line that the fewest links lead to from some points, '' for none.

    With a line of its own a loop through it would give the direction between these.
    """
    reached, before = frozenset(ends), frozenset[str]()
    while reached > before:
        if guided := next(_guides_without_line(mechanism, reached), None):
            return guided.point
        touching = (link.points for link in mechanism.links if not reached.isdisjoint(link.points))
        before, reached = reached, reached.union(*touching)
    return ""


def _without_length(mechanism: Mechanism) -> str:
    """Return the one rod of which a drive's description gives nothing, '' for none or several."""
    given = {frozenset((g.tail, g.head)) for g in mechanism.geometry if not isinstance(g, Turn)}
    rods = [k.name for k in mechanism.links if len(k.points) == 2 and {*k.points} not in given]
    return rods[0] if mechanism.drive and len(rods) == 1 else ""


def _placed_and_loose(mechanism: Mechanism) -> str:
    """Return the first point with a place of which nothing says what holds it, '' for none."""
    held = {*mechanism.fixed, *(point for joint in mechanism.joints for point in joint.points)}
    links = mechanism.rigid_bodies
    alone = (d.point for d in mechanism.drawn if sum(d.point in k.points for k in links) == 1)
    return next((point for point in alone if point not in held), "")


def _near(mechanism: Mechanism) -> str:
    """Return a place for a line to go through."""
    return min(filter(None, mechanism.fixed), default="(0 mm, 0 mm)")


def _without_input(
    mechanism: Mechanism, needed: Mapping[str, Link], sought: SoughtVectors, left: OpenUnknowns
) -> Iterator[Diagnostic]:
    """Yield one message for loops that leave some of their unknowns open.

    A link that a block guides keeps its angle to the slot: that is what is missing first.
    """
    names = [name for name in needed if name in left.unknown]
    if not names or not left.missing:
        return
    points = ["".join(sought[name][:2]) for name in names]
    guided = next(_guided(mechanism, {needed[name].name for name in names}), "")
    yield messages.inputs_missing(needed[names[0]].span, points, left.missing, guided)


def _guided(mechanism: Mechanism, open_: Collection[str]) -> Iterator[str]:
    """Yield the three points of the angle between a slot and an open link that it guides."""
    for slot in mechanism.each(Slot):
        if slot.guided in open_:
            other = next(p for p in mechanism.link(slot.guided).points if p != slot.point)
            yield f"{slot.tail}{slot.point}{other}"


def _cycles(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the directions that are given by one another, all round."""
    after = {
        frozenset((g.tail, g.head)): (g, frozenset((g.direction.tail, g.direction.head)))
        for g in mechanism.geometry
        if isinstance(g, Arrow) and isinstance(g.direction, AlongLine)
    }
    seen: set[frozenset[str]] = set()
    for start in after:
        chain, following = [start], after[start][1]
        while following in after and following not in chain:
            chain.append(following)
            following = after[following][1]
        if following == start and start not in seen:
            seen.update(chain)
            entries = [after[pair][0] for pair in chain]
            names = [f"{entry.tail}{entry.head}" for entry in entries]
            yield messages.directions_in_a_cycle(entries[0].span, names)
