"""C99: a header and a source that C++ reads too, each result for one pose and for many."""

import re
from collections.abc import Mapping, Sequence, Set
from types import ModuleType
from typing import NamedTuple

from ...diagnostics.diagnostic import MechcError
from ...diagnostics.emission import file_hides_another, unspeakable_file_name
from ...formula import newton
from ...formula.choices import SIGNS
from ...formula.tree import Call, Formula
from ...formula.walk import walk
from ...routine.steps import (
    Common,
    Function,
    Solve,
    Solver,
    every,
    formulas_of,
    mentioned,
    names_of,
    programs,
)
from ...units import si_unit
from .. import describe
from ..names import Names, file_stem, mangle, transliterate
from ..printer import Printer
from ..render import Line, render
from ..target import Compiled, Emitted, Options
from .checks import ChecksContext, checks_context
from .helpers import BITS, helpers
from .layout import harmless, wrapped
from .pose import CommonContext, PoseContext, common_context, pose_contexts
from .printer import CIRCULAR, CPrinter, QuickPrinter, guarded
from .reserved import HEADERS, LINKED, RESERVED
from .solvers import (
    SolverContext,
    lines,
    solver_context,
    solvers_of,
)
from .status import StatusContext, status_context

_CHOICES = {"min": "<", "max": ">"}
_SIGNS = {**SIGNS, "same": "=="}


class Body(NamedTuple):
    """What a function computes."""

    body: list[str]
    conditions: list[str]
    output: str


class FunctionContext(NamedTuple):
    """One function in its two forms, for one pose and for many.

    Where it needs sines or cosines, the loop calls a ``kernel`` with the ``quick`` body
    of its own, and the ``plain`` one where that gives no number.
    """

    remarks: list[str]
    single: str
    batch: str
    kernel: str
    plain: Body
    quick: Body | None
    element: str
    call: str
    quick_call: str
    number: str
    loop: str
    start: str
    stop: str
    result: str
    otherwise: str
    status: StatusContext | None


Declared = FunctionContext | StatusContext | PoseContext | ChecksContext
"""What a header declares."""


class HeaderContext(NamedTuple):
    """Fields are what ``c/header.jinja`` mentions."""

    preface: list[str]
    guard: str
    functions: list[Declared]


class CodeContext(NamedTuple):
    """Fields are what ``c/functions.jinja`` mentions."""

    functions: list[FunctionContext]
    poses: list[PoseContext]
    checks: ChecksContext | None
    solvers: list[SolverContext]
    commons: list[CommonContext]
    newton: ModuleType


class SourceContext(NamedTuple):
    """Fields are what ``c/source.jinja`` mentions; ``header`` is '' in a single file."""

    preface: list[str]
    header: str
    public: list[Declared]
    helpers: Set[str]
    choices: list[Line]
    conditions: list[Line]
    bits: bool
    pi: bool
    code: str


class Symbols(NamedTuple):
    """The names of one function's forms at file scope."""

    single: str
    batch: str
    kernel: str


class Parts(NamedTuple):
    """What a source consists of."""

    functions: list[FunctionContext]
    poses: list[PoseContext]
    checks: ChecksContext | None
    solvers: list[SolverContext]
    commons: list[CommonContext]

    @property
    def public(self) -> list[Declared]:
        """Return what the header declares."""
        with_statuses = (each for f in self.functions for each in (f, f.status) if each)
        return [*with_statuses, *self.poses, *([self.checks] if self.checks else [])]


