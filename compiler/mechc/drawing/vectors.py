"""Forces and velocities on paper: their symbols, and how large they are."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping

from ..figure.figure import Figure, Link, Slide, Torque
from ..figure.tolerances import NO_SPEED
from ..figure.velocities import Velocities
from ..frozen import frozen
from ..statics.diagram import Acting, Diagram, FreeBody
from .drawing import Run
from .lettering import measured, name

LEAST = 0.004
"""A force below this part of the largest is nothing."""

LETTERS = {"guide": "N", "slot": "N", "contact": "N", "friction": "T"}
"""The symbols of forces of joints, by their kind; others are R."""


FIXED = {"ground": "ground", "branches": "other"}
"""What is no body of the mechanism, and the word that it is called by."""

KILO, MEGA = 1e4, 1e7
"""From which largest force on they are in kilonewtons, and in meganewtons."""


def heading(diagram: Diagram, words: Mapping[str, str]) -> tuple[Run, ...]:
    """Return under which loads the bodies are, in the words of a language."""
    runs = (*name(diagram.result), Run(f", {words[diagram.motion or 'without']}"))
    if diagram.per:
        before, behind = words["per"].split("{load}")
        runs += (Run(f", {before}"), *name(diagram.per), *([Run(behind)] if behind else []))
    if not diagram.trouble:
        return runs
    return (*runs, Run(f": {words.get(diagram.trouble, diagram.trouble)}"))


def in_words(runs: tuple[Run, ...]) -> str:
    """Return lettering as plain text."""
    return "".join(run.text for run in runs)


@frozen
class Forces:
    """The forces of one diagram, in the words of a language."""

    figure: Figure
    diagram: Diagram
    words: Mapping[str, str]

    @property
    def largest(self) -> float:
        """Return the size of the largest force."""
        forces = (a.force for body in self.diagram.bodies for a in body.forces if a.force)
        return max((math.hypot(*force) for force in forces), default=0.0) or 1.0

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

    def name(self, body: FreeBody, acting: Acting, couple: bool = False) -> tuple[Run, ...]:
        """Give the symbol of a force or couple: a load's name, others by their point.

        A couple that is of no point is called after friction, or after the nut of a screw.
        """
        if acting.kind == "load":
            return name(acting.by)
        letter = LETTERS.get(acting.kind, "R")
        if couple and not acting.point:
            index = letter if acting.kind == "friction" else in_words(name(acting.by))
            return Run("M", italic=True), Run(index, level=-1)
        same = Counter((LETTERS.get(a.kind, "R"), a.point) for a in body.forces if a.kind != "load")
        index = in_words(name(acting.point))
        if same[letter, acting.point] > 1:
            index = ",".join(filter(None, (index, self.called(acting.by))))
        shown = "M" if couple else letter
        return (Run(shown, italic=True), *([Run(index, level=-1)] if index else []))

    @property
    def unit(self) -> tuple[Run, ...]:
        """Return in what forces are measured: newtons or more, or the load that they are per."""
        if not self.diagram.per:
            return (Run(self._newtons[0], unit=True),)
        return (*name(self.diagram.per), *([Run("/m", unit=True)] if self._turning else []))

    @property
    def _newtons(self) -> tuple[str, float]:
        """Return the unit of forces in newtons, and its size."""
        if self.largest < KILO:
            return "N", 1.0
        return ("kN", 1e3) if self.largest < MEGA else ("MN", 1e6)

    @property
    def measure(self) -> float:
        """Return the size of what forces are measured in."""
        return 1.0 if self.diagram.per else self._newtons[1]

    def size(self, acting: Acting) -> tuple[Run, ...]:
        """Return how large a force is, in newtons or more, or in the load that it is per."""
        return self._value(acting, math.hypot(*(acting.force or ())), self._turning, "", -1)

    def turning(self, acting: Acting) -> tuple[Run, ...]:
        """Return how large a couple is."""
        return self._value(acting, abs(acting.moment), not self._turning, "\u2009m", 1)

    @property
    def _turning(self) -> bool:
        """Return whether the load that sizes are per unit of is a couple."""
        parts = self.figure.parts
        return any(isinstance(p, Torque) and p.name == self.diagram.per for p in parts)

    def _value(
        self, acting: Acting, size: float, scaled: bool, by: str, metres: int
    ) -> tuple[Run, ...]:
        """Return a size in newtons, or that ``by`` a length, or in units of a load.

        That load itself has none, nor has what depends on lengths that were chosen.
        ``scaled`` where the quotient of both has a dimension, of so many ``metres``.
        """
        if acting.chosen or (acting.kind == "load" and acting.by == self.diagram.per):
            return ()
        if not self.diagram.per:
            unit, newtons = self._newtons
            return (*measured(size / newtons), Run(f"{unit}{by}", unit=True))
        length = {(True, -1): "/m", (True, 1): "\u2009m"}.get((scaled, metres), "")
        number = measured(size, of_another=True)
        return (*number, *name(self.diagram.per), *([Run(length, unit=True)] if length else []))


def index(*points: str) -> Run:
    """Return points as an index."""
    return Run("".join(run.text for point in points for run in name(point)), level=-1)


@frozen
class Speeds:
    """The velocities of one motion."""

    velocities: Velocities

    def name(self, *points: str) -> tuple[Run, ...]:
        """Return the symbol of a point's velocity, or of that relative to another point."""
        return Run("V", italic=True), index(*points)

    def spin_name(self, link: str) -> tuple[Run, ...]:
        """Return the symbol of a link's angular velocity."""
        return Run("ω", italic=True), index(link)

    def size(self, speed: float, *of: str) -> tuple[Run, ...]:
        """Return how large a speed is that depends on some points; nothing where that is open."""
        per = self.velocities.per
        if of == (per,) or not self.velocities.chosen.isdisjoint(of):
            return ()
        unit = self.name(per) if per else (Run("m/s", unit=True),)
        return (*measured(speed, of_another=bool(per)), *unit)

    def spin(self, link: str) -> tuple[Run, ...]:
        """Return the angular velocity of a link; nothing where that is open."""
        if link in self.velocities.chosen:
            return ()
        per, spin = self.velocities.per, self.velocities.spins[link]
        least = NO_SPEED * max(map(abs, self.velocities.spins.values()))
        if abs(spin) <= least:
            return (*self.spin_name(link), Run(" = 0"))
        unit = (*self.name(per), Run("/m", unit=True)) if per else (Run("rad/s", unit=True),)
        return (*self.spin_name(link), *measured(spin, of_another=bool(per)), *unit)
