"""Continuation: a system's unknowns where one outer symbol varies, each found from one nearby.

The straight way of :mod:`.newton` to one value of the symbol leads past all values between the
anchor and that one. So the solutions at some of them, the rungs, are found once, each from the one
before it, and any other is a short way from the rung before. It is the solution that the whole way
leads to, but for rounding, whatever was asked for before. Where the rungs end the whole way is
gone.
"""

from collections.abc import Sequence

from .evaluate import beginning, solver, way_of
from .newton import Way, scale
from .straight_line import Solution
from .tree import System

RUNG = 1 / 32
"""How far apart rungs are, against the symbol's scale: three corrections lead to the next one."""

FAR = 8.0
"""How far rungs lead, against that: the corrections of a whole way suffice for more."""

Known = tuple[Sequence[float], Sequence[float]]
"""Values of the outer symbols, and the unknowns there."""


def continued(system: System) -> Solution:
    """Return a system's unknowns as a function of the outer symbols' values, for many of them."""
    return _Continuation(system).at


class _Continuation:
    """Ladders for the last symbol that varied, one to either side of its anchor."""

    def __init__(self, system: System) -> None:
        self._system, self._directly = system, solver(system)
        self._varied: tuple[int, tuple[float, ...]] | None = None
        self._ladders: dict[bool, _Ladder] = {}

    def at(self, outer: tuple[float, ...]) -> tuple[float, ...]:
        """Return the unknowns; NaN where the branch ends on the way."""
        anchor, start = beginning(self._system, outer)
        moved = [i for i, (a, o) in enumerate(zip(anchor, outer, strict=True)) if a != o]
        if len(moved) != 1 or self._is_new(moved[0], outer):
            return self._directly(outer)
        i, origin = moved[0], anchor[moved[0]]
        if not abs(outer[i] - origin) <= FAR * scale(origin):
            return self._directly(outer)
        side = outer[i] > origin
        if side not in self._ladders:
            self._ladders[side] = _Ladder(way_of(self._system), (anchor, start), i, side)
        return self._ladders[side].at(outer) or self._directly(outer)

    def _is_new(self, i: int, outer: tuple[float, ...]) -> bool:
        """Return whether another symbol varies than before, or the others have other values."""
        varied = i, (*outer[:i], *outer[i + 1 :])
        if varied == self._varied:
            return False
        self._varied, self._ladders = varied, {}
        return True


class _Ladder:
    """Solutions at equal distances from the anchor on, as many as were needed."""

    def __init__(self, way: Way, first: Known, varied: int, upwards: bool) -> None:
        self._way, self._varied, self._rungs = way, varied, [first]
        self._origin = first[0][varied]
        self._step = (RUNG if upwards else -RUNG) * scale(self._origin)
        self._ends = False

    def at(self, outer: Sequence[float]) -> tuple[float, ...]:
        """Return the unknowns, found from the last rung before; none where no rungs lead there."""
        number = int((outer[self._varied] - self._origin) / self._step)
        while len(self._rungs) <= number and not self._ends:
            self._grow()
        if len(self._rungs) <= number:
            return ()
        status, found = self._way.follow(*self._rungs[number], outer)
        return found if status == 0 else ()

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
