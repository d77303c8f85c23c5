"""The forces on pins and bodies, gathered from the unknowns and loads of equilibrium."""

import math
from collections.abc import Iterable

from ..model.parts.repeated import primed
from ..pose.places import NOWHERE
from .assembly import (
    GROUND,
    Action,
    Assembly,
    Body,
    Couple,
    Cylinder,
    Plane,
    PointForce,
    Transfer,
    Wrench,
    scaled,
)
from .diagram import Acting, Kind
from .free_bodies import Unknown
from .surfaces import Pair

AXES = {"x": Plane(1.0, 0.0), "y": Plane(0.0, 1.0)}

Bearing = tuple[str, str]
"""A pin or slide, and what holds it there against teeth, a belt or a thread."""


def _plus(first: Acting, second: Acting) -> Acting:
    force = first.force.plus(second.force) if first.force and second.force else None
    moment = first.moment + second.moment
    return first._replace(force=force, moment=moment, gap=first.gap or second.gap)


class Acts:
    """The forces on pins, and directly on bodies, as the equations have them."""

    def __init__(self, assembly: Assembly) -> None:
        translating = [slide.body for slide in assembly.slides]
        self.assembly = assembly
        self.slides = {slide.body.name: slide for slide in assembly.slides}
        telescopes = [_whole(cylinder) for cylinder in assembly.cylinders]
        self.frames = {b.name: b for b in (*assembly.bodies, *translating, *telescopes)}
        self.parts = {c.part(p): (c.name, p) for c in assembly.cylinders for p in c.ends}
        self.cylinders = {cylinder.name for cylinder in assembly.cylinders}
        self.guides = {guide.point: guide.along for guide in assembly.guides}
        self.normals = {(r.point, r.body): r.normal for r in assembly.contacts}
        self.transfers = {transfer.name: transfer for transfer in assembly.transfers}
        self.on_pins: dict[str, dict[tuple[Kind, str], Acting]] = {}
        self.on_bodies: dict[str, list[Acting]] = {name: [] for name in self.frames}

    # ------------------------------------------------------------------ what is found

    def unknown(self, unknown: Unknown, size: float | None) -> None:
        """Let an unknown act that equilibrium gives, or leaves open."""
        by, on, component = unknown
        if by in self.cylinders and not on:
            return  # what the parts of a telescope do to one another
        match component:
            case "x" | "y":
                self._pin("ground" if by == "ground" else "pin", by, on, AXES[component], size)
            case "tension":
                self._tension(self.frames[by], size)
            case "slot" | "contact":
                normal = self.normals[on, by]
                self._pin(component, by, on, normal, size)
                self._body(by, _acting(component, on, on, normal.times(-1), size))
            case "transfer":
                self._transfer(self.transfers[by], size)
            case "couple":
                first = self._first(on)
                self._body(on, _acting("guide", "ground", first, NOWHERE, size, 1.0))
            case _ if on in self.slides:
                across = self.slides[on].along.turned()
                self._body(on, _acting("guide", "ground", self._first(on), across, size))
            case _:
                self._pin("guide", "ground", on, self.guides[on].turned(), size)

    def _tension(self, rod: Body, size: float | None) -> None:
        (tail, a), (head, b) = rod.points.items()
        along = b.minus(a).unit() or NOWHERE
        self._pin("pin", rod.name, tail, along, size)
        self._pin("pin", rod.name, head, along.times(-1), size)

    def _first(self, body: str) -> str:
        return next(iter(self.frames[body].points))

    # ---------------------------------------------------------------------- what is put on

    def load(self, name: str, size: float, pair: Pair | None) -> None:
        """Let a load act, or friction between a pair of surfaces."""
        actions = [scaled(action, size) for action in self.assembly.loads[name]]
        match pair.kind if pair else "":
            case "pin" if pair:
                for action in actions:
                    self._friction_at_pin(action, pair.on)
            case "face":
                for push, back in zip(actions[::2], actions[1::2], strict=True):
                    self._exchange("friction", (push, back), 1.0)
            case "guide":
                for action in actions:
                    self._alone("friction", "ground", action)
            case "transmission":
                for action in actions:
                    self._alone("friction", "", action)
            case "rope" if pair:
                for action in actions:
                    self._from_rope(self.transfers[pair.by].label, action)
            case _:
                for action in actions:
                    self._alone("load", name, action)

    def _friction_at_pin(self, action: Action, point: str) -> None:
        assert isinstance(action, Couple)
        body, on = self.parts.get(action.body, (action.body, point))
        on = on if on in self.frames[body].points else primed(on)
        self._pin("pin", body, on, NOWHERE, 0.0, -action.moment)

    def _transfer(self, transfer: Transfer, size: float | None) -> None:
        """Let two things act on each other, or a rope on all that it runs over."""
        if transfer.kind != "rope":
            self._exchange(transfer.kind, transfer.actions, size)
            return
        for action in transfer.actions:
            self._alone(transfer.kind, transfer.label, action, size)

    def _from_rope(self, rope: str, action: Action) -> None:
        """Let a rope that slides pull more or less than its mean tension, and turn a drum."""
        if isinstance(action, PointForce):
            self._alone("rope", rope, action)
        else:
            self._alone("friction", "", action)

    def _exchange(self, kind: Kind, actions: tuple[Action, ...], size: float | None) -> None:
        """Let two things act on each other."""
        first, second = actions
        for action, other in (first, second), (second, first):
            self._alone(kind, _target(other), action, size, _point(other))

    def _alone(
        self, kind: Kind, by: str, action: Action, size: float | None = 1.0, at: str = ""
    ) -> None:
        """Let something act; a wrench on a body is a force ``at`` the pin where bodies touch."""
        match action:
            case PointForce(point, force):
                self._pin(kind, by, point, force, size)
            case Couple(body) if body == GROUND:
                pass
            case Couple(body, moment):
                self._body(body, _acting(kind, by, "", NOWHERE, size, moment))
            case Wrench(body, force, moment) if body in self.parts:
                body, point = self.parts[body]
                self._body(body, _acting(kind, by, point, force, size, moment))
            case Wrench(body, force, moment):
                if kind == "friction":
                    self._body(body, _acting(kind, by, at, force, size))
                else:
                    first = self._first(body)
                    self._body(body, _acting(kind, by, first, force, size, moment))

    def _pin(
        self, kind: Kind, by: str, on: str, along: Plane, size: float | None, moment: float = 0.0
    ) -> None:
        acts = self.on_pins.setdefault(on, {})
        new = _acting(kind, by, on, along, size)._replace(moment=moment)
        acts[kind, by] = _plus(acts[kind, by], new) if (kind, by) in acts else new

    def _body(self, name: str, acting: Acting) -> None:
        alike = (acting.kind, acting.by, acting.point)
        acts = self.on_bodies[name]
        for i, there in enumerate(acts):
            if (there.kind, there.by, there.point) == alike:
                acts[i] = _plus(there, acting)
                return
        acts.append(acting)

    # ------------------------------------------------------------------ what follows

    def balance_couples(self) -> None:
        """Let what holds a pin take the friction of all that turns on it."""
        for acts in self.on_pins.values():
            rest = math.fsum(acting.moment for acting in acts.values())
            holding = [key for key in acts if key[0] in ("ground", "guide")]
            holding += [key for key in acts if key[1] in self.slides]
            if rest and holding:
                kind, by = holding[0]
                acts[kind, by] = acts[kind, by]._replace(moment=acts[kind, by].moment - rest)
                if by in self.slides:
                    first = self._first(by)
                    self._body(by, Acting("guide", "ground", first, NOWHERE, -rest))

    def forget(self, bearings: Iterable[Bearing]) -> None:
        """Leave out forces of which teeth, belts or threads make an undetermined part."""
        for place, by in bearings:
            acts = self.on_pins.get(place, {})
            for key in [key for key in acts if key[1] == by]:
                acts[key] = acts[key]._replace(force=None, moment=0.0, gap="transmission")
            for i, acting in enumerate(self.on_bodies.get(place, [])):
                if acting.by == by:
                    there = acting._replace(force=None, moment=0.0, gap="transmission")
                    self.on_bodies[place][i] = there


def _whole(cylinder: Cylinder) -> Body:
    """Return a telescope as one body, as it is drawn: what its parts do to each other is inside."""
    first, second = cylinder.ends
    return Body(cylinder.name, {first: NOWHERE, second: cylinder.along.times(cylinder.reach)})


def _target(action: Action) -> str:
    return action.point if isinstance(action, PointForce) else action.body


def _point(action: Action) -> str:
    return action.point if isinstance(action, PointForce) else ""


def _acting(
    kind: Kind, by: str, point: str, along: Plane, size: float | None, moment: float = 0.0
) -> Acting:
    if size is None:
        return Acting(kind, by, point, None, 0.0, "indeterminate")
    return Acting(kind, by, point, along.times(size), moment * size)
