"""Directions and places."""

import math
from collections.abc import Iterable, Iterator, Sequence

from ...diagnostics.model import quantities
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, degrees
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...units import ANGLE, LENGTH, Dimension
from ..constants import out_of_reach
from ..mechanism import Absolute, AlongLine, Direction, Offset
from ..names.scope import DESCRIPTION, NameScope
from ..tolerances import SAME_DIRECTION
from .expressions import Reader

QUARTERS = {("x", 1): 0, ("y", 1): 90, ("x", -1): 180, ("y", -1): -90}
"""The axes as angles in degrees, by their name and sign."""


def read_direction(
    direction: ast.Direction, scope: NameScope, what: str = "a direction"
) -> Direction | None:
    """Return a direction; a point that one is aimed by counts as used."""
    match direction:
        case ast.Axis(axis, sign, span):
            return Absolute(degrees(QUARTERS[axis, sign]), span)
        case ast.Toward(name, sign, perp, span):
            ends = scope.points.acting(name)
            quarter = (1 if perp else 0) + (2 if sign < 0 else 0)
            return AlongLine(ends[0], ends[1], quarter, span) if ends else None
        case _:
            angle = Reader(scope, DESCRIPTION).wanted(direction, ANGLE, what)
            check_reach(angle, ANGLE, direction.span, scope)
            return Absolute(angle, direction.span) if angle else None


def read_place(tail: str, head: str, place: ast.Cartesian, scope: NameScope) -> Offset | None:
    """Return a vector by its components."""
    reader = Reader(scope, DESCRIPTION)
    x = reader.wanted(place.x, LENGTH, "the place")
    y = reader.wanted(place.y, LENGTH, "the place")
    for part, written in ((x, place.x), (y, place.y)):
        check_reach(part, LENGTH, written.span, scope)
    units = units_of((place.x, place.y))
    if len(set(units)) > 1:
        scope.report.add(quantities.coordinates_in_two_units(place.span, *units))
    return Offset(tail, head, x, y, place.span) if x and y else None


def note_units(ends: Sequence[ast.Expr | None], what: str, span: Span, scope: NameScope) -> None:
    """Say that the ends of a range or of a stroke are in two units."""
    units = units_of(end for end in ends if end is not None)
    if len(set(units)) > 1:
        scope.report.add(quantities.range_in_two_units(span, what, *units))


def is_beyond_a_turn(*angles: float) -> bool:
    """Return whether one of some angles in radians is more than a turn: W245 says so."""
    return max(map(abs, angles), default=0.0) > math.tau


def units_of(written: Iterable[ast.Expr]) -> list[str]:
    """Return the units of those among expressions that are numbers, and not zero."""
    return [unit for unit in map(_unit_of, written) if unit]


def _unit_of(written: ast.Expr) -> str:
    """Return the unit of a number that is not zero, '' of anything else."""
    match written:
        case ast.Number(unit=unit) as found:
            return unit if found.value else ""
        case ast.Sum(terms=((_, single),)):
            return _unit_of(single)
        case _:
            return ""


def value_of(formula: Formula, scope: NameScope) -> float | None:
    """Return the value at the given parameters; None where one of them has none."""
    if not symbols(formula) <= scope.values.keys():
        return None
    return evaluate(formula, scope.values)


def check_sign(formula: Formula | None, span: Span, what: str, scope: NameScope) -> None:
    """Report a quantity that cannot be negative and is, or is in a part of the range given.

    ``what`` names it in messages.
    """
    value = value_of(formula, scope) if formula else None
    cause = None
    if formula and value is not None and value < 0:
        cause = scope.cause(formula, span)
    elif formula:
        cause = next(_ends_below_zero(formula, scope), None)
    if cause is not None:
        written = scope.report.source.written(cause)
        scope.report.add(quantities.negative_quantity(span, what, written, cause))


def _ends_below_zero(formula: Formula, scope: NameScope) -> Iterator[Span]:
    """Yield the lower ends of ranges, below zero, at which a formula is negative, too."""
    for name in sorted(symbols(formula) & scope.lower_ends.keys()):
        low, _ = scope.ranges[name]
        values = {**scope.values, name: low}
        if low < 0 and symbols(formula) <= values.keys() and evaluate(formula, values) < 0:
            yield scope.lower_ends[name]


def check_reach(
    formula: Formula | None, dimension: Dimension, span: Span, scope: NameScope
) -> None:
    """Report a value that is no real number, or none to compute with.

    Parameters without a value count as 1: multiples of them must be in reach, too.
    """
    if formula is None:
        return
    value = scope.size(formula)
    if not math.isfinite(value) and symbols(formula) <= scope.values.keys():
        scope.report.add(quantities.no_value(span))
    elif out_of_reach(value, dimension):
        scope.report.add(quantities.out_of_reach(span, dimension))


def parallel(a: Direction, b: Direction, scope: NameScope) -> bool:
    """Return whether two directions may lie along one line: False only where surely not."""
    if not isinstance(a, Absolute) or not isinstance(b, Absolute):
        return True
    first, second = value_of(a.angle, scope), value_of(b.angle, scope)
    if first is None or second is None:
        return True
    return not abs(math.sin(first - second)) > SAME_DIRECTION
