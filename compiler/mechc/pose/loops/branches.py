"""Where in the stroke a group of higher class closes that does not at the default pose.

Newton's method by shortest steps, the drive being an unknown as well, leads to poses
nearby that close; from there each branch is followed to where it turns back.
"""

from collections.abc import Iterator
from random import Random

from ...diagnostics import open_loops as messages
from ...formula.evaluate import numeric
from ...formula.numeric.folds import SolutionCurve
from ...model.values import following
from ...units import ANGLE
from .groups import LoopGroup, draw, rows_of, size_of, system_of
from .reach import limits_of_drive
from .state import LoopState

POSE_STARTS = 60
"""Random starts from which poses that close are looked for."""


def branches(block: LoopGroup, state: LoopState) -> "list[messages.AssemblyRange]":
    """Return the stretches of the drive on which a block closes, empty without a drive."""
    drive = state.mechanism.drive
    if drive is None:
        return []
    parameter = state.mechanism.parameter(drive.parameter)
    low, high = limits_of_drive(state, parameter.dimension)
    found: list[messages.AssemblyRange] = []
    curve = _curve(block, state, drive.parameter, parameter.dimension == ANGLE)
    for unknowns, x in _closed(block, state, curve):
        if low <= x <= high and not any(s.low <= x <= s.high for s in found):
            least, greatest = (curve.end(unknowns, x, goal).x for goal in (low, high))
            found.append(messages.AssemblyRange(least, greatest, parameter.dimension))
    return _joined(found)


def _curve(block: LoopGroup, state: LoopState, drive: str, is_angle: bool) -> SolutionCurve:
    """Return the curve of a group's solutions along the drive."""
    system = system_of(block, state)
    chain = following(state.mechanism, state.definitions)
    given = {n: v for n, v in state.base.items() if n not in chain.names}
    names = [name for name, _ in system.anchor]

    def outer(x: float) -> list[float]:
        values = chain.complete({**given, drive: x})
        return [values[name] for name in names]

    size = size_of(rows_of(block), system.unknowns, state.base)
    scales = [1.0 if n in state.angles else size for n in system.unknowns]
    return SolutionCurve(numeric(system), outer, [*scales, 1.0 if is_angle else size])


def _closed(
    block: LoopGroup, state: LoopState, curve: SolutionCurve
) -> Iterator[tuple[list[float], float]]:
    """Yield poses that close, as unknowns and the drive."""
    assert state.mechanism.drive is not None
    dice, x = Random(state.mechanism.name), state.base[state.mechanism.drive.parameter]
    size = size_of(rows_of(block), sorted(block.unknown), state.base)
    for _ in range(POSE_STARTS):
        start = [draw(name in state.angles, size, dice) for name in sorted(block.unknown)]
        if found := curve.near(start, x):
            yield found


def _joined(stretches: "list[messages.AssemblyRange]") -> "list[messages.AssemblyRange]":
    """Return stretches in order, those that overlap as one."""
    joined: list[messages.AssemblyRange] = []
    for stretch in sorted(stretches, key=lambda s: s.low):
        if joined and stretch.low <= joined[-1].high:
            high = max(stretch.high, joined[-1].high)
            joined[-1] = joined[-1]._replace(high=high)
        else:
            joined.append(stretch)
    return joined
