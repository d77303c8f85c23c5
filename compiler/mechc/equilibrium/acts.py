"""A body that is cut free, and what acts on it: the values that sums are written from."""

from collections.abc import Iterable, Iterator, Mapping
from typing import assert_never

from ..algebra.angle import Angle
from ..algebra.factors import Opaque
from ..algebra.product import ONE, Product
from ..formula.tree import Call
from ..frozen import frozen
from ..model.mechanism import (
    Contact,
    Force,
    ForcePair,
    Pivot,
    Rack,
    Rope,
    Screw,
    Slider,
    Slot,
    Torque,
    WheelPair,
)
from ..named import NamedTuple
from ..pose.pose import Arm, Pose, Vector, components

QUARTER = Angle.constant(90)
X, Y = Angle(), QUARTER


class Act(NamedTuple):
    """A force ``along`` a line, ``at`` an arm from a body's first point; a couple has no line.

    It counts ``size`` times.
    """

    name: str
    size: Product
    along: Angle | None
    at: Vector = ()


@frozen
class FreeBody:
    """A link, a slide or a pin by itself, with all that acts on it.

    ``frame`` has the points that moments may be taken about, none where the body cannot turn.
    ``lines`` are the directions in which its forces balance, ``guide`` one of them. ``rods`` are
    the names of the forces in rods that act on it, with the rods.
    """

    name: str
    acts: tuple[Act, ...]
    frame: Mapping[str, Vector]
    lines: tuple[Angle, ...]
    guide: Angle | None
    rods: Mapping[str, str]


def unit(vector: Vector) -> Vector:
    """Return the vector of length 1 in the direction of another."""
    if len(vector) == 1:
        return (Arm(ONE, vector[0].angle),)
    sides = tuple(side.formula() for side in components(vector))
    length = Product.of(Opaque(Call("hypot", sides)))
    return tuple(Arm(arm.length / length, arm.angle) for arm in vector)


def lines_of(acts: Iterable[Act], guide: Angle | None) -> Iterator[Angle]:
    """Yield the directions in which the sums of forces are short, each line once."""
    whole = [*([guide] if guide else []), X, Y]
    whole += [act.along + QUARTER for act in acts if act.along is not None]
    met: set[Angle] = set()
    for line in whole:
        there = Angle(line.terms, line.degrees % 180)
        if there not in met:
            met.add(there)
            yield line


def bent(pose: Pose) -> Iterator[str]:
    """Yield the links that something acts on between their pins, or turns."""
    for load in pose.mechanism.loads:
        match load:
            case ForcePair(first_link=first, second_link=second):
                yield from (first, second)
            case Force(link=link) | Torque(link=link):
                yield link
            case _:
                assert_never(load)
    yield from (touch.body for touch in pose.touches)
    for joint in pose.mechanism.joints:
        match joint:
            case WheelPair() | Rack() | Screw():
                yield from joint.bodies
            case Slot(guided=guided):
                yield guided
            case Pivot() | Slider() | Contact() | Rope():
                pass
            case _:
                assert_never(joint)
