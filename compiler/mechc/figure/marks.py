"""What measures the figure: the parameters that are lengths, and those that are angles."""

from collections.abc import Iterator
from typing import assert_never

from ..algebra.angle import RADIAN, Angle
from ..algebra.from_formula import to_angle
from ..formula.to_text import text
from ..formula.tree import Formula
from ..formula.walk import evaluate, symbols
from ..model.mechanism import (
    Absolute,
    Arrow,
    Contact,
    Direction,
    Force,
    Geometry,
    Mechanism,
    Offset,
    Slider,
    Turn,
)
from ..pose.places import Plane
from .figure import AngleMark, Dimension, Measure
from .parts import Half

ALONG_X, ALONG_Y = Plane(1.0, 0.0), Plane(0.0, 1.0)


def marks(half: Half) -> Iterator[Measure]:
    """Yield a mark for every length and angle that is given by a formula of parameters."""
    mechanism = half.ways.pose.mechanism
    for entry in mechanism.geometry:
        yield from _entry(entry, half)
    for point, line in _lines(mechanism):
        yield from _angle(point, line, half)


def _lines(mechanism: Mechanism) -> Iterator[tuple[str, Direction]]:
    """Yield the directions of joints and loads, with the points at which they are."""
    yield from ((slider.point, slider.along) for slider in mechanism.each(Slider))
    yield from ((slide.points[0], slide.along) for slide in mechanism.slides)
    yield from ((contact.point, contact.normal) for contact in mechanism.each(Contact))
    yield from ((f.point, f.along) for f in mechanism.loads if isinstance(f, Force))


def _entry(entry: Geometry, half: Half) -> Iterator[Measure]:
    match entry:
        case Offset(tail, head, x, y):
            yield from _distance(tail, head, x, half.vector(ALONG_X), half)
            yield from _distance(tail, head, y, half.vector(ALONG_Y), half)
        case Arrow(tail, head, length, line):
            if length is not None:
                yield from _distance(tail, head, length, None, half)
            if line is not None:
                yield from _angle(tail, line, half)
        case Turn(first, vertex, _, angle):
            towards = half.at(first).minus(half.at(vertex))
            yield from _sweep(vertex, towards, angle, half)
        case _:
            assert_never(entry)


def _distance(
    tail: str, head: str, formula: Formula, line: Plane | None, half: Half
) -> Iterator[Dimension]:
    """Yield what measures a vector along a line, or along itself; plain numbers measure nothing."""
    if not symbols(formula) or not tail:
        return
    value = evaluate(formula, half.ways.values)
    vector = half.at(head).minus(half.at(tail))
    along = line or vector.unit()
    if along is not None:
        yield Dimension(half.point(tail), half.point(head), along, text(formula), value)


def _angle(vertex: str, line: Direction, half: Half) -> Iterator[AngleMark]:
    """Yield what measures a direction, from +x or a constant direction on."""
    if not isinstance(line, Absolute) or not symbols(line.angle) or not vertex:
        return
    angle = to_angle(line.angle)
    if angle is None:
        sweep = evaluate(line.angle, half.ways.values)
        yield _mark(vertex, 0.0, sweep, text(line.angle), half)
        return
    start = Angle(tuple(t for t in angle.terms if t[0] == RADIAN), angle.degrees)
    rest = angle - start
    shown = -rest if all(c < 0 for _, c in rest.terms) else rest
    values = half.ways.values
    name = text(shown.formula())
    yield _mark(vertex, start.evaluate(values), rest.evaluate(values), name, half)


def _sweep(vertex: str, towards: Plane, angle: Formula, half: Half) -> Iterator[AngleMark]:
    if symbols(angle):
        sweep = half.sense * evaluate(angle, half.ways.values)
        yield AngleMark(half.point(vertex), towards.angle, sweep, text(angle))


def _mark(vertex: str, start: float, sweep: float, name: str, half: Half) -> AngleMark:
    return AngleMark(half.point(vertex), half.turned(start), half.sense * sweep, name)
