"""A mechanism as free bodies for a chain: rods, levers, sliders, and pins between rods.

One half of a mirror, one branch of copies: a load on what they share counts for its part.
"""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Literal, assert_never

from ..algebra.angle import Angle
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add
from ..algebra.trigonometry import cosine, sine
from ..frozen import frozen
from ..kinematics.joint_refs import JointRef, held_end
from ..model.mechanism import Force, ForcePair, Link, Load, PinFriction, Torque
from ..named import NamedTuple
from ..pose.pose import PointContact, Pose, Vector, gathered
from ..power.definitions import bound_names
from ..power.loads import occurrences
from ..power.reactions import Reactions
from .normal_forces import Given, LoadedPair

Kind = Literal["lever", "slider", "pin"]

HALF_TURN = Angle.constant(180)


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


class Surface(NamedTuple):
    """Friction of a body at a joint: its factor, its slip, and 1, or -1 for a slip turned round.

    ``pressed`` is, of a guide, the ideal force across it.
    """

    name: str
    factor: Product
    slip: Product
    turn: int = 1
    pressed: Product = ZERO


@frozen
class Task:
    """The sequential solver's task: the driving load, the given ones, and the loaded pairs.

    ``owners`` gives of each load the free load that it is a multiple of, and the multiple;
    ``reactions`` the forces at joints without friction.
    """

    pose: Pose
    driving: str
    given: Given
    owners: Mapping[str, tuple[str, Product]]
    pressed: Sequence[LoadedPair]
    reactions: Reactions


