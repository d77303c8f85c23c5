"""The ends of what can be assembled, where a loop that is closed by iteration comes to its own.

Newton's method gives up a hair before the fold at which two solutions meet; the curve of
solutions is followed to the fold itself. Where the curve does not turn back there, another
one crosses it: a branch point, at which the drive can go on and the loop in two ways.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial

from ...base.named import NamedTuple
from ...formula.evaluate import evaluate, numeric, solution
from ...formula.numeric.folds import SolutionCurve
from ...formula.tree import Formula, Implicit, System
from ...model.values import Chain, following
from ...pose.pose import Pose
from ...units import LENGTH
from ..pose_sweep import PoseSweep
from ..tolerances import LEAST_LENGTH, STEP_BACK

Outer = Callable[[float], Sequence[float]]
"""The outer symbols of a system at a value of the drive."""


class LastValue(NamedTuple):
    """The last value that can be reached, and the loop that another branch crosses there."""

    x: float
    crossed: str = ""


def end_of_branch(pose: Pose, along: PoseSweep, edge: float, range_: float) -> LastValue:
    """Return where a loop turns back, or another branch crosses it, beyond an edge.

    ``range_`` is the length of the stroke, negative where there are poses after the edge.
    The edge itself is returned where neither happens.
    """
    inside, goal = edge - STEP_BACK * range_, edge + STEP_BACK * range_
    loops = [limit.loop for limit in pose.limits if limit.group == "system"]
    for (system, outer), loop in zip(_systems(pose, along), loops, strict=False):
        start = solution(system, tuple(outer(inside)))
        scales = [*_scales(system, start, pose), 1.0 if _turns(pose) else abs(range_)]
        curve = SolutionCurve(numeric(system), outer, scales)
        end = curve.end(start, inside, goal)
        if end.turns and (end.x - goal) * range_ < 0:
            return LastValue(end.x)
        if (crossing := curve.crossing(start, inside, goal)) is not None:
            return LastValue(crossing, loop)
    return LastValue(edge)


def _systems(pose: Pose, along: PoseSweep) -> Iterator[tuple[System, Outer]]:
    """Yield each system with its outer symbols along the drive."""
    before: dict[str, Formula] = {}
    for name, formula in pose.definitions:
        if isinstance(formula, Implicit) and not any(_solves(f, formula) for f in before.values()):
            chain = following(pose.mechanism, before.items())
            yield formula.system, partial(_outer, formula, chain, along)
        before[name] = formula


def _solves(known: Formula, formula: Implicit) -> bool:
    return isinstance(known, Implicit) and known.system == formula.system


def _outer(formula: Implicit, chain: Chain, along: PoseSweep, x: float) -> list[float]:
    values = chain.complete(along.given(x))
    return [evaluate(argument, values) for argument in formula.arguments]


def _scales(system: System, start: Sequence[float], pose: Pose) -> list[float]:
    """Return a radian for each unknown angle, and for each unknown length what it is."""
    named = {p.name for p in pose.mechanism.parameters if p.dimension == LENGTH}
    lengths = [name in named or name.startswith("len_") for name in system.unknowns]
    return [
        max(abs(s), LEAST_LENGTH) if length else 1.0
        for s, length in zip(start, lengths, strict=True)
    ]


def _turns(pose: Pose) -> bool:
    assert pose.mechanism.drive is not None
    drive = pose.mechanism.drive.parameter
    return all(p.dimension != LENGTH for p in pose.mechanism.parameters if p.name == drive)
