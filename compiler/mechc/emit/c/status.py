"""The function that says whether a result with friction moves, for one pose and for many."""

from collections.abc import Mapping

from ...model.result import Drive
from ...named import NamedTuple
from ...routine.steps import NOTHING, STATUSES, Function, Solver, mentioned, names_of
from .. import describe
from ..names import Names, mangle
from ..printer import driving
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
    nothing: float = NOTHING


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
    own = mangle((i.name for i in asked.inputs), Names(reserved))
    space = Names(reserved, set(own.values()))
    printer = CPrinter(own | mangle((n for s in asked.steps for n in names_of(s)), space))
    used = mentioned(asked.steps, asked.sides)
    body, statuses = lines(asked.steps, used, solvers, printer, space)
    ideal, load = driving(asked, printer, lambda n: describe.call(functions[n], names, own))
    is_needed_first = isinstance(asked.drive, Drive)
    single, inputs = names[asked.name], list(own.values())
    arrays = [f"const double *MECHC_RESTRICT {name}" for name in inputs]
    return StatusContext(
        remarks=[harmless(line) for line in _remarks(function, own)],
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


def _remarks(function: Function, own: Mapping[str, str]) -> list[str]:
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
