"""Which bodies are cut free, and which of them carries a pin."""

from collections.abc import Iterable, Iterator, Mapping

from ..frozen import frozen
from ..model.mechanism import Link, Mechanism, Slide
from ..pose.pose import Pose
from .acts import bent


@frozen
class Cutting:
    """The ``rigid`` bodies, by name with their points: links that are no plain rods, and slides.

    A pin that none of them carries is a body by itself.
    """

    pose: Pose
    rigid: Mapping[str, tuple[str, ...]]

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism that is cut."""
        return self.pose.mechanism

    def points(self, body: str) -> tuple[str, ...]:
        """Return the points of a body; the ground, '', has none."""
        return tuple(self.pose.frames[body]) if body else ()

    def on(self, point: str) -> list[str]:
        """Return the rigid bodies that have a point."""
        return [name for name, points in self.rigid.items() if point in points]

    def host(self, point: str) -> str:
        """Return the body that carries a pin, the pin where none does; '' for the ground."""
        if point in self.mechanism.fixed:
            return ""
        return next(
            (b for b in self.on(point) if self.repeats((point,), self.rigid[b]) == 1), point
        )

    def repeats(self, host: Iterable[str], points: Iterable[str]) -> int:
        """Return how many equal parts put the same on what they share."""
        return int(self.mechanism.repeats(points) / self.mechanism.repeats(host))


def cutting(pose: Pose) -> Cutting:
    """Return how a mechanism, or one of its equal parts, is cut into free bodies."""
    return Cutting(pose, {body.name: body.points for body in _rigid(pose)})


def _rigid(pose: Pose) -> Iterator[Link | Slide]:
    loaded = set(bent(pose))
    for link in pose.mechanism.links:
        if len(link.points) > 2 or link.name in loaded:
            yield link
    yield from pose.mechanism.slides
