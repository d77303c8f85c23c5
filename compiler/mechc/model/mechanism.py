"""The mechanism: names resolved, quantities in SI, dimensions checked.

Formulas in here mention parameters only (and, in lets and ties, loads and results);
every definition is acyclic. Points are strings (``"A"``, ``"O1"``), and each link's
points are in the order the user named them.
"""

from collections.abc import Iterable, Mapping
from fractions import Fraction
from math import prod
from types import MappingProxyType
from typing import TypeVar

from ..base.frozen import frozen, replace
from ..formula.tree import Formula, Number
from ..formula.walk import symbols
from ..source import Span
from ..units import ANGLE
from .parts.friction import CollarFriction as CollarFriction
from .parts.friction import FaceFriction as FaceFriction
from .parts.friction import Friction as Friction
from .parts.friction import GuideFriction as GuideFriction
from .parts.friction import JointFriction as JointFriction
from .parts.friction import PinFriction as PinFriction
from .parts.friction import PivotFriction as PivotFriction
from .parts.friction import RopeFriction as RopeFriction
from .parts.friction import ThreadFriction as ThreadFriction
from .parts.friction import WheelFriction as WheelFriction
from .parts.friction import coulomb as coulomb
from .parts.friction import tension_share as tension_share
from .parts.holding import Feed as Feed
from .parts.holding import Meshing as Meshing
from .parts.joints import Contact as Contact
from .parts.joints import Joint as Joint
from .parts.joints import Mesh as Mesh
from .parts.joints import Pivot as Pivot
from .parts.joints import Rack as Rack
from .parts.joints import Rope as Rope
from .parts.joints import Screw as Screw
from .parts.joints import Slider as Slider
from .parts.joints import Slot as Slot
from .parts.joints import WheelPair as WheelPair
from .parts.linkage import Absolute as Absolute
from .parts.linkage import AlongLine as AlongLine
from .parts.linkage import ArcSlot as ArcSlot
from .parts.linkage import Assembly as Assembly
from .parts.linkage import Body as Body
from .parts.linkage import Copies as Copies
from .parts.linkage import Direction as Direction
from .parts.linkage import Drawn as Drawn
from .parts.linkage import Drive as Drive
from .parts.linkage import Link as Link
from .parts.linkage import Mirror as Mirror
from .parts.linkage import Slide as Slide
from .parts.linkage import Subassembly as Subassembly
from .parts.linkage import Telescope as Telescope
from .parts.loads import Force as Force
from .parts.loads import ForcePair as ForcePair
from .parts.loads import Load as Load
from .parts.loads import Spread as Spread
from .parts.loads import Torque as Torque
from .parts.quantities import Expect as Expect
from .parts.quantities import Find as Find
from .parts.quantities import Interval as Interval
from .parts.quantities import Let as Let
from .parts.quantities import Parameter as Parameter
from .parts.quantities import Reported as Reported
from .parts.quantities import Require as Require
from .parts.quantities import Subject as Subject
from .parts.quantities import Taken as Taken
from .parts.targets import Axial as Axial
from .parts.targets import ComponentPart as ComponentPart
from .parts.targets import Efficiency as Efficiency
from .parts.targets import ForceAtJoint as ForceAtJoint
from .parts.targets import LoadForm as LoadForm
from .parts.targets import LoadRatio as LoadRatio
from .parts.targets import Normal as Normal
from .parts.targets import Reaction as Reaction
from .parts.targets import ResultTarget as ResultTarget
from .parts.targets import Sense as Sense
from .parts.targets import Speed as Speed
from .parts.targets import SpeedRatio as SpeedRatio
from .parts.targets import WithFriction as WithFriction
from .parts.written import WrittenTable

J = TypeVar("J", bound=Joint)

GRAVITY = Number(Fraction("9.80665"))
"""The standard acceleration of free fall in m/s²."""


@frozen
class Arrow:
    """A vector from ``tail`` to ``head``: what is given of its length and direction."""

    tail: str
    head: str
    length: Formula | None
    direction: Direction | None
    span: Span


@frozen
class Offset:
    """A vector from ``tail`` to ``head`` by its components.

    ``tail`` is ``""`` for the origin of the plane: ``pivot O at (x, y)``.
    """

    tail: str
    head: str
    x: Formula
    y: Formula
    span: Span


