"""The columns of a stroke with what fills them."""

from collections.abc import Callable, Iterable

from ...formula.tree import Formula
from ...model.result import Definition
from ...named import NamedTuple
from .stroke import Column


class Filled(NamedTuple):
    """A column, its value along the drive, and the formula of that with its definitions."""

    column: Column
    at: Callable[[float], float]
    formula: Formula | None = None
    where: tuple[Definition, ...] = ()
    has_friction: bool = False


def named_apart(columns: Iterable[Filled]) -> list[Filled]:
    """Return columns under names that differ: the second of two says what it holds."""
    taken: set[str] = set()
    found: list[Filled] = []
    for filled in columns:
        column, name = filled.column, filled.column.name
        if name in taken:
            name = f"{name} ({column.content})"
        while name in taken:
            name += "'"
        taken.add(name)
        found.append(filled._replace(column=column._replace(name=name)))
    return found
