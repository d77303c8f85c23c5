"""Where a branch of solutions of a system turns back: the ends of what its drive may be.

The solutions of n equations in n unknowns and one drive are a curve. It is followed by its
arc length, along which nothing is singular where the drive turns back: the tangent has no
part along the drive there (H. B. Keller, *Numerical solution of bifurcation and nonlinear
eigenvalue problems*, 1977). As the drive is stationary at the fold, its value comes out to
the last bits.
"""

import math
from collections.abc import Callable, Sequence

from ...base.named import NamedTuple
from .elimination import eliminate
from .newton import Residuals

STEP, SHORTEST = 0.06, 1e-7
"""Steps along the curve, in radians; lengths are measured in sizes of the mechanism."""

MOST_STEPS = 600
"""Steps after which a curve is given up."""

CROSSING_STEP = 1.5e-3
"""Steps by which a crossing is looked for; solutions are exact to twelve digits so near it."""

STEP_CORRECTIONS = 12

CLOSED = 1e-12
"""A correction behind which a point lies on the curve, and a step behind which it turns back."""

DIFFERENCE = 1e-6
"""By how much the drive is moved to see how equations change with it."""

NEAR_CORRECTIONS = 40
"""Corrections after which no point of the curve is looked for any more."""

CurvePoint = list[float]
"""The unknowns, then the drive, each in its scale."""


class BranchEnd(NamedTuple):
    """The end that a branch reaches; ``turns`` where it turns back, unless something else ends."""

    x: float
    turns: bool


