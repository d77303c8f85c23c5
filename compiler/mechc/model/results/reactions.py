"""Forces at joints that are asked for: ``R_O``, ``R_B on AB``, ``N_AB``, ``N_A``."""

from collections.abc import Collection, Iterator

from ...diagnostics.model import circular_slots, spread_loads
from ...diagnostics.model import reactions as messages
from ...syntax import ast
from ...units import ANGLE, FORCE, Dimension
from ..mechanism import (
    Axial,
    ComponentPart,
    Force,
    Link,
    Mechanism,
    Normal,
    Reaction,
    ResultTarget,
    Slider,
)
from ..names.forms import ReservedName
from ..names.scope import NameScope
from ..parts.friction import PinFriction, RopeFriction

Ending = tuple[str, ResultTarget, Dimension]
"""The end of a result's name, what it is and what it measures."""

PARTS: tuple[tuple[str, ComponentPart, Dimension], ...] = (
    ("_x", "x", FORCE),
    ("_y", "y", FORCE),
    ("", "size", FORCE),
    ("_direction", "direction", ANGLE),
)


def read_reaction(
    symbol: ast.Symbol, form: ReservedName, on: ast.Name | None, scope: NameScope
) -> tuple[Ending, ...]:
    """Return the results that one such ``find`` asks for; none where an error was reported.

    A force on a pin is four: its components, its size, and its direction.
    """
    name = ast.Name("".join(form.points), symbol.span)
    if not scope.points.acting(name):
        return ()
    if form.prefix == "R":
        return tuple(_force(symbol, form.points[0], on, scope))
    if on:
        scope.report.add(messages.link_named_for_nothing(on.span))
        return ()
    normal = len(form.points) == 1
    target = _normal(symbol, form.points[0], scope) if normal else _axial(symbol, name, scope)
    return (("", target, FORCE),) if target else ()


def _force(
    symbol: ast.Symbol, point: str, on: ast.Name | None, scope: NameScope
) -> Iterator[Ending]:
    """Yield components, size and direction of the force at a pin, on a link or of the ground."""
    held = scope.points
    if on is None and point not in held.fixed | held.guided:
        links = [link.name for link in held.carried.get(point, [])]
        scope.report.add(messages.on_which_link(symbol.span, point, links))
        return
    link = held.link(on) if on else None
    if on and (link is None or not _meets_something(symbol, point, link, scope)):
        return
    for suffix, part, dimension in PARTS:
        yield suffix, Reaction(point, link.name if link else "", part), dimension


def _meets_something(symbol: ast.Symbol, point: str, link: Link, scope: NameScope) -> bool:
    """Return whether a link has the point, and anything else there to press on it."""
    points = scope.points
    if point not in link.points:
        scope.report.add(messages.point_of_another(symbol.span, point, link.name))
        return False
    bodies = [*points.slides, *points.telescopes]
    joined = len(points.carried[point]) > 1 or any(point in ends for ends in bodies)
    if not joined and point not in points.fixed | points.guided | points.touching.keys():
        fall = next(("".join(sorted(ends)) for ends in points.falls if point in ends), "")
        scope.report.add(messages.no_joint(symbol.span, point, link.name, fall))
        return False
    return True


def _axial(symbol: ast.Symbol, name: ast.Name, scope: NameScope) -> ResultTarget | None:
    """Return the force along a rod or a fall of a rope; None for other bodies, reported."""
    ends = scope.points.split(name) or ()
    rods = [link for link in scope.points.links.values() if {*link.points} == {*ends}]
    pin = next((p for p in ends if p in scope.points.arcs), None)
    if pin and not rods:
        return _in_arc(symbol, pin, ends, scope)
    ropes = scope.points.falls.get(frozenset(ends), [])
    if len(ropes) == 1 and not rods:
        return Axial(ropes[0], ends[0], ends[1])
    link = scope.points.link(name)
    if link is None:
        return None
    tail, head, *more = scope.points.split(name) or ()
    if more or len(link.points) > 2:
        scope.report.add(messages.not_a_rod(symbol.span, link.name, len(link.points), tail))
        return None
    return Axial(link.name, tail, head)


