"""The columns of a stroke with what fills them; those of the paths that are asked for.

A path is a coordinate of a point, the direction of a link, or the rate of one.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from ...base.named import NamedTuple
from ...diagnostics import MechcError, near_miss
from ...diagnostics import stroke as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula
from ...formula.walk import symbols
from ...model.result import Definition
from ...model.values import Chain, Values
from ...pose.motion import Motion, MotionQuantity
from ...units import Dimension
from ..sweep import Sweep
from .stroke import StrokeColumn

ALL = "all"
"""Stands for every point and link."""


class FilledColumn(NamedTuple):
    """A column, its value along the drive, and the formula of that with its definitions.

    ``ideal`` is the column of what one with friction is without it, if there is one.
    """

    column: StrokeColumn
    at: Callable[[float], float]
    formula: Formula | None = None
    where: tuple[Definition, ...] = ()
    has_friction: bool = False
    ideal: str = ""


def named_apart(columns: Iterable[FilledColumn]) -> list[FilledColumn]:
    """Return columns under names that differ: the second of two says what it holds."""
    taken: set[str] = set()
    found: list[FilledColumn] = []
    for filled in columns:
        column, name = filled.column, filled.column.name
        if name in taken:
            name = f"{name} ({column.content})"
        while name in taken:
            name += "'"
        taken.add(name)
        found.append(filled._replace(column=column._replace(name=name)))
    return found


class ShownQuantities(NamedTuple):
    """The quantities of a motion that are shown, and the definitions of all."""

    quantities: tuple[MotionQuantity, ...]
    definitions: tuple[tuple[str, Formula], ...]


def asked(motion: Motion | None, paths: Sequence[str]) -> ShownQuantities:
    """Return the quantities of motion of the points and links of these names.

    Reports E597 for a name that is none of them.
    """
    quantities = motion.quantities if motion else ()
    known = list(dict.fromkeys(q.of for q in quantities))
    strange = [path for path in paths if path not in (ALL, *known)]
    if strange:
        found = [messages.no_path(p, known, near_miss(p, known)) for p in strange]
        raise MechcError(found)
    shown = tuple(q for q in quantities if ALL in paths or q.of in paths)
    return ShownQuantities(shown, motion.definitions if motion else ())


def path_columns(
    asked: ShownQuantities, along: Sweep, unit: Callable[[Dimension], str]
) -> Iterator[FilledColumn]:
    """Yield the columns of what is asked for."""
    moving = _Moving(asked.definitions, along)
    for quantity in asked.quantities:
        dimension = quantity.dimension
        column = StrokeColumn(quantity.shown, dimension, "path", unit(dimension))
        yield FilledColumn(
            column,
            partial(moving.at, quantity.formula),
            quantity.formula,
            moving.needed(quantity.formula),
        )


class _Moving:
    """Evaluates the formulas of a motion along the drive."""

    def __init__(self, definitions: Sequence[tuple[str, Formula]], along: Sweep) -> None:
        self._along = along
        self._chain = Chain(dict(definitions))
        self._definitions = [Definition(*d) for d in self._chain.definitions]
        self._last: tuple[float, Values] | None = None

    def needed(self, formula: Formula) -> tuple[Definition, ...]:
        """Return the definitions that a formula rests on, in order."""
        needed = self._chain.needed_by(symbols(formula))
        return tuple(d for d in self._definitions if d.name in needed)

    def at(self, formula: Formula, x: float) -> float:
        """Return the value of a formula at a value of the drive."""
        if self._last is None or self._last[0] != x:
            self._last = x, self._chain.complete(self._along.values(x))
        return evaluate(formula, self._last[1])
