"""What can be meant, and hardly ever is: remarks on values, bodies and the drive."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from ..diagnostics import Diagnostic
from ..diagnostics.model import doubts as messages
from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..source import Span
from ..units import ANGLE, LENGTH
from .joint_friction import RopeFriction
from .mechanism import (
    Absolute,
    Along,
    Arrow,
    Contact,
    Direction,
    Find,
    Force,
    Link,
    Mechanism,
    Offset,
    Parameter,
    Pivot,
    Rack,
    Slider,
    WheelPair,
)
from .tolerances import SAME_DIRECTION, SAME_VALUE
from .values import Chain, Values, defaults, dependent

TURN = 2 * math.pi * (1 + SAME_VALUE)

FAR = 100.0
"""How many times a length is the largest, or the smallest, of the others: 35 is met in books."""

SOME = 0.731
"""A value for what is open, at which no formula vanishes by chance."""

FARTHEST = 1e6
"""Lengths in metres beyond which a vector is as good as infinite."""


def doubts(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield a remark on each thing that is hardly meant."""
    chain = Chain(dependent(mechanism))
    values = chain.complete(defaults(mechanism))
    yield from _turns(mechanism)
    yield from _vanishing(mechanism, chain, values)
    yield from _far_off(mechanism, values)
    yield from _asked_twice(mechanism.finds)
    yield from _coinciding(mechanism, values)
    yield from _within(mechanism.links)
    yield from _of_ground(mechanism)
    yield from _along_a_link(mechanism)
    yield from _held(mechanism)
    yield from _without_value(mechanism, values)
    yield from _of_no_size(mechanism, values)
    if mechanism.friction.joints:
        yield from _standing_for_friction(mechanism, values)


# -------------------------------------------------------------------------- angles


