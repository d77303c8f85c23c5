"""C99: a header and a source that C++ reads too, each result for one pose and for many."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from ..algebra.formula import Call, Formula, Pi, walk
from ..diagnostics.diagnostic import MechcError
from ..diagnostics.emission import unspeakable_file_name
from ..routine.steps import Function, Guard
from . import describe
from .names import Names, mangle, transliterate
from .printer import Printer
from .render import Line, render
from .target import Compiled, Emitted, Options

_WORDS = """
    auto break case char const continue default do double else enum extern float for goto if
    inline int long register restrict return short signed sizeof static struct switch typedef
    union unsigned void volatile while _Bool _Complex _Imaginary bool true false complex
    imaginary I alignas alignof asm atomic_cancel atomic_commit atomic_noexcept and and_eq
    bitand bitor catch char8_t char16_t char32_t class co_await co_return co_yield compl concept
    const_cast consteval constexpr constinit decltype delete dynamic_cast explicit export friend
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public
    reflexpr reinterpret_cast requires static_assert static_cast synchronized template this
    thread_local throw try typeid typename typeof typeof_unqual using virtual wchar_t xor xor_eq
    sin cos tan asin acos atan atan2 sqrt hypot fabs exp log pow abs fmin fmax
    size_t ptrdiff_t NULL NAN INFINITY HUGE_VAL EOF errno assert offsetof main
    near far min max small interface unix linux stdin stdout stderr
"""
RESERVED = frozenset(_WORDS.split())
"""Keywords of C and C++, the functions called, and what common headers define as macros."""

LONGEST_LINE = 100

_FUNCTIONS = {"abs": "fabs", "min": "mechc_min", "max": "mechc_max"}
_CHOICES = {"min": "<", "max": ">"}
_OPERATORS = {"=": "=="}


class CPrinter(Printer):
    """Prints for C99."""

    pi = "MECHC_PI"

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of ``math.h``; those of two arguments are nested."""
        name = _FUNCTIONS.get(function, function)
        if len(arguments) > 2:
            *rest, last = arguments
            return f"{name}({self.call(function, rest)}, {last})"
        return f"{name}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return a call of ``pow``."""
        return f"pow({base}, {exponent})"


class FunctionContext(NamedTuple):
    """One function in its two forms; ``call`` is the inner line of the batch's loop."""

    remarks: list[str]
    single: str
    batch: str
    body: list[Line]
    conditions: list[str]
    output: str
    result: str
    number: str
    loop: str
    call: str


class HeaderContext(NamedTuple):
    """Fields are what ``c_header.jinja`` mentions."""

    preface: list[str]
    guard: str
    functions: list[FunctionContext]


class SourceContext(NamedTuple):
    """Fields are what ``c_source.jinja`` mentions; ``header`` is '' in a single file."""

    preface: list[str]
    header: str
    functions: list[FunctionContext]
    pi: bool
    choices: list[Line]


class Symbols(NamedTuple):
    """The linker's names of one function."""

    single: str
    batch: str


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
        return (source, Emitted(header, render("c_header.jinja", context)))


TARGET = CTarget()


def _source(
    compiled: Compiled, functions: list[FunctionContext], preface: list[str], header: str
) -> str:
    parts = [part for f in compiled.routine.functions for g in _formulas(f) for part in walk(g)]
    called = {part.function for part in parts if isinstance(part, Call)}
    choices = [Line(name, sign) for name, sign in _CHOICES.items() if name in called]
    context = SourceContext(preface, header, functions, Pi() in parts, choices)
    return render("c_source.jinja", context)


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
    """Return the linker's names; no batch form may take another function's name."""
    space = Names(RESERVED)
    singles = mangle((f"{mechanism}_{f}" for f in functions), space)
    batches = {f: space.claim(f"{singles[f'{mechanism}_{f}']}_n") for f in functions}
    return {f: Symbols(singles[f"{mechanism}_{f}"], batches[f]) for f in functions}


def _function(function: Function, linked: Symbols, arguments: Mapping[str, str]) -> FunctionContext:
    own = {i.name: arguments[i.name] for i in function.inputs}
    space = Names(RESERVED, set(own.values()))
    printer = CPrinter(own | mangle((s.name for s in function.steps), space.within()))
    outer = Names(RESERVED, {*own.values(), *linked})
    number, loop, result = outer.claim("n"), outer.claim("i"), outer.claim(function.name)
    return FunctionContext(
        remarks=[_harmless(line) for line in _remarks(function, own, number, result)],
        single=_single(linked.single, list(own.values())),
        batch=_batch(linked.batch, list(own.values()), number, result),
        body=[Line(printer.names[s.name], printer.print(s.formula)) for s in function.steps],
        conditions=[_condition(guard, printer) for guard in function.guards],
        output=printer.print(function.output),
        result=result,
        number=number,
        loop=loop,
        call=f"{linked.single}({', '.join(f'{a}[{loop}]' for a in own.values())})",
    )


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


def _condition(guard: Guard, printer: Printer) -> str:
    operator = _OPERATORS.get(guard.operator, guard.operator)
    return f"{printer.print(guard.left)} {operator} {printer.print(guard.right)}"


def _remarks(function: Function, own: Mapping[str, str], number: str, result: str) -> list[str]:
    unit = describe.si_unit(function.dimension)
    inputs = [f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in function.inputs]
    conditions = [f"  {line}" for line in describe.condition_lines(function)]
    return [
        f"The {describe.one_line(function.title)}{f' in {unit}' if unit else ''}:",
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
