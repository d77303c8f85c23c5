"""The constant angles between the directions of a description, by which differences are known."""

from fractions import Fraction
from itertools import combinations

from .pose import Pose

FEW = 12
"""More constants than these, and any angle is a difference of some of them."""


def constants_of(pose: Pose) -> frozenset[Fraction]:
    """Return the constant parts of angles between given lines, in degrees from 0 to 180.

    Coordinates are no lines. Lines have no sense, and a direction that a loop gives has no
    constant: neither the order in which things are written nor a turn of the whole drawing
    changes what is found.
    """
    between = (vector for ends, vector in pose.vectors.items() if all(ends))
    arms = (arm.angle for vector in between for arm in vector)
    own = {Fraction(angle.degrees) % 180 for angle in (*arms, *pose.guides.values())}
    if pose.loops:
        own.add(Fraction(0))
    if len(own) > FEW:
        return frozenset()
    found = {abs(one - other) for one, other in combinations(own, 2)}
    return frozenset(size for angle in found for size in (angle, 180 - angle) if size % 90)
