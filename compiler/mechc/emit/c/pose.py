"""Functions that give many values: a pose's with its status, and what others have in common."""

from collections.abc import Mapping

from ...base.named import NamedTuple
from ...formula.tree import Symbol
from ...routine.steps import Common, PoseProgram, Solver, closed_dimensions, mentioned, names_of
from .. import describe
from ..names import TargetNames, mangle
from ..target import Compiled
from .printer import CPrinter, broken, harmless, wrapped
from .reserved import RESERVED
from .solvers import lines

ENDED = [
    "close or a branch has ended on the way from the default pose, 2 where Newton's method",
    "does not converge; what is not there is NaN.",
]

POSE = [
    "The intermediates of the pose. Returns 0 where all are there, 1 where the loops do not",
    *ENDED,
]

POINTS = [
    f"The {describe.POINTS}, and how both change with",
    "the drive. Returns 0 where there is a pose, 1 where the loops do not",
    *ENDED,
]


class Forms(NamedTuple):
    """The names of a function for one pose and of that for many."""

    single: str
    batch: str

    @classmethod
    def of(cls, name: str, space: TargetNames) -> "Forms":
        """Return the names that such functions get."""
        return cls(space.claim(name), space.claim(f"{name}_n"))


class PoseContext(NamedTuple):
    """Fields are what ``c/pose.jinja`` and ``c/declarations.jinja`` mention, and what it fills."""

    name: str
    outputs: list[str]
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


def pose_contexts(
    compiled: Compiled,
    space: TargetNames,
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> list[PoseContext]:
    """Return the functions of a mechanism's pose and its points, each for one and for many."""
    routine = compiled.routine
    pose, points = (Forms.of(f"{routine.name}_{what}", space) for what in ("pose", "points"))
    found: list[PoseContext] = []
    if routine.pose:
        measured = closed_dimensions(routine.pose, compiled.mechanism)
        meanings = {name: describe.measured_words(name, d) for name, d in measured.items()}
        found.append(_context(routine.pose, pose, POSE, meanings, arguments, solvers))
    if routine.points:
        meanings = {q.name: describe.quantity_words(q) for q in routine.points.quantities}
        program = routine.points.program
        found.append(_context(program, points, POINTS, meanings, arguments, solvers))
    return found


def _context(
    pose: PoseProgram,
    forms: Forms,
    remarks: list[str],
    meanings: Mapping[str, str],
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> PoseContext:
    """Return the fields of the template of a program of the pose."""
    own = {i.name: arguments[i.name] for i in pose.inputs}
    single, batch = forms
    space = TargetNames(RESERVED, {single, batch, *own.values(), *solvers.values()})
    names = own | mangle((n for s in pose.steps for n in names_of(s)), space)
    outputs = {n: space.claim(f"{names[n]}_out") for n in pose.outputs}
    used = mentioned(pose.steps, map(Symbol, pose.outputs))
    body, statuses = lines(pose.steps, used, solvers, CPrinter(names), space)
    status, number, loop = map(space.claim, ("status", "n", "i"))
    inputs = list(own.values())
    given = [*(f"{a}[{loop}]" for a in inputs), *(f"{o} + {loop}" for o in outputs.values())]
    return PoseContext(
        name=single,
        outputs=list(outputs.values()),
        remarks=[*remarks, "", *map(harmless, _remarks(pose, own, outputs, meanings, number))],
        single=wrapped(
            f"int {single}(",
            [*(f"double {a}" for a in inputs), *(f"double *{o}" for o in outputs.values())],
        ),
        batch=wrapped(f"void {batch}(", arrays(number, inputs, list(outputs.values()), status)),
        body=body,
        results=[f"*{o} = {names[n]};" for n, o in outputs.items()],
        missing=broken(" || ", [f"{names[n]} != {names[n]}" for n in pose.closed]),
        statuses=statuses,
        call=f"{single}({', '.join(given)})",
        status=status,
        number=number,
        loop=loop,
    )


def arrays(number: str, inputs: list[str], outputs: list[str], status: str) -> list[str]:
    """Return the arguments of the form for many poses."""
    taken = [f"const double *MECHC_RESTRICT {name}" for name in inputs]
    given = [f"double *MECHC_RESTRICT {name}" for name in outputs]
    return [f"size_t {number}", *taken, *given, f"int *MECHC_RESTRICT {status}"]


def _remarks(
    pose: PoseProgram,
    own: Mapping[str, str],
    outputs: Mapping[str, str],
    meanings: Mapping[str, str],
    number: str,
) -> list[str]:
    """Return the comment above a program of the pose: its arguments, and what it gives."""
    return [
        *(f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in pose.inputs),
        *(f"  {out}: {meanings[name]}" for name, out in outputs.items()),
        "",
        f"The second form computes the elements 0 .. {number} - 1; its arrays must not overlap.",
    ]


class CommonContext(NamedTuple):
    """Fields are what ``c/common.jinja`` mentions."""

    head: str
    body: list[str]


def common_context(
    common: Common,
    names: Mapping[int, str],
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> CommonContext:
    """Return the function of what others have in common, which fills an array."""
    own, name = {i.name: arguments[i.name] for i in common.inputs}, names[common.number]
    space = TargetNames(RESERVED, {*names.values(), *own.values(), *solvers.values()})
    values = space.claim("values")
    steps = mangle((n for step in common.steps for n in names_of(step)), space)
    taken = taking(common.before, names, own, space)
    printer = CPrinter({**arguments, **taken.names, **steps})
    used = mentioned(common.steps, map(Symbol, common.outputs))
    body, statuses = lines(common.steps, used, solvers, printer, space)
    body += [f"(void){status};" for status in statuses]
    body += [f"{values}[{i}] = {printer.names[n]};" for i, n in enumerate(common.outputs)]
    heads = [*(f"double {a}" for a in own.values()), f"double *{values}"]
    return CommonContext(wrapped(f"static void {name}(", heads), [*taken.body, *body])


class Taking(NamedTuple):
    """Lines that take what is common, and what its outputs are called then."""

    body: list[str]
    names: Mapping[str, str]


def taking(
    common: Common | None, called: Mapping[int, str], own: Mapping[str, str], space: TargetNames
) -> Taking:
    """Return how a function takes what it has in common with others."""
    if common is None:
        return Taking([], {})
    values = space.claim("taken")
    given = ", ".join([*(own[i.name] for i in common.inputs), values])
    body = [f"double {values}[{len(common.outputs)}];", f"{called[common.number]}({given});"]
    return Taking(body, {name: f"{values}[{i}]" for i, name in enumerate(common.outputs)})
