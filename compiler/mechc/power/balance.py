"""The power equations, ``Σ load · speed = 0``, and what follows from them without friction.

As a matrix they have a row for each motion and a column for each free load.
"""

from collections.abc import Mapping, Sequence

from ..algebra.angle import Angle
from ..algebra.matrices import determinant, independent_of
from ..algebra.product import Product
from ..algebra.sums import add, canonical
from ..base.frozen import frozen
from ..kinematics.plan import Plan, SpeedFactors
from ..model.mechanism import Load
from ..model.result import Result


@frozen
class Term:
    """The part of one load: ``count · load · speed``, for each independent motion.

    ``count`` is how often the load acts (mirror, copies, times); ``speed`` its point's
    velocity along its line, or its link's spin. ``tie`` is (other load, factor) for a
    load tied to another.
    """

    load: Load
    count: Product
    speed: SpeedFactors
    line: Angle | None
    tie: tuple[str, Product] | None = None

    @property
    def power(self) -> SpeedFactors:
        """Return the power per unit of the load."""
        return tuple(self.count * s for s in self.speed)


@frozen
class PowerEquations:
    """``Σ columns[load][i] · load = 0`` for each independent motion i that moves a load.

    Tied loads are taken into the column of the load they are tied to, one of the ``owners``,
    by a factor; columns that vanish are left out and stand in ``idle_loads``. ``idle_motions``
    are those that move no load, whatever the others do; ``powers`` are the columns with a row
    for every motion.
    """

    owners: Mapping[str, tuple[str, Product]]
    columns: Mapping[str, list[Product]]
    powers: Mapping[str, list[Product]]
    idle_loads: tuple[str, ...]
    idle_motions: tuple[int, ...]

    def owner(self, load: str) -> tuple[str, Product]:
        """Return the free load that a load is tied to in the end, and the factor."""
        return self.owners[load]

    @property
    def number(self) -> int:
        """Return the number of independent equations."""
        return len(next(iter(self.columns.values()), ()))

    def per_power(self, load: str, power: Sequence[Product]) -> Product | None:
        """Return a power of each motion per unit of a load's, in the one that moves loads.

        None where an idle motion changes it.
        """
        whole = self.powers[load]
        (kept,) = (i for i in range(len(whole)) if i not in self.idle_motions)
        ratio = canonical(power[kept] / whole[kept])
        idle = (add((power[i], -(ratio * whole[i]))) for i in self.idle_motions)
        return None if any(map(canonical, idle)) else ratio

    def solve(self, load: str, unknown: Sequence[str], per: str) -> Product:
        """Return the unknown load that balances a unit of a known one, others being absent.

        Cramer's rule on the equations, one for each unknown load.
        """
        matrix = [self.columns[u] for u in unknown]
        replaced = [self.columns[per] if u == load else self.columns[u] for u in unknown]
        return canonical(-(determinant(replaced) / determinant(matrix)))

    def determines(self, unknown: Sequence[str]) -> bool:
        """Return whether the equations can be solved for these loads."""
        return all(u in self.columns for u in unknown) and bool(
            determinant([self.columns[u] for u in unknown])
        )


@frozen
class Release:
    """One component of the force at a joint: a joint that is released along a direction.

    ``kind``, ``point`` and ``of`` are the joint's; the loads that are ``held`` do no work. Of
    the ``terms`` the last one is that of the force itself, its speed that at which the joint
    parts; ``amounts`` is the force per unit of each load.
    """

    kind: str
    point: str
    of: str
    direction: Angle
    held: tuple[str, ...]
    plan: Plan
    terms: tuple[Term, ...]
    amounts: Mapping[str, Product]


@frozen
class AlgebraicResult:
    """A result as algebra, before it is turned into a formula.

    ``value`` is None for a let. ``above`` and ``below`` are the loads of a ratio,
    ``releases`` those by which a force at a joint was found.
    """

    result: Result
    value: Product | None = None
    above: str = ""
    below: str = ""
    releases: tuple[Release, ...] = ()


@frozen
class Balance:
    """The plan with its loads, and what was asked for without friction, solved.

    ``driving`` are the loads that follow from the others where forces at joints are asked for;
    ``reading`` is the plan with the speeds as they are read, and the names that results mention.
    """

    plan: Plan
    terms: tuple[Term, ...]
    equations: PowerEquations
    driving: tuple[str, ...]
    solved: tuple[AlgebraicResult, ...]
    reading: Plan

    @property
    def results(self) -> tuple[Result, ...]:
        """Return the results in the order in which they were asked for."""
        return tuple(s.result for s in self.solved)


def equations_of(terms: Sequence[Term]) -> PowerEquations:
    """Return the independent power equations of the loads in a plan."""
    owners = _owners(terms)
    columns = _columns(terms, owners)
    powers = {name: column for name, column in columns.items() if any(column)}
    motions = len(terms[0].speed) if terms else 0
    rows = [{n: c[m] for n, c in enumerate(powers.values()) if c[m]} for m in range(motions)]
    kept = independent_of(rows)
    return PowerEquations(
        owners,
        {n: [p for p, keep in zip(c, kept, strict=True) if keep] for n, c in powers.items()},
        powers,
        tuple(name for name in columns if name not in powers),
        tuple(i for i, keep in enumerate(kept) if not keep),
    )


def _columns(
    terms: Sequence[Term], factors: Mapping[str, tuple[str, Product]]
) -> Mapping[str, list[Product]]:
    """Return the power of every free load, with those tied to it."""
    parts: dict[str, list[list[Product]]] = {}
    for term in terms:
        owner, factor = factors[term.load.name]
        powers = parts.setdefault(owner, [[] for _ in term.speed])
        for i, power in enumerate(term.power):
            powers[i].append(power * factor)
    return {name: [add(p) for p in powers] for name, powers in parts.items()}


def _owners(terms: Sequence[Term]) -> Mapping[str, tuple[str, Product]]:
    """Return for each load the free load it is tied to in the end, and the factor."""
    ties = {t.load.name: t.tie for t in terms}
    factors: dict[str, tuple[str, Product]] = {}
    for name in ties:
        owner, factor = name, Product(1)
        while (tie := ties[owner]) is not None:
            owner, factor = tie[0], factor * tie[1]
        factors[name] = owner, factor
    return factors
