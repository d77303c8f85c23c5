"""The forces on pins and bodies, gathered from the unknowns and loads of equilibrium."""

import math
from collections.abc import Iterable, Iterator

from ..base.named import NamedTuple
from ..model.parts.linkage import primed
from ..pose.places import NOWHERE
from .assembly import (
    GROUND,
    Action,
    AssembledBodies,
    Couple,
    Cylinder,
    Plane,
    PointForce,
    RigidBody,
    Transfer,
    Wrench,
    scaled,
)
from .diagrams.diagram import Acting, ActionKind
from .equations import UnknownForce
from .surfaces import FrictionSurfaces
from .transfers import PinOnLink

AXES = {"x": Plane(1.0, 0.0), "y": Plane(0.0, 1.0)}


class Members:
    """The parts of an assembly by their names, and the directions in which they hold pins."""

    def __init__(self, assembly: AssembledBodies) -> None:
        translating = [slide.body for slide in assembly.slides]
        telescopes = [_whole(cylinder) for cylinder in assembly.cylinders]
        self.loads = assembly.loads
        self.slides = {slide.body.name: slide for slide in assembly.slides}
        self.frames = {b.name: b for b in (*assembly.bodies, *translating, *telescopes)}
        self.parts = {c.part(p): (c.name, p) for c in assembly.cylinders for p in c.ends}
        self.cylinders = {cylinder.name for cylinder in assembly.cylinders}
        self.guides = {guide.point: guide.along for guide in assembly.guides}
        self.normals = {(r.point, r.body): r.normal for r in assembly.contacts}
        self.transfers = {transfer.name: transfer for transfer in assembly.transfers}

    def first(self, body: str) -> str:
        """Return the first point of a body."""
        return next(iter(self.frames[body].points))


class OnPin(NamedTuple):
    """A force on a pin."""

    pin: str
    acting: Acting


class OnBody(NamedTuple):
    """A force or a couple directly on a body."""

    body: str
    acting: Acting


class Actions:
    """The forces on pins, and directly on bodies, as the equations have them."""

    def __init__(self, assembly: AssembledBodies) -> None:
        self.assembly, self.members = assembly, Members(assembly)
        self.on_pins: dict[str, dict[tuple[ActionKind, str], Acting]] = {}
        self.on_bodies: dict[str, list[Acting]] = {name: [] for name in self.members.frames}

    def unknown(self, unknown: UnknownForce, size: float | None) -> None:
        """Let an unknown act that equilibrium gives, or leaves open."""
        self._take(_of_unknown(unknown, size, self.members))

    def load(self, name: str, size: float, pair: FrictionSurfaces | None) -> None:
        """Let a load act, or friction between a pair of surfaces."""
        self._take(_of_load(name, size, pair, self.members))

    def balance_couples(self) -> None:
        """Let what holds a pin take the friction of all that turns on it."""
        slides = self.members.slides
        for actions in self.on_pins.values():
            rest = math.fsum(acting.moment for acting in actions.values())
            holding = [key for key in actions if key[0] in ("ground", "guide")]
            holding += [key for key in actions if key[1] in slides]
            if rest and holding:
                kind, by = holding[0]
                actions[kind, by] = actions[kind, by]._replace(
                    moment=actions[kind, by].moment - rest
                )
                if by in slides:
                    first = self.members.first(by)
                    self._on_body(by, Acting("guide", "ground", first, NOWHERE, -rest))

    def forget(self, bearings: Iterable[PinOnLink]) -> None:
        """Leave out forces of which teeth, belts or threads make an undetermined part."""
        for place, by in bearings:
            actions = self.on_pins.get(place, {})
            for key in [key for key in actions if key[1] == by]:
                actions[key] = actions[key]._replace(force=None, moment=0.0, gap="transmission")
            for i, acting in enumerate(self.on_bodies.get(place, [])):
                if acting.by == by:
                    there = acting._replace(force=None, moment=0.0, gap="transmission")
                    self.on_bodies[place][i] = there

    def _take(self, found: Iterable[OnPin | OnBody]) -> None:
        """Add forces to those that act already; two of one kind and cause are one."""
        for each in found:
            match each:
                case OnPin(pin, acting):
                    actions = self.on_pins.setdefault(pin, {})
                    cause = acting.kind, acting.by
                    actions[cause] = _plus(actions[cause], acting) if cause in actions else acting
                case OnBody(body, acting):
                    self._on_body(body, acting)

    def _on_body(self, name: str, acting: Acting) -> None:
        alike = (acting.kind, acting.by, acting.point)
        actions = self.on_bodies[name]
        for i, there in enumerate(actions):
            if (there.kind, there.by, there.point) == alike:
                actions[i] = _plus(there, acting)
                return
        actions.append(acting)


def _plus(first: Acting, second: Acting) -> Acting:
    force = first.force.plus(second.force) if first.force and second.force else None
    moment = first.moment + second.moment
    return first._replace(force=force, moment=moment, gap=first.gap or second.gap)


# -------------------------------------------------------------------- what is found


