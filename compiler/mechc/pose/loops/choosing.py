"""Which of two closures is meant: what the user said, decided at the default pose."""

import math
from collections.abc import Collection, Mapping, Sequence

from ...base.named import NamedTuple
from ...diagnostics import MechcError, Report
from ...diagnostics import assembly_lines as closure_messages
from ...diagnostics import open_loops as messages
from ...formula.walk import symbols
from ...model.mechanism import Arrow, Assembly, Mechanism
from ..samples import Values
from ..tolerances import FLAT_TRIANGLE
from ..vector_graph import Cycle, loop_name, points_around
from .assembly_hints import AssemblyHints, Loops, group_span, is_ahead
from .drawn import nearest
from .dyads import Closure
from .guide_lines import GuideLine
from .reach import reach_of
from .state import LoopState, PointSide

Corner = tuple[float, float]


def lengths_around(cycle: Cycle, mechanism: Mechanism) -> list[str]:
    """Return the vectors of a loop whose lengths are given, and are not the drive's.

    Those of a drawing follow from coordinates.
    """
    points, drive = {*points_around(cycle)}, {mechanism.drive_name}
    arrows = [entry for entry in mechanism.geometry if isinstance(entry, Arrow)]
    given = (a for a in arrows if a.length and not drive & symbols(a.length))
    names = [a.tail + a.head for a in given if {a.tail, a.head} <= points]
    return [] if mechanism.drawn else names


