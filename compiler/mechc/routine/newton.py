"""Newton's method along a path, for many poses at a time.

What :func:`mechc.formula.numeric.newton.Way.follow` does for one pose, correction by correction;
poses that are done wait for the others.
"""

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..base.named import NamedTuple
from ..formula.numeric import newton
from ..formula.numeric.newton_status import BRANCH_ENDS, NOT_FOUND, SOLVED
from . import arcs
from .arcs import Array, PoseIndices, eliminate
from .steps import Solver


class SolverEquations(Protocol):
    """Residuals and Jacobian (equations first, poses last) at unknowns and outer symbols.

    With what the outer symbols change by on the whole way, slopes by its share as the last column.
    """

    def __call__(
        self, unknowns: Array, known: Array, changes: Array | None = None, /
    ) -> tuple[Array, Array]: ...


def follow(
    equations: SolverEquations, solver: Solver, outer: Sequence[Array]
) -> tuple[Array, Array]:
    """Return the status of every pose, and its unknowns: NaN where it is not solved."""
    shape = np.broadcast_shapes(*map(np.shape, outer))
    wide = [np.broadcast_to(value, shape) for value in outer]
    known = np.array(wide, dtype=np.float64).reshape(len(outer), int(np.prod(shape)))
    for name in solver.turning:
        place = solver.outer.index(name)
        known[place] = _nearest(known[place], solver.anchor[place] or 0.0)
    status, found = _follow(equations, solver, known)
    found[:, status != SOLVED] = np.nan
    return status.reshape(shape), found.reshape(len(solver.unknowns), *shape)


def _nearest(angles: Array, anchor: float) -> Array:
    return angles - np.multiply(math.tau, np.floor((angles - anchor) / math.tau + 0.5))


class _Poses(NamedTuple):
    """The poses on their way: unknowns at the last ``base`` and ``found`` since, poses last.

    ``reached`` is the part of the way at the base, ``step`` the next part, at most the ``longest``;
    ``last`` is the size of the last correction, 0 where there was none since the base.
    """

    base: Array
    found: Array
    reached: Array
    step: Array
    last: Array
    longest: Array

    def only(self, chosen: NDArray[np.bool_]) -> "_Poses":
        """Return some of the poses."""
        return _Poses(*(array[..., chosen] for array in self))


def _follow(equations: SolverEquations, solver: Solver, outer: Array) -> tuple[Array, Array]:
    """Return the status of each pose, and the unknowns of those whose way from the start ends well.

    Poses are columns of ``outer``. ``left`` are the numbers of those still on their way: each
    correction takes all of them on by one, and leaves those that have arrived. Poses whose steps
    get too short, or that are not there in time, go along the branch by its arc length, if the
    solver can do that.
    """
    number = outer.shape[1]
    anchor, start = _beginning(solver, outer)
    status, result = np.full(number, float(NOT_FOUND)), np.full((len(start), number), np.nan)
    longest = _longest(solver, anchor, outer)
    left = np.flatnonzero(longest)
    none = np.zeros(len(left))
    begun = start[:, left]
    poses = _Poses(
        base=begun, found=begun, reached=none, step=longest[left], last=none, longest=longest[left]
    )
    tried = left
    for _ in range(newton.CORRECTIONS):
        if solver.by_arcs is not None:
            is_long = poses.step >= newton.ARCS_FROM
            left, poses = left[is_long], poses.only(is_long)
        if not len(left):
            break
        aim = poses.reached + poses.step
        known = (1.0 - aim) * anchor[:, left] + aim * outer[:, left]
        poses, solved = _corrected(poses, aim, *equations(poses.found, known), solver)
        status[left[solved]], result[:, left[solved]] = SOLVED, poses.found[:, solved]
        left, poses = left[~solved], poses.only(~solved)
    if solver.by_arcs is not None:
        left = tried[status[tried] != SOLVED]
        status[left], result[:, left] = _by_arcs(equations, solver, outer[:, left])
    else:
        status[left] = np.where(poses.step < newton.SHORTEST_STEP, BRANCH_ENDS, NOT_FOUND)
    return status, result


def _by_arcs(equations: SolverEquations, solver: Solver, outer: Array) -> tuple[Array, Array]:
    """Return statuses and unknowns by the arc length of the branch, from the start on."""
    anchor, start = _beginning(solver, outer)

    def sides(poses: PoseIndices, unknowns: Array, share: Array) -> tuple[Array, Array]:
        begin, end = anchor[:, poses], outer[:, poses]
        return equations(unknowns, (1.0 - share) * begin + share * end, end - begin)

    return arcs.follow(sides, start)


def _corrected(
    poses: _Poses, aim: Array, residuals: Array, matrix: Array, solver: Solver
) -> tuple[_Poses, NDArray[np.bool_]]:
    """Return the poses after one correction, and which of them are at the end of their way.

    A correction is good that keeps to the side of the Jacobian and contracts; where one is not,
    the step is halved.
    """
    scales = np.array([newton.scale(s) for s in solver.start])[:, None]
    sign = eliminate(matrix, residuals)
    size = np.sqrt(np.sum(residuals / scales * (residuals / scales), axis=0))
    last = poses.last
    allowed = np.where(last > 0, newton.CONTRACTION * last, newton.FIRST_CORRECTION)
    good = (sign == solver.side) & (sign != 0) & ((size <= newton.TINY) | (size <= allowed))
    precise = (size <= newton.TINY) | (
        size * size * size <= newton.NEGLIGIBLE_CORRECTION * last * last
    )
    there = good & (precise | ((aim < 1.0) & (size <= newton.ROUGH_CORRECTION)))

    found = np.where(good, poses.found - residuals, poses.base)
    reached = np.where(there, aim, poses.reached)
    ahead = np.minimum(np.minimum(2 * poses.step, poses.longest), 1.0 - reached)
    new = _Poses(
        base=np.where(there, found, poses.base),
        found=found,
        reached=reached,
        step=np.where(there, ahead, np.where(good, poses.step, poses.step / 2)),
        last=np.where(good & ~there, size, 0.0),
        longest=poses.longest,
    )
    return new, there & (aim == 1.0)


def _beginning(solver: Solver, outer: Array) -> tuple[Array, Array]:
    """Return outer symbols and unknowns where the way of each pose begins."""
    pairs = zip(solver.anchor, outer, strict=True)
    wide = [end if value is None else np.full_like(end, value) for value, end in pairs]
    anchor = np.array(wide).reshape(outer.shape)
    named = dict(zip(solver.outer, anchor, strict=True))
    poses = outer.shape[1]
    rows = [named[s] if isinstance(s, str) else np.full(poses, s) for s in solver.start]
    return anchor, np.array(rows)


def _longest(solver: Solver, anchor: Array, outer: Array) -> Array:
    """Return the longest step of every pose; 0 where the way is too far or not finite."""
    scales = np.array([newton.scale(a) for a in solver.anchor])[:, None]
    parts = (outer - anchor) / scales
    far = np.sqrt(np.sum(parts * parts, axis=0))
    steps = np.ones_like(far)
    while np.any(wide := (steps * far > newton.WIDEST) & (far <= newton.FARTHEST)):
        steps = np.where(wide, steps / 2, steps)
    return np.where(far <= newton.FARTHEST, steps, 0.0)
