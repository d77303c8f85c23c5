"""The functions that hand out what many others have in common."""

from collections.abc import Mapping
from typing import NamedTuple

from ...formula.tree import Symbol
from ...routine.steps import Common, Solver, mentioned, names_of
from ..names import Names, mangle
from ..render import Line
from .printer import RESERVED, PythonPrinter
from .solvers import line


class CommonContext(NamedTuple):
    """One of them; ``outputs`` are names and their variables."""

    name: str
    arguments: list[str]
    body: list[Line]
    outputs: list[Line]


def common_name(common: Common) -> str:
    """Return the name of the function of what others have in common."""
    return f"_values_{common.number}"


def common_context(
    common: Common, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> CommonContext:
    """Return the function of what others have in common."""
    own = {i.name: arguments[i.name] for i in common.inputs}
    steps = (n for step in common.steps for n in names_of(step))
    printer = PythonPrinter(own | mangle(steps, Names(RESERVED, set(own.values()))))
    used = mentioned(common.steps, map(Symbol, common.outputs))
    return CommonContext(
        common_name(common),
        list(own.values()),
        [line(step, used, solvers, printer) for step in common.steps],
        [Line(repr(n), printer.names[n]) for n in common.outputs],
    )