class AssemblyChoice:
    """Takes the ``assembly`` lines to the closures that they decide."""

    def __init__(self, state: LoopState, report: Report) -> None:
        self._state, self._report = state, report
        self._unused = list(state.mechanism.assemblies)
        self._in_slots: dict[str, tuple[Assembly, str]] = {}

    @property
    def unused(self) -> tuple[Assembly, ...]:
        """Return the lines that decided nothing."""
        return tuple(self._unused)

    def choose(
        self, closures: Sequence[Closure], group: Loops, within: Collection[str] | None = None
    ) -> Closure:
        """Return the closure that is meant; report where there is none, or none is named.

        Where none is named one is taken for the time being: what is asked for of other loops
        is reported with it. ``within`` are the points of a body that closes by itself: only
        they have places yet.
        """
        state = self._state
        poses = [state.tried(c, state.base) for c in closures]
        possible = [i for i, p in enumerate(poses) if all(map(math.isfinite, p.values()))]
        if not possible:
            raise self._none(closures, group)
        if len(closures) == 1:
            return closures[0]
        possible = _with_lengths(possible, poses, group, state) or possible
        read = AssemblyReading(state, _guide_lines(group, state), _longest_side(group, state.base))
        lines = [a for a in self._unused if within is None or _is_of_shape(a, within)]
        decisive = read.decisive(lines, poses, possible)
        self._unused = [a for a in self._unused if a not in decisive]
        self._note_slots(decisive, group, read)
        meant = [i for i in possible if all(read.holds(a, poses, i) for a in decisive)]
        if len(meant) > 1:
            drawn = nearest(poses, meant, state, within)
            if not decisive and not drawn:
                self._doubt_slots(group, read)
            meant = drawn or (meant if decisive else _ahead(meant, group, poses, state))
        left = meant or possible
        if len(meant) != 1:
            self._report_open(decisive, [poses[i] for i in left], group, read, not meant)
        return closures[left[0]]

    def place(self, closures: Sequence[Closure], group: Loops, chosen: Closure) -> PointSide | None:
        """Return which of two places the closure that was chosen gives a point on its guide.

        None where closures do not differ by that.
        """
        read = AssemblyReading(self._state, _guide_lines(group, self._state), 0.0)
        pins = [pin for pin, line in read.lines.items() if line.length in group.unknown]
        if len(pins) != 1 or len(closures) != 2:
            return None
        (pin,) = pins
        asked = Assembly((pin,), "forward", read.lines[pin].span)
        other = next(closure for closure in closures if closure is not chosen)
        poses = (self._state.tried(closure, self._state.base) for closure in (chosen, other))
        mine, its = (read.measure(asked, pose) for pose in poses)
        if mine is None or its is None or math.isnan(mine - its) or mine == its:
            return None
        return pin, mine > its

    def _note_slots(
        self, decisive: Sequence[Assembly], group: Loops, read: "AssemblyReading"
    ) -> None:
        """Note the pins in slots whose place along them a line has decided, and in which loop."""
        for line in decisive:
            if len(line.points) == 1 and read.lines[line.points[0]].in_slot:
                self._in_slots[line.points[0]] = line, loop_name(group.cycle)

    def _doubt_slots(self, group: Loops, read: "AssemblyReading") -> None:
        """Warn of lines that may be meant of another slot, on the same pin, than they decided."""
        for pin, guide in read.lines.items():
            if guide.in_slot and guide.length in group.unknown and pin in self._in_slots:
                line, loop = self._in_slots[pin]
                other = loop_name(group.cycle)
                message = closure_messages.assembly_of_one_slot(line.span, pin, loop, other)
                self._report.add(message)

    def _none(self, closures: Sequence[Closure], group: Loops) -> MechcError:
        """Return that nothing closes, unless that rests on a closure taken for the time being."""
        self._report.stop_on_errors()
        stretches = reach_of(self._state, closures[0], group.limit)
        drive = self._state.mechanism.drive
        name = drive.parameter if drive else ""
        at, loop = group_span(group), loop_name(group.cycle)
        lengths = lengths_around(group.cycle, self._state.mechanism)
        return self._report.fail(messages.cannot_assemble(at, loop, name, stretches, lengths))

    def _report_open(
        self,
        decisive: Sequence[Assembly],
        poses: Sequence[Values],
        group: Loops,
        read: "AssemblyReading",
        refuted: bool,
    ) -> None:
        """Report that nothing distinguishes the closures at some poses, and what would."""
        drive = self._state.mechanism.drive
        lines = {point: line for point, line in read.lines.items() if line.length in group.unknown}
        hints = AssemblyHints(group, lines, read.measure, read.size, self._state.angles)
        hint = hints.hint(poses, drive.parameter if drive else "", refuted)
        if decisive:
            self._report.stop_on_errors()
            at = decisive[0]
            self._report.add(closure_messages.assembly_undecided(at.span, "".join(at.points), hint))
        else:
            loop, number = loop_name(group.cycle), len(poses)
            self._report.add(closure_messages.closure_open(group_span(group), loop, number, hint))


def _is_of_shape(assembly: Assembly, points: Collection[str]) -> bool:
    """Return whether a line is about the shape that points have, not about places on guides."""
    return len(assembly.points) == 3 and set(assembly.points) <= set(points)


def _with_lengths(
    indices: Sequence[int], poses: Sequence[Values], group: Loops, state: LoopState
) -> list[int]:
    """Return the closures in which no vector has a negative length; places may be negative."""
    places = {line.length for line in state.guide_lines} | state.named
    lengths = group.unknown - state.angles - places
    return [i for i in indices if all(poses[i].get(n, 0.0) >= 0 for n in lengths)]


def _guide_lines(group: Loops, state: LoopState) -> Mapping[str, GuideLine]:
    """Return the line of each pin; of several lines the one along which the group closes."""
    guide_lines = sorted(state.guide_lines, key=lambda line: line.length in group.unknown)
    return {line.pin: line for line in guide_lines}


def _longest_side(group: Loops, values: Values) -> float:
    """Return the longest of the sides of which the length is known."""
    lengths = (arm.length for edge in group.cycle for arm in edge.arms)
    known = (n for n in lengths if symbols(n.formula()) <= values.keys())
    return max((abs(length.evaluate(values)) for length in known), default=0.0)