def _in_arc(
    symbol: ast.Symbol, pin: str, ends: tuple[str, ...], scope: NameScope
) -> ResultTarget | None:
    """Return the force between a pin and the centre of its circular slot."""
    centre = scope.points.centre(pin)
    if centre is None:
        return None  # what is wrong is reported at the slot
    if set(ends) != {pin, centre}:
        scope.report.add(circular_slots.normal_of_arc(symbol.span, pin, centre))
        return None
    return Axial(f"{centre}{pin}", ends[0], ends[1], slot=pin)


def check_rods(mechanism: Mechanism, scope: NameScope) -> None:
    """Report rods that loads act on at both ends: the force along them is not that of a pin."""
    on = {end for load in mechanism.loads for end in load.ends}
    sliding = {j.joint for j in mechanism.friction.joints if isinstance(j, RopeFriction)}
    spread = {k.spread.link for k in mechanism.loads if isinstance(k, Force) and k.spread}
    for find in mechanism.finds:
        match find.target:
            case Axial(link) if link in spread:
                scope.report.add(spread_loads.spread_along_rod(find.span, link))
            case Axial(rope, tail, head) if rope in sliding:
                pulling = _pulling((tail, head), mechanism)
                fall = f"{tail}{head}"
                scope.report.add(messages.tension_of_sliding_rope(find.span, fall, pulling))
            case Axial(link, tail, head) if {(link, tail), (link, head)} <= on:
                scope.report.add(messages.loaded_at_both_ends(find.span, link))


def _pulling(ends: Collection[str], mechanism: Mechanism) -> list[str]:
    """Return the loads of no given size that act at the ends of a fall."""
    given = {let.name for let in mechanism.lets}
    loads = (load for load in mechanism.loads if isinstance(load, Force) and load.name not in given)
    return [load.name for load in loads if load.point in ends]


def warn_of_shared_pivots(mechanism: Mechanism, scope: NameScope) -> None:
    """Warn of forces of the ground where several links, or those of both halves, share a pivot."""
    for find in mechanism.finds:
        match find.target:
            case Reaction(point, "", "size") if point in mechanism.fixed:
                links = [link.name for link in mechanism.links if point in link.points]
                if len(links) > 1 or (links and point in mechanism.shared):
                    scope.report.add(messages.force_of_the_ground(find.span, point, links))


def warn_of_loads_on_pins(mechanism: Mechanism, scope: NameScope) -> None:
    """Warn of loads at a shared pin on no link, where the force of the pin on one is asked for.

    Where the pin has friction W540 says so.
    """
    rough = {f.point for f in mechanism.friction.joints if isinstance(f, PinFriction)}
    asked = {
        (target.point, target.link): find.span
        for find in reversed(mechanism.finds)
        if isinstance(target := find.target, Reaction) and target.link
    }
    for (point, link), span in asked.items():
        others = [k.name for k in mechanism.links if point in k.points and k.name != link]
        for load in mechanism.loads if others and point not in rough else ():
            if ("", point) in load.ends:
                words = span, load.name, point, link, others, load.span
                scope.report.add(messages.load_on_the_pin(*words))


def check_guides_of_copies(mechanism: Mechanism, scope: NameScope) -> None:
    """Report forces of a guide on whose slider several copies push, each from where it stands."""
    if mechanism.copies is None:
        return
    guided = {slider.point for slider in mechanism.each(Slider)}.intersection(
        mechanism.copies.sharing
    )
    for find in mechanism.finds:
        match find.target:
            case Reaction(point, "") | Normal(point) if point in guided:
                link = next((k.name for k in mechanism.links if point in k.points), "")
                scope.report.add(messages.guide_of_copies(find.span, point, link))


def _normal(symbol: ast.Symbol, point: str, scope: NameScope) -> ResultTarget | None:
    """Return the force of a guide, slot or contact on a point; report a point without one."""
    if scope.points.touching[point] > 1:
        scope.report.add(messages.several_in_contact(symbol.span, point))
        return None
    if point in scope.points.arcs:
        if centre := scope.points.centre(point):
            scope.report.add(circular_slots.normal_of_arc(symbol.span, point, centre))
        return None
    sliding = {p for points in scope.points.slides for p in points}
    if point not in scope.points.guided | scope.points.touching.keys() | sliding:
        scope.report.add(messages.nothing_normal(symbol.span, point))
        return None
    return Normal(point)
