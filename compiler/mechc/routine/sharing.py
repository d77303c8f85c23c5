"""Steps from formulas: every part that is used twice is computed once, under a name.

Names are taken from what the step is (``sin_alpha``, ``cos_alpha_plus_beta``) as long
as that is short, and are numbered otherwise (``s1`` a sum, ``p1`` a product).
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import count
from typing import assert_never

from ..base.named import NamedTuple
from ..formula import derivative
from ..formula.evaluate import changes, side
from ..formula.sharing import each_part
from ..formula.tree import (
    Call,
    Constant,
    Formula,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
)
from ..formula.walk import symbols
from . import angle_offsets
from .common_factors import with_common_factors
from .steps import ByArcs, ProgramStatement, Solve, Solver, Step, leading_to, names_in
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
    tabulate,
)


class Shared(NamedTuple):
    """The steps in order, and the formulas rewritten in terms of them."""

    steps: tuple[ProgramStatement, ...]
    formulas: tuple[Formula, ...]


def share(
    definitions: Sequence[tuple[str, Formula]], results: Sequence[Formula], taken: Iterable[str]
) -> Shared:
    """Return definitions and shared parts as steps, and the results in terms of them.

    Definitions keep their names and their order; a shared part stands just before the
    first definition that uses it. ``taken`` are names no new step may have.

    >>> x, sin = Symbol("x"), Call("sin", (Symbol("x"),))
    >>> share([], [Sum((sin, Power(sin, Number(Fraction(2)))))], ["x"]).steps
    (Step(name='sin_x', formula=Call(function='sin', arguments=(Symbol(name='x'),))),)
    """
    definitions = _with_constants(definitions, results)
    table, roots = with_common_factors(
        *tabulate([*(formula for _, formula in definitions), *results])
    )
    names = [name for name, _ in definitions]
    writer = _SharingWriter(table, _used_twice(table, roots), {*taken, *names})
    writer.expect(zip(names, roots, strict=False))
    for name, root in zip(names, roots, strict=False):
        writer.define(name, root)
    formulas = tuple(writer.write(root) for root in roots[len(names) :])
    return Shared(tuple(writer.steps), formulas)


def _with_constants(
    definitions: Sequence[tuple[str, Formula]], results: Sequence[Formula]
) -> list[tuple[str, Formula]]:
    """Return definitions with those of the numbers that have names before them.

    Those that are in the equations of a system only are its solver's.
    """
    formulas = [*(formula for _, formula in definitions), *results]
    used = dict.fromkeys(p for p in each_part(formulas) if isinstance(p, Constant))
    names = {name for name, _ in definitions}
    return [*(named(c) for c in used if c.name not in names), *definitions]


def named(constant: Constant) -> tuple[str, Formula]:
    """Return a number that has a name as a definition."""
    return constant.name, constant.value


@lru_cache(maxsize=16)
def solver(system: System) -> Solver:
    """Return a system in straight lines, its equations and their slopes sharing parts."""
    used = used_outer(system)
    outer = tuple(system.anchor[i][0] for i in used)
    equations = angle_offsets.turned_alike(system.equations)
    rows = derivative.jacobian(equations, system.unknowns)
    entries = [entry for row in rows for entry in row]
    changed = _changes_of(outer, system)
    shares = {name: Symbol(change) for name, change in changed.items()}
    by_share = derivative.along(equations, shares)
    taken = [*system.unknowns, *outer, *changed.values()]
    shared, formulas = share([], [*equations, *entries, *by_share], taken)
    size = len(system.unknowns)
    own = size + size * size
    steps = [step for step in shared if isinstance(step, Step)]
    corrected = leading_to(names_in(formulas[:own]), steps)
    return Solver(
        unknowns=system.unknowns,
        outer=outer,
        equations=system.equations,
        start=system.start,
        anchor=tuple(system.anchor[i][1] for i in used),
        side=side(system),
        steps=corrected,
        residuals=formulas[:size],
        jacobian=tuple(formulas[size * i : size * (i + 1)] for i in range(1, size + 1)),
        by_arcs=ByArcs(
            tuple((outer.index(name), change) for name, change in changed.items()),
            tuple(step for step in steps if step not in corrected),
            formulas[own:],
        )
        if system.by_arcs
        else None,
        turning=tuple(name for name in outer if name in system.turning),
    )


def _changes_of(outer: Sequence[str], system: System) -> dict[str, str]:
    """Return the names for by how much outer symbols change, if arcs are followed."""
    moved = changes(system) if system.by_arcs else {}
    return {name: change for name, change in moved.items() if name in outer}


def used_outer(system: System) -> tuple[int, ...]:
    """Return the places of those outer symbols that the equations or the start mention."""
    used = frozenset(s for s in system.start if isinstance(s, str))
    used = used.union(*map(symbols, system.equations))
    return tuple(i for i, (name, _) in enumerate(system.anchor) if name in used)


def _used_twice(table: EntryTable, roots: Sequence[int]) -> frozenset[int]:
    """Return the entries that get a name: those that the roots reach by more than one way."""
    uses = Counter(roots)
    for index in range(len(table.entries) - 1, -1, -1):
        entry = table.entries[index]
        ways = min(uses[index], 1) if _is_work(entry, table) else uses[index]
        for part in parts(entry):
            uses[part] += ways
    constant = table.constants()
    return frozenset(
        index
        for index, number in uses.items()
        if number > 1 and index not in constant and _is_step(table.entries[index], table)
    )


def _is_step(entry: TableEntry, table: EntryTable) -> bool:
    """Return whether a shared entry is a step; an unknown has its name from the solution."""
    return _is_work(entry, table) and not isinstance(entry, SolvedUnknown)


def _is_work(entry: TableEntry, table: EntryTable) -> bool:
    """Return whether an entry gets a step: no symbol, minus sign or multiple of a symbol."""
    match entry:
        case Leaf() | Scaled(Fraction(numerator=-1, denominator=1), _):
            return False
        case Scaled(_, part):
            return not isinstance(table.entries[part], Leaf)
        case _:
            return True


LONGEST_LABEL = 24
"""Characters of a step's name beyond which it is numbered instead."""


