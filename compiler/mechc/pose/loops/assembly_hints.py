"""What distinguishes closures: the ``assembly`` lines that hold in one of them only."""

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Protocol

from ...diagnostics import assembly_lines as messages
from ...model.mechanism import Assembly
from ...source import Span
from ..pose import Limit
from ..samples import Values
from ..tolerances import SAME_ANGLE, SAME_DIRECTION, SAME_PLACE
from ..vector_graph import Cycle, NameSet
from .guide_lines import GuideLine


class Loops(Protocol):
    """Loops that close together, a dyad's or those of a larger group."""

    @property
    def cycle(self) -> Cycle:
        """Return the edges of the loops."""
        ...

    @property
    def unknown(self) -> NameSet:
        """Return the unknowns."""
        ...

    @property
    def limit(self) -> Limit | None:
        """Return where closures meet, if that is a function of what is known."""
        ...

    def triples(self) -> Sequence[tuple[str, str, str]]:
        """Return points whose turn may distinguish the closures."""
        ...


AssemblyMeasure = Callable[[Assembly, Values], float | None]
"""Twice the area of three points, or a place along a guide; None where that is open."""

LISTED_CLOSURES = 3
"""Closures that are listed in a line; more are listed in a table, and by so many directions."""


class AssemblyHints:
    """Looks for lines that distinguish the closures of loops."""

    def __init__(
        self,
        group: Loops,
        guide_lines: Mapping[str, GuideLine],
        measure: AssemblyMeasure,
        size: float,
        angles: Collection[str],
    ) -> None:
        """``guide_lines`` are those whose pins the group places, ``angles`` unknown directions.

        ``size`` is the longest side of the loops.
        """
        self._group, self._guide_lines = group, guide_lines
        self._measure, self._size = measure, size
        self._angles = sorted(n for n in group.unknown if n in angles)

    def hint(self, poses: Sequence[Values], drive: str, refuted: bool) -> str:
        """Return the hint on lines to add for a closure, or on what to do where none helps.

        Where the lines given are ``refuted`` it is said what the closures are instead.
        """
        lines = [self._lines(values, poses) for values in poses]
        alike = [p for p, own in zip(poses, lines, strict=True) if lines.count(own) > 1]
        if alike and self._is_one(alike):
            return messages.MEET
        if alike:
            return messages.no_line_decides(self._apart(alike), drive)
        if len(poses) > LISTED_CLOSURES and not refuted:
            return self._table(poses, lines)
        found = [self._described(p, own) for p, own in zip(poses, lines, strict=True)]
        if refuted:
            each = (said or self._shown(p) for p, said in zip(poses, found, strict=True))
            return messages.the_closures([*each])
        return messages.one_of(found)

    def _is_one(self, poses: Sequence[Values]) -> bool:
        """Return whether poses are one, so that it is no matter of lines."""
        names = sorted(self._group.unknown)
        return all(
            abs(math.remainder(p.get(n, 0.0) - poses[0].get(n, 0.0), 2 * math.pi)) < SAME_DIRECTION
            for p in poses
            for n in names
        )

    def _apart(self, poses: Sequence[Values]) -> list[str]:
        """Return each closure by the direction in which the first differs most from another."""

        def gap(name: str) -> float:
            turns = (math.remainder(p[name] - poses[0][name], 2 * math.pi) for p in poses)
            return max(map(abs, turns))

        name = max((n for n in self._angles if n in poses[0]), key=gap, default="")
        return [f"{name} = {_degrees(p[name])}" for p in poses] if name else []

    def _described(self, values: Values, lines: Sequence[str]) -> str:
        """Return the lines that choose a closure, and its angles in degrees."""
        shown, quoted = self._shown(values), " with ".join(f"`{line}`" for line in lines)
        return f"{quoted} ({shown})" if quoted and shown else quoted

    def _table(self, poses: Sequence[Values], lines: Sequence[Sequence[str]]) -> str:
        """Return the hint that lists many closures, with the first of the directions."""
        modes = [{points: mode for _, points, mode in map(str.split, own)} for own in lines]
        angles = [
            {n: f"{math.degrees(math.remainder(p[n], 2 * math.pi)):.4g}" for n in names}
            for p in poses
            for names in ([n for n in self._angles if n in p][:LISTED_CLOSURES],)
        ]
        point = next((triple[1] for triple in self._group.triples()), self._group.cycle[0].head)
        return messages.one_row(point, modes, angles)

    def _shown(self, values: Values) -> str:
        return ", ".join(f"{n} = {_degrees(values[n])}" for n in self._angles if n in values)

    def _lines(self, values: Values, poses: Sequence[Values]) -> list[str]:
        """Return as many lines as distinguish a closure from all others."""
        others, lines = [p for p in poses if p is not values], list[str]()
        for probe in self._probes():
            if not others:
                break
            mine = self._mode(probe, values, poses)
            left = [p for p in others if self._mode(probe, p, poses) == mine]
            if mine and len(left) < len(others):
                lines.append(f"assembly {''.join(probe.points)} {mine}")
                others = left
        return lines

    def _probes(self) -> Iterator[Assembly]:
        span = group_span(self._group)
        for point in self._guide_lines:
            yield Assembly((point,), "forward", span)
        for triple in (*self._group.triples(), *combinations(_points(self._group), 3)):
            yield Assembly(triple, "ccw", span)

    def _mode(self, probe: Assembly, values: Values, poses: Sequence[Values]) -> str:
        """Return the word that fits a closure, '' where the points are in one line."""
        mine = self._measure(probe, values) or 0.0
        if len(probe.points) == 1:
            places = [self._measure(probe, p) or 0.0 for p in poses]
            return "forward" if is_ahead(mine, places, self._size) else "back"
        return "" if mine == 0 else "ccw" if mine > 0 else "cw"


def is_ahead(place: float, places: Sequence[float], size: float) -> bool:
    """Return whether a place is the farthest along the guide; several closures may share it.

    ``size`` is the longest side of the loop: all places may be zero but for rounding.
    """
    known = [p for p in places if not math.isnan(p)]
    return place > max(known) - SAME_PLACE * max(size, *map(abs, known))


def _degrees(angle: float) -> str:
    """Return an angle within a turn; one that is zero but for rounding as 0.

    >>> _degrees(2.7e-16), _degrees(-math.pi / 2 - 4 * math.pi)
    ('0 deg', '-90 deg')
    """
    turned = math.remainder(angle, 2 * math.pi)
    return f"{0.0 if abs(turned) < SAME_ANGLE else math.degrees(turned):.4g} deg"


def _points(group: Loops) -> list[str]:
    """Return the points of the loops, the ground's origin apart."""
    return [p for p in dict.fromkeys(e.tail for e in group.cycle) if p]


def group_span(group: Loops) -> Span:
    """Return the span of that edge of a loop that comes last in the text."""
    return max((e.span for e in group.cycle), key=lambda s: s.start)
