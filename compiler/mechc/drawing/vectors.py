"""Forces and velocities on paper: their symbols, and how large they are."""

import math
from collections.abc import Iterator, Mapping

from ..base.frozen import frozen
from ..figure.figure import Figure, Link, Slide, Torque
from ..figure.tolerances import NO_SPEED
from ..figure.velocities import MotionVelocities
from ..statics.diagrams.diagram import Acting, Diagram, FreeBody
from ..units import UNITS
from .drawing import TextRun
from .lettering import enumerated, lowered, measured, name, times
from .tolerances import NO_FORCE

LETTERS = {"guide": "N", "slot": "N", "contact": "N", "friction": "F"}
"""The symbols of forces of joints, by their kind; others are R."""


FIXED = {"ground": "ground", "branches": "other"}
"""What is no body of the mechanism, and the word that it is called by."""

INCHES = ("in", "ft")
"""Units of lengths in which arms of couples are given, too, with forces in pounds."""

KILO, MEGA = 1e4, 1e7
"""From which largest force on they are in kilonewtons, and in meganewtons."""


def heading(diagram: Diagram, words: Mapping[str, str]) -> tuple[TextRun, ...]:
    """Return under which loads the bodies are, in the words of a language."""
    runs = (*name(diagram.result), TextRun(f", {words['with' if diagram.motion else 'without']}"))
    if diagram.per:
        before, behind = words["per"].split("{load}")
        runs += (TextRun(f", {before}"), *name(diagram.per), *([TextRun(behind)] if behind else []))
    if diagram.trouble:
        return (*runs, TextRun(f": {words.get(diagram.trouble, diagram.trouble)}"))
    acting = (acting for body in diagram.bodies for acting in body.forces)
    if any(one.force is None for one in acting):
        return (*runs, TextRun(f"; {words['undetermined']}"))
    return runs


def in_words(runs: tuple[TextRun, ...]) -> str:
    """Return lettering as plain text."""
    return "".join(run.text for run in runs)


