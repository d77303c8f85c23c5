"""The user's text and places in it.

Every node of every later stage carries a :class:`Span`, so that the last stage
can still point at line 9 of the user's file.
"""

from bisect import bisect_right
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from .base.frozen import frozen, replace
from .base.named import NamedTuple


class Span(NamedTuple):
    """A half-open range of characters ``[start, end)`` of one source text.

    >>> Span(3, 5).to(Span(9, 12))
    Span(start=3, end=12)
    """

    start: int
    end: int

    def moved(self, by: int) -> "Span":
        """Return the span so many characters farther on."""
        return Span(self.start + by, self.end + by)

    def to(self, other: "Span") -> "Span":
        """Return the span from the start of this one to the end of the other."""
        return Span(self.start, other.end)


class Position(NamedTuple):
    """A place as people count it: line and column from 1."""

    line: int
    column: int


@frozen
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
    attached: "tuple[Source, ...]" = ()
    """What the command line sets, and what it uses: each text counts on behind the one before."""
    folder: Path | None = None
    """Where the files are that it may use by their paths; None where it is no file."""

    def parts(self) -> "Iterator[tuple[int, Source]]":
        """Yield this text and those attached, each with the offset of its first character."""
        start = 0
        for part in (self, *self.attached):
            yield start, part
            start += len(part.text) + 1

    def used(self) -> "list[Path]":
        """Return the files that are attached: what the description uses."""
        return [Path(text.name) for text in self.attached if text.folder is not None]

    def with_attached(self, other: "Source") -> "tuple[Source, int]":
        """Return this source with another, and what is attached to that, and where that begins."""
        start, last = max(self.parts(), key=lambda part: part[0])
        texts = (*self.attached, replace(other, attached=()), *other.attached)
        return replace(self, attached=texts), start + len(last.text) + 1

    def part(self, span: Span) -> "tuple[Source, Span]":
        """Return the text that a span lies in, and its place there."""
        start, part = max(p for p in self.parts() if p[0] <= span.start)
        return part, span.moved(-start)

    def is_setting(self, span: Span) -> bool:
        """Return whether a place is in what the command line sets, and in no file."""
        return span.start > len(self.text) and self.part(span)[0].folder is None

    def written(self, span: Span) -> str:
        """Return the text at a span."""
        part, (start, end) = self.part(span)
        return part.text[start:end]

    def position(self, offset: int) -> Position:
        """Return line and column of a character offset (both from 1)."""
        starts = _starts(self.text)
        line = bisect_right(starts, offset)
        return Position(line, offset - starts[line - 1] + 1)

    def line(self, number: int) -> str:
        """Return one line of the text, without its end, by its number from 1."""
        starts = _starts(self.text)
        start = starts[number - 1]
        stop = starts[number] - 1 if number < len(starts) else len(self.text)
        return self.text[start:stop].rstrip("\r")


@lru_cache(maxsize=4)
def _starts(text: str) -> list[int]:
    """Return where the lines begin; messages ask for it again and again."""
    return [0, *(i + 1 for i, c in enumerate(text) if c == "\n")]
