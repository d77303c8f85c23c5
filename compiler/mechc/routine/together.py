"""Long functions of the same inputs that have most of their steps in common.

Written out each by itself, results that rest on one another (a chain of lets) would make
a file grow with the square of their number. So one function computes them all and hands
out their values, and each of them picks its own.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ..formula.tree import Formula
from ..formula.walk import symbols
from ..frozen import replace
from ..model.result import FrictionResult
from .functions import Asked, Read, operations, steps_to, written
from .scope import Scope, rename
from .steps import Common, Function, Guard, Step

MANY = 8
"""How many times over the same definitions are needed before they are computed together."""

Groups = dict[tuple[str, ...], list[Asked]]


def together(listed: Iterable[Asked], scope: Scope, names: Sequence[str]) -> dict[str, Function]:
    """Return by name those functions that are computed together."""
    groups: Groups = defaultdict(list)
    for one in listed:
        if not isinstance(one.result, FrictionResult):
            groups[tuple(i.name for i in one.inputs)].append(one)
    worth = [group for group in groups.values() if _repeats(group)]
    return {
        f.name: f
        for number, group in enumerate(worth, 1)
        for f in _sharing(number, group, scope, names)
    }


def _repeats(group: Sequence[Asked]) -> bool:
    """Return whether the same definitions are needed many times over."""
    needed = [{d.name for d in one.result.where} for one in group]
    return sum(map(len, needed)) > MANY * len(set[str]().union(*needed))


def _sharing(
    number: int, group: Sequence[Asked], scope: Scope, names: Sequence[str]
) -> Iterator[Function]:
    known = scope.together({one.result.name: one.needed for one in group})
    called = [known.names[one.result.name] for one in group]
    formulas = [rename(one.result.formula, n) for one, n in zip(group, called, strict=True)]
    guards = [one.guards(n) for one, n in zip(group, called, strict=True)]
    steps, outputs = steps_to(known.formulas, formulas, [g for gs in guards for g in gs], names)
    used = frozenset[str]().union(*map(_mentioned, outputs, guards))
    inputs = group[0].inputs
    handed = sorted(used - {i.name for i in inputs})
    common, work = Common(number, inputs, steps, tuple(handed)), operations(steps)
    defined, results = dict(known.formulas), frozenset(scope.results)
    for one, formula, gs, output in zip(group, formulas, guards, outputs, strict=True):
        where, others = _near(_mentioned(formula, gs), defined, results)
        written_out = written(one, steps, output, gs, Read(formula, where), work)
        yield replace(written_out, common=common, others=others)


def _mentioned(formula: Formula, guards: Iterable[Guard]) -> frozenset[str]:
    """Return the names in an output and in what the guards compare."""
    sides = (side for g in guards for side in (g.left, g.right))
    return symbols(formula).union(*map(symbols, sides))


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
