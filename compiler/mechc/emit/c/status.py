"""Functions that say whether a result with friction moves, and which condition fails, for C."""

from collections.abc import Mapping

from ...base.named import NamedTuple
from ...model.result import DrivingLoad
from ...routine.statuses import STATUSES
from ...routine.steps import NO_LOAD, Checks, Function, Solver, mentioned, names_of, sides_of
from .. import describe
from ..names import TargetNames, mangle
from ..printer import driving
from .pose import arrays
from .printer import CPrinter, harmless, wrapped
from .reserved import RESERVED
from .solvers import lines


class StatusContext(NamedTuple):
    """Fields are what ``c/status.jinja`` and ``c/declarations.jinja`` mention."""

    remarks: list[str]
    single: str
    batch: str
    value: str
    ideal: str
    load: str
    before: list[str]
    body: list[str]
    conditions: list[str]
    loops: list[str]
    friction: str
    idle: bool
    moves: str
    standstill: tuple[int, int]
    call: str
    number: str
    loop: str
    nothing: float = NO_LOAD


OWN = ("value", "ideal", "load", "is_ahead", "is_unloaded", "status", "n", "i")
"""What the template calls its own."""


def status_context(
    function: Function,
    functions: Mapping[str, Function],
    names: Mapping[str, str],
    batch: str,
    solvers: Mapping[Solver, str],
) -> StatusContext | None:
    """Return the status of a function, None where it has none; ``names`` are at file scope."""
    asked = function.status
    if asked is None:
        return None
    reserved = RESERVED.besides([*OWN, *names.values(), batch, *solvers.values()])
    own = mangle((i.name for i in asked.inputs), TargetNames(reserved))
    space = TargetNames(reserved, set(own.values()))
    printer = CPrinter(own | mangle((n for s in asked.steps for n in names_of(s)), space))
    used = mentioned(asked.steps, asked.sides)
    body, statuses = lines(asked.steps, used, solvers, printer, space)
    ideal, load = driving(asked, printer, lambda n: describe.call(functions[n], names, own))
    is_needed_first = isinstance(asked.drive, DrivingLoad)
    single, inputs = names[asked.name], list(own.values())
    arrays = [f"const double *MECHC_RESTRICT {name}" for name in inputs]
    return StatusContext(
        remarks=[harmless(line) for line in _remarks_on_status(function, own)],
        single=wrapped(f"int {single}(", [f"double {a}" for a in inputs] or ["void"]),
        batch=wrapped(f"void {batch}(", ["size_t n", *arrays, "int *MECHC_RESTRICT status"]),
        value=describe.call(function, names, own),
        ideal=ideal,
        load=load,
        before=body if is_needed_first else [],
        body=[] if is_needed_first else body,
        conditions=[printer.condition(g) for g in asked.guards],
        loops=statuses[:-1],
        friction=statuses[-1] if statuses else "2",
        idle=asked.is_idle,
        moves=f"load {asked.way} 0.0" if asked.is_idle else "(is_ahead ? load > 0.0 : load < 0.0)",
        standstill=asked.standstill,
        call=f"{single}({', '.join(f'{a}[i]' for a in inputs)})",
        number="n",
        loop="i",
    )


def _remarks_on_status(function: Function, own: Mapping[str, str]) -> list[str]:
    inputs = function.status.inputs if function.status else ()
    return [
        f"The status of {function.name}, which tells its numbers and NaN apart:",
        "",
        *(f"  {line}" for line in describe.numbered(STATUSES)),
        "",
        *(f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in inputs),
        "",
        "The second form computes the elements 0 .. n - 1; its arrays must not overlap.",
    ]


# --------------------------------------------------------------------------------------- conditions


class ChecksContext(NamedTuple):
    """Fields are what ``c/checks.jinja`` and ``c/declarations.jinja`` mention."""

    remarks: list[str]
    single: str
    batch: str
    body: list[str]
    conditions: list[str]
    call: str
    status: str
    number: str
    loop: str


def checks_context(
    checks: Checks,
    single: str,
    batch: str,
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> ChecksContext:
    """Return the function of a sheet's conditions, for one and for many."""
    own = {i.name: arguments[i.name] for i in checks.inputs}
    space = TargetNames(RESERVED, {single, batch, *own.values(), *solvers.values()})
    printer = CPrinter(own | mangle((n for s in checks.steps for n in names_of(s)), space))
    sides = list(sides_of(checks.guards))
    used = mentioned(checks.steps, sides)
    body, statuses = lines(checks.steps, used, solvers, printer, space)
    body += [f"(void){name}; /* where it is not 0, the unknowns are NaN */" for name in statuses]
    status, number, loop = map(space.claim, ("status", "n", "i"))
    inputs = list(own.values())
    return ChecksContext(
        remarks=[harmless(line) for line in _remarks_on_checks(checks, own, number)],
        single=wrapped(f"int {single}(", [f"double {a}" for a in inputs] or ["void"]),
        batch=wrapped(f"void {batch}(", arrays(number, inputs, [], status)),
        body=body,
        conditions=[printer.condition(guard) for guard in checks.guards],
        call=f"{single}({', '.join(f'{a}[{loop}]' for a in inputs)})",
        status=status,
        number=number,
        loop=loop,
    )


def _remarks_on_checks(checks: Checks, own: Mapping[str, str], number: str) -> list[str]:
    return [
        "Returns 0 where all conditions hold, else the number of the first that does not:",
        *(f"  {line}" for line in describe.status_lines(checks)),
        "",
        *(f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in checks.inputs),
        "",
        f"The second form computes the elements 0 .. {number} - 1; its arrays must not overlap.",
    ]
