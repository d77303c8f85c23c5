"""From results to straight-line programs, one function per ``find`` and ``let``."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, assert_never

from ..formula.operations import count_operations
from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..model.mechanism import (
    Axial,
    Efficiency,
    Load,
    LoadForm,
    LoadRatio,
    Mechanism,
    Normal,
    Parameter,
    Reaction,
    Require,
    Speed,
    SpeedRatio,
    Target,
    Torque,
    WithFriction,
)
from ..model.result import FrictionResult, Result
from ..pose.pose import ClosedLoop
from ..study.analysis import as_printed
from ..units import FORCE, TORQUE
from .lengths import with_roots
from .loops import closing_guard, unseen_loops
from .scope import Definitions, Scope, rename
from .sharing import share
from .steps import (
    Function,
    Guard,
    Input,
    Pose,
    Routine,
    Solve,
    Statement,
    Step,
    formulas_of,
    names_of,
)
from .turning import in_unit_vectors


def program(
    mechanism: Mechanism,
    results: tuple[Result, ...],
    definitions: Mapping[str, Formula] | None = None,
    loops: Sequence[ClosedLoop] = (),
) -> Routine:
    """Return the routine that computes every result.

    Each function takes the parameters it depends on in declared order, then the loads
    it depends on, all in SI. A ``require`` guards those functions whose inputs decide
    it; one that needs more than a function is given is left to its caller. ``definitions``
    are those of the pose, on which conditions may rest that no result does; ``loops`` must
    close for a result to have a value, needed for it or not.
    Raises ``LookupError`` for a name that neither the mechanism nor a result explains.
    """
    scope, inputs = Scope(mechanism, results, definitions or {}), _inputs(mechanism)
    functions = tuple(_function(result, scope, inputs, loops) for result in results)
    pose = _pose(scope, inputs, loops)
    return Routine(mechanism.name, mechanism.title, mechanism.source, functions, pose)


def _function(
    result: Result, scope: Scope, inputs: Mapping[str, Input], loops: Sequence[ClosedLoop]
) -> Function:
    unseen = unseen_loops(result, scope, loops)
    needed = [result.formula, *(side for g in result.guards for side in (g.left, g.right))]
    needed += [loop.margin for loop in unseen]
    used = _known(result, scope.free(result.name, needed), inputs)
    requires = [r for r in scope.mechanism.requires if _decided(r, result.name, scope, used)]
    requires += result.guards
    sides = [side for r in requires for side in (r.left, r.right)]
    definitions = scope.definitions(result.name, [result.formula, *sides, *needed])
    formula = rename(result.formula, definitions.names)
    guards = (
        *(_guard(r, definitions) for r in requires),
        *(closing_guard(loop, definitions) for loop in unseen),
    )
    asked = {name for g in guards for side in (g.left, g.right) for name in symbols(side)}
    taken = {*inputs, *scope.results, *(name for name, _ in definitions.formulas)}
    carried, formulas = in_unit_vectors(definitions.formulas, [formula], asked, taken)
    steps, (output,) = share(carried, formulas, [*inputs, *scope.results])
    shown = scope.definitions(result.name, [result.formula, *sides]).formulas
    read = _read(result, formula, shown)
    return Function(
        name=result.name,
        title=title(result.target),
        inputs=used,
        guards=guards,
        steps=steps,
        output=output,
        formula=read.formula,
        where=read.where,
        dimension=result.dimension,
        operations=sum(map(count_operations, _computed(steps))) + count_operations(output),
        holds=read.holds,
        iterated=read.iterated,
    )


class _Read(NamedTuple):
    """A result for readers."""

    formula: Formula
    where: tuple[Step, ...]
    holds: tuple[Guard, ...] = ()
    iterated: tuple[str, ...] = ()


def _read(result: Result, formula: Formula, known: Iterable[tuple[str, Formula]]) -> _Read:
    """Return a result as people read it: a case where there is one, no system's coefficients."""
    if not isinstance(result, FrictionResult) or (result.case is None and not result.inside):
        return _Read(formula, tuple(Step(name, f) for name, f in known))
    printed = as_printed(result)
    used, where = set(symbols(printed.formula)), []
    named = {d.name for d in printed.where}
    for name, found in reversed([*(k for k in known if k[0] not in named), *printed.where]):
        if name in used - result.inside:
            where.append(Step(name, found))
            used |= symbols(found)
    holds = tuple(Guard(h.left, h.operator, h.right) for h in printed.holds)
    iterated = tuple(d.name for d in printed.where if d.name in used & result.inside)
    return _Read(printed.formula, tuple(where[::-1]), holds, iterated)