class CTarget:
    """``--emit c``."""

    name = "c"
    suffixes = (".c", ".h")

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return source and header, or one file with the declarations in front."""
        stem = _stem(options)
        parts = _parts(compiled)
        preface = _preface(compiled)
        header = "" if options.single else f"{stem}.h"
        source = Emitted(f"{stem}.c", _source(parts, preface, header))
        if options.single:
            return (source,)
        guard = f"MECHC_{transliterate(compiled.routine.name).upper()}_H"
        context = HeaderContext(preface, guard, parts.public)
        return (source, Emitted(header, render("c/header.jinja", context)))


TARGET = CTarget()


def _stem(options: Options) -> str:
    if re.search(r'["\\\n]', options.stem):
        raise MechcError([unspeakable_file_name(options.stem)])
    stem = file_stem(options.stem, options.named, HEADERS)
    if stem is None:
        name = f"{options.stem}.h"
        raise MechcError([file_hides_another(name, f"the header <{name}>", f"{options.stem}_.c")])
    return stem


def _source(parts: Parts, preface: list[str], header: str) -> str:
    code = render("c/functions.jinja", CodeContext(*parts, newton))
    called = helpers(code)
    context = SourceContext(
        preface=preface,
        header=header,
        public=parts.public,
        helpers=called,
        choices=[Line(name, sign) for name, sign in _CHOICES.items() if name in called],
        conditions=[Line(name, _SIGNS[name]) for name in SIGNS if name in called],
        bits=not called.isdisjoint(BITS),
        pi=CPrinter.pi in code,
        code=code,
    )
    return render("c/source.jinja", context)


def _formulas(function: Function) -> list[Formula]:
    return [*(f for s in function.steps for f in formulas_of(s)), *_ends(function)]


def _ends(function: Function) -> list[Formula]:
    """Return the output and what the guards compare."""
    return [function.output, *(side for g in function.guards for side in (g.left, g.right))]


def _preface(compiled: Compiled) -> list[str]:
    mechanism = compiled.mechanism
    lines = [f"{describe.heading(mechanism)}."]
    if mechanism.source:
        lines.append(f"Source: {describe.one_line(mechanism.source)}.")
    for line in describe.unchecked(mechanism, compiled.routine.functions):
        lines.append(f"Not checked here: {line}.")
    lines.append(f"Written by mechc {compiled.version}. SI units and radians.")
    return [harmless(line) for line in lines]


def _parts(compiled: Compiled) -> Parts:
    routine, space = compiled.routine, Names(LINKED)
    written, listed = programs(routine), list(every(routine.functions))
    told = [f.status.name for f in listed if f.status]
    linked = _symbols(routine.name, [*(f.name for f in listed), *told], space)
    called = [linked[f.otherwise.name].single for f in listed if f.otherwise]
    arguments = mangle((i.name for p in written for i in p.inputs), Names(RESERVED.besides(called)))
    status, statuses = (space.claim(f"{routine.name}_status{end}") for end in ("", "_n"))
    found = solvers_of(step for p in written for step in p.steps)
    solvers = {s: space.claim(f"{routine.name}_solution_{i}") for i, s in enumerate(found, 1)}
    commons = [p for p in written if isinstance(p, Common)]
    handing = {c.number: space.claim(f"{routine.name}_values_{c.number}") for c in commons}
    poses = pose_contexts(routine, space, arguments, solvers)
    return Parts(
        [_function(f, linked, arguments, solvers, handing, listed) for f in listed],
        poses,
        checks_context(routine.checks, status, statuses, arguments, solvers)
        if routine.checks
        else None,
        [solver_context(solver, name) for solver, name in solvers.items()],
        [common_context(c, handing[c.number], arguments, solvers) for c in commons],
    )


def _symbols(mechanism: str, functions: list[str], space: Names) -> dict[str, Symbols]:
    """Return the names at file scope; no second form may take another function's name."""
    singles = mangle((f"{mechanism}_{f}" for f in functions), space)
    found = {f: singles[f"{mechanism}_{f}"] for f in functions}
    batches = {f: space.claim(f"{name}_n") for f, name in found.items()}
    return {f: Symbols(n, batches[f], space.claim(f"{n}_quick")) for f, n in found.items()}


