"""One pose with its equations of equilibrium, set up once however many questions are asked."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property
from typing import Any, TypeVar

from ..base.named import NamedTuple
from ..formula.evaluate import SharedEvaluation, evaluate
from ..formula.walk import symbols
from ..model.mechanism import Load, Mechanism
from ..model.result import Definition
from .equations import EquilibriumSystem, equilibrium
from .sparse_elimination import EliminatedSystem, SparseRow, factor, scale_of
from .unfold import Unfolding

T = TypeVar("T")


class Tie(NamedTuple):
    """A load as a multiple of an untied one."""

    base: str
    factor: float


class Eliminated(NamedTuple):
    """The eliminated equations with columns for some loads, and the units of these."""

    factors: EliminatedSystem
    units: Mapping[str, float]


class Balanced(Unfolding):
    """A pose unfolded; what does not depend on the question is found when first asked for."""

    @cached_property
    def system(self) -> EquilibriumSystem:
        """Return the equations of every free body under the mechanism's own loads."""
        return equilibrium(self.assembly())

    @cached_property
    def tied(self) -> Mapping[str, Tie]:
        """Return every load as a multiple of an untied one."""
        return ties(self.pose.mechanism, self.values)

    @cached_property
    def columns(self) -> Mapping[str, SparseRow]:
        """Return the column of one unit of each untied load, with all that is tied to it."""
        return gather(self.system, self.tied)

    def eliminated(self, unknown: Sequence[str], last: int | None) -> Eliminated:
        """Return the equations with the named loads unknown; ``last`` as for :func:`factor`."""
        key = (*unknown, last)
        if key not in self._eliminated:
            loads = {name: self.columns[name] for name in unknown}
            self._eliminated[key] = eliminated(self.system, loads, last)
        return self._eliminated[key]

    @cached_property
    def _eliminated(self) -> dict[tuple[str | int | None, ...], Eliminated]:
        return {}

    def once(self, asked: Hashable, find: Callable[[], T]) -> T:
        """Return an answer for this pose, found when it is first asked for."""
        if asked not in self._found:
            self._found[asked] = find()
        found: T = self._found[asked]
        return found

    @cached_property
    def _found(self) -> dict[Hashable, Any]:
        return {}

    def formulas(self, where: tuple[Definition, ...]) -> SharedEvaluation:
        """Return an evaluation at this pose of formulas that rest on these definitions, in order.

        It is made once for each tuple of definitions.
        """
        if id(where) not in self._formulas:
            values = dict(self.values)
            evaluation = SharedEvaluation(values)
            for name, formula in where:
                values[name] = evaluation.of(formula)
            self._formulas[id(where)] = where, evaluation  # kept, so that no other tuple has its id
        return self._formulas[id(where)][1]

    @cached_property
    def _formulas(self) -> dict[int, tuple[tuple[Definition, ...], SharedEvaluation]]:
        """Return the evaluations by the identity of definitions, which are kept alive for that."""
        return {}


def ties(mechanism: Mechanism, values: Mapping[str, float]) -> dict[str, Tie]:
    """Return every load as a multiple of an untied one, which is a multiple of itself."""
    loads = {load.name: load for load in mechanism.loads}
    return {name: _tie(load, loads, values) for name, load in loads.items()}


def _tie(load: Load, loads: Mapping[str, Load], values: Mapping[str, float]) -> Tie:
    """Follow a tie, which is linear, to its end; a known load such as a weight is its own."""
    others = [] if load.tie is None else [n for n in symbols(load.tie) if n in loads]
    if load.tie is None or not others:
        return Tie(load.name, 1.0)
    (other,) = others
    further = _tie(loads[other], loads, values)
    at = {size: evaluate(load.tie, {**values, other: size}) for size in (0.0, 1.0)}
    return Tie(further.base, (at[1.0] - at[0.0]) * further.factor)


def untied(sizes: Mapping[str, float], tied: Mapping[str, Tie]) -> dict[str, float]:
    """Return the sizes of the untied loads from which loads of these sizes follow."""
    return {tied[name].base: size / tied[name].factor for name, size in sizes.items()}


def gather(system: EquilibriumSystem, tied: Mapping[str, Tie]) -> dict[str, dict[int, float]]:
    """Return the column of one unit of each untied load, with all that is tied to it."""
    columns: dict[str, dict[int, float]] = {tie.base: {} for tie in tied.values()}
    for name, (base, multiple) in tied.items():
        for row, amount in system.loads[name].items():
            columns[base][row] = columns[base].get(row, 0.0) + amount * multiple
    return columns


def with_loads(
    system: EquilibriumSystem, loads: Mapping[str, SparseRow]
) -> tuple[list[dict[int, float]], dict[str, float]]:
    """Return the rows with columns for unknown loads behind those of the reactions.

    Loads may be tied by tiny multiples, so each is counted in a unit that puts on about 1;
    the units are returned too.
    """
    rows = [dict(row) for row in system.rows]
    units = {name: scale_of(load) for name, load in loads.items()}
    for column, (name, load) in enumerate(loads.items(), len(system.unknowns)):
        for i, amount in load.items():
            rows[i][column] = amount * units[name]
    return rows, units


def eliminated(
    system: EquilibriumSystem, loads: Mapping[str, SparseRow], last: int | None = None
) -> Eliminated:
    """Eliminate the equations with columns for unknown ``loads``; ``last`` as for ``factor``."""
    rows, units = with_loads(system, loads)
    return Eliminated(factor(rows, len(system.unknowns) + len(loads), last), units)
