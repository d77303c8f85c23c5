"""What equilibrium is written of, in numbers: bodies, joints, and what acts on them."""

from collections.abc import Mapping
from typing import Literal, assert_never

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..model.parts.joints import MeshKind
from ..pose.places import Plane as Plane
from ..pose.places import direction as direction

GROUND = "ground"
"""What stands still; nothing is asked of its equilibrium."""


class RigidBody(NamedTuple):
    """A rigid body: where its points are, seen from the first of them.

    An ``arc`` is the rod that stands for a circular slot: no body turns on a pin there.
    """

    name: str
    points: Mapping[str, Plane]
    arc: bool = False


class Guide(NamedTuple):
    """A point guided by the ground along a unit direction."""

    point: str
    along: Plane


class Translation(NamedTuple):
    """A body that only translates: its guide takes any force across and any couple."""

    body: RigidBody
    along: Plane


class Cylinder(NamedTuple):
    """A telescope as two bodies, each with one of its ends, that slide in one another.

    They take any force across ``along``, the unit direction from the first end to the second,
    and any couple.
    """

    name: str
    ends: tuple[str, str]
    reach: float
    along: Plane

    def part(self, point: str) -> str:
        """Return the name of the body at an end; no description can have it."""
        return f"{self.name} at {point}"


class PinOnBody(NamedTuple):
    """A pin held by a body across a line: the force on the pin is along the normal.

    ``arm`` is the vector from the body's first point to the pin.
    """

    kind: str
    point: str
    body: str
    arm: Plane
    normal: Plane


TransferKind = Literal[MeshKind, "rope", "slot"]
"""The joints that pass a force on; a slot passes the couple of what it guides."""


class Transfer(NamedTuple):
    """One force that wheels, a rack, a screw or a rope pass on, and what a unit of it does.

    Where its direction is undetermined, the bearings' part in it is left out: it loads the
    ground alone, and forces on such bearings are never asked for. On an arm that carries
    wheels the ``bearings`` put a couple, whatever the direction. A rope has a ``label``, the
    points of its route.
    """

    kind: TransferKind
    name: str
    actions: tuple["Action", ...]
    bearings: tuple["Action", ...] = ()
    label: str = ""


class PointForce(NamedTuple):
    """A force on a point, per unit of its load."""

    point: str
    force: Plane


class Couple(NamedTuple):
    """A couple on a body, counter-clockwise, per unit of its load; one on the ground is taken."""

    body: str
    moment: float


class Wrench(NamedTuple):
    """A force on a body itself, not on a pin of it, and its moment about the first point."""

    body: str
    force: Plane
    moment: float


Action = PointForce | Couple | Wrench


def scaled(action: Action, factor: float) -> Action:
    """Return an action times a number."""
    match action:
        case PointForce(point, force):
            return PointForce(point, force.times(factor))
        case Couple(body, moment):
            return Couple(body, moment * factor)
        case Wrench(body, force, moment):
            return Wrench(body, force.times(factor), moment * factor)
        case _:
            assert_never(action)


@frozen
class AssembledBodies:
    """Everything that equilibrium needs, in numbers.

    ``twins`` has the bodies and points that the mirror adds, each with what it is the image of.
    """

    bodies: tuple[RigidBody, ...]
    pivots: tuple[str, ...]
    guides: tuple[Guide, ...]
    slides: tuple[Translation, ...]
    contacts: tuple[PinOnBody, ...]
    transfers: tuple[Transfer, ...]
    cylinders: tuple[Cylinder, ...]
    loads: Mapping[str, tuple[Action, ...]]
    twins: Mapping[str, str]
