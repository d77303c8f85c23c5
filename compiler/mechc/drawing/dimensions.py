"""Dimensions on paper: their lines in levels, lengths beside bars, arcs of angles."""

import math
from collections.abc import Iterable, Iterator

from ..base.named import NamedTuple
from ..figure.figure import AngleMark, DimensionLine, Link, Telescope
from ..pose.places import Plane, direction
from .bodies import bars_at
from .drawing import Arc, Polyline, Shape
from .labels import AlongArc, BesideLine, above
from .lettering import formula
from .paper import Paper
from .pens import MEASURE
from .sheet import Layer, Sheet
from .symbols import head, line, off
from .tolerances import DETOUR, SHORTEST_LINE

FIRST, LEVEL, LEVELS = 8.0, 6.5, 5
"""How far the first dimension line is from what it measures, the others from each other."""

WITNESS, BEYOND = 1.8, 1.2
"""How far from its point a witness line starts, and how far it goes beyond its dimension."""

SPARED = 2
"""How many lines the witness lines of a repeated length may cross."""

RADII = (8.0, 10.5, 13.0, 16.0, 19.0, 23.0)
"""The radii that are tried for the arc of an angle."""

SMALL_HEAD = 2.2
"""How long the heads of dimension lines are: shorter than those of forces."""

DISTANCE_COST = 0.06
"""The cost of a millimetre between a length and its dimension line: sixteen are a line crossed."""

TRIMMED, MOST = 0.8, 0.4
"""How much of a line is left out at either end where others meet it, at most this part of it."""

SMALLEST_DRAWN_ANGLE = math.radians(1.0)
"""An angle below this is not drawn."""

SAME_DRAWN_DIRECTION = 0.9998
"""The cosine between directions above which they are drawn as one."""


class MeasureLine(NamedTuple):
    """A dimension line, between its witness lines."""

    start: Plane
    end: Plane
    witnesses: tuple[Polyline, ...]

    def shapes(self) -> Iterator[Shape]:
        """Yield all of it; its arrows come from outside where there is no room between."""
        yield from self.witnesses
        along = self.end.minus(self.start).unit() or Plane(1.0, 0.0)
        yield line(self.start, self.end, MEASURE)
        inside = 1 if math.dist(self.start, self.end) > 3 * SMALL_HEAD else -1
        yield head(self.start, along.times(-inside), MEASURE, SMALL_HEAD)
        yield head(self.end, along.times(inside), MEASURE, SMALL_HEAD)


def draw_measures(sheet: Sheet, paper: Paper) -> list[Shape]:
    """Draw what measures lengths, the short ones nearest to the mechanism, and angles.

    The lines of lengths come back.
    """
    parts = paper.figure.parts
    lengths = [part for part in parts if isinstance(part, DimensionLine)]
    known, drawn = set[str](), list[Shape]()
    for dimension in sorted(lengths, key=lambda d: d.value):
        drawn += _draw_length(sheet, paper, dimension, dimension.text in known)
        known.add(dimension.text)
    for mark in parts:
        if isinstance(mark, AngleMark):
            _draw_angle(sheet, paper, mark)
    return drawn


# ---------------------------------------------------------------------------- lengths


def _draw_length(
    sheet: Sheet, paper: Paper, dimension: DimensionLine, known: bool
) -> Iterable[Shape]:
    """Draw a length; one of a name that is ``known`` already only where nothing is in the way.

    Its lines come back, if it has any.
    """
    tail, tip = paper.at(dimension.tail), paper.at(dimension.head)
    runs = formula(dimension.text)
    if _is_rod(paper, dimension):
        sheet.name(BesideLine(tail, tip, runs, MEASURE))
        return ()
    lines = list(_lines(tail, tip, dimension.along))
    best = min(lines, key=lambda found: _cost(sheet, found, tail, tip))
    if _crossed(sheet, best) and _is_bar(paper, dimension):
        sheet.name(BesideLine(tail, tip, runs, MEASURE))
        return ()
    if known and _in_the_way(sheet, best) > SPARED:
        return ()
    sheet.draw(Layer.MEASURES, best.shapes())
    sheet.name(BesideLine(best.start, best.end, runs, MEASURE))
    return best.shapes()


def _is_rod(paper: Paper, dimension: DimensionLine) -> bool:
    """Return whether a dimension is the length of a body that is a single bar."""
    ends = {dimension.tail, dimension.head}
    bodies = (part for part in paper.figure.parts if isinstance(part, Link | Telescope))
    return _is_lengthwise(paper, dimension) and any(ends == {*body.points} for body in bodies)


def _is_lengthwise(paper: Paper, dimension: DimensionLine) -> bool:
    """Return whether a dimension is taken along the line between its points."""
    way = paper.at(dimension.head).minus(paper.at(dimension.tail)).unit()
    return way is not None and abs(way.dot(dimension.along)) > SAME_DRAWN_DIRECTION


