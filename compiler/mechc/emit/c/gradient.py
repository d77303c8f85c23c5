"""Functions that give a result and its slopes by each argument, for one pose and for many."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...base.named import NamedTuple
from ...formula.tree import Call, Formula
from ...formula.walk import walk
from ...routine.functions import operations
from ...routine.gradient import gradients
from ...routine.steps import Function, Input, PoseProgram, formulas_of, mentioned, names_of
from .. import describe
from ..names import TargetNames, mangle
from ..printer import Printer
from .printer import CIRCULAR, CPrinter, QuickPrinter, harmless, wrapped
from .reserved import RESERVED
from .solvers import lines


class GradientContext(NamedTuple):
    """Fields are what ``c/gradient.jinja`` and ``c/declarations.jinja`` mention.

    ``name``, ``inputs`` and ``outputs`` are those of the form for one pose. ``kernel`` is the form
    with the ``quick`` body, which loops call; '' where the plain one serves.
    """

    name: str
    inputs: Sequence[Input]
    outputs: list[str]
    remarks: list[str]
    single: str
    batch: str
    kernel: str
    plain: list[str]
    quick: list[str]
    call: str
    quick_call: str
    value: str
    number: str
    loop: str
    missing: str


def gradient_contexts(
    mechanism: str, functions: Iterable[Function], space: TargetNames, arguments: Mapping[str, str]
) -> list[GradientContext]:
    """Return such a function for each result that has a closed form."""
    return [_context(mechanism, f, p, space, arguments) for f, p in gradients(functions)]


def _context(
    mechanism: str,
    function: Function,
    program: PoseProgram,
    space: TargetNames,
    arguments: Mapping[str, str],
) -> GradientContext:
    """Return the fields of the template of a function with its slopes."""
    single = space.claim(f"{mechanism}_{function.name}_gradient")
    batch, kernel = space.claim(f"{single}_n"), space.claim(f"{single}_quick")
    own = {i.name: arguments[i.name] for i in program.inputs}
    inner = TargetNames(RESERVED, {single, batch, kernel, *own.values()})
    names = own | mangle((n for s in program.steps for n in names_of(s)), inner)
    outputs = {name: inner.claim(f"{names[name]}_out") for name in program.outputs}
    number, loop, missing = map(inner.claim, ("n", "i", "missing"))
    inputs, slots = list(own.values()), list(outputs.values())
    heads = [*(f"double {a}" for a in inputs), *(f"double *{o}" for o in slots)]
    given = ", ".join([*(f"{a}[{loop}]" for a in inputs), *(f"{o} + {loop}" for o in slots)])
    plain, quick = (
        _body(program, printer, outputs, inner)
        for printer in (CPrinter(names), QuickPrinter(names, _formulas(program)))
    )
    return GradientContext(
        name=single,
        inputs=program.inputs,
        outputs=slots,
        remarks=[*map(harmless, _remarks(function, program, own, outputs, number))],
        single=wrapped(f"void {single}(", heads),
        batch=wrapped(f"void {batch}(", _arrays(number, inputs, slots)),
        kernel=wrapped(f"void {kernel}(", heads) if _is_circular(program) else "",
        plain=plain,
        quick=quick,
        call=f"{single}({given})",
        quick_call=f"{kernel}({given})",
        value=f"{outputs[program.outputs[0]]}[{loop}]",
        number=number,
        loop=loop,
        missing=missing,
    )


def _arrays(number: str, inputs: Iterable[str], outputs: Iterable[str]) -> list[str]:
    """Return the parameters of the form for many poses."""
    return [
        f"size_t {number}",
        *(f"const double *MECHC_RESTRICT {a}" for a in inputs),
        *(f"double *MECHC_RESTRICT {o}" for o in outputs),
    ]


def _body(
    program: PoseProgram, printer: Printer, outputs: Mapping[str, str], inner: TargetNames
) -> list[str]:
    """Return the statements of a program, and those that hand its outputs on."""
    statements, _ = lines(program.steps, frozenset(program.outputs), {}, printer, inner)
    used = mentioned(program.steps, ()) | set(program.outputs)
    unused = (printer.names[i.name] for i in program.inputs if i.name not in used)
    given = (f"*{slot} = {printer.names[n]};" for n, slot in outputs.items())
    return [*statements, *given, *(f"(void){name};" for name in unused)]


def _formulas(program: PoseProgram) -> list[Formula]:
    return [f for s in program.steps for f in formulas_of(s)]


def _is_circular(program: PoseProgram) -> bool:
    calls = (part for f in _formulas(program) for part in walk(f))
    return any(isinstance(part, Call) and part.function in CIRCULAR for part in calls)


def _remarks(
    function: Function,
    program: PoseProgram,
    own: Mapping[str, str],
    outputs: Mapping[str, str],
    number: str,
) -> Iterator[str]:
    """Yield the comment above a function with its slopes."""
    value, *slopes = outputs.values()
    yield f"The {describe.one_line(function.title)} and its slopes by each argument."
    yield ""
    yield from (f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in program.inputs)
    yield f"  {value}: {describe.measured_words(function.name, function.dimension)}"
    for slope, item in zip(slopes, program.inputs, strict=True):
        words, unit = f"the slope of {function.name} by {item.name}", function.dimension
        yield f"  {slope}: {describe.measured_words(words, unit.over(item.dimension))}"
    yield from describe.slope_remarks(function)
    yield f"{describe.counted(operations(program.steps))}. The second form computes the elements"
    yield f"0 .. {number} - 1; its arrays must not overlap."
