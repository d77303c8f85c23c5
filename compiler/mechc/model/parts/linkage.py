"""The parts of a mechanism: directions, bodies, what drives, closes and repeats it.

The twin of ``B`` in the other half of a mirrored mechanism is ``B'``; a description names twins
so as well. Only where names are read is a twin known by its name; everywhere else it is a field
that states so.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import Literal

from ...base.frozen import frozen
from ...formula.tree import Formula
from ...source import Span

# ---------------------------------------------------------------------- directions


@frozen
class Absolute:
    """A direction given as an angle, counter-clockwise from +x."""

    angle: Formula
    span: Span


@frozen
class AlongLine:
    """The direction from ``tail`` to ``head``, turned by ``quarter`` · 90° (0 … 3)."""

    tail: str
    head: str
    quarter: int
    span: Span


Direction = Absolute | AlongLine


# -------------------------------------------------------------------------- bodies


@frozen
class ArcSlot:
    """A circular slot of ``link``, of a ``radius`` about its point ``centre``.

    The pin in it keeps its distance from the centre, and a smooth slot pushes it along that
    line only.
    """

    link: str
    centre: str
    radius: Formula
    span: Span


@frozen
class Link:
    """A rigid body through two or more points; ``name`` is the points as written (``OBA``).

    One with an ``arc`` is no body: it is the rod, from the centre to the pin, that does what
    a circular slot does.
    """

    name: str
    points: tuple[str, ...]
    span: Span
    label: str = ""
    arc: ArcSlot | None = None


@frozen
class Slide:
    """A body that only translates, along a direction: a wedge, a rack, a plunger.

    All its points have one velocity; it transmits a couple. ``name`` is the points as
    written (``WXY``).
    """

    name: str
    points: tuple[str, ...]
    along: Direction
    span: Span


@frozen
class Telescope:
    """A two-part link of variable length, pinned at both ends (``AB``).

    Its two parts turn together and slide along AB without resistance: no tension. They take
    a side force and a couple, as friction at the end pins makes them.
    """

    name: str
    points: tuple[str, str]
    span: Span


Body = Link | Slide | Telescope


# ------------------------------------------------------------------- drive, closure


@frozen
class Drive:
    """The driving coordinate, a parameter, and its stroke (None where no ends are given).

    It ``reshapes`` where it is a size of a rigid body: its stroke is a study, no motion. Of
    ``drive OA`` the ``ends`` are O and A: the parameter is the direction of that vector, or
    its length where it is a telescope, and begins where they are drawn, or at the ``start``
    that is set from outside. ``speed`` is its rate in time; the coordinate is an angle where
    it ``turns``.
    """

    parameter: str
    low: Formula | None
    high: Formula | None
    span: Span
    reshapes: bool = False
    ends: tuple[str, str] | None = None
    speed: Formula | None = None
    start: Formula | None = None
    turns: bool = False


@frozen
class Drawn:
    """Where a point is drawn, at the default pose.

    Gaps up to ``slack``, in metres, the digits written account for; ``unit`` is the user's.
    """

    point: str
    x: Formula
    y: Formula
    slack: float
    unit: str
    span: Span


@frozen
class Assembly:
    """Which closure is meant: the turn of three points, or a point's place along its guide."""

    points: tuple[str, ...]
    mode: Literal["cw", "ccw", "forward", "back"]
    span: Span


# -------------------------------------------------------- halves, branches, parts


@frozen
class Mirror:
    """The description is the half on one side of a line; shared points lie on it."""

    across: Direction
    sharing: tuple[str, ...]
    span: Span

    @property
    def number(self) -> Fraction:
        """Return how many halves there are."""
        return Fraction(2)

    def shares(self, points: Iterable[str]) -> bool:
        """Return whether both halves have what goes through these points in common."""
        return set(points) <= set(self.sharing)


@frozen
class Copies:
    """The description is one of ``number`` identical branches around the shared points' guide."""

    number: Fraction
    sharing: tuple[str, ...]
    span: Span

    def shares(self, points: Iterable[str]) -> bool:
        """Return whether the branches have what goes through these points in common."""
        return set(points) <= set(self.sharing)


@frozen
class Subassembly:
    """A mechanism that is a part of this one: its name, its prefix, and its points.

    ``points`` are pairs of a point's name there and here.
    """

    prefix: str
    name: str
    points: tuple[tuple[str, str], ...]


PRIME = "'"


def primed(name: str) -> str:
    """Return the name of a twin.

    >>> primed("B")
    "B'"
    """
    return name + PRIME


def without_prime(name: str) -> str:
    """Return the name of what is described, whether its twin is named or itself.

    >>> without_prime("B'"), without_prime("B")
    ('B', 'B')
    """
    return name.removesuffix(PRIME)
