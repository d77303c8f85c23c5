"""The function of a result: what it takes, its steps, and what a reader sees of it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from typing import assert_never

from ..base.frozen import replace
from ..base.named import NamedTuple
from ..formula.operations import count_operations
from ..formula.sharing import OneOfEach
from ..formula.tree import ZERO, Formula
from ..formula.walk import constants, symbols
from ..model.mechanism import (
    Axial,
    Efficiency,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    Require,
    ResultTarget,
    SpeedRatio,
    WithFriction,
)
from ..model.result import FrictionResult, Result
from ..pose.pose import ClosedLoop
from .scope import ProgramScope, rename
from .sharing import Shared, named, share
from .sign_powers import in_choices
from .steps import (
    Checks,
    Function,
    Guard,
    Input,
    ProgramStatement,
    Solve,
    Step,
    formulas_of,
    leading_to,
    names_in,
    sides_of,
)
from .unit_vectors import in_unit_vectors


class AskedResult(NamedTuple):
    """A result with the inputs that it depends on, and the conditions that they decide."""

    result: Result
    inputs: tuple[Input, ...]
    requires: tuple[Require, ...]
    unseen: tuple[ClosedLoop, ...]

    @property
    def read(self) -> list[Formula]:
        """Return the formulas that a reader sees."""
        sides = [side for r in self.requires for side in (r.left, r.right)]
        return [self.result.formula, *sides]

    @property
    def needed(self) -> list[Formula]:
        """Return all formulas that are computed."""
        return [*self.read, *(loop.margin for loop in self.unseen)]

    def guards(self, names: Mapping[str, str]) -> tuple[Guard, ...]:
        """Return the conditions with the names that definitions have."""
        own = self.result.guards
        requires = (_guard(r, names, self.result if r in own else None) for r in self.requires)
        return (*requires, *(closing_guard(loop, names) for loop in self.unseen))


def asked(
    result: Result, scope: ProgramScope, inputs: Mapping[str, Input], loops: Sequence[ClosedLoop]
) -> AskedResult:
    """Return the inputs, conditions and loops of a function for a result.

    Raises ``LookupError`` for a name that nothing explains.
    """
    unseen = tuple(unseen_loops(result, scope, loops))
    alone = AskedResult(result, (), result.guards, unseen)
    used = _known(result, scope.free(result.name, alone.needed), inputs)
    rested = {name for name, _ in scope.definitions(result.name, alone.needed).formulas}
    decided = [
        r
        for r in scope.mechanism.requires
        if r.concerns({result.name, *rested}) and _decided(r, result.name, scope, used)
    ]
    return AskedResult(result, used, (*decided, *result.guards), unseen)


def _known(result: Result, used: frozenset[str], inputs: Mapping[str, Input]) -> tuple[Input, ...]:
    strangers = sorted(used - inputs.keys())
    if strangers:
        raise LookupError(f"nothing explains {', '.join(strangers)} in result {result.name}")
    return tuple(item for name, item in inputs.items() if name in used)


def _decided(require: Require, owner: str, scope: ProgramScope, used: tuple[Input, ...]) -> bool:
    """Return whether a function's inputs decide a condition.

    One that rests on none of any kind holds: the description was checked.
    """
    free = scope.free(owner, [require.left, require.right])
    return bool(free) and free <= {i.name for i in used}


def _guard(require: Require, names: Mapping[str, str], owner: Result | None) -> Guard:
    """Return a condition, of the description or without which a result has no value."""
    left, right = (rename(side, names) for side in (require.left, require.right))
    if owner is None:
        return Guard(left, require.operator, right)
    is_direction = require.subject is not None and require.subject.kind == "force"
    return Guard(left, require.operator, right, balance=owner.name, direction=is_direction)


class ProgramOutput(NamedTuple):
    """A result in the terms of steps that compute several."""

    asked: AskedResult
    formula: Formula
    guards: tuple[Guard, ...]
    value: Formula

    @property
    def ends(self) -> tuple[Formula, ...]:
        """Return the formulas computed from the steps: the value, and the sides of the guards."""
        return (self.value, *sides_of(self.guards))


class Computation(NamedTuple):
    """The steps that compute several results, what each makes of them, and their definitions."""

    steps: tuple[ProgramStatement, ...]
    outputs: tuple[ProgramOutput, ...]
    definitions: tuple[tuple[str, Formula], ...]


def computation(
    group: Sequence[AskedResult], scope: ProgramScope, names: Iterable[str]
) -> Computation:
    """Return the steps of several results: what these rest on is worked out once for all."""
    known = scope.shared_definitions({one.result.name: one.needed for one in group})
    called = [known.names[one.result.name] for one in group]
    formulas = [rename(one.result.formula, n) for one, n in zip(group, called, strict=True)]
    guards = [one.guards(n) for one, n in zip(group, called, strict=True)]
    ends = [[f, *_sides_of_balances(gs)] for f, gs in zip(formulas, guards, strict=True)]
    others = [guard for gs in guards for guard in gs if not guard.balance]
    steps, values = steps_to(known.formulas, [e for each in ends for e in each], others, names)
    left, outputs = iter(values), list[ProgramOutput]()
    for one, formula, gs, each in zip(group, formulas, guards, ends, strict=True):
        value, *sides = islice(left, len(each))
        outputs.append(ProgramOutput(one, formula, _with_sides(gs, sides), value))
    return Computation(steps, tuple(outputs), known.formulas)


def functions(
    group: Sequence[AskedResult], scope: ProgramScope, names: Iterable[str]
) -> Iterator[Function]:
    """Yield functions that compute all that they need themselves, their steps found together."""
    steps, outputs, _ = computation(group, scope, names)
    return (_by_itself(output, scope, steps) for output in outputs)


def _by_itself(
    output: ProgramOutput, scope: ProgramScope, known: Sequence[ProgramStatement]
) -> Function:
    """Return the function of an output by those of the known steps that it needs."""
    asked, formula, guards, value = output
    steps = leading_to(names_in(output.ends), known)
    shown = scope.definitions(asked.result.name, asked.read).formulas
    read = _readable(asked.result, formula, shown, scope.inside)
    return function_of(asked, steps, value, guards, read, operations(steps))


def _sides_of_balances(guards: Iterable[Guard]) -> Iterator[Formula]:
    """Yield the sides of conditions that nobody reads."""
    return sides_of(guard for guard in guards if guard.balance)


def _with_sides(guards: Iterable[Guard], sides: Iterable[Formula]) -> tuple[Guard, ...]:
    """Return guards, those that nobody reads with other sides, two for each."""
    left = iter(sides)
    return tuple(
        replace(guard, left=next(left), right=next(left)) if guard.balance else guard
        for guard in guards
    )


def checks(scope: ProgramScope, inputs: Mapping[str, Input], names: Iterable[str]) -> Checks | None:
    """Return the conditions of a description as a program; None where it has none."""
    requires = scope.mechanism.requires
    sides = [side for require in requires for side in (require.left, require.right)]
    definitions = scope.definitions("", sides)
    guards = tuple(_guard(require, definitions.names, None) for require in requires)
    steps, _ = steps_to(definitions.formulas, [], guards, names)
    used = scope.free("", sides)
    taken = tuple(item for name, item in inputs.items() if name in used)
    return Checks(taken, steps, guards) if guards else None


def steps_to(
    definitions: Sequence[tuple[str, Formula]],
    formulas: Sequence[Formula],
    guards: Iterable[Guard],
    names: Iterable[str],
) -> Shared:
    """Return the steps to formulas, and those in their terms; names of guards are kept."""
    sides = list(sides_of(guards))
    asked, definitions = names_in(sides), [*map(named, constants(sides)), *definitions]
    taken = {*names, *(name for name, _ in definitions)}
    alike = OneOfEach()
    definitions = [(name, in_choices(alike.of(formula))) for name, formula in definitions]
    formulas = [in_choices(alike.of(formula)) for formula in formulas]
    return share(*in_unit_vectors(definitions, formulas, asked, taken), names)


def function_of(
    asked: AskedResult,
    steps: tuple[ProgramStatement, ...],
    output: Formula,
    guards: tuple[Guard, ...],
    read: "Read",
    work: int,
) -> Function:
    """Return the function of a result; ``work`` is the number of operations in its steps."""
    result = asked.result
    return Function(
        name=result.name,
        title=title(result.target, result.label),
        inputs=asked.inputs,
        guards=guards,
        steps=steps,
        output=output,
        formula=read.formula,
        where=read.where,
        dimension=result.dimension,
        operations=work + count_operations(output),
        holds=read.holds,
        iterated=read.iterated,
    )


def operations(statements: Iterable[ProgramStatement]) -> int:
    """Return how many operations statements are, one correction of each solver."""
    return sum(map(count_operations, _computed(statements)))


def _computed(statements: Iterable[ProgramStatement]) -> Iterator[Formula]:
    """Yield every formula that is computed, those of a solver once."""
    for statement in statements:
        yield from formulas_of(statement)
        if isinstance(statement, Solve):
            yield from statement.solver.computed


class Read(NamedTuple):
    """A result for readers."""

    formula: Formula
    where: tuple[Step, ...]
    holds: tuple[Guard, ...] = ()
    iterated: tuple[str, ...] = ()


def _readable(
    result: Result,
    formula: Formula,
    known: Sequence[tuple[str, Formula]],
    inside: frozenset[str],
) -> Read:
    """Return a result as people read it: a case where there is one.

    What systems of any result have ``inside``, their coefficients, is left out.
    """
    if not isinstance(result, FrictionResult) or (result.case is None and not result.inside):
        where, iterated = _without(inside, formula, known)
        return Read(formula, _with_literals(formula, where), (), iterated)
    shown = result if result.case is None else result.case
    named = {d.name for d in shown.where}
    everything = [*(k for k in known if k[0] not in named), *shown.where]
    where, iterated = _without(result.inside, shown.formula, everything)
    signs = () if result.case is None else result.case.holds
    holds = tuple(Guard(h.left, h.operator, h.right) for h in signs)
    return Read(shown.formula, _with_literals(shown.formula, where), holds, iterated)


def _without(
    inside: frozenset[str], formula: Formula, known: Sequence[tuple[str, Formula]]
) -> tuple[list[Step], tuple[str, ...]]:
    """Return the definitions that a formula rests on, and its names inside systems."""
    used, where = set(symbols(formula)), list[Step]()
    for name, found in reversed(known):
        if name in used - inside:
            where.append(Step(name, found))
            used |= symbols(found)
    return where[::-1], tuple(name for name, _ in known if name in used & inside)


def _with_literals(formula: Formula, where: Sequence[Step]) -> tuple[Step, ...]:
    """Return the definitions behind a formula, named numbers first."""
    known = constants([formula, *(step.formula for step in where)])
    return (*(Step(*named(constant)) for constant in known), *where)


def title(target: ResultTarget | None, label: str = "") -> str:
    """Return the title of a result, with the user's text for a formula.

    >>> title(LoadRatio("P", "F"))
    'force ratio P/F'
    >>> title(None, "pressure")
    'formula "pressure" of the description'
    """
    match target:
        case None:
            return (
                f'formula "{label}" of the description' if label else "formula of the description"
            )
        case LoadRatio(above, below):
            return f"force ratio {above}/{below}"
        case LoadForm(load):
            return f"load {load} that balances the others"
        case SpeedRatio(above, below):
            return f"speed ratio {above.name}/{below.name}"
        case Reaction(point, link, part):
            on = f"link {link} by its neighbours" if link else "the mechanism by the ground"
            return f"{PARTS[part]} force at {point} on {on}"
        case Axial(_, tail, head):
            return f"force along {tail}{head}, tension positive"
        case Normal(point):
            return f"normal force on {point}"
        case WithFriction(of, sense, order):
            about = " to first order" if order == "first" else ""
            return f"{title(of)} with friction{about}, {sense}"
        case Efficiency(of, sense):
            return f"efficiency of {title(of)}, {sense}"
        case _:
            assert_never(target)


PARTS = {"x": "x component of the", "y": "y component of the", "size": "size of the"} | {
    "direction": "direction of the"
}
"""The parts of a reaction in words."""


def unseen_loops(
    result: Result, scope: ProgramScope, loops: Sequence[ClosedLoop]
) -> list[ClosedLoop]:
    """Return the loops whose failure to close a result would not show, those needed last first.

    A loop that rests on another one shows the other's failure as well. One of fixed lengths
    alone closes once and for all.
    """
    if not loops:
        return []
    found: list[ClosedLoop] = []
    formulas = [result.formula, *(side for g in result.guards for side in (g.left, g.right))]
    known = _defined(result, formulas, scope)
    if result.target is None and not _rests_on_a_pose(known, scope, loops):
        return []
    for loop in reversed([loop for loop in loops if _concerns(loop, {result.name, *known})]):
        if loop.names.isdisjoint(known) and scope.free(result.name, [loop.margin]):
            found.append(loop)
            known |= _defined(result, [loop.margin], scope)
    return found


def _defined(result: Result, formulas: Sequence[Formula], scope: ProgramScope) -> set[str]:
    return {name for name, _ in scope.definitions(result.name, formulas).formulas}


def _concerns(loop: ClosedLoop, names: set[str]) -> bool:
    """Whether a loop is the mechanism's own, or one of a used mechanism that has the names."""
    return not loop.of or any(name.startswith(f"{loop.of}_") for name in names)


def _rests_on_a_pose(known: set[str], scope: ProgramScope, loops: Sequence[ClosedLoop]) -> bool:
    """Return whether a formula of the user's own uses what a loop or virtual power gives."""
    finds = {name for name, result in scope.results.items() if result.target is not None}
    return not known.isdisjoint(finds.union(*(loop.names for loop in loops)))


def closing_guard(loop: ClosedLoop, names: Mapping[str, str]) -> Guard:
    """Return the condition that a loop closes, with the names that definitions have."""
    return Guard(rename(loop.margin, names), ">=", ZERO, loop.loop)