@frozen
class ForceVectors:
    """The forces of one diagram, in the words of a language."""

    figure: Figure
    diagram: Diagram
    words: Mapping[str, str]

    @property
    def largest(self) -> float:
        """Return the size of the largest force."""
        forces = (a.force for body in self.diagram.bodies for a in body.forces if a.force)
        return max((math.hypot(*force) for force in forces), default=0.0) or 1.0

    def pushes(self, acting: Acting) -> bool:
        """Return whether there is a known force that is more than rounding, however small."""
        return math.hypot(*(acting.force or ())) > NO_FORCE * self.largest

    def turns(self, acting: Acting) -> bool:
        """Return whether there is a couple that is more than rounding of the largest moments."""
        return abs(acting.moment) > NO_FORCE * self.largest * self.figure.size

    @property
    def described(self) -> Iterator[FreeBody]:
        """Yield the bodies of the described half, and those that both halves share."""
        yield from (body for body in self.diagram.bodies if not body.twin)

    def called(self, body: str) -> str:
        """Return a body's name by its points, with their primes: B'K is the twin of BK."""
        if body in FIXED:
            return self.words[FIXED[body]]
        for part in self.figure.parts:
            if isinstance(part, Link | Slide) and part.name == body:
                return "".join(part.points)
        return body.replace("-", "")

    def name(self, body: FreeBody, acting: Acting, couple: bool = False) -> tuple[TextRun, ...]:
        """Give the symbol of a force or couple: a load's name, others by their point.

        A couple that is of no point is called after friction, or after the nut of a screw.
        """
        if acting.kind == "load":
            return times(self._part(acting), acting.by)
        letter = "M" if couple else LETTERS.get(acting.kind, "R")
        return (TextRun(letter, italic=True), *enumerated(self._indices(body, acting)))

    def _indices(self, body: FreeBody, acting: Acting) -> Iterator[tuple[TextRun, ...]]:
        """Yield what tells a force from others: friction, its point, what it comes from."""
        of_friction = acting.kind == "friction"
        if of_friction:
            yield (TextRun(self.words["of_friction"]),)
        if acting.point:
            yield name(acting.point)
        elif not of_friction:
            yield self._source(acting, alone=False)
        alike = [a for a in body.forces if _kind(a) == _kind(acting) and a.point == acting.point]
        if len(alike) > 1 and acting.by and acting.point:
            yield self._source(acting, alone=[a.kind for a in alike].count("rope") == 1)

    def _source(self, acting: Acting, *, alone: bool) -> tuple[TextRun, ...]:
        """Return the origin of a force: a body by its points, the one rope there as the rope."""
        if acting.kind == "rope" and alone:
            return (TextRun(self.words["of_rope"]),)
        called = self.called(acting.by)
        return (TextRun(called),) if acting.by in FIXED else name(called)

    def _part(self, acting: Acting) -> float:
        """Return how often a load acts here: twice as 2P, a third where three branches share it."""
        whole = abs(self.diagram.loads.get(acting.by, 0.0))
        size = math.hypot(*(acting.force or ())) if acting.point else abs(acting.moment)
        return size / whole if size and whole else 1.0

    @property
    def unit(self) -> tuple[TextRun, ...]:
        """Return in what forces are measured: newtons or more, or the load that they are per."""
        if not self.diagram.per:
            return (TextRun(self._unit[0], unit=True),)
        return (*name(self.diagram.per), *([TextRun("/m", unit=True)] if self._turning else []))

    @property
    def _unit(self) -> tuple[str, float]:
        """Return the unit of forces and its size: newtons or more, or that of the description."""
        given = self.figure.units.force
        if not given.endswith("N"):
            return given, UNITS[given].size
        if self.largest < KILO:
            return "N", 1.0
        return ("kN", 1e3) if self.largest < MEGA else ("MN", 1e6)

    @property
    def _arm(self) -> tuple[str, float]:
        """Return the unit of the arms of couples and its size: metres, or inches or feet."""
        given = self.figure.units.length
        own = given if given in INCHES and not self._unit[0].endswith("N") else "m"
        return own, UNITS[own].size

    @property
    def measure(self) -> float:
        """Return the size of what forces are measured in."""
        return 1.0 if self.diagram.per else self._unit[1]

    def size(self, acting: Acting) -> tuple[TextRun, ...]:
        """Return how large a force is, in its unit, or in the load that it is per."""
        return self._value(acting, math.hypot(*(acting.force or ())), None, -self._turning)

    def turning(self, acting: Acting) -> tuple[TextRun, ...]:
        """Return how large a couple is."""
        return self._value(acting, abs(acting.moment), self._arm, not self._turning)

    @property
    def _turning(self) -> bool:
        """Return whether the load that sizes are per unit of is a couple."""
        parts = self.figure.parts
        return any(isinstance(p, Torque) and p.name == self.diagram.per for p in parts)

    def _value(
        self, acting: Acting, size: float, by: tuple[str, float] | None, metres: int
    ) -> tuple[TextRun, ...]:
        """Return a size in a unit of forces, or that ``by`` a length, or in units of a load.

        That load itself has none, nor has what depends on lengths that were chosen.
        The quotient of both is in so many ``metres``; an arm is given in millimetres.
        """
        if acting.chosen or (acting.kind == "load" and acting.by == self.diagram.per):
            return ()
        if not self.diagram.per:
            unit, newtons = self._unit
            arm, length = by or ("", 1.0)
            shown = f"{unit}·{arm}" if arm else unit
            return (*measured(size / (newtons * length)), TextRun(shown, unit=True))
        if metres > 0:
            number, unit = (size, "m") if size >= 1.0 else (size * 1e3, "mm")
            return (*measured(number), TextRun(f"{unit}·", unit=True), *name(self.diagram.per))
        times_load = measured(size, of_another=True)
        return (
            *times_load,
            *name(self.diagram.per),
            *([TextRun("/m", unit=True)] if metres else []),
        )


def _kind(acting: Acting) -> str:
    """Return by which letter a force goes; that of friction has an index besides."""
    of_load_or_friction = acting.kind in ("load", "friction")
    return acting.kind if of_load_or_friction else LETTERS.get(acting.kind, "R")


def index(*points: str) -> tuple[TextRun, ...]:
    """Return points as an index."""
    return lowered(run for point in points for run in name(point))


@frozen
class VelocityVectors:
    """The velocities of one motion."""

    velocities: MotionVelocities

    def name(self, *points: str) -> tuple[TextRun, ...]:
        """Return the symbol of a point's velocity, or of that relative to another point."""
        return (TextRun("V", italic=True), *index(*points))

    def spin_name(self, link: str) -> tuple[TextRun, ...]:
        """Return the symbol of a link's angular velocity."""
        return (TextRun("ω", italic=True), *index(link))

    def size(self, speed: float, *of: str) -> tuple[TextRun, ...]:
        """Return how large a speed is that depends on some points; nothing where that is open."""
        per = self.velocities.per
        if of == (per,) or not self.velocities.chosen.isdisjoint(of):
            return ()
        unit = self.name(per) if per else (TextRun("m/s", unit=True),)
        return (*measured(speed, of_another=bool(per)), *unit)

    def spin(self, link: str) -> tuple[TextRun, ...]:
        """Return the angular velocity of a link; nothing where that is open."""
        if link in self.velocities.chosen:
            return ()
        per, spin = self.velocities.per, self.velocities.spins[link]
        least = NO_SPEED * max(map(abs, self.velocities.spins.values()))
        if abs(spin) <= least:
            return (*self.spin_name(link), TextRun(" = 0"))
        unit = (
            (*self.name(per), TextRun("/m", unit=True)) if per else (TextRun("rad/s", unit=True),)
        )
        return (*self.spin_name(link), *measured(spin, of_another=bool(per)), *unit)
