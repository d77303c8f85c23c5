"""What kinds of joints have in common: what they hold, what they pass on, what sizes they have."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Self

from ...base.named import NamedTuple
from ...formula.tree import PI, Formula, number, product
from ...source import Span


class OnePoint:
    """A joint that holds one point."""

    __slots__ = ()
    point: str

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds."""
        return (self.point,)

    @property
    def held(self) -> tuple[str, ...]:
        """Return the points that it holds by itself, without a link."""
        return (self.point,)


class HoldsNothing:
    """A joint that passes something on and holds no point by itself."""

    __slots__ = ()

    @property
    def held(self) -> tuple[str, ...]:
        """Return the points that it holds by itself: none."""
        return ()


class OnGround:
    """A joint with the ground, which names no body."""

    __slots__ = ()

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return ()


class OnLink:
    """A joint that names one body."""

    __slots__ = ()
    link: str

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that it names."""
        return (self.link,)


# ---------------------------------------------------------------------------- sizes


class SizeLetter(NamedTuple):
    """A radius, or a pitch, by the letter of its name and the point that it is of: ``r_O``."""

    letter: str
    of: str
    formula: Formula


class Unsized:
    """A joint without a radius and a pitch."""

    __slots__ = ()

    @property
    def sizes(self) -> tuple[SizeLetter, ...]:
        """Return its radii and its pitch: none."""
        return ()

    def with_sizes(self, formulas: Sequence[Formula]) -> Self:
        """Return the joint with other sizes, in the order of ``sizes``: itself."""
        return self


class OnLine(OnePoint, OnLink, Unsized):
    """A joint of a point with the line from ``tail`` to ``head`` of a link."""

    __slots__ = ()
    tail: str
    head: str


# --------------------------------------------------------------------------- motion


class Tied(NamedTuple):
    """A motion with its factor: of a body, or of the guided ``point`` where it names no body."""

    body: str
    point: str
    factor: Formula


class Meshing(HoldsNothing):
    """A joint that passes a motion on and holds nothing: rims, teeth, a thread.

    It passes a force on to the ``bodies`` that it names. A pass to which all of these are
    alike has one case for them.
    """

    __slots__ = ()

    @property
    @abstractmethod
    def kind(self) -> str:
        """Return the word of the language for it, which is that of its rule in a report."""

    @property
    @abstractmethod
    def described(self) -> str:
        """Return how messages name it: ``the rack at K``."""

    @property
    @abstractmethod
    def tied(self) -> tuple[Tied, ...]:
        """Return the motions that it ties: times their factors they add up to zero."""

    @property
    def presses_aside(self) -> bool:
        """Return whether it presses on pins in directions that are undetermined.

        Teeth press across the line of centres, belts are tightened beforehand, and a screw's
        thrust is out of the plane.
        """
        return True


class Feed(OnLink, Meshing):
    """Turning ``link`` moves the guided ``point`` along its guide.

    V = ω · lead, seen from the point ``base``; '' is the ground. Its size is the lead, or the
    way of a whole turn, 2π times the lead.
    """

    __slots__ = ()
    point: str
    span: Span

    @property
    @abstractmethod
    def id(self) -> str:
        """Return the joint's name among all joints."""

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds: the one that it moves, and where that is seen from."""
        return (self.point, self.base) if self.base else (self.point,)

    @property
    def tied(self) -> tuple[Tied, Tied]:
        """Return the turn of the link times the lead, and the way of the point."""
        lead = product([(self.way, 1), (number(2), -1), (PI, -1)]) if self.is_per_turn else self.way
        return Tied(self.link, "", lead), Tied("", self.point, number(-1))

    @property
    @abstractmethod
    def way(self) -> Formula:
        """Return how far the point moves in a radian, or in a turn where it ``is_per_turn``."""

    @property
    def is_per_turn(self) -> bool:
        """Return whether its ``way`` is that of a turn."""
        return False

    @property
    def base(self) -> str:
        """Return the point from which the motion is seen, '' for the ground."""
        return ""
