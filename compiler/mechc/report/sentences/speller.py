"""What a printer must know to write mathematics inside a sentence."""

from typing import Protocol

from ...formula.tree import Formula


class Speller(Protocol):
    """Writes mathematics inside a sentence."""

    @property
    def angles(self) -> frozenset[str]:
        """Return the names that are angles."""
        ...

    def relation(self, sides: tuple[Formula, ...], signs: tuple[str, ...], angle: bool) -> str:
        """Return sides joined by signs (``<``, ``<=``, ``=``, ``!=``, ``~`` …); one side, none.

        ``angle`` says that the sides are angles, so that constants are in degrees.
        """
        ...

    def number(self, value: float) -> str:
        """Return a number that was computed."""
        ...

    def point(self, names: str) -> str:
        """Return a point, a link or a vector."""
        ...
