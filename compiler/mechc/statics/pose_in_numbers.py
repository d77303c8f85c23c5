"""A pose in numbers, and the way from each half of a mirrored mechanism to its twin."""

from collections.abc import Mapping
from itertools import chain
from typing import assert_never

from ..base.frozen import frozen
from ..model.parts.linkage import primed
from ..pose.pose import Pose, evaluate_vector
from .assembly import GROUND, Action, Couple, Plane, PointForce, Wrench, direction


@frozen
class PoseInNumbers:
    """A pose at given values of its symbols."""

    pose: Pose
    values: Mapping[str, float]

    @property
    def axis(self) -> Plane | None:
        """Return the unit vector along the mirror line, None without a mirror."""
        axis = self.pose.axis
        return None if axis is None else direction(axis.evaluate(self.values))

    def is_shared(self, name: str) -> bool:
        """Return whether both halves have a link, a slide or a point in common."""
        mirror = self.pose.mechanism.mirror
        return mirror is None or name == GROUND or self.points(name) <= set(mirror.sharing)

    def points(self, name: str) -> set[str]:
        """Return the points of a link, or the point itself."""
        return set(self.pose.frames.get(name, (name,)))

    def part_of(self, name: str) -> float:
        """Return which part of a load there one branch of the copies takes."""
        copies = self.pose.mechanism.copies
        common = copies is not None and self.points(name) <= set(copies.sharing)
        return 1 / float(copies.number) if copies is not None and common else 1.0

    def count(self, name: str) -> float:
        """Return how many times over a load on a point or link does its work."""
        return self.part_of(name) * (1 if self.is_shared(name) else 2)

    def reflected(self, vector: Plane) -> Plane:
        """Return a vector as it is in the other half."""
        axis = self.axis
        assert axis is not None
        return vector.reflected(axis)

    def twin(self, point: str) -> str:
        """Return the name of a point's twin."""
        return point if self.is_shared(point) else primed(point)

    def twin_of(self, body: str) -> str:
        """Return the name of the twin of a link, a slide or a part of a telescope."""
        whole, at, point = body.partition(" at ")
        if self.is_shared(whole):
            return body
        return f"{primed(whole)}{at}{self.twin(point) if point else ''}"

    def twins(self) -> dict[str, str]:
        """Return the bodies and points that the mirror adds, each with what is described."""
        frames = self.pose.frames
        names = dict.fromkeys((*frames, *chain(*frames.values()), *self.pose.guides))
        return {primed(name): name for name in names if not self.is_shared(name)}

    def acts_on_shared(self, action: Action) -> bool:
        """Return whether an action is on what both halves share."""
        return self.is_shared(action.point if isinstance(action, PointForce) else action.body)

    def mirrored(self, action: Action) -> Action:
        """Return an action as it is in the other half."""
        match action:
            case PointForce(point, force):
                return PointForce(self.twin(point), self.reflected(force))
            case Couple(body, moment):
                return Couple(self.twin_of(body), -moment)
            case Wrench(body, force, moment):
                return Wrench(self.twin_of(body), self.reflected(force), -moment)
            case _:
                assert_never(action)

    def axial(self, force: Plane) -> Plane:
        """Return the part of a force on what both halves share that is the same for both."""
        axis = self.axis
        return force if axis is None else axis.times(axis.dot(force))

    def cylinders(self) -> set[str]:
        """Return the names of the telescopes that two bodies make."""
        return {telescope.name for telescope in self.pose.mechanism.cylinders}

    def arm(self, link: str, tail: str, head: str) -> Plane:
        """Return the vector between two points of a link."""
        return Plane(*evaluate_vector(self.pose.vector(link, tail, head), self.values))

    def direction_of_guide(self, point: str) -> Plane:
        """Return the unit direction of the guide of a slider, or of a point of a slide."""
        guide = self.pose.guide_of(point)
        assert guide is not None
        return direction(guide.evaluate(self.values))