class SolutionCurve:
    """The solutions of equations that hang on a drive."""

    def __init__(
        self,
        equations: Residuals,
        outer: Callable[[float], Sequence[float]],
        scales: Sequence[float],
    ) -> None:
        """``outer`` gives the outer symbols at a value of the drive; ``scales`` has its, last."""
        self._equations, self._outer, self._scales = equations, outer, scales

    def near(self, unknowns: Sequence[float], x: float) -> tuple[list[float], float] | None:
        """Return a point of the curve that Newton's method leads to, by the shortest steps."""
        point = self._scaled([*unknowns, x])
        for _ in range(NEAR_CORRECTIONS):
            gaps, matrix = self._at(point)
            step = _shortest(matrix, gaps)
            if step is None:
                return None
            point = [p - s for p, s in zip(point, step, strict=True)]
            if _norm(step) < CLOSED:
                *found, there = self._plain(point)
                return found, there
        return None

    def end(self, unknowns: Sequence[float], x: float, goal: float) -> BranchEnd:
        """Return where the branch through a point ends on the way to a goal."""
        point = self._scaled([*unknowns, x])
        sense = 1.0 if goal > x else -1.0
        tangent = self._tangent(point, [*([0.0] * len(unknowns)), sense])
        step = STEP
        for _ in range(MOST_STEPS):
            ahead = self._corrected(point, tangent, step) if tangent else None
            turned = self._tangent(ahead, tangent) if ahead and tangent else None
            if not ahead or not tangent or not turned or _dot(turned, tangent) < 0.9:
                step /= 2
                if step < SHORTEST:
                    break
                continue
            if turned[-1] * sense <= 0:
                return BranchEnd(self._turning(point, tangent, step), True)
            if (ahead[-1] * self._scales[-1] - goal) * sense >= 0:
                return BranchEnd(goal, False)
            point, tangent, step = ahead, turned, min(STEP, 1.5 * step)
        return BranchEnd(point[-1] * self._scales[-1], False)

    def crossing(self, unknowns: Sequence[float], x: float, goal: float) -> float | None:
        """Return the drive on the way to a goal where another branch crosses, if one does.

        The determinant changes its sign there while the drive goes on. At the crossing itself
        nothing can be solved for, so it is interpolated from both sides.
        """
        point = self._scaled([*unknowns, x])
        sense = 1.0 if goal > x else -1.0
        tangent = self._tangent(point, [*([0.0] * len(unknowns)), sense])
        here = self._determinant(point)
        while tangent and tangent[-1] * sense > 0 and (goal - self._drive(point)) * sense > 0:
            step, ahead = CROSSING_STEP, self._corrected(point, tangent, CROSSING_STEP)
            while ahead is None and step < 2 * CROSSING_STEP:
                step *= 1.3
                ahead = self._corrected(point, tangent, step)
            if ahead is None:
                return None
            if (there := self._determinant(ahead)) * here <= 0:
                return self._crossed(point, tangent, step * here / (here - there))
            point, tangent, here = ahead, self._tangent(ahead, tangent), there
        return None

    def _crossed(self, point: CurvePoint, tangent: CurvePoint, middle: float) -> float | None:
        """Return the drive where the determinant vanishes, about a step along a tangent."""
        steps = [middle + CROSSING_STEP * part for part in (-5, -4, -3, -2, -1, 1, 2, 3, 4, 5)]
        points = [p for step in steps if (p := self._corrected(point, tangent, step))]
        if len(points) < len(steps):
            return None
        sizes = [self._determinant(p) for p in points]
        return interpolated(sizes, [self._drive(p) for p in points], 0.0)

    def _determinant(self, point: CurvePoint) -> float:
        """Return the determinant by the unknowns."""
        gaps, matrix = self._at(point)
        square = [row[:-1] for row in matrix]
        sign = eliminate(square, gaps)
        return sign * math.prod(abs(row[i]) for i, row in enumerate(square))

    def _drive(self, point: CurvePoint) -> float:
        return point[-1] * self._scales[-1]

    def _turning(self, point: CurvePoint, tangent: CurvePoint, step: float) -> float:
        """Return the drive between two points where the tangent has no part along it."""
        sense, low, high = math.copysign(1.0, tangent[-1]), 0.0, step
        found = point
        while high - low > CLOSED:
            middle = (low + high) / 2
            ahead = self._corrected(point, tangent, middle)
            turned = self._tangent(ahead, tangent) if ahead else None
            if not ahead or not turned:
                break
            found = ahead
            if turned[-1] * sense > 0:
                low = middle
            else:
                high = middle
        return found[-1] * self._scales[-1]

    def _corrected(self, point: CurvePoint, tangent: CurvePoint, step: float) -> CurvePoint | None:
        """Return the point of the curve at a step along a tangent, across which it is sought."""
        start = [p + step * t for p, t in zip(point, tangent, strict=True)]
        found = start
        for _ in range(STEP_CORRECTIONS):
            gaps, matrix = self._at(found)
            across = _dot([f - s for f, s in zip(found, start, strict=True)], tangent)
            right = [*gaps, across]
            if not eliminate([*(list(row) for row in matrix), list(tangent)], right):
                return None
            found = [f - r for f, r in zip(found, right, strict=True)]
            if _norm(right) < CLOSED:
                return found
        return None

    def _tangent(self, point: CurvePoint, before: CurvePoint) -> CurvePoint | None:
        """Return the direction of the curve that goes on from one before it."""
        _, matrix = self._at(point)
        right = [*([0.0] * (len(point) - 1)), 1.0]
        if not eliminate([*matrix, list(before)], right):
            return None
        size = _norm(right)
        return [r / size for r in right]

    def _at(self, point: CurvePoint) -> tuple[list[float], list[list[float]]]:
        """Return the residual of the closure, and its slopes by the unknowns and the drive."""
        *unknowns, x = self._plain(point)
        gaps, matrix = self._equations(unknowns, self._outer(x))
        step = DIFFERENCE * self._scales[-1]
        after, before = (self._equations(unknowns, self._outer(x + s))[0] for s in (step, -step))
        rows = [
            [*(m * s for m, s in zip(row, self._scales, strict=False)), (a - b) / (2 * DIFFERENCE)]
            for row, a, b in zip(matrix, after, before, strict=True)
        ]
        return gaps, rows

    def _scaled(self, plain: Sequence[float]) -> CurvePoint:
        return [p / s for p, s in zip(plain, self._scales, strict=True)]

    def _plain(self, point: CurvePoint) -> list[float]:
        return [p * s for p, s in zip(point, self._scales, strict=True)]


def interpolated(xs: Sequence[float], ys: Sequence[float], x: float) -> float:
    """Return the value at x of the polynomial through points (Neville).

    >>> interpolated([1.0, 2.0, 3.0], [1.0, 4.0, 9.0], 1.5)
    2.25
    """
    row = list(ys)
    for width in range(1, len(xs)):
        for i in range(len(xs) - width):
            low, high = xs[i], xs[i + width]
            row[i] = ((x - high) * row[i] + (low - x) * row[i + 1]) / (low - high)
    return row[0]


def _shortest(matrix: Sequence[Sequence[float]], gaps: Sequence[float]) -> list[float] | None:
    """Return the shortest step that closes gaps of fewer equations than unknowns."""
    right = list(gaps)
    if not all(map(math.isfinite, right)):
        return None
    if not eliminate([[_dot(one, other) for other in matrix] for one in matrix], right):
        return None
    step = [_dot(right, column) for column in zip(*matrix, strict=True)]
    return step if all(map(math.isfinite, step)) else None


def _dot(one: Sequence[float], other: Sequence[float]) -> float:
    return math.fsum(a * b for a, b in zip(one, other, strict=True))


def _norm(vector: Sequence[float]) -> float:
    return math.sqrt(_dot(vector, vector))
