"""What can be meant, and hardly ever is: remarks on values, bodies and the drive."""

import math
from collections.abc import Iterator, Sequence, Set

from ...diagnostics import Diagnostic
from ...diagnostics.model import doubts as messages
from ...diagnostics.model import sizes
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, Symbol
from ...formula.walk import reached, symbols
from ...source import Span
from ..entries import body_through
from ..mechanism import (
    Absolute,
    AlongLine,
    Axial,
    Direction,
    Find,
    Force,
    Link,
    LoadForm,
    LoadRatio,
    Mechanism,
    Offset,
    Pivot,
    Rack,
    Slider,
    WheelPair,
)
from ..tolerances import SAME_DIRECTION
from ..values import Values, defaults, following, user_defined
from .sizes import beyond_a_turn, far_off, vanishing_lengths

SOME = 0.731
"""A value for what is open, at which no formula vanishes by chance."""


def doubts(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield a remark on each thing that is hardly meant."""
    chain = following(mechanism)
    values = chain.complete(defaults(mechanism))
    yield from beyond_a_turn(mechanism)
    yield from vanishing_lengths(mechanism, chain, values)
    yield from far_off(mechanism, values)
    yield from _asked_twice(mechanism)
    yield from _both_given(mechanism)
    yield from _coinciding(mechanism, values)
    yield from _within(mechanism.links)
    yield from _of_ground(mechanism)
    yield from _along_a_link(mechanism)
    yield from _held(mechanism)
    yield from _idle(mechanism)
    yield from _without_value(mechanism, values)
    yield from _of_no_size(mechanism, values)
    if mechanism.friction.joints:
        yield from _standing_for_friction(mechanism, values)


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
    """Yield the links that two pivots hold, but for those of wheels, which may be on one axis.

    A pivot that a held drive has put there is none of the description.
    """
    wheels = {p for j in mechanism.joints if isinstance(j, WheelPair | Rack) for p in j.points}
    drives = {drive.span for drive in mechanism.held}
    fixed = mechanism.fixed - {p.point for p in mechanism.each(Pivot) if p.span in drives}
    for link in mechanism.links:
        held = [point for point in link.points if point in fixed - wheels]
        if set(link.points) <= fixed:
            yield messages.link_of_ground(link.span, link.name)
        elif len(held) > 1:
            yield messages.link_of_ground(link.span, link.name, held)


def _along_a_link(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the guides whose direction is that of a link that moves: they stand still."""
    for slider in mechanism.each(Slider):
        along = slider.along
        if not isinstance(along, AlongLine) or along.quarter % 2:
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


def _idle(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the telescopes in which nothing acts, where forces are looked at."""
    if not any(isinstance(find.target, LoadForm | LoadRatio) for find in mechanism.finds):
        return
    acting = [set(load.points) for load in mechanism.loads]
    for telescope in mechanism.telescopes:
        is_held = bool(body_through(telescope.points, mechanism))
        if set(telescope.points) not in acting and not is_held:
            yield messages.idle_telescope(telescope.span, telescope.name)


# --------------------------------------------------------------- what is asked for


def _asked_twice(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the first result of each line that an earlier line asks for, not what it brings on."""
    first: dict[object, Find] = {}
    reported: set[Span] = set()
    rods = {link.name for link in mechanism.links}
    for find in mechanism.finds:
        other = first.setdefault(_without_sense(find.target, rods), find)
        if other.name != find.name and find.span not in reported:
            reported.add(find.span)
            yield messages.asked_twice(find.span, find.name, other.name, other.span)


def _without_sense(target: object, rods: Set[str]) -> object:
    """Return a target; the force along a rod is one, N_BA that of N_AB, unlike that in a rope."""
    match target:
        case Axial(link=link) if link in rods:
            return Axial, link
        case _:
            return target


def _both_given(mechanism: Mechanism) -> Iterator[Diagnostic]:
    """Yield the ratios both of whose loads have values: one of these follows from the other."""
    formulas = user_defined(mechanism)
    spans = {let.name: let.span for let in mechanism.lets}
    for find in mechanism.finds:
        match find.target:
            case LoadRatio(above=above, below=below) if {above, below} <= formulas.keys():
                known = {**formulas, find.name: Symbol(find.name)}
                if find.name not in reached((above, below), known):
                    place = spans[above], find.name, above, below, find.span
                    yield messages.both_given(*place)


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
            yield sizes.of_no_size(let.span, f"load '{let.name}'")
    for load in mechanism.loads:
        if load.tie is not None and _is_zero(load.tie, values):
            yield sizes.of_no_size(load.span, f"load '{load.name}'")


def _is_zero(formula: Formula, values: Values) -> bool:
    """Return whether a formula is zero whatever the loads and lengths that it rests on."""
    return evaluate(formula, dict.fromkeys(symbols(formula), SOME) | dict(values)) == 0


# --------------------------------------------------------- loads that are friction


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
        case AlongLine(tail, head, quarter), AlongLine(start, end, turned):
            return {tail, head} == {start, end} and (quarter - turned) % 2 == 1
        case _:
            return False
