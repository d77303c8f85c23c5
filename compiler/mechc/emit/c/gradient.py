"""Functions that give a result and its slopes by each argument, for one pose and for many."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from ...formula.tree import Call
from ...formula.walk import walk
from ...routine.functions import operations
from ...routine.gradient import gradients
from ...routine.steps import Function, Pose, formulas_of, names_of
from .. import describe
from ..names import Names, mangle
from .layout import harmless, wrapped
from .printer import CIRCULAR, CPrinter, QuickPrinter
from .reserved import RESERVED
from .solvers import lines


class GradientContext(NamedTuple):
    """Fields are what ``c/gradient.jinja`` and ``c/declarations.jinja`` mention.

    ``kernel`` is the form with the ``quick`` body, which loops call; '' where the plain one serves.
    """

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
    mechanism: str, functions: Iterable[Function], space: Names, arguments: Mapping[str, str]
) -> list[GradientContext]:
    """Return such a function for each result that has a closed form."""
    return [_context(mechanism, f, p, space, arguments) for f, p in gradients(functions)]


def _context(
    mechanism: str, function: Function, program: Pose, space: Names, arguments: Mapping[str, str]
) -> GradientContext:
    single = space.claim(f"{mechanism}_{function.name}_gradient")
    batch, kernel = space.claim(f"{single}_n"), space.claim(f"{single}_quick")
    own = {i.name: arguments[i.name] for i in program.inputs}
    inner = Names(RESERVED, {single, batch, kernel, *own.values()})
    names = own | mangle((n for s in program.steps for n in names_of(s)), inner)
    outputs = {name: inner.claim(f"{names[name]}_out") for name in program.outputs}
    number, loop, missing = map(inner.claim, ("n", "i", "missing"))
    heads = [*(f"double {a}" for a in own.values()), *(f"double *{o}" for o in outputs.values())]
    arrays = [
        f"size_t {number}",
        *(f"const double *MECHC_RESTRICT {a}" for a in own.values()),
        *(f"double *MECHC_RESTRICT {o}" for o in outputs.values()),
    ]
    given = [*(f"{a}[{loop}]" for a in own.values()), *(f"{o} + {loop}" for o in outputs.values())]
    called = ", ".join(given)
    results = [f"*{o} = {names[n]};" for n, o in outputs.items()]
    plain, quick = (
        [*lines(program.steps, frozenset(program.outputs), {}, p, inner)[0], *results]
        for p in (CPrinter(names), QuickPrinter(names))
    )
    is_quick = _is_circular(program)
    return GradientContext(
        remarks=[*map(harmless, _remarks(function, program, own, outputs, number))],
        single=wrapped(f"void {single}(", heads),
        batch=wrapped(f"void {batch}(", arrays),
        kernel=wrapped(f"void {kernel}(", heads) if is_quick else "",
        plain=plain,
        quick=quick,
        call=f"{single}({called})",
        quick_call=f"{kernel}({called})",
        value=f"{outputs[program.outputs[0]]}[{loop}]",
        number=number,
        loop=loop,
        missing=missing,
    )


def _is_circular(program: Pose) -> bool:
    calls = (part for s in program.steps for f in formulas_of(s) for part in walk(f))
    return any(isinstance(part, Call) and part.function in CIRCULAR for part in calls)


def _remarks(
    function: Function,
    program: Pose,
    own: Mapping[str, str],
    outputs: Mapping[str, str],
    number: str,
) -> Iterator[str]:
    value, *slopes = outputs.values()
    yield f"The {describe.one_line(function.title)} and its slopes by each argument."
    yield ""
    yield from (f"  {own[i.name]}: {describe.input_words(i, own[i.name])}" for i in program.inputs)
    yield f"  {value}: {function.name}"
    for slope, item in zip(slopes, program.inputs, strict=True):
        yield f"  {slope}: the slope of {function.name} by {item.name}"
    yield from describe.slope_remarks(function)
    yield f"{operations(program.steps)} operations. The second form computes the elements"
    yield f"0 .. {number} - 1; its arrays must not overlap."
