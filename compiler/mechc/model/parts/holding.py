"""What kinds of joints have in common: what they hold, what they pass on, what sizes they have."""

from collections.abc import Sequence
from typing import Self

from ...formula.tree import Formula
from ...named import NamedTuple


class OnePoint:
    """A joint that holds one point."""

    __slots__ = ()
    point: str

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it holds."""
        return (self.point,)


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


class Size(NamedTuple):
    """A radius, or a pitch, by the letter of its name and the point that it is of: ``r_O``."""

    letter: str
    of: str
    formula: Formula


class Unsized:
    """A joint without a radius and a pitch."""

    __slots__ = ()

    @property
    def sizes(self) -> tuple[Size, ...]:
        """Return its radii and its pitch: none."""
        return ()

    def with_sizes(self, formulas: Sequence[Formula]) -> Self:
        """Return the joint with other sizes, in the order of ``sizes``: itself."""
        return self


# --------------------------------------------------------------------------- motion


class Meshing:
    """A joint that passes a motion on and holds nothing: rims, teeth, a thread.

    It passes a force on to the ``bodies`` that it names. A pass to which all of these are
    alike has one case for them.
    """

    __slots__ = ()


class Feed(OnLink, Meshing):
    """Turning ``link`` moves the guided ``point`` along its guide.

    V = ω · lead, ``meshes.lead``, seen from the point ``base``; '' is the ground.
    """

    __slots__ = ()
    point: str

    @property
    def base(self) -> str:
        """Return the point from which the motion is seen, '' for the ground."""
        return ""
