"""What may stand on a command line: proposed while it is typed."""

from collections.abc import Iterable, Iterator

from ..files import library
from .usage import Proposal


def beginning(begun: str, words: Iterable[str]) -> Iterator[Proposal]:
    """Yield the words that begin so."""
    return (Proposal(word) for word in words if word.startswith(begun))


def descriptions(begun: str) -> list[Proposal]:
    """Return the mechanisms of the library, and the shell's own files."""
    return [*beginning(begun, library()), *paths(begun)]


def paths(begun: str) -> list[Proposal]:
    """Return the request for the shell's own completion of files."""
    return [Proposal(begun, kind="file")]
