"""Definitions that closing made and nothing needs in the end."""

from collections.abc import Iterable, Iterator, Mapping

from ..algebra.product import Product
from ..base.frozen import replace
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Mechanism
from .pose import Pose
from .vector_graph import mentioned, names_in


def pruned(pose: Pose) -> Pose:
    """Return the pose with only those definitions that it rests on, in their order.

    A direction that turned out to be a known one leaves its triangle behind, which need not
    have a value where the loop lies flat. Rates count as needed, where the name does, and what
    a loop finds that may fail to close and that nothing else shows to have closed, and by which
    it is seen that it closes.
    """
    if not pose.definitions:
        return pose
    formulas = {d.name: d.formula for d in pose.definitions}
    used = set[str]()
    _reach(_names(pose), used, formulas, pose.rates)
    for loop in pose.loops:
        shown = loop.names if loop.names.isdisjoint(used) else symbols(loop.margin)
        _reach(shown, used, formulas, pose.rates)
    return replace(pose, definitions=tuple(d for d in pose.definitions if d.name in used))


def _reach(
    names: Iterable[str],
    used: set[str],
    formulas: Mapping[str, Formula],
    rates: Mapping[str, Product],
) -> None:
    """Add to the used definitions those that names lead to, those of their rates included."""
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name in used or name not in formulas:
            continue
        used.add(name)
        waiting.extend(symbols(formulas[name]))
        if name in rates:
            waiting.extend(names_in(rates[name]))


def _names(pose: Pose) -> Iterator[str]:
    """Yield the names that vectors and directions mention, and those the description asks for."""
    vectors = [v for frame in pose.frames.values() for v in frame.values()]
    for vector in (*vectors, *(contact.reach for contact in pose.contacts)):
        yield from mentioned(vector)
    angles = [*pose.guides.values(), *pose.lines.values(), *pose.slides.values()]
    for angle in (*angles, *(contact.normal for contact in pose.contacts)):
        yield from angle.names
    if pose.axis is not None:
        yield from pose.axis.names
    yield from (parameter.name for parameter in pose.mechanism.parameters)
    for formula in _formulas(pose.mechanism):
        yield from symbols(formula)


def _formulas(mechanism: Mechanism) -> Iterator[Formula]:
    yield from (load.tie for load in mechanism.loads if load.tie)
    yield from (let.value for let in mechanism.lets)
    yield from (expect.value for expect in mechanism.expects)
    for require in mechanism.requires:
        yield from (require.left, require.right)
