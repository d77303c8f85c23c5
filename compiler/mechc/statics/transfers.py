"""What wheels, racks, screws and guided links pass on, from their mechanics."""

import math
from collections.abc import Mapping

from ..formula.walk import evaluate
from ..model.mechanism import Rack, Screw, Slot, WheelPair
from .assembly import GROUND, Couple, Plane, Push, Transfer, Wrench

Values = Mapping[str, float]


def rims(pair: WheelPair, values: Values) -> Transfer:
    """Return the couples of a unit force on the rims of two wheels.

    Gears press on each other at the pitch point. Between the centres that gives moments
    of one sign; inner gears have both centres on one side of it, and the tight side of an
    open belt pulls one wheel backwards as it pulls the other one on: opposite signs.

    On the two wheels together these forces cancel, so that what their pins pass on to the
    arm is a couple: the opposite of both moments.
    """
    first = evaluate(pair.first_radius, values)
    second = evaluate(pair.second_radius, values) * (-1 if pair.same else 1)
    wheels = (
        Couple(pair.first_link or GROUND, first),
        Couple(pair.second_link or GROUND, second),
    )
    return Transfer(pair.id, wheels, (Couple(pair.arm or GROUND, -first - second),))


def thread(screw: Screw, along: Plane, values: Values) -> Transfer:
    """Return a unit force on a nut along its guide, and the couple that the screw takes."""
    lead = evaluate(screw.pitch, values) / (2 * math.pi)
    return Transfer(screw.id, (Push(screw.point, along), Couple(screw.link, -lead)))


def teeth(rack: Rack, along: Plane, centre: Plane, values: Values) -> Transfer:
    """Return a force on a rack along its guide, and what its wheel takes at the pitch point."""
    right = along.turned().times(-evaluate(rack.radius, values))
    x, y = centre.x + right.x, centre.y + right.y
    back = Wrench(rack.link, along.times(-1), y * along.x - x * along.y)
    return Transfer(rack.id, (Push(rack.point, along), back))


def block(slot: Slot) -> Transfer:
    """Return the couple that keeps a guided link from turning in its slot."""
    return Transfer(slot.id, (Couple(slot.guided, 1.0), Couple(slot.link, -1.0)))
