"""A mechanism as free bodies for a chain: rods, levers, sliders, and pins between rods.

One half of a mirror, one branch of copies: a load on what they share counts for its part.
"""

from collections.abc import Iterator, Mapping, Sequence, Set
from fractions import Fraction
from typing import Literal

from ..algebra.angle import HALF_TURN, QUARTER, Angle
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine
from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..kinematics.joint_refs import JointRef
from ..model.mechanism import Link, Load, Mechanism, Mesh, PinFriction, Rack, Torque
from ..pose.pose import Arm, PointContact, Pose, Vector, gathered
from ..power.loads import occurrences
from ..power.reactions import Reactions
from .friction_pairs import GivenForces, LoadedPair

BodyKind = Literal["lever", "slider", "pin"]


Arms = Mapping[str, Vector]
"""Where the points of a lever are, seen from its pivot."""


class EquationsCoupled(Exception):
    """The bodies do not follow one from another."""


class BodyForce(NamedTuple):
    """A force on a body: its size along a line at a point, and a couple; no line for a couple."""

    name: str
    point: str
    line: Angle | None
    size: Product = ONE
    couple: Product = ZERO

    def scaled(self, size: Product) -> "BodyForce":
        """Return the force times a size."""
        return self._replace(size=self.size * size, couple=self.couple * size)

    def along(self, direction: Angle) -> Product:
        """Return the component in a direction."""
        return ZERO if self.line is None else self.size * cosine(self.line - direction)

    def across(self, direction: Angle) -> Product:
        """Return the component in a direction turned by +90°."""
        return ZERO if self.line is None else self.size * sine(self.line - direction)

    def moment(self, arms: Arms) -> Product:
        """Return the moment about the pivot of a lever, counter-clockwise."""
        if self.line is None:
            return self.couple
        parts = (part.length * self.across(part.angle) for part in arms[self.point])
        return add((*parts, self.couple))


@frozen
class Task:
    """The sequential solver's task: the driving load, the given ones, and the loaded pairs.

    ``owners`` gives of each load the free load that it is a multiple of, and the multiple;
    ``reactions`` the forces at joints without friction.
    """

    pose: Pose
    driving: str
    given: GivenForces
    owners: Mapping[str, tuple[str, Product]]
    loaded: Sequence[LoadedPair]
    reactions: Reactions


