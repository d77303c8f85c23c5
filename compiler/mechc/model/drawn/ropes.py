"""Ropes that are drawn otherwise than their lines say: falls, and wraps around pulleys."""

import math
from collections.abc import Iterator
from itertools import pairwise

from ...diagnostics import Diagnostic
from ...diagnostics import drawn_places as messages
from ...formula.evaluate import evaluate
from ...formula.walk import symbols
from ..mechanism import Mechanism, Rope
from ..parts.friction import RopeFriction
from .sketch import Sketch

BACKWARDS = -0.5
"""The cosine of the angle to the drawn fall below which a rope is said to run the wrong way."""

ACROSS = 0.5
"""The cosine below which it is said to run across: pulleys would fill seven eighths of the way."""

OFF = 0.01
"""The part of its radius by which a drum may be off a fall, as it is drawn."""

WRAP_GAP = math.radians(15)
"""How far a wrap may be from the turn of the drawn falls: pulleys have a size, points have none."""


def turned_falls(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the falls whose direction is against the way from point to point, or across it."""
    for rope in mechanism.ropes:
        for (tail, head), along in zip(pairwise(rope.route), rope.ways, strict=True):
            turned = sketch.turned(along)
            if turned is not None and sketch.has_all((tail, head)):
                x, y = sketch.way(tail, head)
                if math.hypot(x, y) <= sketch.rounding:
                    continue  # of points that lie on one another there is no way
                ahead = math.cos(math.atan2(y, x) - turned)
                if ahead < BACKWARDS:
                    yield messages.fall_drawn_backwards(along.span, tail, head)
                elif ahead < ACROSS:
                    yield messages.fall_drawn_across(along.span, tail, head, math.acos(ahead))


def wraps_otherwise(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the ropes that wrap a drum the other way round, or a pulley farther, than is drawn."""
    ropes = {rope.id: rope for rope in mechanism.ropes}
    for friction in mechanism.friction.joints:
        if isinstance(friction, RopeFriction) and sketch.has_all(ropes[friction.joint].route):
            yield from _wrapped_otherwise(friction, ropes[friction.joint], sketch)


def falls_off_drums(mechanism: Mechanism, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the falls between a drum and an end of its rope that do not touch the drum."""
    ropes = {rope.id: rope for rope in mechanism.ropes}
    for friction in mechanism.friction.joints:
        if not isinstance(friction, RopeFriction) or friction.reach is None:
            continue
        rope, reach = ropes[friction.joint], friction.reach
        if sketch.has_all(rope.route) and symbols(reach) <= sketch.values.keys():
            radius = abs(evaluate(reach, sketch.values))
            for end, off in _standing_off(friction, rope, sketch):
                if abs(abs(off) - radius) > max(OFF * radius, sketch.rounding):
                    found = (end, friction.point, abs(off), radius)
                    yield messages.fall_off_its_drum(friction.span, *found)


def _wrapped_otherwise(friction: RopeFriction, rope: Rope, sketch: Sketch) -> Iterator[Diagnostic]:
    """Yield the warning at a wrap whose sense or angle is not that of the drawing."""
    senses = set(_senses(friction, rope, sketch))
    sense = -1 if friction.reach and _is_negative(friction) else 1
    if friction.reach and senses == {-sense}:
        yield messages.wrapped_backwards(friction.span, friction.point, sense < 0)
        return
    if not symbols(friction.wrap) <= sketch.values.keys():
        return
    wrap, turn = sense * evaluate(friction.wrap, sketch.values), _turn(friction, rope, sketch)
    meant = (wrap,) if friction.reach else (wrap, -wrap)
    if all(abs(math.remainder(turn - angle, math.tau)) > WRAP_GAP for angle in meant):
        yield messages.wrapped_farther(friction.span, friction.point, wrap, turn)


def _is_negative(friction: RopeFriction) -> bool:
    """Return whether the rope goes clockwise around its drum by the sign of its wrap."""
    assert friction.reach is not None
    return evaluate(friction.reach, dict.fromkeys(symbols(friction.reach), 1.0)) < 0


def _senses(friction: RopeFriction, rope: Rope, sketch: Sketch) -> Iterator[int]:
    """Yield on which side of the falls to the rope's ends the axle is drawn, 1 for the left.

    A rope that has the axle on its left goes counter-clockwise around it.
    """
    for _, side in _standing_off(friction, rope, sketch):
        yield int(math.copysign(1, side)) if abs(side) > sketch.rounding else 0


def _standing_off(
    friction: RopeFriction, rope: Rope, sketch: Sketch
) -> Iterator[tuple[str, float]]:
    """Yield the ends of a rope next to a pulley, and how far its axle is to the left of the fall.

    A fall that runs from point to point goes through the axle, and one to another pulley stands
    off from its point.
    """
    for at, place in (
        (friction.place - 1, friction.place - 1),
        (friction.place, friction.place + 1),
    ):
        turned, is_end = sketch.turned(rope.ways[at]), place in (0, len(rope.route) - 1)
        if turned is not None and is_end:
            x, y = sketch.way(rope.route[place], friction.point)
            yield rope.route[place], math.cos(turned) * y - math.sin(turned) * x


def _turn(friction: RopeFriction, rope: Rope, sketch: Sketch) -> float:
    """Return by which angle the rope turns at a pulley, as its falls are directed or drawn."""
    directions = []
    for at in (friction.place - 1, friction.place):
        turned = sketch.turned(rope.ways[at])
        x, y = sketch.way(rope.route[at], rope.route[at + 1])
        directions.append(math.atan2(y, x) if turned is None else turned)
    return directions[1] - directions[0]
