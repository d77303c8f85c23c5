"""C99: a header and a source that C++ reads too, each result for one pose and for many."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from ...diagnostics.diagnostic import MechcError
from ...diagnostics.emission import unspeakable_file_name
from ...formula.tree import Call, Formula, Pi
from ...formula.walk import walk
from ...routine.steps import Function
from .. import describe
from ..names import Names, mangle, transliterate
from ..printer import Printer
from ..render import Line, render
from ..target import Compiled, Emitted, Options
from .printer import CIRCULAR, RESERVED, CPrinter, QuickPrinter, guarded

LONGEST_LINE = 100

_CHOICES = {"min": "<", "max": ">"}


class Body(NamedTuple):
    """What a function computes."""

    body: list[Line]
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


class HeaderContext(NamedTuple):
    """Fields are what ``c/header.jinja`` mentions."""

    preface: list[str]
    guard: str
    functions: list[FunctionContext]


class SourceContext(NamedTuple):
    """Fields are what ``c/source.jinja`` mentions; ``header`` is '' in a single file."""

    preface: list[str]
    header: str
    functions: list[FunctionContext]
    pi: bool
    circular: bool
    guarded: bool
    choices: list[Line]


class Symbols(NamedTuple):
    """The names of one function's forms at file scope."""

    single: str
    batch: str
    kernel: str


class CTarget:
    """``--emit c``."""

    name = "c"
    suffixes = (".c", ".h")

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return source and header, or one file with the declarations in front."""
        if re.search(r'["\\\n]', options.stem):
            raise MechcError([unspeakable_file_name(options.stem)])
        functions = _functions(compiled)
        preface = _preface(compiled)
        header = "" if options.single else f"{options.stem}.h"
        source = Emitted(f"{options.stem}.c", _source(compiled, functions, preface, header))
        if options.single:
            return (source,)
        guard = f"MECHC_{transliterate(compiled.routine.name).upper()}_H"
        context = HeaderContext(preface, guard, functions)
        return (source, Emitted(header, render("c/header.jinja", context)))


TARGET = CTarget()


def _source(
    compiled: Compiled, functions: list[FunctionContext], preface: list[str], header: str
) -> str:
    parts = [part for f in compiled.routine.functions for g in _formulas(f) for part in walk(g)]
    called = {part.function for part in parts if isinstance(part, Call)}
    choices = [Line(name, sign) for name, sign in _CHOICES.items() if name in called]
    context = SourceContext(
        preface=preface,
        header=header,
        functions=functions,
        pi=Pi() in parts,
        circular=any(f.quick for f in functions),
        guarded=any(f.quick and f.plain.conditions for f in functions),
        choices=choices,
    )
    return render("c/source.jinja", context)


def _formulas(function: Function) -> list[Formula]:
    sides = [side for g in function.guards for side in (g.left, g.right)]
    return [*(s.formula for s in function.steps), function.output, *sides]


def _preface(compiled: Compiled) -> list[str]:
    mechanism = compiled.mechanism
    lines = [f"{describe.heading(mechanism)}."]
    if mechanism.source:
        lines.append(f"Source: {describe.one_line(mechanism.source)}.")
    for line in describe.unchecked(mechanism, compiled.routine.functions):
        lines.append(f"Not checked here: {line}.")
    lines.append(f"Written by mechc {compiled.version}. SI units and radians.")
    return [_harmless(line) for line in lines]


def _functions(compiled: Compiled) -> list[FunctionContext]:
    routine = compiled.routine
    arguments = mangle((i.name for f in routine.functions for i in f.inputs), Names(RESERVED))
    linked = _symbols(routine.name, [f.name for f in routine.functions])
    return [_function(f, linked[f.name], arguments) for f in routine.functions]


def _symbols(mechanism: str, functions: list[str]) -> dict[str, Symbols]:
    """Return the names at file scope; no second form may take another function's name."""
    space = Names(RESERVED)
    singles = mangle((f"{mechanism}_{f}" for f in functions), space)
    found = {f: singles[f"{mechanism}_{f}"] for f in functions}
    batches = {f: space.claim(f"{name}_n") for f, name in found.items()}
    return {f: Symbols(n, batches[f], space.claim(f"{n}_quick")) for f, n in found.items()}


