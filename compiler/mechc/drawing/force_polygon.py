"""The polygon of the forces on a body, head to tail: it closes where they balance."""

import math
from collections.abc import Sequence

from ..pose.places import NOWHERE, Plane
from ..statics.diagrams.diagram import Acting, FreeBody
from .drawing import Drawing
from .labels import BesideLine
from .occupied import LineSegment
from .pens import FORCE, HATCH
from .sheet import Layer, Sheet
from .symbols import arrow, line
from .vectors import ForceVectors

LARGEST_SIDE = 34.0
"""The length of the largest force in millimetres."""

DRAWN_PARALLEL = 1e-3
"""Forces are drawn as parallel where none has more than this part of the largest across it."""

PARALLEL_GAP = 3.0
"""How far parallel forces of opposite senses are drawn from each other, in millimetres."""


def visible(forces: ForceVectors, body: FreeBody) -> list[Acting]:
    """Return the forces on a body that are more than rounding, in the order of a polygon.

    They go round counter-clockwise, the loads first, so that no side crosses another one.
    """
    pushing = [a for a in body.forces if forces.pushes(a)]
    first = next((a for a in pushing if a.kind == "load"), pushing[0] if pushing else None)
    start = first.force.angle if first and first.force else 0.0

    def turn(acting: Acting) -> float:
        angle = acting.force.angle if acting.force else 0.0
        return round((angle - start) % math.tau, 6) % round(math.tau, 6)

    return sorted(pushing, key=turn)


def is_known(body: FreeBody) -> bool:
    """Return whether every force on a body has a value."""
    return all(acting.force is not None for acting in body.forces)


def force_scale(forces: ForceVectors) -> float:
    """Return how many millimetres a newton is, for all bodies of a diagram."""
    return LARGEST_SIDE / forces.largest


def force_polygon(forces: ForceVectors, body: FreeBody) -> Drawing:
    """Return the polygon of the forces on a body."""
    sheet, acting, scale = Sheet(), visible(forces, body), force_scale(forces)
    sides = _sides([(one.force or NOWHERE).times(scale) for one in acting])
    for one, (tail, tip) in zip(acting, sides, strict=True):
        sheet.draw(Layer.LOADS, arrow(tail, tip))
        sheet.name(BesideLine(tail, tip, (*forces.name(body, one), *forces.size(one)), FORCE))
    for (_, tip), (tail, _) in zip(sides, (*sides[1:], sides[0]), strict=True):
        if math.dist(tip, tail) > PARALLEL_GAP / 2:
            sheet.draw(Layer.AXES, [line(tip, tail, HATCH)])
    return sheet.finished("", "")


def _sides(steps: Sequence[Plane]) -> list[LineSegment]:
    """Return steps head to tail; where all are parallel, those back beside those ahead."""
    longest = max(steps, key=lambda step: math.hypot(*step))
    along = longest.unit() or Plane(1.0, 0.0)
    flat = all(
        abs(along.turned().dot(step)) < DRAWN_PARALLEL * math.hypot(*longest) for step in steps
    )
    at, sides = NOWHERE, list[LineSegment]()
    for step in steps:
        back = flat and along.dot(step) * along.dot(steps[0]) < 0
        aside = along.turned().times(PARALLEL_GAP if back else 0.0)
        sides.append((at.plus(aside), at.plus(step).plus(aside)))
        at = at.plus(step)
    return sides