def _pose(scope: Scope, inputs: Mapping[str, Input], loops: Sequence[ClosedLoop]) -> Pose | None:
    found = scope.intermediates()
    needed = {name for name, _ in found.formulas}
    unseen = [loop for loop in loops if loop.names.isdisjoint(needed)]
    if unseen:
        found = scope.intermediates(n for loop in unseen for n in sorted(loop.names))
    if not found.names:
        return None
    names = {*inputs, *scope.results, *(name for name, _ in found.formulas)}
    rooted, _ = with_roots(found.formulas, [], names)
    steps, _ = share(rooted, [], [*inputs, *scope.results])
    used = frozenset[str]().union(*(symbols(f) for step in steps for f in formulas_of(step)))
    defined = {name for step in steps for name in names_of(step)}
    known = tuple(item for name, item in inputs.items() if name in used - defined)
    return Pose(known, steps, tuple(found.names))


def _computed(statements: Iterable[Statement]) -> Iterator[Formula]:
    """Yield every formula that is computed, those of a solver once."""
    for statement in statements:
        yield from formulas_of(statement)
        if isinstance(statement, Solve):
            solver = statement.solver
            yield from (step.formula for step in solver.steps)
            yield from solver.residuals
            yield from (entry for row in solver.jacobian for entry in row)


def title(target: Target | None) -> str:
    """Return what a result is, in words.

    >>> title(LoadRatio("P", "F"))
    'force ratio P/F'
    """
    match target:
        case None:
            return "formula of the description"
        case LoadRatio(above, below):
            return f"force ratio {above}/{below}"
        case LoadForm(load):
            return f"load {load} that balances the others"
        case SpeedRatio(above, below):
            return f"speed ratio {_speed(above)}/{_speed(below)}"
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


def _speed(speed: Speed) -> str:
    return f"V_{speed.of}" if speed.kind == "point" else f"omega_{speed.of}"


# -------------------------------------------------------------------------- inputs


def _inputs(mechanism: Mechanism) -> dict[str, Input]:
    """Return all that a function may take: free parameters, then loads, in declared order."""
    free = [_parameter(p) for p in mechanism.parameters if not p.dependent]
    loads = [_load(load) for load in mechanism.loads if load.tie is None]
    return {item.name: item for item in (*free, *loads)}


def _parameter(parameter: Parameter) -> Input:
    low, high = parameter.range or (None, None)
    return Input(
        parameter.name,
        parameter.dimension,
        parameter.unit,
        _constant(parameter.value),
        _constant(low),
        _constant(high),
        parameter.label,
        _constant(parameter.tolerance),
    )


def _load(load: Load) -> Input:
    if isinstance(load, Torque):
        return Input(load.name, TORQUE, "N*m")
    return Input(load.name, FORCE, "N")


def _constant(formula: Formula | None) -> float | None:
    return None if formula is None else evaluate(formula, {})


def _known(result: Result, used: frozenset[str], inputs: Mapping[str, Input]) -> tuple[Input, ...]:
    strangers = sorted(used - inputs.keys())
    if strangers:
        raise LookupError(f"nothing explains {', '.join(strangers)} in result {result.name}")
    return tuple(item for name, item in inputs.items() if name in used)


# -------------------------------------------------------------------------- guards


def _decided(require: Require, owner: str, scope: Scope, used: tuple[Input, ...]) -> bool:
    """Return whether a function's inputs decide a condition."""
    return scope.free(owner, [require.left, require.right]) <= {i.name for i in used}


def _guard(require: Require, definitions: Definitions) -> Guard:
    left, right = (rename(side, definitions.names) for side in (require.left, require.right))
    return Guard(left, require.operator, right)