@frozen
class Turn:
    """The counter-clockwise angle at ``vertex`` from ``vertex→first`` to ``vertex→second``."""

    first: str
    vertex: str
    second: str
    angle: Formula
    span: Span


Geometry = Arrow | Offset | Turn


@frozen
class Mechanism:
    """A whole description, resolved and checked.

    ``literals`` are the lengths that it gives by numbers, each once, under names that it does
    not use: formulas have a :class:`~..formula.tree.Constant` for each. ``held`` are the drives
    that stay at their values while ``drive`` moves. ``reported`` is what a report holds, all where
    nothing says so. A calculation sheet may have results ``taken`` from mechanisms that it uses;
    ``subassemblies`` are mechanisms that are parts of it. Quantities and tables that used
    descriptions have are ``brought`` in, under ``prefixes`` unless they are parts.
    """

    name: str
    title: str
    source: str
    span: Span
    parameters: tuple[Parameter, ...] = ()
    literals: tuple[Parameter, ...] = ()
    links: tuple[Link, ...] = ()
    slides: tuple[Slide, ...] = ()
    telescopes: tuple[Telescope, ...] = ()
    joints: tuple[Joint, ...] = ()
    drive: Drive | None = None
    held: tuple[Drive, ...] = ()
    assemblies: tuple[Assembly, ...] = ()
    geometry: tuple[Geometry, ...] = ()
    drawn: tuple[Drawn, ...] = ()
    loads: tuple[Load, ...] = ()
    mirror: Mirror | None = None
    copies: Copies | None = None
    friction: Friction = Friction()
    finds: tuple[Find, ...] = ()
    lets: tuple[Let, ...] = ()
    requires: tuple[Require, ...] = ()
    implied: tuple[Require, ...] = ()
    """What tables, lists and choices demand of the pose and of results: without it, no value."""
    expects: tuple[Expect, ...] = ()
    tables: tuple[WrittenTable, ...] = ()
    reported: tuple[Reported, ...] = ()
    translations: Mapping[str, Mapping[str, str]] = MappingProxyType({})
    """By language, what texts of the description are in it."""
    taken: tuple[Taken, ...] = ()
    subassemblies: tuple[Subassembly, ...] = ()
    brought: frozenset[str] = frozenset()
    prefixes: tuple[str, ...] = ()
    spans: Mapping[str, Span] = MappingProxyType({})
    """Where each point was first named."""

    @property
    def drives(self) -> tuple[Drive, ...]:
        """Return the drive that moves, if there is one, then those that are held."""
        return (*([self.drive] if self.drive else []), *self.held)

    def texts(self, language: str) -> Mapping[str, str]:
        """Return the translations of texts and names into a language, none where there are none."""
        return self.translations.get(language, {})

    @property
    def drive_name(self) -> str:
        """Return the parameter that the drive moves, '' where there is none."""
        return self.drive.parameter if self.drive else ""

    @property
    def angles(self) -> frozenset[str]:
        """Return the parameters that are angles."""
        return frozenset(p.name for p in self.parameters if p.dimension == ANGLE)

    @property
    def bodies(self) -> tuple[Body, ...]:
        """Return the links, the slides and the telescopes."""
        return (*self.links, *self.slides, *self.telescopes)

    @property
    def rigid_bodies(self) -> tuple[Link | Slide, ...]:
        """Return the links and the slides."""
        return (*self.links, *self.slides)

    def each(self, kind: type[J]) -> tuple[J, ...]:
        """Return the joints of one kind."""
        return tuple(joint for joint in self.joints if isinstance(joint, kind))

    @property
    def meshes(self) -> tuple[Mesh, ...]:
        """Return the wheels, racks and screws."""
        return tuple(j for j in self.joints if isinstance(j, Meshing))

    @property
    def brought_angles(self) -> frozenset[str]:
        """Return the angles that parts of it have brought in with a value of their own."""
        prefixes = tuple(f"{part.prefix}_" for part in self.subassemblies)
        mine = (p for p in self.parameters if p.name.startswith(prefixes) and p.value is not None)
        return frozenset(p.name for p in mine if p.dimension == ANGLE and not p.dependent)

    @property
    def ropes(self) -> tuple[Rope, ...]:
        """Return the ropes."""
        return self.each(Rope)

    @property
    def rigid_links(self) -> tuple[Link, ...]:
        """Return the links that are bodies: no rods that stand for circular slots."""
        return tuple(link for link in self.links if link.arc is None)

    def joint(self, id: str) -> Joint:
        """Return the joint of an ``id``."""
        return next(joint for joint in self.joints if joint.id == id)

    def parameter(self, name: str) -> Parameter:
        """Return the parameter of a name."""
        return next(p for p in self.parameters if p.name == name)

    def link(self, name: str) -> Link:
        """Return the link of a name."""
        return next(link for link in self.links if link.name == name)

    def arc_of(self, rod: str) -> ArcSlot | None:
        """Return the circular slot that a rod stands for, None for what is a body."""
        return next((link.arc for link in self.links if link.name == rod), None)

    def arc_at(self, pin: str) -> tuple[Link, ArcSlot] | None:
        """Return the circular slot in which a pin slides, behind the rod that stands for it."""
        found = ((k, k.arc) for k in self.links if k.arc and k.points[1] == pin)
        return next(found, None)

    @property
    def fixed(self) -> frozenset[str]:
        """Return the points that are pinned to the ground."""
        return frozenset(pivot.point for pivot in self.each(Pivot))

    def slides_at(self, point: str) -> tuple[Slide, ...]:
        """Return the bodies that only translate and have a point."""
        return tuple(slide for slide in self.slides if point in slide.points)

    @property
    def symmetries(self) -> tuple[Mirror | Copies, ...]:
        """Return the mirror and the copies, as far as there are any."""
        return tuple(group for group in (self.mirror, self.copies) if group is not None)

    @property
    def moved(self) -> "Mechanism":
        """Return it where its drives, and what has a value from outside, are set to.

        It is drawn with the values of the description.
        """
        starts = {drive.parameter: drive.start for drive in self.drives if drive.start}
        parameters = [
            replace(p, outside=starts[p.name]) if p.name in starts else p for p in self.parameters
        ]
        if not any(p.outside for p in parameters):
            return self
        return replace(self, parameters=tuple(p.moved for p in parameters))

    @property
    def shared(self) -> frozenset[str]:
        """Return the points that halves or branches have in common."""
        return frozenset(point for group in self.symmetries for point in group.sharing)

    def is_on_the_line(self, points: Iterable[str]) -> bool:
        """Whether there is a mirror, and both halves share what goes through these points."""
        return self.mirror is not None and self.mirror.shares(points)

    def repeats(self, points: Iterable[str]) -> Fraction:
        """Return how often the whole mechanism has what goes through these points."""
        there = set(points)
        own = (group.number for group in self.symmetries if not group.shares(there))
        return prod(own, start=Fraction(1))

    @property
    def parts(self) -> Fraction:
        """Return how many halves and branches the whole mechanism has."""
        return prod((group.number for group in self.symmetries), start=Fraction(1))

    @property
    def follow(self) -> frozenset[str]:
        """Return the formulas brought in that are made of results: loads of used mechanisms."""
        taken = {known.name for known in self.taken}
        lets = (let for let in self.lets if let.name in self.brought)
        return frozenset(let.name for let in lets if symbols(let.value) & taken)

    @property
    def cylinders(self) -> tuple[Telescope, ...]:
        """Return the telescopes under load whose end pins have friction, which bends them."""
        loaded = {load.first_link for load in self.loads if isinstance(load, ForcePair)}
        return tuple(t for t in self.telescopes if t.name in loaded)

    def pairs_at_pins(self) -> tuple[ForcePair, ...]:
        """Return the pairs of forces at whose ends pins may be meant.

        None are where a telescope holds them, or where each end names the link that it acts on.
        """
        ends = {frozenset(telescope.points) for telescope in self.telescopes}
        pairs = (k for k in self.loads if isinstance(k, ForcePair))
        return tuple(k for k in pairs if frozenset(k.points) not in ends and self.loose_ends(k))

    def loose_ends(self, pair: ForcePair) -> list[str]:
        """Return the ends of a pair of forces on a body that is not named."""
        return [point for link, point in pair.ends if not link and self.turning_at(point)]

    def turning_at(self, point: str) -> tuple[str, ...]:
        """Return the links and the cylinders that turn on a pin."""
        bodies: tuple[Link | Telescope, ...] = (*self.rigid_links, *self.cylinders)
        return tuple(body.name for body in bodies if point in body.points)
