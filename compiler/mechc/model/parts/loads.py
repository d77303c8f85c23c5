"""Loads: forces, torques, pairs of forces, and forces that are spread over a stretch.

A ``tie`` is a formula in parameters and one other load.
"""

from fractions import Fraction
from typing import assert_never

from ...formula.tree import Formula, number, product, total
from ...frozen import frozen
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


@frozen
class Force:
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
    def points(self) -> tuple[str, ...]:
        """The points that it acts on; a couple acts on a link."""
        return (self.point,)

    @property
    def dimension(self) -> Dimension:
        """The dimension of its size."""
        return FORCE


@frozen
class Torque:
    """A couple on a link, positive counter-clockwise."""

    name: str
    link: str
    span: Span
    tie: Formula | None = None
    times: Fraction = Fraction(1)

    @property
    def points(self) -> tuple[str, ...]:
        """The points that it acts on; a couple acts on a link."""
        return ()

    @property
    def dimension(self) -> Dimension:
        """The dimension of its size."""
        return TORQUE


@frozen
class ForcePair:
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
    def points(self) -> tuple[str, ...]:
        """The points that it acts on; a couple acts on a link."""
        return (self.first, self.second)

    @property
    def dimension(self) -> Dimension:
        """The dimension of its size."""
        return FORCE


Load = Force | Torque | ForcePair
"""A weight is a :class:`Force` with ``weight`` True and ``tie`` = m·g (a known load)."""


def acts_at(point: str, load: Load) -> bool:
    """Return whether a load acts at a point."""
    match load:
        case Force():
            return load.point == point
        case ForcePair():
            return point in (load.first, load.second)
        case Torque():
            return False
        case _:
            assert_never(load)
