"""A mechanism as it is drawn: the places of its points, and quantities that follow from them.

A derived length, direction or angle has a name and is a parameter: a constant where the
coordinates are numbers, or a formula of the parameters that they rest on.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ...algebra.from_formula import to_product
from ...algebra.product import Product
from ...algebra.sums import add
from ...formula.names import another
from ...formula.tree import ZERO, Call, Formula, Number, Symbol, degrees, negative, total
from ...formula.walk import evaluate, substitute, symbols
from ...named import NamedTuple
from ...source import Span
from ...units import ANGLE, LENGTH, Dimension, in_unit
from ..constants import number_of, rational
from ..entries import points_of, unit_of_drawing
from ..mechanism import Absolute, Direction, Geometry, Mechanism, Offset, Parameter
from ..tolerances import SAME_PLACE, SAME_VECTOR
from .commensurable import Lengths
from .led_points import led_points
from .polar import Polar, polar


class Place(NamedTuple):
    """Where a point is drawn: its coordinates as formulas, and in metres."""

    x: Formula
    y: Formula
    at: tuple[float, float]
    span: Span

    @property
    def symbols(self) -> frozenset[str]:
        """Return the parameters in the coordinates."""
        return symbols(self.x) | symbols(self.y)


ORIGIN = Place(ZERO, ZERO, (0.0, 0.0), Span(0, 0))
"""Where the ground's coordinates begin; its name is empty."""

Components = tuple[Product, Product]


class _Vector(NamedTuple):
    components: Components
    length: Formula
    angle: Formula


