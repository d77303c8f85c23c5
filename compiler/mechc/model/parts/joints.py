"""The joints of a mechanism.

Every joint says in its docstring what it asks of velocities; what it transmits follows
from its mechanics in statics, never from this. Each has an ``id`` that no other has, the
``points`` that it holds and the ``bodies`` (links, slides) that it names. Pins that links
share are no joints of their own: the links' points say them.
"""

from collections.abc import Iterable, Sequence
from typing import Literal

from ...base.frozen import frozen, replace
from ...formula.tree import Formula, negative, total
from ...source import Span
from .holding import (
    Feed,
    HoldsNothing,
    Meshing,
    OnePoint,
    OnGround,
    OnLine,
    SizeLetter,
    Tied,
    Unsized,
)
from .linkage import Direction


@frozen
class Pivot(OnePoint, OnGround, Unsized):
    """A point pinned to the ground."""

    point: str
    span: Span

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"pivot {self.point}"


@frozen
class Slider(OnePoint, OnGround, Unsized):
    """A point guided by the ground; ``through`` is a point of the guide's line, if given.

    ``is_of_slide`` marks the guide that states where a drawn slide runs, for loops to close. It
    holds nothing: the slide has a guide of its own, and a pose has no such joint.
    """

    point: str
    along: Direction
    span: Span
    through: str | None = None
    is_of_slide: bool = False

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"slider {self.point}"


@frozen
class Slot(OnLine):
    """Pin ``point`` slides along the line from ``tail`` to ``head`` of a link.

    (V_B − V of the link's point under B) · normal of the line = 0. A ``guided`` link is fast
    in the block on the pin, so that it turns with the link that has the slot.
    """

    point: str
    link: str
    tail: str
    head: str
    span: Span
    guided: str = ""

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"slot {self.point} in {self.tail}{self.head}"

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return (self.link, self.guided) if self.guided else (self.link,)


@frozen
class Contact(OnLine):
    """``point`` of its own link touches ``link`` (its line ``tail``–``head``).

    ``normal`` is the direction in which the link pushes the point; it can only push.
    (V_A − V of the link's point under A) · normal = 0.
    """

    point: str
    link: str
    tail: str
    head: str
    normal: Direction
    span: Span

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"contact {self.point} on {self.tail}{self.head}"


