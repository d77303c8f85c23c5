"""A struct of all parameters with the values of the description, and the functions that take it."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from ...base.named import NamedTuple
from ...routine.steps import Function, Input, Routine, inputs_of
from .. import describe
from ..names import TargetNames
from .pose import PoseContext
from .printer import harmless, wrapped
from .reserved import RESERVED

if TYPE_CHECKING:
    from .gradient import GradientContext


class StructField(NamedTuple):
    """A field of the struct, what it means, and the value of the description in C."""

    name: str
    words: str
    value: str


class ByStruct(NamedTuple):
    """A function that takes the struct, or an array of it: its head and its statements."""

    head: str
    body: list[str]


class ParametersContext(NamedTuple):
    """Fields are what ``c/parameters.jinja`` and ``c/declarations.jinja`` mention."""

    struct: str
    defaults: str
    fields: list[StructField]
    functions: list[ByStruct]


class Positional(NamedTuple):
    """A function that takes numbers: its type, its name, what it takes and what it fills.

    What it returns for many poses stands in an array ``returned``.
    """

    kind: str
    name: str
    inputs: Sequence[Input]
    outputs: Sequence[str] = ()
    returned: str = "status"


class Own(NamedTuple):
    """What the functions that take a struct call it, their arguments and what they return."""

    struct: str
    pointer: str
    number: str
    loop: str
    returned: Mapping[str, str]


def parameters_context(
    routine: Routine,
    singles: Mapping[str, str],
    poses: Sequence[PoseContext],
    gradients: "Sequence[GradientContext]",
    checks: str,
    space: TargetNames,
    arguments: Mapping[str, str],
) -> ParametersContext | None:
    """Return the struct and its functions; None where nothing has a parameter.

    ``singles`` are the functions of results and their statuses at file scope, ``checks`` is that
    of a sheet's conditions.
    """
    inputs = inputs_of(routine)
    if not inputs:
        return None
    listed = [*_of_results(routine.functions, singles), *_of_poses(routine, poses)]
    if routine.checks:
        listed.append(Positional("int", checks, routine.checks.inputs))
    listed += (Positional("void", g.name, g.inputs, g.outputs) for g in gradients)
    struct, defaults = (space.claim(f"{routine.name}_{end}") for end in ("parameters", "defaults"))
    named = [(each, *_claimed(each.name, space)) for each in listed]
    taken = {struct, *(name for each, one, many in named for name in (each.name, one, many))}
    own = _own(struct, listed, TargetNames(RESERVED, taken))
    return ParametersContext(
        struct,
        defaults,
        [_field(item, arguments[item.name]) for item in inputs],
        [f for each, one, many in named for f in _taking(each, one, many, own, arguments)],
    )


def _claimed(name: str, space: TargetNames) -> tuple[str, str]:
    """Return the names of the functions that take the struct, and an array of it."""
    return space.claim(f"{name}_of"), space.claim(f"{name}_n_of")


def _own(struct: str, listed: Sequence[Positional], inner: TargetNames) -> Own:
    for output in sorted({output for each in listed for output in each.outputs}):
        inner.claim(output)
    pointer, number, loop = map(inner.claim, ("p", "n", "i"))
    returned = dict.fromkeys(each.returned for each in listed)
    return Own(struct, pointer, number, loop, {name: inner.claim(name) for name in returned})


def _of_results(functions: Sequence[Function], singles: Mapping[str, str]) -> Iterator[Positional]:
    for function in functions:
        name = function.name
        yield Positional("double", singles[name], function.inputs, returned=name)
        if function.status:
            yield Positional("int", singles[function.status.name], function.status.inputs)


def _of_poses(routine: Routine, poses: Sequence[PoseContext]) -> Iterator[Positional]:
    points = routine.points.program if routine.points else None
    given = [program for program in (routine.pose, points) if program]
    for program, pose in zip(given, poses, strict=True):
        yield Positional("int", pose.name, program.inputs, pose.outputs)


def _field(item: Input, name: str) -> StructField:
    value = "NAN" if item.default is None else repr(float(item.default))
    return StructField(name, harmless(describe.input_words(item, name)), value)


def _taking(
    function: Positional, one: str, many: str, own: Own, arguments: Mapping[str, str]
) -> tuple[ByStruct, ByStruct]:
    """Return the functions that take one struct, and an array of them."""
    return _for_one(function, one, own, arguments), _for_many(function, one, many, own)


def _for_one(function: Positional, name: str, own: Own, arguments: Mapping[str, str]) -> ByStruct:
    pointer = own.pointer
    heads = [f"const {own.struct} *{pointer}", *(f"double *{o}" for o in function.outputs)]
    given = [*(f"{pointer}->{arguments[i.name]}" for i in function.inputs), *function.outputs]
    back = "" if function.kind == "void" else "return "
    call = wrapped(f"{back}{function.name}(", given, indent=" " * 8)
    unused = [] if function.inputs else [f"(void){pointer};"]
    return ByStruct(wrapped(f"{function.kind} {name}(", heads), [*unused, f"{call};"])


def _for_many(function: Positional, one: str, name: str, own: Own) -> ByStruct:
    """Return the function of many structures that calls that of one for each."""
    pointer, loop = own.pointer, own.loop
    filled = [f"double *MECHC_RESTRICT {o}" for o in function.outputs]
    call = (
        f"{one}({', '.join([f'{pointer} + {loop}', *(f'{o} + {loop}' for o in function.outputs)])})"
    )
    if function.kind != "void":
        result = own.returned[function.returned]
        filled.append(f"{function.kind} *MECHC_RESTRICT {result}")
        call = f"{result}[{loop}] = {call}"
    heads = [f"size_t {own.number}", f"const {own.struct} *MECHC_RESTRICT {pointer}", *filled]
    body = [
        f"for (size_t {loop} = 0; {loop} < {own.number}; ++{loop}) {{",
        f"    {call};",
        "}",
    ]
    return ByStruct(wrapped(f"void {name}(", heads), body)
