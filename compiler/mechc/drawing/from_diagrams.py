"""From free bodies to their diagrams: each body cut free, the forces on it to scale."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from ..figure.figure import Figure, Link, Slide, Slider, Telescope, Torque
from ..frozen import frozen, replace
from ..pose.places import NOWHERE, Plane
from ..statics.diagram import Acting, Diagram, FreeBody
from . import symbols
from .arrange import below_each_other, in_rows
from .bodies import link, slide
from .drawing import AXIS, FORCE, SYMBOL, Arc, Drawing, Label, Run, Shape
from .labels import Around, Beside
from .lettering import SIZE, box, name
from .paper import Paper, on_paper
from .sheet import Layer, Sheet
from .symbols import off

LARGEST, LEAST = 24.0, 0.004
"""The length of the largest force in millimetres; one below this part of it is nothing."""

SHORTEST = 3.0
"""The length of an arrow is never less than this, in millimetres."""

VISIBLE = 0.3
"""A friction circle with a smaller radius than this, in millimetres, is not drawn."""

AT_PINS = ("pin", "ground")
"""Where the couple of friction shifts the force off its point; elsewhere it is a couple."""

LETTERS = {"guide": "N", "slot": "N", "contact": "N", "friction": "T"}
"""What forces of joints are called by their kind; others are R."""


WORDS: Mapping[str, str] = {
    "without": "without friction",
    "tightening": "with friction, tightening",
    "releasing": "with friction, releasing",
    "per": "forces per unit of {load}",
}
"""What stands above the bodies, of the forces on them."""


def free_bodies(
    figure: Figure, diagrams: Sequence[Diagram], words: Mapping[str, str] = WORDS
) -> Drawing | None:
    """Return the free-body diagrams of the described half, for every set of loads if any.

    ``words`` are those of a language.
    """
    if not diagrams:
        return None
    paper = on_paper(figure)
    torques = frozenset(p.name for p in figure.parts if isinstance(p, Torque))
    drawn = [
        _Maker(paper, diagram, _heading(diagram, words), diagram.per in torques).drawing()
        for diagram in diagrams
    ]
    title = f"Free bodies of {figure.title or figure.name}"
    about = _description(diagrams, figure.mirror is not None)
    return replace(below_each_other(drawn), title=title, description=about)


def _description(diagrams: Sequence[Diagram], halves: bool) -> str:
    bodies = "Every body of one mirrored half" if halves else "Every body"
    heads = "; ".join(_heading(diagram, WORDS) for diagram in diagrams)
    return f"{bodies} cut free, with the forces on it: {heads}."


def _heading(diagram: Diagram, words: Mapping[str, str]) -> str:
    friction = words[diagram.motion or "without"]
    per = f", {words['per'].format(load=diagram.per)}" if diagram.per else ""
    trouble = f": none, {diagram.trouble}" if diagram.trouble else ""
    return f"{diagram.result}, {friction}{per}{trouble}"


@frozen
class _Maker:
    """One set of loads; where sizes are per unit of a load, ``turning`` if that is a couple."""

    paper: Paper
    diagram: Diagram
    heading: str
    turning: bool

    def drawing(self) -> Drawing:
        """Return a heading over all bodies."""
        heading = _line_of_text(self.heading)
        bodies = [self._body(body) for body in self._described()]
        return below_each_other([heading, in_rows(bodies)]) if bodies else heading

    def _described(self) -> Iterator[FreeBody]:
        """Yield the bodies of the described half, and those that both halves share."""
        names = {body.name for body in self.diagram.bodies}
        for body in self.diagram.bodies:
            if not (body.name.endswith("'") and body.name[:-1] in names):
                yield body

    def _body(self, body: FreeBody) -> Drawing:
        sheet = Sheet()
        sheet.draw(Layer.BODIES, self._shapes(body))
        for acting in body.forces:
            self._draw_force(sheet, body, acting)
        for point in dict.fromkeys(a.point for a in body.forces if a.point):
            at = self.paper.at(point)
            sheet.name(Around(at, name(point), SYMBOL, math.pi / 2, symbols.PIN))
        return sheet.finished("", "")

    def _shapes(self, body: FreeBody) -> Iterator[Shape]:
        """Yield the body, and its pins."""
        for part in self.paper.figure.parts:
            match part:
                case Link() if part.name == body.name:
                    yield from link(self.paper, part)
                case Slide() if part.name == body.name:
                    yield from slide(self.paper, part)
                case Telescope() if part.name == body.name:
                    yield from symbols.cylinder(*map(self.paper.at, part.points))
                case Slider() if body.kind == "slider" and part.point == body.name:
                    yield symbols.block(self.paper.at(part.point), part.along)
                case _:
                    pass
        for point in dict.fromkeys(a.point for a in body.forces if a.point and a.kind != "load"):
            yield symbols.pin(self.paper.at(point))

    # ------------------------------------------------------------------ forces

    def _draw_force(self, sheet: Sheet, body: FreeBody, acting: Acting) -> None:
        if acting.force is None:
            unknown = (*self._name(body, acting), Run(" = ?"))
            sheet.name(Around(self._place(body, acting), unknown, FORCE, 0.0, symbols.PIN))
            return
        size, unit = math.hypot(*acting.force), acting.force.unit()
        pushes = bool(acting.point) and unit is not None and size > LEAST * self._largest
        if pushes and unit is not None:
            self._draw_arrow(sheet, body, acting, unit)
        turns = abs(acting.moment) > LEAST * self._largest * self.paper.figure.size
        if turns and not (pushes and acting.kind in AT_PINS):
            self._draw_couple(sheet, body, acting)

    def _draw_arrow(self, sheet: Sheet, body: FreeBody, acting: Acting, unit: Plane) -> None:
        """Draw a force along its line of action, which touches the friction circle."""
        size = math.hypot(*(acting.force or NOWHERE))
        radius = (acting.offset or 0.0) * self.paper.scale if acting.kind in AT_PINS else 0.0
        at = self.paper.at(acting.point)
        length = max(SHORTEST, LARGEST * size / self._largest)
        gap = symbols.PIN + symbols.GAP
        ways = [(off(at, unit, d, -radius), off(at, unit, d + length, -radius))
                for d in (gap, -gap - length)]  # fmt: skip
        tail, tip = min(ways, key=lambda way: sheet.occupied.crossings(*way))
        if abs(radius) > VISIBLE:
            sheet.draw(Layer.PINS, [Arc(at, abs(radius), AXIS)])
            reach = off(at, unit, -gap - length, -radius), off(at, unit, gap + length, -radius)
            sheet.draw(Layer.AXES, [symbols.line(*reach, AXIS)])
        sheet.draw(Layer.LOADS, symbols.arrow(tail, tip))
        value = self._value(acting, size, self.turning, "N", -1)
        sheet.name(Beside(tail, tip, (*self._name(body, acting), *value), FORCE))

    def _draw_couple(self, sheet: Sheet, body: FreeBody, acting: Acting) -> None:
        at = self._place(body, acting)
        start = math.pi / 2
        sheet.draw(Layer.LOADS, symbols.couple(at, start, acting.moment > 0))
        value = self._value(acting, abs(acting.moment), not self.turning, "N\u2009m", 1)
        runs = (*self._name(body, acting, couple=True), *value)
        outside = at.plus(Plane(0.0, symbols.COUPLE + 1))
        sheet.name(Around(outside, runs, FORCE, start))

    @property
    def _largest(self) -> float:
        """Return the size of the largest force."""
        forces = (a.force for body in self.diagram.bodies for a in body.forces if a.force)
        return max((math.hypot(*force) for force in forces), default=0.0) or 1.0

    def _place(self, body: FreeBody, acting: Acting) -> Plane:
        """Return where a force or couple is: at its point, or in the middle of the body."""
        if acting.point:
            return self.paper.at(acting.point)
        points = [self.paper.at(a.point) for a in body.forces if a.point]
        total = NOWHERE
        for at in points:
            total = total.plus(at)
        return total.times(1 / max(len(points), 1))

    # ------------------------------------------------------------------- names

    def _name(self, body: FreeBody, acting: Acting, couple: bool = False) -> tuple[Run, ...]:
        """Return what a force or couple is called: a load by its name, others by their point."""
        if acting.kind == "load":
            return name(acting.by)
        letter = LETTERS.get(acting.kind, "R")
        same = Counter((LETTERS.get(a.kind, "R"), a.point) for a in body.forces if a.kind != "load")
        index = "".join(run.text for run in name(acting.point))
        if same[letter, acting.point] > 1:
            index = f"{index},{self._called(acting.by)}"
        shown = "M" if couple else letter
        return (Run(shown, italic=True), *([Run(index, level=-1)] if index else []))

    def _called(self, body: str) -> str:
        """Return a body's name by its points, with their primes: B'K is the twin of BK."""
        for part in self.paper.figure.parts:
            if isinstance(part, Link | Slide) and part.name == body:
                return "".join(part.points)
        return body

    def _value(
        self, acting: Acting, size: float, scaled: bool, unit: str, metres: int
    ) -> tuple[Run, ...]:
        """Return a size in newtons or newton metres, or in units of the load that it is per.

        That load itself has none, nor has what depends on lengths that were chosen.
        ``scaled`` tells that the quotient of both has a dimension, of so many ``metres``.
        """
        if acting.chosen or (acting.kind == "load" and acting.by == self.diagram.per):
            return ()
        number = f" = {size:.3g}\u2009"
        if not self.diagram.per:
            return (Run(number + unit),)
        length = {(True, -1): "/m", (True, 1): "\u2009m"}.get((scaled, metres), "")
        return (Run(number), *name(self.diagram.per), *([Run(length)] if length else []))


def _line_of_text(text: str) -> Drawing:
    runs = (Run(text),)
    width, height = box(runs, SIZE)
    label = Label(Plane(width / 2, 0.0), runs, SYMBOL, SIZE, width, height)
    return Drawing("", "", (), (label,), Plane(0.0, -height), Plane(width, height))
