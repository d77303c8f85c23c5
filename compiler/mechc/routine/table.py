"""A table of expressions in which equal parts are one entry.

A formula is lowered into the table part by part. What a machine has no name for is
rewritten on the way (cot = cos/sin, x^3 = x·x·x); products are kept in the order in
which they were written, and differ from their reordering in nothing but that order.
An entry's parts stand before it, so a pass over the entries needs no recursion.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import assert_never

from ..base.named import NamedTuple
from ..formula.choices import spelled_out
from ..formula.tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
)
from ..formula.walk import Once, children


class Leaf(NamedTuple):
    """A number, π or a symbol."""

    formula: Number | Pi | Symbol


class EntryTerms(NamedTuple):
    """A sum."""

    parts: tuple[int, ...]


class Scaled(NamedTuple):
    """A rational multiple of an entry that is itself without a coefficient."""

    coefficient: Fraction
    part: int


class Ratio(NamedTuple):
    """Factors above and below one fraction line; a factor may occur several times."""

    above: tuple[int, ...]
    below: tuple[int, ...]


class Apply(NamedTuple):
    """A function of entries."""

    function: str
    arguments: tuple[int, ...]


class Raised(NamedTuple):
    """A power whose exponent is not a small integer or a half."""

    base: int
    exponent: int


class SolvedUnknown(NamedTuple):
    """An unknown of a system, whose outer symbols have the values of entries."""

    system: System
    which: int
    arguments: tuple[int, ...]


TableEntry = Leaf | EntryTerms | Scaled | Ratio | Apply | Raised | SolvedUnknown


class EntryFactors(NamedTuple):
    """A product taken apart."""

    coefficient: Fraction
    above: tuple[int, ...]
    below: tuple[int, ...]

    def inverse(self) -> "EntryFactors":
        """Return 1 / self."""
        return EntryFactors(1 / self.coefficient, self.below, self.above)


_QUOTIENTS = {"tan": ("sin", "cos"), "cot": ("cos", "sin")}
_RECIPROCALS = {"sec": "cos", "csc": "sin"}


def parts(entry: TableEntry) -> tuple[int, ...]:
    """Return the entries that an entry is made of, left to right."""
    match entry:
        case Leaf():
            return ()
        case EntryTerms(terms):
            return terms
        case Scaled(_, part):
            return (part,)
        case Ratio(above, below):
            return above + below
        case Apply(_, arguments) | SolvedUnknown(_, _, arguments):
            return arguments
        case Raised(base, exponent):
            return (base, exponent)
        case _:
            assert_never(entry)


class EntryTable:
    """The entries, and the arguments whose tangent is to be sine over cosine.

    ``split`` holds arguments of which a sine or cosine is computed anyway, so that a
    tangent costs one division.
    """

    def __init__(self, split: frozenset[int] = frozenset()) -> None:
        self.split = split
        self.entries: list[TableEntry] = []
        self.lower = Once(self._lower)
        self._known: dict[object, int] = {}

    def add(self, entry: TableEntry) -> int:
        """Return the place of an entry whose parts are in the table, putting it there."""
        return self._add(entry, (type(entry), *entry))

    def reached(self, roots: Iterable[int]) -> frozenset[int]:
        """Return the entries that some need, these among them."""
        needed = set(roots)
        for index in range(len(self.entries) - 1, -1, -1):
            if index in needed:
                needed.update(parts(self.entries[index]))
        return frozenset(needed)

    def constants(self) -> frozenset[int]:
        """Return the entries that rest on no symbol."""
        constant = set[int]()
        for index, entry in enumerate(self.entries):
            if isinstance(entry, Leaf):
                known = not isinstance(entry.formula, Symbol)
            else:
                known = constant.issuperset(parts(entry))
            if known:
                constant.add(index)
        return frozenset(constant)

    def _lower(self, formula: Formula) -> int:
        """Return the entry of a formula, putting it and its parts into the table."""
        return self._lower_one(formula, tuple(map(self.lower, children(formula))))

    def _lower_one(self, node: Formula, arguments: tuple[int, ...]) -> int:
        """Return the index of a part's entry, its arguments being entered already."""
        match node:
            case Constant(name, _):
                return self._add(Leaf(Symbol(name)), Symbol(name))
            case Number() | Pi() | Symbol():
                return self._add(Leaf(node), node)
            case Sum():
                return self._add(EntryTerms(arguments), (Sum, tuple(sorted(arguments))))
            case Product():
                return self._product(self._factors(a) for a in arguments)
            case Power(_, Number(value)) if (2 * value).denominator == 1 and abs(value) <= 64:
                return self._power(arguments[0], value)
            case Power():
                return self._add(Raised(*arguments), (Power, arguments))
            case Call(function, parts_of_call) if simpler := spelled_out(function, parts_of_call):
                return self.lower(simpler)
            case Call(function, _):
                return self._call(function, arguments)
            case Implicit(system, index, _):
                unknown = SolvedUnknown(system, index, arguments)
                return self._add(unknown, (SolvedUnknown, *unknown))
            case _:
                assert_never(node)

    def _add(self, entry: TableEntry, key: object) -> int:
        index = self._known.setdefault(key, len(self.entries))
        if index == len(self.entries):
            self.entries.append(entry)
        return index

    def _factors(self, index: int) -> EntryFactors:
        match self.entries[index]:
            case Leaf(Number(value)):
                return EntryFactors(value, (), ())
            case Scaled(coefficient, part):
                return self._factors(part)._replace(coefficient=coefficient)
            case Ratio(above, below):
                return EntryFactors(Fraction(1), above, below)
            case _:
                return EntryFactors(Fraction(1), (index,), ())

    def _product(self, factors: Iterable[EntryFactors]) -> int:
        """Return the index of a product's entry; plain factors on both sides of the line cancel."""
        coefficient, above, below = Fraction(1), list[int](), list[int]()
        for factor in factors:
            coefficient *= factor.coefficient
            above += factor.above
            below += factor.below
        if coefficient == 0 or not (above or below):
            return self._number(coefficient)
        for common in [f for f in above if self._is_plain(f)]:
            if common in below:
                above.remove(common)
                below.remove(common)
        if not (above or below):
            return self._number(coefficient)
        core = self._ratio(tuple(above), tuple(below))
        if coefficient == 1:
            return core
        return self._add(Scaled(coefficient, core), (Scaled, coefficient, core))

    def _is_plain(self, index: int) -> bool:
        """Return whether an entry is an input or its size, so that it may be cancelled."""
        entry = self.entries[index]
        if isinstance(entry, Apply) and entry.function == "abs":
            entry = self.entries[entry.arguments[0]]
        return isinstance(entry, Leaf)

    def _ratio(self, above: tuple[int, ...], below: tuple[int, ...]) -> int:
        if len(above) == 1 and not below:
            return above[0]
        return self._add(Ratio(above, below), (Ratio, tuple(sorted(above)), tuple(sorted(below))))

    def _number(self, value: Fraction) -> int:
        return self._add(Leaf(Number(value)), Number(value))

    def _power(self, base: int, exponent: Fraction) -> int:
        factors = self._factors(base)
        if factors.coefficient == 0:
            return self._add(Raised(base, self._number(exponent)), (Power, base, exponent))
        if exponent.denominator == 1:
            return self._product(self._raise(factors, int(exponent)))
        root = self._factors(self._call("sqrt", (base,)))
        whole = self._raise(factors, int(exponent))
        return self._product([*whole, root if exponent > 0 else root.inverse()])

    def _raise(self, factors: EntryFactors, exponent: int) -> list[EntryFactors]:
        """Raise a product to an integer by squaring; the squares are entries, computed once."""
        if exponent < 0:
            return self._raise(factors.inverse(), -exponent)
        if exponent < 4:
            return [factors] * exponent
        square = EntryFactors(
            factors.coefficient**2,
            tuple(self._ratio((f, f), ()) for f in factors.above),
            tuple(self._ratio((f, f), ()) for f in factors.below),
        )
        return self._raise(square, exponent // 2) + [factors] * (exponent % 2)

    def _call(self, function: str, arguments: tuple[int, ...]) -> int:
        if function == "cot" or (function == "tan" and arguments[0] in self.split):
            above, below = _QUOTIENTS[function]
            return self._ratio((self._call(above, arguments),), (self._call(below, arguments),))
        if function in _RECIPROCALS:
            return self._ratio((), (self._call(_RECIPROCALS[function], arguments),))
        return self._add(Apply(function, arguments), (Apply, function, arguments))


def tabulate(formulas: Iterable[Formula]) -> tuple[EntryTable, tuple[int, ...]]:
    """Return one table of all formulas, and each formula's entry in it."""
    listed, table = tuple(formulas), EntryTable()
    entries = tuple(table.lower(f) for f in listed)
    if not any(isinstance(e, Apply) and e.function == "tan" for e in table.entries):
        return table, entries
    table.split = _circular(table)
    table.lower.forget()
    return table, tuple(table.lower(f) for f in listed)


def _circular(table: EntryTable) -> frozenset[int]:
    """Return the arguments whose sine or cosine is in the table."""
    return frozenset(
        e.arguments[0]
        for e in table.entries
        if isinstance(e, Apply) and e.function in ("sin", "cos")
    )
