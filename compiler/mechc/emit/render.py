"""Templates: the shape of a file, in the folder of its target, filled from a frozen context."""

from collections.abc import Iterable, Iterator
from importlib import import_module
from typing import Protocol, TypeVar

from ..base.frozen import frozen
from ..base.named import NamedTuple


class Context(Protocol):
    """A NamedTuple: its fields are what the template may mention."""

    def _asdict(self) -> dict[str, object]: ...


class Nothing(NamedTuple):
    """The context of a template that mentions nothing."""


def render(template: str, context: Context) -> str:
    """Return a file's text from a template (``c/header.jinja``) and its context.

    What the template mentions and the context lacks is an error.
    """
    folder = template.partition("/")[0]
    made = import_module(f".{folder}.made_templates", __package__)
    text: str = made.TEMPLATES[template](context._asdict())
    return text


class Assignment(NamedTuple):
    """One statement of a function: ``name = code``."""

    name: str
    code: str


T = TypeVar("T")


@frozen
class LoopTurn:
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


def turns(values: Iterable[T]) -> Iterator[tuple[LoopTurn, T]]:
    """Yield each value after its turn.

    >>> [(turn.index, turn.revindex, turn.last, value) for turn, value in turns("ab")]
    [(1, 2, False, 'a'), (2, 1, True, 'b')]
    """
    every = list(values)
    for done, value in enumerate(every):
        left = len(every) - done
        yield LoopTurn(done + 1, left, left == 1, len(every)), value
