"""Functions that give many values: a pose's with its status, and what others have in common."""

from collections.abc import Mapping
from typing import NamedTuple

from ...formula.tree import Symbol
from ...routine.steps import Common, Pose, Solver, mentioned, names_of
from .. import describe
from ..names import Names, mangle
from .layout import harmless, wrapped
from .printer import CPrinter
from .reserved import RESERVED
from .solvers import lines


class PoseContext(NamedTuple):
    """Fields are what ``c/pose.jinja`` and ``c/declarations.jinja`` mention."""

    remarks: list[str]
    single: str
    batch: str
    body: list[str]
    results: list[str]
    missing: str
    statuses: list[str]
    call: str
    status: str
    number: str
    loop: str


def pose_context(
    pose: Pose,
    single: str,
    batch: str,
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> PoseContext:
    """Return the function of a mechanism's pose, for one and for many."""
    own = {i.name: arguments[i.name] for i in pose.inputs}
    space = Names(RESERVED, {single, batch, *own.values(), *solvers.values()})
    names = own | mangle((n for s in pose.steps for n in names_of(s)), space)
    outputs = {n: space.claim(f"{names[n]}_out") for n in pose.outputs}
    used = mentioned(pose.steps, map(Symbol, pose.outputs))
    body, statuses = lines(pose.steps, used, solvers, CPrinter(names), space)
    status, number, loop = map(space.claim, ("status", "n", "i"))
    inputs = list(own.values())
    given = [*(f"{a}[{loop}]" for a in inputs), *(f"{o} + {loop}" for o in outputs.values())]
    return PoseContext(
        [harmless(line) for line in _remarks(pose, own, outputs, number)],
        wrapped(
            f"int {single}(",
            [*(f"double {a}" for a in inputs), *(f"double *{o}" for o in outputs.values())],
        ),
        wrapped(f"void {batch}(", _arrays(number, inputs, list(outputs.values()), status)),
        body,
        [f"*{o} = {names[n]};" for n, o in outputs.items()],
        " || ".join(f"{names[n]} != {names[n]}" for n in pose.outputs),
        statuses,
        f"{single}({', '.join(given)})",
        status,
        number,
        loop,
    )


def _arrays(number: str, inputs: list[str], outputs: list[str], status: str) -> list[str]:
    """Return the arguments of the form for many poses."""
    taken = [f"const double *MECHC_RESTRICT {name}" for name in inputs]
    given = [f"double *MECHC_RESTRICT {name}" for name in outputs]
    return [f"size_t {number}", *taken, *given, f"int *MECHC_RESTRICT {status}"]


def _remarks(
    pose: Pose, own: Mapping[str, str], outputs: Mapping[str, str], number: str
) -> list[str]:
    return [
        "The intermediates of the pose. Returns 0 where all are there, 1 where the loops do not",
        "close or a branch has ended on the way from the default pose, 2 where Newton's method",
        "does not converge; what is not there is NaN.",
        "",
        *(f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in pose.inputs),
        *(f"  {out}: {name}" for name, out in outputs.items()),
        "",
        f"The second form computes the elements 0 .. {number} - 1; its arrays must not overlap.",
    ]


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
