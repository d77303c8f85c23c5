"""Functions that give many values: a pose's with its status, and what others have in common."""

from collections.abc import Iterable, Mapping, Sequence

from ...base.named import NamedTuple
from ...formula.tree import Formula, Symbol
from ...routine.steps import (
    Common,
    PoseProgram,
    ProgramStatement,
    Solve,
    Solver,
    closed_dimensions,
    mentioned,
    names_of,
)
from .. import describe
from ..names import TargetNames, mangle
from ..render import Assignment
from ..target import Compiled
from .pairs import PAIR, CosineAndSine, in_pairs
from .printer import RESERVED, PythonPrinter
from .solvers import line


class PoseContext(NamedTuple):
    """Fields are what ``python/pose.jinja`` mentions; ``outputs`` are names and their variables.

    ``meanings`` say what outputs are; ``closed`` are those that have values where loops close,
    empty where these are all.
    """

    name: str
    title: str
    arguments: list[str]
    inputs: list[Assignment]
    meanings: list[str]
    body: list[Assignment]
    outputs: list[Assignment]
    closed: list[str]
    statuses: list[str]


def pose_contexts(
    compiled: Compiled,
    space: TargetNames,
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> list[PoseContext]:
    """Return the functions of a mechanism's pose and of its points, as far as there are any."""
    routine = compiled.routine
    pose, points = (space.claim(name) for name in ("pose", "points"))
    found: list[PoseContext] = []
    if routine.pose:
        measured = closed_dimensions(routine.pose, compiled.mechanism)
        words = [describe.measured_words(name, d) for name, d in measured.items()]
        found.append(_context(routine.pose, pose, "intermediates", words, arguments, solvers))
    if routine.points:
        meanings = describe.quantity_lines(routine.points.quantities)
        program = routine.points.program
        found.append(_context(program, points, describe.POINTS, meanings, arguments, solvers))
    return found


def _context(
    pose: PoseProgram,
    name: str,
    title: str,
    meanings: Iterable[str],
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> PoseContext:
    """Return the fields of the template of a program of the pose."""
    own = {i.name: arguments[i.name] for i in pose.inputs}
    space = TargetNames(RESERVED.besides(["found", "status"]), set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in pose.steps for n in names_of(s)), space))
    used = mentioned(pose.steps, map(Symbol, pose.outputs))
    body: list[Assignment] = []
    statuses: list[str] = []
    for step in pose.steps:
        status = space.claim("status_1") if isinstance(step, Solve) else ""
        body.append(line(step, used, solvers, printer, status))
        statuses += [status] if status else []
    return PoseContext(
        name=name,
        title=title,
        arguments=list(own.values()),
        inputs=[Assignment(own[i.name], describe.input_words(i, own[i.name])) for i in pose.inputs],
        meanings=list(meanings),
        body=body,
        outputs=[Assignment(repr(n), printer.names[n]) for n in pose.outputs],
        closed=[] if pose.closed == pose.outputs else [repr(n) for n in pose.closed],
        statuses=statuses,
    )


class CommonContext(NamedTuple):
    """One of them; ``outputs`` are names and their variables."""

    name: str
    arguments: list[str]
    body: list[Assignment]
    outputs: list[Assignment]


def common_name(common: Common) -> str:
    """Return the name of the function of what others have in common."""
    return f"_values_{common.number}"


def common_context(
    common: Common, arguments: Mapping[str, str], solvers: Mapping[Solver, str]
) -> CommonContext:
    """Return the function of what others have in common."""
    own = {i.name: arguments[i.name] for i in common.inputs}
    space = TargetNames(RESERVED, set(own.values()))
    ends = [*map(Symbol, common.outputs)]
    body, _, printer = body_after_common(common.before, common.steps, ends, own, space, solvers)
    return CommonContext(
        common_name(common),
        list(own.values()),
        body,
        [Assignment(repr(n), printer.names[n]) for n in common.outputs],
    )


class FunctionBody(NamedTuple):
    """Lines of a function, its ends by what these assign, and the printer that knows the names."""

    body: list[Assignment]
    ends: list[Formula]
    printer: PythonPrinter


def body_after_common(
    common: Common | None,
    steps: Sequence[ProgramStatement],
    ends: Sequence[Formula],
    own: Mapping[str, str],
    space: TargetNames,
    solvers: Mapping[Solver, str],
) -> FunctionBody:
    """Return the lines of a function that calls what it has in common with others, then its steps.

    ``common`` is what is called, if there is any; ``steps`` are left for this function, and
    ``ends`` the formulas that its result is made of. ``own`` has the variable of each input;
    further variables get names of ``space`` that are free. All is written for arrays of poses too.
    """
    names, body = dict(own), list[Assignment]()
    if common:
        values = space.claim("values")
        given = ", ".join(own[i.name] for i in common.inputs)
        body.append(Assignment(values, f"{common_name(common)}({given})"))
        names.update((name, f'{values}["{name}"]') for name in common.outputs)
    used = mentioned(steps, ends)
    found = in_pairs(steps, ends, names)
    own_names = (*(n for s in steps for n in names_of(s)), *found.names)
    printer = PythonPrinter(names | mangle(own_names, space))
    body += [
        _pair(s, printer) if isinstance(s, CosineAndSine) else line(s, used, solvers, printer)
        for s in found.statements
    ]
    return FunctionBody(body, found.formulas, printer)


def _pair(pair: CosineAndSine, printer: PythonPrinter) -> Assignment:
    cosine, sine = (printer.names.get(name, name) for name in (pair.cosine, pair.sine))
    return Assignment(f"{cosine}, {sine}", f"{PAIR}({printer.print(pair.angle)})")
