"""Directions as vectors: an angle is turned by without being known as an angle.

A unit vector is kept with its size undivided, so that the sizes of several end up in one
division.
"""

from collections import Counter
from collections.abc import Callable, Mapping

from ..algebra.angle import Angle
from ..algebra.trigonometry import cosine, sine
from ..base.named import NamedTuple
from ..formula.tree import ONE, Call, Formula, Product, negative, product, total


class DirectionVector(NamedTuple):
    """The direction ``(x, y)/size`` of an angle; ``size`` is the positive hypotenuse."""

    x: Formula
    y: Formula
    size: Formula = ONE

    @property
    def cos(self) -> Formula:
        """Return the cosine of the angle."""
        return over(self.x, self.size)

    @property
    def sin(self) -> Formula:
        """Return the sine of the angle."""
        return over(self.y, self.size)

    def turned(self, by: "DirectionVector") -> "DirectionVector":
        """Return the direction of a sum of two angles."""
        return DirectionVector(
            total([times(self.x, by.x), negative(times(self.y, by.y))]),
            total([times(self.y, by.x), times(self.x, by.y)]),
            _gathered([self.size, by.size]),
        )

    def back(self) -> "DirectionVector":
        """Return the direction of the opposite angle."""
        return DirectionVector(self.x, negative(self.y), self.size)


WANTED: Mapping[str, Callable[[DirectionVector], Formula]] = {
    "sin": lambda u: u.sin,
    "cos": lambda u: u.cos,
    "tan": lambda u: over(u.y, u.x),
    "cot": lambda u: over(u.x, u.y),
    "sec": lambda u: over(u.size, u.x),
    "csc": lambda u: over(u.size, u.y),
}
"""Each function of an angle, from its direction."""


def plain(angle: Angle) -> DirectionVector:
    """Return the direction of an angle by its own cosine and sine; of a negative one, back."""
    if all(c < 0 for _, c in angle.terms):
        return plain(-angle).back() if angle.terms else _constant(angle)
    return DirectionVector(Call("cos", (angle.formula(),)), Call("sin", (angle.formula(),)))


def _constant(angle: Angle) -> DirectionVector:
    return DirectionVector(cosine(angle).formula(), sine(angle).formula())


def whole(units: list[DirectionVector]) -> DirectionVector:
    """Return the direction of a sum of angles."""
    result = units[0]
    for unit in units[1:]:
        result = result.turned(unit)
    return result


def times(a: Formula, b: Formula) -> Formula:
    """Return ``a·b``."""
    return product([(a, 1), (b, 1)])


def over(a: Formula, b: Formula) -> Formula:
    """Return ``a/b``."""
    return product([(a, 1), (b, -1)])


def factors(size: Formula) -> int:
    """Return of how many factors a size is made."""
    return len(size.factors) if isinstance(size, Product) else 1


def _gathered(sizes: list[Formula]) -> Formula:
    """Return a product of sizes with equal ones as powers."""
    factors = [f for s in sizes for f in (s.factors if isinstance(s, Product) else (s,))]
    return product(Counter(factors).items())
