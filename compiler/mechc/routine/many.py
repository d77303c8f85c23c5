"""One program of many results, which have most of their steps in common."""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..formula.tree import Formula
from ..formula.walk import symbols
from ..frozen import replace
from .functions import Asked, Output, Read, computation, written
from .scope import Scope
from .steps import Function, Guard, Statement, Step, sides_of


class Program:
    """One program that computes many results: its steps, and what each result makes of them."""

    def __init__(self, group: Sequence[Asked], scope: Scope, names: Sequence[str]) -> None:
        self.steps, self.outputs, definitions = computation(group, scope, names)
        self._defined, self._results = dict(definitions), frozenset(scope.results)

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
