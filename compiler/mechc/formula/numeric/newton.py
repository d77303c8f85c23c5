"""Newton's method along a path: which of several solutions a system's unknowns are.

The outer symbols go from the anchor to their values on a straight line (those that have no
anchor have their values from the outset), in as few steps as Newton's method allows, one for
a turn of up to 1.5 radians. A step is allowed where the corrections shrink at once: then the
theorem of Newton and Kantorovich says that the solution found is the one that the start leads
to (P. Deuflhard, *Newton Methods for Nonlinear Problems*, 2004, ch. 2 and 5). It is halved
where the first correction is long, where the corrections do not shrink to :data:`CONTRACTION`,
or where the determinant changes its sign: solutions that meet where a branch ends have unlike
signs.

Of a system whose end says something (``by_arcs``: that friction jams a mechanism) the rest of a way
on which steps become short is followed by the arc length of the branch (:mod:`.arcs`), and that it
ends is said where a fold was found.

Every target and the interpreter do the same, correction by correction.
"""

import math
from collections.abc import Callable, Sequence
from operator import mul, truediv

from ...base.named import NamedTuple
from .arcs import Arcs
from .elimination import Elimination, Matrix, eliminate, quick
from .newton_status import BRANCH_ENDS, NOT_FOUND, SOLVED, NewtonStatus

Residuals = Callable[[Sequence[float], Sequence[float]], tuple[list[float], Matrix]]
"""Residuals and Jacobian at values of the unknowns and of the outer symbols."""

Bordered = Callable[[Sequence[float], Sequence[float], Sequence[float]], tuple[list[float], Matrix]]
"""Residuals, and slopes by the unknowns and by the share of a way.

At values of the unknowns and of the outer symbols, and at what these change by on the whole way.
"""

CORRECTIONS = 192
"""Corrections of the unknowns altogether, those of steps that are given up among them.

With half as many the way past a place where two branches nearly meet was not found at one pose in
thirty of some triads, be it found at those next to it.
"""

CONTRACTION = 0.4
"""What a correction may be at most, as a part of the one before."""

FIRST_CORRECTION = 0.5
"""What the first correction of a step may be, as a part of :func:`scale`: half a radian.

At a whole radian one step in two thousand passed over the end of a branch of a triad, to
another solution of the same side; at half a radian none did.
"""

WIDEST = 1.5
"""What the outer symbols may change by in one step, as a part of their :func:`scale`."""

FARTHEST = WIDEST * CORRECTIONS
"""A change that no number of corrections would reach."""

SHORTEST_STEP = 2.0**-10
"""Where corrections run out at steps below this part of the path, the branch ends there."""

ARCS_FROM = 2.0**-6
"""Where steps are below this part of a path that is followed by arcs, these lead on faster."""

TINY = 1e-11
"""A correction behind which no other is needed."""

ROUGH_CORRECTION = 1e-2
"""A correction behind which a step that does not end the path may follow."""

GUESSED = 1e-4
"""What takes a guess to the solution that it is all but equal to, at most."""

QUICK_CORRECTIONS = 4
"""Corrections that this takes at most."""

NEGLIGIBLE_CORRECTION = 1e-17
"""Nor is one needed that is expected, from how the last two shrank, to be below this."""


def nearest(angle: float, anchor: float) -> float:
    """Return the angle that whole turns bring nearest to another one.

    >>> nearest(6.25, 0.0) == 6.25 - math.tau, nearest(1.0, 0.5)
    (True, 1.0)
    """
    turns = (angle - anchor) / math.tau + 0.5
    return angle - math.tau * math.floor(turns) if math.isfinite(turns) else angle


def scale(start: float | str | None) -> float:
    """Return the size by which changes are measured of what has this value at the outset.

    A radian for angles; a length of several metres is measured by itself. What has a name
    instead of a number is of order one.
    """
    return 1.0 if start is None or isinstance(start, str) else max(1.0, abs(start) / math.pi)