Labels = Mapping[int, str]
"""The labels of entries, '' of those without one."""


def shortened(label: str) -> str:
    """Return a label, '' where it is too long."""
    return label if len(label) <= LONGEST_LABEL else ""


def words(entry: TableEntry, labels: Labels, entries: Sequence[TableEntry]) -> str:
    """Return an entry in words, '' where there are none for it."""
    match entry:
        case Leaf(Symbol(name)):
            return name
        case Leaf(Number(value)) if value.denominator == 1 and value >= 0:
            return str(value)
        case Apply(function, (argument,)) if labels[argument]:
            return f"{function}_{labels[argument]}"
        case Scaled(coefficient, part):
            return _scaled(coefficient, labels[part], is_pi=entries[part] == Leaf(Pi()))
        case Ratio((one, other), ()) if labels[one] and labels[other]:
            return f"{labels[one]}_{'squared' if one == other else labels[other]}"
        case EntryTerms(terms) if all(
            labels[t] and not isinstance(entries[t], Ratio) for t in terms
        ):
            return "_plus_".join(labels[t] for t in terms).replace("plus_minus", "minus")
        case _:
            return ""


def _scaled(coefficient: Fraction, label: str, *, is_pi: bool) -> str:
    """Return so many times what has a label; parts of π are degrees."""
    sign, size = "minus_" if coefficient < 0 else "", abs(coefficient)
    if is_pi:
        size, label = 180 * size, "deg"
    if not label or size.denominator != 1:
        return ""
    return f"{sign}{'' if size == 1 else size}{label}"


