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
from collections.abc import Iterator
from typing import assert_never

from ..base.frozen import frozen
from ..model.mechanism import Force, ForcePair, Load, Pivot, Slider, Torque
from ..model.parts.linkage import primed
from ..pose.pose import evaluate_vector
from .assembly import (
    Action,
    AssembledBodies,
    Couple,
    Cylinder,
    Guide,
    PinOnBody,
    Plane,
    PointForce,
    RigidBody,
    Translation,
    Wrench,
    direction,
)
from .pose_in_numbers import PoseInNumbers
from .transfers import transfers


@frozen
class Unfolding(PoseInNumbers):
    """A pose at given values, and what forces and couples put on both halves of it."""

    def push(self, point: str, force: Plane) -> tuple[Action, ...]:
        """Return the actions on the whole assembly of a force on a point."""
        share = force.times(self.part_of(point))
        if not self.is_shared(point):
            return (PointForce(point, share), PointForce(self.twin(point), self.reflected(share)))
        return (PointForce(point, self.axial(share)),)

    def on(self, link: str, point: str, force: Plane) -> tuple[Action, ...]:
        """Return the actions on the whole assembly of a force on a link at one of its points.

        On what the halves share the part of it counts that is the same for both.
        """
        share = force.times(self.part_of(link))
        if self.axis is not None and self.is_shared(link):
            share = self.axial(share)
        there = self._end(link, point, share)
        return (there,) if self.is_shared(link) else (there, self.mirrored(there))

    def turning(self, body: str, point: str, moment: float) -> tuple[Action, ...]:
        """Return the actions of a couple on a link or a telescope, at the pin of a point."""
        if body not in self.cylinders():
            return self.couple(body, moment)
        share = moment * self.part_of(body)
        there = Couple(f"{body} at {point}", share)
        if not self.is_shared(body):
            return (there, self.mirrored(there))
        return (there,) if self.axis is None else ()

    def turning_on(self, point: str) -> Iterator[str]:
        """Yield the links and telescopes that a pin joins, but no telescope that nothing loads."""
        mechanism = self.pose.mechanism
        loaded = [set(load.points) for load in mechanism.loads]
        yield from (link.name for link in mechanism.rigid_links if point in link.points)
        for telescope in mechanism.telescopes:
            if point in telescope.points and {*telescope.points} in loaded:
                yield telescope.name

    def couple(self, link: str, moment: float) -> tuple[Action, ...]:
        """Return the actions on the whole assembly of a couple on a link."""
        share = moment * self.part_of(link)
        if not self.is_shared(link):
            return (Couple(link, share), Couple(primed(link), -share))
        return (Couple(link, share),) if self.axis is None else ()

    def _actions(self, load: Load) -> tuple[Action, ...]:
        """Return the actions of a load on the free bodies, as many times as it is there."""
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
        if load.joins_twins:
            link = load.first_link
            return self.on(link, load.first, push) if link else self.push(load.first, push)
        push = push.times(max(self.part_of(load.first), self.part_of(load.second)))
        shared = self.is_shared(load.first) and self.is_shared(load.second)
        push = self.axial(push) if shared else push
        pair = (
            self._end(load.second_link, load.second, push),
            self._end(load.first_link, load.first, push.times(-1)),
        )
        return pair if self.axis is None or shared else (*pair, *map(self.mirrored, pair))

    def _end(self, link: str, point: str, push: Plane) -> Action:
        """Return the action of a pair's end on a pin, a link or a part of a telescope."""
        if not link:
            return PointForce(point, push)
        if link in self.cylinders():
            return Wrench(f"{link} at {point}", push, 0.0)
        arm = self.arm(link, next(iter(self.pose.frames[link])), point)
        return Wrench(link, push, arm.x * push.y - arm.y * push.x)

    def assembly(self, *more: tuple[str, tuple[Action, ...]]) -> AssembledBodies:
        """Return the unfolded mechanism with its own loads and ``more`` named ones."""
        loads = {load.name: self._actions(load) for load in self.pose.mechanism.loads}
        return AssembledBodies(
            bodies=tuple(bodies(self)),
            pivots=tuple(pivots(self)),
            guides=tuple(guides(self)),
            slides=tuple(slides(self)),
            contacts=tuple(point_contacts(self)),
            transfers=tuple(transfers(self)),
            cylinders=tuple(telescopes(self)),
            loads={**loads, **dict(more)},
            twins=self.twins(),
        )


