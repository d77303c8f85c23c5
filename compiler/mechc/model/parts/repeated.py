"""What a description has several times: halves, branches, and parts that are mechanisms.

The twin of ``B`` in the other half of a mirrored mechanism is ``B'``; a description names twins
so as well. Only where names are read is a twin known by its name; everywhere else it is a field
that states so.
"""

from collections.abc import Iterable
from fractions import Fraction

from ...frozen import frozen
from ...source import Span
from .linkage import Direction


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
