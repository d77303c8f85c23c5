"""The constant angles in the directions of links, by which differences of them are known."""

from fractions import Fraction
from itertools import combinations

from .pose import Pose

FEW = 12
"""More constants than these, and any angle is a difference of some of them."""


def constants_of(pose: Pose) -> frozenset[Fraction]:
    """Return the constants, in degrees from 0 to 180, of directions and of two of them."""
    arms = (arm for frame in pose.frames.values() for vector in frame.values() for arm in vector)
    own = {Fraction(arm.angle.degrees) for arm in arms if arm.angle.terms}
    if len(own) > FEW:
        return frozenset()
    found = {*own, *(one - other for one, other in combinations(own, 2))}
    sizes = (abs((degrees + 180) % 360 - 180) for degrees in found)
    return frozenset(size for size in sizes if size % 90)