def bodies(numeric: PoseInNumbers) -> Iterator[RigidBody]:
    """Yield every link, in both halves."""
    for link in numeric.pose.mechanism.links:
        frame = numeric.pose.frames[link.name]
        points = {p: Plane(*evaluate_vector(frame[p], numeric.values)) for p in link.points}
        yield RigidBody(link.name, points, link.arc is not None)
        if not numeric.is_shared(link.name):
            twins = {numeric.twin(p): numeric.reflected(v) for p, v in points.items()}
            yield RigidBody(primed(link.name), twins, link.arc is not None)


def pivots(numeric: PoseInNumbers) -> Iterator[str]:
    """Yield every pin on the ground, in both halves."""
    for pivot in numeric.pose.mechanism.each(Pivot):
        yield from dict.fromkeys((pivot.point, numeric.twin(pivot.point)))


def guides(numeric: PoseInNumbers) -> Iterator[Guide]:
    """Yield the guide of every slider, in both halves, and those that symmetry makes."""
    for slider in numeric.pose.mechanism.each(Slider):
        along = numeric.direction_of_guide(slider.point)
        yield Guide(slider.point, along)
        if not numeric.is_shared(slider.point):
            yield Guide(numeric.twin(slider.point), numeric.reflected(along))
    yield from _guides_by_symmetry(numeric)


def _guides_by_symmetry(numeric: PoseInNumbers) -> Iterator[Guide]:
    copies, guides = numeric.pose.mechanism.copies, numeric.pose.guides
    if copies is None:
        return
    axis = next((numeric.direction_of_guide(p) for p in copies.sharing if p in guides), None)
    held = {*guides, *numeric.pose.mechanism.fixed}
    for point in copies.sharing:
        if axis is not None and point not in held:
            yield Guide(point, axis)


def slides(numeric: PoseInNumbers) -> Iterator[Translation]:
    """Yield every body that only translates, in both halves."""
    for slide in numeric.pose.mechanism.slides:
        along = direction(numeric.pose.slides[slide.name].evaluate(numeric.values))
        frame = numeric.pose.frames[slide.name]
        points = {p: Plane(*evaluate_vector(frame[p], numeric.values)) for p in slide.points}
        yield Translation(RigidBody(slide.name, points), along)
        if not numeric.is_shared(slide.name):
            twins = {numeric.twin(p): numeric.reflected(v) for p, v in points.items()}
            yield Translation(RigidBody(primed(slide.name), twins), numeric.reflected(along))


def point_contacts(numeric: PoseInNumbers) -> Iterator[PinOnBody]:
    """Yield every pin in a slot and every contact, in both halves."""
    for contact in numeric.pose.contacts:
        normal = direction(contact.normal.evaluate(numeric.values))
        reach = Plane(*evaluate_vector(contact.reach, numeric.values))
        first = next(iter(numeric.pose.frames[contact.body]))
        base = numeric.arm(contact.body, first, contact.tail)
        arm = Plane(base.x + reach.x, base.y + reach.y)
        yield PinOnBody(contact.kind, contact.point, contact.body, arm, normal)
        if not (numeric.is_shared(contact.point) and numeric.is_shared(contact.body)):
            body = contact.body if numeric.is_shared(contact.body) else primed(contact.body)
            mirrored = numeric.reflected(arm), numeric.reflected(normal)
            yield PinOnBody(contact.kind, numeric.twin(contact.point), body, *mirrored)


def telescopes(numeric: PoseInNumbers) -> Iterator[Cylinder]:
    """Yield every telescope that two bodies make, in both halves."""
    for telescope in numeric.pose.mechanism.cylinders:
        first, second = telescope.points
        arm = numeric.arm(telescope.name, first, second)
        reach = math.hypot(arm.x, arm.y)
        along = arm.times(1 / reach)
        yield Cylinder(telescope.name, telescope.points, reach, along)
        if not numeric.is_shared(telescope.name):
            ends = numeric.twin(first), numeric.twin(second)
            yield Cylinder(primed(telescope.name), ends, reach, numeric.reflected(along))
