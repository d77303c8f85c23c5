"""Functions that give many values: a pose's with its status, and what others have in common."""

from collections.abc import Mapping
from typing import NamedTuple

from ...formula.tree import Symbol
from ...routine.steps import Common, Pose, Solve, Solver, mentioned, names_of
from .. import describe
from ..names import Names, mangle
from ..render import Line
from .printer import RESERVED, PythonPrinter
from .solvers import line


class PoseContext(NamedTuple):
    """Fields are what ``python/pose.jinja`` mentions; ``outputs`` are names and their variables."""

    name: str
    arguments: list[str]
    inputs: list[Line]
    body: list[Line]
    outputs: list[Line]
    statuses: list[str]


def pose_context(
    pose: Pose, name: str, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> PoseContext:
    """Return the function of a mechanism's pose."""
    own = {i.name: arguments[i.name] for i in pose.inputs}
    space = Names(RESERVED.besides(["found", "status"]), set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in pose.steps for n in names_of(s)), space))
    used = mentioned(pose.steps, map(Symbol, pose.outputs))
    body: list[Line] = []
    statuses: list[str] = []
    for step in pose.steps:
        status = space.claim("status_1") if isinstance(step, Solve) else ""
        body.append(line(step, used, solvers, printer, status))
        statuses += [status] if status else []
    return PoseContext(
        name,
        list(own.values()),
        [Line(own[i.name], describe.input_words(i, own[i.name])) for i in pose.inputs],
        body,
        [Line(repr(n), printer.names[n]) for n in pose.outputs],
        statuses,
    )


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
