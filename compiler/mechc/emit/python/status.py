"""Functions that say whether a result with friction moves, and which condition of a sheet fails."""

from collections.abc import Mapping

from ...base.named import NamedTuple
from ...routine.statuses import STATUSES
from ...routine.steps import NO_LOAD, Checks, Function, Solve, Solver, mentioned, names_of, sides_of
from .. import describe
from ..names import TargetNames, mangle
from ..printer import driving
from ..render import Assignment
from .printer import RESERVED, PythonPrinter
from .solvers import line


class StatusContext(NamedTuple):
    """Fields are what ``python/status.jinja`` mentions."""

    name: str
    of: str
    arguments: list[str]
    inputs: list[Assignment]
    meanings: list[str]
    value: str
    ideal: str
    load: str
    body: list[Assignment]
    conditions: list[str]
    loops: list[str]
    friction: str
    idle: bool
    moves: str
    standstill: tuple[int, int]
    nothing: float = NO_LOAD


OWN = ("value", "ideal", "load", "ahead", "unloaded", "moves", "found")
"""What the template calls its own."""


def status_context(
    function: Function,
    functions: Mapping[str, Function],
    names: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> StatusContext | None:
    """Return the status of a function, None where it has none."""
    asked = function.status
    if asked is None:
        return None
    reserved = RESERVED.besides([*OWN, *names.values()])
    own = mangle((i.name for i in asked.inputs), TargetNames(reserved))
    space = TargetNames(reserved, set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in asked.steps for n in names_of(s)), space))
    used, statuses, body = mentioned(asked.steps, asked.sides), list[str](), list[Assignment]()
    for step in asked.steps:
        status = space.claim("status_1") if isinstance(step, Solve) else ""
        body.append(line(step, used, solvers, printer, status))
        statuses += [status] if status else []
    ideal, load = driving(asked, printer, lambda n: describe.call(functions[n], names, own))
    moves = "np.where(ahead, load, np.negative(load)) > 0.0"
    return StatusContext(
        name=names[asked.name],
        of=function.name,
        arguments=list(own.values()),
        inputs=[
            Assignment(own[i.name], describe.input_words(i, own[i.name])) for i in asked.inputs
        ],
        meanings=list(describe.numbered(STATUSES)),
        value=describe.call(function, names, own),
        ideal=ideal,
        load=load,
        body=body,
        conditions=[printer.condition(g) for g in asked.guards],
        loops=statuses[:-1],
        friction=statuses[-1] if statuses else "2",
        idle=asked.is_idle,
        moves=f"load {asked.way} 0.0" if asked.is_idle else moves,
        standstill=asked.standstill,
    )


# --------------------------------------------------------------------------------------- conditions


class ChecksContext(NamedTuple):
    """Fields are what ``python/checks.jinja`` mentions."""

    name: str
    arguments: list[str]
    inputs: list[Assignment]
    body: list[Assignment]
    conditions: list[str]
    meanings: list[str]


def checks_context(
    checks: Checks, name: str, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> ChecksContext:
    """Return the function of a sheet's conditions."""
    own = {i.name: arguments[i.name] for i in checks.inputs}
    space = TargetNames(RESERVED.besides(["status", "holds", "number"]), set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in checks.steps for n in names_of(s)), space))
    used = mentioned(checks.steps, sides_of(checks.guards))
    return ChecksContext(
        name,
        list(own.values()),
        [Assignment(own[i.name], describe.input_words(i, own[i.name])) for i in checks.inputs],
        [line(step, used, solvers, printer) for step in checks.steps],
        [printer.condition(guard) for guard in checks.guards],
        describe.status_lines(checks),
    )
