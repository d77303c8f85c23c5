"""A mechanism as it is drawn: the places of its points, and quantities that follow from them.

A derived length, direction or angle has a name and is a parameter: a constant where the
coordinates are numbers, or a formula of the parameters that they rest on.
"""

from collections.abc import Mapping

from ...algebra.product import ZERO, Product, Sum
from ...algebra.sums import add
from ...base.named import NamedTuple
from ...formula.names import another
from ...formula.tree import Call, Formula, Number, Symbol, degrees, negative, total
from ...formula.walk import symbols
from ...units import ANGLE, LENGTH, Dimension
from ..constants import number_of, rational
from ..mechanism import Absolute, Mechanism, Parameter
from ..tolerances import SAME_VECTOR
from .components import DrawnLengths, Polar, polar
from .drawn_points import AlgebraicVector, DrawnPoints


class _Vector(NamedTuple):
    components: AlgebraicVector
    length: Formula
    angle: Formula


class Image(NamedTuple):
    """A reflection for a ``sense`` of −1, then a turn by so many degrees, a multiple of 90."""

    sense: int
    turned: int

    def of(self, components: AlgebraicVector) -> AlgebraicVector:
        """Return the image of a vector."""
        x, y = components[0], components[1] if self.sense > 0 else -components[1]
        for _ in range(self.turned // 90 % 4):
            x, y = -y, x
        return x, y


PARALLELS = (Image(1, 0), Image(1, 180))
MIRRORED = (Image(-1, 180), Image(-1, 0), Image(-1, 90), Image(-1, -90))
IMAGES = (*PARALLELS, *MIRRORED, Image(1, 90), Image(1, -90))


class Sketch(DrawnPoints):
    """The drawn points, and the quantities that were named by them so far: ``parameters``."""

    def __init__(self, mechanism: Mechanism, values: Mapping[str, float]) -> None:
        super().__init__(mechanism, values)
        self.parameters: dict[str, Parameter] = {}
        self._taken = {p.name for p in mechanism.parameters} | {p.name for p in mechanism.loads}
        self._vectors: list[_Vector] = []
        self._lengths = DrawnLengths()

    def offset(self, tail: str, head: str) -> tuple[Formula, Formula]:
        """Return the vector between two points by its components."""
        x, y = self.components(tail, head)
        return in_terms(x), in_terms(y)

    def length(self, tail: str, head: str) -> Formula:
        """Return the distance of two points, ``len_AB`` unless it is a parameter by itself."""
        x, y = self.components(tail, head)
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
        x, y = self.components(tail, head)
        angle = self._axis(x, y)
        if angle is None and (found := self.polar(tail, head)):
            angle = found.angle.formula()
        if angle is None:
            value = Call("atan2", (y.formula(), x.formula()))
            angle = self._named(f"phi_{tail}{head}", value, ANGLE, "deg", head)
        return Absolute(angle, self.span(head))

    def start(self, tail: str, head: str) -> Formula:
        """Return the drawn direction between two points that turn on: ``phi_AB_0``."""
        x, y = self.components(tail, head)
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
        x, y = self.components(tail, head)
        return polar(x, y, self.values) if x and y else None

    def vector(self, tail: str, head: str) -> tuple[Formula, Absolute]:
        """Return the length and direction between two points with numbers for coordinates.

        Of vectors that are parallel in the drawing, at right angles, or images of one another
        across an axis, the later has the direction of the first, and its length if it is equal:
        what moves only since it is symmetric must be seen to be so.
        """
        components, span = self.components(tail, head), self.span(head)
        found = self._image(components)
        if found:
            first, angle = found
            is_equal = self.are_equal(first.components, components)
            length = first.length if is_equal else self.length(tail, head)
            direction = Absolute(angle, span)
        else:
            length, direction = self.length(tail, head), self.direction(tail, head)
        self._vectors.append(_Vector(components, length, direction.angle))
        return length, direction

    def _image(self, components: AlgebraicVector) -> tuple[_Vector, Formula] | None:
        """Return an earlier vector and the direction that follows from its own, if one does.

        One that is equal comes before one that is only parallel, and this before an image.
        """
        for image in IMAGES:
            alike = [v for v in self._vectors if self.are_along(image.of(v.components), components)]
            equal = (v for v in alike if self.are_equal(v.components, components))
            if first := next(equal, alike[0] if alike else None):
                turned = first.angle if image.sense > 0 else negative(first.angle)
                return first, total([turned, degrees(image.turned)] if image.turned else [turned])
        return None

    def turn(self, first: str, vertex: str, second: str) -> Formula:
        """Return the counter-clockwise angle at a point between two others."""
        (ax, ay), (bx, by) = self.components(vertex, first), self.components(vertex, second)
        ahead, across = add([ax * bx, ay * by]), add([ax * by, -(ay * bx)])
        axis = self._axis(ahead, across)
        if axis is not None:
            return axis
        value = Call("atan2", (across.formula(), ahead.formula()))
        return self._named(f"delta_{first}{vertex}{second}", value, ANGLE, "deg", second)

    def _axis(self, x: Product, y: Product) -> Formula | None:
        """Return the direction of a vector along an axis, if it is but for rounding."""
        x, y = self._rounded(x, y)
        if x and y:
            return None
        quarter = 90 if y else 0
        return degrees(quarter if self.value(x or y) > 0 else quarter - 180)

    def _rounded(self, x: Product, y: Product) -> tuple[Product, Product]:
        """Return components; one of a vector of numbers that is rounding of the other is 0."""
        if symbols(x.formula(), y.formula()):
            return x, y
        least = SAME_VECTOR * max(abs(self.value(x)), abs(self.value(y)))
        return x if abs(self.value(x)) > least else ZERO, y if abs(self.value(y)) > least else ZERO

    def _positive(self, length: Product) -> Product:
        return length if self.value(length) >= 0 else -length

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


def in_terms(component: Product) -> Formula:
    """Return a component whose terms stand apart, so that a number among them is a length.

    >>> from fractions import Fraction
    >>> from ...formula.to_text import text
    >>> h, low = Product.symbol("h"), Product(Fraction(1, 20))
    >>> text(add([low, -h]).formula()), text(in_terms(add([low, -h])))
    ('(1 - 20*h)/20', '1/20 - h')
    """
    match list(component.factors.items()):
        case [(Sum(terms=terms), 1)]:
            return total(term.scaled(component.coefficient).formula() for term in terms)
        case _:
            return component.formula()
