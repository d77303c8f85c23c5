"""The power equations as a matrix: a row for each motion, a column for each free load."""

from collections.abc import Mapping, Sequence

from ..algebra.modular import Point
from ..algebra.product import Product
from ..algebra.rank import independent, residues
from ..algebra.sums import add
from .balance import Equations, Term


def equations_of(terms: Sequence[Term]) -> Equations:
    """Return the independent power equations of the loads in a plan."""
    owners = _owners(terms)
    columns = _columns(terms, owners)
    powers = {name: column for name, column in columns.items() if any(column)}
    motions = len(terms[0].speed) if terms else 0
    point = Point()
    rows = [{n: c[m] for n, c in enumerate(powers.values()) if c[m]} for m in range(motions)]
    kept = independent(residues(row, point) for row in rows)
    return Equations(
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
