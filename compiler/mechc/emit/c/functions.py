"""A result as a function of C, for one pose and for many."""

from collections.abc import Mapping, Sequence

from ...base.named import NamedTuple
from ...formula.tree import Call, Formula
from ...formula.walk import walk
from ...routine.steps import (
    Common,
    Function,
    ProgramStatement,
    Solve,
    Solver,
    formulas_of,
    mentioned,
    names_of,
    sides_of,
)
from ...units import si_unit
from .. import describe
from ..names import TargetNames, mangle
from ..printer import Printer
from .pose import taking
from .printer import CIRCULAR, CPrinter, QuickPrinter, guarded, harmless, wrapped
from .reserved import RESERVED
from .solvers import lines
from .status import StatusContext, status_context


class FunctionBody(NamedTuple):
    """The body of a function."""

    body: list[str]
    conditions: list[str]
    output: str


class FunctionContext(NamedTuple):
    """One function in its two forms, for one pose and for many.

    Where it needs sines or cosines, the loop calls a ``kernel`` with the ``quick`` body
    of its own, and the ``plain`` one where that gives no number.
    """

    remarks: list[str]
    single: str
    batch: str
    kernel: str
    plain: FunctionBody
    quick: FunctionBody | None
    element: str
    call: str
    quick_call: str
    number: str
    loop: str
    start: str
    stop: str
    value: str
    missing: str
    result: str
    otherwise: str
    status: StatusContext | None


class Symbols(NamedTuple):
    """The names of one function's forms at file scope."""

    single: str
    batch: str
    kernel: str


class FileScope(NamedTuple):
    """The names at file scope: of functions, their arguments, solvers, and what they share."""

    symbols: Mapping[str, Symbols]
    arguments: Mapping[str, str]
    solvers: Mapping[Solver, str]
    commons: Mapping[int, str]

    @property
    def singles(self) -> dict[str, str]:
        """Return the name of each function's form for one pose."""
        return {name: s.single for name, s in self.symbols.items()}


def symbols_of(mechanism: str, functions: list[str], space: TargetNames) -> dict[str, Symbols]:
    """Return the names at file scope; no second form may take another function's name."""
    singles = mangle((f"{mechanism}_{f}" for f in functions), space)
    found = {f: singles[f"{mechanism}_{f}"] for f in functions}
    batches = {f: space.claim(f"{name}_n") for f, name in found.items()}
    return {f: Symbols(n, batches[f], space.claim(f"{n}_quick")) for f, n in found.items()}


def function_context(
    function: Function, scope: FileScope, listed: Sequence[Function]
) -> FunctionContext:
    """Return a function of the file; ``listed`` are all of them."""
    linked, singles = scope.symbols[function.name], scope.singles
    own = {i.name: scope.arguments[i.name] for i in function.inputs}
    other = function.otherwise
    called = [singles[other.name]] if other else []
    taken = {*own.values(), *scope.solvers.values(), *scope.commons.values(), *called}
    inner, outer = TargetNames(RESERVED, taken), TargetNames(RESERVED, {*own.values(), *linked})
    number, loop = outer.claim("n"), outer.claim("i")
    result = outer.claim(function.name)
    elements = ", ".join(f"{a}[{loop}]" for a in own.values())
    if function.common:
        plain, quick = _taken(function, function.common, own, scope, inner), None
    else:
        plain, quick = _computed(function, own, scope.solvers, inner)
    return FunctionContext(
        remarks=[harmless(line) for line in _remarks(function, own, number, result, singles)],
        single=_single(linked.single, list(own.values())),
        batch=_batch(linked.batch, list(own.values()), number, result),
        kernel=_single(linked.kernel, list(own.values())),
        plain=plain,
        quick=quick,
        element=f"{result}[{loop}]",
        call=f"{linked.single}({elements})",
        quick_call=f"{linked.kernel}({elements})",
        number=number,
        loop=loop,
        start=outer.claim("start"),
        stop=outer.claim("stop"),
        value=outer.claim("value"),
        missing=outer.claim("missing"),
        result=inner.claim(function.name),
        otherwise=describe.call(other, singles, own) if other else "",
        status=_status(function, scope, listed),
    )


