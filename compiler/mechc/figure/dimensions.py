"""The dimensions of a figure: the parameters that are lengths, and those that are angles."""

import math
from collections.abc import Iterator
from typing import assert_never

from ..algebra.angle import RADIAN, Angle
from ..algebra.from_formula import to_angle
from ..formula.evaluate import evaluate
from ..formula.rewriting import plus_first
from ..formula.to_text import text
from ..formula.tree import Formula, Sum, Symbol, negative, total
from ..formula.walk import constants, symbols
from ..model.entries import unit_of_drawing
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
from ..units import LENGTH, in_unit, size_of
from .figure import AngleMark, DimensionLine, Measure
from .half import Half
from .joints import lost_places
from .tolerances import NO_LENGTH, SAME_ANGLE, SAME_LENGTH

MEASURED = 4
"""Figures of a length that follows from others, which none reads off a drawing more exactly."""

ALONG_X, ALONG_Y = Plane(1.0, 0.0), Plane(0.0, 1.0)


def dimensions(half: Half) -> Iterator[Measure]:
    """Yield a mark for every length that is given, and every angle given by parameters."""
    found: list[Measure] = []
    for mark in _all(half):
        if not any(_same(mark, other) for other in found):
            found.append(mark)
    yield from found


def _all(half: Half) -> Iterator[Measure]:
    mechanism = half.vectors.pose.mechanism
    lost = set(lost_places(mechanism))
    for entry in mechanism.geometry:
        if not isinstance(entry, Offset) or entry.head not in lost:
            yield from _entry(entry, half)
    for point, line in _lines(mechanism):
        yield from _angle(point, line, half)


def _same(one: Measure, other: Measure) -> bool:
    """Return whether two marks say the same: angles that are opposite each other do."""
    if not isinstance(one, AngleMark) or not isinstance(other, AngleMark):
        return one == other
    half_turns = (one.start - other.start) / math.pi
    level = (
        abs(half_turns - round(half_turns)) < SAME_ANGLE
        and abs(one.sweep - other.sweep) < SAME_ANGLE
    )
    return level and (one.vertex, one.text) == (other.vertex, other.text)


def _lines(mechanism: Mechanism) -> Iterator[tuple[str, Direction]]:
    """Yield the directions of joints and loads, with the points at which they are."""
    yield from ((slider.point, slider.along) for slider in mechanism.each(Slider))
    yield from ((slide.points[0], slide.along) for slide in mechanism.slides)
    yield from ((contact.point, contact.normal) for contact in mechanism.each(Contact))
    yield from ((f.point, f.along) for f in mechanism.loads if isinstance(f, Force))


def _entry(entry: Geometry, half: Half) -> Iterator[Measure]:
    """Yield the lengths and angles to be measured of one line of the geometry."""
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
) -> Iterator[DimensionLine]:
    """Yield the dimension of a vector along a line, or along itself; one of no length has none."""
    start = tail or _origin(half)
    if not start:
        return
    value = evaluate(formula, half.vectors.values)
    along = line or half.at(head).minus(half.at(start)).unit()
    if along is None or abs(value) < NO_LENGTH * half.size:
        return
    ends = half.point(start), half.point(head)
    if value < 0:
        formula, along = negative(formula), along.times(-1)
    yield DimensionLine(*ends, along, _length(formula, half), abs(value))


def _origin(half: Half) -> str:
    """Return the pivot that has its place in the origin, '' where none is there."""
    for entry in half.vectors.pose.mechanism.geometry:
        if isinstance(entry, Offset) and not entry.tail:
            place = [evaluate(coordinate, half.vectors.values) for coordinate in (entry.x, entry.y)]
            if not any(place):
                return entry.head
    return ""


def _length(formula: Formula, half: Half) -> str:
    """Return a length's formula, its plain numbers in the unit that they are written in."""
    mechanism = half.vectors.pose.mechanism
    if not symbols(formula):
        return _written(evaluate(formula, {}), _unit(formula, mechanism))
    if isinstance(formula, Sum):
        return text(plus_first(total(_with_unit(term, mechanism) for term in formula.terms)))
    return text(formula)


def _with_unit(term: Formula, mechanism: Mechanism) -> Formula:
    """Return a term that is printed with its unit."""
    if symbols(term):
        return term
    value = evaluate(term, {})
    size = Symbol(_written(abs(value), _unit(term, mechanism)))
    return size if value > 0 else negative(size)


def _written(value: float, unit: str) -> str:
    """Return a length in its unit: as it is written, or to four figures where it was computed."""
    size = value / size_of(unit)
    is_short = math.isclose(size, float(f"{size:.6g}"), rel_tol=SAME_LENGTH)
    return in_unit(value, unit, 6 if is_short else MEASURED)


def _unit(formula: Formula, mechanism: Mechanism) -> str:
    """Return the unit in which the numbers of a formula are written, or else lengths are."""
    names = {constant.name for constant in constants([formula])}
    lengths = (p for p in mechanism.literals if p.name in names and p.dimension == LENGTH)
    own = (length.unit for length in lengths if length.unit)
    return next(own, unit_of_drawing(mechanism) or "mm")


def _angle(vertex: str, line: Direction, half: Half) -> Iterator[AngleMark]:
    """Yield the mark of a direction, from +x or a constant direction on."""
    if not isinstance(line, Absolute) or not symbols(line.angle) or not vertex:
        return
    angle = to_angle(line.angle)
    if angle is None:
        sweep = evaluate(line.angle, half.vectors.values)
        yield _mark(vertex, 0.0, sweep, text(line.angle), half)
        return
    start = Angle(tuple(t for t in angle.terms if t[0] == RADIAN), angle.degrees)
    rest = angle - start
    shown = -rest if all(c < 0 for _, c in rest.terms) else rest
    values = half.vectors.values
    name = text(shown.formula())
    yield _mark(vertex, start.evaluate(values), rest.evaluate(values), name, half)


def _sweep(vertex: str, towards: Plane, angle: Formula, half: Half) -> Iterator[AngleMark]:
    if symbols(angle):
        sweep = half.sense * evaluate(angle, half.vectors.values)
        yield AngleMark(half.point(vertex), towards.angle, sweep, text(angle))


def _mark(vertex: str, start: float, sweep: float, name: str, half: Half) -> AngleMark:
    return AngleMark(half.point(vertex), half.turned(start), half.sense * sweep, name)
