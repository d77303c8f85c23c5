"""Long functions that have most of their steps in common.

Written out each by itself, results that rest on one another (a chain of lets) would make
a file grow with the square of their number. So one function computes all of those that take the
same inputs and hands out their values, and each of them picks its own; of those that take ever
more inputs each calls one that computes less.
"""

from collections.abc import Iterable, Iterator, Sequence

from ..frozen import replace
from ..model.result import FrictionResult
from .chained import GroupProgram, chained
from .functions import Asked, operations
from .scope import Scope
from .steps import Common, Function, names_in

MANY = 8
"""How many times over the same definitions are needed before they are computed together."""

Groups = dict[tuple[str, ...], list[Asked]]


def together(listed: Iterable[Asked], scope: Scope, names: Sequence[str]) -> dict[str, Function]:
    """Return by name those functions that are computed together."""
    groups, left = Groups(), list[Asked]()
    for one in listed:
        if not isinstance(one.result, FrictionResult):
            groups.setdefault(tuple(i.name for i in one.inputs), []).append(one)
    made = dict[str, Function]()
    number = 0
    for group in groups.values():
        if not _repeats(group):
            left += group
            continue
        number += 1
        made.update((f.name, f) for f in _sharing(number, group, scope, names))
    if _repeats(left):
        chain = chained(GroupProgram(left, scope, names), number + 1)
        made.update((f.name, f) for f in chain)
    return made


def _repeats(group: Sequence[Asked]) -> bool:
    """Return whether the same definitions are needed many times over."""
    needed = [{d.name for d in one.result.where} for one in group]
    return sum(map(len, needed)) > MANY * len(set[str]().union(*needed))


def _sharing(
    number: int, group: Sequence[Asked], scope: Scope, names: Sequence[str]
) -> Iterator[Function]:
    program = GroupProgram(group, scope, names)
    used = names_in(list(program.ends))
    inputs = group[0].inputs
    handed = sorted(used - {i.name for i in inputs})
    common, work = Common(number, inputs, program.steps, tuple(handed)), operations(program.steps)
    for one in program.outputs:
        yield replace(program.function(one, program.steps, work), common=common)
