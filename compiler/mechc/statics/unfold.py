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

from collections.abc import Iterator
from typing import assert_never

from ..frozen import frozen
from ..model.mechanism import Force, ForcePair, Load, Torque
from ..model.repeated import primed
from .assembly import Action, Assembly, Couple, Plane, PointForce, Wrench, direction
from .halves import Halves
from .transfers import transfers
from .unfolded import bodies, guides, pivots, point_contacts, slides, telescopes


@frozen
class Unfolding(Halves):
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
        pairs = [load for load in mechanism.loads if isinstance(load, ForcePair)]
        loaded = [{pair.first, pair.second} for pair in pairs]
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

    def assembly(self, *more: tuple[str, tuple[Action, ...]]) -> Assembly:
        """Return the unfolded mechanism with its own loads and ``more`` named ones."""
        loads = {load.name: self._actions(load) for load in self.pose.mechanism.loads}
        return Assembly(
            tuple(bodies(self)),
            tuple(pivots(self)),
            tuple(guides(self)),
            tuple(slides(self)),
            tuple(point_contacts(self)),
            tuple(transfers(self)),
            tuple(telescopes(self)),
            {**loads, **dict(more)},
            self.twins(),
        )
