"""Equilibrium solved for all forces at once, without friction or with it."""

import math

from .balanced import Tie, gather, ties, untied, with_loads
from .diagrams.cut_free import StaticsSolution
from .diagrams.load_cases import LoadCase
from .equations import equilibrium
from .friction_loads import friction_forces
from .sparse_elimination import EliminatedSystem, factor
from .tolerances import INCONSISTENT
from .transfers import PinOnLink, bearings
from .unfold import Unfolding
from .verdict import OPEN, SEVERAL, UNBALANCED


def ideal(unfolding: Unfolding, case: LoadCase) -> StaticsSolution | str:
    """Return all forces without friction, or why there are none."""
    assembly, tied = unfolding.assembly(), _ties(unfolding)
    system = equilibrium(assembly)
    columns = gather(system, tied)
    sizes, right = untied(case.sizes, tied), dict[int, float]()
    for base, size in sizes.items():
        for i, amount in columns[base].items():
            right[i] = right.get(i, 0.0) - amount * size
    unknown = {base: columns[base] for base in _unknown(case, tied)}
    rows, units = with_loads(system, unknown)
    places = {base: len(system.unknowns) + i for i, base in enumerate(unknown)}
    factors = factor(rows, len(system.unknowns) + len(unknown))
    found = factors.solve(right)
    if not all(map(math.isfinite, found)) or factors.gap(found, right) > INCONSISTENT:
        return UNBALANCED
    open_ = _open(factors)
    if not open_.isdisjoint(places.values()):
        return OPEN
    sizes |= {base: found[column] * units[base] for base, column in places.items()}
    loads = _of_all(sizes, tied)
    return StaticsSolution(assembly, system, found, open_, loads, {}, *_besides(unfolding))


def with_friction(
    unfolding: Unfolding, case: LoadCase, nearby: Unfolding | None = None
) -> StaticsSolution | str:
    """Return all forces with friction, or why there are none.

    What does not slip has the friction of a ``nearby`` pose, if there is one.
    """
    tied = _ties(unfolding)
    unknown = _unknown(case, tied)
    if len(unknown) != 1:
        return SEVERAL
    (drive,) = unknown
    sense = unfolding.pose.mechanism.friction.sense
    slipping = friction_forces(unfolding, sense, drive, case.sizes, nearby)
    if isinstance(slipping, str):
        return slipping
    question, found = slipping.question, [0.0] * (len(slipping.question.system.unknowns) + 1)
    for (_, more), size in slipping.parts:
        found = [f + size * x for f, x in zip(found, more, strict=True)]
    loads = _of_all(
        {**untied(case.sizes, tied), drive: found[question.drive] * question.unit}, tied
    )
    frictions = zip(slipping.pairs, slipping.senses, slipping.frictions, strict=True)
    return StaticsSolution(
        unfolding.assembly(*((pair.name, pair.actions) for pair in slipping.pairs)),
        question.system,
        found,
        _open(question.factors),
        {**loads, **{pair.name: sense * size for pair, sense, size in frictions}},
        {pair.name: pair for pair in slipping.pairs},
        *_besides(unfolding),
    )


def _ties(unfolding: Unfolding) -> dict[str, Tie]:
    return ties(unfolding.pose.mechanism, unfolding.values)


def _unknown(case: LoadCase, tied: dict[str, Tie]) -> list[str]:
    """Return the untied loads that follow from the given ones."""
    known = {tied[name].base for name in case.sizes} | case.known
    return [name for name, tie in tied.items() if tie.base == name and name not in known]


def _of_all(sizes: dict[str, float], tied: dict[str, Tie]) -> dict[str, float]:
    """Return the size of every load from those of the untied ones that act."""
    acting = {name: tie for name, tie in tied.items() if tie.base in sizes}
    return {name: sizes[tie.base] * tie.factor for name, tie in acting.items()}


def _open(factors: EliminatedSystem) -> frozenset[int]:
    """Return the columns of what equilibrium doesn't determine."""
    if len(factors.pivots) == factors.width:
        return frozenset()
    return frozenset(i for i in range(factors.width) if not factors.determined(i))


def _besides(unfolding: Unfolding) -> tuple[frozenset[PinOnLink], frozenset[str]]:
    """Return the other bearings, of wheels, racks and screws, and the points that copies share."""
    copies = unfolding.pose.mechanism.copies
    return bearings(unfolding.pose.mechanism), frozenset(copies.sharing if copies else ())
