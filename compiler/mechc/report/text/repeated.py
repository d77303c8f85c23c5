"""Long parts that formulas on one page have more than once: each gets a name, and stands once.

>>> from ...formula.to_text import text
>>> from ...formula.tree import Symbol, product, total
>>> a, b, c, d = map(Symbol, "abcd")
>>> long = total([product([(x, 1), (y, 1)]) for x in (a, b) for y in (a, b, c)])
>>> formulas = [product([(a, 1), (long, -1)]), product([(d, 1), (long, -1)])]
>>> parts = RepeatedSums(formulas, MadeNames(), lambda part: True)
>>> [text(parts.shown(formula)) for formula in formulas]
['a/Z_1', 'd/Z_1']
>>> [(name, part == long) for name, part in parts.fresh(formulas)]
[('Z_1', True)]
>>> list(parts.fresh(formulas))
[]
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction

from ...formula.layout import has_minus
from ...formula.operations import count_operations
from ...formula.tree import ZERO, Formula, Number, Power, Sum, negative
from ...formula.walk import children, rebuild, symbols
from ...model.result import Definition
from ..made_names import MadeNames, NamedSums

MINUS = Number(Fraction(-1))
"""The exponent of what is divided by."""

OPERATIONS = 10
"""A sum of fewer operations is read faster than a name that stands for it."""


class RepeatedSums:
    """The names of the long sums that stand inside of several formulas of a page."""

    def __init__(
        self,
        formulas: Iterable[Formula],
        made: MadeNames,
        is_long: Callable[[Formula], bool],
        page: Iterable[Formula] = (),
    ) -> None:
        """Take ``formulas`` of a page, and which sums of them it is worth naming.

        They are named in the order in which the whole of the ``page`` has them.
        """
        self._made = MadeNames()
        self._stated: set[str] = set()
        left = list(formulas)
        while found := _largest(left, is_long):
            self._made.of_sum(found)
            left = [*map(self.shown, left), self._inside(found)]
        for part in _as_met(self.sums, page):
            made.of_sum(part)
        self._made = made

    @property
    def sums(self) -> NamedSums:
        """The sums that have names, with these."""
        return self._made.sums

    def shown(self, formula: Formula) -> Formula:
        """Return a formula with names for the parts that have some, but for it as a whole."""
        return self._inside(formula) if self.sums else formula

    def sides(self, sides: Sequence[Formula]) -> tuple[Formula, ...]:
        """Return the sides of a relation; where something is zero, the whole of it by its name."""
        named = self._named if ZERO in sides else self.shown
        return tuple(map(named, sides)) if self.sums else tuple(sides)

    def fresh(self, formulas: Iterable[Formula]) -> Iterator[Definition]:
        """Yield the names that formulas have, as they are shown, and that are new on the page."""
        met = {name for formula in formulas for name in symbols(self.shown(formula))}
        for whole, symbol in self.sums.items():
            if symbol.name in met - self._stated:
                self._stated.add(symbol.name)
                yield Definition(symbol.name, whole)
                yield from self.fresh([whole])

    def _named(self, formula: Formula) -> Formula:
        if isinstance(formula, Sum):
            known: Formula | None = self._made.known(formula)
            if known is None and count_operations(formula) >= OPERATIONS:
                known = self._made.opposite(formula)
            if known is not None:
                return known
        return self._inside(formula)

    def _inside(self, formula: Formula) -> Formula:
        parts = tuple(map(self._named, children(formula)))
        if isinstance(formula, Power) and has_minus(parts[0]) and formula.exponent == MINUS:
            return negative(Power(negative(parts[0]), formula.exponent))
        return rebuild(formula, parts) if parts != children(formula) else formula


def _as_met(sums: Iterable[Formula], formulas: Iterable[Formula]) -> list[Formula]:
    """Return sums in the order in which formulas have them first."""
    places: dict[Formula, int] = {}
    for place, part in enumerate(part for formula in formulas for part in _inner_sums(formula)):
        places.setdefault(part, place)
    return sorted(sums, key=lambda part: places.get(part, len(places)))


def _largest(formulas: Iterable[Formula], is_long: Callable[[Formula], bool]) -> Formula | None:
    """Return the largest of the long sums that stand inside of formulas more than once."""
    often = Counter(part for formula in formulas for part in _inner_sums(formula))
    found = [part for part, times in often.items() if times > 1 and is_long(part)]
    return max(found, key=count_operations, default=None)


def _inner_sums(formula: Formula) -> Iterator[Sum]:
    for part in children(formula):
        if isinstance(part, Sum) and count_operations(part) >= OPERATIONS:
            yield part
        yield from _inner_sums(part)
