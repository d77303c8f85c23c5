"""Grown mechanisms along strokes, by coordinates: Newton's method in small steps.

Nothing but places and the bilinear forms that hold between them. Velocities come from the
same forms, differentiated; loads from their work. Many strokes run at once.
"""

import math
import warnings

import numpy as np

from mechc.routine.evaluate import evaluate

CLOSED = 1e-15
"""A gap below this, in square metres, is closed."""

BENT, STILL = 0.25, 1e-9
"""The part of a step by which a motion may bend in it, and what is none, in metres."""

STEPS = 25
WIDE = {"phi": 0.25, "s": 0.01}
LAX = 1e-9
"""Relative error from which on two numbers differ; poses near a dead centre are left out."""

HARD = 300.0
"""Above this condition a pose is near a dead centre: the reference could take another branch."""


def strokes_of(grown):
    """Return the drives and the cranks along eight strokes, both ways from the default pose."""
    part = np.linspace(0, 1, STEPS)
    ways = [(sense, growth) for growth in (0.0, 0.02, -0.04, 0.06) for sense in (1, -1)]
    drives = [grown.start + sense * WIDE[grown.drive] * part for sense, _ in ways]
    return np.array(drives), np.array([grown.size * (1 + growth * part) for _, growth in ways])


def inputs_of(grown, function):
    """Return the places of these strokes as arguments of a function."""
    drives, cranks = strokes_of(grown)
    given = {grown.drive: drives, "r": cranks}
    return {i.name: given[i.name] for i in function.inputs}


def errors(found, expected):
    """Return by how much a result is off, as a part of itself, where the reference has one."""
    known = np.isfinite(expected)
    return np.abs(found - expected)[known] / np.maximum(np.abs(expected[known]), 0.01)


def refuted(grown, function):
    """Yield where code has another k than the places of a grown mechanism, or none."""
    expected = Strokes(grown).followed(*strokes_of(grown))
    found = np.broadcast_to(evaluate(function, inputs_of(grown, function)), expected.shape)
    error = errors(found, expected)
    if not np.all(error < LAX):
        yield f"{function.name} is off by {np.max(error)} along a stroke"


def conditions(matrices):
    """Return the conditions of matrices; infinite, with a warning, where LAPACK finds none.

    Some builds of it do not converge where others do: the reference then ends a stroke, which
    says nothing of what is compared with it.
    """
    try:
        return np.linalg.cond(matrices)
    except np.linalg.LinAlgError:
        return np.array([_condition(matrix) for matrix in matrices])


def _condition(matrix):
    try:
        return np.linalg.cond(matrix)
    except np.linalg.LinAlgError:
        warnings.warn("the reference found no condition and ends a stroke", stacklevel=3)
        return math.inf


