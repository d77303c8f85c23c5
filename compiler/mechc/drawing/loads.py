"""Loads on paper: arrows of forces, round arrows of couples, names beside them."""

import math

from ..figure.figure import (
    Actuator,
    Force,
    SpreadLoad,
    Spring,
    Telescope,
    Torque,
)
from ..pose.places import Plane
from .drawing import Arc
from .joints import reach
from .labels import AlongArc, BesideLine
from .lettering import name, times
from .occupied import LineSegment, Occupied
from .paper import Paper
from .pens import FORCE, SYMBOL, VELOCITY
from .sheet import Layer, Sheet
from .symbols import (
    ARROW,
    GAP,
    PIN,
    arrow,
    centre_of_gravity,
    couple,
    cylinder,
    line,
    off,
    spring,
)

SPACING, HEIGHT = 7.0, 9.0
"""How far apart the arrows of a spread load are, and how long the longest is."""

LEAST = 3.5
"""How long an arrow of a spread load is at least."""

BESIDE_VELOCITY = 2.2
"""How far an arrow is to the side of its point where a velocity's is in its place."""

CLEAR_OF_LINE = 0.9
"""How far an arrow keeps off a thin line beside it: half the width of its head, and some air."""

DIRECTIONS = 12
"""In how many directions from its middle the arrow of a couple is tried."""


def draw_pairs(sheet: Sheet, paper: Paper) -> None:
    """Draw actuators and springs; a telescope between the same points is the cylinder already."""
    parts = paper.figure.parts
    drawn = {frozenset(part.points) for part in parts if isinstance(part, Telescope)}
    for part in parts:
        if isinstance(part, Actuator) and frozenset((part.first, part.second)) not in drawn:
            sheet.draw(Layer.BODIES, cylinder(paper.at(part.first), paper.at(part.second)))
        elif isinstance(part, Spring):
            sheet.draw(Layer.BODIES, spring(paper.at(part.first), paper.at(part.second)))


def draw_forces(sheet: Sheet, paper: Paper, avoided: Occupied) -> list[LineSegment]:
    """Draw the arrows of forces, weights and couples, each with its name.

    Those of forces come back; they keep off the lines to be avoided, where they have the choice.
    """
    drawn = []
    for part in paper.figure.parts:
        match part:
            case Force():
                drawn.append(_draw_force(sheet, paper, part, avoided))
            case SpreadLoad():
                _draw_spread(sheet, paper, part)
            case Torque():
                _draw_torque(sheet, paper, part)
            case Actuator() | Spring():
                ends = paper.at(part.first), paper.at(part.second)
                pen = FORCE if isinstance(part, Actuator) else SYMBOL
                sheet.name(BesideLine(*ends, name(part.name), pen))
            case _:
                pass
    return drawn


def _draw_force(sheet: Sheet, paper: Paper, force: Force, avoided: Occupied) -> LineSegment:
    at = paper.at(force.point)
    if force.weight:
        sheet.draw(Layer.PINS, centre_of_gravity(at))
    tail, tip = _free_arrow(sheet.occupied, avoided, paper, force)
    sheet.draw(Layer.LOADS, arrow(tail, tip))
    sheet.name(BesideLine(tail, tip, times(force.times, force.name), FORCE))
    return tail, tip


def meets(arrow: LineSegment, lines: Occupied) -> bool:
    """Return whether an arrow meets lines, or comes so near to them that it seems to."""
    tail, tip = arrow
    across = (tip.minus(tail).unit() or Plane(1.0, 0.0)).turned()
    steps = (across.times(side * CLEAR_OF_LINE) for side in (-1, 0, 1))
    return any(lines.crossings(tail.plus(step), tip.plus(step)) for step in steps)


def _free_arrow(occupied: Occupied, avoided: Occupied, paper: Paper, force: Force) -> LineSegment:
    """Return the tail and the tip of a force's arrow.

    It leaves its point or comes to it, whichever meets fewer lines; where velocities lie on
    both, it is beside the point.
    """
    at = paper.at(force.point)
    gap = GAP + max(PIN + 0.4 * force.weight, reach(paper, force.point, force.along))

    def arrow_from(start: float, across: float = 0.0) -> LineSegment:
        ends = start, start + ARROW
        return off(at, force.along, ends[0], across), off(at, force.along, ends[1], across)

    coming = () if force.weight else (arrow_from(-gap - ARROW),)
    in_line = [way for way in (arrow_from(gap), *coming) if not occupied.lies_on(way, VELOCITY)]
    beside = arrow_from(gap, BESIDE_VELOCITY), arrow_from(gap, -BESIDE_VELOCITY)
    ways = in_line or beside
    return min(ways, key=lambda way: (occupied.crossings(*way), meets(way, avoided)))


def _draw_spread(sheet: Sheet, paper: Paper, load: SpreadLoad) -> None:
    """Draw a row of arrows, as long as the load is large at each place, and the line above them."""
    start, end = paper.at(load.tail), paper.at(load.head)
    first, last = load.tail_intensity, load.head_intensity
    largest = max(abs(first), abs(last)) or 1.0
    count = max(3, round(math.dist(start, end) / SPACING))
    tails = []
    for i in range(count + 1):
        part = i / count
        size = (first + part * (last - first)) / largest * HEIGHT
        tip = off(start.plus(end.minus(start).times(part)), load.along, -GAP)
        tails.append(off(tip, load.along, -size))
        if abs(size) > LEAST:
            sheet.draw(Layer.LOADS, arrow(tails[-1], tip))
    sheet.draw(Layer.LOADS, [line(tails[0], tails[-1], FORCE)])
    sheet.name(BesideLine(tails[0], tails[-1], times(load.times, load.name), FORCE))


def _draw_torque(sheet: Sheet, paper: Paper, torque: Torque) -> None:
    at = paper.place(torque.at)
    starts = [math.pi / 2 + math.tau * i / DIRECTIONS for i in range(DIRECTIONS)]
    shapes = [tuple(couple(at, start, torque.counterclockwise)) for start in starts]
    found = min(shapes, key=lambda s: sheet.occupied.crossed(s))
    sheet.draw(Layer.LOADS, found)
    arc = next(shape for shape in found if isinstance(shape, Arc))
    sheet.name(AlongArc(arc, times(torque.times, torque.name), FORCE))
