"""Pressing forces by their coupled equations: as many as there are pairs of surfaces.

With n the sizes of the pressing forces, n = |φ·ideal + Σ D·n| under loads of the size φ. The
solution is followed from D = 0, where n is what the loads press alone, while all frictions
grow alike: the friction of a share t of the coefficients is t·D.

The equations are homogeneous in loads and pressing forces, so that the loads need not stay
the same on the way. Beside a dead centre of the drive φ alone would not do: there D is large,
because the drive that balances a friction is. What is kept near 1 is the size q of the load
without friction, φ = q - g·Σ κ·n, where κ·n is what a friction adds to the driving load. With
the g for which D - g·ideal·κ is least, this rest is of order one at a dead centre, too. Where φ
passes zero the drive would need to be infinitely strong, and behind it the load to be turned
round: nothing balances. Nor does anything where the branch of solutions ends on the way.
"""

from collections.abc import Iterator, Mapping, Sequence, Set
from fractions import Fraction

from ..formula.names import another
from ..formula.newton import LONGER
from ..formula.tree import (
    ONE,
    Call,
    Formula,
    Implicit,
    Symbol,
    System,
    negative,
    number,
    product,
    quotient,
    total,
)
from ..frozen import frozen
from ..model.result import Definition
from ..named import NamedTuple
from .normal_forces import Component, LoadedPair

NOTHING = number(Fraction(1, 10**30))
"""What is added to pressing forces so that none of them vanishes, where no slope would be."""

ROUNDED = Fraction(3, 100)
"""By how much, against all of them, pressing forces are rounded off where they vanish.

They are at the outset, and no longer at the end: on the way a force may turn round.
"""

TOO_LARGE = Fraction(2) ** 46
"""The sum of squares of D from which nothing follows: about 1e14, and no number of a user's.

Beside a dead centre forces of 1e7 times their sum may cancel, so that Newton's corrections stop
to shrink by rounding, as they do where the branch of solutions ends. Code in single precision
has a limit of its own by this one's digits (``emit.c.real``).
"""


@frozen
class Sizes:
    """The names of the true sizes of pressing forces, by pair, and what they rest on.

    They balance where ``positive`` is so.
    """

    names: Mapping[str, str]
    definitions: tuple[Definition, ...]
    sense: int
    positive: tuple[Formula, ...]

    @property
    def inside(self) -> frozenset[str]:
        """Return all names of the system, its many coefficients among them."""
        return frozenset(definition.name for definition in self.definitions)


def true_sizes(pressed: Sequence[LoadedPair], sense: int, taken: Set[str]) -> Sizes:
    """Return the sizes of the pressing forces that solve the coupled equations."""
    coupled = _Coupled(pressed, sense, taken)
    definitions = tuple(coupled.definitions())
    names = {p.pair.name: name for p, name in zip(pressed, coupled.sizes, strict=True)}
    return Sizes(names, definitions, sense, (coupled.load,))


class Row(NamedTuple):
    """One component of a pressing force: the ideal one, and its part per true size."""

    ideal: Definition
    shares: tuple[tuple[int, Definition], ...]


