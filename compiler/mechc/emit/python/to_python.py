"""Python: one module that needs only NumPy, for floats and arrays alike."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import ModuleType
from typing import TYPE_CHECKING

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...diagnostics import emission as messages
from ...diagnostics.diagnostic import MechcError
from ...formula.choices import SIGNS
from ...formula.numeric import arcs, newton
from ...formula.tree import Call, Formula
from ...formula.walk import walk
from ...routine.steps import (
    Common,
    Function,
    Input,
    PoseProgram,
    Program,
    Routine,
    Solver,
    every,
    formulas_of,
    inputs_of,
    programs,
    sides_of,
)
from ...units import si_unit
from .. import describe
from ..names import TargetNames, file_stem, mangle
from ..printer import Printer
from ..render import Assignment, render
from ..target import Compiled, Emitted, Options
from . import gradient
from .pairs import PAIR
from .pose import (
    CommonContext,
    PoseContext,
    body_after_common,
    common_context,
    pose_contexts,
)
from .printer import KEYWORDS, MODULES, RESERVED
from .solvers import SolverContext, solver_context, solver_names
from .status import ChecksContext, StatusContext, checks_context, status_context

_SIGNS = {**SIGNS, "same": "=="}


if TYPE_CHECKING:
    from .gradient import GradientContext


class FunctionContext(NamedTuple):
    """One function of the module."""

    name: str
    arguments: list[str]
    title: str
    unit: str
    formulas: list[str]
    conditions: list[str]
    inputs: list[Assignment]
    body: list[Assignment]
    result: str
    block: str
    operations: int
    remarks: list[str]
    otherwise: str
    status: StatusContext | None


class ModuleContext(NamedTuple):
    """The whole module; fields are what ``python/module.jinja`` mentions."""

    heading: str
    preface: list[str]
    defaults: list[Assignment]
    ranges: list[Assignment]
    solvers: list[SolverContext]
    newton: ModuleType
    arcs: ModuleType
    by_arcs: bool
    turning: bool
    conditions: list[Assignment]
    chooses: bool
    commons: list[CommonContext]
    functions: list[FunctionContext]
    pairs: bool
    poses: list[PoseContext]
    checks: ChecksContext | None
    gradients: "list[GradientContext]"
    main: list[str]


class PythonTarget:
    """``--emit python``."""

    name = "python"
    suffixes = (".py",)

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the module as one file, with gradients if the options ask for them."""
        text = render("python/module.jinja", _module(compiled, options.gradient))
        return (Emitted(f"{_stem(options)}.py", text),)


TARGET = PythonTarget()


def _stem(options: Options) -> str:
    taken = MODULES if options.named else MODULES | KEYWORDS
    stem = file_stem(options.stem, options.named, taken)
    if stem is None:
        hidden, free = f"Python's module {options.stem}", f"{options.stem}_.py"
        raise MechcError([messages.file_hides_another(f"{options.stem}.py", hidden, free)])
    return stem


def _module(compiled: Compiled, slopes: bool) -> ModuleContext:
    """Return the fields of the template of a module."""
    routine, space = compiled.routine, TargetNames(RESERVED)
    names, parts = function_names(routine, space), programs(routine)
    inputs = inputs_of(routine)
    arguments = mangle((i.name for i in inputs), _free(routine, names))
    solvers = solver_names(step for part in parts for step in part.steps)
    poses = pose_contexts(compiled, space, arguments, solvers)
    checks = _checks(routine, space, arguments, solvers)
    gradients = _gradients(routine, space, arguments) if slopes else []
    written = (*parts, *(gradient.program for gradient in gradients))
    called = {name for program in written for name in _called(program)}
    listed = list(every(routine.functions))
    commons = [common_context(p, arguments, solvers) for p in parts if isinstance(p, Common)]
    functions = [_function(f, names, arguments, solvers, listed) for f in listed]
    lines = [
        *(line for c in commons for line in c.body),
        *(line for f in functions for line in f.body),
    ]
    return ModuleContext(
        heading=_quoted(describe.heading(compiled.mechanism)),
        preface=[_quoted(line) for line in _preface(compiled)],
        defaults=_defaults(inputs, arguments),
        ranges=_ranges(inputs, arguments),
        solvers=[solver_context(solver, name) for solver, name in solvers.items()],
        newton=newton,
        arcs=arcs,
        by_arcs=any(solver.by_arcs for solver in solvers),
        turning=any(solver.turning for solver in solvers),
        conditions=[Assignment(name, _SIGNS[name]) for name in SIGNS if name in called],
        chooses="choose" in called,
        commons=commons,
        functions=functions,
        pairs=any(line.code.startswith(PAIR) for line in lines),
        poses=poses,
        checks=checks,
        gradients=gradients,
        main=[_shown(f, names[f.name], arguments) for f in routine.functions],
    )


