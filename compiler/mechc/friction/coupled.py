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


class Share(NamedTuple):
    """How a friction, as it acts on its slip, changes a component for each unit of its true size.

    The friction is that of the pair at a ``place`` in their order.
    """

    place: int
    name: str
    amount: Formula


class Row(NamedTuple):
    """One component of a pressing force: the ideal one, and what frictions share in it."""

    ideal: Definition
    shares: tuple[Share, ...]


class Coupled:
    """Names what the system is made of, and the system, for either sense of motion."""

    def __init__(self, pressed: Sequence[LoadedPair], taken: Set[str]) -> None:
        self._pressed, self._taken = pressed, set(taken)
        self._places = {p.pair.name: i for i, p in enumerate(pressed)}
        self._slips = [p.slip.formula() for p in pressed]
        self._factors = [p.pair.factor.formula() for p in pressed]
        self._sizes = self._each("n")
        self._unknowns, self._added = self._each("x"), self._each("q")
        self._alone = self._each("a")
        self._scale, self._length = self._name("n_0"), self._name("d_0")
        self._turn, self._common = self._name("g_0"), self._name("e_0")
        self._load = self._name("phi_0")
        self._without = self._name("q_0")
        self._step, self._left, self._rounded = (self._name(n) for n in ("t_0", "t_1", "t_2"))
        self._pairs = [self._rows(p) for p in pressed]
        self._every = [row for pair in self._pairs for row in pair]
        self._system = self._equations()

    def sizes(self, sense: int) -> Sizes:
        """Return the sizes of the pressing forces that solve the coupled equations."""
        names = {p.pair.name: name for p, name in zip(self._pressed, self._sizes, strict=True)}
        return Sizes(names, tuple(self._definitions(sense)), sense, (Symbol(self._load),))

    def _each(self, prefix: str) -> list[str]:
        return [self._name(f"{prefix}_{p.pair.name}") for p in self._pressed]

    def _name(self, wanted: str) -> str:
        while wanted in self._taken:
            wanted = another(wanted)
        self._taken.add(wanted)
        return wanted

    # -------------------------------------------------------------------- definitions

    def _definitions(self, sense: int) -> Iterator[Definition]:
        """Yield the ideal forces, how frictions change them, and the true sizes."""
        yield from (row.ideal for row in self._every)
        yield Definition(self._scale, _hypot(row.ideal.name for row in self._every))
        for name, pair in zip(self._alone, self._pairs, strict=True):
            ideal = (self._per_scale(row.ideal.name) for row in pair)
            yield Definition(name, Call("hypot", (*ideal, number(ROUNDED))))
        yield from self._against(sense)
        for i, name in enumerate(self._added):
            yield Definition(name, self._power(i, sense))
        yield from self._of_the_load()
        yield from self._solutions()

    def _against(self, sense: int) -> Iterator[Definition]:
        """Yield by how much a unit of each true size changes a component."""
        sides = [Call("sign", (slip,)) for slip in self._slips]
        for share in (share for row in self._every for share in row.shares):
            parts = [(number(-sense), 1), (share.amount, 1), (sides[share.place], 1)]
            yield Definition(share.name, product(parts))

    def _of_the_load(self) -> Iterator[Definition]:
        """Yield how much of D goes along with the loads that friction adds; how long the way is."""
        shares = [share.name for row in self._every for share in row.shares]
        common = (
            product([(self._per_scale(r.ideal.name), 1), (Symbol(s.name), 1), (self._adds(s), 1)])
            for r in self._every
            for s in r.shares
        )
        yield Definition(self._common, total(common))
        squares = (product([(Symbol(name), 2)]) for name in self._added)
        yield Definition(self._turn, quotient(Symbol(self._common), total([*squares, NOTHING])))
        both = product([(Symbol(self._turn), 1), (Symbol(self._common), 1)])
        whole = total([product([(Symbol(share), 2)]) for share in shares])
        rest = Call("max", (total([whole, negative(both)]), number(0)))
        parts = (total([ONE, rest]), _certain(whole))
        yield Definition(self._length, Call("sqrt", (product([(p, 1) for p in parts]),)))

    def _solutions(self) -> Iterator[Definition]:
        """Yield the loads at the end, and the true sizes where they are as given."""
        system = self._system
        arguments = tuple(self._argument(name) for name, _ in system.anchor)
        found = [Implicit(system, i, arguments) for i in range(len(system.unknowns))]
        for name, size in zip(self._unknowns, found, strict=False):
            yield Definition(name, size)
        less = product([(number(-1), 1), (Symbol(self._turn), 1), (self._load_added(), 1)])
        yield Definition(self._load, total([found[-1], less]))
        for name, unknown in zip(self._sizes, self._unknowns, strict=True):
            parts = [(Symbol(self._scale), 1), (Symbol(unknown), 1), (Symbol(self._load), -1)]
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

    def _adds(self, share: Share) -> Formula:
        return Symbol(self._added[share.place])

    def _power(self, place: int, sense: int) -> Formula:
        """Return the driving load that friction takes for each unit of a normal force."""
        slip = Call("abs", (self._slips[place],))
        return product([(number(sense), 1), (self._factors[place], 1), (slip, 1)])

    def _rows(self, pressed: LoadedPair) -> list[Row]:
        return [
            Row(
                Definition(self._name(f"r_{pressed.pair.name}{axis}"), component.ideal.formula()),
                tuple(self._shares(f"d_{pressed.pair.name}{axis}", component)),
            )
            for axis, component in zip("xy", pressed.components, strict=False)
        ]

    def _shares(self, prefix: str, component: Component) -> Iterator[Share]:
        for other, part in component.by.items():
            place = self._places[other]
            amount = part * self._pressed[place].pair.factor
            yield Share(place, self._name(f"{prefix}{other}"), amount.formula())

    # ------------------------------------------------------------------------- system

    def _equations(self) -> System:
        """Return the equations, each force times the share of the way that is left."""
        self._ideal = {row.ideal.name for row in self._every}
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
            for x, pair in zip(self._unknowns, self._pairs, strict=True)
        ]
        unknowns = (*self._unknowns, self._without)
        every = (*equations, self._measure())
        return System(unknowns, every, self._anchor(), (*self._alone, 1.0), LONGER)

    def _anchor(self) -> tuple[tuple[str, float | None], ...]:
        """Return where the way begins: without friction; what has no value there stays as it is."""
        path = ((self._step, 0.0), (self._left, 1.0), (self._rounded, float(ROUNDED)))
        kept = [*(row.ideal.name for row in self._every), *self._alone, *self._added]
        kept += [share.name for row in self._every for share in row.shares]
        return (*path, *((name, None) for name in kept))

    def _load_added(self) -> Formula:
        """Return the driving load that all frictions together take."""
        return total(
            product([(Symbol(added), 1), (Symbol(x), 1)])
            for added, x in zip(self._added, self._unknowns, strict=True)
        )

    def _force(self, row: Row, load: Formula) -> Formula:
        """Return a component of a force in the unknowns."""
        terms = (
            product([(Symbol(s.name), 1), (Symbol(self._unknowns[s.place]), 1)]) for s in row.shares
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