def _lines(tail: Plane, tip: Plane, along: Plane) -> Iterator[MeasureLine]:
    """Yield dimension lines on both sides of two points, the near ones first."""
    across = along.turned()
    heights = across.dot(tail), across.dot(tip)
    for level in range(LEVELS):
        for side in (1, -1):
            outer = max(side * h for h in heights) + FIRST + level * LEVEL
            feet = (tail, tip)
            start, end = (p.plus(across.times(side * outer - across.dot(p))) for p in feet)
            witnesses = (
                line(off(p, across, side * WITNESS), off(foot, across, side * BEYOND), MEASURE)
                for p, foot in zip(feet, (start, end), strict=True)
            )
            yield MeasureLine(start, end, tuple(witnesses))


def _cost(sheet: Sheet, found: MeasureLine, tail: Plane, tip: Plane) -> float:
    """Return the cost of a dimension line: lines that it crosses, and its distance."""
    distance = math.dist(found.start, tail) + math.dist(found.end, tip)
    return _in_the_way(sheet, found) + DISTANCE_COST * distance


def _in_the_way(sheet: Sheet, found: MeasureLine) -> int:
    """Return how many lines a dimension would cross, those across its number counted more."""
    witnesses = sum(sheet.occupied.crossed((witness,)) for witness in found.witnesses)
    return 3 * _crossed(sheet, found) + witnesses


def _crossed(sheet: Sheet, found: MeasureLine) -> int:
    """Return how many lines a dimension and its number would cross."""
    start, end = found.start, found.end
    return sum(
        sheet.occupied.crossings(*_shortened(start.plus(step), end.plus(step)))
        for step in (Plane(0.0, 0.0), *(_across(start, end).times(s) for s in (4.0, -1.2)))
    )


def _is_bar(paper: Paper, dimension: DimensionLine) -> bool:
    """Return whether a dimension measures a bar between neighbouring points of a link."""
    ends = {dimension.tail, dimension.head}
    for part in paper.figure.parts:
        if isinstance(part, Link) and ends in map(set, part.rods):
            return _is_lengthwise(paper, dimension) and not any(
                _between(paper, dimension, p) for p in {*part.points} - ends
            )
    return False


def _between(paper: Paper, dimension: DimensionLine, point: str) -> bool:
    tail, tip, at = (paper.at(p) for p in (dimension.tail, dimension.head, point))
    return math.dist(tail, at) + math.dist(at, tip) < (1 + DETOUR) * math.dist(tail, tip)


def _across(start: Plane, end: Plane) -> Plane:
    """Return the unit vector across a line to the side on which its number stands."""
    return above(end.minus(start).unit() or Plane(1.0, 0.0))


def _shortened(start: Plane, end: Plane) -> tuple[Plane, Plane]:
    """Return a line without its ends, at which others may meet it."""
    step = end.minus(start).times(min(TRIMMED / max(math.dist(start, end), SHORTEST_LINE), MOST))
    return start.plus(step), end.minus(step)


# ----------------------------------------------------------------------------- angles


def _draw_angle(sheet: Sheet, paper: Paper, mark: AngleMark) -> None:
    """Draw an angle: its arc, that of the radii which crosses least, its value, and its sides.

    A side is drawn where no line of the figure runs along it.
    """
    if abs(mark.sweep) < SMALLEST_DRAWN_ANGLE:
        return
    at, lines = paper.at(mark.vertex), list(_lines_at(paper, mark.vertex))
    arcs = [Arc(at, r, MEASURE, mark.start, mark.sweep) for r in RADII]
    arc = min(arcs, key=lambda a: 2 * sheet.occupied.crossed((a,)) + 0.1 * a.radius)
    for angle in (mark.start, mark.start + mark.sweep):
        if all(direction(angle).dot(unit) < SAME_DRAWN_DIRECTION for unit in lines):
            ray = line(
                off(at, direction(angle), WITNESS),
                off(at, direction(angle), arc.radius + 2),
                MEASURE,
            )
            sheet.draw(Layer.AXES, [ray])
    sheet.draw(Layer.MEASURES, _with_heads(arc))
    sheet.name(AlongArc(arc, formula(mark.text), MEASURE))


def _lines_at(paper: Paper, point: str) -> Iterable[Plane]:
    """Yield the directions in which bars leave a point."""
    for part in paper.figure.parts:
        if isinstance(part, Link):
            yield from bars_at(paper, part, point)


def _with_heads(arc: Arc) -> Iterator[Shape]:
    """Yield an arc with arrows at its ends, where it is long enough for them."""
    yield arc
    if arc.radius * abs(arc.sweep) > 3 * SMALL_HEAD:
        sense = math.copysign(1.0, arc.sweep)
        lean = sense * SMALL_HEAD / arc.radius / 2
        for part, way in ((0.0, -1), (1.0, 1)):
            angle = arc.start + part * arc.sweep - way * lean
            yield head(
                arc.at(part), direction(angle).turned().times(sense * way), MEASURE, SMALL_HEAD
            )