def _free(routine: Routine, names: Mapping[str, str]) -> TargetNames:
    """Return the names that arguments may have: none of a function that another one calls."""
    called = (f.otherwise.name for f in every(routine.functions) if f.otherwise)
    return TargetNames(RESERVED.besides(names[name] for name in called))


def _defaults(inputs: Iterable[Input], arguments: Mapping[str, str]) -> list[Assignment]:
    return [Assignment(arguments[i.name], repr(i.default)) for i in inputs if i.default is not None]


def _ranges(inputs: Iterable[Input], arguments: Mapping[str, str]) -> list[Assignment]:
    ranged = (i for i in inputs if i.low is not None)
    return [Assignment(arguments[i.name], f"({i.low!r}, {i.high!r})") for i in ranged]


def _checks(
    routine: Routine,
    space: TargetNames,
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
) -> ChecksContext | None:
    if not routine.checks:
        return None
    return checks_context(routine.checks, space.claim("status"), arguments, solvers)


def _gradients(
    routine: Routine, space: TargetNames, arguments: Mapping[str, str]
) -> "list[GradientContext]":
    return gradient.gradient_contexts(routine.functions, space, arguments)


def function_names(routine: Routine, space: TargetNames) -> dict[str, str]:
    """Return the names that results and their statuses have in the module."""
    listed = list(every(routine.functions))
    statuses = (f.status.name for f in listed if f.status)
    return mangle((*(f.name for f in listed), *statuses), space)


def _called(part: Program) -> Iterator[str]:
    """Yield the functions of the language that a program calls."""
    guards = () if isinstance(part, Common | PoseProgram) else part.guards
    sides = list(sides_of(guards))
    output = [part.output] if isinstance(part, Function) else []
    for formula in (*(f for s in part.steps for f in formulas_of(s)), *sides, *output):
        yield from (p.function for p in walk(formula) if isinstance(p, Call))


def _preface(compiled: Compiled) -> list[str]:
    lines = []
    if compiled.mechanism.source:
        lines.append(f"Source: {describe.one_line(compiled.mechanism.source)}.")
    for condition in describe.unchecked(compiled.routine):
        lines.append(f"Not checked here: {condition}.")
    return [
        *lines,
        f"Written by mechc {compiled.version}. SI units and radians; floats and arrays alike.",
    ]


def _function(
    function: Function,
    names: Mapping[str, str],
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
    listed: Sequence[Function],
) -> FunctionContext:
    """Return the fields of the template of a function."""
    own = {i.name: arguments[i.name] for i in function.inputs}
    other = function.otherwise
    space = TargetNames(RESERVED, {*own.values(), *([names[other.name]] if other else [])})
    result = space.claim(function.name if function.name not in own else "result")
    steps = function.own if function.common else function.steps
    body, ends, printer = body_after_common(
        function.common, steps, _ends(function), own, space, solvers
    )
    unit = si_unit(function.dimension)
    return FunctionContext(
        name=names[function.name],
        arguments=list(own.values()),
        title=_quoted(describe.one_line(function.title)),
        unit=f", in {unit}" if unit else "",
        formulas=[_quoted(words) for words in describe.formula_lines(function)],
        conditions=[_quoted(words) for words in describe.condition_lines(function)],
        inputs=[
            Assignment(own[i.name], _quoted(describe.input_words(i, own[i.name])))
            for i in function.inputs
        ],
        body=[*body, *_returned(function, ends, result, printer)],
        result=result,
        block=f"_block_of_{names[function.name]}",
        operations=function.operations,
        remarks=[_quoted(words) for words in describe.remarks(function, names)],
        otherwise=f"{names[other.name]}({', '.join(own[i.name] for i in other.inputs)})"
        if other
        else "",
        status=status_context(function, {f.name: f for f in listed}, names, solvers),
    )


def _ends(function: Function) -> list[Formula]:
    """Return the output and what the guards compare."""
    return [function.output, *sides_of(function.guards)]


def _returned(
    function: Function, ends: Sequence[Formula], result: str, printer: Printer
) -> list[Assignment]:
    """Return the lines of the output and the guards, which ``ends`` have in the printer's terms."""
    output, *sides = ends
    lines = [Assignment(result, printer.print(output))]
    pairs = zip(sides[::2], sides[1::2], strict=True)
    for guard, (left, right) in zip(function.guards, pairs, strict=True):
        condition = printer.condition(replace(guard, left=left, right=right))
        lines.append(Assignment(result, f"np.where({condition}, {result}, np.nan)"))
    return lines


def _shown(function: Function, name: str, arguments: Mapping[str, str]) -> str:
    """Return the line that prints a result at the default pose, or says what is missing."""
    missing = [arguments[i.name] for i in function.inputs if i.default is None]
    if missing:
        return f'print("{name}: no default for {", ".join(missing)}")'
    values = ", ".join(f"{arguments[i.name]}={i.default!r}" for i in function.inputs)
    return f'print(f"{name} = {{{name}({values}):.10g}}")'


def _quoted(words: str) -> str:
    """Return text fit for a docstring."""
    return words.replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