class _Coupled:
    """Names what the system is made of, and the system."""

    def __init__(self, pressed: Sequence[LoadedPair], sense: int, taken: Set[str]) -> None:
        self._pressed, self._sense, self._taken = pressed, sense, set(taken)
        self._places = {p.pair.name: i for i, p in enumerate(pressed)}
        self.sizes = self._each("n")
        self._unknowns, self._added = self._each("x"), self._each("q")
        self._alone = self._each("a")
        self._scale, self._length = self._name("n_0"), self._name("d_0")
        self._turn, self._common = self._name("g_0"), self._name("e_0")
        self._load = self._name("phi_0")
        self._without = self._name("q_0")
        self._step, self._left, self._rounded = (self._name(n) for n in ("t_0", "t_1", "t_2"))

    @property
    def load(self) -> Formula:
        """Return the size of the loads at the end of the way."""
        return Symbol(self._load)

    def _each(self, prefix: str) -> list[str]:
        return [self._name(f"{prefix}_{p.pair.name}") for p in self._pressed]

    def _name(self, wanted: str) -> str:
        while wanted in self._taken:
            wanted = another(wanted)
        self._taken.add(wanted)
        return wanted

    # -------------------------------------------------------------------- definitions

    def definitions(self) -> Iterator[Definition]:
        """Yield the ideal forces, how frictions change them, and the true sizes."""
        pairs = [self._rows(p) for p in self._pressed]
        rows = [row for pair in pairs for row in pair]
        yield from (row.ideal for row in rows)
        yield Definition(self._scale, _hypot(row.ideal.name for row in rows))
        for name, pair in zip(self._alone, pairs, strict=True):
            ideal = (self._per_scale(row.ideal.name) for row in pair)
            yield Definition(name, Call("hypot", (*ideal, number(ROUNDED))))
        yield from (share for row in rows for _, share in row.shares)
        yield from self._of_the_load(rows)
        yield from self._solutions(pairs)

    def _of_the_load(self, rows: Sequence[Row]) -> Iterator[Definition]:
        """Yield the loads that friction adds, and the length of the path."""
        added = [(name, self._power(p)) for name, p in zip(self._added, self._pressed, strict=True)]
        for name, power in added:
            yield Definition(name, power)
        shares = [share.name for row in rows for _, share in row.shares]
        common = (
            product([(self._per_scale(r.ideal.name), 1), (Symbol(d.name), 1), (self._adds(i), 1)])
            for r in rows
            for i, d in r.shares
        )
        yield Definition(self._common, total(common))
        squares = (product([(self._adds(i), 2)]) for i in range(len(added)))
        yield Definition(self._turn, quotient(Symbol(self._common), total([*squares, NOTHING])))
        both = product([(Symbol(self._turn), 1), (Symbol(self._common), 1)])
        whole = total([product([(Symbol(share), 2)]) for share in shares])
        rest = Call("max", (total([whole, negative(both)]), number(0)))
        parts = (total([ONE, rest]), _certain(whole))
        yield Definition(self._length, Call("sqrt", (product([(p, 1) for p in parts]),)))

    def _solutions(self, pairs: Sequence[Sequence[Row]]) -> Iterator[Definition]:
        """Yield the loads at the end, and the true sizes where they are as given."""
        system = self._system(pairs)
        arguments = tuple(self._argument(name) for name, _ in system.anchor)
        found = [Implicit(system, i, arguments) for i in range(len(system.unknowns))]
        for name, size in zip(self._unknowns, found, strict=False):
            yield Definition(name, size)
        less = product([(number(-1), 1), (Symbol(self._turn), 1), (self._load_added(), 1)])
        yield Definition(self._load, total([found[-1], less]))
        for name, unknown in zip(self.sizes, self._unknowns, strict=True):
            parts = [(Symbol(self._scale), 1), (Symbol(unknown), 1), (self.load, -1)]
            yield Definition(name, product(parts))

    def _argument(self, name: str) -> Formula:
        if name in (self._step, self._left):
            return quotient(ONE, Symbol(self._length))
        if name == self._rounded:
            return NOTHING
        ideal = name in self._ideal
        if name in self._added:
            return product([(Symbol(self._turn), 1), (Symbol(name), 1)])
        return self._per_scale(name) if ideal else Symbol(name)

    def _per_scale(self, name: str) -> Formula:
        return quotient(Symbol(name), Symbol(self._scale))

    def _adds(self, i: int) -> Formula:
        return Symbol(self._added[i])

    def _power(self, pressed: LoadedPair) -> Formula:
        """Return the driving load that friction takes for each unit of a normal force."""
        slip = Call("abs", (pressed.slip.formula(),))
        return product([(number(self._sense), 1), (pressed.pair.factor.formula(), 1), (slip, 1)])

    def _rows(self, pressed: LoadedPair) -> list[Row]:
        return [
            Row(
                Definition(self._name(f"r_{pressed.pair.name}{axis}"), component.ideal.formula()),
                tuple(self._shares(f"d_{pressed.pair.name}{axis}", component)),
            )
            for axis, component in zip("xy", pressed.components, strict=False)
        ]

    def _shares(self, prefix: str, component: Component) -> Iterator[tuple[int, Definition]]:
        """Yield by how much a unit of each true size changes a component."""
        for other, part in component.by.items():
            place = self._places[other]
            slip = self._pressed[place].slip
            factor = self._pressed[place].pair.factor
            against = product(
                [
                    (number(-self._sense), 1),
                    ((part * factor).formula(), 1),
                    (Call("sign", (slip.formula(),)), 1),
                ]
            )
            yield place, Definition(self._name(f"{prefix}{other}"), against)

    # ------------------------------------------------------------------------- system

    def _system(self, pairs: Sequence[Sequence[Row]]) -> System:
        """Return the equations, each force times the share of the way that is left."""
        rows = [row for pair in pairs for row in pair]
        self._ideal = {row.ideal.name for row in rows}
        left, step = Symbol(self._left), Symbol(self._step)
        load = product([(left, 1), (Symbol(self._without), 1)])
        true_load = total([load, product([(number(-1), 1), (step, 1), (self._load_added(), 1)])])
        rounded = product([(Symbol(self._rounded), 1), (load, 1)])
        equations = [
            total(
                [
                    product([(left, 1), (Symbol(x), 1)]),
                    negative(Call("hypot", (*(self._force(r, true_load) for r in pair), rounded))),
                ]
            )
            for x, pair in zip(self._unknowns, pairs, strict=True)
        ]
        unknowns = (*self._unknowns, self._without)
        every = (*equations, self._measure())
        return System(unknowns, every, self._anchor(rows), (*self._alone, 1.0), LONGER)

    def _anchor(self, rows: Sequence[Row]) -> tuple[tuple[str, float | None], ...]:
        """Return where the way begins: without friction; what has no value there stays as it is."""
        path = ((self._step, 0.0), (self._left, 1.0), (self._rounded, float(ROUNDED)))
        kept = [*(row.ideal.name for row in rows), *self._alone, *self._added]
        kept += [share.name for row in rows for _, share in row.shares]
        return (*path, *((name, None) for name in kept))

    def _load_added(self) -> Formula:
        """Return the driving load that all frictions together take."""
        return total(
            product([(self._adds(i), 1), (Symbol(x), 1)]) for i, x in enumerate(self._unknowns)
        )

    def _force(self, row: Row, load: Formula) -> Formula:
        """Return a component of a force in the unknowns."""
        terms = (
            product([(Symbol(d.name), 1), (Symbol(self._unknowns[i]), 1)]) for i, d in row.shares
        )
        by_friction = product([(Symbol(self._step), 1), (total(terms), 1)])
        return total([product([(Symbol(row.ideal.name), 1), (load, 1)]), by_friction])

    def _measure(self) -> Formula:
        """Return the equation by which loads and forces keep their size altogether."""
        without, part = Symbol(self._without), number(Fraction(1, len(self._unknowns) + 1))
        more = (
            total([Symbol(x), product([(number(-1), 1), (Symbol(a), 1), (without, 1)])])
            for x, a in zip(self._unknowns, self._alone, strict=True)
        )
        return total([without, product([(part, 1), (total(more), 1)]), number(-1)])


def _hypot(names: Iterator[str]) -> Formula:
    return Call("hypot", (*map(Symbol, names), NOTHING))


def _certain(whole: Formula) -> Formula:
    """Return 1 and, as D grows, less: where D is too large it is negative and has no root.

    As a factor of the length of the way it changes no solution: forces keep their proportion.
    """
    return total([ONE, product([(number(-1 / TOO_LARGE), 1), (whole, 1)])])
