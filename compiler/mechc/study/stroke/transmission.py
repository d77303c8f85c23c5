"""Transmission angles: between a coupler and what it drives.

At the pin between a rod and a link on a pivot it is the angle between rod and link, folded
to 0 … 90°; at a slider it is 90° less the angle between the rod and the guide (Alt 1932).
Forces pass well near 90° and not at all at 0.
"""

import math
from collections.abc import Iterable, Iterator, Mapping

from ...algebra.angle import Angle
from ...model.mechanism import Link
from ...named import NamedTuple
from ...pose.pose import Pose


class Transmission(NamedTuple):
    """A pin, the angle whose sine is that of its transmission angle, the rod and what it drives.

    ``onto`` is the link driven, '' where it is a slider.
    """

    pin: str
    between: Angle
    rod: str
    onto: str

    def at(self, values: Mapping[str, float]) -> float:
        """Return the angle in radians, between 0 and π/2."""
        return abs(math.asin(min(1.0, abs(math.sin(self.between.evaluate(values))))))


def transmissions(pose: Pose) -> Iterator[Transmission]:
    """Yield the transmission angle at every pin between a rod and a pivoted link or a guide."""
    pivots = pose.mechanism.fixed
    links = pose.mechanism.links
    for rod in links:
        if len(rod.points) != 2 or not pivots.isdisjoint(rod.points):
            continue
        for pin, far in (rod.points, rod.points[::-1]):
            along = _direction(pose, rod, far, pin)
            for link in links:
                centre = next((p for p in link.points if p in pivots), None)
                if link is not rod and centre and pin in link.points and along is not None:
                    arm = _direction(pose, link, centre, pin)
                    if arm is not None and not _drives(pose, arm):
                        yield Transmission(pin, along - arm, rod.name, link.name)
            if pin in pose.guides and along is not None:
                across = pose.guides[pin] + Angle.constant(90)
                yield Transmission(pin, along - across, rod.name, "")


def _direction(pose: Pose, link: Link, tail: str, head: str) -> Angle | None:
    arms = pose.vector(link.name, tail, head)
    return arms[0].angle if len(arms) == 1 else None


def _drives(pose: Pose, arm: Angle) -> bool:
    """Return the crank, whose direction is the drive's, and what is driven."""
    drive = pose.mechanism.drive
    return drive is not None and [n for n, _ in arm.terms] == [drive.parameter]


def named(found: Iterable[Transmission]) -> Iterator[tuple[str, Transmission]]:
    """Yield transmission angles by their pins, by rod and link too where a pin has several."""
    each = list(dict.fromkeys(found))
    for one in each:
        alone = [other.pin for other in each].count(one.pin) == 1
        pair = "-".join(name for name in (one.rod, one.onto) if name)
        yield f"mu_{one.pin}" if alone else f"mu_{one.pin}({pair})", one
