"""Long functions that have most of their steps in common.

Written out each by itself, results that rest on one another (a chain of lets) would make
a file grow with the square of their number. So one function computes all of those that take the
same inputs and hands out their values, and each of them picks its own.

User-defined formulas that each add a parameter share no arguments, so that no one function can
compute them all. One program is made of all of these, and every so many steps of it become a
function that calls the one before: each result takes the last of these that it rests on and adds
its own steps.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from functools import reduce
from operator import or_
from typing import TypeVar

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.result import FrictionResult
from .functions import AskedResult, ProgramOutput, Read, computation, function_of, operations
from .scope import ProgramScope
from .steps import (
    Common,
    Function,
    Guard,
    ProgramStatement,
    Step,
    formulas_of,
    mentioned,
    names_in,
    names_of,
    sides_of,
)

FEWEST_USES = 8
"""How many times over the same definitions are needed before they are computed together."""

Groups = dict[tuple[str, ...], list[AskedResult]]


def with_common_steps(
    listed: Iterable[AskedResult], scope: ProgramScope, names: Sequence[str]
) -> dict[str, Function]:
    """Return by name the functions of those results that need the same definitions many times."""
    groups, left = Groups(), list[AskedResult]()
    for one in listed:
        if not isinstance(one.result, FrictionResult):
            groups.setdefault(tuple(i.name for i in one.inputs), []).append(one)
    made = dict[str, Function]()
    number = 0
    for group in groups.values():
        if not _repeats(group):
            left += group
            continue
        number += 1
        made.update((f.name, f) for f in _sharing(number, group, scope, names))
    if _repeats(left):
        chain = chained(GroupProgram(left, scope, names), number + 1)
        made.update((f.name, f) for f in chain)
    return made


def _repeats(group: Sequence[AskedResult]) -> bool:
    """Return whether the same definitions are needed many times over."""
    needed = [{d.name for d in one.result.where} for one in group]
    return sum(map(len, needed)) > FEWEST_USES * len(set[str]().union(*needed))


def _sharing(
    number: int, group: Sequence[AskedResult], scope: ProgramScope, names: Sequence[str]
) -> Iterator[Function]:
    program = GroupProgram(group, scope, names)
    used = names_in(list(program.ends))
    inputs = group[0].inputs
    handed = sorted(used - {i.name for i in inputs})
    common, work = Common(number, inputs, program.steps, tuple(handed)), operations(program.steps)
    for one in program.outputs:
        yield replace(program.function(one, program.steps, work), common=common)


class GroupProgram:
    """One program that computes many results: its steps, and what each result makes of them."""

    def __init__(
        self, group: Sequence[AskedResult], scope: ProgramScope, names: Sequence[str]
    ) -> None:
        self.steps, self.outputs, definitions = computation(group, scope, names)
        self._defined, self._results = dict(definitions), frozenset(scope.results)

    @property
    def ends(self) -> Iterator[Formula]:
        """Yield all that the results make of the steps."""
        return (end for one in self.outputs for end in one.ends)

    def function(
        self, one: ProgramOutput, steps: tuple[ProgramStatement, ...], work: int
    ) -> Function:
        """Return the function of a result that takes so many operations of some of the steps."""
        names = _mentioned(one.formula, one.guards)
        where, others = _near(names, self._defined, self._results)
        read = Read(one.formula, where)
        made = function_of(one.asked, steps, one.value, one.guards, read, work)
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


T = TypeVar("T")

STRETCH = 16
"""How many steps a function adds at most to those that it takes."""


class Stop(NamedTuple):
    """A stop where values are handed on: the result there, what it needs, its own steps."""

    at: ProgramOutput
    needs: int
    steps: tuple[ProgramStatement, ...]
    before: int | None


class FromStop(NamedTuple):
    """How a result is computed: from which stop on, by which steps of its own, of all it needs."""

    output: ProgramOutput
    needs: int
    start: int | None
    steps: tuple[ProgramStatement, ...]


def chained(program: GroupProgram, first: int) -> Iterator[Function]:
    """Yield the functions that take what others compute; the latter get numbers from first on.

    A result that needs an input which its formula does not show has none here.
    """
    needs = Needs(program)
    stops, ways = _ways(program, needs)
    commons = _commons(stops, ways, needs, first)
    work = [operations((statement,)) for statement in program.steps]
    for way in ways:
        own = needs.steps(way.needs)
        made = program.function(way.output, own, sum(needs.chosen(way.needs, work)))
        common = commons[way.start] if way.start is not None else None
        yield replace(made, common=common, own=way.steps) if common else made


class Needs:
    """The needs of formulas in a program, as numbers with a bit for each step and each input."""

    def __init__(self, program: GroupProgram) -> None:
        self._all = program.steps
        self._bits = {n: 1 << i for i, s in enumerate(program.steps) for n in names_of(s)}
        inputs = dict.fromkeys(i.name for one in program.outputs for i in one.asked.inputs)
        self._reached = {n: 1 << i for i, n in enumerate(inputs, len(program.steps))}
        for statement in program.steps:
            reached = self.of(formulas_of(statement))
            self._reached |= {n: reached | self._bits[n] for n in names_of(statement)}

    def of(self, formulas: Sequence[Formula]) -> int:
        """Return all that formulas need."""
        return self.named(names_in(formulas))

    def named(self, names: Iterable[str]) -> int:
        """Return all that these names need, themselves included."""
        return reduce(or_, (self._reached[name] for name in names), 0)

    def steps(self, needs: int) -> tuple[ProgramStatement, ...]:
        """Return the steps among what is needed."""
        return tuple(self.chosen(needs, self._all))

    def chosen(self, needs: int, values: Sequence[T]) -> Iterator[T]:
        """Yield those of the values, one for each step, whose step is needed."""
        return (value for i, value in enumerate(values) if needs >> i & 1)

    def inputs(self, needs: int) -> int:
        """Return the inputs among what is needed."""
        return needs >> len(self._all)


def _ways(program: GroupProgram, needs: Needs) -> tuple[list[Stop], list[FromStop]]:
    """Return where results hand on what they compute, and how each is computed.

    What another one rests on needs less than that, and comes first.
    """
    stops, ways = list[Stop](), list[FromStop]()
    found = ((needs.of(one.ends), one) for one in program.outputs)
    for needed, one in sorted(found, key=lambda pair: pair[0].bit_count()):
        if needs.inputs(needed & ~needs.named(i.name for i in one.asked.inputs)):
            continue
        start = _last(stops, needed)
        steps = needs.steps(needed & ~(stops[start].needs if start is not None else 0))
        if len(steps) > STRETCH:
            stops.append(Stop(one, needed, steps, start))
            start, steps = len(stops) - 1, ()
        ways.append(FromStop(one, needed, start, steps))
    return stops, ways


def _last(stops: Sequence[Stop], needed: int) -> int | None:
    """Return the last stop that computes nothing but what is needed."""
    fitting = (i for i in reversed(range(len(stops))) if not stops[i].needs & ~needed)
    return next(fitting, None)


def _commons(
    stops: Sequence[Stop], ways: Iterable[FromStop], needs: Needs, first: int
) -> list[Common]:
    """Return the computation of each stop, which hands on the names that are mentioned beyond."""
    made = list[Common]()
    for stop, beyond in zip(stops, _mentioned_beyond(stops, ways), strict=True):
        known = {name for step in needs.steps(stop.needs) for name in names_of(step)}
        before = made[stop.before] if stop.before is not None else None
        outputs = tuple(sorted(beyond & known))
        made.append(Common(first + len(made), stop.at.asked.inputs, stop.steps, outputs, before))
    return made


def _mentioned_beyond(stops: Sequence[Stop], ways: Iterable[FromStop]) -> list[set[str]]:
    """Return the names that each stop is asked for: by ways from it, and by stops that rest on it.

    A stop comes after those that it rests on, so that the last one is asked by ways only.
    """
    beyond = [set[str]() for _ in stops]
    for way in ways:
        if way.start is not None:
            beyond[way.start] |= mentioned(way.steps, way.output.ends)
    for stop, names in zip(reversed(stops), reversed(beyond), strict=True):
        if stop.before is not None:
            beyond[stop.before] |= names | mentioned(stop.steps, ())
    return beyond
