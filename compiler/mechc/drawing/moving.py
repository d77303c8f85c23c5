"""Marks of how a mechanism moves: velocities, instantaneous centres, circles of friction."""

import math
from collections.abc import Iterator, Mapping
from types import MappingProxyType

from ..base.frozen import frozen
from ..base.named import NamedTuple
from ..figure.figure import Link
from ..figure.tolerances import NO_SPEED
from ..figure.velocities import MotionVelocities
from ..formula.names import split_points
from ..pose.places import Plane
from . import symbols
from .drawing import Arc, TextRun
from .labels import AroundPoint
from .paper import Paper
from .pens import AXIS, FORCE, SYMBOL, VELOCITY
from .sheet import Layer, Sheet
from .vectors import VelocityVectors, index

LONGEST, SHORTEST = 20.0, 1.0
"""How long the largest velocity is drawn, and how long one is that is drawn at all."""

FARTHEST_CENTRE = 1.5
"""How often as far off as the mechanism is large a centre may be to be drawn."""

CROSS = 1.6
"""Half the size of the cross at an instantaneous centre."""


@frozen
class Marks:
    """What is marked: the velocities and the centres of a motion, circles by their points."""

    velocities: MotionVelocities | None = None
    centres: MotionVelocities | None = None
    circles: Mapping[str, float] = MappingProxyType({})


NO_MARKS = Marks()


class Centre(NamedTuple):
    """Where a link would be pinned to the ground to move as it does: its instantaneous centre."""

    link: Link
    at: Plane


def draw_marks(sheet: Sheet, paper: Paper, marks: Marks) -> None:
    """Draw what is asked for over a scheme."""
    for point, radius in marks.circles.items():
        sheet.draw(Layer.LOADS, [Arc(paper.at(point), radius * paper.scale, FORCE)])
    if marks.centres is not None:
        for centre in _centres(paper, marks.centres):
            if _is_near(paper, centre):
                _draw_centre(sheet, paper, centre)
    if marks.velocities is not None:
        _draw_velocities(sheet, paper, marks.velocities)


def say_marks(paper: Paper, marks: Marks, words: Mapping[str, str]) -> Iterator[str]:
    """Yield which centres are too far off to be drawn."""
    centres = _centres(paper, marks.centres) if marks.centres else ()
    far = [c.link.name for c in centres if not _is_near(paper, c)]
    if far:
        yield words["far_centres"].format(links=", ".join(far))


def _draw_velocities(sheet: Sheet, paper: Paper, velocities: MotionVelocities) -> None:
    speeds, scale = VelocityVectors(velocities), LONGEST / velocities.largest
    for point, velocity in velocities.points.items():
        step = velocity.times(scale)
        if not split_points(point) or math.hypot(*step) < SHORTEST:
            continue
        tail = paper.at(point)
        tip = tail.plus(step)
        sheet.draw(Layer.LOADS, symbols.arrow(tail, tip, VELOCITY))
        size = speeds.size(velocities.speed(point), point)
        sheet.name(AroundPoint(tip, (*speeds.name(point), *size), VELOCITY, step.angle, 0.5))


def _centres(paper: Paper, velocities: MotionVelocities) -> Iterator[Centre]:
    """Yield the centres of links that turn about no point of their own."""
    least = NO_SPEED * velocities.largest / paper.figure.size
    for part in paper.figure.parts:
        if not isinstance(part, Link) or abs(velocities.spins.get(part.name, 0.0)) < least:
            continue
        if all(velocities.speed(p) > NO_SPEED * velocities.largest for p in part.points):
            point, spin = part.points[0], velocities.spins[part.name]
            arm = velocities.points[point].turned().times(1 / spin)
            yield Centre(part, paper.place(paper.figure.points[point].plus(arm)))


def _is_near(paper: Paper, centre: Centre) -> bool:
    places = [paper.at(point) for point in paper.figure.points]
    xs, ys = [at.x for at in places], [at.y for at in places]
    reach = FARTHEST_CENTRE * max(max(xs) - min(xs), max(ys) - min(ys))
    middle = Plane((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    return math.dist(centre.at, middle) < reach


def _draw_centre(sheet: Sheet, paper: Paper, centre: Centre) -> None:
    """Draw a cross, and the lines to it, on which the velocities of the pins are square."""
    for point in centre.link.points:
        sheet.draw(Layer.AXES, [symbols.line(paper.at(point), centre.at, AXIS)])
    for along in (Plane(CROSS, CROSS), Plane(CROSS, -CROSS)):
        ends = centre.at.minus(along), centre.at.plus(along)
        sheet.draw(Layer.LOADS, [symbols.line(*ends, SYMBOL)])
    runs = (TextRun("P", italic=True), *index(*centre.link.points))
    sheet.name(AroundPoint(centre.at, runs, SYMBOL, math.pi / 4, CROSS))