def _ahead(
    possible: list[int], group: Loops, poses: Sequence[Values], state: LoopState
) -> list[int]:
    """Return the one closure ahead of its guide; else all."""
    ahead = _reaching_ahead(group, poses, state)
    return ahead if len(ahead) == 1 else possible


def _reaching_ahead(group: Loops, poses: Sequence[Values], state: LoopState) -> list[int]:
    """Return the closures in which no length is negative."""
    names = group.unknown - state.angles
    lengths = [[p[n] for n in names if n in p] for p in poses]
    return [i for i, sizes in enumerate(lengths) if sizes and min(sizes) >= 0]


class AssemblyReading(NamedTuple):
    """How ``assembly`` lines are read at poses; a line on a pin along its guide, of ``lines``.

    ``size`` is the longest side of the loops.
    """

    state: LoopState
    lines: Mapping[str, GuideLine]
    size: float

    def decisive(
        self, lines: Sequence[Assembly], poses: Sequence[Values], possible: Sequence[int]
    ) -> list[Assembly]:
        """Return the lines that decide; of several, none that says the same of all closures.

        A pin whose place another line gives as well stands at one place in all of them.
        """
        decisive = [a for a in lines if self._decides(a, poses)]
        separating = [a for a in decisive if self._separates(a, poses, possible)]
        turns = [a for a in decisive if len(a.points) == 3]
        return [*separating, *(a for a in turns if a not in separating)] if separating else decisive

    def _separates(
        self, assembly: Assembly, poses: Sequence[Values], possible: Sequence[int]
    ) -> bool:
        """Return whether a line holds in some closures and not in others."""
        return len({self.holds(assembly, poses, i) for i in possible}) > 1

    def _decides(self, assembly: Assembly, poses: Sequence[Values]) -> bool:
        """Return whether this group is what places the points named."""
        if self.measure(assembly, self.state.base) is not None:
            return False
        return all(self.measure(assembly, p) is not None for p in poses)

    def holds(self, assembly: Assembly, poses: Sequence[Values], i: int) -> bool:
        """Return whether a line holds in one of the poses; a place ahead is so among them."""
        mine = self.measure(assembly, poses[i]) or 0.0
        if assembly.mode in ("ccw", "cw"):
            return mine > 0 if assembly.mode == "ccw" else mine < 0
        others = [self.measure(assembly, p) or 0.0 for p in poses]
        ahead = [is_ahead(place, others, self.size) for place in others]
        return not all(ahead) and ahead[i] == (assembly.mode == "forward")

    def measure(self, assembly: Assembly, values: Values) -> float | None:
        """Return twice the triangle's area, or the place along the guide; None if open."""
        start = self._start(assembly, values)
        if start is None:
            return None
        places = self.state.graph.places(start, values, assembly.points)
        if not set(assembly.points) <= places.keys():
            return None
        corners = [places[point] for point in assembly.points]
        if len(corners) == 3:
            return _doubled_area(*corners)
        ((x, y),) = corners
        along = self.lines[assembly.points[0]].angle.evaluate(values)
        return x * math.cos(along) + y * math.sin(along)

    def _start(self, assembly: Assembly, values: Values) -> str | None:
        """Return a point to measure from: the fixed end of a guide, or the first point."""
        if len(assembly.points) == 3:
            return assembly.points[0]
        line = self.lines.get(assembly.points[0])
        return line.start if line and line.angle.names <= values.keys() else None


def _doubled_area(a: Corner, b: Corner, c: Corner) -> float:
    """Return twice the area of a triangle, counter-clockwise; 0 of one that is flat."""
    (x, y), (u, v) = ((p[0] - a[0], p[1] - a[1]) for p in (b, c))
    area = x * v - y * u
    longest = max(math.hypot(x, y), math.hypot(u, v))
    return 0.0 if abs(area) < FLAT_TRIANGLE * longest**2 else area
