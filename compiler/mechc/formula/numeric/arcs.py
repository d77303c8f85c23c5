"""The branch of a system's solutions by its arc length: on to the end of the way, or round a fold.

The solutions of n equations in n unknowns and the share of the way are a curve. Newton's
straight steps (:mod:`.newton`) need the share to grow along it, and become short where the curve
is steep, where another branch comes near, and where it turns back alike: that steps are short
shows nothing of which it is. By its arc length the curve is followed past all three, as only a
crossing of two branches is singular then (H. B. Keller, *Numerical solution of bifurcation and
nonlinear eigenvalue problems*, 1977). With F the equations, x the unknowns and t the share, the
tangent (x', t') solves F_x x' + F_t t' = 0 and goes on from the tangent before it.

What is concluded from what:

- the curve comes to t = 1, and there F = 0, with the sign of the determinant of F_x that it has at
  the point before: it is the solution. Where another branch crossed on the way the sign is not
  that of the start, as of symmetric mechanisms, whose forces need not stay alike;
- of two points of the curve, so close together that their tangents differ by less than an angle
  of :data:`FOLDED`, or of :data:`ARC_COSINE` at a :data:`SHARP` end, and alike in the sign of the
  determinant, one has t' > 0 and the other t' <= 0: between them F_x is singular with
  t' = 0, a fold. From the fold on the share falls: with all of it no solution is on the branch.
  But what is rounded off on the way may have made the fold, where it is all that there is in an
  unknown; so there is none if Newton's method leads straight from the start to a solution with
  all of the share, whatever the sign of the determinant, its last unknown, the size of the whole,
  above zero as at the start;
- neither is found in so many points, or the points come closer together than numbers can tell
  them apart: nothing is concluded.

Every target and the interpreter do the same, point by point.
"""

import math
from collections.abc import Callable, Sequence
from operator import mul

from ...base.named import NamedTuple
from .elimination import Elimination, Matrix, eliminate
from .newton_status import BRANCH_ENDS, NOT_FOUND, SOLVED, NewtonStatus

CurveEquations = Callable[[Sequence[float], float], tuple[list[float], Matrix]]
"""Residuals and their slopes, by the unknowns and last by the share, at values of both."""

MOST_POINTS = 256
"""Points of the curve altogether, those that are not found among them."""

FIRST, LONGEST = 2.0**-6, 0.25
"""Length of the first arc, and of the longest, against unknowns and shares of order one."""

LEAST = 2.0**-30
"""An arc that is shorter leads nowhere: corrections are no longer exact against it."""

ARC_COSINE = 0.9
"""The cosine of the angle by which tangents may differ at the ends of an arc."""

EASY = 0.975
"""The cosine of half that angle: behind an arc that is bent more the next is no longer."""

STRAIGHT_COSINE = 0.99
"""The same where the sign of the determinant changes over an arc: the curve goes straight on.

Along one curve it changes at a crossing alone. An arc that led across to another branch, which
comes near without crossing, is mostly bent, as both branches turn aside there.
"""

FOLDED, SHARP = 0.9999, 2.0**-20
"""The same where the share falls behind an arc, and the length of one to which that does not apply.

Where pressing forces turn round the curve has all but corners. A longer arc led past one of them
to another branch, which seemed to fall, and a mechanism that moves was said to jam.
"""

POINT_CORRECTIONS = 6
"""Corrections of a point at most."""

FOLD_CORRECTIONS = 12
"""Corrections from the start straight to a solution at most, where a fold was found."""

CONTRACTION = 0.4
"""What a correction may be at most, as a part of the one before."""

FIRST_CORRECTION_OF_ARC = 0.5
"""What the first correction may be, as a part of the arc."""

TINY, ROUNDING = 1e-11, 1e-17
"""A correction behind which no other is needed, and one that is expected to be below rounding."""

EXACT_ON_THE_WAY = 1e-2
"""The same on the way, against the first that may be: a point need be exact against its arc alone.

What such a correction leaves is its square, as an arc is bent by less than its length.
"""

ArcPoint = list[float]
"""The unknowns, then the share."""


