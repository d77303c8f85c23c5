"""What acts on every link and pin that is cut free, one half or branch of equal ones.

A rod that nothing acts on between its pins passes a force along itself. A pin that one
body alone carries is part of it; where several meet, the first carries the pin and the
others are held by two components. The ground is cut off at each body by itself. What equal
parts share is balanced along the line of symmetry alone, each part counted as often as
there are such parts.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple, assert_never

from ..algebra.angle import Angle, rational
from ..algebra.from_formula import to_product
from ..algebra.product import ONE, Product
from ..formula.tree import PI
from ..model.mechanism import (
    Contact,
    Force,
    ForcePair,
    Joint,
    Link,
    Load,
    Pivot,
    Rack,
    Rope,
    Screw,
    Slide,
    Slider,
    Slot,
    Torque,
    WheelPair,
)
from ..pose.pose import Arm, PointContact, Pose, Vector, gathered
from ..power.loads import owners
from .acts import QUARTER, Act, FreeBody, X, Y, bent, lines_of, unit
from .equilibrium import JointForce, Kind


class Cut(NamedTuple):
    """All free bodies, and the forces between them."""

    bodies: tuple[FreeBody, ...]
    forces: tuple[JointForce, ...]


def cut_free(pose: Pose) -> Cut:
    """Return every body of a mechanism, or of one of its equal parts, cut free."""
    cutting = _Cutting(pose)
    cutting.everything()
    return Cut(tuple(cutting.bodies()), tuple(cutting.forces))


class _Cutting:
    """Forces in the making, and what they act on."""

    def __init__(self, pose: Pose) -> None:
        self._pose, self._mechanism = pose, pose.mechanism
        self._taken = {p.name for p in self._mechanism.parameters}
        self._taken |= {load.name for load in self._mechanism.loads}
        self._rigid = {body.name: body.points for body in self._bodies_that_turn_or_slide()}
        self._acts: dict[str, list[Act]] = {name: [] for name in self._rigid}
        self._rods: dict[str, str] = {}
        self._owners = owners(self._mechanism)
        self.forces: list[JointForce] = []

    def _bodies_that_turn_or_slide(self) -> Iterator[Link | Slide]:
        loaded = set(bent(self._pose))
        for link in self._mechanism.links:
            if len(link.points) > 2 or link.name in loaded:
                yield link
        yield from self._mechanism.slides

    # ------------------------------------------------------------------------ gathering

    def everything(self) -> None:
        """Let all joints and loads act."""
        for link in self._mechanism.links:
            if link.name not in self._rigid:
                self._rod(link)
        for point in dict.fromkeys(p for points in self._rigid.values() for p in points):
            self._pin(point)
        for point, guide in self._pose.guides.items():
            normal = self._force("guide", (f"N_{point}",), (point,))
            self._on_pin(normal, point, guide + QUARTER, (point,))
        for touch in self._pose.touches:
            self._touch(touch)
        for joint in self._mechanism.joints:
            self._passed_on(joint)
        for load in self._mechanism.loads:
            self._load(load)

    def _force(self, kind: Kind, names: tuple[str, ...], subject: tuple[str, ...]) -> str:
        """Note a force under names that nothing else has; return the first."""
        free = []
        for name in names:
            while name in self._taken:
                name += "_"
            self._taken.add(name)
            free.append(name)
        self.forces.append(JointForce(kind, tuple(free), subject))
        return free[0]

    def _rod(self, rod: Link) -> None:
        tail, head = rod.points
        name = self._force("rod", (f"N_{rod.name}",), (rod.name,))
        self._rods[name] = rod.name
        for part, along in unit(self._pose.vector(rod.name, tail, head)):
            self._on_pin(name, tail, along, rod.points, part)
            self._on_pin(name, head, along, rod.points, -part)

    def _pin(self, point: str) -> None:
        """Hold the bodies of a pin, but for the one that carries it."""
        bodies = [name for name, points in self._rigid.items() if point in points]
        host = self._host(point)
        others = [name for name in bodies if name != host]
        for body in others:
            of = point if len(others) == 1 else f"{point}_{body}"
            if host:
                arm, lines = self._components(point, (body, host))
                names = (f"R_{of}_n", f"R_{of}_t") if arm else (f"X_{of}", f"Y_{of}")
                self._force("pin", names, (body, point, arm))
            else:
                lines = (X, Y)
                self._force("pivot", (f"X_{of}", f"Y_{of}"), (body, point))
            for name, along in zip(self.forces[-1].names, lines, strict=True):
                self._on_body(name, body, along, self._pose.frames[body][point])
                self._on_pin(name, point, along, self._rigid[body], Product(-1))

    def _components(self, point: str, bodies: Iterable[str]) -> tuple[str, tuple[Angle, Angle]]:
        """Return the arm of a body along which and across which its force at a pin is taken.

        About the other end of a crank the force along it has no moment. '' is for x and y.
        """
        for body in filter(self._rigid.__contains__, bodies):
            points = self._rigid[body]
            ends = [p for p in points if p in self._mechanism.fixed] or [
                p for p in points if len(points) == 2 and p != point
            ]
            arm = self._pose.vector(body, ends[0], point) if ends else ()
            if len(arm) == 1 and body not in self._pose.slides:
                return ends[0] + point, (arm[0].angle, arm[0].angle + QUARTER)
        return "", (X, Y)

    def _touch(self, touch: PointContact) -> None:
        """Let a body push a pin, and the pin the body."""
        name = self._force("touch", (f"N_{touch.point}",), (touch.point, touch.body))
        both = (touch.point, *self._points(touch.body))
        at = (*self._pose.frames[touch.body][touch.tail], *touch.reach)
        self._on_pin(name, touch.point, touch.normal, both)
        often = self._repeats(self._points(touch.body), both)
        self._on_body(name, touch.body, touch.normal, at, Product(-often))

    def _passed_on(self, joint: Joint) -> None:
        match joint:
            case WheelPair():
                self._wheels(joint)
            case Rack():
                self._rack(joint)
            case Screw(point, pitch, link):
                name = self._force("thread", (f"T_{point}",), (link, point))
                lead = self._pose.radii[pitch] / to_product(PI).scaled(2)
                self._on_pin(name, point, self._guide(point), self._points(link))
                self._couple(name, link, -lead)
            case Rope():
                self._rope(joint)
            case Slot(point=point, link=link, guided=guided) if guided:
                name = self._force("couple", (f"M_{point}",), (guided, link))
                self._couple(name, guided, ONE)
                self._couple(name, link, Product(-1))
            case Pivot() | Slider() | Slot() | Contact():
                pass  # they hold points
            case _:
                assert_never(joint)

    def _wheels(self, pair: WheelPair) -> None:
        """Let two rims push each other along, and their centres push the arm."""
        name = self._force("rim", (f"T_{pair.first}{pair.second}",), pair.points)
        first = self._pose.radii[pair.first_radius]
        second = self._pose.radii[pair.second_radius].scaled(-1 if pair.same else 1)
        self._couple(name, pair.first_link, first)
        self._couple(name, pair.second_link, second)
        self._couple(name, pair.arm, -first)
        self._couple(name, pair.arm, -second)

    def _rack(self, rack: Rack) -> None:
        name = self._force("rack", (f"T_{rack.point}",), (rack.pivot, rack.point))
        along = self._guide(rack.point)
        down = Arm(self._pose.radii[rack.radius], along - QUARTER)
        self._on_pin(name, rack.point, along, self._points(rack.link))
        at = (*self._pose.frames[rack.link][rack.pivot], down)
        self._on_body(name, rack.link, along, at, Product(-1))

    def _rope(self, rope: Rope) -> None:
        """Let one tension draw the ends of each fall together."""
        name = self._force("rope", (f"S_{rope.route[0]}",), rope.route[:1])
        for (tail, head), way in zip(pairwise(rope.route), self._pose.falls[rope.id], strict=True):
            self._on_pin(name, tail, way, rope.points)
            self._on_pin(name, head, way, rope.points, Product(-1))

    def _load(self, load: Load) -> None:
        """Let a load act, under the name of the one that it is tied to."""
        owner, part = self._owners[load.name]
        size = part.scaled(rational(load.times))
        match load:
            case Torque(_, link):
                self._couple(owner, link, size)
            case Force(name, point, link=link):
                act = Act(owner, size, self._pose.lines[name])
                self._at(act, link, point, self._points(link) or (point,))
            case ForcePair(name, first, second, first_link=one, second_link=other):
                act = Act(owner, size, self._pose.lines[name])
                if second == f"{first}'":
                    self._at(act, one, first, (first,))
                else:
                    self._at(act._replace(size=-size), one, first, (first, second))
                    self._at(act, other, second, (first, second))
            case _:
                assert_never(load)

    # -------------------------------------------------------------------------- what acts where

    def _at(self, act: Act, link: str, point: str, points: Iterable[str]) -> None:
        """Let a load act on a link at a point, or on the pin there."""
        assert act.along is not None, "what acts at a point is a force"
        if link in self._rigid:
            at = self._pose.frames[link][point]
            self._on_body(act.name, link, act.along, at, act.size)
        else:
            self._on_pin(act.name, point, act.along, points, act.size)

    def _host(self, point: str) -> str:
        """Return the body that carries a pin, the pin where none does; '' for the ground."""
        if point in self._mechanism.fixed:
            return ""
        bodies = (name for name, points in self._rigid.items() if point in points)
        return next((b for b in bodies if self._repeats((point,), self._rigid[b]) == 1), point)

    def _repeats(self, host: Iterable[str], points: Iterable[str]) -> int:
        """Return how many equal parts put the same on what they share."""
        ratio = self._mechanism.repeats(points) / self._mechanism.repeats(host)
        return int(ratio)

    def _on_pin(
        self, name: str, point: str, along: Angle, by: Iterable[str], size: Product = ONE
    ) -> None:
        """Let what goes through some points act on what carries a pin."""
        if host := self._host(point):
            frame = self._pose.frames[host][point] if host in self._rigid else ()
            often = self._repeats(self._rigid.get(host, (point,)), by)
            self._on_body(name, host, along, frame, size.scaled(often))

    def _on_body(self, name: str, body: str, along: Angle, at: Vector, size: Product = ONE) -> None:
        self._acts.setdefault(body, []).append(Act(name, size, along, gathered(at)))

    def _couple(self, name: str, body: str, size: Product) -> None:
        if body:
            self._acts[body].append(Act(name, size, None))

    def _points(self, body: str) -> tuple[str, ...]:
        return tuple(self._pose.frames[body]) if body else ()

    def _guide(self, point: str) -> Angle:
        guide = self._pose.guide_of(point)
        assert guide is not None, "the model lets racks and screws move guided points only"
        return guide

    # ------------------------------------------------------------------------------ what is left

    def bodies(self) -> Iterator[FreeBody]:
        """Yield every body that something acts on."""
        for name, acts in self._acts.items():
            points = self._rigid.get(name, (name,))
            rods = {a.name: self._rods[a.name] for a in acts if a.name in self._rods}
            guide = self._guide_of(name)
            frame: Mapping[str, Vector] = {}
            if any(group.shares(points) for group in self._mechanism.symmetries):
                lines = [line for line in [self._axis()] if line is not None]
            elif name in self._pose.slides:
                lines = [self._pose.slides[name]]
            else:
                frame = self._pose.frames[name] if name in self._rigid else {}
                lines = list(lines_of(acts, guide))
            yield FreeBody(name, tuple(acts), frame, tuple(lines), guide, rods)

    def _guide_of(self, body: str) -> Angle | None:
        if body in self._pose.slides:
            return self._pose.slides[body]
        return self._pose.guides.get(body)

    def _axis(self) -> Angle | None:
        """Return the line along which what equal parts share can move."""
        if self._pose.axis is not None:
            return self._pose.axis
        shared = self._mechanism.shared
        return next((g for p, g in self._pose.guides.items() if p in shared), None)