class _SharingWriter:
    """Turns entries back into formulas, naming the shared ones as it meets them."""

    def __init__(self, table: EntryTable, shared: frozenset[int], taken: set[str]) -> None:
        self.table = table
        self.shared = shared
        self.taken = taken
        self.steps: list[ProgramStatement] = []
        self._written: dict[int, Formula] = {}
        self._labels: dict[int, str] = {}
        self._names: dict[SolvedUnknown, str] = {}
        self._solved: dict[tuple[System, tuple[int, ...]], Solve] = {}

    def expect(self, definitions: Iterable[tuple[str, int]]) -> None:
        """Note which unknowns will be defined, so that solutions call them by these names."""
        for name, root in definitions:
            entry = self.table.entries[root]
            if isinstance(entry, SolvedUnknown):
                self._names.setdefault(entry, name)

    def write(self, root: int) -> Formula:
        """Return an entry's formula; the steps it needs are added on the way."""
        stack = [root]
        while stack:
            index = stack[-1]
            missing = [p for p in parts(self.table.entries[index]) if p not in self._written]
            stack.extend(reversed(missing))
            if not missing:
                stack.pop()
                self._finish(index)
        return self._written[root]

    def define(self, name: str, root: int) -> None:
        """Add the step of a definition; what equals it is called by its name from then on."""
        entry = self.table.entries[root]
        for part in parts(entry):
            self.write(part)
        formula = self._written[root] if root in self._written else self._formula(entry)
        if formula == Symbol(name):
            return
        self.steps.append(Step(name, formula))
        if not isinstance(entry, Leaf | SolvedUnknown):
            self._written.setdefault(root, Symbol(name))
            self._labels.setdefault(root, name)

    def _finish(self, index: int) -> None:
        if index in self._written:
            return
        entry = self.table.entries[index]
        formula, label = self._formula(entry), self._label(entry)
        if index in self.shared:
            label = self._name(entry, label)
            self.steps.append(Step(label, formula))
            formula = Symbol(label)
        self._written[index], self._labels[index] = formula, label

    def _formula(self, entry: TableEntry) -> Formula:
        """Return an entry as a formula in terms of those written before it."""
        match entry:
            case Leaf(formula):
                return formula
            case EntryTerms(terms):
                return Sum(tuple(self._written[t] for t in terms))
            case Scaled(coefficient, part):
                return _flat([Number(coefficient), self._written[part]])
            case Ratio(above, below):
                upper = [self._written[f] for f in above]
                return _flat([*upper, *(_inverse(self._written[f]) for f in below)])
            case Apply(function, arguments):
                return Call(function, tuple(self._written[a] for a in arguments))
            case Raised(base, exponent):
                return Power(self._written[base], self._written[exponent])
            case SolvedUnknown(system, which, arguments):
                return Symbol(self._solution(system, arguments).names[which])
            case _:
                assert_never(entry)

    def _solution(self, system: System, arguments: tuple[int, ...]) -> Solve:
        """Return the step that solves a system, added where it is first needed."""
        key = (system, arguments)
        if key not in self._solved:
            entries = [SolvedUnknown(system, i, arguments) for i in range(len(system.unknowns))]
            names = [self._names.get(e) or self._name(e, system.unknowns[e.which]) for e in entries]
            values = tuple(self._written[arguments[i]] for i in used_outer(system))
            self._solved[key] = Solve(tuple(names), values, solver(system))
            self.steps.append(self._solved[key])
        return self._solved[key]

    def _name(self, entry: TableEntry, label: str) -> str:
        if label in ("", *self.taken) or label[0].isdigit():
            letter = {EntryTerms: "s", Ratio: "p", Scaled: "p"}.get(type(entry), "t")
            label = next(n for i in count(1) if (n := f"{letter}{i}") not in self.taken)
        self.taken.add(label)
        return label

    def _label(self, entry: TableEntry) -> str:
        """Return the label of an entry; a solution has the name of its unknown."""
        if isinstance(entry, SolvedUnknown):
            return shortened(self._solution(entry.system, entry.arguments).names[entry.which])
        return shortened(words(entry, self._labels, self.table.entries))


def _inverse(formula: Formula) -> Formula:
    return Power(formula, Number(Fraction(-1)))


def _flat(factors: Iterable[Formula]) -> Formula:
    """Return a product of the factors; one that is a product itself joins in."""
    flat: list[Formula] = []
    for factor in factors:
        flat.extend(factor.factors if isinstance(factor, Product) else (factor,))
    return flat[0] if len(flat) == 1 else Product(tuple(flat))
