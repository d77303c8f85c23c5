"""Transmission angles: between a coupler and what it drives.

At the pin between a rod and a link on a pivot it is the angle of the triangle between rod and
link, 0 … 180°, as the formulas have it; at a slider it is 90° less the angle between the rod and
the guide (Alt 1932). Forces pass well near 90° and not at all at 0 and 180°.
"""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping

from ...algebra.angle import QUARTER, Angle
from ...base.named import NamedTuple
from ...model.mechanism import Link
from ...pose.pose import Pose


class TransmissionAngle(NamedTuple):
    """A pin, the angle that its transmission angle is but for sign, the rod and what it drives.

    ``between`` runs from the link to the rod, at a slider from the normal of the guide.
    ``onto`` is the link driven, '' where it is a slider; ``ends`` the far end of the rod and
    the pivot of the link.
    """

    pin: str
    between: Angle
    rod: str
    onto: str
    ends: frozenset[str] = frozenset()

    def at(self, values: Mapping[str, float]) -> float:
        """Return the angle in radians: between 0 and π, at a slider π/2."""
        size = abs(math.remainder(self.between.evaluate(values), math.tau))
        return size if self.onto else min(size, math.pi - size)


def transmissions(pose: Pose) -> Iterator[TransmissionAngle]:
    """Yield the transmission angle at every pin between a rod and a pivoted link or a guide."""
    for rod in pose.mechanism.links:
        if len(rod.points) != 2 or not pose.mechanism.fixed.isdisjoint(rod.points):
            continue
        for pin, far in (rod.points, rod.points[::-1]):
            along = _direction(pose, rod, far, pin)
            if along is None:
                continue
            yield from _to_links(pose, rod, pin, far, along)
            if pin in pose.guides:
                across = pose.guides[pin] + QUARTER
                yield TransmissionAngle(pin, along - across, rod.name, "")


def _to_links(
    pose: Pose, rod: Link, pin: str, far: str, along: Angle
) -> Iterator[TransmissionAngle]:
    """Yield the angles between a rod and the links on pivots that it drives at a pin."""
    pivots = pose.mechanism.fixed
    for link in pose.mechanism.links:
        centre = next((p for p in link.points if p in pivots), None)
        if link is rod or not centre or pin not in link.points:
            continue
        arm = _direction(pose, link, centre, pin)
        if arm is not None and not _drives(pose, arm):
            yield TransmissionAngle(pin, along - arm, rod.name, link.name, frozenset((far, centre)))


def _direction(pose: Pose, link: Link, tail: str, head: str) -> Angle | None:
    arms = pose.vector(link.name, tail, head)
    return arms[0].angle if len(arms) == 1 else None


def _drives(pose: Pose, arm: Angle) -> bool:
    """Return the crank, whose direction is the drive's, and what is driven."""
    drive = pose.mechanism.drive
    return drive is not None and [n for n, _ in arm.terms] == [drive.parameter]


def named(
    found: Iterable[TransmissionAngle], others: Mapping[str, Collection[str]]
) -> Iterator[tuple[str, TransmissionAngle]]:
    """Yield transmission angles by their pins, by rod and link too where that is ambiguous.

    It is where a pin has several, and where ``others`` has another angle of the name: one
    that is not seen between the same two points.
    """
    each = list(dict.fromkeys(found))
    for one in each:
        name = f"mu_{one.pin}"
        alone = [other.pin for other in each].count(one.pin) == 1
        if alone and one.ends == others.get(name, one.ends):
            yield name, one
        else:
            yield f"{name}({'-'.join(filter(None, (one.rod, one.onto)))})", one


def angles_at_pins(pose: Pose) -> dict[str, frozenset[str]]:
    """Return the definitions of closed loops, each with the two points that its angle lies between.

    There are none where the name is not that of a triangle's angle.
    """
    names = (d.name for d in (*pose.definitions, *pose.closing))
    ends = dict.fromkeys(names, frozenset[str]())
    for loop in pose.solved:
        if loop.is_triangle:
            first, pin, last = loop.points
            ends[f"mu_{pin}"] = frozenset((first, last))
    return ends