@frozen
class WheelPair(Meshing):
    """Two wheels, each fixed to a link on its centre: a pair of gears, a belt, a chain.

    Seen from the ``arm``, the link that carries both centres, ω₁ r₁ = ω₂ r₂ where ``same`` is
    True (belt, internal gears), else ω₁ r₁ = −ω₂ r₂ (external gears, crossed belt). An arm or
    a link of '' is the ground. ``kind`` is the word of the language.
    """

    kind: Literal["gear", "belt"]
    first: str
    first_link: str
    first_radius: Formula
    second: str
    second_link: str
    second_radius: Formula
    same: bool
    span: Span
    arm: str = ""

    @property
    def id(self) -> str:
        """Return the joint's name among all joints; wheels on an arm share their centres."""
        if not self.arm:
            return f"{self.kind} {self.first}, {self.second}"
        first, second = (link or "the ground" for link in self.wheels)
        return f"{self.kind} {first} at {self.first}, {second} at {self.second}"

    @property
    def described(self) -> str:
        """Return how messages name it."""
        between = "pair of gears on" if self.kind == "gear" else "belt between"
        return f"the {between} {self.first} and {self.second}"

    @property
    def wheels(self) -> tuple[str, str]:
        """Return the links that the wheels are fixed to."""
        return (self.first_link, self.second_link)

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds."""
        return (self.first, self.second)

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return tuple(name for name in (*self.wheels, self.arm) if name)

    @property
    def tied(self) -> tuple[Tied, ...]:
        """Return the turns of both wheels, and of the arm, times their radii."""
        ahead = self.first_radius
        back = negative(self.second_radius) if self.same else self.second_radius
        arm = negative(total([ahead, back]))
        wheels = Tied(self.first_link, "", ahead), Tied(self.second_link, "", back)
        return (*wheels, Tied(self.arm, "", arm))

    @property
    def sizes(self) -> tuple[SizeLetter, SizeLetter]:
        """Return the radii of both wheels."""
        first = SizeLetter("r", self.first, self.first_radius)
        return first, SizeLetter("r", self.second, self.second_radius)

    def with_sizes(self, formulas: Sequence[Formula]) -> "WheelPair":
        """Return the pair with other radii."""
        first, second = formulas
        return replace(self, first_radius=first, second_radius=second)


@frozen
class Rack(Feed):
    """A slider, or a point of a slide, carries a rack that a gear on ``pivot`` drives.

    V of the slider along its guide = ω · radius: the rack passes the pivot on the right of
    the guide's direction; a negative radius puts it on the left.
    """

    point: str
    pivot: str
    link: str
    radius: Formula
    span: Span

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"rack {self.point} on {self.pivot}"

    @property
    def kind(self) -> Literal["rack"]:
        """Return the word of the language for it."""
        return "rack"

    @property
    def described(self) -> str:
        """Return how messages name it."""
        return f"the rack at {self.point}"

    @property
    def presses_aside(self) -> bool:
        """Return that it presses along its guide."""
        return False

    @property
    def way(self) -> Formula:
        """Return the radius of the gear: how far it rolls in a radian."""
        return self.radius

    @property
    def base(self) -> str:
        """Return the pivot of the gear: the rack moves along as it does, too."""
        return self.pivot

    @property
    def sizes(self) -> tuple[SizeLetter]:
        """Return the radius of the gear."""
        return (SizeLetter("r", self.pivot, self.radius),)

    def with_sizes(self, formulas: Sequence[Formula]) -> "Rack":
        """Return the rack with another radius of its gear."""
        (radius,) = formulas
        return replace(self, radius=radius)


@frozen
class Screw(Feed):
    """Turning ``link`` moves slider ``point`` along its guide by ``pitch`` per turn.

    V = ω · pitch/2π, right-handed for a positive pitch.
    """

    point: str
    pitch: Formula
    link: str
    span: Span

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return f"screw {self.point} on {self.link}"

    @property
    def kind(self) -> Literal["screw"]:
        """Return the word of the language for it."""
        return "screw"

    @property
    def described(self) -> str:
        """Return how messages name it."""
        return f"the screw that moves {self.point}"

    @property
    def way(self) -> Formula:
        """Return the pitch."""
        return self.pitch

    @property
    def is_per_turn(self) -> bool:
        """Return that the pitch is the way of a turn."""
        return True

    @property
    def sizes(self) -> tuple[SizeLetter]:
        """Return the pitch."""
        return (SizeLetter("p", self.point, self.pitch),)

    def with_sizes(self, formulas: Sequence[Formula]) -> "Screw":
        """Return the screw with another pitch."""
        (pitch,) = formulas
        return replace(self, pitch=pitch)


@frozen
class Rope(HoldsNothing, Unsized):
    """A rope from its first point over pulleys on the axles between to its last one.

    ``ways`` are the directions of its falls. Its length stays the same, whatever the radii of
    the pulleys: Σ (V of a fall's end − V of its beginning) · way = 0.
    """

    route: tuple[str, ...]
    ways: tuple[Direction, ...]
    span: Span

    @property
    def id(self) -> str:
        """Return the joint's name among all joints."""
        return rope_id(self.route)

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds."""
        return tuple(dict.fromkeys(self.route))

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names: none, as it acts on pins."""
        return ()


def rope_id(route: Iterable[str]) -> str:
    """Return the name of a rope among all joints."""
    return f"rope {'-'.join(route)}"


Mesh = WheelPair | Rack | Screw
MeshKind = Literal["gear", "belt", "rack", "screw"]
"""The words of the language for what passes a motion on."""

Joint = Pivot | Slider | Slot | Contact | WheelPair | Rack | Screw | Rope
"""A pass over joints matches all of them and ends in ``assert_never``: mypy names what is left.

Kinds that are alike to it are one case, by what they have in common (``Meshing``, ``Feed``).
"""
