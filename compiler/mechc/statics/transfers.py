"""The forces that wheels, racks and screws pass on, from their mechanics, and their bearings."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import assert_never

from ..formula.evaluate import evaluate
from ..model.mechanism import Contact, Mechanism, Pivot, Rack, Rope, Screw, Slider, Slot, WheelPair
from ..model.parts.linkage import primed
from .assembly import GROUND, Action, Couple, PointForce, Transfer, Wrench, direction
from .pose_in_numbers import Halves

PinOnLink = tuple[str, str]
"""A pin or slide, and what holds it there against teeth, a belt or a thread."""


def transfers(halves: Halves) -> Iterator[Transfer]:
    """Yield the forces that wheels and screws pass on."""
    for joint in halves.pose.mechanism.joints:
        match joint:
            case WheelPair():
                yield from both(halves, _rims(halves, joint))
            case Rack():
                yield from both(halves, Transfer(joint.kind, joint.id, _teeth(halves, joint)))
            case Screw():
                yield from both(halves, Transfer(joint.kind, joint.id, _thread(halves, joint)))
            case Rope():
                yield from both(halves, _falls(halves, joint))
            case Slot(link=link, guided=guided) if guided:
                couples = Couple(guided, 1.0), Couple(link, -1.0)
                yield from both(halves, Transfer("slot", joint.id, couples))
            case Pivot() | Slider() | Slot() | Contact():
                pass  # they press on one point: see :mod:`.unfold`
            case _:
                assert_never(joint)


def _rims(halves: Halves, pair: WheelPair) -> Transfer:
    """Return the couples of a unit force on the rims of two wheels.

    Gears press on each other at the pitch point. Between the centres that gives moments
    of one sign; inner gears have both centres on one side of it, and the tight side of an
    open belt pulls one wheel backwards as it pulls the other one on: opposite signs.

    On the two wheels together these forces cancel, so that what their pins pass on to the
    arm is a couple: the opposite of both moments.
    """
    first = evaluate(pair.first_radius, halves.values)
    second = evaluate(pair.second_radius, halves.values) * (-1 if pair.same else 1)
    wheels = (
        Couple(pair.first_link or GROUND, first),
        Couple(pair.second_link or GROUND, second),
    )
    return Transfer(pair.kind, pair.id, wheels, (Couple(pair.arm or GROUND, -first - second),))


def _thread(halves: Halves, screw: Screw) -> tuple[Action, Action]:
    """Return a unit force on a nut along its guide, and the couple that the screw takes."""
    lead = evaluate(screw.pitch, halves.values) / (2 * math.pi)
    return PointForce(screw.point, halves.direction_of_guide(screw.point)), Couple(
        screw.link, -lead
    )


def _teeth(halves: Halves, rack: Rack) -> tuple[Action, Action]:
    """Return a force on a rack along its guide, and what its wheel takes at the pitch point."""
    along = halves.direction_of_guide(rack.point)
    right = along.turned().times(-evaluate(rack.radius, halves.values))
    first = next(iter(halves.pose.frames[rack.link]))
    centre = halves.arm(rack.link, first, rack.pivot)
    x, y = centre.x + right.x, centre.y + right.y
    back = Wrench(rack.link, along.times(-1), y * along.x - x * along.y)
    return PointForce(rack.point, along), back


def _falls(halves: Halves, rope: Rope) -> Transfer:
    """Return the forces of a tension of 1 on all that a rope runs over."""
    forces = tuple(rope_forces(halves, rope))
    return Transfer("rope", rope.id, forces, label="-".join(rope.route))


def rope_forces(halves: Halves, rope: Rope, tensions: Sequence[float] = ()) -> Iterator[Action]:
    """Yield the forces of tensions in the falls, of 1 in each: these draw its ends together.

    A pulley that turns freely on its axle has the same tension on both sides.
    """
    ways = [direction(way.evaluate(halves.values)) for way in halves.pose.falls[rope.id]]
    sizes = tensions or [1.0] * len(ways)
    for (tail, head), way, size in zip(pairwise(rope.route), ways, sizes, strict=True):
        yield PointForce(tail, way.times(size))
        yield PointForce(head, way.times(-size))


def both(halves: Halves, transfer: Transfer) -> Iterator[Transfer]:
    """Yield a transfer and its twin in the other half."""
    yield transfer
    if halves.axis is not None and not all(map(halves.acts_on_shared, transfer.actions)):
        actions, bearings = (
            tuple(map(halves.mirrored, part)) for part in (transfer.actions, transfer.bearings)
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
