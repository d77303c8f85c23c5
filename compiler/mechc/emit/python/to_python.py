"""Python: one module that needs only NumPy, for floats and arrays alike."""

from collections.abc import Mapping
from typing import NamedTuple

from ...formula.tree import Call, Formula, Number, Power
from ...formula.walk import symbols, walk
from ...routine.steps import Function
from .. import describe
from ..names import Names, mangle
from ..printer import Printer
from ..render import Line, render
from ..target import Compiled, Emitted, Options

_WORDS = """
    False None True and as assert async await break class continue def del elif else except
    finally for from global if import in is lambda nonlocal not or pass raise return try while
    with yield match case type np float print abs all any bin bool bytes chr complex dict dir
    divmod eval exec filter format frozenset hash help hex id input int iter len list map max
    min next object oct open ord pow range repr reversed round set slice sorted str sum super
    tuple vars zip main
"""
RESERVED = frozenset(_WORDS.split())
"""Keywords, the built-ins that a drawing might name, and what the template itself uses."""

_FUNCTIONS = {
    "asin": "np.arcsin",
    "acos": "np.arccos",
    "atan": "np.arctan",
    "atan2": "np.arctan2",
    "min": "np.minimum",
    "max": "np.maximum",
}
_MAY_FAIL = ("asin", "acos", "sqrt", "log", "exp", "tan", "cot", "sec", "csc")


class PythonPrinter(Printer):
    """Prints for NumPy."""

    pi = "np.pi"

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of a NumPy function."""
        return f"{_FUNCTIONS.get(function, f'np.{function}')}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return ``np.power``, which gives NaN where ``**`` on floats would be complex."""
        return f"np.power({base}, {exponent})"


class FunctionContext(NamedTuple):
    """One function of the module."""

    name: str
    arguments: list[str]
    title: str
    unit: str
    formulas: list[str]
    conditions: list[str]
    inputs: list[Line]
    body: list[Line]
    result: str
    quiet: bool
    operations: int


class ModuleContext(NamedTuple):
    """The whole module; fields are what ``python/module.jinja`` mentions."""

    heading: str
    preface: list[str]
    functions: list[FunctionContext]
    main: list[str]


class PythonTarget:
    """``--emit python``."""

    name = "python"
    suffixes = (".py",)

    def emit(self, compiled: Compiled, options: Options) -> tuple[Emitted, ...]:
        """Return the module."""
        return (Emitted(f"{options.stem}.py", render("python/module.jinja", _module(compiled))),)


TARGET = PythonTarget()


def _module(compiled: Compiled) -> ModuleContext:
    routine = compiled.routine
    names = mangle((f.name for f in routine.functions), Names(RESERVED))
    arguments = mangle((i.name for f in routine.functions for i in f.inputs), Names(RESERVED))
    functions = [_function(f, names[f.name], arguments) for f in routine.functions]
    return ModuleContext(
        heading=_quoted(describe.heading(compiled.mechanism)),
        preface=[_quoted(line) for line in _preface(compiled)],
        functions=functions,
        main=[_shown(f, names[f.name], arguments) for f in routine.functions],
    )


def _preface(compiled: Compiled) -> list[str]:
    lines = []
    if compiled.mechanism.source:
        lines.append(f"Source: {describe.one_line(compiled.mechanism.source)}.")
    for line in describe.unchecked(compiled.mechanism, compiled.routine.functions):
        lines.append(f"Not checked here: {line}.")
    return [
        *lines,
        f"Written by mechc {compiled.version}. SI units and radians; floats and arrays alike.",
    ]


def _function(function: Function, name: str, arguments: Mapping[str, str]) -> FunctionContext:
    own = {i.name: arguments[i.name] for i in function.inputs}
    space = Names(RESERVED, set(own.values()))
    result = space.claim(function.name if function.name not in own else "result")
    printer = PythonPrinter(own | mangle((s.name for s in function.steps), space))
    lines = [Line(printer.names[s.name], printer.print(s.formula)) for s in function.steps]
    unit = describe.si_unit(function.dimension)
    return FunctionContext(
        name=name,
        arguments=list(own.values()),
        title=_quoted(describe.one_line(function.title)),
        unit=f", in {unit}" if unit else "",
        formulas=[_quoted(line) for line in describe.formula_lines(function)],
        conditions=[_quoted(line) for line in describe.condition_lines(function)],
        inputs=[
            Line(own[i.name], _quoted(describe.input_words(i, own[i.name])))
            for i in function.inputs
        ],
        body=[*lines, *_returned(function, result, printer)],
        result=result,
        quiet=_may_fail(function),
        operations=function.operations,
    )


def _returned(function: Function, result: str, printer: Printer) -> list[Line]:
    lines = [Line(result, printer.print(function.output))]
    for guard in function.guards:
        lines.append(Line(result, f"np.where({printer.condition(guard)}, {result}, np.nan)"))
    return lines


def _may_fail(function: Function) -> bool:
    """Return whether some input makes a step infinite or undefined, which NumPy remarks upon."""
    formulas = [*(s.formula for s in function.steps), function.output]
    guards = [side for g in function.guards for side in (g.left, g.right)]
    return any(_is_partial(part) for f in (*formulas, *guards) for part in walk(f))


def _is_partial(part: Formula) -> bool:
    match part:
        case Power(_, Number(value)) if value >= 0 and value.denominator == 1:
            return False
        case Power():
            return bool(symbols(part))
        case Call(function, _):
            return function in _MAY_FAIL
        case _:
            return False


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
