"""One load ratio out of the equations of equilibrium, with its condition number.

The loads that nothing gives are unknowns as the reactions are; one load is put on with
size 1 and the one asked for is read off.
"""

import math
from collections.abc import Mapping, Set

from ..base.named import NamedTuple
from .balanced import Balanced, Tie
from .equations import EquilibriumSystem
from .sparse_elimination import EliminatedSystem, SparseRow
from .tolerances import EPSILON, INCONSISTENT
from .verdict import OPEN, UNBALANCED


class Answer(NamedTuple):
    """An answer of statics: a value, NaN where there is none, and then why.

    ``influence`` bounds the change of the value per relative change of the entries of
    the equations, each against the largest of its row. ``doubt`` is why another value may
    be as right.
    """

    value: float
    influence: float
    trouble: str = ""
    doubt: str = ""

    @property
    def condition(self) -> float:
        """Return the influence relative to the value: the condition number of the question."""
        return self.influence / abs(self.value) if self.value else math.inf


def load_ratio(at: Balanced, above: str, below: str) -> Answer:
    """Return ``above`` where ``below`` is 1 and the loads with a value of their own are 0.

    Where nothing balances so, the ratio may be that for whatever size those loads have: with
    two degrees of freedom and a spring between two levers the torques on them stand in one ratio.
    """
    mechanism = at.pose.mechanism
    known = {load.name for load in mechanism.loads if load.tie is not None}
    answer = _respond(at, above, below, known | {let.name for let in mechanism.lets})
    return _respond(at, above, below, set()) if answer.trouble == UNBALANCED else answer


def load_coefficient(at: Balanced, load: str, other: str, known: Set[str]) -> Answer:
    """Return ``load`` where ``other`` is 1 and the rest of the ``known`` loads are 0."""
    return _respond(at, load, other, known)


def _respond(at: Balanced, wanted: str, given: str, known: Set[str]) -> Answer:
    """Return how large a load is for a unit of another one, each by the load that it is tied to."""
    target, source = at.tied[wanted], at.tied[given]
    if target.base == source.base:
        return Answer(target.factor / source.factor, 1.0)
    unknown = unknown_bases(at, source, known - {target.base})
    column = len(at.system.unknowns) + unknown.index(target.base)
    factors, units = at.eliminated(unknown, column)
    weights = {column: units[target.base]}
    found = combination(at.system, factors, one_of(at, source), weights)
    factor = target.factor
    return found._replace(value=found.value * factor, influence=found.influence * abs(factor))


def unknown_bases(at: Balanced, source: Tie, known: Set[str]) -> list[str]:
    """Return the untied loads that follow from the known ones, of which ``source`` is one."""
    return [base for base in at.columns if base != source.base and base not in known]


def one_of(at: Balanced, source: Tie) -> SparseRow:
    """Return the right-hand side where a load is 1 and the other known ones are 0."""
    return {i: -amount / source.factor for i, amount in at.columns[source.base].items()}


def pushes(
    at: Balanced, wanted: str, given: str, known: Set[str], kind: str
) -> dict[tuple[str, str], float]:
    """Return the forces on pins at joints of one kind where ``given`` is 1, by pin and body.

    ``wanted`` balances it, and the rest of the ``known`` loads are 0. Forces that
    equilibrium does not determine are left out.
    """
    source, right = at.tied[given], one_of(at, at.tied[given])
    factors, _ = at.eliminated(unknown_bases(at, source, known - {at.tied[wanted].base}), None)
    found = factors.solve(right)
    if not all(map(math.isfinite, found)) or factors.gap(found, right) > INCONSISTENT:
        return {}
    return {
        (force.on, force.by): found[i]
        for i, force in enumerate(at.system.unknowns)
        if force.component == kind and factors.determined(i)
    }


def combination(
    system: EquilibriumSystem,
    factors: EliminatedSystem,
    right: SparseRow,
    weights: Mapping[int, float],
) -> Answer:
    """Solve for the reactions and the unknown loads, and return a combination of them.

    The weights of reactions are components of unit vectors, so rounded ones of directions:
    the cosine of 90° is 6e-17, and a force that has no part along x shows one of that size.
    """
    found = factors.solve(right)
    if not all(map(math.isfinite, found)) or factors.gap(found, right) > INCONSISTENT:
        return Answer(math.nan, math.inf, UNBALANCED)
    if not all(map(factors.determined, weights)):
        return Answer(math.nan, math.inf, OPEN)
    value = sum(weight * found[column] for column, weight in weights.items())
    sizes = factors.weights(found, right)
    forces = [column for column in weights if column < len(system.unknowns)]
    influence = EPSILON * max(sizes, default=0.0) * len(forces)
    influence += sum(abs(found[column]) for column in forces)
    for column, weight in weights.items():
        terms = zip(factors.adjoint(column), sizes, strict=True)
        influence += abs(weight) * sum(abs(share) * size for share, size in terms)
    return Answer(value, influence)
