"""The order of sums in which each gives one force more, as few as lead to a load.

Taken is the shortest sum with one unknown force; where none has, the fewest sums that
give as many forces together. What the load does not rest on is left out again.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ..algebra.matrices import determinant, numeric_rank, with_column
from ..algebra.product import ZERO
from ..algebra.sums import add
from ..base.frozen import frozen
from ..formula.operations import count_operations
from ..formula.walk import symbols
from ..work import spend
from .equilibrium import EquilibriumStep, EquilibriumSum, FoundForce

MOST_SUMS_TOGETHER = 3
"""More sums than this nobody solves together by hand."""

ROUNDED_PART = 1e-9
"""A part of a sum that is smaller, relative to the others, is rounding of 0."""

ForceNames = frozenset[str]


@frozen
class CandidateSum:
    """A sum that may be taken: its unknown forces, what each counts at one pose, how long it is.

    The arms make a sum of moments longer by two.
    """

    balance: EquilibriumSum
    unknown: ForceNames
    numbers: Mapping[str, float]
    length: int


def candidates(
    sums: Iterable[EquilibriumSum],
    known: ForceNames,
    values: Mapping[str, float],
    made_up: ForceNames,
) -> list[CandidateSum]:
    """Return the sums that can be taken, the shortest first.

    Left out are those that rest on ``made_up`` lengths, which nothing may rest on.
    """
    found = (_candidate(s, known, values, made_up) for s in sums if s.terms)
    return sorted((c for c in found if c), key=lambda c: c.length)


def _candidate(
    balance: EquilibriumSum, known: ForceNames, values: Mapping[str, float], made_up: ForceNames
) -> CandidateSum | None:
    """Return a sum with its unknown forces, coefficients and length; None on a made-up length.

    Coefficients count from the largest, and rounding among them is left out.
    """
    formulas = [part.formula() for part in balance.terms.values()]
    if any(symbols(formula) & made_up for formula in formulas):
        return None
    try:
        numbers = {name: part.evaluate(values) for name, part in balance.terms.items()}
    except (KeyError, ZeroDivisionError):
        numbers = dict.fromkeys(balance.terms, 1.0)
    most = max(map(abs, numbers.values()))
    numbers = {name: n / most for name, n in numbers.items() if abs(n) > ROUNDED_PART * most}
    length = sum(map(count_operations, formulas)) + 2 * len(formulas) + 2 * bool(balance.centre)
    return CandidateSum(balance, frozenset(balance.terms) - known, numbers, length)


def steps_to(
    load: str, sums: Sequence[CandidateSum], avoided: ForceNames
) -> tuple[EquilibriumStep, ...]:
    """Return the steps that lead to a load, () where none do.

    Forces that are ``avoided`` are found where nothing else can be.
    """
    steps: list[EquilibriumStep] = []
    found: ForceNames = frozenset()
    while load not in found:
        taken = _single(load, sums, found, avoided) or _simultaneous_sums(sums, found)
        if not taken:
            return ()
        names = sorted(frozenset().union(*(c.unknown for c in taken)) - found)
        steps.append(EquilibriumStep(tuple(c.balance for c in taken), tuple(_solved(taken, names))))
        found |= {*names}
    return tuple(_needed(_without_zeros(steps), load))


def _single(
    load: str, sums: Sequence[CandidateSum], found: ForceNames, avoided: ForceNames
) -> list[CandidateSum]:
    """Return the shortest sum that gives one force, the load before any other."""
    fit = [c for c in sums if len(left := c.unknown - found) == 1 and left <= c.numbers.keys()]
    wanted = [c for c in fit if not c.unknown - found <= avoided]
    return ([c for c in fit if load in c.unknown] or wanted or fit)[:1]


def _simultaneous_sums(sums: Sequence[CandidateSum], found: ForceNames) -> list[CandidateSum]:
    """Return the fewest sums that give as many forces, the shortest of those."""
    for size in range(2, MOST_SUMS_TOGETHER + 1):
        few = [c for c in sums if 1 < len(c.unknown - found) <= size]
        groups = _groups([c.unknown - found for c in few], size)
        fit = [taken for names in groups if (taken := _independent(few, names, found))]
        if fit:
            return min(fit, key=lambda taken: sum(c.length for c in taken))
    return []


def _groups(sets: Iterable[ForceNames], size: int) -> set[ForceNames]:
    """Return the sets of so many names that some of the given ones make up."""
    base = set(sets)
    whole = set(base)
    for _ in range(size - 1):
        spend(len(whole) * len(base))
        whole |= {a | b for a in whole for b in base if a & b and len(a | b) <= size}
    return {names for names in whole if len(names) == size}


def _independent(
    sums: Iterable[CandidateSum], names: ForceNames, found: ForceNames
) -> list[CandidateSum]:
    """Return as many independent sums in the names as there are names, [] where there are less."""
    columns = {name: i for i, name in enumerate(sorted(names))}
    taken: list[CandidateSum] = []
    rows: list[dict[int, float]] = []
    for c in sums:
        if c.unknown - found <= names:
            row = {columns[n]: c.numbers[n] for n in names & c.numbers.keys()}
            if numeric_rank([*rows, row], scaled=False) > len(rows):
                taken.append(c)
                rows.append(row)
    return taken if len(taken) == len(names) else []


def _solved(taken: Sequence[CandidateSum], names: Sequence[str]) -> Iterator[FoundForce]:
    """Yield each force in what is known, by Cramer's rule."""
    forms = [c.balance.terms for c in taken]
    matrix = [[form.get(name, ZERO) for name in names] for form in forms]
    whole = determinant(matrix)
    known = dict.fromkeys(name for form in forms for name in form if name not in names)
    for column, name in enumerate(names):
        parts = {
            other: -determinant(with_column(matrix, column, [f.get(other, ZERO) for f in forms]))
            for other in known
        }
        terms = {other: add([part / whole]) for other, part in parts.items() if part}
        yield FoundForce(name, {other: part for other, part in terms.items() if part})


def _without_zeros(steps: Iterable[EquilibriumStep]) -> Iterator[EquilibriumStep]:
    """Yield steps in which nothing is found from a force that is zero."""
    zeros: set[str] = set()
    for step in steps:
        parts = [{n: t for n, t in f.terms.items() if n not in zeros} for f in step.found]
        zeros |= {f.name for f, terms in zip(step.found, parts, strict=True) if not terms}
        found = (FoundForce(f.name, terms) for f, terms in zip(step.found, parts, strict=True))
        yield EquilibriumStep(step.balances, tuple(found))


def _needed(steps: Iterable[EquilibriumStep], load: str) -> list[EquilibriumStep]:
    """Return the steps that a load rests on, with those forces that its sums mention."""
    needed, kept = {load}, []
    for balances, found in reversed(list(steps)):
        there = tuple(f for f in found if f.name in needed)
        if there:
            kept.append(EquilibriumStep(balances, there))
            needed |= {name for balance in balances for name in balance.terms}
    return kept[::-1]
