"""C99: a header and a source that C++ reads too, each result for one pose and for many."""

import re
from collections.abc import Iterator, Mapping, Sequence, Set
from types import ModuleType
from typing import TYPE_CHECKING, TypeAlias

from ...base.later import pattern
from ...base.named import NamedTuple
from ...diagnostics import emission as messages
from ...diagnostics.diagnostic import MechcError
from ...formula.choices import SIGNS
from ...formula.numeric import arcs, newton
from ...routine.steps import Common, Program, Routine, every, inputs_of, programs
from .. import describe
from ..names import TargetNames, file_stem, mangle, transliterate
from ..render import Assignment, render
from ..target import Compiled, Emitted, Options
from . import gradient
from . import threads as parallel
from .functions import FileScope, FunctionContext, Symbols, function_context, symbols_of
from .parameters import ParametersContext, parameters_context
from .pose import CommonContext, PoseContext, common_context, pose_contexts
from .printer import CPrinter, harmless
from .real import FLOAT, Real, in_single_precision, named
from .reserved import HEADERS, LINKED, RESERVED
from .solvers import SolverContext, solver_context, solvers_of
from .status import ChecksContext, StatusContext, checks_context

if TYPE_CHECKING:
    from .gradient import GradientContext


_CHOICES = {"min": "<", "max": ">"}
_SIGNS = {**SIGNS, "same": "=="}


DeclaringContext: TypeAlias = (
    "FunctionContext | StatusContext | PoseContext | ChecksContext | GradientContext"
)
"""The declarations of a header."""


class HeaderContext(NamedTuple):
    """Fields are what ``c/header.jinja`` mentions."""

    preface: list[str]
    guard: str
    functions: list[DeclaringContext]
    parameters: ParametersContext | None


class CodeContext(NamedTuple):
    """Fields are what ``c/functions.jinja`` mentions."""

    functions: list[FunctionContext]
    poses: list[PoseContext]
    checks: ChecksContext | None
    solvers: list[SolverContext]
    commons: list[CommonContext]
    gradients: "list[GradientContext]"
    parameters: ParametersContext | None
    newton: ModuleType
    real: Real


class SourceContext(NamedTuple):
    """Fields are what ``c/source.jinja`` mentions; ``header`` is '' in a single file."""

    preface: list[str]
    header: str
    public: list[DeclaringContext]
    parameters: ParametersContext | None
    helpers: Set[str]
    choices: list[Assignment]
    conditions: list[Assignment]
    bits: bool
    roots: bool
    pi: bool
    real: Real
    arcs: ModuleType
    code: str


class Parts(NamedTuple):
    """The parts of a source."""

    functions: list[FunctionContext]
    poses: list[PoseContext]
    checks: ChecksContext | None
    solvers: list[SolverContext]
    commons: list[CommonContext]
    gradients: "list[GradientContext]"
    parameters: ParametersContext | None

    @property
    def public(self) -> list[DeclaringContext]:
        """Return the declarations of the header."""
        with_statuses = (each for f in self.functions for each in (f, f.status) if each)
        checks = [self.checks] if self.checks else []
        return [*with_statuses, *self.poses, *checks, *self.gradients]


