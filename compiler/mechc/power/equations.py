"""The power equations as a matrix: a row for each motion, a column for each free load."""

from collections.abc import Mapping, Sequence

from ..algebra.determinant import determinant
from ..algebra.modular import Point
from ..algebra.product import Product
from ..algebra.rank import independent, residues
from ..algebra.sums import add, canonical
from .balance import Term


class Equations:
    """``Σ column[load][i] · load = 0`` for each independent motion i that moves a load.

    Tied loads are taken into the column of the load they are tied to; columns that
    vanish are left out and stand in ``idle_loads``. ``idle_motions`` are those that
    move no load, whatever the others do.
    """

    def __init__(self, terms: Sequence[Term]) -> None:
        self._owners = _factors(terms)
        columns = _columns(terms, self._owners)
        self.idle_loads = [name for name, column in columns.items() if not any(column)]
        active = {n: c for n, c in columns.items() if any(c)}
        motions = len(terms[0].speed) if terms else 0
        point = Point()
        rows = [{n: c[m] for n, c in enumerate(active.values()) if c[m]} for m in range(motions)]
        kept = independent(residues(row, point) for row in rows)
        self.idle_motions = [i for i, keep in enumerate(kept) if not keep]
        self._powers = active
        self.columns = {
            n: [p for p, keep in zip(c, kept, strict=True) if keep] for n, c in active.items()
        }

    def owner(self, load: str) -> tuple[str, Product]:
        """Return the free load that a load is tied to in the end, and the factor."""
        return self._owners[load]

    @property
    def number(self) -> int:
        """Return the number of independent equations."""
        return len(next(iter(self.columns.values()), ()))

    def per_power(self, load: str, power: Sequence[Product]) -> Product | None:
        """Return a power of each motion per unit of a load's, in the one that moves loads.

        None where an idle motion changes it.
        """
        whole = self._powers[load]
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


def _factors(terms: Sequence[Term]) -> Mapping[str, tuple[str, Product]]:
    """Return for each load the free load it is tied to in the end, and the factor."""
    ties = {t.load.name: t.tie for t in terms}
    factors: dict[str, tuple[str, Product]] = {}
    for name in ties:
        owner, factor = name, Product(1)
        while (tie := ties[owner]) is not None:
            owner, factor = tie[0], factor * tie[1]
        factors[name] = owner, factor
    return factors