class Way(NamedTuple):
    """What stays the same on all ways to solutions of a system on one branch.

    ``side`` is the sign of the Jacobian's determinant where the branch is known, ``scales`` are
    those of the unknowns there; with ``along`` it is followed by arcs where steps are short.
    ``solve`` is how the equations are solved.
    """

    equations: Residuals
    side: int
    scales: Sequence[float]
    along: Bordered | None = None
    solve: Elimination = eliminate

    def follow(
        self, anchor: Sequence[float], start: Sequence[float], outer: Sequence[float]
    ) -> tuple[NewtonStatus, tuple[float, ...]]:
        """Return how it went from a solution that is known, and the unknowns where it ended.

        >>> circle = lambda x, p: ([x[0] * x[0] - p[0]], [[2 * x[0]]])
        >>> way = Way(circle, -1, [1.0])
        >>> way.follow([1.0], [-1.0], [4.0])
        (0, (-2.0,))
        >>> way.follow([1.0], [-1.0], [-4.0])[0]
        1
        """
        longest = _longest(anchor, outer)
        if longest == 0.0:
            return NOT_FOUND, tuple(start)
        base, found = list(start), list(start)
        reached, step, last = 0.0, longest, 0.0
        shortest = ARCS_FROM if self.along else 0.0
        for _ in range(CORRECTIONS):
            if step < shortest:
                break
            aim = reached + step
            here = _between(anchor, outer, aim)
            sign, correction = self._correction(found, here)
            size = _norm(correction, self.scales)
            if not (sign == self.side != 0 and _shrinks(size, last)):
                found, step, last = base, step / 2, 0.0
                continue
            found = [x - c for x, c in zip(found, correction, strict=True)]
            if not (_is_precise(size, last) or (aim < 1.0 and size <= ROUGH_CORRECTION)):
                last = size
            elif aim == 1.0:
                return SOLVED, tuple(found)
            else:
                base, reached, last = found, aim, 0.0
                step = min(2 * step, longest, 1.0 - reached)
        if self.along:
            return self._by_arcs(self.along, anchor, start, outer)
        return BRANCH_ENDS if step < SHORTEST_STEP else NOT_FOUND, tuple(base)

    def _by_arcs(
        self,
        along: Bordered,
        anchor: Sequence[float],
        start: Sequence[float],
        outer: Sequence[float],
    ) -> tuple[NewtonStatus, tuple[float, ...]]:
        """Follow the branch by its arc length instead, from the start on, which is exact."""
        changes = [o - a for a, o in zip(anchor, outer, strict=True)]
        arcs = Arcs(
            lambda x, share: along(x, _between(anchor, outer, share), changes),
            quick(len(start) + 1),
        )
        status, found = arcs.follow(start)
        return status, found or tuple(start)

    def beside(self, guess: Sequence[float], outer: Sequence[float]) -> tuple[float, ...] | None:
        """Return the solution that a guess is all but equal to; None where it is not.

        >>> circle = lambda x, p: ([x[0] * x[0] - p[0]], [[2 * x[0]]])
        >>> Way(circle, 1, [1.0]).beside([2.00001], [4.0])
        (2.0,)
        >>> Way(circle, 1, [1.0]).beside([2.1], [4.0])
        """
        found, last = list(guess), GUESSED / CONTRACTION
        for _ in range(QUICK_CORRECTIONS):
            sign, correction = self._correction(found, outer)
            size = _norm(correction, self.scales)
            if not (sign == self.side != 0 and _shrinks(size, last)):
                return None
            found = [x - c for x, c in zip(found, correction, strict=True)]
            if _is_precise(size, last):
                return tuple(found)
            last = size
        return None

    def _correction(
        self, unknowns: Sequence[float], outer: Sequence[float]
    ) -> tuple[int, list[float]]:
        """Return the sign of the Jacobian's determinant, and what Newton's step takes off."""
        residuals, matrix = self.equations(unknowns, outer)
        return self.solve(matrix, residuals), residuals


def _between(anchor: Sequence[float], outer: Sequence[float], share: float) -> list[float]:
    """Return the outer symbols at a share of the way; most stay as they are."""
    rest = 1.0 - share
    return [a if a == o else rest * a + share * o for a, o in zip(anchor, outer, strict=True)]


def side_of(equations: Residuals, unknowns: Sequence[float], outer: Sequence[float]) -> int:
    """Return the sign of the Jacobian's determinant."""
    residuals, matrix = equations(unknowns, outer)
    return eliminate(matrix, residuals)


def _longest(anchor: Sequence[float], outer: Sequence[float]) -> float:
    """Return the longest step, a power of 1/2; 0 where the way is too far or not finite."""
    parts = [(o - a) / scale(a) for a, o in zip(anchor, outer, strict=True)]
    far, step = math.sqrt(sum(part * part for part in parts)), 1.0
    if not far <= FARTHEST:
        return 0.0
    while step * far > WIDEST:
        step /= 2
    return step


def _norm(correction: Sequence[float], scales: Sequence[float]) -> float:
    parts = [*map(truediv, correction, scales)]
    return math.sqrt(sum(map(mul, parts, parts)))


def _shrinks(size: float, last: float) -> bool:
    """Return whether a correction is small enough behind the last one; 0: it is the first."""
    return size <= TINY or size <= (CONTRACTION * last if last > 0 else FIRST_CORRECTION)


def _is_precise(size: float, last: float) -> bool:
    """Return whether the next correction would be below rounding."""
    return size <= TINY or size * size * size <= NEGLIGIBLE_CORRECTION * last * last
