"""Pressing forces by their coupled equations: as many as there are pairs of surfaces.

With n the sizes of the pressing forces, n = |φ·ideal + Σ D·n| under loads of the size φ. The
solution is followed from D = 0, where n is what the loads make alone, while all frictions
grow alike: the friction of a share t of the coefficients is t·D.

The equations are homogeneous in loads and pressing forces, so that the loads need not stay
the same on the way. Near a dead centre of the drive φ alone would not do: there D is large,
because the drive that balances a friction is. What is kept is the size of forces and of the load
q without friction together, φ = q - g·Σ κ·n, where κ·n is what a friction adds to the driving
load. With the g for which D - g·ideal·κ is least, this rest is of order one at a dead centre, too.

What is concluded from what. The solutions with a share t of all friction are a curve, from the
one without friction on (:mod:`~mechc.formula.numeric.arcs`).

- It comes to t = 1 with φ > 0: there the forces balance, the mechanism moves.
- It comes to t = 1 with φ < 0: where φ passed zero the drive would need to be infinitely strong,
  and behind it the load to be reversed. The solution says that nothing moves.
- It turns back before, at a fold: forces that balance with less friction end before all of it is
  there. Nothing moves, either, unless Newton's method finds forces that balance with all of it:
  of a pressing force that nothing makes but its own friction, what is rounded off makes folds.
- None of the three was found: nothing is said of the pose. That steps became short, or that
  corrections did not suffice, is no reason.

Where a pressing force vanishes its size has a corner. The corner is rounded off by a part of the
loads φ, which vanishes at t = 1, so that the curve is smooth before; and by a part of the share t,
as the loads vanish, too, where φ passes zero. Neither is a part of the whole size q: forces may be
small against it, where links lie on a line, and would be rounding.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from fractions import Fraction

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..formula.names import another
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
from ..model.result import Definition
from .friction_pairs import Component, LoadedPair
from .naming import ForceSizes
from .signs.senses import sense_of

KEPT_FROM_ZERO = number(Fraction(1, 10**30))
"""What is added to pressing forces so that none of them vanishes, where no slope would be."""

ROUNDED_OFF = Fraction(3, 100)
"""By how much, against the loads, pressing forces are rounded off where they vanish.

They are at the outset, and no longer at the end: on the way a force may turn round.
"""

TOO_LARGE = Fraction(2) ** 46
"""The sum of squares of D from which nothing follows: about 1e14, and no number of a user's.

