"""Branch points: poses in which the two closures of a loop meet and the drive can go on.

A margin that vanishes there and is positive on either side has its least value at the
pose, so it is the zero of its slope: found to the last bits, where a zero that is only
touched is found to half of them.
"""

from collections.abc import Iterator, Mapping, Sequence

from ...algebra.derivative import depends_openly, derivative
from ...algebra.product import Product
from ...algebra.sums import add
from ...formula.numeric.roots import RealFunction, Root, lowest, roots
from ...formula.walk import symbols
from ...pose.pose import Pose
from ..pose_sweep import PoseSweep
from ..tolerances import SAME_VALUE, TOUCHING_WIDTH, VANISHED_MARGIN
from .stroke import ChangePoint

TOUCHING = 0.25
"""What is left of a margin next to where it is touched, at most: a ninth of a parabola's."""


def branch_points(pose: Pose, along: PoseSweep, grid: Sequence[float]) -> tuple[ChangePoint, ...]:
    """Return the branch points between the first and the last point of a grid, in their order."""
    margins = [(limit.loop, margin) for limit in pose.limits for margin in limit.margins]
    slopes = {
        i: slope for i, (_, m) in enumerate(margins) if (slope := _slope(m, pose)) is not None
    }
    curves = along.inside_together([*(margin for _, margin in margins), *slopes.values()])
    sloping = dict(zip(slopes, curves[len(margins) :], strict=True))
    found = [
        ChangePoint(loop, *root)
        for i, (loop, _) in enumerate(margins)
        for root in _touched(curves[i], sloping.get(i), grid)
    ]
    kept: list[ChangePoint] = []
    for branch in sorted(found, key=lambda b: (b.loop, b.drive)):
        last = kept[-1] if kept else None
        width = SAME_VALUE * (grid[-1] - grid[0])
        if not last or last.loop != branch.loop or branch.drive - last.drive > width:
            kept.append(branch)
    return tuple(sorted(kept, key=lambda b: b.drive))


def _touched(
    margin: RealFunction, slope: RealFunction | None, grid: Sequence[float]
) -> Iterator[Root]:
    size = max((abs(v) for v in map(margin, grid) if v == v), default=0.0)
    for root in _turning(margin, slope, grid):
        if abs(margin(root.x)) <= VANISHED_MARGIN * size:
            yield root


def _turning(
    margin: RealFunction, slope: RealFunction | None, grid: Sequence[float]
) -> Iterator[Root]:
    """Yield where a margin may be least; one that only changes its sign is the end of a loop."""
    if slope is not None:
        yield from roots(slope, grid)
        return
    values = [margin(x) for x in grid]
    for i in range(1, len(grid) - 1):
        before, here, after = values[i - 1 : i + 2]
        if before >= here <= after and here <= TOUCHING * max(before, after):
            x = lowest(margin, grid[i - 1], grid[i + 1])
            yield Root(x, TOUCHING_WIDTH * (grid[-1] - grid[0]))


def _slope(margin: Product, pose: Pose) -> Product | None:
    """Return the derivative of a margin by the drive, None where a rate is not known."""
    names = symbols(margin.formula()) & _moving(pose)
    if not names or not depends_openly(margin, names) or not names <= rates_of(pose).keys():
        return None
    return add(derivative(margin, name) * rates_of(pose)[name] for name in sorted(names))


def rates_of(pose: Pose) -> Mapping[str, Product]:
    """Return the derivatives by the drive of all names that move, the drive's own included."""
    assert pose.mechanism.drive is not None
    return pose.rates or {pose.mechanism.drive.parameter: Product(1)}


def _moving(pose: Pose) -> frozenset[str]:
    assert pose.mechanism.drive is not None
    moving = {pose.mechanism.drive.parameter}
    for name, formula in pose.closing:
        if not moving.isdisjoint(symbols(formula)):
            moving.add(name)
    return frozenset(moving)