@frozen
class Bodies:
    """The free bodies of a task: its levers and, by their forces, its rods.

    ``fixed`` points are pivots, ``guides`` those of points. ``loaded`` are the pairs with friction
    by their joints, ``carriers`` the links that pins with friction are fast in.
    """

    task: Task
    levers: Mapping[str, Link]
    rods: Mapping[str, Link]
    loaded: Mapping[JointRef, LoadedPair]
    carriers: Mapping[str, str]
    fixed: Set[str]
    guides: Mapping[str, Angle]

    @property
    def pose(self) -> Pose:
        """Return the pose of the bodies."""
        return self.task.pose

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism that is cut into them."""
        return self.task.pose.mechanism

    def solvable(self) -> Iterator[str]:
        """Yield the levers, the slides, and the points that neither carries."""
        yield from self.levers
        yield from (s.name for s in self.mechanism.slides)
        carried = {p for k in self.levers.values() for p in k.points} | self.fixed
        carried |= {p for s in self.mechanism.slides for p in s.points}
        points = [p for k in self.rods.values() for p in k.points]
        points += [rack.point for rack in self.mechanism.each(Rack)]
        yield from dict.fromkeys(p for p in points if p not in carried)

    def kind(self, body: str) -> BodyKind:
        """Return the kind of a body."""
        if body in self.levers:
            return "lever"
        return "slider" if body in self.guides or body in self.pose.slides else "pin"

    def points(self, body: str) -> tuple[str, ...]:
        """Return the points of a body at which others may act on it."""
        if body in self.pose.slides:
            return next(s.points for s in self.mechanism.slides if s.name == body)
        if body not in self.levers:
            return (body,)
        return tuple(p for p in self.levers[body].points if p not in self.fixed)

    # --------------------------------------------------------------------------- loads

    def loads_on(self, body: str) -> Iterator[BodyForce]:
        """Yield the loads on a body, each in units of the free load that it is tied to."""
        for force, link in self._loads():
            if force.line is None and link == body:
                yield force
            elif force.line is not None and force.point in self.points(body):
                if not link:
                    self._refuse_on_rod(force.point, body)
                yield force

    def loads_at(self, pivot: str) -> Iterator[BodyForce]:
        """Yield the loads on the pin of a pivot itself, which the ground alone carries."""
        return (force for force, _ in self._loads() if force.point == pivot)

    def _loads(self) -> Iterator[tuple[BodyForce, str]]:
        """Yield the loads as forces, each with the link that it acts on, if that is said."""
        for load in self.mechanism.loads:
            owner, factor = self.task.owners[load.name]
            size = factor.scaled(self._part(load))
            for place, link, line in self._acting(load):
                if line is None:
                    yield BodyForce(owner, "", None, ZERO, size), link
                else:
                    yield BodyForce(owner, place, line, size), link

    def _acting(self, load: Load) -> Iterator[tuple[str, str, Angle | None]]:
        """Yield where a load acts, on which link if that is said, and along which line."""
        if not load.pushes:
            yield from (("", link, None) for link in load.links)
        for link, point, sense in load.pushes:
            line = self.pose.lines[load.name]
            yield point, link, line if sense > 0 else line + HALF_TURN

    def _part(self, load: Load) -> Fraction:
        """Return how much of a load one half or branch takes."""
        return load.times * occurrences(self.mechanism, load) / self.mechanism.parts

    def _refuse_on_rod(self, point: str, body: str) -> None:
        """A load on a pin that is fast in a rod and slips in a lever would bend the rod."""
        carrier = self.carriers.get(point, "")
        if body in self.levers and carrier and carrier != body:
            raise EquationsCoupled

    # ---------------------------------------------------------------------------- rods

    def rods_at(self, body: str) -> Iterator[tuple[Link, str]]:
        """Yield the rods that meet a body, and where."""
        for rod in self.rods.values():
            for point in rod.points:
                if point in self.points(body):
                    yield rod, point

    def rod(self, name: str) -> Link | None:
        """Return the rod whose force is called so."""
        return self.rods.get(name)

    def vector(self, rod: Link) -> tuple[Angle, Product]:
        """Return a rod's direction and length."""
        arms = self.pose.vector(rod.name, *rod.points)
        if len(arms) != 1:
            raise EquationsCoupled
        return arms[0].angle, arms[0].length

    def contacts_at(self, body: str) -> Iterator[tuple[PointContact, bool]]:
        """Yield the slots and contacts of a body, and whether it is the one under the pin."""
        for contact in self.pose.contacts:
            if contact.point in self.points(body):
                yield contact, False
            if contact.body == body:
                yield contact, True

    def racks_at(self, body: str) -> Iterator[tuple[Rack, bool]]:
        """Yield the racks that meet a body, and whether it is the wheel."""
        for rack in self.mechanism.each(Rack):
            if rack.link == body or rack.point in self.points(body):
                yield rack, rack.link == body

    def rack(self, name: str) -> Rack | None:
        """Return the rack whose force is called so."""
        return next((r for r in self.mechanism.each(Rack) if f"S_{r.point}" == name), None)

    def contact(self, name: str) -> PointContact | None:
        """Return the slot or contact whose force is called so."""
        return next((t for t in self.pose.contacts if f"R_{t.point}" == name), None)

    # ---------------------------------------------------------------- levers and guides

    def arms(self, lever: str) -> Arms:
        """Return where the points of a lever are, seen from its pivot."""
        pivot = self.pivot(lever)
        points = (p for p in self.levers[lever].points if p != pivot)
        arms = {p: self.pose.vector(lever, pivot, p) for p in points}
        for contact in self.pose.contacts:
            if contact.body == lever:
                tail = () if contact.tail == pivot else arms[contact.tail]
                arms[under(contact)] = gathered((*tail, *contact.reach))
        for rack, is_wheel in self.racks_at(lever):
            if is_wheel:
                across = self.pose.moved_along(rack.point) - QUARTER
                arms[pitch(rack)] = (Arm(self.pose.radii[rack.radius], across),)
        return arms

    def pivot(self, lever: str) -> str:
        """Return the point on which a lever turns."""
        return next(p for p in self.levers[lever].points if p in self.fixed)

    def guide(self, body: str) -> Angle:
        """Return the direction of the guide of a slider or slide."""
        return self.pose.slides[body] if body in self.pose.slides else self.guides[body]


