"""Loads: forces, torques, pairs of forces, and forces that are spread over a stretch.

A ``tie`` is a formula in parameters and one other load.
"""

from abc import abstractmethod
from fractions import Fraction
from typing import Literal

from ...base.frozen import frozen
from ...base.named import NamedTuple
from ...formula.tree import Formula, number, product, total
from ...source import Span
from ...units import FORCE, TORQUE, Dimension
from .linkage import Direction


@frozen
class Spread:
    """A load per unit of length along a stretch of a link.

    Its resultant acts at ``part`` of the way from ``tail`` to ``head``, ``length`` apart.
    ``intensities`` are those at both ends, one where it is uniform, none where it is open.
    """

    link: str
    tail: str
    head: str
    length: Formula
    part: Formula
    intensities: tuple[Formula, ...] = ()

    @property
    def resultant(self) -> Formula | None:
        """Return q·l, or (q₁ + q₂)·l/2; None where the intensity is open."""
        if not self.intensities:
            return None
        mean = (number(len(self.intensities)), -1)
        return product([(total(self.intensities), 1), (self.length, 1), mean])

    @property
    def reach(self) -> Formula:
        """Return how far from ``tail`` the resultant acts."""
        return product([(self.part, 1), (self.length, 1)])


LoadEnds = tuple[tuple[str, str], ...]
"""Where a load acts: by its link and point, '' for the link where it acts on the pin itself."""


class Push(NamedTuple):
    """A force of a load on a point, on its ``link`` or the pin there ('').

    It is along the load's line where its ``sense`` is 1, against it where that is −1.
    """

    link: str
    point: str
    sense: Literal[1, -1] = 1


class SpeedAgainst(NamedTuple):
    """The speed against which a load works, and what it is ``of``.

    That of a ``load`` is the part of a point's velocity along it, that of a ``distance`` the
    rate at which two points part, a ``spin`` that of a link.
    """

    kind: Literal["load", "distance", "spin"]
    of: str

    @property
    def name(self) -> str:
        """Return its name: ``V_A``, ``V_AB``, ``omega_AB``."""
        return f"omega_{self.of}" if self.kind == "spin" else f"V_{self.of}"


class AtPoints:
    """A load that acts at points of links, or on the pins there."""

    __slots__ = ()

    @property
    @abstractmethod
    def pushes(self) -> tuple[Push, ...]:
        """Return the forces that it acts with in one half or branch."""

    @property
    @abstractmethod
    def ends(self) -> LoadEnds:
        """Return the link and the point of each of its forces."""

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it acts on."""
        return tuple(point for _, point in self.ends)

    @property
    def links(self) -> tuple[str, ...]:
        """Return the links that it acts on, '' for a pin."""
        return tuple(link for link, _ in self.ends)

    @property
    def dimension(self) -> Dimension:
        """Return the dimension of its size."""
        return FORCE


@frozen
class Force(AtPoints):
    """A force on a point; ``tie`` is a formula linear in one other load, or None.

    ``times`` multiplies the load wherever it acts. ``link`` is the link that carries it, ''
    where it acts on the pin itself and so on whatever the pin is fast in. It may be the
    resultant of what is ``spread`` over a stretch, and then acts at a point made for it.
    """

    name: str
    point: str
    along: Direction
    span: Span
    tie: Formula | None = None
    times: Fraction = Fraction(1)
    weight: bool = False
    link: str = ""
    spread: Spread | None = None

    @property
    def ends(self) -> LoadEnds:
        """Return the link and the point that it acts on."""
        return ((self.link, self.point),)

    @property
    def pushes(self) -> tuple[Push]:
        """Return the force itself."""
        return (Push(self.link, self.point),)

    @property
    def host(self) -> str:
        """Return the link with which it is repeated, '' where that is by its points."""
        return self.link

    @property
    def against(self) -> SpeedAgainst:
        """Return the speed against which it works."""
        return SpeedAgainst("load", self.point)


@frozen
class Torque:
    """A couple on a link, positive counter-clockwise."""

    name: str
    link: str
    span: Span
    tie: Formula | None = None
    times: Fraction = Fraction(1)

    @property
    def ends(self) -> LoadEnds:
        """Return the link and the point of each of its forces: it acts at no point."""
        return ()

    @property
    def pushes(self) -> tuple[Push, ...]:
        """Return the forces that it acts with: none."""
        return ()

    @property
    def host(self) -> str:
        """Return the link with which it is repeated."""
        return self.link

    @property
    def against(self) -> SpeedAgainst:
        """Return the speed against which it works."""
        return SpeedAgainst("spin", self.link)

    @property
    def points(self) -> tuple[str, ...]:
        """Return the points that it acts on: none."""
        return ()

    @property
    def links(self) -> tuple[str, ...]:
        """Return the link that it acts on."""
        return (self.link,)

    @property
    def dimension(self) -> Dimension:
        """Return the dimension of its size."""
        return TORQUE


@frozen
class ForcePair(AtPoints):
    """A pair of equal and opposite forces that pushes two points apart.

    ``tie`` is None for an actuator; for a spring it is c·(l0 − len_AB), a known load, and
    ``spring`` is True. Its power is the load times the rate of the distance. Each end acts on
    a link at its point, or on the pin there where the link is ''. One that ``joins_twins`` acts
    across the mirror, on a point and its twin. A pair inside a telescope
    whose end pins have friction acts on the telescope, along it at the piston.
    """

    name: str
    first: str
    second: str
    span: Span
    tie: Formula | None = None
    times: Fraction = Fraction(1)
    spring: bool = False
    first_link: str = ""
    second_link: str = ""
    joins_twins: bool = False

    @property
    def ends(self) -> LoadEnds:
        """Return the link and the point of each of its two forces."""
        return (self.first_link, self.first), (self.second_link, self.second)

    @property
    def pushes(self) -> tuple[Push, ...]:
        """Return both forces; across the mirror the twin's is the other one."""
        if self.joins_twins:
            return (Push(self.first_link, self.first),)
        return Push(self.second_link, self.second), Push(self.first_link, self.first, -1)

    @property
    def host(self) -> str:
        """Return that it is repeated by its points."""
        return ""

    @property
    def against(self) -> SpeedAgainst:
        """Return the speed against which it works."""
        return SpeedAgainst("distance", f"{self.first}{self.second}")


Load = Force | Torque | ForcePair
"""A weight is a :class:`Force` with ``weight`` True and ``tie`` = m·g (a known load)."""
