"""The names made up for long parts of formulas in one document, and those that mean something."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, count

from ..algebra.equality import equal
from ..formula.names import ParsedName, split_name, split_points
from ..formula.tree import Formula, Symbol, negative
from ..formula.walk import symbols
from ..model.mechanism import Mechanism
from ..study.analysis import Analysis

NamedSums = Mapping[Formula, Symbol]
"""The sums that have got names of their own on a page."""

LETTERS = "ZYXWUH"
"""The letters of sums with a name, in the order in which they are taken."""


class MadeNames:
    """The names made up for long formulas of one document, each with one meaning.

    ``Z1`` and ``Z_1`` are one name on paper, so that either keeps the other from being made up;
    where there is a point Z another letter is taken.
    """

    def __init__(self) -> None:
        self._names: dict[Formula, Symbol] = {}
        self._taken: set[ParsedName] = set()
        self._letter = LETTERS[0]

    def take(self, names: Iterable[str]) -> None:
        """Keep names that mean something already from being made up."""
        self._taken.update(map(split_name, names))

    def take_points(self, points: Iterable[str]) -> None:
        """Keep the letters of points from those of sums, as long as there are others."""
        of_points = {part.letter for point in points for part in split_points(point)}
        self._letter = next((x for x in LETTERS if x not in of_points), LETTERS[0])

    @property
    def sums(self) -> NamedSums:
        """Return the names made up so far, by the formulas that they stand for."""
        return self._names

    def known(self, formula: Formula) -> Symbol | None:
        """Return the name that a formula has got, if any."""
        return self._names.get(formula)

    def opposite(self, formula: Formula) -> Formula | None:
        """Return a name with a minus, where one has been made up for the opposite sum."""
        for known, name in self._names.items():
            if symbols(known) == symbols(formula) and equal(known, negative(formula)):
                return negative(name)
        return None

    def of_sum(self, formula: Formula) -> Symbol:
        """Return a new name ``Z_1``, ``Z_2`` … for a sum."""
        return self._fresh(formula, (f"{self._letter}_{i}" for i in count(1)))

    def of_coefficient(self, formula: Formula, load: str) -> Symbol:
        """Return a new name ``c_F``, ``c_F_2`` … for the coefficient of a load F."""
        own = f"c_{load}"
        return self._fresh(formula, chain([own], (f"{own}_{i}" for i in count(2))))

    def _fresh(self, formula: Formula, names: Iterable[str]) -> Symbol:
        name = next(n for n in names if split_name(n) not in self._taken)
        self.take([name])
        return self._names.setdefault(formula, Symbol(name))


def points_of(mechanism: Mechanism) -> Iterator[str]:
    """Yield the points of bodies, and those that are pinned to the ground."""
    yield from (point for body in mechanism.bodies for point in body.points)
    yield from mechanism.fixed


def names_of(mechanism: Mechanism, results: Sequence[Analysis]) -> Iterator[str]:
    """Yield the names that mean something in a report of these results."""
    yield from (p.name for p in (*mechanism.parameters, *mechanism.literals))
    yield from dict.fromkeys(load.name for load in mechanism.loads)
    for result in results:
        yield result.name
        yield from (d.name for d in result.where)
        yield from sorted(symbols(result.formula))
