"""The function that states which condition of a calculation sheet fails first."""

from collections.abc import Mapping

from ...named import NamedTuple
from ...routine.steps import Checks, Solver, mentioned, names_of, sides_of
from .. import describe
from ..names import Names, mangle
from ..render import Line
from .printer import RESERVED, PythonPrinter
from .solvers import line


class ChecksContext(NamedTuple):
    """Fields are what ``python/checks.jinja`` mentions."""

    name: str
    arguments: list[str]
    inputs: list[Line]
    body: list[Line]
    conditions: list[str]
    meanings: list[str]


def checks_context(
    checks: Checks, name: str, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> ChecksContext:
    """Return the function of a sheet's conditions."""
    own = {i.name: arguments[i.name] for i in checks.inputs}
    space = Names(RESERVED.besides(["status", "holds", "number"]), set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in checks.steps for n in names_of(s)), space))
    used = mentioned(checks.steps, sides_of(checks.guards))
    return ChecksContext(
        name,
        list(own.values()),
        [Line(own[i.name], describe.input_words(i, own[i.name])) for i in checks.inputs],
        [line(step, used, solvers, printer) for step in checks.steps],
        [printer.condition(guard) for guard in checks.guards],
        describe.status_lines(checks),
    )
