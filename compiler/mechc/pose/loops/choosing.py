"""Which of two closures is meant: what the user said, decided at the default pose."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Protocol

from ...diagnostics import Report
from ...diagnostics import pose as words
from ...model.mechanism import Assembly
from ...source import Span
from ..nearby import Values
from ..pose import Limit
from .dyads import Closure
from .rails import Rail
from .reach import reach_of
from .state import State
from .web import Cycle, Names, loop_name


class Loops(Protocol):
    """Loops that close together, a dyad's or those of a larger group."""

    @property
    def cycle(self) -> Cycle:
        """Return the edges of the loops."""
        ...

    @property
    def unknown(self) -> Names:
        """Return the unknowns."""
        ...

    @property
    def limit(self) -> Limit | None:
        """Return where closures meet, if that is a function of what is known."""
        ...

    def triples(self) -> Sequence[tuple[str, str, str]]:
        """Return points whose turn may tell the closures apart."""
        ...


FLAT = 1e-9
"""A triangle whose height is below this part of its longest side has no turn."""


class Choice:
    """Takes the ``assembly`` lines to the closures that they decide."""

    def __init__(self, state: State, report: Report) -> None:
        self._state, self._report = state, report
        self._unused = list(state.mechanism.assemblies)
        self._lines: Mapping[str, Rail] = {}

    def choose(
        self, closures: Sequence[Closure], group: Loops, within: Collection[str] | None = None
    ) -> Closure | None:
        """Return the closure that is meant; report where there is none, or none is named.

        ``within`` are the points of a body that closes by itself: only they have places yet.
        """
        base = self._state.base
        poses = [self._state.tried(c, base) for c in closures]
        possible = [i for i, p in enumerate(poses) if all(map(math.isfinite, p.values()))]
        if not possible:
            self._report_none(closures, group)
            return None
        if len(closures) == 1:
            return closures[0]
        possible = self._with_lengths(possible, poses, group) or possible
        self._lines = self._rails_of(group)
        heard = [a for a in self._unused if within is None or set(a.points) <= set(within)]
        decisive = [a for a in heard if self._decides(a, poses, base)]
        self._unused = [a for a in self._unused if a not in decisive]
        meant = [i for i in possible if all(self._holds(a, poses, i) for a in decisive)]
        if not decisive and len(ahead := self._reaching_ahead(group, poses)) == 1:
            meant = ahead
        if len(meant) != 1:
            self._report_open(decisive, poses, group)
            return None
        return closures[meant[0]]

    def warn_of_unused(self) -> None:
        """Warn of lines that decided nothing."""
        for assembly in self._unused:
            self._report.add(words.assembly_idle(assembly.span, "".join(assembly.points)))

    def _rails_of(self, group: Loops) -> Mapping[str, Rail]:
        """Return the line of each pin; of several lines the one along which the group closes."""
        rails = sorted(self._state.rails, key=lambda rail: rail.length in group.unknown)
        return {rail.pin: rail for rail in rails}

    def _with_lengths(
        self, indices: Sequence[int], poses: Sequence[Values], group: Loops
    ) -> list[int]:
        """Return the closures in which no vector has a negative length; places may be negative."""
        places = {rail.length for rail in self._state.rails} | self._state.named
        lengths = group.unknown - self._state.angles - places
        return [i for i in indices if all(poses[i].get(n, 0.0) >= 0 for n in lengths)]

    def _reaching_ahead(self, group: Loops, poses: Sequence[Values]) -> list[int]:
        """Return the closures in which no length is negative."""
        names = group.unknown - self._state.angles
        lengths = [[p[n] for n in names if n in p] for p in poses]
        return [i for i, sizes in enumerate(lengths) if sizes and min(sizes) >= 0]

    def _decides(self, assembly: Assembly, poses: Sequence[Values], before: Values) -> bool:
        """Tell whether this group is what places the points named."""
        if self._measure(assembly, before) is not None:
            return False
        return all(self._measure(assembly, p) is not None for p in poses)

    def _measure(self, assembly: Assembly, values: Values) -> float | None:
        """Return twice the triangle's area, or the place along the guide; None if open."""
        start = self._start(assembly, values)
        places = self._state.web.places(start, values) if start is not None else {}
        if not set(assembly.points) <= places.keys():
            return None
        if len(assembly.points) == 1:
            x, y = places[assembly.points[0]]
            along = self._lines[assembly.points[0]].angle.evaluate(values)
            return x * math.cos(along) + y * math.sin(along)
        (ax, ay), (bx, by), (cx, cy) = (places[p] for p in assembly.points)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        longest = max(math.hypot(bx - ax, by - ay), math.hypot(cx - ax, cy - ay))
        return 0.0 if abs(area) < FLAT * longest**2 else area

    def _start(self, assembly: Assembly, values: Values) -> str | None:
        """Return a point to measure from: the fixed end of a guide, or the first point."""
        if len(assembly.points) == 3:
            return assembly.points[0]
        rail = self._lines.get(assembly.points[0])
        return rail.start if rail and rail.angle.names <= values.keys() else None

    def _holds(self, assembly: Assembly, poses: Sequence[Values], i: int) -> bool:
        mine = self._measure(assembly, poses[i]) or 0.0
        if assembly.mode in ("ccw", "cw"):
            return mine > 0 if assembly.mode == "ccw" else mine < 0
        others = [self._measure(assembly, p) or 0.0 for p in poses]
        ahead = [_is_ahead(place, others) for place in others]
        return not all(ahead) and ahead[i] == (assembly.mode == "forward")

    # --------------------------------------------------------------------------- reports

    def _report_none(self, closures: Sequence[Closure], group: Loops) -> None:
        stretches = reach_of(self._state, closures[0], group.limit)
        drive = self._state.mechanism.drive
        name = drive.parameter if drive else ""
        self._report.add(
            words.cannot_assemble(_span(group), loop_name(group.cycle), name, stretches)
        )

    def _report_open(
        self, decisive: Sequence[Assembly], poses: Sequence[Values], group: Loops
    ) -> None:
        listed = [self._described(group, p, poses) for p in poses]
        if decisive:
            at = decisive[0]
            self._report.add(words.assembly_undecided(at.span, "".join(at.points), listed))
        else:
            self._report.add(words.closure_open(_span(group), loop_name(group.cycle), listed))

    def _described(self, group: Loops, values: Values, poses: Sequence[Values]) -> str:
        """Return the lines that would choose a closure, if any, and its angles in degrees."""
        angles = sorted(n for n in group.unknown if n in self._state.angles)
        shown = ", ".join(f"{n} = {_degrees(values[n])}" for n in angles if n in values)
        lines = " with ".join(f"`{line}`" for line in self._telling(group, values, poses))
        return f"{lines} ({shown})" if lines and shown else lines

    def _telling(self, group: Loops, values: Values, poses: Sequence[Values]) -> list[str]:
        """Return as many lines as it takes to tell a closure from all others."""
        others, lines = [p for p in poses if p is not values], list[str]()
        for probe in self._probes(group):
            if not others:
                break
            mine = self._mode(probe, values, poses)
            left = [p for p in others if self._mode(probe, p, poses) == mine]
            if len(left) < len(others):
                lines.append(f"assembly {''.join(probe.points)} {mine}")
                others = left
        return lines

    def _probes(self, group: Loops) -> Iterator[Assembly]:
        span = _span(group)
        for point, rail in self._lines.items():
            if rail.length in group.unknown:
                yield Assembly((point,), "forward", span)
        for triple in (*group.triples(), *combinations(_points(group), 3)):
            yield Assembly(triple, "ccw", span)

    def _mode(self, probe: Assembly, values: Values, poses: Sequence[Values]) -> str:
        """Return the word that fits a closure."""
        mine = self._measure(probe, values) or 0.0
        if len(probe.points) == 1:
            places = [self._measure(probe, p) or 0.0 for p in poses]
            return "forward" if _is_ahead(mine, places) else "back"
        return "ccw" if mine > 0 else "cw"


def _is_ahead(place: float, places: Sequence[float]) -> bool:
    """Tell whether a place is the farthest along the guide; several closures may share it."""
    known = [p for p in places if not math.isnan(p)]
    return place > max(known) - FLAT * max(map(abs, known))


def _degrees(angle: float) -> str:
    return f"{math.degrees(math.remainder(angle, 2 * math.pi)):.4g} deg"


def _points(group: Loops) -> list[str]:
    """Return the points of the loops, the ground's origin apart."""
    return [p for p in dict.fromkeys(e.tail for e in group.cycle) if p]


def _span(group: Loops) -> Span:
    return max((e.span for e in group.cycle), key=lambda s: s.start)