class Image(NamedTuple):
    """A reflection for a ``sense`` of −1, then a turn by so many degrees, a multiple of 90."""

    sense: int
    turned: int

    def of(self, components: Components) -> Components:
        """Return the image of a vector."""
        x, y = components[0], components[1] if self.sense > 0 else -components[1]
        for _ in range(self.turned // 90 % 4):
            x, y = -y, x
        return x, y


PARALLELS = (Image(1, 0), Image(1, 180))
MIRRORED = (Image(-1, 180), Image(-1, 0), Image(-1, 90), Image(-1, -90))
IMAGES = (*PARALLELS, *MIRRORED, Image(1, 90), Image(1, -90))


class Sketch:
    """The drawn points, the pivots with a place, and where vectors lead from these.

    ``parameters`` are the named quantities so far, ``unit`` is that of the drawing.
    """

    def __init__(self, mechanism: Mechanism, values: Mapping[str, float]) -> None:
        self.values = values
        self.pivots = mechanism.fixed
        self.places: dict[str, Place] = {}
        self.parameters: dict[str, Parameter] = {}
        self._taken = {p.name for p in mechanism.parameters} | {p.name for p in mechanism.loads}
        self.unit = unit_of_drawing(mechanism)
        self._vectors: list[_Vector] = []
        self._lengths = Lengths()
        for entry in mechanism.geometry:
            if isinstance(entry, Offset) and not entry.tail:
                self._place(entry.head, entry.x, entry.y, entry.span)
        for drawn in mechanism.drawn:
            self._place(drawn.point, drawn.x, drawn.y, drawn.span)
        placed = {name: (place.x, place.y) for name, place in self.places.items()}
        led = led_points(mechanism.geometry, placed, values) if mechanism.drawn else {}
        self.led = frozenset(led)
        for point, ((x, y), span) in led.items():
            self._place(point, x, y, span)

    def _place(self, point: str, x: Formula, y: Formula, span: Span) -> None:
        if symbols(x) | symbols(y) <= self.values.keys():
            at = evaluate(x, self.values), evaluate(y, self.values)
            self.places[point] = Place(x, y, at, span)

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

    # ------------------------------------------------------------------ named quantities

    def offset(self, tail: str, head: str) -> tuple[Formula, Formula]:
        """Return the vector between two points by its components."""
        x, y = self._components(tail, head)
        return x.formula(), y.formula()

    def length(self, tail: str, head: str) -> Formula:
        """Return the distance of two points, ``len_AB`` unless it is a parameter by itself."""
        x, y = self._components(tail, head)
        if not (x and y):
            value = self._positive(x or y).formula()
        elif found := self.polar(tail, head):
            value = found.length.formula()
        else:
            value = self._hypotenuse(x.formula(), y.formula())
        if isinstance(value, Symbol):
            return value
        if not symbols(value):
            return number_of(value)
        return self._named(f"len_{tail}{head}", value, LENGTH, self.unit, head)

    def _hypotenuse(self, x: Formula, y: Formula) -> Formula:
        exact = rational(x), rational(y)
        if exact[0] is None or exact[1] is None:
            return Call("hypot", (x, y))
        return Number(self._lengths.of(exact[0], exact[1]))

    def direction(self, tail: str, head: str) -> Absolute:
        """Return the direction between two points: along an axis, or named."""
        x, y = self._components(tail, head)
        angle = self._axis(x, y)
        if angle is None and (found := self.polar(tail, head)):
            angle = found.angle.formula()
        if angle is None:
            value = Call("atan2", (y.formula(), x.formula()))
            angle = self._named(f"phi_{tail}{head}", value, ANGLE, "deg", head)
        return Absolute(angle, self.span(head))

    def start(self, tail: str, head: str) -> Formula:
        """Return the drawn direction between two points that turn on: ``phi_AB_0``."""
        x, y = self._components(tail, head)
        angle = self._axis(x, y)
        if angle is not None:
            return angle
        value = Call("atan2", (y.formula(), x.formula()))
        return self._named(f"phi_{tail}{head}_0", value, ANGLE, "deg", head)

    def length_called(self, name: str, value: Number, point: str) -> Formula:
        """Return a length of a joint at a drawn point under a name."""
        return self._named(name, value, LENGTH, self.unit, point)

    def polar(self, tail: str, head: str) -> Polar | None:
        """Return the vector between two points that is written by its length and angle."""
        x, y = self._components(tail, head)
        return polar(x, y, self.values) if x and y else None

    def vector(self, tail: str, head: str) -> tuple[Formula, Absolute]:
        """Return the length and direction between two points with numbers for coordinates.

        Of vectors that are parallel in the drawing, at right angles, or images of one another
        across an axis, the later has the direction of the first, and its length if it is equal:
        what moves only since it is symmetric must be seen to be so.
        """
        components, span = self._components(tail, head), self.span(head)
        found = self._image(components)
        if found:
            first, angle = found
            is_equal = self._same_size(first.components, components)
            length = first.length if is_equal else self.length(tail, head)
            direction = Absolute(angle, span)
        else:
            length, direction = self.length(tail, head), self.direction(tail, head)
        self._vectors.append(_Vector(components, length, direction.angle))
        return length, direction

    def _image(self, components: Components) -> tuple[_Vector, Formula] | None:
        """Return an earlier vector and the direction that follows from its own, if one does.

        One that is equal comes before one that is only parallel, and this before an image.
        """
        for image in IMAGES:
            alike = [v for v in self._vectors if self._along(image.of(v.components), components)]
            equal = (v for v in alike if self._same_size(v.components, components))
            if first := next(equal, alike[0] if alike else None):
                turned = first.angle if image.sense > 0 else negative(first.angle)
                return first, total([turned, degrees(image.turned)] if image.turned else [turned])
        return None

    def turn(self, first: str, vertex: str, second: str) -> Formula:
        """Return the counter-clockwise angle at a point between two others."""
        (ax, ay), (bx, by) = self._components(vertex, first), self._components(vertex, second)
        ahead, across = add([ax * bx, ay * by]), add([ax * by, -(ay * bx)])
        axis = self._axis(ahead, across)
        if axis is not None:
            return axis
        value = Call("atan2", (across.formula(), ahead.formula()))
        return self._named(f"delta_{first}{vertex}{second}", value, ANGLE, "deg", second)

    def lay_on_line(self, point: str, tail: str, head: str) -> None:
        """Move a drawn point to the line through two others, where it is not quite on it."""
        x, y = self._components(tail, head)
        px, py = self._components(tail, point)
        if not add([x * py, -(y * px)]):
            return
        part = self._value(add([x * px, y * py])) / self._value(add([x * x, y * y]))
        start, share = self.places[tail], Product(Fraction(part))
        ends = ((start.x, x), (start.y, y))
        moved = [add([to_product(at), step * share]).formula() for at, step in ends]
        self._place(point, moved[0], moved[1], self.span(point))

    def _components(self, tail: str, head: str) -> Components:
        start, end = self.places[tail] if tail else ORIGIN, self.places[head]
        x = add([to_product(end.x), -to_product(start.x)])
        return x, add([to_product(end.y), -to_product(start.y)])

    def _axis(self, x: Product, y: Product) -> Formula | None:
        """Return the direction of a vector along an axis."""
        if x and y:
            return None
        quarter = 90 if y else 0
        return degrees(quarter if self._value(x or y) > 0 else quarter - 180)

    def _along(self, one: Components, other: Components) -> bool:
        """Return whether two vectors have one direction but for rounding."""
        ahead = add([a * b for a, b in zip(one, other, strict=True)])
        across = add([one[0] * other[1], -(one[1] * other[0])])
        sizes = (math.hypot(*map(self._value, vector)) for vector in (one, other))
        return abs(self._value(across)) <= SAME_VECTOR * math.prod(sizes) and self._value(ahead) > 0

    def _same_size(self, one: Components, other: Components) -> bool:
        sizes = (math.hypot(*map(self._value, vector)) for vector in (one, other))
        return math.isclose(*sizes, rel_tol=SAME_VECTOR)

    def _positive(self, length: Product) -> Product:
        return length if self._value(length) >= 0 else -length

    def _value(self, product: Product) -> float:
        return product.evaluate(self.values)

    def _named(
        self, name: str, value: Formula, dimension: Dimension, unit: str, point: str
    ) -> Formula:
        """Return a parameter of this value, a number if possible, by this name or one like it."""
        if not symbols(value):
            value = number_of(value)
        while self._means_another(name, value):
            name = another(name)
        made = Parameter(name, dimension, self.span(point), value, unit=unit, dependent=True)
        self.parameters.setdefault(name, made)
        return Symbol(name)

    def _means_another(self, name: str, value: Formula) -> bool:
        """Return whether a name stands for something else already."""
        known = self.parameters.get(name)
        return name in self._taken if known is None else known.value != value
