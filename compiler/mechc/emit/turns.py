"""How far a loop of a template is."""

from collections.abc import Iterable, Iterator
from typing import TypeVar

from ..frozen import frozen

T = TypeVar("T")


@frozen
class Turn:
    """One turn of a loop: its number, how many are left with it, whether it is the last; of all.

    The names are those of Jinja's loops.
    """

    index: int
    revindex: int
    last: bool
    length: int

    @property
    def index0(self) -> int:
        """How many turns were before it."""
        return self.index - 1


def turns(values: Iterable[T]) -> Iterator[tuple[Turn, T]]:
    """Yield each value after its turn.

    >>> [(turn.index, turn.revindex, turn.last, value) for turn, value in turns("ab")]
    [(1, 2, False, 'a'), (2, 1, True, 'b')]
    """
    every = list(values)
    for done, value in enumerate(every):
        left = len(every) - done
        yield Turn(done + 1, left, left == 1, len(every)), value
