"""What products have in common, computed once: reciprocals, and pairs of factors.

A division takes as long as ten multiplications. Where fractions have the same factors below
the line, their reciprocal is an entry by which each is multiplied; that costs each one rounding
more. Then a pair of factors that products have in common is an entry, the most frequent pair
first; each saves a multiplication at least, so that there is an end to it.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from heapq import heappop, heappush
from itertools import combinations, combinations_with_replacement
from typing import assert_never

from ..base.named import NamedTuple
from .table import (
    Apply,
    EntryTable,
    EntryTerms,
    Leaf,
    Raised,
    Ratio,
    Scaled,
    SolvedUnknown,
    TableEntry,
    parts,
)

Divisor = tuple[int, ...]
"""The factors below a fraction line, in the order of the table."""

FactorPair = tuple[int, int]
"""Two factors, the one that stands first in the table first."""


def with_common_factors(
    table: EntryTable, roots: Sequence[int]
) -> tuple[EntryTable, tuple[int, ...]]:
    """Return a table in which what the roots need is divided and multiplied once, and the roots.

    >>> from ..formula.tree import Symbol, quotient
    >>> from .table import tabulate
    >>> fractions = [quotient(Symbol(name), Symbol("c")) for name in "ab"]
    >>> found, (a, b) = with_common_factors(*tabulate(fractions))
    >>> found.entries[a], found.entries[b]
    (Ratio(above=(0, 3), below=()), Ratio(above=(5, 3), below=()))
    >>> found.entries[3]
    Ratio(above=(), below=(1,))
    """
    return _multiplied_once(*_divided_once(table, roots))


# ---------------------------------------------------------------------- reciprocals


class _Fraction(NamedTuple):
    coefficient: Fraction
    ratio: Ratio


def _divided_once(table: EntryTable, roots: Sequence[int]) -> tuple[EntryTable, tuple[int, ...]]:
    """Return a table that divides by each common divisor once, and the places of its roots."""
    common = _common_divisors(table, roots)
    made, place = EntryTable(table.split), dict[int, int]()
    for index, entry in enumerate(table.entries):
        fraction = _fraction(table, index)
        if fraction and _divisor(fraction.ratio) in common:
            over = common[_divisor(fraction.ratio)]
            place[index] = _times_reciprocal(fraction, over, made, place)
        else:
            place[index] = made.add(_moved(entry, place))
    return made, tuple(place[root] for root in roots)


def _common_divisors(table: EntryTable, roots: Sequence[int]) -> Mapping[Divisor, Fraction]:
    """Return the divisors that several fractions have, with what most of them have above.

    That is the number which goes into the reciprocal. Constants are no divisors.
    """
    found: dict[Divisor, Counter[Fraction]] = {}
    for fraction in _fractions(table, roots):
        numbers = found.setdefault(_divisor(fraction.ratio), Counter())
        numbers[abs(fraction.coefficient)] += 1
    constant = table.constants()
    several = {d: numbers for d, numbers in found.items() if numbers.total() > 1}
    return {d: n.most_common(1)[0][0] for d, n in several.items() if not constant.issuperset(d)}


def _fractions(table: EntryTable, roots: Sequence[int]) -> Iterator[_Fraction]:
    """Yield the fractions that the roots need, each with its coefficient."""
    needed = set(roots)
    for index in range(len(table.entries) - 1, -1, -1):
        if index in needed:
            fraction = _fraction(table, index)
            needed.update(parts(fraction.ratio if fraction else table.entries[index]))
            if fraction:
                yield fraction


def _fraction(table: EntryTable, index: int) -> _Fraction | None:
    match table.entries[index]:
        case Scaled(coefficient, part):
            entry = table.entries[part]
        case entry:
            coefficient = Fraction(1)
    return _Fraction(coefficient, entry) if isinstance(entry, Ratio) else None


def _divisor(ratio: Ratio) -> Divisor:
    return tuple(sorted(ratio.below))


def _times_reciprocal(
    fraction: _Fraction, over: Fraction, made: EntryTable, place: Mapping[int, int]
) -> int:
    """Return the entry of a fraction as what is above times the reciprocal ``over``/below."""
    above, below = (tuple(place[f] for f in side) for side in fraction.ratio)
    reciprocal = _scaled(over, made.add(Ratio((), below)), made)
    core = made.add(Ratio((*above, reciprocal), ())) if above else reciprocal
    return _scaled(fraction.coefficient / over, core, made)


def _scaled(coefficient: Fraction, entry: int, made: EntryTable) -> int:
    return entry if coefficient == 1 else made.add(Scaled(coefficient, entry))


def _moved(entry: TableEntry, place: Mapping[int, int]) -> TableEntry:
    """Return an entry whose parts have other places."""
    here = tuple(place[part] for part in parts(entry))
    match entry:
        case Leaf():
            return entry
        case EntryTerms():
            return EntryTerms(here)
        case Scaled(coefficient, _):
            return Scaled(coefficient, *here)
        case Ratio(above, _):
            return Ratio(here[: len(above)], here[len(above) :])
        case Apply(function, _):
            return Apply(function, here)
        case Raised():
            return Raised(*here)
        case SolvedUnknown(system, which, _):
            return SolvedUnknown(system, which, here)
        case _:
            assert_never(entry)


# ----------------------------------------------------------------- pairs of factors


def _multiplied_once(table: EntryTable, roots: Sequence[int]) -> tuple[EntryTable, tuple[int, ...]]:
    """Return a table in which products share factors, each multiplied once, and its roots."""
    needed = table.reached(roots)
    ratios = {i: e for i, e in enumerate(table.entries) if i in needed and isinstance(e, Ratio)}
    products = _Products((s for ratio in ratios.values() for s in ratio), len(table.entries))
    products.share()
    sides = map(tuple, products.rows)
    shared = {index: Ratio(next(sides), next(sides)) for index in ratios}
    made, place = EntryTable(table.split), dict[int, int]()

    def at(factor: int) -> int:
        """Return the place of an entry or a pair."""
        if factor not in place:
            place[factor] = made.add(Ratio(tuple(map(at, products.pair(factor))), ()))
        return place[factor]

    for index, entry in enumerate(table.entries):
        match shared.get(index, entry):
            case Ratio((alone,), ()):
                place[index] = at(alone)
            case Ratio(above, below):
                place[index] = made.add(Ratio(tuple(map(at, above)), tuple(map(at, below))))
            case _:
                place[index] = made.add(_moved(entry, place))
    return made, tuple(place[root] for root in roots)


class _Products:
    """Rows of factors, in which pairs become factors that count from ``first`` on."""

    def __init__(self, rows: Iterable[Sequence[int]], first: int) -> None:
        self.rows = [list(row) for row in rows]
        self._first = first
        self._pairs: list[FactorPair] = []
        self._rows_of: dict[FactorPair, dict[int, int]] = {}
        self._most: list[tuple[int, FactorPair]] = []

    def pair(self, factor: int) -> FactorPair:
        """Return the factors of a pair."""
        return self._pairs[factor - self._first]

    def share(self) -> None:
        """Put a factor in place of each pair that occurs twice, the most frequent one first."""
        for row in range(len(self.rows)):
            self._count_pairs(row)
        while self._most:
            times, pair = heappop(self._most)
            if -times == self._times(pair):
                self._replace(pair)

    def _times(self, pair: FactorPair) -> int:
        """Return how often a pair is in all rows."""
        return sum(self._rows_of.get(pair, {}).values())

    def _count_pairs(self, row: int) -> None:
        """Count the pairs of a row, each as often as it is there without sharing a factor."""
        number = Counter(self.rows[row])
        found = {
            pair: min(map(number.__getitem__, pair)) for pair in combinations(sorted(number), 2)
        }
        found |= {(f, f): n // 2 for f, n in number.items() if n > 1}
        for pair, times in found.items():
            self._rows_of.setdefault(pair, {})[row] = times
            self._rank(pair)

    def _uncount_pairs(self, row: int) -> None:
        """Leave the pairs of a row out of the count."""
        for pair in combinations_with_replacement(sorted({*self.rows[row]}), 2):
            rows = self._rows_of.get(pair, {})
            if rows.pop(row, 0):
                self._rank(pair)

    def _rank(self, pair: FactorPair) -> None:
        """Note how often a pair is there, where it is there twice: most are not."""
        times = self._times(pair)
        if times > 1:
            heappush(self._most, (-times, pair))

    def _replace(self, pair: FactorPair) -> None:
        """Put one factor in place of a pair in all rows that have it."""
        factor = self._first + len(self._pairs)
        self._pairs.append(pair)
        for row, times in sorted(self._rows_of[pair].items()):
            self._uncount_pairs(row)
            for _ in range(times):
                self._put(self.rows[row], pair, factor)
            self._count_pairs(row)

    @staticmethod
    def _put(row: list[int], pair: FactorPair, factor: int) -> None:
        """Put a factor where the first one of a pair stands in a row."""
        place = min(map(row.index, pair))
        for part in pair:
            row.remove(part)
        row.insert(place, factor)