class Bodies:
    """The free bodies of a task; with ``cranks`` pivoted links of two points are levers too."""

    def __init__(self, task: Task, cranks: bool) -> None:
        self.task, self._pose, self._mechanism = task, task.pose, task.pose.mechanism
        self._pressed = {p.pair.joint: p for p in task.pressed}
        joints = self._mechanism.friction.joints
        self._carriers = {r.point: r.carrier for r in joints if isinstance(r, PinFriction)}
        self._compressions: dict[str, Product] = {}
        self._fixed = self._mechanism.fixed
        self._guides = task.pose.guides_and_line
        turned = {k.link for k in self._mechanism.loads if isinstance(k, Torque)}
        self._levers = {
            k.name: k for k in self._mechanism.links if self._is_lever(k, turned, cranks)
        }
        self._rods = {f"S_{k.name}": k for k in self._mechanism.links if k.name not in self._levers}
        self._refuse_the_rest(turned)

    def _is_lever(self, link: Link, turned: set[str], cranks: bool) -> bool:
        held = [p for p in link.points if p in self._fixed]
        return len(held) == 1 and (len(link.points) > 2 or link.name in turned or cranks)

    def _refuse_the_rest(self, turned: set[str]) -> None:
        """Raise :class:`EquationsCoupled` for bodies and joints that are none of the four kinds."""
        m = self._mechanism
        if (
            (m.cylinders or m.meshes or m.ropes or any(link.arc for link in m.links))
            or any(p.pair.thrust for p in self.task.pressed)
            or any(self._is_apart(load) for load in m.loads)
            or any(len(k.points) > 2 or k.name in turned for k in self._rods.values())
            or self._has_strange_touches()
            or self._has_shared_points()
        ):
            raise EquationsCoupled

    def _has_strange_touches(self) -> bool:
        """Return whether a contact is on neither lever nor slide, or a point is in two of them."""
        touches = self._pose.touches
        held = {*self._levers, *(s.name for s in self._mechanism.slides)}
        is_twice = len({t.point for t in touches}) < len(touches)
        return is_twice or any(t.body not in held for t in touches)

    def _has_shared_points(self) -> bool:
        """Return whether two levers or slides carry one point, or a lever one that is guided."""
        turning = [p for k in self._levers.values() for p in k.points if p not in self._fixed]
        carried = [*turning, *(p for s in self._mechanism.slides for p in s.points)]
        return len(set(carried)) < len(carried) or any(p in self._guides for p in turning)

    def _is_apart(self, load: Load) -> bool:
        """Return whether a load acts on a rod itself, or on a lever at its pivot."""
        match load:
            case Force(point=point, link=link):
                ends = [(link, point)]
            case ForcePair(first=first, second=second):
                ends = [(load.first_link, first), (load.second_link, second)]
            case _:
                return False
        named = [(link, point) for link, point in ends if link]
        return any(link not in self._levers or point in self._fixed for link, point in named)

    def solvable(self) -> Iterator[str]:
        """Yield the levers, the slides, and the points that neither carries."""
        yield from self._levers
        yield from (s.name for s in self._mechanism.slides)
        carried = {p for k in self._levers.values() for p in k.points} | self._fixed
        carried |= {p for s in self._mechanism.slides for p in s.points}
        yield from dict.fromkeys(
            p for k in self._rods.values() for p in k.points if p not in carried
        )

    def kind(self, body: str) -> Kind:
        """Return the kind of a body."""
        if body in self._levers:
            return "lever"
        return "slider" if body in self._guides or body in self._pose.slides else "pin"

    def _points(self, body: str) -> tuple[str, ...]:
        if body in self._pose.slides:
            return next(s.points for s in self._mechanism.slides if s.name == body)
        if body not in self._levers:
            return (body,)
        return tuple(p for p in self._levers[body].points if p not in self._fixed)

    # --------------------------------------------------------------------------- loads

    def loads_on(self, body: str) -> Iterator[BodyForce]:
        """Yield the loads on a body, each in units of the free load that it is tied to."""
        for load in self._mechanism.loads:
            owner, factor = self.task.owners[load.name]
            for place, link, line in self._acting(load):
                size = factor.scaled(self._part(load))
                if line is None and link == body:
                    yield BodyForce(owner, "", None, ZERO, size)
                elif line is not None and place in self._points(body):
                    if not link:
                        self._refuse_on_rod(place, body)
                    yield BodyForce(owner, place, line, size)

    def _acting(self, load: Load) -> Iterator[tuple[str, str, Angle | None]]:
        """Yield where a load acts, on which link if that is said, and along which line."""
        match load:
            case Force(name, point, link=link):
                yield point, link, self._pose.lines[name]
            case Torque(link=link):
                yield "", link, None
            case ForcePair(name, first) if load.joins_twins:
                yield first, load.first_link, self._pose.lines[name]
            case ForcePair(name, first, second):
                yield second, load.second_link, self._pose.lines[name]
                yield first, load.first_link, self._pose.lines[name] + HALF_TURN
            case _:
                assert_never(load)

    def _part(self, load: Load) -> Fraction:
        """Return how much of a load one half or branch takes."""
        return load.times * occurrences(self._mechanism, load) / self._mechanism.parts

    def _refuse_on_rod(self, point: str, body: str) -> None:
        """A load on a pin that is fast in a rod and slips in a lever would bend the rod."""
        carrier = self._carriers.get(point, "")
        if body in self._levers and carrier and carrier != body:
            raise EquationsCoupled

    # ---------------------------------------------------------------------------- rods

    def rods_at(self, body: str) -> Iterator[tuple[Link, str]]:
        """Yield the rods that meet a body, and where."""
        for rod in self._rods.values():
            for point in rod.points:
                if point in self._points(body):
                    yield rod, point

    def rod(self, name: str) -> Link | None:
        """Return the rod whose force is called so."""
        return self._rods.get(name)

    def vector(self, rod: Link) -> tuple[Angle, Product]:
        """Return a rod's direction and length."""
        arms = self._pose.vector(rod.name, *rod.points)
        if len(arms) != 1:
            raise EquationsCoupled
        return arms[0].angle, arms[0].length

    def compression(self, rod: Link) -> Product:
        """Return the ideal force by which a rod is pressed, unless that is a long sum."""
        if rod.name not in self._compressions:
            self._compressions[rod.name] = self._compression(rod)
        return self._compressions[rod.name]

    def _compression(self, rod: Link) -> Product:
        end = held_end(self._mechanism, rod)
        found = self.task.reactions.of(JointRef("pin", end, rod.name))
        if found is None:
            raise EquationsCoupled
        outwards = self.vector(rod)[0]
        along = found.along(outwards if end == rod.points[1] else outwards + HALF_TURN)
        pressed = -add(along[n] * size for n, size in self.task.given.items() if n in along)
        if any(bound_names(pressed)):
            raise EquationsCoupled
        return pressed

    def surface(self, point: str, rod: Link) -> Surface | None:
        """Return the friction of a rod at one of its ends: in what carries the pin, or about it."""
        own = self._pressed.get(JointRef("pin", point, rod.name))
        if own:
            return _surface(own)
        others = [p for b, p in self._pressed.items() if b.kind == "pin" and b.point == point]
        if self._carriers.get(point) != rod.name or not others:
            return None
        if len(others) > 1 or self._is_pressed_besides(point):
            raise EquationsCoupled
        return _surface(others[0])._replace(turn=-1)

    def _is_pressed_besides(self, point: str) -> bool:
        """Return whether a pin has a guide, or is on a lever and in a slot or contact.

        Then two links press one another at the pin with other forces than it has from them.
        """
        slides = bool(self._mechanism.slides_at(point))
        turning = any(point in k.points for k in self._levers.values())
        touching = any(touch.point == point for touch in self._pose.touches)
        return point in self._guides or slides or (turning and touching)

    def touches_at(self, body: str) -> Iterator[tuple[PointContact, bool]]:
        """Yield the slots and contacts of a body, and whether it is the one under the pin."""
        for touch in self._pose.touches:
            if touch.point in self._points(body):
                yield touch, False
            if touch.body == body:
                yield touch, True

    def touch(self, name: str) -> PointContact | None:
        """Return the slot or contact whose force is called so."""
        return next((t for t in self._pose.touches if f"R_{t.point}" == name), None)

    def face(self, touch: PointContact) -> Surface | None:
        """Return the friction of a pin on the body under it, with the ideal force on the pin."""
        pressed = self._pressed.get(JointRef("touch", touch.point))
        if pressed is None:
            return None
        (component,) = pressed.components
        return _surface(pressed)._replace(pressed=component.ideal)

    def has_friction(self, point: str) -> bool:
        """Return whether there is friction at a pin."""
        return any(b.kind == "pin" and b.point == point for b in self._pressed)

    # ---------------------------------------------------------------- levers and guides

    def arms(self, lever: str) -> dict[str, Vector]:
        """Return where the points of a lever are, seen from its pivot."""
        pivot = self.pivot(lever)
        points = (p for p in self._levers[lever].points if p != pivot)
        arms = {p: self._pose.vector(lever, pivot, p) for p in points}
        for touch in self._pose.touches:
            if touch.body == lever:
                tail = () if touch.tail == pivot else arms[touch.tail]
                arms[under(touch)] = gathered((*tail, *touch.reach))
        return arms

    def pivot(self, lever: str) -> str:
        """Return the point on which a lever turns."""
        return next(p for p in self._levers[lever].points if p in self._fixed)

    def bearing(self, lever: str) -> Surface | None:
        """Return the friction of a lever on its pivot."""
        pressed = self._pressed.get(JointRef("pin", self.pivot(lever), lever))
        return _surface(pressed) if pressed else None

    def guide(self, body: str) -> Angle:
        """Return the direction of the guide of a slider or slide."""
        return self._pose.slides[body] if body in self._pose.slides else self._guides[body]

    def sliding(self, body: str) -> Surface | None:
        """Return the friction on the guide of a slider or slide, and the ideal force across it."""
        joint_refs = [
            JointRef("ground", body),
            *(JointRef("slide", p, body) for p in self._points(body)),
        ]
        pressed = next((self._pressed[b] for b in joint_refs if b in self._pressed), None)
        if pressed is None:
            return None
        (component,) = pressed.components
        return _surface(pressed)._replace(pressed=-component.ideal)


def under(touch: PointContact) -> str:
    """Return the name of the place on a body that a pin touches."""
    return f"under {touch.point}"


def _surface(pressed: LoadedPair) -> Surface:
    return Surface(pressed.pair.name, pressed.pair.factor, pressed.slip)
