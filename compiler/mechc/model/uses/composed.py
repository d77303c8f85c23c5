"""A description with what it uses put in."""

from ...base.later import pattern
from ...base.named import NamedTuple
from ...source import Source, Span
from ...syntax import ast
from ..mechanism import Mechanism, Parameter, Subassembly
from ..parts.loads import Load
from ..result import UsedSolution
from ..statements import every
from . import mechanism_statements

DOTTED = pattern(r"\w\.[A-Z]")
"""What a point of a part is written with: T.C."""


class Used(NamedTuple):
    """What is used: its tree, what that means, and its text with what it uses itself.

    The text begins at ``start`` in that of the sheet that uses it. ``solved`` is what was found
    of a mechanism, or of those that a sheet uses itself; ``mechanisms`` are the texts of these,
    by their prefixes.
    """

    file: ast.File
    mechanism: Mechanism
    source: Source
    solved: UsedSolution
    start: int = 0
    mechanisms: tuple[tuple[str, Source], ...] = ()

    @property
    def span(self) -> Span:
        """Where its heading stands."""
        return self.mechanism.span.moved(self.start)

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Its parameters that a line declares, by their names there.

        What a loop gives is none that anything could be given to.
        """
        declared = {param.name.text for param in every(self.file, ast.Param)}
        declared -= {d.name for d in self.solved.definitions if d.name in declared}
        return {p.name: p for p in self.mechanism.parameters if p.name in declared}

    @property
    def loads(self) -> dict[str, Load]:
        """Its loads that may be given a value, by their names there."""
        return mechanism_statements.open_loads(self.mechanism, self.solved)


class Composed(NamedTuple):
    """A file with what it uses put in, and what was found of the mechanisms among that.

    ``mechanisms`` are the texts of these by their prefixes, ``parts`` those that are joined;
    ``prefixes`` are those of all that is not joined, also of what that uses itself.
    """

    file: ast.File
    solved: UsedSolution = UsedSolution()
    parts: tuple[Subassembly, ...] = ()
    mechanisms: tuple[tuple[str, Source], ...] = ()
    prefixes: tuple[str, ...] = ()


def uses_others(file: ast.File, text: str) -> bool:
    """Return whether a file names other descriptions, or points as parts have them."""
    return bool(every(file, ast.Use)) or DOTTED.search(text) is not None
