"""The figure as text, for ``mechc show figure``: points, then parts, in mm and degrees."""

import math
from collections.abc import Iterator
from typing import assert_never

from .figure import (
    Actuator,
    AngleMark,
    Belt,
    Contact,
    Dimension,
    Figure,
    Force,
    Gears,
    Link,
    Measure,
    Part,
    Pivot,
    Plane,
    Rack,
    Screw,
    Segment,
    Slide,
    Slider,
    Slot,
    Spring,
    Telescope,
    Torque,
)


def describe(figure: Figure | None) -> str:
    """Return every point and part of a figure, one to a line.

    >>> print(describe(None), end="")
    There is no figure: the mechanism cannot be assembled at these values.
    """
    if figure is None:
        return "There is no figure: the mechanism cannot be assembled at these values.\n"
    return "\n".join(_lines(figure)) + "\n"


def _lines(figure: Figure) -> Iterator[str]:
    yield f"{figure.name}, a usual length is {_mm(figure.size)}"
    yield from (f"{name} at {_place(at)}" for name, at in figure.points.items())
    if line := figure.mirror:
        yield f"mirror line through {_place(line.at)} along {_towards(line.along)}"
    if figure.copies > 1:
        yield f"one of {figure.copies} branches"
    yield from (f"{n} = {figure.values[n]:.6g}, chosen for the drawing" for n in figure.chosen)
    yield from map(_part, figure.parts)


def _part(part: Part) -> str:
    match part:
        case Link(name, _, outline, rods):
            bars = ", ".join(map("".join, rods))
            return f"link {name}: bars {bars}; corners {' '.join(outline)}"
        case Slide(name, points, _, along, guide):
            return f"slide {name} through {' '.join(points)} along {_towards(along)}, {_on(guide)}"
        case Telescope(name, (first, second)):
            return f"telescope {name} from {first} to {second}"
        case Pivot(point, ground):
            return f"pivot {point}, the ground along {_towards(ground)}"
        case Slider(point, along, guide):
            return f"slider {point} along {_towards(along)}, {_on(guide)}"
        case Slot(point, body, tail, head, along, groove):
            return f"slot {point} in {tail}{head} of {body} along {_towards(along)}, {_on(groove)}"
        case Contact(point, body, normal, face):
            return f"contact {point} on {body}, normal {_towards(normal)}, {_on(face)}"
        case Gears() | Belt():
            return _wheels(part)
        case Rack(point, pivot, _, radius, _, line):
            return f"rack {point} on {pivot}, radius {_mm(radius)}, {_on(line)}"
        case Screw(point, link, pitch, along):
            return f"screw {point} on {link}, pitch {_mm(pitch)}, along {_towards(along)}"
        case Force(name, point, along, weight):
            kind = "weight" if weight else "force"
            return f"{kind} {name} at {point} along {_towards(along)}"
        case Torque(name, link, at, counterclockwise):
            way = "" if counterclockwise else "clock"
            return f"torque {name} on {link} at {_place(at)}, {way or 'counter-clock'}wise"
        case Actuator(name, first, second):
            return f"actuator {name} between {first} and {second}"
        case Spring(name, first, second):
            return f"spring {name} between {first} and {second}"
        case Dimension() | AngleMark():
            return _measure(part)
        case _:
            assert_never(part)


def _wheels(pair: Gears | Belt) -> str:
    kind = "gear" if isinstance(pair, Gears) else "belt"
    unusual = pair.inner if isinstance(pair, Gears) else pair.crossed
    word = {"gear": " inner", "belt": " crossed"}[kind] if unusual else ""
    first, second = _mm(pair.first_radius), _mm(pair.second_radius)
    return f"{kind} {pair.first} {first}, {pair.second} {second}{word}"


def _measure(mark: Measure) -> str:
    if isinstance(mark, Dimension):
        along = _towards(mark.along)
        return f"{mark.text} = {_mm(mark.value)} from {mark.tail} to {mark.head}, along {along}"
    start, sweep = _degrees(mark.start), _degrees(mark.sweep)
    return f"{mark.text} at {mark.vertex}, from {start} on by {sweep}"


def _on(line: Segment) -> str:
    return f"from {_place(line.start)} to {_place(line.end)}"


def _place(at: Plane) -> str:
    return f"({_number(at.x * 1000)}, {_number(at.y * 1000)}) mm"


def _towards(line: Plane) -> str:
    return _degrees(line.angle)


def _degrees(angle: float) -> str:
    return f"{_number(math.degrees(angle))} deg"


def _mm(length: float) -> str:
    return f"{_number(length * 1000)} mm"


def _number(value: float) -> str:
    """Return six digits, and a plain zero for what rounding leaves of one."""
    return f"{value if abs(value) > 1e-9 else 0:.6g}"
