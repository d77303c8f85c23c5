"""The branch of a system's solutions by its arc length, for many poses at a time.

What :mod:`mechc.formula.numeric.arcs` does for one pose, point by point; poses that are done
wait for the others.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..base.named import NamedTuple
from ..formula.numeric import arcs
from ..formula.numeric.newton_status import BRANCH_ENDS, NOT_FOUND, SOLVED

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]
PoseIndices: TypeAlias = NDArray[np.intp]
ArrayEquations: TypeAlias = Callable[[PoseIndices, Array, Array], tuple[Array, Array]]
"""Residuals and their slopes, by the unknowns and last by the share, at values of both.

Equations are first, poses last.
"""


class _Curves(NamedTuple):
    """Where the poses are: the unknowns and the share, the tangent there, and the next arc.

    ``side`` is the sign of the determinant by the unknowns.
    """

    points: Array
    tangents: Array
    arcs: Array
    side: Array

    def only(self, chosen: Flags) -> "_Curves":
        """Return some of the poses."""
        return _Curves(*(array[..., chosen] for array in self))


def follow(sides: ArrayEquations, start: Array) -> tuple[Array, Array]:
    """Return the status of every pose, and its unknowns where it is solved."""
    poses = start.shape[1]
    status, result = np.full(poses, float(NOT_FOUND)), np.full_like(start, np.nan)
    points = np.vstack([start, np.zeros(poses)])
    along = np.zeros_like(points)
    along[-1] = 1.0
    left = np.arange(poses)
    side, tangents = _tangents(sides, left, points, along)
    curves = _Curves(points, tangents, np.full(poses, arcs.FIRST), side)
    left, curves = left[side != 0], curves.only(side != 0)
    for _ in range(arcs.MOST_POINTS):
        curves, here = _ahead(sides, left, curves)
        here, curves = _straight(sides, start, left, here, curves)
        done = here != NOT_FOUND
        status[left[done]], result[:, left[done]] = here[done], curves.points[:-1, done]
        on = ~done & (curves.arcs >= arcs.LEAST)
        left, curves = left[on], curves.only(on)
        if not len(left):
            break
    return status, result


def _ahead(sides: ArrayEquations, poses: PoseIndices, curves: _Curves) -> tuple[_Curves, Array]:
    """Return the next points, and the status: solved at the end, else behind a fold, or on the way.

    On the way, nothing is found yet.
    """
    points, tangents, arc, side = curves
    rest = (1.0 - points[-1]) / tangents[-1]
    is_last = arc >= rest
    length = np.where(is_last, rest, arc)
    ahead = points + length * tangents
    ahead[-1] = np.where(is_last, 1.0, ahead[-1])
    along = np.zeros_like(points)
    along[-1] = 1.0
    across = np.where(is_last, along, tangents)
    is_found, found = _corrected(
        sides,
        poses,
        ahead,
        across,
        arcs.FIRST_CORRECTION_OF_ARC * length,
        np.where(is_last, side, 0),
    )
    there, turned = _tangents(sides, poses, found, tangents)
    is_end = is_found & is_last
    is_within = is_found & (found[-1] <= 1.0)
    cosine = _dot(turned, tangents)
    good = is_within & _goes_on(turned, there, length, cosine, side)
    longer = np.where(cosine >= arcs.EASY, np.minimum(2.0 * arc, arcs.LONGEST), arc)
    is_fold = good & ~is_end & (turned[-1] <= 0.0)
    status = np.where(is_end, SOLVED, np.where(is_fold, BRANCH_ENDS, NOT_FOUND))
    moved = good | is_end
    return (
        _Curves(
            np.where(moved, found, points),
            np.where(good, turned, tangents),
            np.where(good, longer, length / 2.0),
            np.where(good, there, side),
        ),
        status,
    )


def _goes_on(turned: Array, there: Array, length: Array, cosine: Array, side: Array) -> Flags:
    """Return where a curve goes on behind arcs of these lengths, bent no more than they may be.

    It is ``turned`` there, by the angle of a ``cosine``; the determinant has the sign ``there``.
    """
    rises, is_alike = turned[-1] > 0.0, there == side
    close = np.where(rises, arcs.STRAIGHT_COSINE, arcs.FOLDED)
    bent = np.where(is_alike & (rises | (length <= arcs.SHARP)), arcs.ARC_COSINE, close)
    goes_on: Flags = (there != 0) & (rises | is_alike) & (cosine >= bent)
    return goes_on


def _straight(
    sides: ArrayEquations, start: Array, poses: PoseIndices, status: Array, curves: _Curves
) -> tuple[Array, _Curves]:
    """Return statuses and points: behind a fold, of a solution that is found from the start."""
    (folds,) = np.nonzero(status == BRANCH_ENDS)
    if not len(folds):
        return status, curves
    found = np.vstack([start[:, poses[folds]], np.ones(len(folds))])
    along = np.zeros_like(found)
    along[-1] = 1.0
    good, there = np.ones(len(folds), bool), np.zeros(len(folds), bool)
    for _ in range(arcs.FOLD_CORRECTIONS):
        sign, change = _solved(sides, poses[folds], found, along)
        good &= there | (sign != 0)
        found = np.where(good & ~there, found - change, found)
        there |= good & (np.sqrt(_dot(change, change)) <= arcs.TINY)
    is_solution = good & there & (found[-2] > 0.0)
    solved = folds[is_solution]
    points, ends = curves.points.copy(), status.copy()
    points[:, solved], ends[solved] = found[:, is_solution], 0.0
    return ends, curves._replace(points=points)


def _corrected(
    sides: ArrayEquations,
    poses: PoseIndices,
    start: Array,
    across: Array,
    stray: Array,
    side: Array,
) -> tuple[Flags, Array]:
    """Return whether there is a point of the curve next to one, and that point."""
    found, most = start.copy(), stray
    tiny = np.maximum(arcs.TINY, np.where(side == 0, arcs.EXACT_ON_THE_WAY * stray, 0.0))
    good, there = np.ones(len(poses), bool), np.zeros(len(poses), bool)
    for _ in range(arcs.POINT_CORRECTIONS):
        sign, change = _solved(sides, poses, found, across)
        size = np.sqrt(_dot(change, change))
        good &= there | ((sign != 0) & ((size <= arcs.TINY) | (size <= most)))
        found = np.where(good & ~there, found - change, found)
        last = most / arcs.CONTRACTION
        is_precise = (size <= tiny) | (size * size * size <= arcs.ROUNDING * last * last)
        ends = good & ~there & is_precise
        good &= ~ends | (side == 0) | (sign == side)
        there |= ends
        most = arcs.CONTRACTION * size
        if np.all(there | ~good):
            break
    return good & there, found


def _tangents(
    sides: ArrayEquations, poses: PoseIndices, points: Array, before: Array
) -> tuple[Array, Array]:
    """Return the sign of the determinant by the unknowns, and the direction that goes on.

    The sign is 0 where there is no such direction.
    """
    residuals, matrix = _bordered(sides, poses, points, before)
    right = np.zeros_like(residuals)
    right[-1] = 1.0
    sign = eliminate(matrix, right)
    return sign, right / np.sqrt(_dot(right, right))


def _solved(
    sides: ArrayEquations, poses: PoseIndices, points: Array, across: Array
) -> tuple[Array, Array]:
    """Return the signs of the determinants, and the corrections."""
    right, matrix = _bordered(sides, poses, points, across)
    return eliminate(matrix, right), right


def _bordered(
    sides: ArrayEquations, poses: PoseIndices, points: Array, across: Array
) -> tuple[Array, Array]:
    """Return residuals and slopes, and a direction as the last row."""
    unknowns, share = points[:-1], points[-1]
    residuals, matrix = sides(poses, unknowns, share)
    return (
        np.concatenate([residuals, np.zeros((1, len(share)))]),
        np.concatenate([matrix, across[None]]),
    )


def _dot(one: Array, other: Array) -> Array:
    return np.asarray(np.sum(one * other, axis=0))


def eliminate(matrix: Array, right: Array) -> Array:
    """Solve ``matrix · x = right`` in place; return the determinants' signs, 0 for none."""
    size = len(right)
    sign = np.ones(right.shape[1])
    poses = np.arange(right.shape[1])
    for k in range(size):
        best = k + np.argmax(np.abs(matrix[k:, k]), axis=0)
        for array in (matrix, right):
            upper, lower = array[k].copy(), array[best, ..., poses]
            array[k] = np.moveaxis(lower, 0, -1)
            array[best, ..., poses] = np.moveaxis(upper, -1, 0)
        pivot = matrix[k, k]
        sign = np.where(best != k, -sign, sign) * np.where(np.isfinite(pivot), np.sign(pivot), 0.0)
        for i in range(k + 1, size):
            times = matrix[i, k] / pivot
            matrix[i, k + 1 :] -= times * matrix[k, k + 1 :]
            right[i] -= times * right[k]
    for k in reversed(range(size)):
        for j in range(k + 1, size):
            right[k] -= matrix[k, j] * right[j]
        right[k] /= matrix[k, k]
    return sign