class Strokes:
    """The strokes of one mechanism: columns of drives and cranks, rows of poses."""

    def __init__(self, grown):
        self.grown = grown
        self.index = {p: i for i, p in enumerate(grown.places)}
        self.x0 = np.array(list(grown.places.values()), dtype=float)
        self.loose = [i for p, i in self.index.items() if p not in grown.fixed]
        self.left, self.right = (self._chords(a) for a in (0, 2))
        cross = np.array([[0.0, 1.0], [-1.0, 0.0]])
        self.turned = np.array([cross if f.is_cross else np.eye(2) for f in grown.forms])
        self.values = np.array([f.value for f in grown.forms])
        self.drives = [(i, f.drive) for i, f in enumerate(grown.forms) if f.drive]

    def _chords(self, first):
        """Return the matrix that takes places to the differences in the forms."""
        rows = np.zeros((len(self.grown.forms), len(self.x0)))
        for row, form in zip(rows, self.grown.forms, strict=True):
            row[self.index[form[first]]] -= 1
            row[self.index[form[first + 1]]] += 1
        return rows

    def _run(self, drive, crank):
        """Return the values of the forms at each stroke's drive, and their rates."""
        values = np.tile(self.values, (len(drive), 1))
        rates = np.zeros_like(values)
        for i, kind in self.drives:
            c, s, still = np.cos(drive), np.sin(drive), np.zeros_like(drive)
            values[:, i], rates[:, i] = {
                "cos": (crank * c, -crank * s),
                "sin": (crank * s, crank * c),
                "xx": (drive * drive, 2 * drive),
                "rr": (crank * crank, still),
                "r": (values[:, i] * crank / self.grown.size, still),
            }[kind]
        return values, rates

    def _jacobian(self, x):
        """Return the forms at places x, and their derivatives by the loose points' places."""
        u, w = self.left @ x, np.einsum("fab,sfb->sfa", self.turned, self.right @ x)
        back = np.einsum("fba,sfb->sfa", self.turned, u)
        slopes = (
            self.left[:, :, None] * w[:, :, None, :] + self.right[:, :, None] * back[:, :, None, :]
        )
        return np.sum(u * w, axis=2), slopes[:, :, self.loose].reshape(len(x), len(w[0]), -1)

    def _closed(self, x, values):
        """Return the places by Newton's method, the last Jacobian, and which ones close.

        Its first step goes along the motion. Where what it adds later is no small part of that
        the stroke may have come to another closure: there it is not followed any farther.
        """
        start = ahead = x
        for turn in range(12):
            found, jacobian = self._jacobian(x)
            gap = found - values
            if np.max(np.abs(gap)) < CLOSED / 50:
                break
            jacobian[np.linalg.det(jacobian) == 0] = np.eye(jacobian.shape[1])
            step = np.linalg.solve(jacobian, gap[:, :, None])[:, :, 0]
            x = x.copy()
            x[:, self.loose] -= np.nan_to_num(step).reshape(len(x), -1, 2)
            ahead = ahead if turn else x
        found, jacobian = self._jacobian(x)
        moved, bent = (np.max(np.abs(d), axis=(1, 2)) for d in (ahead - start, x - ahead))
        is_closed = np.max(np.abs(found - values), axis=1) < CLOSED
        return x, jacobian, is_closed & (bent <= BENT * moved + STILL)

    @np.errstate(over="ignore", invalid="ignore")
    def followed(self, drives, cranks):
        """Return k at each pose of each stroke, NaN from where one comes near a dead centre."""
        found = np.full(drives.shape, math.nan)
        for j, (x, v, alive) in enumerate(self.poses(drives, cranks)):
            found[alive, j] = -self._work(x, v)[alive]
        return found

    def poses(self, drives, cranks):
        """Yield places, their rates, and which strokes are still far from a dead centre."""
        x = np.tile(self.x0, (len(drives), 1, 1))
        alive = np.ones(len(drives), bool)
        for j, drive in enumerate(drives.T):
            values, rates = self._run(drive, cranks[:, j])
            x, jacobian, closed = self._closed(x, values)
            sizes = np.linalg.norm(jacobian, axis=2, keepdims=True)
            alive &= closed
            scaled = jacobian / sizes
            scaled[~alive] = np.eye(jacobian.shape[1])
            alive &= conditions(scaled) < HARD
            if not alive.any():
                break
            jacobian[~alive] = np.eye(jacobian.shape[1])
            moved = np.linalg.solve(jacobian, rates[:, :, None])[:, :, 0]
            v = np.zeros_like(x)
            v[:, self.loose] = moved.reshape(len(x), -1, 2)
            yield x, v, alive

    def _work(self, x, v):
        """Return the work of F = 1 for a unit of the drive."""
        kind, p, q, angle = self.grown.work
        d, rate = (a[:, self.index[q]] - a[:, self.index[p]] for a in (x, v))
        size = np.hypot(d[:, 0], d[:, 1])
        match kind:
            case "torque":
                return (d[:, 0] * rate[:, 1] - d[:, 1] * rate[:, 0]) / size**2
            case "pair":
                return np.sum(d * rate, axis=1) / size
        return v[:, self.index[p]] @ (math.cos(angle), math.sin(angle))
