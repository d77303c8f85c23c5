"""Newton's method along a path, for many poses at a time.

What :func:`mechc.formula.newton.follow` does for one pose, correction by correction; poses that
are done wait for the others.
"""

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..formula import newton
from .steps import Solver

Array: TypeAlias = NDArray[np.float64]
Equations: TypeAlias = Callable[[Array, Array], tuple[Array, Array]]
"""Residuals and Jacobian (equations first, poses last) at unknowns and outer symbols."""


def follow(equations: Equations, solver: Solver, outer: Sequence[Array]) -> tuple[Array, Array]:
    """Return the status of every pose, and its unknowns: NaN where the status is not 0."""
    shape = np.broadcast_shapes(*map(np.shape, outer))
    wide = [np.broadcast_to(value, shape) for value in outer]
    known = np.array(wide, dtype=np.float64).reshape(len(outer), int(np.prod(shape)))
    status, found = _follow(equations, solver, known)
    found[:, status != 0] = np.nan
    return status.reshape(shape), found.reshape(len(solver.unknowns), *shape)


def _follow(equations: Equations, solver: Solver, outer: Array) -> tuple[Array, Array]:
    poses = outer.shape[1]
    anchor, start = _beginning(solver, outer)
    scales = np.array([newton.scale(s) for s in solver.start])[:, None]
    status, result = np.full(poses, 2.0), np.full((len(start), poses), np.nan)
    longest = _longest(solver, anchor, outer)
    left = np.flatnonzero(longest)
    base, longest = start[:, left], longest[left]
    found, step = base.copy(), longest
    reached, last = np.zeros(len(left)), np.zeros(len(left))
    for _ in range(solver.corrections):
        aim = reached + step
        residuals, matrix = equations(found, (1.0 - aim) * anchor[:, left] + aim * outer[:, left])
        sign = eliminate(matrix, residuals)
        size = np.sqrt(np.sum(residuals / scales * (residuals / scales), axis=0))
        allowed = np.where(last > 0, newton.CONTRACTION * last, newton.LONGEST)
        good = (sign == solver.side) & (sign != 0) & ((size <= newton.TINY) | (size <= allowed))
        found = np.where(good, found - residuals, base)
        precise = (size <= newton.TINY) | (size * size * size <= newton.ROUNDING * last * last)
        there = good & (precise | ((aim < 1.0) & (size <= newton.ROUGH)))
        last = np.where(good & ~there, size, 0.0)
        base = np.where(there, found, base)
        reached = np.where(there, aim, reached)
        ahead = np.minimum(np.minimum(2 * step, longest), 1.0 - reached)
        step = np.where(there, ahead, np.where(good, step, step / 2))
        solved = there & (aim == 1.0)
        status[left[solved]], result[:, left[solved]] = 0.0, found[:, solved]
        on = ~solved
        left, base, found = left[on], base[:, on], found[:, on]
        reached, step, last, longest = reached[on], step[on], last[on], longest[on]
        if not len(left):
            break
    status[left] = np.where(step < newton.SHORTEST, 1.0, 2.0)
    return status, result


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