class CTarget:
    """``--emit c``."""

    name = "c"
    suffixes = (".c", ".h")

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return source and header, or one file with the declarations in front."""
        stem = _stem(options)
        parts = _parts(compiled, options.gradient)
        preface, real = _preface(compiled, options.c_openmp), named(options.c_real)
        header = "" if options.single else f"{stem}.h"
        source = _file(f"{stem}.c", _source(parts, preface, header, real, options.c_openmp), real)
        if options.single:
            return (source,)
        guard = f"MECHC_{transliterate(compiled.routine.name).upper()}_H"
        context = HeaderContext(preface, guard, parts.public, parts.parameters)
        return (source, _file(header, render("c/header.jinja", context), real))


TARGET = CTarget()


def _stem(options: Options) -> str:
    if re.search(r'["\\\n]', options.stem):
        raise MechcError([messages.unspeakable_file_name(options.stem)])
    stem = file_stem(options.stem, options.named, HEADERS)
    if stem is None:
        name = f"{options.stem}.h"
        raise MechcError(
            [messages.file_hides_another(name, f"the header <{name}>", f"{options.stem}_.c")]
        )
    return stem


def _file(name: str, text: str, real: Real) -> Emitted:
    return Emitted(name, in_single_precision(text) if real is FLOAT else text)


def _source(parts: Parts, preface: list[str], header: str, real: Real, threads: bool) -> str:
    """Return the text of the source file, with those helpers alone that it calls."""
    code = render("c/functions.jinja", CodeContext(*parts, newton, real))
    if threads:
        code = parallel.in_threads(code)
    called = helpers(code)
    context = SourceContext(
        preface=preface,
        header=header,
        public=parts.public,
        parameters=parts.parameters,
        helpers=called,
        choices=[Assignment(name, sign) for name, sign in _CHOICES.items() if name in called],
        conditions=[Assignment(name, _SIGNS[name]) for name in SIGNS if name in called],
        bits=not called.isdisjoint(BITS),
        roots=any("sqrt(" in line for line in _quick_lines(parts)),
        pi=CPrinter.pi in code,
        real=real,
        arcs=arcs,
        code=code,
    )
    return render("c/source.jinja", context)


def _quick_lines(parts: Parts) -> Iterator[str]:
    """Yield the lines of the bodies that are for loops."""
    for function in parts.functions:
        if function.quick:
            yield from (*function.quick.body, function.quick.output)
    for one in parts.gradients:
        yield from one.quick


def _preface(compiled: Compiled, threads: bool) -> list[str]:
    mechanism = compiled.mechanism
    lines = [f"{describe.heading(mechanism)}."]
    if mechanism.source:
        lines.append(f"Source: {describe.one_line(mechanism.source)}.")
    for line in describe.unchecked(compiled.routine):
        lines.append(f"Not checked here: {line}.")
    lines.append(f"Written by mechc {compiled.version}. SI units and radians.")
    if threads:
        lines.append("Built with OpenMP (-fopenmp), forms for many poses use all processors.")
    return [harmless(line) for line in lines]


def linked_names(routine: Routine, space: TargetNames) -> dict[str, Symbols]:
    """Return the names that the linker knows of results and of their statuses."""
    listed = list(every(routine.functions))
    statuses = (f.status.name for f in listed if f.status)
    return symbols_of(routine.name, [*(f.name for f in listed), *statuses], space)


def _parts(compiled: Compiled, slopes: bool) -> Parts:
    """Return the functions of all files, for one header and one source."""
    routine, space = compiled.routine, TargetNames(LINKED)
    written, listed = programs(routine), list(every(routine.functions))
    linked = linked_names(routine, space)
    status, statuses = (space.claim(f"{routine.name}_status{end}") for end in ("", "_n"))
    scope = _file_scope(routine, written, linked, space)
    arguments, solvers = scope.arguments, scope.solvers
    poses = pose_contexts(compiled, space, arguments, solvers)
    gradients = _gradients(routine, space, arguments) if slopes else []
    checks = routine.checks
    return Parts(
        functions=[function_context(f, scope, listed) for f in listed],
        poses=poses,
        checks=checks_context(checks, status, statuses, arguments, solvers) if checks else None,
        solvers=[solver_context(solver, name) for solver, name in solvers.items()],
        commons=[
            common_context(c, scope.commons, arguments, solvers)
            for c in written
            if isinstance(c, Common)
        ],
        gradients=gradients,
        parameters=parameters_context(
            routine, scope.singles, poses, gradients, status, space, arguments
        ),
    )


def _file_scope(
    routine: Routine, written: Sequence[Program], linked: Mapping[str, Symbols], space: TargetNames
) -> FileScope:
    """Return the names at file scope; no argument is called as a function that a body calls."""
    called = (linked[f.otherwise.name].single for f in every(routine.functions) if f.otherwise)
    free = TargetNames(RESERVED.besides(called))
    found = solvers_of(step for program in written for step in program.steps)
    numbers = [program.number for program in written if isinstance(program, Common)]
    return FileScope(
        symbols=linked,
        arguments=mangle((i.name for i in inputs_of(routine)), free),
        solvers={s: space.claim(f"{routine.name}_solution_{i}") for i, s in enumerate(found, 1)},
        commons={number: space.claim(f"{routine.name}_values_{number}") for number in numbers},
    )


def _gradients(
    routine: Routine, space: TargetNames, arguments: Mapping[str, str]
) -> "list[GradientContext]":
    return gradient.gradient_contexts(routine.name, routine.functions, space, arguments)


_CALL = pattern(r"\bmechc_(\w+)\(")
_NEEDS = {
    "sin": "sine",
    "cos": "sine",
    "sin_of_pair": "circular",
    "cos_of_pair": "circular",
    "tan": "circular",
}
BITS = frozenset({"sine", "circular", "nan", "if_less", "if_no_more"})
"""Those that look at the bits of numbers, for which they need ``stdint.h`` and ``string.h``."""


def helpers(code: str) -> set[str]:
    """Return the helper functions that code calls, and those that these call.

    Only helpers have names that begin with ``mechc_``: nothing else is given such a name.

    >>> sorted(helpers("return mechc_sin(x)*y;"))
    ['sin', 'sine']
    """
    called = set(_CALL.findall(code))
    return called | {_NEEDS[name] for name in called if name in _NEEDS}
