"""From the diagrams of free bodies to their drawing: each body, the forces on it to scale."""

import math
from collections.abc import Iterator, Mapping, Sequence

from ..base.frozen import frozen, replace
from ..figure.figure import Figure, Link, Slide, Slider, Telescope
from ..pose.places import NOWHERE, Plane, direction
from ..statics.diagrams.diagram import AT_PINS, Acting, Diagram, FreeBody
from . import symbols
from .arrange import below_each_other, in_rows, joined, line_of_text
from .bodies import link, slide
from .drawing import Arc, Drawing, Shape, TextRun
from .labels import AroundPoint, BesideLine
from .lettering import name
from .paper import Paper, on_paper
from .pens import AXIS, FORCE, SYMBOL
from .sheet import Layer, Sheet
from .symbols import LARGEST_ARROW, SHORTEST_ARROW, off
from .vectors import ForceVectors, heading, in_words

RADII = (symbols.COUPLE, symbols.COUPLE + 2.5)
"""How far round arrows are from their middle, in millimetres: one that is free is taken."""

VISIBLE = 0.3
"""A friction circle with a smaller radius than this, in millimetres, is not drawn."""


def free_bodies(
    figure: Figure, diagrams: Sequence[Diagram], words: Mapping[str, str]
) -> Drawing | None:
    """Return the free-body diagrams of the described half, for every set of loads if any.

    ``words`` are those of a language.
    """
    if not diagrams:
        return None
    paper = on_paper(figure)
    drawn = [_DiagramMaker(paper, ForceVectors(figure, d, words)).drawing() for d in diagrams]
    title = words["bodies_of"].format(name=figure.title or figure.name)
    about = _description(diagrams, words, figure.mirror is not None)
    return replace(below_each_other(drawn), title=title, description=about)


def _description(diagrams: Sequence[Diagram], words: Mapping[str, str], halves: bool) -> str:
    heads = "; ".join(in_words(heading(diagram, words)) for diagram in diagrams)
    return words["half_cut" if halves else "cut"].format(heads=heads)


@frozen
class _DiagramMaker:
    """One set of loads and the forces under it."""

    paper: Paper
    forces: ForceVectors

    def drawing(self) -> Drawing:
        """Return a heading over all bodies."""
        head = line_of_text(heading(self.forces.diagram, self.forces.words))
        bodies = [self._body(body) for body in self.forces.described]
        return joined([head, in_rows(bodies)]) if bodies else head

    def _body(self, body: FreeBody) -> Drawing:
        sheet = Sheet()
        sheet.draw(Layer.BODIES, self._shapes(body))
        for acting in body.forces:
            self._draw_force(sheet, body, acting)
        for point in dict.fromkeys(a.point for a in body.forces if a.point):
            at = self.paper.at(point)
            sheet.name(AroundPoint(at, name(point), SYMBOL, math.pi / 2, symbols.PIN))
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
            unknown = (*self.forces.name(body, acting), TextRun(" = ?"))
            sheet.name(AroundPoint(self._place(body, acting), unknown, FORCE, 0.0, symbols.PIN))
            return
        unit = acting.force.unit()
        pushes = bool(acting.point) and self.forces.pushes(acting)
        if pushes and unit is not None:
            self._draw_arrow(sheet, body, acting, unit)
        if self.forces.turns(acting) and not (pushes and acting.kind in AT_PINS):
            self._draw_couple(sheet, body, acting)

    def _draw_arrow(self, sheet: Sheet, body: FreeBody, acting: Acting, unit: Plane) -> None:
        """Draw a force along its line of action, which touches the friction circle."""
        size = math.hypot(*(acting.force or NOWHERE))
        radius = (acting.offset or 0.0) * self.paper.scale if acting.kind in AT_PINS else 0.0
        at = self.paper.at(acting.point)
        length = max(SHORTEST_ARROW, LARGEST_ARROW * size / self.forces.largest)
        gap = symbols.PIN + symbols.GAP
        ways = [(off(at, unit, d, -radius), off(at, unit, d + length, -radius))
                for d in (gap, -gap - length)]  # fmt: skip
        tail, tip = min(ways, key=lambda way: sheet.occupied.crossings(*way))
        if abs(radius) > VISIBLE:
            sheet.draw(Layer.PINS, [Arc(at, abs(radius), AXIS)])
            reach = off(at, unit, -gap - length, -radius), off(at, unit, gap + length, -radius)
            sheet.draw(Layer.AXES, [symbols.line(*reach, AXIS)])
        sheet.draw(Layer.LOADS, symbols.arrow(tail, tip))
        runs = (*self.forces.name(body, acting), *self.forces.size(acting))
        sheet.name(BesideLine(tail, tip, runs, FORCE))

    def _draw_couple(self, sheet: Sheet, body: FreeBody, acting: Acting) -> None:
        at, sense = self._place(body, acting), acting.moment > 0
        ways = [(start, radius) for radius in RADII for start in (math.pi / 2, -math.pi / 2)]
        drawn = {way: tuple(symbols.couple(at, way[0], sense, way[1])) for way in ways}
        start, radius = min(ways, key=lambda way: sheet.occupied.crossed(drawn[way]))
        sheet.draw(Layer.LOADS, drawn[start, radius])
        runs = (*self.forces.name(body, acting, couple=True), *self.forces.turning(acting))
        sheet.name(AroundPoint(off(at, direction(start), radius + 1), runs, FORCE, start))

    def _place(self, body: FreeBody, acting: Acting) -> Plane:
        """Return where a force or couple is: at its point, or in the middle of the body."""
        if acting.point:
            return self.paper.at(acting.point)
        points = [self.paper.at(a.point) for a in body.forces if a.point]
        total = NOWHERE
        for at in points:
            total = total.plus(at)
        return total.times(1 / max(len(points), 1))
