"""One program of many results, which have most of their steps in common."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..formula.tree import Formula
from ..formula.walk import symbols
from ..frozen import replace
from ..named import NamedTuple
from .functions import Asked, Read, steps_to, written
from .scope import Scope, rename
from .steps import Function, Guard, Statement, Step, sides_of


class Output(NamedTuple):
    """A result in the terms of a program of many."""

    asked: Asked
    formula: Formula
    guards: tuple[Guard, ...]
    value: Formula

    @property
    def ends(self) -> tuple[Formula, ...]:
        """Return the formulas computed from the steps: the value, and the sides of the guards."""
        return (self.value, *sides_of(self.guards))


class Program:
    """One program that computes many results: its steps, and what each result makes of them."""

    def __init__(self, group: Sequence[Asked], scope: Scope, names: Sequence[str]) -> None:
        known = scope.together({one.result.name: one.needed for one in group})
        called = [known.names[one.result.name] for one in group]
        formulas = [rename(one.result.formula, n) for one, n in zip(group, called, strict=True)]
        guards = [one.guards(n) for one, n in zip(group, called, strict=True)]
        compared = [g for gs in guards for g in gs]
        self.steps, values = steps_to(known.formulas, formulas, compared, names)
        self.outputs = tuple(map(Output, group, formulas, guards, values))
        self._defined, self._results = dict(known.formulas), frozenset(scope.results)

    @property
    def ends(self) -> Iterator[Formula]:
        """Yield all that the results make of the steps."""
        return (end for one in self.outputs for end in one.ends)

    def function(self, one: Output, steps: tuple[Statement, ...], work: int) -> Function:
        """Return the function of a result that takes so many operations of some of the steps."""
        names = _mentioned(one.formula, one.guards)
        where, others = _near(names, self._defined, self._results)
        read = Read(one.formula, where)
        made = written(one.asked, steps, one.value, one.guards, read, work)
        return replace(made, others=others)


def _mentioned(formula: Formula, guards: Iterable[Guard]) -> frozenset[str]:
    """Return the names in an output and in what the guards compare."""
    return symbols(formula).union(*map(symbols, sides_of(guards)))


def _near(
    names: Iterable[str], defined: Mapping[str, Formula], results: Set[str]
) -> tuple[tuple[Step, ...], tuple[str, ...]]:
    """Return the definitions that names rest on, up to other results, and these results."""
    where, others, left = dict[str, Step](), set[str](), list(names)
    while left:
        name = left.pop()
        if name in results:
            others.add(name)
        elif name in defined and name not in where:
            where[name] = Step(name, defined[name])
            left.extend(symbols(defined[name]))
    return tuple(where[n] for n in defined if n in where), tuple(sorted(others))
