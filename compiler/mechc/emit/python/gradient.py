"""Functions that give a result and its slopes by each argument."""

from collections.abc import Iterable, Mapping

from ...base.named import NamedTuple
from ...routine.functions import operations
from ...routine.gradient import gradients
from ...routine.steps import Function, PoseProgram, names_of
from .. import describe
from ..names import TargetNames, mangle
from ..render import Assignment
from .printer import RESERVED, PythonPrinter
from .solvers import line


class GradientContext(NamedTuple):
    """Fields are what ``python/gradient.jinja`` mentions, and the program that it writes.

    ``outputs`` are names and their variables.
    """

    name: str
    title: str
    of: str
    arguments: list[str]
    inputs: list[Assignment]
    remarks: list[str]
    body: list[Assignment]
    outputs: list[Assignment]
    operations: int
    program: PoseProgram


def gradient_contexts(
    functions: Iterable[Function], space: TargetNames, arguments: Mapping[str, str]
) -> list[GradientContext]:
    """Return such a function for each result that has a closed form."""
    return [_context(f, p, space, arguments) for f, p in gradients(functions)]


def _context(
    function: Function, program: PoseProgram, space: TargetNames, arguments: Mapping[str, str]
) -> GradientContext:
    """Return the fields of the template of a function with its slopes."""
    own = {i.name: arguments[i.name] for i in program.inputs}
    inner = TargetNames(RESERVED.besides(["found"]), set(own.values()))
    printer = PythonPrinter(own | mangle((n for s in program.steps for n in names_of(s)), inner))
    used = frozenset(program.outputs)
    return GradientContext(
        name=space.claim(f"{function.name}_gradient"),
        title=describe.one_line(function.title),
        of=function.name,
        arguments=list(own.values()),
        inputs=[
            Assignment(own[i.name], describe.input_words(i, own[i.name])) for i in program.inputs
        ],
        remarks=describe.slope_remarks(function),
        body=[line(step, used, {}, printer) for step in program.steps],
        outputs=[Assignment(repr(n), printer.names[n]) for n in program.outputs],
        operations=operations(program.steps),
        program=program,
    )
