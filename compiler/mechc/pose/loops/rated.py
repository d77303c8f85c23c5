"""How fast names that the user made, and what closing the loops finds, move with the drive."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType

from ...algebra.angle import QUARTER, Angle, rational
from ...algebra.derivative import derivative
from ...algebra.factors import Length
from ...algebra.from_formula import to_product
from ...algebra.matrices import determinant, with_column
from ...algebra.product import Product
from ...algebra.sums import add
from ...algebra.trigonometry import cosine, sine
from ...formula.derivative import derivative as slope
from ...formula.tree import Formula, Symbol
from ...formula.walk import substitute, symbols
from ..pose import Arm, PoseDefinition, Vector, components, gathered
from ..vector_graph import mentioned
from .dyad_sides import is_of_vector


def given_rates(definitions: Iterable[PoseDefinition], drive: str) -> dict[str, Product]:
    """Return the rates of what the user made to move with the drive, itself included."""
    rates = {drive: Product(1)}
    for name, formula in definitions:
        if not symbols(formula).isdisjoint(rates):
            rates[name] = rate_of(formula, rates)
    return rates


def rate_of(formula: Formula, rates: Mapping[str, Product]) -> Product:
    """Return the rate of a formula by the chain rule."""
    parts = sorted(symbols(formula) & rates.keys())
    return add(to_product(slope(formula, n)) * rates[n] for n in parts)


def moved_by(drive: str, definitions: Iterable[PoseDefinition]) -> frozenset[str]:
    """Return the names that move with the drive, itself included."""
    moving = {drive}
    for name, formula in definitions:
        if not moving.isdisjoint(symbols(formula)):
            moving.add(name)
    return frozenset(moving)


class Rated:
    """The rates found so far, per unit of the drive.

    What has no rate does not move, but for the ``unknown``, of which the rate is not known.
    """

    def __init__(self, given: Mapping[str, Product]) -> None:
        self.rates = dict(given)
        self.unknown: set[str] = set()

    def define(self, name: str, angle: Angle) -> None:
        """Enter the rate of a name that a sum of angles has got."""
        if not self.unknown.isdisjoint(angle.names):
            self.unknown.add(name)
        elif moving := [self.rates[n].scaled(c) for n, c in angle.terms if n in self.rates]:
            self.rates[name] = add(moving)

    def enter(
        self,
        found: Sequence[PoseDefinition],
        loops: Sequence[Vector],
        twins: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        """Enter the rates of what closing loops found; note what moves at one that is not known.

        ``twins`` are in the loops for what has the same value, and a name, already.
        """
        met = frozenset().union(*map(mentioned, loops))
        fresh = {d.name for d in found} & met
        fresh |= twins.keys() & met if fresh else set()
        if len(fresh) > 2 * len(loops):
            fresh -= self._rate_turns(found, fresh)
        if self.unknown.isdisjoint(met):
            rates = loop_rates(loops, sorted(fresh), self.rates)
            self.rates |= {n: _by_name(r, twins) for n, r in rates.items() if n not in twins}
        self._rate_twins(found)
        self._rates_by_one_name(found)
        for name, formula in found:
            rests = symbols(formula)
            moves = any(self.rates.get(n) for n in rests) or not rests.isdisjoint(self.unknown)
            if moves and name not in self.rates:
                self.unknown.add(name)

    def _rate_turns(self, found: Sequence[PoseDefinition], fresh: set[str]) -> set[str]:
        """Enter the rates of directions that a known side has within its body; return the names.

        No loop gives them: a side whose length passes zero is turned round there.
        """
        own = {d.name for d in found}
        turns = {
            name: rate_of(formula, self.rates)
            for name, formula in found
            if name in fresh and is_of_vector(formula)
            if symbols(formula).isdisjoint(own | self.unknown)
        }
        self.rates |= turns
        return turns.keys() & fresh

    def _rate_twins(self, found: Sequence[PoseDefinition]) -> None:
        """Enter the rates of sides of which what a loop gives is but a multiple."""
        sides = {d.name for d in found} - self.rates.keys()
        for name, formula in found:
            value = to_product(formula)
            match list(value.factors.items()):
                case [(Length(twin), 1)] if name in self.rates and twin in sides:
                    self.rates[twin] = self.rates[name].scaled(1 / Fraction(value.coefficient))

    def _rates_by_one_name(self, found: Sequence[PoseDefinition]) -> None:
        """Write a side that is another one by the name of that one in all rates."""
        twins = {d.name: d.formula.name for d in found if isinstance(d.formula, Symbol)}
        for name, rate in self.rates.items() if twins else ():
            self.rates[name] = _by_name(rate, twins)


def _by_name(rate: Product, twins: Mapping[str, str]) -> Product:
    """Return a rate in which names stand for their twins."""
    formula = rate.formula() if twins else None
    if formula is None or twins.keys().isdisjoint(symbols(formula)):
        return rate
    return to_product(substitute(formula, {n: Symbol(name) for n, name in twins.items()}))


# -------------------------------------------------------------------------------------------- loops


KnownRates = Mapping[str, Product]
"""The derivative by the drive of every name that moves with it."""


def loop_rates(
    loops: Sequence[Vector], unknown: Sequence[str], known: KnownRates
) -> dict[str, Product]:
    """Return the rates of the unknowns of loops that close together.

    The vectors of a loop add up to zero all along the stroke, so their rates do: an unknown
    direction turns its part, an unknown length stretches it. The rates come out as the velocity
    ratios of mechanics, ``a·sin(φ − ψ)/(b·sin(ψ − θ))``.
    """
    if len(loops) == 1 and len(unknown) == 1:
        return _rate_of_one(loops[0], unknown[0], known)
    if len(loops) == 1 and len(unknown) == 2:
        return _pair(loops[0], unknown, known)
    rows = [part for loop in loops for part in zip(*_columns(loop, unknown, known), strict=True)]
    matrix, right = [row[:-1] for row in rows], [-row[-1] for row in rows]
    if len(matrix) != len(unknown) or not (whole := determinant(matrix)):
        return {}
    return {
        name: determinant(with_column(matrix, i, right)) / whole for i, name in enumerate(unknown)
    }


def _rate_of_one(loop: Vector, unknown: str, known: KnownRates) -> dict[str, Product]:
    """Solve K + x′·X = 0 for x′: K is the rate by what is known, X that by a unit of x′.

    The loop's other unknown has a rate already, so that the component along X is enough; there is
    nothing where x moves the loop by more than one vector.
    """
    by_known, by_unit = rate(loop, known), rate(loop, {unknown: Product(1)})
    if len(by_unit) != 1:
        return {}
    size, angle = by_unit[0]
    along = add(part.length * cosine(part.angle - angle) for part in by_known)
    return {unknown: add([-(along / size)])}


def _columns(
    loop: Vector, unknown: Sequence[str], known: KnownRates
) -> Iterable[tuple[Product, Product]]:
    """Return the components of a loop's rate for each unknown, then those of what is known."""
    for name in unknown:
        yield components(rate(loop, {name: Product(1)}))
    yield components(rate(loop, known))


def _pair(loop: Vector, unknown: Sequence[str], known: KnownRates) -> dict[str, Product]:
    """Solve K + x′·X + y′·Y = 0 by products with the vectors square to X and to Y."""
    x, y = unknown
    given = rate(loop, known)
    one, other = (rate(loop, {name: Product(1)}) for name in unknown)
    whole = _cross(one, other)
    if not whole:
        return {}
    return {x: add([-_cross(given, other) / whole]), y: add([_cross(given, one) / whole])}


def _cross(one: Vector, other: Vector) -> Product:
    return add(a.length * b.length * sine(b.angle - a.angle) for a in one for b in other)


def rate(vector: Vector, rates: KnownRates) -> Vector:
    """Return the derivative of a vector whose symbols move at given rates."""
    arms: list[Arm] = []
    for length, angle in vector:
        turning = add(rates[n].scaled(rational(c)) for n, c in angle.terms if n in rates)
        arms.append(Arm(length * turning, angle + QUARTER))
        names = mentioned((Arm(length, Angle()),)) & rates.keys()
        arms.append(Arm(add(derivative(length, n) * rates[n] for n in sorted(names)), angle))
    return gathered(arm for arm in arms if arm.length)
