"""The interpreter: a routine's steps on floats or NumPy arrays.

It is the oracle: every target's code must give what it gives. It computes in the
order that :mod:`.quotient` fixes and has no tricks of its own.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache, partial, reduce
from typing import TypeAlias, assert_never

import numpy as np
from numpy.typing import NDArray

from ..formula.choices import SIGNS, equal_within, is_sense, spelled_out
from ..formula.tree import (
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
)
from ..formula.walk import walk
from ..model.result import DrivingLoad
from .arcs import Array
from .newton import SolverEquations, follow
from .quotient import quotient_of
from .statuses import MOVES, NO_POSE, NOT_FOUND
from .steps import (
    NO_LOAD,
    Function,
    Guard,
    PoseProgram,
    ProgramStatement,
    ResultStatus,
    Solve,
    Solver,
    formulas_of,
)

Value: TypeAlias = float | Array
OnArrays = Callable[..., Value]
"""A function of values that broadcast together, in the order of its inputs."""

_quotient_of = lru_cache(maxsize=4096)(quotient_of)
"""Products that are computed again and again, as iteration does, are taken apart once."""


def _condition(name: str, left: Array, right: Array) -> Array:
    """Return 1 where a condition holds, 0 where it does not, NaN where a side is NaN."""
    holds = _HOLDS[SIGNS[name]](left, right)
    return np.where(np.isnan(left) | np.isnan(right), np.nan, holds)


FUNCTIONS: Mapping[str, Callable[..., Array]] = {
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "cot": lambda x: np.cos(x) / np.sin(x),
    "sec": lambda x: 1.0 / np.cos(x),
    "csc": lambda x: 1.0 / np.sin(x),
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
    "sqrt": np.sqrt,
    "hypot": lambda *xs: reduce(np.hypot, xs),
    "abs": np.abs,
    "sign": np.sign,
    "min": lambda *xs: reduce(np.minimum, xs),
    "max": lambda *xs: reduce(np.maximum, xs),
    "exp": np.exp,
    "log": np.log,
    **{name: partial(_condition, name) for name in SIGNS},
    "choose": lambda c, x, y=np.nan: np.where(c > 0, x, np.where(c <= 0, y, np.nan)),
}
"""Every function of the language on arrays."""

_HOLDS: Mapping[str, Callable[[Array, Array], NDArray[np.bool_]]] = {
    "<": np.less,
    "<=": np.less_equal,
    ">": np.greater,
    ">=": np.greater_equal,
    "=": np.equal,
    "!=": np.not_equal,
}


def evaluate(function: Function, values: Mapping[str, Value]) -> Value:
    """Return a function's output at values of its inputs, which broadcast as NumPy's do.

    Values are SI and radians; names beyond the inputs are ignored. The output is a
    float when all inputs are scalars. It is NaN where a guard fails or a step is not
    defined, and the result has no form for elsewhere; it is infinite at a pole. No warning is
    raised for either.
    """
    result = _value(function, values)
    if function.otherwise and np.any(np.isnan(result)):
        result = np.where(np.isnan(result), _value(function.otherwise, values), result)
    return scalar_or_array(result)


def _value(function: Function, values: Mapping[str, Value]) -> Array:
    scope = _inputs(function, values)
    with np.errstate(all="ignore"):
        for step in function.steps:
            _run(step, scope)
        result = compute(function.output, scope)
        for guard in function.guards:
            result = np.where(_holds(guard, scope), result, np.nan)
    return result


def _inputs(
    program: Function | PoseProgram | ResultStatus, values: Mapping[str, Value]
) -> dict[str, Array]:
    return {i.name: np.asarray(values[i.name], dtype=np.float64) for i in program.inputs}


def has_senses(function: Function) -> bool:
    """Return whether joints of a function have friction whose sense is that of a slip."""
    return any(True for step in function.steps for _ in _senses_in(step))


def _senses_in(step: ProgramStatement) -> Iterator[Formula]:
    """Yield the senses of slips in a step, as :func:`spelled_out` has them."""
    parts = (part for formula in formulas_of(step) for part in walk(formula))
    return filter(is_sense, parts)


def at_rest(function: Function, values: Mapping[str, Value]) -> NDArray[np.bool_]:
    """Return where a slip is zero, so that its friction has no sense.

    The output has no friction of that joint there, and differs from what it comes to next to it.
    """
    forms = [form for form in (function, function.otherwise) if form and has_senses(form)]
    return reduce(np.logical_or, (_at_rest(form, values) for form in forms), np.asarray(False))


def _at_rest(form: Function, values: Mapping[str, Value]) -> NDArray[np.bool_]:
    """Return where a slip is zero by the steps of one form."""
    scope, found = _inputs(form, values), [np.asarray(False)]
    with np.errstate(all="ignore"):
        for step in form.steps:
            found += [compute(sense, scope) == 0 for sense in _senses_in(step)]
            _run(step, scope)
    return reduce(np.logical_or, found)


def status(function: Function, ideal: Function, values: Mapping[str, Value]) -> Array:
    """Return the status of a result with friction; ``ideal`` is the same without it.

    What the numbers mean is in :data:`~.statuses.STATUSES`.
    """
    asked = function.status
    assert asked is not None, "only results with friction have a status"
    value, without = (np.asarray(evaluate(f, values)) for f in (function, ideal))
    load = value
    scope = _inputs(asked, values)
    with np.errstate(all="ignore"):
        done = [_run(step, scope) for step in asked.steps]
        if isinstance(asked.drive, DrivingLoad):
            without, load = (compute(each, scope) for each in asked.drive)
        solved = [d for d, step in zip(done, asked.steps, strict=True) if isinstance(step, Solve)]
        is_pose = reduce(
            np.logical_and, (_holds(g, scope) for g in asked.guards), ~np.isnan(without)
        )
    none = np.isnan(value)
    ahead = np.isfinite(value) if asked.is_idle else without >= 0
    found = np.where(ahead, *asked.standstill)
    *loops, friction = (d == NOT_FOUND for d in solved or [np.asarray(NOT_FOUND)])
    found = np.where(none & friction, NOT_FOUND, found)
    found = np.where(none & ~is_pose, NO_POSE, found)
    found = np.where(none & reduce(np.logical_or, loops, False), NOT_FOUND, found)
    unloaded = (np.abs(without) < NO_LOAD) & (np.abs(load) < NO_LOAD)
    if asked.is_idle:
        moves = unloaded | (asked.sense * load >= 0)
    else:
        moves = unloaded | np.where(ahead, load > 0, load < 0)
    return np.where(np.isfinite(value) & moves, MOVES, found)


def scalar_or_array(value: Value) -> Value:
    """Return a float for a scalar, else an array of floats."""
    return np.asarray(value, dtype=np.float64) if np.ndim(value) else float(value)


def pose(pose: PoseProgram, values: Mapping[str, Value]) -> tuple[dict[str, Value], Value]:
    """Return the outputs of a pose at values of the inputs, and the status.

    The status is 0 where the loops close, 1 where the loops do not close or a branch has
    ended, and 2 where Newton's method ran out of corrections.
    """
    scope = _inputs(pose, values)
    status: Array = np.asarray(0.0)
    with np.errstate(all="ignore"):
        for step in pose.steps:
            status = np.maximum(status, _run(step, scope))
        found = {name: scope[name] for name in pose.outputs}
        for name in pose.closed:
            status = np.maximum(status, np.isnan(found[name]))
    return {n: scalar_or_array(v) for n, v in found.items()}, scalar_or_array(status)


def _run(statement: ProgramStatement, scope: dict[str, Array]) -> Array:
    """Add what a statement defines to the scope; return the status of a solution, else 0."""
    if not isinstance(statement, Solve):
        scope[statement.name] = compute(statement.formula, scope)
        return np.asarray(0.0)
    solver = statement.solver
    outer = [compute(a, scope) for a in statement.arguments]

    status, found = follow(_equations(solver), solver, outer)
    scope.update(zip(statement.names, found, strict=True))
    return status


def _equations(solver: Solver) -> SolverEquations:
    """Return a solver's residuals and slopes, those by the share where changes are given."""

    def equations(
        unknowns: Array, known: Array, changes: Array | None = None
    ) -> tuple[Array, Array]:
        inner = dict(zip((*solver.unknowns, *solver.outer), (*unknowns, *known), strict=True))
        steps, rows = solver.steps, solver.jacobian
        if changes is not None and (arcs := solver.by_arcs):
            inner |= {name: changes[place] for place, name in arcs.changes}
            steps = (*steps, *arcs.steps)
            rows = tuple((*row, last) for row, last in zip(rows, arcs.slopes, strict=True))
        for step in steps:
            inner[step.name] = compute(step.formula, inner)
        residuals, *slopes = (
            np.stack([np.broadcast_to(compute(f, inner), unknowns[0].shape) for f in row])
            for row in (solver.residuals, *rows)
        )
        return residuals, np.stack(slopes)

    return equations