def _function(
    function: Function,
    symbols: Mapping[str, Symbols],
    arguments: Mapping[str, str],
    solvers: Mapping[Solver, str],
    handing: Mapping[int, str],
    listed: Sequence[Function],
) -> FunctionContext:
    linked, singles = symbols[function.name], {n: s.single for n, s in symbols.items()}
    own = {i.name: arguments[i.name] for i in function.inputs}
    other, asked = function.otherwise, function.status
    called = [singles[other.name]] if other else []
    inner = Names(RESERVED, {*own.values(), *solvers.values(), *handing.values(), *called})
    outer = Names(RESERVED, {*own.values(), *linked})
    number, loop = outer.claim("n"), outer.claim("i")
    result = outer.claim(function.name)
    elements = ", ".join(f"{a}[{loop}]" for a in own.values())
    if function.common:
        plain, quick = _taken(function, function.common, own, handing, inner), None
    else:
        plain, quick = _computed(function, own, solvers, inner)
    return FunctionContext(
        remarks=[harmless(line) for line in _remarks(function, own, number, result, singles)],
        single=_single(linked.single, list(own.values())),
        batch=_batch(linked.batch, list(own.values()), number, result),
        kernel=_single(linked.kernel, list(own.values())),
        plain=plain,
        quick=quick,
        element=f"{result}[{loop}]",
        call=f"{linked.single}({elements})",
        quick_call=f"{linked.kernel}({elements})",
        number=number,
        loop=loop,
        start=outer.claim("start"),
        stop=outer.claim("stop"),
        result=inner.claim(function.name),
        otherwise=describe.call(other, singles, own) if other else "",
        status=status_context(
            function, {f.name: f for f in listed}, singles, symbols[asked.name].batch, solvers
        )
        if asked
        else None,
    )


def _computed(
    function: Function, own: Mapping[str, str], solvers: Mapping[Solver, str], inner: Names
) -> tuple[Body, Body | None]:
    """Return what a function computes itself, and the same without branches where it pays."""
    names = {**own, **mangle((n for s in function.steps for n in names_of(s)), inner)}
    plain = _plain(function, CPrinter(names), solvers, inner)
    return plain, _quick(function, QuickPrinter(names)) if _is_circular(function) else None


def _taken(
    function: Function,
    common: Common,
    own: Mapping[str, str],
    handing: Mapping[int, str],
    inner: Names,
) -> Body:
    """Return a body that takes what many functions have in common."""
    values = inner.claim("values")
    names = {name: f"{values}[{i}]" for i, name in enumerate(common.outputs)}
    printer = CPrinter({**own, **names})
    given = ", ".join([*own.values(), values])
    return Body(
        [f"double {values}[{len(names)}];", f"{handing[common.number]}({given});"],
        [printer.condition(guard) for guard in function.guards],
        printer.print(function.output),
    )


def _plain(
    function: Function, printer: Printer, solvers: Mapping[Solver, str], space: Names
) -> Body:
    conditions = [printer.condition(guard) for guard in function.guards]
    used = mentioned(function.steps, _ends(function))
    body, statuses = lines(function.steps, used, solvers, printer, space)
    body += [f"(void){name}; /* where it is not 0, the unknowns are NaN */" for name in statuses]
    return Body(body, conditions, printer.print(function.output))


def _quick(function: Function, printer: Printer) -> Body:
    """Return a body without branches: each guard is a call around the output."""
    output = printer.print(function.output)
    for guard in function.guards:
        output = guarded(guard, printer, output)
    return Body(lines(function.steps, frozenset(), {}, printer, Names(RESERVED))[0], [], output)


def _is_circular(function: Function) -> bool:
    """Return whether a function of inputs calls a sine, a cosine or a tangent."""
    if any(isinstance(step, Solve) for step in function.steps):
        return False
    calls = [g for f in _formulas(function) for g in walk(f) if isinstance(g, Call)]
    return bool(function.inputs) and any(g.function in CIRCULAR for g in calls)


def _single(name: str, arguments: list[str]) -> str:
    return wrapped(f"double {name}(", [f"double {a}" for a in arguments] or ["void"])


def _batch(name: str, arguments: list[str], number: str, result: str) -> str:
    arrays = [f"const double *MECHC_RESTRICT {a}" for a in arguments]
    listed = [f"size_t {number}", *arrays, f"double *MECHC_RESTRICT {result}"]
    return wrapped(f"void {name}(", listed)


def _remarks(
    function: Function,
    own: Mapping[str, str],
    number: str,
    result: str,
    names: Mapping[str, str],
) -> list[str]:
    unit = si_unit(function.dimension)
    inputs = [f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in function.inputs]
    conditions = [f"  {line}" for line in describe.condition_lines(function)]
    return [
        f"The {describe.one_line(function.title)}{f', in {unit}' if unit else ''}:",
        "",
        *(f"  {line}" for line in describe.formula_lines(function)),
        "",
        *inputs,
        *(["NaN unless", *conditions] if conditions else []),
        *describe.remarks(function, names),
        f"{function.operations} operations. The second form computes {result}[0 .. {number} - 1];",
        "its arrays must not overlap.",
    ]
