"""The functions that hand out what many others have in common."""

from collections.abc import Mapping
from typing import NamedTuple

from ...formula.tree import Symbol
from ...routine.steps import Common, Solver, mentioned, names_of
from ..names import Names, mangle
from .layout import wrapped
from .printer import CPrinter
from .reserved import RESERVED
from .solvers import lines


class CommonContext(NamedTuple):
    """Fields are what ``c/common.jinja`` mentions."""

    head: str
    body: list[str]


def common_context(
    common: Common, name: str, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> CommonContext:
    """Return the function of what others have in common, which fills an array."""
    own = [arguments[i.name] for i in common.inputs]
    space = Names(RESERVED, {name, *own, *solvers.values()})
    values = space.claim("values")
    steps = mangle((n for step in common.steps for n in names_of(step)), space)
    printer = CPrinter({**arguments, **steps})
    used = mentioned(common.steps, map(Symbol, common.outputs))
    body, statuses = lines(common.steps, used, solvers, printer, space)
    body += [f"(void){status};" for status in statuses]
    body += [f"{values}[{i}] = {printer.names[n]};" for i, n in enumerate(common.outputs)]
    heads = [*(f"double {a}" for a in own), f"double *{values}"]
    return CommonContext(wrapped(f"static void {name}(", heads), body)
