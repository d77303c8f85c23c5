"""From a solution of the equations of equilibrium to free bodies with all that acts on them.

Equilibrium is written for links and pins. Where a pin joins two links and nothing else acts
on it, or one link alone carries it, people draw no pin: it is merged into the links.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ...base.frozen import frozen, replace
from ..actions import Actions
from ..assembly import AssembledBodies
from ..equations import EquilibriumSystem
from ..surfaces import FrictionSurfaces
from ..tolerances import VANISHED
from ..transfers import PinOnLink
from .diagram import Acting, FreeBody, Plane

PointPositions = Mapping[str, Plane]
"""Where points are drawn."""


@frozen
class StaticsSolution:
    """Equations of equilibrium with all that was found.

    ``found`` are the unknowns, of which those of the columns ``open`` may be anything.
    ``sizes`` are those of the loads that act, friction's among them; ``frictions`` says which
    these are. ``bearings`` are where teeth, belts or threads press besides. ``common`` are
    the points that copies share, and hold by their side forces.
    """

    assembly: AssembledBodies
    system: EquilibriumSystem
    found: Sequence[float]
    open: frozenset[int]
    sizes: Mapping[str, float]
    frictions: Mapping[str, FrictionSurfaces]
    bearings: frozenset[PinOnLink]
    common: frozenset[str]

    def times(self, factor: float) -> "StaticsSolution":
        """Return the solution under loads so many times as large."""
        found = [factor * x for x in self.found]
        sizes = {name: factor * size for name, size in self.sizes.items()}
        return replace(self, found=found, sizes=sizes)


def cut_free(solution: StaticsSolution, places: PointPositions) -> tuple[FreeBody, ...]:
    """Return every link, slide and pin that people draw, with all that acts on it.

    Forces do not depend on where slides carry their pins, but the couples of their guides do.
    These are for the ``places`` in which the points are drawn.
    """
    actions = Actions(solution.assembly)
    for column, unknown in enumerate(solution.system.unknowns):
        actions.unknown(unknown, None if column in solution.open else solution.found[column])
    for name, size in solution.sizes.items():
        actions.load(name, size, solution.frictions.get(name))
    actions.balance_couples()
    actions.forget(solution.bearings)
    bodies = [_with_forces_of_branches(body, solution.common) for body in _Drawn(actions).bodies()]
    frames = actions.members.frames
    for rod in (body for body in bodies if body.name in frames and frames[body.name].arc):
        bodies = list(_slotted(rod, bodies))
    return tuple(_rounded([_held(body, places) for body in bodies]))


def sizes_beyond_rounding(
    solution: StaticsSolution, bodies: Sequence[FreeBody], torques: Set[str], places: PointPositions
) -> dict[str, float]:
    """Return the sizes of loads, those as 0 of which nothing but rounding is left.

    A force is measured by the largest one that acts, a torque by what that has for a moment.
    """
    acting = [a for body in bodies for a in body.forces]
    largest = max((math.hypot(*a.force) for a in acting if a.force), default=0.0)
    used = [places[a.point] for a in acting if a.point in places]
    span = max((math.dist(one, other) for one in used for other in used), default=0.0)
    couple = max((abs(a.moment) for a in acting), default=0.0)
    least = {True: VANISHED * max(largest * span, couple), False: VANISHED * largest}
    return {n: s if abs(s) > least[n in torques] else 0.0 for n, s in solution.sizes.items()}


def _with_forces_of_branches(body: FreeBody, common: Set[str]) -> FreeBody:
    """Return a body on which the other branches exert the forces at points that all have.

    In the plane of one branch these are forces of a guide.
    """
    forces = (
        a._replace(by="branches") if a.kind == "guide" and a.point in common else a
        for a in body.forces
    )
    return body._replace(forces=tuple(forces))


def _slotted(rod: FreeBody, bodies: Iterable[FreeBody]) -> Iterator[FreeBody]:
    """Yield the bodies without the rod of a circular slot: the wall and the pin push each other.

    The force on the rod's centre and the couple of its friction there are, together, what the
    wall does at the place of the pin.
    """
    centre, pin = rod.forces
    for body in bodies:
        touching = {centre.by: pin.by, pin.by: centre.by}.get(body.name, "")
        forces = (
            a._replace(kind="slot", by=touching, point=pin.point, moment=0.0)
            if a.by == rod.name
            else a
            for a in body.forces
        )
        if body is not rod:
            yield body._replace(forces=tuple(forces))


def _rounded(bodies: Sequence[FreeBody]) -> Iterator[FreeBody]:
    """Yield bodies with zeros where a force is only rounding, relative to the others.

    So are couples of friction at pins, relative to those with forces that are more than that.
    """
    acting = [a for body in bodies for a in body.forces if a.force]
    least = VANISHED * max((math.hypot(*a.force) for a in acting if a.force), default=0.0)
    pins = [a for a in acting if a.kind == "pin" and a.force and math.hypot(*a.force) > least]
    couple = VANISHED * max((abs(a.moment) for a in pins), default=math.inf)
    for body in bodies:
        yield body._replace(forces=tuple(_clean(acting, least, couple) for acting in body.forces))


def _clean(acting: Acting, least: float, couple: float) -> Acting:
    """Return an action with a rounded zero as 0, and so the couple of a pin without a force.

    A pin passes on what others rub on it, whether or not it passes on a force.
    """
    force = acting.force
    if force is None:
        return acting
    force = Plane(*(part if abs(part) > least else 0.0 for part in force))
    stays = any(force) or acting.kind != "pin" or abs(acting.moment) > couple
    return acting._replace(force=force, moment=(acting.moment if stays else 0.0) + 0.0)


def _held(body: FreeBody, places: PointPositions) -> FreeBody:
    """Return a slide with the couple of its guide that keeps it from turning."""
    known = all(acting.force is not None for acting in body.forces)
    holding = next((i for i, a in enumerate(body.forces) if a.kind == "guide"), None)
    if body.kind != "slide" or holding is None or not known:
        return body
    forces = list(body.forces)
    start = places[forces[holding].point]
    others = [a for a in forces if a.kind != "guide"]
    couple = -math.fsum(a.about(start, places) for a in others)
    small = abs(couple) <= VANISHED * max((_reach(a, start, places) for a in others), default=0.0)
    forces[holding] = forces[holding]._replace(moment=0.0 if small else couple)
    return body._replace(forces=tuple(forces))


def _reach(acting: Acting, centre: Plane, places: PointPositions) -> float:
    """Return the largest moment that such a force could have at its place."""
    if acting.force is None or not acting.point:
        return abs(acting.moment)
    return abs(acting.moment) + math.hypot(*acting.force) * math.dist(places[acting.point], centre)


class _Drawn:
    """The free bodies as people draw them: pins on which little acts are merged into links."""

    def __init__(self, actions: Actions) -> None:
        self.actions = actions
        self.merged = {p: by for p in actions.on_pins if (by := self._carrier(p))}

    def bodies(self) -> Iterator[FreeBody]:
        """Yield links, slides, then pins."""
        twins = self.actions.assembly.twins
        for name in self.actions.members.frames:
            direct = (self._named(a) for a in self.actions.on_bodies[name])
            at_pins = (
                a for p in self.actions.members.frames[name].points for a in self._at(p, name)
            )
            forces = (*at_pins, *direct)
            slides = name in self.actions.members.slides
            yield FreeBody(name, "slide" if slides else "link", forces, name in twins)
        for point, actions in self.actions.on_pins.items():
            free = {kind for kind, _ in actions} != {"ground"}
            if free and point not in self.merged and not self._is_plain(point):
                forces = tuple(actions.values())
                guided = point in self.actions.members.guides
                yield FreeBody(point, "slider" if guided else "pin", forces, point in twins)

    def _carriers(self, point: str) -> list[str]:
        return [by for kind, by in self.actions.on_pins[point] if kind == "pin"]

    def _carrier(self, point: str) -> str:
        """Return the only link that carries a pin, empty for one that is a body of its own."""
        carriers = self._carriers(point)
        return (
            carriers[0] if len(carriers) == 1 and point not in self.actions.members.guides else ""
        )

    def _is_plain(self, point: str) -> bool:
        """Return whether a pin joins two links and nothing else acts on it."""
        return len(self.actions.on_pins[point]) == len(self._carriers(point)) == 2

    def _at(self, point: str, body: str) -> Iterator[Acting]:
        """Yield the forces on a body at a pin."""
        actions = self.actions.on_pins.get(point, {})
        if point in self.merged:
            yield from (self._named(a) for (kind, _), a in actions.items() if kind != "pin")
        elif ("pin", body) in actions:
            carriers = self._carriers(point)
            other = next((c for c in carriers if c != body), "")
            yield _back(actions["pin", body], other if self._is_plain(point) else point)

    def _named(self, acting: Acting) -> Acting:
        """Return an action by a pin as one by the link that the pin is merged into."""
        return acting._replace(by=self.merged.get(acting.by, acting.by))


def _back(acting: Acting, by: str) -> Acting:
    """Return the reaction to what a body does to a pin."""
    force = acting.force.times(-1) if acting.force is not None else None
    return acting._replace(by=by, force=force, moment=-acting.moment)