Near a dead centre forces of 1e7 times their sum may cancel, so that Newton's corrections stop
to shrink by rounding, as they do where the branch of solutions ends. Code in single precision
has a limit of its own by this one's digits (``emit.c.real``).
"""


class FrictionShare(NamedTuple):
    """How a friction, as it acts on its slip, changes a component for each unit of its true size.

    The friction is that of the pair at a ``place`` in their order.
    """

    place: int
    name: str
    amount: Formula


class ForceRow(NamedTuple):
    """One component of a pressing force: the ideal one, and what frictions share in it."""

    ideal: Definition
    shares: tuple[FrictionShare, ...]


@frozen
class SystemNames:
    """What the parts of the system are called: those of each pair, in their order, then the rest.

    Of each pair that is its true size, the unknown that it is found by, the power that its
    friction takes, and its size without friction (``sizes``, ``unknowns``, ``added``, ``alone``).
    ``scale`` is the size of all forces without friction, ``length`` how long the way is, ``turn``
    the g above and ``common`` the sum that it is a quotient of, ``load`` φ at the end, ``without``
    q. ``step`` and ``left`` are what frictions and loads are multiplied by on the way, ``rounded``
    is how much of them rounds corners off.
    """

    sizes: tuple[str, ...]
    unknowns: tuple[str, ...]
    added: tuple[str, ...]
    alone: tuple[str, ...]
    scale: str
    length: str
    turn: str
    common: str
    load: str
    without: str
    step: str
    left: str
    rounded: str


@frozen
class Coupled:
    """The coupled equations of loaded pairs, for either sense of motion."""

    loaded: tuple[LoadedPair, ...]
    names: SystemNames
    pairs: tuple[tuple[ForceRow, ...], ...]
    system: System

    @property
    def rows(self) -> tuple[ForceRow, ...]:
        """Return the components of all pressing forces."""
        return tuple(row for pair in self.pairs for row in pair)

    @property
    def shares(self) -> list[FrictionShare]:
        """Return the shares of all frictions in all components."""
        return [share for row in self.rows for share in row.shares]


def coupled(loaded: Sequence[LoadedPair], taken: Set[str]) -> Coupled:
    """Return the coupled equations of pairs, under names that are not taken."""
    name = _fresh(taken)
    sizes, unknowns, added, alone = (
        tuple(name(f"{prefix}_{p.pair.name}") for p in loaded) for prefix in "nxqa"
    )
    others = ("n_0", "d_0", "g_0", "e_0", "phi_0", "q_0", "t_0", "t_1", "t_2")
    names = SystemNames(sizes, unknowns, added, alone, *map(name, others))
    places = {p.pair.name: i for i, p in enumerate(loaded)}
    pairs = tuple(tuple(_rows(p, loaded, places, name)) for p in loaded)
    return Coupled(tuple(loaded), names, pairs, _system(names, pairs))


def _fresh(taken: Set[str]) -> Callable[[str], str]:
    """Return a function that gives each name that is wanted, or one like it, once."""
    used = set(taken)

    def name(wanted: str) -> str:
        while wanted in used:
            wanted = another(wanted)
        used.add(wanted)
        return wanted

    return name


def _rows(
    pair: LoadedPair,
    loaded: Sequence[LoadedPair],
    places: Mapping[str, int],
    name: Callable[[str], str],
) -> Iterator[ForceRow]:
    """Yield the components of the force that presses a pair."""
    for axis, component in zip("xy", pair.components, strict=False):
        ideal = Definition(name(f"r_{pair.pair.name}{axis}"), component.ideal.formula())
        shares = _shares(f"d_{pair.pair.name}{axis}", component, loaded, places, name)
        yield ForceRow(ideal, tuple(shares))


def _shares(
    prefix: str,
    component: Component,
    loaded: Sequence[LoadedPair],
    places: Mapping[str, int],
    name: Callable[[str], str],
) -> Iterator[FrictionShare]:
    """Yield what the friction of each pair adds to a component, under a name."""
    for other, part in component.by.items():
        place = places[other]
        amount = part * loaded[place].pair.factor
        yield FrictionShare(place, name(f"{prefix}{other}"), amount.formula())


def true_sizes(equations: Coupled, sense: int) -> ForceSizes:
    """Return the sizes of the pressing forces that solve the coupled equations."""
    pairs = zip(equations.loaded, equations.names.sizes, strict=True)
    names = {loaded.pair.name: name for loaded, name in pairs}
    return ForceSizes(
        names, tuple(_definitions(equations, sense)), sense, (Symbol(equations.names.load),)
    )


# ------------------------------------------------------------------------ definitions


def _definitions(of: Coupled, sense: int) -> Iterator[Definition]:
    """Yield the ideal forces, how frictions change them, and the true sizes."""
    yield from (row.ideal for row in of.rows)
    yield Definition(of.names.scale, _hypot(row.ideal.name for row in of.rows))
    for name, pair in zip(of.names.alone, of.pairs, strict=True):
        ideal = (_per_scale(of, row.ideal.name) for row in pair)
        yield Definition(name, Call("hypot", (*ideal, number(ROUNDED_OFF))))
    yield from _against(of, [sense_of(p.slip) for p in of.loaded], sense)
    slips = [p.slip.formula() for p in of.loaded]
    for name, loaded, slip in zip(of.names.added, of.loaded, slips, strict=True):
        yield Definition(name, _power(loaded.pair.factor.formula(), slip, sense))
    yield from _of_the_load(of)
    yield from _solutions(of)


def _against(of: Coupled, sides: Sequence[Formula], sense: int) -> Iterator[Definition]:
    """Yield by how much a unit of each true size changes a component; ``sides`` is of slips."""
    for share in of.shares:
        parts = [(number(-sense), 1), (share.amount, 1), (sides[share.place], 1)]
        yield Definition(share.name, product(parts))


def _power(factor: Formula, slip: Formula, sense: int) -> Formula:
    """Return the driving load that friction takes for each unit of a normal force."""
    return product([(number(sense), 1), (factor, 1), (Call("abs", (slip,)), 1)])


def _of_the_load(of: Coupled) -> Iterator[Definition]:
    """Yield how much of D goes along with the loads that friction adds; how long the way is."""
    names = of.names
    common = (
        product([(_per_scale(of, r.ideal.name), 1), (Symbol(s.name), 1), (_adds(of, s), 1)])
        for r in of.rows
        for s in r.shares
    )
    yield Definition(names.common, total(common))
    squares = (product([(Symbol(name), 2)]) for name in names.added)
    yield Definition(names.turn, quotient(Symbol(names.common), total([*squares, KEPT_FROM_ZERO])))
    both = product([(Symbol(names.turn), 1), (Symbol(names.common), 1)])
    whole = total([product([(Symbol(share.name), 2)]) for share in of.shares])
    rest = Call("max", (total([whole, negative(both)]), number(0)))
    parts = (total([ONE, rest]), _certain(whole))
    yield Definition(names.length, Call("sqrt", (product([(p, 1) for p in parts]),)))


def _solutions(of: Coupled) -> Iterator[Definition]:
    """Yield the loads at the end, and the true sizes where they are as given."""
    names, system = of.names, of.system
    ideal = {row.ideal.name for row in of.rows}
    arguments = tuple(_argument(of, name, name in ideal) for name, _ in system.anchor)
    found = [Implicit(system, i, arguments) for i in range(len(system.unknowns))]
    for name, size in zip(names.unknowns, found, strict=False):
        yield Definition(name, size)
    less = product([(number(-1), 1), (Symbol(names.turn), 1), (_load_added(names), 1)])
    yield Definition(names.load, total([found[-1], less]))
    for name, unknown in zip(names.sizes, names.unknowns, strict=True):
        parts = [(Symbol(names.scale), 1), (Symbol(unknown), 1), (Symbol(names.load), -1)]
        yield Definition(name, product(parts))


def _argument(of: Coupled, name: str, is_ideal: bool) -> Formula:
    """Return the value of a symbol of the system at the end of the way."""
    names = of.names
    if name in (names.step, names.left):
        return quotient(ONE, Symbol(names.length))
    if name == names.rounded:
        return KEPT_FROM_ZERO
    if name in names.added:
        return product([(Symbol(names.turn), 1), (Symbol(name), 1)])
    return _per_scale(of, name) if is_ideal else Symbol(name)


def _per_scale(of: Coupled, name: str) -> Formula:
    return quotient(Symbol(name), Symbol(of.names.scale))


def _adds(of: Coupled, share: FrictionShare) -> Formula:
    return Symbol(of.names.added[share.place])


# ----------------------------------------------------------------------------- system


def _system(names: SystemNames, pairs: Sequence[Sequence[ForceRow]]) -> System:
    """Return the equations, each force times the share of the way that is left."""
    left, step = Symbol(names.left), Symbol(names.step)
    load = product([(left, 1), (Symbol(names.without), 1)])
    true_load = total([load, product([(number(-1), 1), (step, 1), (_load_added(names), 1)])])
    rounded = [product([(Symbol(names.rounded), 1), (part, 1)]) for part in (load, step)]
    equations = [
        total(
            [
                product([(left, 1), (Symbol(x), 1)]),
                negative(Call("hypot", (*(_force(r, true_load, names) for r in pair), *rounded))),
            ]
        )
        for x, pair in zip(names.unknowns, pairs, strict=True)
    ]
    unknowns = (*names.unknowns, names.without)
    every = (*equations, _measure(names))
    return System(
        unknowns,
        every,
        _anchor(names, [r for pair in pairs for r in pair]),
        (*names.alone, 1.0),
        by_arcs=True,
    )


def _anchor(names: SystemNames, rows: Sequence[ForceRow]) -> tuple[tuple[str, float | None], ...]:
    """Return where the way begins: without friction; what has no value there stays as it is."""
    path = ((names.step, 0.0), (names.left, 1.0), (names.rounded, float(ROUNDED_OFF)))
    kept = [*(row.ideal.name for row in rows), *names.alone, *names.added]
    kept += [share.name for row in rows for share in row.shares]
    return (*path, *((name, None) for name in kept))


def _load_added(names: SystemNames) -> Formula:
    """Return the driving load that all frictions together take."""
    return total(
        product([(Symbol(added), 1), (Symbol(x), 1)])
        for added, x in zip(names.added, names.unknowns, strict=True)
    )


def _force(row: ForceRow, load: Formula, names: SystemNames) -> Formula:
    """Return a component of a force in the unknowns."""
    terms = (
        product([(Symbol(s.name), 1), (Symbol(names.unknowns[s.place]), 1)]) for s in row.shares
    )
    by_friction = product([(Symbol(names.step), 1), (total(terms), 1)])
    return total([product([(Symbol(row.ideal.name), 1), (load, 1)]), by_friction])


def _measure(names: SystemNames) -> Formula:
    """Return the equation by which loads and forces keep their size altogether.

    It is a sphere, which each ray of solutions meets once: a plane is met by none that is parallel
    to it, and solutions next to that one would be as large as they like.
    """
    part = number(Fraction(1, len(names.unknowns) + 1))
    squares = (
        total([product([(Symbol(x), 2)]), product([(number(-1), 1), (Symbol(a), 2)])])
        for x, a in zip(names.unknowns, names.alone, strict=True)
    )
    without = product([(Symbol(names.without), 2)])
    return total([without, product([(part, 1), (total(squares), 1)]), number(-1)])


def _hypot(names: Iterator[str]) -> Formula:
    return Call("hypot", (*map(Symbol, names), KEPT_FROM_ZERO))


def _certain(whole: Formula) -> Formula:
    """Return 1 and, as D grows, less: where D is too large it is negative and has no root.

    As a factor of the length of the way it changes no solution: forces keep their proportion.
    """
    return total([ONE, product([(number(-1 / TOO_LARGE), 1), (whole, 1)])])
