"""A struct of all parameters with the values of the description, and the functions that take it."""

from collections.abc import Iterator, Mapping, Sequence

from ...named import NamedTuple
from ...routine.steps import Function, Input, Routine, programs
from .. import describe
from ..names import Names
from .layout import harmless, wrapped
from .pose import PoseContext
from .reserved import RESERVED


class Field(NamedTuple):
    """A field of the struct, what it means, and the value of the description in C."""

    name: str
    words: str
    value: str


class Taking(NamedTuple):
    """A function that takes the struct: its head, and the call of the one that takes numbers."""

    head: str
    call: str


class ParametersContext(NamedTuple):
    """Fields are what ``c/parameters.jinja`` and ``c/declarations.jinja`` mention."""

    struct: str
    defaults: str
    pointer: str
    fields: list[Field]
    functions: list[Taking]


class Positional(NamedTuple):
    """A function that takes numbers: its type, its name, what it takes and what it fills."""

    kind: str
    name: str
    inputs: Sequence[Input]
    outputs: Sequence[str] = ()


def parameters_context(
    routine: Routine,
    singles: Mapping[str, str],
    poses: Sequence[PoseContext],
    checks: str,
    space: Names,
    arguments: Mapping[str, str],
) -> ParametersContext | None:
    """Return the struct and its functions; None where nothing has a parameter.

    ``singles`` are the functions of results and their statuses at file scope, ``checks`` is that
    of a sheet's conditions.
    """
    inputs = {i.name: i for part in programs(routine) for i in part.inputs}
    if not inputs:
        return None
    listed = [*_of_results(routine.functions, singles), *_of_poses(routine, poses)]
    if routine.checks:
        listed.append(Positional("int", checks, routine.checks.inputs))
    struct, defaults = (space.claim(f"{routine.name}_{end}") for end in ("parameters", "defaults"))
    outputs = (output for each in listed for output in each.outputs)
    pointer = Names(RESERVED, {struct, *(each.name for each in listed), *outputs}).claim("p")
    named = [(each, space.claim(f"{each.name}_of")) for each in listed]
    return ParametersContext(
        struct,
        defaults,
        pointer,
        [_field(item, arguments[item.name]) for item in inputs.values()],
        [_taking(each, name, struct, pointer, arguments) for each, name in named],
    )


def _of_results(functions: Sequence[Function], singles: Mapping[str, str]) -> Iterator[Positional]:
    for function in functions:
        yield Positional("double", singles[function.name], function.inputs)
        if function.status:
            yield Positional("int", singles[function.status.name], function.status.inputs)


def _of_poses(routine: Routine, poses: Sequence[PoseContext]) -> Iterator[Positional]:
    points = routine.points.program if routine.points else None
    given = [program for program in (routine.pose, points) if program]
    for program, pose in zip(given, poses, strict=True):
        yield Positional("int", pose.name, program.inputs, pose.outputs)


def _field(item: Input, name: str) -> Field:
    value = "NAN" if item.default is None else repr(float(item.default))
    return Field(name, harmless(describe.input_words(item, name)), value)


def _taking(
    function: Positional, name: str, struct: str, pointer: str, arguments: Mapping[str, str]
) -> Taking:
    heads = [f"const {struct} *{pointer}", *(f"double *{o}" for o in function.outputs)]
    given = [*(f"{pointer}->{arguments[i.name]}" for i in function.inputs), *function.outputs]
    return Taking(
        wrapped(f"{function.kind} {name}(", heads),
        wrapped(f"return {function.name}(", given, indent=" " * 8),
    )
