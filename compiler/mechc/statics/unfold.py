"""The whole mechanism at one pose, in numbers: both mirrored halves, one branch of copies.

A *mirror* is unfolded: every body, joint and load off the line has a twin, its geometry
reflected, so that the side forces on what the halves share cancel by themselves. What
stands on shared points alone exists once. Of a load there only the part that is the same
for both halves counts: a force along the line, no couple.

*Copies* are an arrangement in space around an axis, which is the guide of the points that
the branches share. By symmetry each of the n branches carries the n-th part of a load on
a shared point or body, and gives the axis only a push along it, as the pushes across it
cancel around the axis. In the plane of one branch a guide takes that cross part.
"""

import math
from collections.abc import Iterator, Mapping
from typing import assert_never

from ..formula.walk import evaluate
from ..frozen import frozen
from ..model.mechanism import (
    Contact,
    Force,
    ForcePair,
    Load,
    Pivot,
    Rack,
    Screw,
    Slider,
    Slot,
    Torque,
    WheelPair,
)
from ..pose.pose import PointContact, Pose, evaluate_vector
from .assembly import (
    GROUND,
    Action,
    Assembly,
    Body,
    Couple,
    Cylinder,
    Guide,
    JointFriction,
    Plane,
    Push,
    Transfer,
    Translation,
    Wrench,
    direction,
)
from .transfers import block, rims, teeth, thread


