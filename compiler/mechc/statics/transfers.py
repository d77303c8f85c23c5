"""The forces that wheels, racks and screws pass on, from their mechanics, and their bearings."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import assert_never

from ..formula.evaluate import evaluate
from ..model.mechanism import Contact, Mechanism, Pivot, Rack, Rope, Screw, Slider, Slot, WheelPair
from ..model.parts.linkage import primed
from .assembly import GROUND, Action, Couple, PointForce, Transfer, Wrench, direction
from .pose_in_numbers import PoseInNumbers

PinOnLink = tuple[str, str]
"""A pin or slide, and what holds it there against teeth, a belt or a thread."""


def transfers(numeric: PoseInNumbers) -> Iterator[Transfer]:
    """Yield the forces that wheels and screws pass on."""
    for joint in numeric.pose.mechanism.joints:
        match joint:
            case WheelPair():
                yield from both(numeric, _rims(numeric, joint))
            case Rack():
                yield from both(numeric, Transfer(joint.kind, joint.id, _teeth(numeric, joint)))
            case Screw():
                yield from both(numeric, Transfer(joint.kind, joint.id, _thread(numeric, joint)))
            case Rope():
                yield from both(numeric, _falls(numeric, joint))
            case Slot(link=link, guided=guided) if guided:
                couples = Couple(guided, 1.0), Couple(link, -1.0)
                yield from both(numeric, Transfer("slot", joint.id, couples))
            case Pivot() | Slider() | Slot() | Contact():
                pass  # they press on one point: see :mod:`.unfold`
            case _:
                assert_never(joint)


def _rims(numeric: PoseInNumbers, pair: WheelPair) -> Transfer:
    """Return the couples of a unit force on the rims of two wheels.

    Gears press on each other at the pitch point. Between the centres that gives moments
    of one sign; inner gears have both centres on one side of it, and the tight side of an
    open belt pulls one wheel backwards as it pulls the other one on: opposite signs.

    On the two wheels together these forces cancel, so that what their pins pass on to the
    arm is a couple: the opposite of both moments.
    """
    first = evaluate(pair.first_radius, numeric.values)
    second = evaluate(pair.second_radius, numeric.values) * (-1 if pair.same else 1)
    wheels = (
        Couple(pair.first_link or GROUND, first),
        Couple(pair.second_link or GROUND, second),
    )
    return Transfer(pair.kind, pair.id, wheels, (Couple(pair.arm or GROUND, -first - second),))


def _thread(numeric: PoseInNumbers, screw: Screw) -> tuple[Action, Action]:
    """Return a unit force on a nut along its guide, and the couple that the screw takes."""
    lead = evaluate(screw.pitch, numeric.values) / (2 * math.pi)
    return PointForce(screw.point, numeric.direction_of_guide(screw.point)), Couple(
        screw.link, -lead
    )


def _teeth(numeric: PoseInNumbers, rack: Rack) -> tuple[Action, Action]:
    """Return a force on a rack along its guide, and what its wheel takes at the pitch point."""
    along = numeric.direction_of_guide(rack.point)
    right = along.turned().times(-evaluate(rack.radius, numeric.values))
    first = next(iter(numeric.pose.frames[rack.link]))
    centre = numeric.arm(rack.link, first, rack.pivot)
    x, y = centre.x + right.x, centre.y + right.y
    back = Wrench(rack.link, along.times(-1), y * along.x - x * along.y)
    return PointForce(rack.point, along), back


def _falls(numeric: PoseInNumbers, rope: Rope) -> Transfer:
    """Return the forces of a tension of 1 on all that a rope runs over."""
    forces = tuple(rope_forces(numeric, rope))
    return Transfer("rope", rope.id, forces, label="-".join(rope.route))


def rope_forces(
    numeric: PoseInNumbers, rope: Rope, tensions: Sequence[float] = ()
) -> Iterator[Action]:
    """Yield the forces of tensions in the falls, of 1 in each: these draw its ends together.

    A pulley that turns freely on its axle has the same tension on both sides.
    """
    ways = [direction(way.evaluate(numeric.values)) for way in numeric.pose.falls[rope.id]]
    sizes = tensions or [1.0] * len(ways)
    for (tail, head), way, size in zip(pairwise(rope.route), ways, sizes, strict=True):
        yield PointForce(tail, way.times(size))
        yield PointForce(head, way.times(-size))


def both(numeric: PoseInNumbers, transfer: Transfer) -> Iterator[Transfer]:
    """Yield a transfer and its twin in the other half."""
    yield transfer
    if numeric.axis is not None and not all(map(numeric.acts_on_shared, transfer.actions)):
        actions, bearings = (
            tuple(map(numeric.mirrored, part)) for part in (transfer.actions, transfer.bearings)
        )
        label = transfer.label and primed(transfer.label)
        yield Transfer(transfer.kind, primed(transfer.name), actions, bearings, label)


# ------------------------------------------------------------------------------ bearings


def bearings(mechanism: Mechanism) -> frozenset[PinOnLink]:
    """Return the bearings of wheels, racks and screws, in both halves."""
    half = list(_bearings_of_half(mechanism))
    points = [(primed(point), by) for point, by in half]
    return frozenset(
        bearing
        for point, by in (*half, *points)
        for bearing in ((point, by), (point, primed(by) if by != "ground" else by))
    )


def _bearings_of_half(mechanism: Mechanism) -> Iterator[PinOnLink]:
    """Yield the pins on links and on the ground that bear what joints of the half pass on."""
    for joint in mechanism.joints:
        match joint:
            case WheelPair():
                for centre in joint.points:
                    yield centre, "ground"
                    yield from ((centre, link) for link in mechanism.turning_at(centre))
            case Rack(point, pivot, link):
                yield from ((pivot, link), (pivot, "ground"), (point, "ground"))
                yield from ((slide.name, "ground") for slide in mechanism.slides_at(point))
            case Screw(link=link):
                for pivot in mechanism.fixed.intersection(mechanism.link(link).points):
                    yield from ((pivot, link), (pivot, "ground"))
            case Pivot() | Slider() | Slot() | Contact() | Rope():
                pass
            case _:
                assert_never(joint)
