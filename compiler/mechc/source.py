"""The user's text and places in it.

Every node of every later stage carries a :class:`Span`, so that the last stage
can still point at line 9 of the user's file.
"""

from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple


class Span(NamedTuple):
    """A half-open range of characters ``[start, end)`` of one source text.

    >>> Span(3, 5).to(Span(9, 12))
    Span(start=3, end=12)
    """

    start: int
    end: int

    def to(self, other: "Span") -> "Span":
        """Return the span from the start of this one to the end of the other."""
        return Span(self.start, other.end)


class Position(NamedTuple):
    """A place as people count it: line and column from 1."""

    line: int
    column: int


@dataclass(frozen=True)
class Source:
    r"""One text and the name that messages give it.

    >>> s = Source("clamp.mech", "pivot O\nlink AB\n")
    >>> s.position(13)
    Position(line=2, column=6)
    >>> s.line(2)
    'link AB'
    """

    name: str
    text: str

    @cached_property
    def _starts(self) -> list[int]:
        starts = [0]
        starts.extend(i + 1 for i, c in enumerate(self.text) if c == "\n")
        return starts

    def position(self, offset: int) -> Position:
        """Return line and column of a character offset (both from 1)."""
        line = bisect_right(self._starts, offset)
        return Position(line, offset - self._starts[line - 1] + 1)

    def line(self, number: int) -> str:
        """Return one line of the text, without its end, by its number from 1."""
        start = self._starts[number - 1]
        stop = self._starts[number] - 1 if number < len(self._starts) else len(self.text)
        return self.text[start:stop].rstrip("\r")
