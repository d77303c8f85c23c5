"""The places of points as they are drawn, as formulas and in metres."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...algebra.sums import add
from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.tree import ZERO, Formula, negative, number, total
from ...formula.walk import substitute, symbols
from ...source import Span
from ...units import in_unit
from ..entries import points_of, unit_of_drawing
from ..mechanism import Absolute, Arrow, Direction, Geometry, Mechanism, Offset, Turn
from ..tolerances import SAME_PLACE, SAME_VECTOR
from ..values import Values


class DrawnPlace(NamedTuple):
    """Where a point is drawn: its coordinates as formulas, and in metres."""

    x: Formula
    y: Formula
    at: tuple[float, float]
    span: Span

    @property
    def symbols(self) -> frozenset[str]:
        """Return the parameters in the coordinates."""
        return symbols(self.x) | symbols(self.y)


ORIGIN = DrawnPlace(ZERO, ZERO, (0.0, 0.0), Span(0, 0))
"""Where the ground's coordinates begin; its name is empty."""

AlgebraicVector = tuple[Product, Product]


class DrawnPoints:
    """Where points are drawn, and the vectors between them.

    ``values`` are those of parameters, ``led`` the points that arrows lead to, ``given`` those
    of them to which arrows lead from the ground, and ``unit`` is that of the drawing.
    """

    def __init__(self, mechanism: Mechanism, values: Mapping[str, float]) -> None:
        self.values = values
        self.pivots = mechanism.fixed
        self.places: dict[str, DrawnPlace] = {}
        self.unit = unit_of_drawing(mechanism)
        for entry in mechanism.geometry:
            if isinstance(entry, Offset) and not entry.tail:
                self._place(entry.head, entry.x, entry.y, entry.span)
        fixed = {name: (place.x, place.y) for name, place in self.places.items()}
        for drawn in mechanism.drawn:
            self._place(drawn.point, drawn.x, drawn.y, drawn.span)
        placed = {name: (place.x, place.y) for name, place in self.places.items()}
        led = _led_points(mechanism.geometry, fixed, values) if mechanism.drawn else {}
        exact = {name: way for name, (way, _) in led.items()}  # a drawn place has few digits
        led |= _led_points(mechanism.geometry, placed | exact, values) if mechanism.drawn else {}
        led = {name: found for name, found in led.items() if name not in placed}
        self.led = frozenset(led)
        self.given = frozenset(exact) - placed.keys()
        for point, ((x, y), span) in led.items():
            self._place(point, x, y, span)

    def _place(self, point: str, x: Formula, y: Formula, span: Span) -> None:
        if symbols(x) | symbols(y) <= self.values.keys():
            at = evaluate(x, self.values), evaluate(y, self.values)
            self.places[point] = DrawnPlace(x, y, at, span)

    def put(self, values: Mapping[str, Formula]) -> None:
        """Put values for parameters into the coordinates."""
        for point, place in self.places.items():
            if not place.symbols.isdisjoint(values):
                x, y = substitute(place.x, values), substitute(place.y, values)
                self._place(point, x, y, place.span)

    def has_all(self, points: Iterable[str]) -> bool:
        """Return whether points are drawn."""
        return self.places.keys() >= set(points)

    def has(self, entry: Geometry) -> bool:
        """Return whether the points of an entry are drawn; the origin is in every drawing."""
        return self.has_all(set(points_of(entry)) - {""})

    def span(self, point: str) -> Span:
        """Return where a point's place is written."""
        return self.places[point].span

    @property
    def size(self) -> float:
        """Return the width or height of the drawing, whichever is greater."""
        far = [place.at for place in self.places.values()]
        wide, high = ([at[i] for at in far] for i in (0, 1))
        return max(max(wide) - min(wide), max(high) - min(high))

    @property
    def rounding(self) -> float:
        """Return the gap in metres below which places are one."""
        return SAME_PLACE * self.size

    def shown(self, gap: float) -> str:
        """Return a length in the unit of the drawing."""
        return in_unit(gap, self.unit or "m", 3)

    def coincide(self, first: str, second: str) -> bool:
        """Return whether two points are drawn at one place."""
        gap = math.dist(self.places[first].at, self.places[second].at)
        return gap <= self.rounding

    def way(self, tail: str, head: str) -> tuple[float, float]:
        """Return the vector between two points in metres; the origin's name is empty."""
        ax, ay = self.places[tail].at if tail else (0.0, 0.0)
        bx, by = self.places[head].at
        return bx - ax, by - ay

    def arms(self, points: Sequence[str]) -> Iterator[tuple[str, str]]:
        """Yield the arms of a body's drawn points, from a pivot where it has one."""
        known = [p for p in points if p in self.places]
        hub = next((p for p in known if p in self.pivots), known[0] if known else "")
        yield from ((hub, p) for p in known if p != hub)

    def turned(self, direction: Direction) -> float | None:
        """Return a direction in radians where it is an angle with a value."""
        if isinstance(direction, Absolute) and symbols(direction.angle) <= self.values.keys():
            return evaluate(direction.angle, self.values)
        return None

    def value_of(self, length: Formula | None) -> float | None:
        """Return a given length in metres, None where it has no value."""
        known = length is not None and symbols(length) <= self.values.keys()
        return evaluate(length, self.values) if length is not None and known else None

    def lay_on_line(self, point: str, tail: str, head: str) -> None:
        """Move a drawn point to the line through two others, where it is not quite on it."""
        x, y = self.components(tail, head)
        px, py = self.components(tail, point)
        if not add([x * py, -(y * px)]):
            return
        part = self.value(add([x * px, y * py])) / self.value(add([x * x, y * y]))
        start, share = self.places[tail], Product(Fraction(part))
        ends = ((start.x, x), (start.y, y))
        moved = [add([to_product(at), step * share]).formula() for at, step in ends]
        self._place(point, moved[0], moved[1], self.span(point))

    def components(self, tail: str, head: str) -> AlgebraicVector:
        """Return the vector between two points; the origin's name is empty."""
        start, end = self.places[tail] if tail else ORIGIN, self.places[head]
        x = add([to_product(end.x), -to_product(start.x)])
        return x, add([to_product(end.y), -to_product(start.y)])

    def are_along(self, one: AlgebraicVector, other: AlgebraicVector) -> bool:
        """Return whether two vectors have one direction but for rounding."""
        ahead = add([a * b for a, b in zip(one, other, strict=True)])
        across = add([one[0] * other[1], -(one[1] * other[0])])
        sizes = (math.hypot(*map(self.value, vector)) for vector in (one, other))
        return abs(self.value(across)) <= SAME_VECTOR * math.prod(sizes) and self.value(ahead) > 0

    def are_equal(self, one: AlgebraicVector, other: AlgebraicVector) -> bool:
        """Return whether two vectors have one length but for rounding."""
        sizes = (math.hypot(*map(self.value, vector)) for vector in (one, other))
        return math.isclose(*sizes, rel_tol=SAME_VECTOR)

    def value(self, product: Product) -> float:
        """Return the value of a product as it is drawn."""
        return product.evaluate(self.values)


# --------------------------------------------------------------------------------------- led points


FormulaVector = tuple[Formula, Formula]


class _Step(NamedTuple):
    """A vector by components from one point to another, and where it is written."""

    start: str
    end: str
    way: FormulaVector
    span: Span


def _led_points(
    geometry: Iterable[Geometry], placed: Mapping[str, FormulaVector], values: Values
) -> dict[str, tuple[FormulaVector, Span]]:
    """Return where points are to which vectors lead that are given whole, one after another."""
    steps = [step for entry in geometry for step in _steps(entry, values)]
    known, found = dict(placed), dict[str, tuple[FormulaVector, Span]]()
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


def _way(entry: Arrow | Offset, values: Values) -> FormulaVector | None:
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
