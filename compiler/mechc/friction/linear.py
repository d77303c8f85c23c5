"""Friction in closed form where no pin has friction: guides, faces, threads and teeth.

Each is pressed along one line, so that with the signs of the pressing forces known
n = s·(ideal + Σ D·n) is a linear system, and the driving load a quotient of sums.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from ..algebra.from_formula import to_product
from ..algebra.matrices import determinant, with_column
from ..algebra.product import ONE, ZERO, Product
from ..algebra.sums import add, canonical
from ..formula.tree import Formula, Symbol, product, total
from .chain_bodies import EquationsCoupled
from .closed_form import power
from .friction_pairs import LoadedPair
from .signs.conditions import SignCondition
from .signs.names import SignSymbols
from .solution import FrictionStep, StepKind

MOST_READ_PAIRS = 3
"""More pairs than this make a formula that nobody reads."""


class LinearSolver:
    """Solves the linear system."""

    def __init__(
        self,
        driving: str,
        ideal: Product,
        loaded: Sequence[LoadedPair],
        signs: SignSymbols,
        sense: int,
    ) -> None:
        if len(loaded) > MOST_READ_PAIRS or any(len(p.components) != 1 for p in loaded):
            raise EquationsCoupled
        self._driving, self._ideal = driving, ideal
        self.loaded, self._signs, self._sense = loaded, signs, sense
        self._sizes: Mapping[str, Product] = {}
        self._balances: Sequence[tuple[Formula, Formula]] = ()
        self.conditions: list[SignCondition] = []
        self.steps: tuple[FrictionStep, ...] = ()

    def solve(self) -> Sequence[Product]:
        """Return the driving load without friction, and what each friction adds to it."""
        sides = [self._side(p) for p in self.loaded]
        sizes = self._solved(sides)
        self._sizes = {p.pair.name: size for p, size in zip(self.loaded, sizes, strict=True)}
        self.conditions += [SignCondition(ONE, size) for size in sizes]
        if self._signs.is_read:
            self.steps = (self._step(sides, sizes),)
            self._keep(sizes)
        parts = [
            p.pair.factor * self._slip(p) * p.slip * size
            for p, size in zip(self.loaded, sizes, strict=True)
        ]
        return (self._ideal, *(part.scaled(self._sense) for part in parts))

    def pressing(self) -> FrictionStep:
        """Return the step of the forces that press, once they are solved."""
        return FrictionStep("pressing", equations=tuple(self._balances))

    def friction(self, loaded: LoadedPair) -> Product:
        """Return a friction as a load on its slip."""
        return self._on_slip(loaded, self._sizes[loaded.pair.name])

    def friction_by_name(self, loaded: LoadedPair) -> Product:
        """Return a friction as a load on its slip, in the name of what presses."""
        return self._on_slip(loaded, to_product(_size(loaded)) * _mean(loaded))

    def _on_slip(self, loaded: LoadedPair, size: Product) -> Product:
        """Return the friction of what presses with a size."""
        return (loaded.pair.factor * self._slip(loaded) * size).scaled(-self._sense)

    def _keep(self, sizes: Sequence[Product]) -> None:
        """Note that each size stays positive; one that is not balances nothing."""
        for loaded, size in zip(self.loaded, sizes, strict=True):
            if self._signs.note_sign(f"s_{loaded.pair.name}", size).coefficient < 0:
                raise EquationsCoupled

    def _side(self, loaded: LoadedPair) -> Product:
        """Return the sign of a pressing force in the ideal mechanism."""
        sign = self._signs.note_sign(f"s_{loaded.pair.name}", loaded.components[0].ideal)
        if not sign:
            raise EquationsCoupled
        return sign

    def _slip(self, loaded: LoadedPair) -> Product:
        return self._signs.note_sense(f"sigma_{loaded.pair.name}", loaded.slip)

    def _solved(self, sides: Sequence[Product]) -> list[Product]:
        """Return the sizes of the pressing forces by Cramer's rule."""
        places = {p.pair.name: i for i, p in enumerate(self.loaded)}
        matrix = []
        for i, (loaded, side) in enumerate(zip(self.loaded, sides, strict=True)):
            by = loaded.components[0].by
            row = [self._share(by, name, side) for name in places]
            row[i] = add((ONE, row[i]))
            matrix.append(row)
        right = [p.components[0].ideal * s for p, s in zip(self.loaded, sides, strict=True)]
        whole = determinant(matrix)
        return [
            canonical(determinant(with_column(matrix, i, right)) / whole) for i in range(len(right))
        ]

    def _share(self, by: Mapping[str, Product], name: str, side: Product) -> Product:
        """Return by how much a unit of another pressing force presses less here."""
        if name not in by:
            return ZERO
        other = next(p for p in self.loaded if p.pair.name == name)
        return (side * by[name] * other.pair.factor * self._slip(other)).scaled(self._sense)

    def _step(self, sides: Sequence[Product], sizes: Sequence[Product]) -> FrictionStep:
        """Return the forces that press, the slips, and what frictions add to the driving load."""
        balances = [self._balance(*pair) for pair in zip(self.loaded, sides, strict=True)]
        sizes = [canonical(size / _mean(p)) for p, size in zip(self.loaded, sizes, strict=True)]
        found = zip(map(_size, self.loaded), (size.formula() for size in sizes), strict=True)
        equations = dict.fromkeys((*balances, *found))
        self._balances = tuple(equations)
        equations |= {
            (_slip(p), (self._slip(p) * p.slip_of_one).formula()): None for p in self.loaded
        }
        powers = (
            power(self._sense * p.times, _factor(p).formula(), _size(p), _slip(p))
            for p in self.loaded
        )
        whole = total([self._ideal.formula(), *powers])
        kind: StepKind = "ropes" if all(p.pair.tensions for p in self.loaded) else "straight"
        return FrictionStep(kind, equations=(*equations, (Symbol(self._driving), whole)))

    def _balance(self, loaded: LoadedPair, side: Product) -> tuple[Formula, Formula]:
        """Return a pressing force less what frictions change in it, and the ideal one."""
        (component,) = loaded.components
        shares = ((self._share(component.by, p.pair.name, side), p) for p in self.loaded)
        if loaded.pair.tensions:
            parts = ((add((ONE, share)) if p is loaded else share, p) for share, p in shares)
            terms = [(canonical(part * _mean(p)), p) for part, p in parts]
        else:
            terms = [(ONE, loaded), *((share * _mean(p), p) for share, p in shares)]
        of_each = (product([(part.formula(), 1), (_size(p), 1)]) for part, p in terms if part)
        return total(of_each), (component.ideal * side).formula()


def _size(loaded: LoadedPair) -> Formula:
    """Return the name of what presses; of a rope that of its smaller tension."""
    return Symbol(f"{'S' if loaded.pair.tensions else 'n'}_{loaded.pair.name}")


def _mean(loaded: LoadedPair) -> Product:
    """Return the force that presses for a unit of the named one: of a rope the mean tension."""
    ratio = loaded.pair.tensions
    return add((ONE, ratio)).scaled(Fraction(1, 2)) if ratio else ONE


def _factor(loaded: LoadedPair) -> Product:
    """Return the friction for a unit of what is named: of a rope the difference of tensions."""
    ratio = loaded.pair.tensions
    return add((ratio, -ONE)) if ratio else loaded.pair.factor


def _slip(loaded: LoadedPair) -> Formula:
    return Symbol(f"v_{loaded.pair.name}")
