"""Solving a block: single steps by division, larger ones by determinants."""

from collections.abc import Collection, Mapping, Sequence
from itertools import count

from ..algebra.matrices import determinant, with_column
from ..algebra.modular import PRIME, ModularPoint
from ..algebra.product import ZERO, Product, Sum
from ..algebra.sums import BoundSum, add, canonical
from .graph import LinearForm
from .plan import Binding, SpeedFactors

MOST_UNNAMED_TERMS = 12
"""A sum with more terms than this, inner ones included, is bound to a name."""


class Memory:
    """Speeds already solved, known again at a random point of a finite field.

    A new speed's value there follows from its relation in a few multiplications. If an
    earlier speed has the same, the two are equal, and the earlier form is taken, however
    long the sums that would have to cancel to show it.

    Named numbers have their values there: an angular velocity of ``spins`` and a speed that
    are equal by number, on an arm of one metre, are not the same. Speeds are by those of the
    ``drives``, in their order.
    """

    def __init__(self, drives: Sequence[int], spins: Collection[int]) -> None:
        self._point = ModularPoint()
        self._drives, self._spins = drives, spins
        self._residues: dict[int, tuple[int, ...]] = {}
        self._by_residue: dict[tuple[int, int], Product] = {}

    def note(self, unknown: int, speeds: SpeedFactors) -> None:
        """Remember a solved speed."""
        residues = tuple(s.residue(self._point) for s in speeds)
        self._residues[unknown] = residues
        for drive, residue, speed in zip(self._drives, residues, speeds, strict=True):
            power = self._power_of_length(unknown, drive)
            self._by_residue.setdefault((power, residue), speed)
            self._by_residue.setdefault((power, -residue % PRIME), -speed)

    def recall(self, form: LinearForm, unknown: int) -> SpeedFactors | None:
        """Return the earlier speeds that equal what a relation gives for an unknown, by each drive.

        The relation is solved at the random point, and earlier speeds are looked up by the value
        there. None where one of them has not been found before.
        """
        lead = form[unknown].residue(self._point)
        if not lead:
            return None
        sums = [0] * len(self._drives)
        for u, size in form.items():
            if u != unknown:
                part = size.residue(self._point)
                sums = [s - part * r for s, r in zip(sums, self._residues[u], strict=True)]
        inverse = pow(lead, -1, PRIME)
        values = zip(self._drives, (s * inverse % PRIME for s in sums), strict=True)
        known = [self._known(self._power_of_length(unknown, d), value) for d, value in values]
        return tuple(k for k in known if k is not None) if None not in known else None

    def _known(self, power: int, residue: int) -> Product | None:
        return self._by_residue.get((power, residue)) if residue else ZERO

    def _power_of_length(self, unknown: int, drive: int) -> int:
        """Return the power of a length that a speed is by that of a drive."""
        return (drive in self._spins) - (unknown in self._spins)


class Binder:
    """Binds long sums to names ``s1``, ``s2`` …"""

    def __init__(self, taken: frozenset[str]) -> None:
        self._taken = taken
        self.bindings: list[Binding] = []

    def bound(self, product: Product) -> Product:
        """Return the product with its long sums replaced by bound names."""
        for factor, exponent in product.factors.items():
            if isinstance(factor, Sum) and factor.weight > MOST_UNNAMED_TERMS:
                name = self._name(factor)
                product = product * Product(1, {factor: -exponent, name: exponent})
        return product

    def _name(self, factor: Sum) -> BoundSum:
        value = Product.of(factor)
        for known in self.bindings:
            if known.value == value:
                return BoundSum(known.name, value)
        used = self._taken | {known.name for known in self.bindings}
        name = next(name for i in count(1) if (name := f"s{i}") not in used)
        self.bindings.append(Binding(name, value))
        return BoundSum(name, value)


def solve(
    forms: Sequence[LinearForm],
    unknowns: Sequence[int],
    known: Mapping[int, SpeedFactors],
    drives: int,
) -> list[SpeedFactors]:
    """Return the unknowns of a block as linear forms in the drives.

    Cramer's rule: numerator and denominator are canonical sums, so that nothing but
    the determinant of the block is ever divided by.
    """
    matrix = [[form.get(u, ZERO) for u in unknowns] for form in forms]
    sides = [[_side(form, unknowns, known, i) for form in forms] for i in range(drives)]
    if len(unknowns) == 1:
        return [tuple(add([s[0] / matrix[0][0]]) for s in sides)]
    whole = determinant(matrix)
    return [
        tuple(determinant(with_column(matrix, column, s)) / whole for s in sides)
        for column in range(len(unknowns))
    ]


def by_one_other(
    form: LinearForm, unknown: int, known: Mapping[int, SpeedFactors]
) -> SpeedFactors | None:
    """Return the speed that a relation gives with one other that is known; None with more."""
    others = [u for u in form if u != unknown]
    if len(others) != 1:
        return None
    ratio = -form[others[0]] / form[unknown]
    return tuple(canonical(ratio * speed) for speed in known[others[0]])


def _side(
    form: LinearForm, unknowns: Sequence[int], known: Mapping[int, SpeedFactors], drive: int
) -> Product:
    """Return the right-hand side of a relation, made of the known speeds."""
    return add(-(p * known[u][drive]) for u, p in form.items() if u not in unknowns)