@frozen
class Unfolding:
    """A pose at given values of its symbols, and the ways to its twin and its copies."""

    pose: Pose
    values: Mapping[str, float]

    @property
    def _axis(self) -> Plane | None:
        axis = self.pose.axis
        return None if axis is None else direction(axis.evaluate(self.values))

    def _shared(self, name: str) -> bool:
        mirror = self.pose.mechanism.mirror
        return mirror is None or name == GROUND or self._points(name) <= set(mirror.sharing)

    def _points(self, name: str) -> set[str]:
        """Return the points of a link, or the point itself."""
        return set(self.pose.frames.get(name, (name,)))

    def _parts(self, name: str) -> float:
        """Return which part of a load there one branch of the copies takes."""
        copies = self.pose.mechanism.copies
        common = copies is not None and self._points(name) <= set(copies.sharing)
        return 1 / float(copies.number) if copies is not None and common else 1.0

    def _reflected(self, vector: Plane) -> Plane:
        axis = self._axis
        assert axis is not None
        return vector.reflected(axis)

    def _twin(self, point: str) -> str:
        return point if self._shared(point) else f"{point}'"

    def count(self, name: str) -> float:
        """Return how many times over a load on a point or link does its work."""
        return self._parts(name) * (1 if self._shared(name) else 2)

    def direction_of_guide(self, point: str) -> Plane:
        """Return the unit direction of the guide of a slider, or of a point of a slide."""
        guide = self.pose.guide_of(point)
        assert guide is not None
        return direction(guide.evaluate(self.values))

    def arm(self, link: str, tail: str, head: str) -> Plane:
        """Return the vector between two points of a link."""
        return Plane(*evaluate_vector(self.pose.vector(link, tail, head), self.values))

    def push(self, point: str, force: Plane) -> tuple[Action, ...]:
        """Return what a force on a point puts on the whole assembly."""
        share = force.times(self._parts(point))
        if not self._shared(point):
            return (Push(point, share), Push(self._twin(point), self._reflected(share)))
        return (Push(point, self._axial(share)),)

    def _axial(self, force: Plane) -> Plane:
        """Return the part of a force on what both halves share that is the same for both."""
        axis = self._axis
        return force if axis is None else axis.times(axis.dot(force))

    def on(self, link: str, point: str, force: Plane) -> tuple[Action, ...]:
        """Return what a force on a link at one of its points puts on the whole assembly.

        On what the halves share the part of it counts that is the same for both.
        """
        share = force.times(self._parts(link))
        if self._axis is not None and self._shared(link):
            share = self._axial(share)
        there = self._end(link, point, share)
        return (there,) if self._shared(link) else (there, self._mirrored(there))

    def turning(self, body: str, point: str, moment: float) -> tuple[Action, ...]:
        """Return what a couple on a link or a telescope puts on it at the pin of a point."""
        if body not in self._cylinders():
            return self.couple(body, moment)
        share = moment * self._parts(body)
        there = Couple(f"{body} at {point}", share)
        if not self._shared(body):
            return (there, self._mirrored(there))
        return (there,) if self._axis is None else ()

    def turns(self, body: str) -> bool:
        """Tell whether a body can turn: what both halves share is kept still by symmetry."""
        return self._axis is None or not self._shared(body.removesuffix("'"))

    def turning_on(self, point: str) -> Iterator[str]:
        """Yield the links and telescopes that a pin joins, but no telescope that nothing loads."""
        mechanism = self.pose.mechanism
        pairs = [load for load in mechanism.loads if isinstance(load, ForcePair)]
        loaded = [{pair.first, pair.second} for pair in pairs]
        yield from (link.name for link in mechanism.rigid_links if point in link.points)
        for telescope in mechanism.telescopes:
            if point in telescope.points and {*telescope.points} in loaded:
                yield telescope.name

    def _cylinders(self) -> set[str]:
        return {telescope.name for telescope in self.pose.mechanism.cylinders}

    def couple(self, link: str, moment: float) -> tuple[Action, ...]:
        """Return what a couple on a link puts on the whole assembly."""
        share = moment * self._parts(link)
        if not self._shared(link):
            return (Couple(link, share), Couple(f"{link}'", -share))
        return (Couple(link, share),) if self._axis is None else ()

    def _actions(self, load: Load) -> tuple[Action, ...]:
        match load:
            case Force(name, point, link=link):
                line = direction(self.pose.lines[name].evaluate(self.values))
                force = line.times(float(load.times))
                return self.on(link, point, force) if link else self.push(point, force)
            case Torque(_, link):
                return self.couple(link, float(load.times))
            case ForcePair():
                return self._pair(load)
            case _:
                assert_never(load)

    def _pair(self, load: ForcePair) -> tuple[Action, ...]:
        """Return both forces of a pair, all of them where it belongs to one half or branch.

        Across the mirror the twin's is the other one.
        """
        line = direction(self.pose.lines[load.name].evaluate(self.values))
        push = line.times(float(load.times))
        if load.second == f"{load.first}'":
            link = load.first_link
            return self.on(link, load.first, push) if link else self.push(load.first, push)
        push = push.times(max(self._parts(load.first), self._parts(load.second)))
        shared = self._shared(load.first) and self._shared(load.second)
        push = self._axial(push) if shared else push
        pair = (
            self._end(load.second_link, load.second, push),
            self._end(load.first_link, load.first, push.times(-1)),
        )
        return pair if self._axis is None or shared else (*pair, *map(self._mirrored, pair))

    def _end(self, link: str, point: str, push: Plane) -> Action:
        """Return what an end of a pair does to a pin, to a link or to a part of a telescope."""
        if not link:
            return Push(point, push)
        if link in self._cylinders():
            return Wrench(f"{link} at {point}", push, 0.0)
        arm = self.arm(link, next(iter(self.pose.frames[link])), point)
        return Wrench(link, push, arm.x * push.y - arm.y * push.x)

    def apart(self, touch: PointContact, along: Plane) -> tuple[Action, ...]:
        """Return a unit force on a pin and its reaction on the body under it, in both halves."""
        first = next(iter(self.pose.frames[touch.body]))
        base = self.arm(touch.body, first, touch.tail)
        reach = evaluate_vector(touch.reach, self.values)
        x, y = base.x + reach[0], base.y + reach[1]
        back = Wrench(touch.body, along.times(-1), y * along.x - x * along.y)
        push: tuple[Action, ...] = (Push(touch.point, along), back)
        if self._axis is None or (self._shared(touch.point) and self._shared(touch.body)):
            return push
        return (*push, *map(self._mirrored, push))

    def rim(self, joint: str) -> tuple[Action, ...]:
        """Return a unit force on the rim of a pair's first wheel, or on a rack, by the id."""
        match self.pose.mechanism.joint(joint):
            case WheelPair(first_link=link, first_radius=radius, arm=arm):
                moment = evaluate(radius, self.values)
                return (*self.couple(link or GROUND, moment), *self.couple(arm or GROUND, -moment))
            case Rack(point, link=link):
                return self._by(link, point, self.direction_of_guide(point))
            case other:
                raise AssertionError(f"{other.id} has no rim")

    def along_thread(self, joint: str, diameter: float) -> tuple[Action, ...]:
        """Return the friction on a thread that an axial force of 1 times 1 gives, on nut and screw.

        F/cos ψ along the thread, whose slope is tan ψ = p/(πd): F·tan ψ along the axis, and
        F·d/2 about it.
        """
        screw = self.pose.mechanism.joint(joint)
        assert isinstance(screw, Screw), "a thread is on a screw"
        slope = evaluate(screw.pitch, self.values) / (math.pi * diameter)
        along = self.direction_of_guide(screw.point).times(slope)
        return (*self._by(screw.link, screw.point, along), *self.couple(screw.link, diameter / 2))

    def _by(self, link: str, point: str, force: Plane) -> tuple[Action, ...]:
        """Return a force on a point by each of the links that drive it."""
        return self.push(point, force) if self._shared(link) else self._half(point, force)

    def _half(self, point: str, force: Plane) -> tuple[Action, ...]:
        """Return a force that both halves have, on a point that they may share."""
        if self._axis is None:
            return self.push(point, force)
        return (Push(point, force), Push(self._twin(point), self._reflected(force)))

    def _bodies(self) -> Iterator[Body]:
        for link in self.pose.mechanism.links:
            frame = self.pose.frames[link.name]
            points = {p: Plane(*evaluate_vector(frame[p], self.values)) for p in link.points}
            yield Body(link.name, points, link.arc is not None)
            if not self._shared(link.name):
                twins = {self._twin(p): self._reflected(v) for p, v in points.items()}
                yield Body(f"{link.name}'", twins, link.arc is not None)

    def _pivots(self) -> Iterator[str]:
        for pivot in self.pose.mechanism.each(Pivot):
            yield from dict.fromkeys((pivot.point, self._twin(pivot.point)))

    def _guides(self) -> Iterator[Guide]:
        for slider in self.pose.mechanism.each(Slider):
            along = self.direction_of_guide(slider.point)
            yield Guide(slider.point, along)
            if not self._shared(slider.point):
                yield Guide(self._twin(slider.point), self._reflected(along))
        yield from self._guides_by_symmetry()

    def _guides_by_symmetry(self) -> Iterator[Guide]:
        copies, guides = self.pose.mechanism.copies, self.pose.guides
        if copies is None:
            return
        axis = next((self.direction_of_guide(p) for p in copies.sharing if p in guides), None)
        held = {*guides, *self.pose.mechanism.fixed}
        for point in copies.sharing:
            if axis is not None and point not in held:
                yield Guide(point, axis)

    def _slides(self) -> Iterator[Translation]:
        for slide in self.pose.mechanism.slides:
            along = direction(self.pose.slides[slide.name].evaluate(self.values))
            frame = self.pose.frames[slide.name]
            points = {p: Plane(*evaluate_vector(frame[p], self.values)) for p in slide.points}
            yield Translation(Body(slide.name, points), along)
            if not self._shared(slide.name):
                twins = {self._twin(p): self._reflected(v) for p, v in points.items()}
                yield Translation(Body(f"{slide.name}'", twins), self._reflected(along))

    def _rubbings(self) -> Iterator[JointFriction]:
        for touch in self.pose.touches:
            normal = direction(touch.normal.evaluate(self.values))
            reach = Plane(*evaluate_vector(touch.reach, self.values))
            first = next(iter(self.pose.frames[touch.body]))
            base = self.arm(touch.body, first, touch.tail)
            arm = Plane(base.x + reach.x, base.y + reach.y)
            yield JointFriction(touch.kind, touch.point, touch.body, arm, normal)
            if not (self._shared(touch.point) and self._shared(touch.body)):
                body = touch.body if self._shared(touch.body) else f"{touch.body}'"
                mirrored = self._reflected(arm), self._reflected(normal)
                yield JointFriction(touch.kind, self._twin(touch.point), body, *mirrored)

    def _transfers(self) -> Iterator[Transfer]:
        """Yield what wheels, racks, screws and guided links pass on."""
        for joint in self.pose.mechanism.joints:
            match joint:
                case WheelPair():
                    yield from self._both(rims(joint, self.values))
                case Rack(point, pivot, link):
                    centre = self.arm(link, next(iter(self.pose.frames[link])), pivot)
                    along = self.direction_of_guide(point)
                    yield from self._both(teeth(joint, along, centre, self.values))
                case Screw(point):
                    yield from self._both(
                        thread(joint, self.direction_of_guide(point), self.values)
                    )
                case Slot(guided=guided) if guided:
                    yield from self._both(block(joint))
                case Pivot() | Slider() | Slot() | Contact():
                    pass  # they press on one point: see _pivots, _guides and _rubbings
                case _:
                    assert_never(joint)

    def _both(self, transfer: Transfer) -> Iterator[Transfer]:
        """Yield a transfer and its twin in the other half."""
        yield transfer
        if self._axis is not None and not all(map(self._is_shared, transfer.actions)):
            first, second, *bearings = map(self._mirrored, (*transfer.actions, *transfer.bearings))
            yield Transfer(f"{transfer.name}'", (first, second), tuple(bearings))

    def _is_shared(self, action: Action) -> bool:
        return self._shared(action.point if isinstance(action, Push) else action.body)

    def _mirrored(self, action: Action) -> Action:
        match action:
            case Push(point, force):
                return Push(self._twin(point), self._reflected(force))
            case Couple(body, moment):
                return Couple(self._twin_of(body), -moment)
            case Wrench(body, force, moment):
                return Wrench(self._twin_of(body), self._reflected(force), -moment)
            case _:
                assert_never(action)

    def _twin_of(self, body: str) -> str:
        """Return what the twin of a link, a slide or a part of a telescope is called."""
        whole, at, point = body.partition(" at ")
        if self._shared(whole):
            return body
        return f"{whole}'{at}{self._twin(point) if point else ''}"

    def _telescopes(self) -> Iterator[Cylinder]:
        for telescope in self.pose.mechanism.cylinders:
            first, second = telescope.points
            arm = self.arm(telescope.name, first, second)
            reach = math.hypot(arm.x, arm.y)
            along = arm.times(1 / reach)
            yield Cylinder(telescope.name, telescope.points, reach, along)
            if not self._shared(telescope.name):
                ends = self._twin(first), self._twin(second)
                yield Cylinder(f"{telescope.name}'", ends, reach, self._reflected(along))

    def assembly(self, *more: tuple[str, tuple[Action, ...]]) -> Assembly:
        """Return the unfolded mechanism with its own loads and ``more`` named ones."""
        loads = {load.name: self._actions(load) for load in self.pose.mechanism.loads}
        return Assembly(
            tuple(self._bodies()),
            tuple(self._pivots()),
            tuple(self._guides()),
            tuple(self._slides()),
            tuple(self._rubbings()),
            tuple(self._transfers()),
            tuple(self._telescopes()),
            {**loads, **dict(more)},
        )
