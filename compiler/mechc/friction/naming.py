"""Names that mean one thing in all results of a mechanism.

The force in a rod is another one while the drive tightens than while it just holds. Where a
name stands for something else already, it gets an ending: ``S_AB_hold``, or ``S_AB_m_f`` in the
results of a ratio m.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..algebra.from_formula import to_product
from ..algebra.sums import canonical
from ..base.frozen import frozen
from ..formula.tree import Call, Formula, Symbol
from ..formula.walk import Substitution, substitute, symbols
from ..model.mechanism import Sense
from ..model.parts.targets import HOLDING
from ..model.result import Definition
from .friction_pairs import FrictionPair


@frozen
class ForceSizes:
    """The names of the true sizes of pressing forces, by pair, and what they rest on.

    They balance where ``positive`` is so.
    """

    names: Mapping[str, str]
    definitions: tuple[Definition, ...]
    sense: int
    positive: tuple[Formula, ...]

    def of(self, pair: FrictionPair) -> Symbol:
        """Return the name of the force in a pair."""
        return Symbol(self.names[pair.name])

    @property
    def inside(self) -> frozenset[str]:
        """Return all names of the system, its many coefficients among them."""
        return frozenset(definition.name for definition in self.definitions)


class Meanings:
    """What names stand for in the results so far."""

    def __init__(self) -> None:
        self._formulas: dict[str, Formula] = {}

    def allow(self, name: str, formula: Formula) -> bool:
        """Return whether a name is free, or stands for this formula already."""
        return self._formulas.get(name, formula) == formula

    def note(self, definitions: Iterable[Definition]) -> None:
        """Keep what names stand for from now on."""
        self._formulas.update(definitions)


class OwnNames:
    """The names that the user's formulas give to what friction is made of: β = asin(f·d/L).

    ``lets`` are these formulas, each after those it needs. One that is a symbol alone gives no
    name: what it stands for has one. Of what rests on a symbol that no let has nothing is kept:
    it has no name, and a force without names is as long as the forces before it taken together.
    """

    def __init__(self, lets: Iterable[Definition]) -> None:
        self._whole: dict[str, Formula] = {}
        self._names: dict[Formula, str] = {}
        self._parts: set[str] = set()
        for name, formula in lets:
            self._parts |= symbols(formula)
            self.note(name, formula)
            if not isinstance(formula, Symbol):
                self._names.setdefault(self._whole[name], name)

    def note(self, name: str, formula: Formula) -> None:
        """Keep what a name stands for, without the names kept before, if it may be in a let."""
        if symbols(formula) <= self._parts:
            self._whole[name] = _normal(substitute(formula, self._whole))
            self._parts.add(name)

    def of(self, formula: Formula) -> str:
        """Return the user's own name of a formula, or ''."""
        if not self._names or not symbols(formula) <= self._parts:
            return ""
        return self._names.get(_normal(substitute(formula, self._whole)), "")


def _normal(formula: Formula) -> Formula:
    """Return a formula as all that are equal to it are written, an arc by its sine or tangent."""
    if isinstance(formula, Call):
        return Call(formula.function, tuple(map(_normal, formula.arguments)))
    return canonical(to_product(formula)).formula()


class Endings:
    """The endings of names, by the ratio and the motion that they belong to."""

    def __init__(self) -> None:
        self._first: Sense | None = None

    def of(self, ideal: str, sense: Sense) -> tuple[str, ...]:
        """Return the endings that names may have, the shortest first.

        >>> endings = Endings()
        >>> endings.of("k", "tightening"), endings.of("k", "releasing")
        (('k_f',), ('hold', 'k_hold'))
        """
        self._first = self._first or sense
        return (f"{ideal}_f",) if sense == self._first else ("hold", f"{ideal}{HOLDING}")

    def of_force(self, ideal: str, sense: Sense) -> tuple[str, ...]:
        """Return those of a force at a joint: ``n_B_f`` is what presses B wherever forces are.

        >>> Endings().of_force("R_O_x", "tightening")
        ('f', 'R_O_x_f')
        """
        found = self.of(ideal, sense)
        return ("f", *found) if sense == self._first else found


def with_one_meaning(
    sizes: ForceSizes, meanings: Sequence[Meanings], endings: Sequence[str]
) -> ForceSizes:
    """Return sizes with all their names ended alike, so that each is new, and keep them."""
    for ending in _tried(endings):
        found = _ended(sizes, ending) if ending else sizes
        if all(m.allow(*definition) for m in meanings for definition in found.definitions):
            break
    for each in meanings:
        each.note(found.definitions)
    return found


def renamed(
    definitions: Sequence[Definition], meanings: Meanings, endings: Sequence[str], taken: Set[str]
) -> dict[str, Symbol]:
    """Return other names for those that mean something else, their own or by what they rest on."""
    names: dict[str, Symbol] = {}
    for name, formula in definitions:  # each after those that it rests on
        whole = Substitution(names).of(formula)
        if not meanings.allow(name, whole):
            ways = (f"{name}{ending}" for ending in _tried(endings) if ending)
            free = (way for way in ways if way not in taken and meanings.allow(way, whole))
            names[name] = Symbol(next(free))
    return names


def _tried(endings: Sequence[str]) -> Iterator[str]:
    yield from ("", *(f"_{ending}" for ending in endings))
    longer = f"_{endings[-1]}"
    while True:
        yield (longer := f"{longer}_")


def _ended(sizes: ForceSizes, ending: str) -> ForceSizes:
    """Return sizes under other names; the system keeps its own, which nobody else sees."""
    names = {d.name: Symbol(f"{d.name}{ending}") for d in sizes.definitions}
    put = Substitution(names)

    def ended(formula: Formula) -> Formula:
        return formula if symbols(formula).isdisjoint(names) else put.of(formula)

    return ForceSizes(
        {pair: names[name].name for pair, name in sizes.names.items()},
        tuple(Definition(names[name].name, ended(formula)) for name, formula in sizes.definitions),
        sizes.sense,
        tuple(map(ended, sizes.positive)),
    )