def _status(
    function: Function, scope: FileScope, listed: Sequence[Function]
) -> StatusContext | None:
    if function.status is None:
        return None
    functions, batch = {f.name: f for f in listed}, scope.symbols[function.status.name].batch
    return status_context(function, functions, scope.singles, batch, scope.solvers)


def _computed(
    function: Function, own: Mapping[str, str], solvers: Mapping[Solver, str], inner: TargetNames
) -> tuple[FunctionBody, FunctionBody | None]:
    """Return the body of a function, and the same without branches where it pays."""
    names = {**own, **mangle((n for s in function.steps for n in names_of(s)), inner)}
    plain = _plain(function, function.steps, CPrinter(names), solvers, inner)
    printer = QuickPrinter(names, _formulas(function))
    return plain, _quick(function, own, printer) if _is_circular(function) else None


def _taken(
    function: Function, common: Common, own: Mapping[str, str], scope: FileScope, inner: TargetNames
) -> FunctionBody:
    """Return a body that takes what many functions have in common, and adds its own steps."""
    taken = taking(common, scope.commons, own, inner)
    steps = mangle((n for s in function.own for n in names_of(s)), inner)
    printer = CPrinter({**own, **taken.names, **steps})
    found = _plain(function, function.own, printer, scope.solvers, inner)
    return found._replace(body=[*taken.body, *found.body])


def _plain(
    function: Function,
    steps: Sequence[ProgramStatement],
    printer: Printer,
    solvers: Mapping[Solver, str],
    space: TargetNames,
) -> FunctionBody:
    conditions = [printer.condition(guard) for guard in function.guards]
    body, statuses = lines(steps, mentioned(steps, _ends(function)), solvers, printer, space)
    body += [f"(void){name}; /* where it is not 0, the unknowns are NaN */" for name in statuses]
    return FunctionBody(body, conditions, printer.print(function.output))


def _quick(function: Function, own: Mapping[str, str], printer: Printer) -> FunctionBody:
    """Return a body without branches: each guard is a call around the output.

    What the form for elsewhere alone needs is not used in it.
    """
    used = mentioned(function.steps, _ends(function))
    unused = [f"(void){own[i.name]};" for i in function.inputs if i.name not in used]
    output = printer.print(function.output)
    for guard in function.guards:
        output = guarded(guard, printer, output)
    steps, _ = lines(function.steps, frozenset(), {}, printer, TargetNames(RESERVED))
    return FunctionBody([*steps, *unused], [], output)


def _is_circular(function: Function) -> bool:
    """Return whether a function of inputs calls a sine, a cosine or a tangent."""
    if any(isinstance(step, Solve) for step in function.steps):
        return False
    calls = [g for f in _formulas(function) for g in walk(f) if isinstance(g, Call)]
    return bool(function.inputs) and any(g.function in CIRCULAR for g in calls)


def _single(name: str, arguments: list[str]) -> str:
    return wrapped(f"double {name}(", [f"double {a}" for a in arguments] or ["void"])


def _batch(name: str, arguments: list[str], number: str, result: str) -> str:
    arrays = [f"const double *MECHC_RESTRICT {a}" for a in arguments]
    listed = [f"size_t {number}", *arrays, f"double *MECHC_RESTRICT {result}"]
    return wrapped(f"void {name}(", listed)


def _remarks(
    function: Function,
    own: Mapping[str, str],
    number: str,
    result: str,
    names: Mapping[str, str],
) -> list[str]:
    """Return the lines of the comment above a function."""
    unit = si_unit(function.dimension)
    inputs = [f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in function.inputs]
    conditions = [f"  {line}" for line in describe.condition_lines(function)]
    cost = describe.counted(function.operations)
    return [
        f"The {describe.one_line(function.title)}{f', in {unit}' if unit else ''}:",
        "",
        *(f"  {line}" for line in describe.formula_lines(function)),
        "",
        *inputs,
        *(["NaN unless", *conditions] if conditions else []),
        *describe.remarks(function, names),
        f"{cost}. The second form computes {result}[0 .. {number} - 1];",
        "its arrays must not overlap.",
    ]


def _formulas(function: Function) -> list[Formula]:
    return [*(f for s in function.steps for f in formulas_of(s)), *_ends(function)]


def _ends(function: Function) -> list[Formula]:
    """Return the output and what the guards compare."""
    return [function.output, *sides_of(function.guards)]
