"""Continuation: a system's unknowns where one outer symbol varies, each found from those nearby.

The straight way of :mod:`.newton` to one value of the symbol leads past all values between the
anchor and that one. So the solutions at some of them, the rungs, are found once, each from the one
before it. Any other is all but on the curve through the rungs about it, and else a short way
from the rung before. It is the solution that the whole way leads to, but for rounding, whatever was
asked for before. Where the rungs end the whole way is gone.
"""

import math
from collections.abc import Sequence
from operator import mul, truediv

from ..evaluate import beginning, solver, turned_back, way_of
from ..tree import System
from .elimination import quick
from .newton import Way, scale
from .straight_line import SystemSolver

RUNG = 1 / 32
"""How far apart rungs are, against the symbol's scale: three corrections lead to the next one."""

RUNG_REACH = 8.0
"""How far rungs lead, against that: the corrections of a whole way suffice for more."""

ABOUT = 8
"""So many rungs lead to what lies among them, to eleven digits or more where nothing ends."""

WEIGHTS = [(-1) ** i * math.comb(ABOUT - 1, i) for i in range(ABOUT)]
"""Those of rungs in a polynomial through them: J.-P. Berrut, L. N. Trefethen, Barycentric Lagrange
interpolation, *SIAM Review* 46, 2004."""

KnownSolution = tuple[Sequence[float], Sequence[float]]
"""Values of the outer symbols, and the unknowns there."""


def continued(system: System) -> SystemSolver:
    """Return a system's unknowns as a function of the outer symbols' values, for many of them."""
    return _Continuation(system).at


class _Continuation:
    """The ladder for the last symbol that varied, from the second value of it on."""

    def __init__(self, system: System) -> None:
        self._system, self._directly = system, solver(system)
        self._varied: tuple[int, tuple[float, ...]] | None = None
        self._ladder: _Ladder | None = None

    def at(self, outer: tuple[float, ...]) -> tuple[float, ...]:
        """Return the unknowns; NaN where the branch ends on the way."""
        outer = turned_back(self._system, outer)
        if self._ladder is None or not self._ladder.leads_to(outer):
            self._ladder = self._new(outer)
        return (self._ladder and self._ladder.at(outer)) or self._directly(outer)

    def _new(self, outer: tuple[float, ...]) -> "_Ladder | None":
        """Return the ladder for the one symbol that varies; none if it did not the time before."""
        anchor, start = beginning(self._system, outer)
        moved = [i for i, (a, o) in enumerate(zip(anchor, outer, strict=True)) if a != o]
        if len(moved) != 1:
            return None
        varied, before = (moved[0], _others(outer, moved[0])), self._varied
        self._varied = varied
        if varied != before:
            return None
        way = way_of(self._system)._replace(solve=quick(len(start)))
        return _Ladder(way, (anchor, start), *varied)


def _others(outer: tuple[float, ...], i: int) -> tuple[float, ...]:
    return (*outer[:i], *outer[i + 1 :])


class _Ladder:
    """Solutions at equal distances from the anchor on, numbered from there to either side.

    The symbol that varies stands at one place among all, the ``others`` stay as they are.
    """

    def __init__(
        self, way: Way, first: KnownSolution, varied: int, others: tuple[float, ...]
    ) -> None:
        self._way, self._varied, self._others = way, varied, others
        self._origin = first[0][varied]
        self._step = RUNG * scale(self._origin)
        self._up, self._down = (_Side(way, first, varied, s * self._step) for s in (1, -1))
        self._curves: dict[int, list[tuple[float, ...]]] = {}

    def leads_to(self, outer: tuple[float, ...]) -> bool:
        """Return whether no other symbol has another value than at the anchor."""
        return _others(outer, self._varied) == self._others

    def at(self, outer: tuple[float, ...]) -> tuple[float, ...]:
        """Return the unknowns; none where no rungs lead there."""
        away = (outer[self._varied] - self._origin) / self._step
        before = self._rung(int(away)) if abs(away) <= RUNG_REACH / RUNG else None
        if before is None:
            return ()
        guess = self._guess(away)
        found = self._way.beside(guess, outer) if guess else None
        if found is not None:
            return found
        status, found = self._way.follow(*before, outer)
        return found if status == 0 else ()

    def _rung(self, number: int) -> KnownSolution | None:
        return (self._up if number >= 0 else self._down).rung(abs(number))

    def _guess(self, away: float) -> list[float]:
        """Return where the curve through the rungs about a place leads; nothing next to its end."""
        first = math.floor(away) - ABOUT // 2 + 1
        curves = self._curves_through(first)
        gaps = [away - number for number in range(first, first + ABOUT)]
        if 0 in gaps:
            return [curve[gaps.index(0)] for curve in curves]
        shares = list(map(truediv, WEIGHTS, gaps))
        whole = sum(shares)
        return [sum(map(mul, shares, curve)) / whole for curve in curves]

    def _curves_through(self, first: int) -> list[tuple[float, ...]]:
        """Return each unknown at the rungs from one on."""
        if first not in self._curves:
            rungs = [self._rung(number) for number in range(first, first + ABOUT)]
            found = [rung[1] for rung in rungs if rung]
            self._curves[first] = [*zip(*found, strict=True)] if len(found) == ABOUT else []
        return self._curves[first]


class _Side:
    """The rungs to one side, as many as were needed."""

    def __init__(self, way: Way, first: KnownSolution, varied: int, step: float) -> None:
        self._way, self._varied, self._rungs = way, varied, [first]
        self._origin, self._step = first[0][varied], step
        self._ends = False

    def rung(self, number: int) -> KnownSolution | None:
        """Return a rung, each found from the one before; None where the branch does not lead."""
        while len(self._rungs) <= number and not self._ends:
            self._grow()
        return self._rungs[number] if number < len(self._rungs) else None

    def _grow(self) -> None:
        """Add the next rung if the branch leads there."""
        last, unknowns = self._rungs[-1]
        outer = list(last)
        outer[self._varied] = self._origin + len(self._rungs) * self._step
        status, found = self._way.follow(last, unknowns, outer)
        if status == 0:
            self._rungs.append((outer, found))
        else:
            self._ends = True