def _holds(guard: Guard, scope: Mapping[str, Array]) -> NDArray[np.bool_]:
    if guard.operator == "=":
        gap, slack = equal_within(guard.left, guard.right)
        return np.less_equal(compute(gap, scope), compute(slack, scope))
    return _HOLDS[guard.operator](compute(guard.left, scope), compute(guard.right, scope))


def compute(formula: Formula, scope: Mapping[str, Array]) -> Array:
    """Return a formula's value on arrays, in the order in which targets compute it."""
    match formula:
        case Number(value):
            return np.asarray(value.numerator / value.denominator)
        case Pi():
            return np.asarray(np.pi)
        case Symbol(name):
            return scope[name]
        case Sum(terms):
            return reduce(np.add, (compute(t, scope) for t in terms))
        case Product():
            return _product(formula, scope)
        case Power(base, Number(value)) if value == -1:
            return 1.0 / compute(base, scope)
        case Power(base, exponent):
            return np.power(compute(base, scope), compute(exponent, scope))
        case Call(function, arguments) if simpler := spelled_out(function, arguments):
            return compute(simpler, scope)
        case Call(function, arguments):
            return FUNCTIONS[function](*(compute(a, scope) for a in arguments))
        case Implicit():
            raise TypeError("a solution is a step of its own")
        case _:
            assert_never(formula)


def _product(formula: Product, scope: Mapping[str, Array]) -> Array:
    negative, above, below = _quotient_of(formula)
    result = _multiplied(above, scope)
    if below:
        result = np.divide(result, _multiplied(below, scope))
    return np.negative(result) if negative else result


def _multiplied(factors: tuple[Formula, ...], scope: Mapping[str, Array]) -> Array:
    return reduce(np.multiply, (compute(f, scope) for f in factors), np.asarray(1.0))