def under(contact: PointContact) -> str:
    """Return the name of the place on a body that a pin touches."""
    return f"under {contact.point}"


def pitch(rack: Rack) -> str:
    """Return the name of the place at which a wheel meets its rack."""
    return f"pitch {rack.point}"


# ---------------------------------------------------------------------------- cutting


def cut_free(task: Task, cranks: bool) -> Bodies:
    """Return the free bodies of a task; with ``cranks`` pivoted links of two points are levers too.

    Raises :class:`EquationsCoupled` where there are bodies or joints of other kinds.
    """
    mechanism, fixed = task.pose.mechanism, task.pose.mechanism.fixed
    turned = {k.link for k in mechanism.loads if isinstance(k, Torque)}
    turned |= {rack.link for rack in mechanism.each(Rack)}
    levers = {k.name: k for k in mechanism.links if _is_lever(k, turned, cranks, fixed)}
    rods = {f"S_{k.name}": k for k in mechanism.links if k.name not in levers}
    loaded = {p.pair.joint: p for p in task.loaded}
    pins = (r for r in mechanism.friction.joints if isinstance(r, PinFriction))
    carriers = {r.point: r.carrier for r in pins}
    guides = task.pose.guides_and_line
    bodies = Bodies(task, levers, rods, loaded, carriers, fixed, guides)
    if _has_others(bodies, turned):
        raise EquationsCoupled
    return bodies


def _is_lever(link: Link, turned: Set[str], cranks: bool, fixed: Set[str]) -> bool:
    held = [p for p in link.points if p in fixed]
    return len(held) == 1 and (len(link.points) > 2 or link.name in turned or cranks)


def _has_others(bodies: Bodies, turned: Set[str]) -> bool:
    """Return whether there are bodies or joints that are none of the four kinds."""
    m = bodies.mechanism
    return (
        bool(m.cylinders or m.ropes or any(link.arc for link in m.links))
        or any(_is_other_mesh(mesh, bodies) for mesh in m.meshes)
        or any(p.pair.thrust for p in bodies.task.loaded)
        or any(_is_apart(load, bodies) for load in m.loads)
        or any(len(k.points) > 2 or k.name in turned for k in bodies.rods.values())
        or _has_strange_contacts(bodies)
        or _has_shared_points(bodies)
    )


def _is_other_mesh(mesh: Mesh, bodies: Bodies) -> bool:
    """Return whether two bodies mesh otherwise than a rack and a pivoted wheel."""
    if not isinstance(mesh, Rack) or mesh.link not in bodies.levers:
        return True
    return bodies.pivot(mesh.link) != mesh.pivot


def _has_strange_contacts(bodies: Bodies) -> bool:
    """Return whether a contact is on neither lever nor slide, or a point is in two of them."""
    contacts = bodies.pose.contacts
    held = {*bodies.levers, *(s.name for s in bodies.mechanism.slides)}
    is_twice = len({t.point for t in contacts}) < len(contacts)
    return is_twice or any(t.body not in held for t in contacts)


def _has_shared_points(bodies: Bodies) -> bool:
    """Return whether two levers or slides carry one point, or a lever one that is guided."""
    turning = [p for k in bodies.levers.values() for p in k.points if p not in bodies.fixed]
    carried = [*turning, *(p for s in bodies.mechanism.slides for p in s.points)]
    return len(set(carried)) < len(carried) or any(p in bodies.guides for p in turning)


def _is_apart(load: Load, bodies: Bodies) -> bool:
    """Return whether a load acts on a rod itself, or on a lever at its pivot."""
    named = [(link, point) for link, point in load.ends if link]
    return any(link not in bodies.levers or point in bodies.fixed for link, point in named)
