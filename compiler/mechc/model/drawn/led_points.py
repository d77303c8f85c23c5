"""Where points stand that are not drawn, but to which given vectors lead from drawn ones.

``OA = r @ phi`` puts A where it is at the default pose. A rod between A and a drawn point has
the length that it has there, whatever phi becomes: the steps along arms are numbers.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from ...formula.evaluate import evaluate
from ...formula.tree import Formula, negative, number, total
from ...formula.walk import symbols
from ...named import NamedTuple
from ...source import Span
from ..mechanism import Absolute, Arrow, Geometry, Offset, Turn
from ..values import Values

Vector = tuple[Formula, Formula]


class _Step(NamedTuple):
    """A vector by components from one point to another, and where it is written."""

    start: str
    end: str
    way: Vector
    span: Span


def led_points(
    geometry: Iterable[Geometry], placed: Mapping[str, Vector], values: Values
) -> dict[str, tuple[Vector, Span]]:
    """Return where points are to which vectors lead that are given whole, one after another."""
    steps = [step for entry in geometry for step in _steps(entry, values)]
    known, found = dict(placed), dict[str, tuple[Vector, Span]]()
    while step := next((s for s in steps if s.start in known and s.end not in known), None):
        at = tuple(total(pair) for pair in zip(known[step.start], step.way, strict=True))
        known[step.end] = at[0], at[1]
        found[step.end] = known[step.end], step.span
    return found


def _steps(entry: Geometry, values: Values) -> Iterator[_Step]:
    """Yield a given vector in both senses."""
    if not isinstance(entry, Turn) and entry.tail and (way := _way(entry, values)):
        yield _Step(entry.tail, entry.head, way, entry.span)
        yield _Step(entry.head, entry.tail, (negative(way[0]), negative(way[1])), entry.span)


def _way(entry: Arrow | Offset, values: Values) -> Vector | None:
    """Return the components of a vector that is given by them, or by length and direction."""
    match entry:
        case Offset(_, _, x, y):
            return x, y
        case Arrow(_, _, length, Absolute(angle)) if length is not None:
            if symbols(length) | symbols(angle) <= values.keys():
                size, turned = evaluate(length, values), evaluate(angle, values)
                steps = size * math.cos(turned), size * math.sin(turned)
                return number(Fraction(steps[0])), number(Fraction(steps[1]))
    return None