class Arcs(NamedTuple):
    """A curve of solutions of equations with these sides.

    An arc that leads past the end of the way is halved: from behind it none leads there.
    """

    sides: CurveEquations
    solve: Elimination = eliminate

    def follow(self, start: Sequence[float]) -> tuple[NewtonStatus, tuple[float, ...]]:
        """Return 0 and the solution at the end of the way, 1 behind a fold, else 2.

        The curve of x² = 1 - 2 t turns back at t = 1/2, that of x² = 1 - t/2 does not.

        >>> def parabola(a):
        ...     return Arcs(lambda x, t: ([x[0] * x[0] + a * t - 1.0], [[2 * x[0], a]]))
        >>> parabola(2.0).follow([1.0])
        (1, ())
        >>> status, (x,) = parabola(0.5).follow([1.0])
        >>> status, round(x * x, 12)
        (0, 0.5)
        """
        point, arc = [*start, 0.0], FIRST
        along = [*(0.0 for _ in start), 1.0]
        side, tangent = self._tangent(point, along)
        for _ in range(MOST_POINTS if side else 0):
            rest = (1.0 - point[-1]) / tangent[-1]
            is_last = arc >= rest
            length = rest if is_last else arc
            found = self._ahead(point, tangent, length, (along, side) if is_last else None)
            if found and is_last:
                return SOLVED, tuple(found[:-1])
            there, turned = self._tangent(found, tangent) if found else (0, [])
            cosine = _dot(turned, tangent) if there else 0.0
            if not there or found[-1] > 1.0 or cosine < _least(turned[-1], there == side, length):
                arc = length / 2
                if arc < LEAST:
                    break
            elif turned[-1] <= 0.0:
                straight = self._straight([*start, 1.0], along)
                return (SOLVED, tuple(straight[:-1])) if straight else (BRANCH_ENDS, ())
            else:
                point, tangent, side = found, turned, there
                arc = min(2 * arc, LONGEST) if cosine >= EASY else arc
        return NOT_FOUND, ()

    def _ahead(
        self,
        point: ArcPoint,
        tangent: ArcPoint,
        length: float,
        end: tuple[ArcPoint, int] | None,
    ) -> ArcPoint:
        """Return the point of the curve that an arc leads to; none: [].

        Where the way ends it is sought across the direction of the share, on the side that is
        asked for.
        """
        ahead = [p + length * t for p, t in zip(point, tangent, strict=True)]
        if end is None:
            return self._corrected(ahead, tangent, FIRST_CORRECTION_OF_ARC * length)
        ahead[-1] = 1.0
        along, side = end
        return self._corrected(ahead, along, FIRST_CORRECTION_OF_ARC * length, side)

    def _corrected(
        self, start: ArcPoint, across: ArcPoint, stray: float, side: int = 0
    ) -> ArcPoint:
        """Return the point of the curve next to one, moved square to a direction; none: [].

        The first correction may be so long. If a side is asked for, the point must be on it, and
        is exact.
        """
        found, most, tiny = start, stray, TINY if side else max(TINY, EXACT_ON_THE_WAY * stray)
        for _ in range(POINT_CORRECTIONS):
            change, matrix = self._bordered(found, across)
            sign = self.solve(matrix, change)
            size = math.sqrt(_dot(change, change))
            if not sign or not (size <= TINY or size <= most):
                return []
            found = [f - c for f, c in zip(found, change, strict=True)]
            last = most / CONTRACTION
            if size <= tiny or size * size * size <= ROUNDING * last * last:
                return found if sign == side or not side else []
            most = CONTRACTION * size
        return []

    def _straight(self, found: ArcPoint, along: ArcPoint) -> ArcPoint:
        """Return a solution with all of the share that Newton's method comes to; none: []."""
        for _ in range(FOLD_CORRECTIONS):
            change, matrix = self._bordered(found, along)
            if not self.solve(matrix, change):
                return []
            found = [f - c for f, c in zip(found, change, strict=True)]
            if math.sqrt(_dot(change, change)) <= TINY:
                return found if found[-2] > 0.0 else []
        return []

    def _tangent(self, point: ArcPoint, before: ArcPoint) -> tuple[int, ArcPoint]:
        """Return the direction of the curve that goes on from one before it.

        Before it the sign of the determinant by the unknowns where the share grows along the
        direction; 0 where there is none.
        """
        right, matrix = self._bordered(point, before)
        right = [*(0.0 for _ in right[1:]), 1.0]
        sign = self.solve(matrix, right)
        size = math.sqrt(_dot(right, right)) if sign else 1.0
        return sign, [r / size for r in right]

    def _bordered(self, point: ArcPoint, across: ArcPoint) -> tuple[list[float], Matrix]:
        """Return residuals and slopes, and a direction as the last row."""
        *unknowns, share = point
        residuals, matrix = self.sides(unknowns, share)
        return [*residuals, 0.0], [*matrix, list(across)]


def _least(share: float, is_alike: bool, length: float) -> float:
    """Return the least cosine between the tangents at the ends of an arc, by that at its end."""
    if share > 0.0:
        return ARC_COSINE if is_alike else STRAIGHT_COSINE
    if not is_alike:
        return math.inf
    return ARC_COSINE if length <= SHARP else FOLDED


def _dot(one: Sequence[float], other: Sequence[float]) -> float:
    found: float = sum(map(mul, one, other))
    return found