def _function(function: Function, linked: Symbols, arguments: Mapping[str, str]) -> FunctionContext:
    own = {i.name: arguments[i.name] for i in function.inputs}
    names = own | mangle((s.name for s in function.steps), Names(RESERVED, set(own.values())))
    outer = Names(RESERVED, {*own.values(), *linked})
    number, loop = outer.claim("n"), outer.claim("i")
    result = outer.claim(function.name)
    elements = ", ".join(f"{a}[{loop}]" for a in own.values())
    return FunctionContext(
        remarks=[_harmless(line) for line in _remarks(function, own, number, result)],
        single=_single(linked.single, list(own.values())),
        batch=_batch(linked.batch, list(own.values()), number, result),
        kernel=_single(linked.kernel, list(own.values())),
        plain=_plain(function, CPrinter(names)),
        quick=_quick(function, QuickPrinter(names)) if _is_circular(function) else None,
        element=f"{result}[{loop}]",
        call=f"{linked.single}({elements})",
        quick_call=f"{linked.kernel}({elements})",
        number=number,
        loop=loop,
        start=outer.claim("start"),
        stop=outer.claim("stop"),
    )


def _plain(function: Function, printer: Printer) -> Body:
    conditions = [printer.condition(guard) for guard in function.guards]
    return Body(_lines(function, printer), conditions, printer.print(function.output))


def _quick(function: Function, printer: Printer) -> Body:
    """Return a body without branches: each guard is a call around the output."""
    output = printer.print(function.output)
    for guard in function.guards:
        output = guarded(guard, printer, output)
    return Body(_lines(function, printer), [], output)


def _lines(function: Function, printer: Printer) -> list[Line]:
    return [Line(printer.names[s.name], printer.print(s.formula)) for s in function.steps]


def _is_circular(function: Function) -> bool:
    """Return whether a function of inputs calls a sine, a cosine or a tangent."""
    calls = [g for f in _formulas(function) for g in walk(f) if isinstance(g, Call)]
    return bool(function.inputs) and any(g.function in CIRCULAR for g in calls)


def _single(name: str, arguments: list[str]) -> str:
    return _wrapped(f"double {name}(", [f"double {a}" for a in arguments] or ["void"])


def _batch(name: str, arguments: list[str], number: str, result: str) -> str:
    arrays = [f"const double *MECHC_RESTRICT {a}" for a in arguments]
    listed = [f"size_t {number}", *arrays, f"double *MECHC_RESTRICT {result}"]
    return _wrapped(f"void {name}(", listed)


def _wrapped(head: str, arguments: list[str]) -> str:
    """Return a function's head on one line, or with one argument on each."""
    line = f"{head}{', '.join(arguments)})"
    return line if len(line) <= LONGEST_LINE else head + "\n    " + ",\n    ".join(arguments) + ")"


def _remarks(function: Function, own: Mapping[str, str], number: str, result: str) -> list[str]:
    unit = describe.si_unit(function.dimension)
    inputs = [f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in function.inputs]
    conditions = [f"  {line}" for line in describe.condition_lines(function)]
    return [
        f"The {describe.one_line(function.title)}{f', in {unit}' if unit else ''}:",
        "",
        *(f"  {line}" for line in describe.formula_lines(function)),
        "",
        *inputs,
        *(["NaN unless", *conditions] if conditions else []),
        f"{function.operations} operations. The second form computes {result}[0 .. {number} - 1];",
        "its arrays must not overlap.",
    ]


def _harmless(words: str) -> str:
    """Return text that neither ends a comment nor starts one, a trigraph or a spliced line.

    >>> _harmless("a */ b ??/")
    'a * / b ? ?/'
    """
    words = words.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
    return f"{words} ." if words.endswith("\\") else words