def _turns(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the angles beyond a turn: values, ends of ranges and strokes, directions.

    A rope may be wound around a pulley several times, and wheels lead links round and round.
    """
    ranged = {p.name for p in mechanism.parameters if p.range}
    wraps = (j.wrap for j in mechanism.friction.joints if isinstance(j, RopeFriction))
    wound = {name for wrap in wraps for name in symbols(wrap)}
    if mechanism.meshes:
        wound |= _turning(mechanism)
    for parameter in mechanism.parameters:
        turns = parameter.dimension == ANGLE and parameter.name not in wound
        if turns and not parameter.dependent:
            yield from _turn_of(parameter)
    if not mechanism.meshes:
        yield from _turns_written(mechanism, ranged)


def _turning(mechanism: Mechanism) -> set[str]:
    """Return the names that directions rest on, and the drive's."""
    given = (d.angle for d in directions(mechanism) if isinstance(d, Absolute))
    driving = {mechanism.drive.parameter} if mechanism.drive else set[str]()
    return driving.union(*map(symbols, given))


def _turns_written(mechanism: Mechanism, ranged: set[str]) -> Iterator[Diagnostic]:
    """Yield the ends of strokes and the directions beyond a turn."""
    drive = mechanism.drive
    angles = {p.name for p in mechanism.parameters if p.dimension == ANGLE}
    if drive and drive.parameter in angles - ranged:
        what = f"an end of the stroke of {drive.parameter}"
        yield from _beyond(drive.span, what, (drive.low, drive.high))
    for direction in directions(mechanism):
        if isinstance(direction, Absolute):
            rest = evaluate(direction.angle, dict.fromkeys(symbols(direction.angle), 0.0))
            if 2 * TURN < abs(rest) < math.inf:
                yield messages.beyond_a_turn(direction.span, "the direction", rest / (2 * math.pi))


def _turn_of(parameter: Parameter) -> Iterator[Diagnostic]:
    value = list(_beyond(parameter.given, f"the value of '{parameter.name}'", (parameter.value,)))
    ends = (parameter.range.low, parameter.range.high) if parameter.range else ()
    yield from value or _beyond(parameter.span, f"an end of the range of '{parameter.name}'", ends)


def _beyond(span: Span, what: str, angles: Iterable[Formula | None]) -> Iterator[Diagnostic]:
    """Yield the remark on the largest of constant angles, if it is beyond a turn."""
    sizes = [evaluate(angle, {}) for angle in angles if angle is not None]
    largest = max(sizes, key=abs, default=0.0)
    if abs(largest) > TURN:
        yield messages.beyond_a_turn(span, what, largest / (2 * math.pi))


def directions(mechanism: Mechanism) -> Iterator[Direction]:
    """Yield every direction that is written down, of vectors, guides, faces, ropes and forces."""
    yield from (g.direction for g in mechanism.geometry if isinstance(g, Arrow) and g.direction)
    yield from (s.along for s in mechanism.each(Slider))
    yield from (s.along for s in mechanism.slides)
    yield from (c.normal for c in mechanism.each(Contact))
    yield from (way for rope in mechanism.ropes for way in rope.ways)
    yield from (k.along for k in mechanism.loads if isinstance(k, Force) and not k.weight)


# ------------------------------------------------------------------------- lengths


def _vanishing(mechanism: Mechanism, chain: Chain, values: Values) -> Iterator[Diagnostic]:
    """Yield the parameters that may take a length to zero or to infinity, each once.

    A coordinate along a given direction may pass zero.
    """
    given, resting = defaults(mechanism), dict[str, list[Arrow]]()
    for arrow in mechanism.geometry:
        if isinstance(arrow, Arrow) and arrow.length is not None:
            for name in sorted(symbols(arrow.length)):
                resting.setdefault(name, []).append(arrow)
    for parameter in mechanism.parameters:
        for end, where in _reach(parameter, mechanism, values):
            known = chain.complete({**given, parameter.name: end})
            moved = [n for n in known if known[n] != values.get(n)]
            arrows = [a for n in moved for a in resting.get(n, ()) if _fails(a, known)]
            found = next((a for a in arrows if _is_strange(a, known, where, mechanism)), None)
            if found:
                yield _vanishes(found, known, parameter, where)
                break


def _fails(arrow: Arrow, known: Values) -> bool:
    """Return whether a length that has a value is no positive one, or as good as infinite."""
    assert arrow.length is not None
    is_known = symbols(arrow.length) <= known.keys()
    return is_known and not 0 < evaluate(arrow.length, known) < FARTHEST


def _is_strange(arrow: Arrow, known: Values, where: str, mechanism: Mechanism) -> bool:
    """Return whether a length that fails is no coordinate, and no study of sizes."""
    assert arrow.length is not None
    if body_through((arrow.tail, arrow.head), mechanism):
        return where != "the stroke"
    return arrow.direction is None or not abs(evaluate(arrow.length, known)) < FARTHEST


def _vanishes(arrow: Arrow, known: Values, parameter: Parameter, where: str) -> Diagnostic:
    assert arrow.length is not None
    size = evaluate(arrow.length, known)
    shown = f"{size * 1000:.6g} mm" if abs(size) < FARTHEST else "infinity"
    shown = "" if math.isnan(size) else shown
    points = f"{arrow.tail}{arrow.head}"
    return messages.length_vanishes(parameter.span, points, shown, parameter.name, where)


def _reach(
    parameter: Parameter, mechanism: Mechanism, values: Values
) -> Iterator[tuple[float, str]]:
    """Yield how far a parameter may go, and what takes it there."""
    value, drive = values.get(parameter.name), mechanism.drive
    if parameter.range:
        yield evaluate(parameter.range.low, {}), "the range"
        yield evaluate(parameter.range.high, {}), "the range"
    elif drive and drive.parameter == parameter.name:
        yield from ((evaluate(e, {}), "the stroke") for e in (drive.low, drive.high) if e)
    if parameter.tolerance is not None and value is not None:
        size = evaluate(parameter.tolerance, {})
        yield from ((value + sign * size, "the tolerance") for sign in (-1, 1))


def _far_off(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the largest length that is far from the rest.

    Those written in place, as in ``OA = 100 mm @ x``, give the size of a mechanism, too.
    """
    written = [f for g in mechanism.geometry for f in _lengths(g)]
    plain = [abs(evaluate(f, {})) for f in written if not symbols(f) and evaluate(f, {})]
    used = {name for f in written for name in symbols(f)}
    lengths = [p for p in mechanism.parameters if p.dimension == LENGTH and p.name in used]
    given = [p for p in lengths if values.get(p.name) and not p.dependent]
    units = Counter(p.unit for p in given)
    if len(units) not in (1, 2):
        return
    sizes = {p.name: abs(values[p.name]) for p in given}
    alone = [p for p in given if len(units) == 1 or units[p.unit] == 1]
    for parameter in sorted(alone, key=lambda p: -sizes[p.name]):
        size = sizes[parameter.name]
        others = [*plain, *(s for name, s in sizes.items() if name != parameter.name)]
        if len(others) < 3 - len(units):
            continue
        if size > FAR * max(others) or size * FAR < min(others):
            other = next(iter(units.keys() - {parameter.unit}), "")
            yield messages.length_far_off(parameter.given, parameter.name, parameter.unit, other)
            return


def _lengths(entry: object) -> tuple[Formula, ...]:
    match entry:
        case Arrow(length=length) if length is not None:
            return (length,)
        case Offset(x=x, y=y):
            return (x, y)
        case _:
            return ()


# ------------------------------------------------------------------ bodies, pivots


def _coinciding(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the pivots at the place of an earlier one, but for those of wheels."""
    wheels = {p for j in mechanism.joints if isinstance(j, WheelPair | Rack) for p in j.points}
    spans = {p.point: p.span for p in mechanism.each(Pivot)}
    first: dict[tuple[float, float], str] = {}
    for entry in mechanism.geometry:
        if not isinstance(entry, Offset) or entry.tail or entry.head not in spans:
            continue
        if not symbols(entry.x) | symbols(entry.y) <= values.keys():
            continue
        x, y = (round(evaluate(part, values), 9) + 0.0 for part in (entry.x, entry.y))
        other = first.setdefault((x, y), entry.head)
        is_guide = "_" in other + entry.head
        if other != entry.head and not is_guide and wheels.isdisjoint((other, entry.head)):
            yield messages.pivots_coincide(spans[entry.head], entry.head, other, spans[other])


def _within(links: Sequence[Link]) -> Iterator[Diagnostic]:
    """Yield the links whose points are all on one other link."""
    through: dict[str, list[Link]] = {}
    for link in links:
        for point in link.points:
            through.setdefault(point, []).append(link)
    for link in links:
        for other in through[link.points[0]]:
            if other is not link and set(link.points) < set(other.points):
                yield messages.link_within_link(link.span, link.name, other.name, other.span)
                break


def _of_ground(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the links between pivots alone."""
    for link in mechanism.links:
        if set(link.points) <= mechanism.fixed:
            yield messages.link_of_ground(link.span, link.name)


def _along_a_link(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the guides whose direction is that of a link that moves: they stand still."""
    for slider in mechanism.each(Slider):
        along = slider.along
        if not isinstance(along, Along) or along.quarter % 2:
            continue
        ends = {along.tail, along.head}
        link = next((k for k in mechanism.links if ends <= set(k.points)), None)
        if link and not ends <= mechanism.fixed:
            yield messages.guide_along_link(along.span, slider.point, link.name)


def _held(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the telescopes between two points of one link, or of the ground."""
    for telescope in mechanism.telescopes:
        if body := body_through(telescope.points, mechanism):
            yield messages.telescope_between_fixed(telescope.span, telescope.name, body)


def body_through(points: Iterable[str], mechanism: Mechanism) -> str:
    """Return the rigid body that two points are fast in: a link, a slide, the ground, or ''."""
    pair = set(points)
    if pair <= {"", *mechanism.fixed}:
        return "the ground"
    found = next((body for body in mechanism.rigid_bodies if pair <= set(body.points)), None)
    return f"{'link' if isinstance(found, Link) else 'slide'} {found.name}" if found else ""


# ------------------------------------------------------------------ what is asked for


def _asked_twice(finds: Sequence[Find]) -> Iterator[Diagnostic]:
    """Yield the first result of each line that an earlier line asks for, not what it brings on."""
    first: dict[object, Find] = {}
    reported: set[Span] = set()
    for find in finds:
        other = first.setdefault(find.target, find)
        if other.name != find.name and find.span not in reported:
            reported.add(find.span)
            yield messages.asked_twice(find.span, find.name, other.name, other.span)


def _without_value(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the formulas of parameters alone that have no finite value."""
    named = ((p.name, p.value, p.given) for p in mechanism.parameters if p.dependent)
    for name, formula, span in (*named, *((k.name, k.value, k.span) for k in mechanism.lets)):
        if formula is None or not symbols(formula) <= values.keys():
            continue
        if not math.isfinite(evaluate(formula, values)):
            yield messages.let_without_value(span, name)


def _of_no_size(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the loads that are given as zero, and not by what has a range to go through."""
    names = {load.name for load in mechanism.loads}
    ranged = {p.name for p in mechanism.parameters if p.range}
    values = {name: value for name, value in values.items() if name not in ranged}
    for let in mechanism.lets:
        if let.name in names and _is_zero(let.value, values):
            yield messages.of_no_size(let.span, f"load '{let.name}'")
    for load in mechanism.loads:
        if load.tie is not None and _is_zero(load.tie, values):
            yield messages.of_no_size(load.span, f"load '{load.name}'")


def _is_zero(formula: Formula, values: Values) -> bool:
    """Return whether a formula is zero whatever the loads and lengths that it rests on."""
    return evaluate(formula, dict.fromkeys(symbols(formula), SOME) | dict(values)) == 0


# ------------------------------------------------------------- loads that are friction


def _standing_for_friction(mechanism: Mechanism, values: Values) -> Iterator[Diagnostic]:
    """Yield the forces that are a share of another one at the same point, and across it."""
    forces = {load.name: load for load in mechanism.loads if isinstance(load, Force)}
    for load in forces.values():
        shares = symbols(load.tie) if load.tie and not load.spread else frozenset()
        pressing = [forces[name] for name in shares & forces.keys()]
        if len(pressing) != 1 or len(shares) == 1 or pressing[0].point != load.point:
            continue
        if _is_across(load.along, pressing[0].along, values):
            yield messages.keeps_its_arrow(load.span, load.name, pressing[0].name)


def _is_across(one: Direction, other: Direction, values: Values) -> bool:
    """Return whether two directions are known to be square to one another."""
    match one, other:
        case Absolute(angle), Absolute(against):
            if not symbols(angle) | symbols(against) <= values.keys():
                return False
            return (
                abs(math.cos(evaluate(angle, values) - evaluate(against, values))) < SAME_DIRECTION
            )
        case Along(tail, head, quarter), Along(start, end, turned):
            return {tail, head} == {start, end} and (quarter - turned) % 2 == 1
        case _:
            return False
