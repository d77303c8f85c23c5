"""One load ratio out of the equations of equilibrium, with its condition number.

The loads that nothing gives are unknowns beside the reactions; one load is put on with
size 1 and the one asked for is read off.
"""

import math
from collections.abc import Mapping, Set
from typing import NamedTuple

from ..formula.walk import evaluate, symbols
from ..model.mechanism import Load, Mechanism
from .free_bodies import System, equilibrium
from .solve import factor, scale_of
from .unfold import Unfolding

INCONSISTENT = 1e-9
"""A residual above this, relative to the heaviest row, is an equation that does not hold."""

ROUNDED = 2.0**-52
"""What a force at a joint that is zero by two reasons is off, per largest force.

It is the rounding of a rounding. A load may be tiny and right: 200 gears pass on 1e-60.
"""

UNBALANCED = "no forces at the joints balance the loads"

STANDS = "a joint stands still at that pose, and rounding tells which way it slips"
"""The doubt where friction may as well have the other sign, or none."""

Row = Mapping[int, float]


class Answer(NamedTuple):
    """What statics says: a value, NaN where it says none, and then why.

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


class Tie(NamedTuple):
    """A load as a multiple of an untied one."""

    base: str
    factor: float


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


def load_ratio(unfolding: Unfolding, above: str, below: str) -> Answer:
    """Return ``above`` where ``below`` is 1 and the loads with a value of their own are 0."""
    mechanism = unfolding.pose.mechanism
    known = {load.name for load in mechanism.loads if load.tie is not None}
    return _respond(unfolding, above, below, known | {let.name for let in mechanism.lets})


def load_coefficient(unfolding: Unfolding, load: str, other: str, known: Set[str]) -> Answer:
    """Return ``load`` where ``other`` is 1 and the rest of the ``known`` loads are 0."""
    return _respond(unfolding, load, other, known)


def _respond(unfolding: Unfolding, wanted: str, given: str, known: Set[str]) -> Answer:
    tied = ties(unfolding.pose.mechanism, unfolding.values)
    target, source = tied[wanted], tied[given]
    if target.base == source.base:
        return Answer(target.factor / source.factor, 1.0)
    system = equilibrium(unfolding.assembly())
    columns = gather(system, tied)
    given_row = columns.pop(source.base)
    unknown = {b: row for b, row in columns.items() if b == target.base or b not in known}
    right = {i: -amount / source.factor for i, amount in given_row.items()}
    found = balance(system, unknown, right, target.base)
    factor_ = target.factor
    return found._replace(value=found.value * factor_, influence=found.influence * abs(factor_))


def gather(system: System, tied: Mapping[str, Tie]) -> dict[str, dict[int, float]]:
    """Return what one unit of each untied load puts on, with all that is tied to it."""
    columns: dict[str, dict[int, float]] = {tie.base: {} for tie in tied.values()}
    for name, (base, multiple) in tied.items():
        for row, amount in system.loads[name].items():
            columns[base][row] = columns[base].get(row, 0.0) + amount * multiple
    return columns


def pushes(
    unfolding: Unfolding, wanted: str, given: str, known: Set[str], kind: str
) -> dict[tuple[str, str], float]:
    """Return the forces on pins at joints of one kind where ``given`` is 1, by pin and body.

    ``wanted`` balances it, and the rest of the ``known`` loads are 0. Forces that
    equilibrium does not determine are left out.
    """
    tied = ties(unfolding.pose.mechanism, unfolding.values)
    source, target = tied[given], tied[wanted]
    system = equilibrium(unfolding.assembly())
    columns = gather(system, tied)
    given_row = columns.pop(source.base)
    unknown = {b: row for b, row in columns.items() if b == target.base or b not in known}
    right = {i: -amount / source.factor for i, amount in given_row.items()}
    rows, _ = with_loads(system, unknown)
    factors = factor(rows, len(system.unknowns) + len(unknown))
    found = factors.solve(right)
    if not all(map(math.isfinite, found)) or factors.gap(found, right) > INCONSISTENT:
        return {}
    return {
        (force.on, force.by): found[i]
        for i, force in enumerate(system.unknowns)
        if force.component == kind and factors.determined(i)
    }


def with_loads(
    system: System, loads: Mapping[str, Row]
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


def balance(system: System, loads: Mapping[str, Row], right: Row, wanted: str) -> Answer:
    """Solve for the reactions and the unknown ``loads``, and return the wanted load."""
    column = len(system.unknowns) + list(loads).index(wanted)
    unit = scale_of(loads[wanted])
    return combination(system, loads, right, {column: unit}, wanted)


def combination(
    system: System,
    loads: Mapping[str, Row],
    right: Row,
    weights: Mapping[int, float],
    wanted: str = "the force",
) -> Answer:
    """Solve for the reactions and the unknown ``loads``, and return a combination of them."""
    rows, _ = with_loads(system, loads)
    last = next(iter(weights)) if len(weights) == 1 else None
    factors = factor(rows, len(system.unknowns) + len(loads), last)
    found = factors.solve(right)
    if not all(map(math.isfinite, found)) or factors.gap(found, right) > INCONSISTENT:
        return Answer(math.nan, math.inf, UNBALANCED)
    if not all(map(factors.determined, weights)):
        return Answer(math.nan, math.inf, f"equilibrium leaves {wanted} open")
    value = sum(weight * found[column] for column, weight in weights.items())
    sizes = factors.weights(found, right)
    forces = sum(abs(w) for column, w in weights.items() if column < len(system.unknowns))
    influence = ROUNDED * max(sizes, default=0.0) * forces
    for column, weight in weights.items():
        terms = zip(factors.adjoint(column), sizes, strict=True)
        influence += abs(weight) * sum(abs(share) * size for share, size in terms)
    return Answer(value, influence)