def _of_unknown(
    unknown: UnknownForce, size: float | None, members: Members
) -> Iterator[OnPin | OnBody]:
    """Yield the forces that an unknown is; none of what the parts of a telescope do to another."""
    by, on, component = unknown
    if by in members.cylinders and not on:
        return
    match component:
        case "x" | "y":
            yield _on_pin("ground" if by == "ground" else "pin", by, on, AXES[component], size)
        case "tension":
            yield from _tension(members.frames[by], size)
        case "slot" | "contact":
            normal = members.normals[on, by]
            yield _on_pin(component, by, on, normal, size)
            yield OnBody(by, _acting(component, on, on, normal.times(-1), size))
        case "transfer":
            yield from _of_transfer(members.transfers[by], size, members)
        case "couple":
            yield OnBody(on, _acting("guide", "ground", members.first(on), NOWHERE, size, 1.0))
        case _ if on in members.slides:
            across = members.slides[on].along.turned()
            yield OnBody(on, _acting("guide", "ground", members.first(on), across, size))
        case _:
            yield _on_pin("guide", "ground", on, members.guides[on].turned(), size)


def _tension(rod: RigidBody, size: float | None) -> Iterator[OnPin]:
    (tail, a), (head, b) = rod.points.items()
    along = b.minus(a).unit() or NOWHERE
    yield _on_pin("pin", rod.name, tail, along, size)
    yield _on_pin("pin", rod.name, head, along.times(-1), size)


def _of_transfer(
    transfer: Transfer, size: float | None, members: Members
) -> Iterator[OnPin | OnBody]:
    """Yield what two things do to each other, or a rope to all that it runs over."""
    if transfer.kind != "rope":
        yield from _exchange(transfer.kind, transfer.actions, members, size)
        return
    for action in transfer.actions:
        yield from _alone(transfer.kind, transfer.label, action, members, size)


# ------------------------------------------------------------------- what is put on


def _of_load(
    name: str, size: float, pair: FrictionSurfaces | None, members: Members
) -> Iterator[OnPin | OnBody]:
    """Yield the forces that a load is, or the friction between a pair of surfaces."""
    actions = [scaled(action, size) for action in members.loads[name]]
    match pair.kind if pair else "":
        case "pin" if pair:
            yield from (_friction_at_pin(action, pair.on, members) for action in actions)
        case "face":
            for push, back in zip(actions[::2], actions[1::2], strict=True):
                yield from _exchange("friction", (push, back), members)
        case "guide":
            for action in actions:
                yield from _alone("friction", "ground", action, members)
        case "transmission":
            for action in actions:
                yield from _alone("friction", "", action, members)
        case "rope" if pair:
            for action in actions:
                yield from _from_rope(members.transfers[pair.by].label, action, members)
        case _:
            for action in actions:
                yield from _alone("load", name, action, members)


def _friction_at_pin(action: Action, point: str, members: Members) -> OnPin:
    assert isinstance(action, Couple)
    body, on = members.parts.get(action.body, (action.body, point))
    on = on if on in members.frames[body].points else primed(on)
    return _on_pin("pin", body, on, NOWHERE, 0.0, -action.moment)


def _from_rope(rope: str, action: Action, members: Members) -> Iterator[OnPin | OnBody]:
    """Yield the pull of a rope beyond its mean tension where it slides, and what turns a drum."""
    if isinstance(action, PointForce):
        yield from _alone("rope", rope, action, members)
    else:
        yield from _alone("friction", "", action, members)


def _exchange(
    kind: ActionKind, actions: tuple[Action, ...], members: Members, size: float | None = 1.0
) -> Iterator[OnPin | OnBody]:
    """Yield what two things do to each other."""
    first, second = actions
    for action, other in (first, second), (second, first):
        yield from _alone(kind, _target(other), action, members, size, _point(other))


def _alone(
    kind: ActionKind,
    by: str,
    action: Action,
    members: Members,
    size: float | None = 1.0,
    at: str = "",
) -> Iterator[OnPin | OnBody]:
    """Yield an action; a wrench on a body is a force ``at`` the pin where bodies touch."""
    match action:
        case PointForce(point, force):
            yield _on_pin(kind, by, point, force, size)
        case Couple(body) if body == GROUND:
            pass
        case Couple(body, moment):
            yield OnBody(body, _acting(kind, by, "", NOWHERE, size, moment))
        case Wrench(body, force, moment) if body in members.parts:
            body, point = members.parts[body]
            yield OnBody(body, _acting(kind, by, point, force, size, moment))
        case Wrench(body, force) if kind == "friction":
            yield OnBody(body, _acting(kind, by, at, force, size))
        case Wrench(body, force, moment):
            first = members.first(body)
            yield OnBody(body, _acting(kind, by, first, force, size, moment))


def _on_pin(
    kind: ActionKind, by: str, on: str, along: Plane, size: float | None, moment: float = 0.0
) -> OnPin:
    return OnPin(on, _acting(kind, by, on, along, size)._replace(moment=moment))


def _whole(cylinder: Cylinder) -> RigidBody:
    """Return a telescope as one body, as it is drawn: what its parts do to each other is inside."""
    first, second = cylinder.ends
    return RigidBody(cylinder.name, {first: NOWHERE, second: cylinder.along.times(cylinder.reach)})


def _target(action: Action) -> str:
    return action.point if isinstance(action, PointForce) else action.body


def _point(action: Action) -> str:
    return action.point if isinstance(action, PointForce) else ""


def _acting(
    kind: ActionKind, by: str, point: str, along: Plane, size: float | None, moment: float = 0.0
) -> Acting:
    if size is None:
        return Acting(kind, by, point, None, 0.0, "indeterminate")
    return Acting(kind, by, point, along.times(size), moment * size)
