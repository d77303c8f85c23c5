"""A joint by what holds there, and what hangs on it: to be released, or to state its force."""

from typing import Literal

from ..base.named import NamedTuple
from ..model.mechanism import Link, Mechanism, WheelPair
from ..pose.pose import PointContact, Pose


class JointRef(NamedTuple):
    """What is released: ``pin`` of a link, ``ground``, guide of a ``slide``, ``contact``, ``mesh``.

    ``of`` is the name of the link or slide. A ``mesh`` is that of wheels, a rack, a thread or a
    rope: it has the joint's first point, and ``of`` is the joint's id. The ``thrust`` of a link
    along the axis of its pivot is given, so that it is never released.
    """

    kind: Literal["pin", "ground", "slide", "contact", "mesh", "thrust"]
    point: str
    of: str = ""

    @property
    def loose(self) -> str:
        """Return the name of the link's own point, once it has left the pin."""
        return f"{self.point} of {self.of}" if self.kind == "pin" else self.point


def held_end(mechanism: Mechanism, link: Link) -> str:
    """Return an end of a rod that something else holds: its last one, if that is.

    At an end where a load acts on the rod itself the pin gives not all of the force along it.
    """
    loaded = {end for load in mechanism.loads for end in load.ends}
    held = {point for joint in mechanism.joints for point in joint.held}

    def is_held(point: str) -> bool:
        if (link.name, point) in loaded:
            return False
        others = sum(point in k.points for k in mechanism.links) > 1
        return others or bool(mechanism.slides_at(point)) or point in held

    return next((p for p in reversed(link.points) if is_held(p)), link.points[-1])


def unclear(mechanism: Mechanism) -> frozenset[str]:
    """Return the pins on which wheels and screws press in directions that are undetermined.

    A rack presses along its guide.
    """
    pressing = [mesh for mesh in mechanism.meshes if mesh.presses_aside]
    turning = {link for joint in pressing for link in joint.bodies}
    held = (p for k in mechanism.links if k.name in turning for p in k.points)
    centres = {p for j in pressing if isinstance(j, WheelPair) for p in j.points}
    return mechanism.fixed.intersection(held) | centres


def members(pose: Pose, joint: JointRef) -> tuple[str, ...]:
    """Return the points of all that a joint holds; it is shared by halves where they all are."""
    if joint.kind == "contact":
        return (joint.point, *pose.frames[contact_at(pose, joint.point).body])
    if joint.kind == "mesh":
        mesh = pose.mechanism.joint(joint.of)
        return (*mesh.points, *(p for body in mesh.bodies for p in pose.frames[body]))
    return tuple(pose.frames[joint.of]) if joint.of else (joint.point,)


def contact_at(pose: Pose, point: str) -> PointContact:
    """Return the slot or contact of a point."""
    return next(t for t in pose.contacts if t.point == point)
