"""The function that states which condition of a calculation sheet fails first."""

from collections.abc import Mapping

from ...named import NamedTuple
from ...routine.steps import Checks, Solver, mentioned, names_of, sides_of
from .. import describe
from ..names import Names, mangle
from .pose import arrays
from .printer import CPrinter, harmless, wrapped
from .reserved import RESERVED
from .solvers import lines


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
    space = Names(RESERVED, {single, batch, *own.values(), *solvers.values()})
    printer = CPrinter(own | mangle((n for s in checks.steps for n in names_of(s)), space))
    sides = list(sides_of(checks.guards))
    used = mentioned(checks.steps, sides)
    body, statuses = lines(checks.steps, used, solvers, printer, space)
    body += [f"(void){name}; /* where it is not 0, the unknowns are NaN */" for name in statuses]
    status, number, loop = map(space.claim, ("status", "n", "i"))
    inputs = list(own.values())
    return ChecksContext(
        [harmless(line) for line in _remarks(checks, own, number)],
        wrapped(f"int {single}(", [f"double {a}" for a in inputs] or ["void"]),
        wrapped(f"void {batch}(", arrays(number, inputs, [], status)),
        body,
        [printer.condition(guard) for guard in checks.guards],
        f"{single}({', '.join(f'{a}[{loop}]' for a in inputs)})",
        status,
        number,
        loop,
    )


def _remarks(checks: Checks, own: Mapping[str, str], number: str) -> list[str]:
    return [
        "Returns 0 where all conditions hold, else the number of the first that does not:",
        *(f"  {line}" for line in describe.status_lines(checks)),
        "",
        *(f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in checks.inputs),
        "",
        f"The second form computes the elements 0 .. {number} - 1; its arrays must not overlap.",
    ]
