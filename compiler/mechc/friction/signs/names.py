"""How signs of slips and forces are written: of a printed case, or of whatever pose is evaluated.

A closed form needs to know which way each joint slips and whether each rod is pressed or
pulled. Code takes these signs from the ideal solution at the pose; a printed formula
states one case, that of the default pose.
"""

from collections.abc import Sequence, Set
from typing import Literal, Protocol

from ...algebra.angle import Angle, Rational
from ...algebra.factors import Length, Opaque, Trig
from ...algebra.product import Product
from ...formula.names import another
from ...formula.tree import Call, Formula
from ...model.result import Definition
from ..naming import Meanings

Inverse = Literal["asin", "atan"]
"""The function that gives a turn."""


class SignSymbols(Protocol):
    """A way to write signs down, and what it had to name so far.

    ``is_read`` where people read the formula, so that its steps are noted.
    """

    definitions: list[Definition]
    is_read: bool

    def name_radius(self, name: str, factor: Product) -> Product:
        """Return the radius of a friction circle, which may be called ``name``."""
        ...

    def name_coefficient(self, name: str, factor: Product) -> Product:
        """Return the coefficient of friction of a joint, which may be called ``name``."""
        ...

    def note_sign(self, name: str, value: Product) -> Product:
        """Return the sign of a value, which may be called ``name``."""
        ...

    def way(self, value: Product) -> int:
        """Return -1 for a value that is written as the opposite of a positive one, else 1."""
        ...

    def note_sense(self, name: str, slip: Product) -> Product:
        """Return the sense of a slip, 0 where that is rounding; it may be called ``name``."""
        ...

    def turn_line(self, name: str, line: Angle, by: Inverse, value: Product) -> Angle:
        """Return a line turned by the arc of a sine or tangent, which may be called ``name``."""
        ...

    def unsquared(self, value: Product) -> Product:
        """Return a product without the squares of signs, which are 1 but at single poses."""
        ...

    def note_arm_beyond(self, arm: Product, radius: Product, ahead: Product) -> bool:
        """Return whether an arm exceeds a radius, as it does if a force turns a lever; note it.

        Otherwise ``ahead`` is positive, and that is noted. The arm's sign was asked for before.
        """
        ...

    def note_alike(self, value: Product, other: Product) -> None:
        """Note that what has a name has the sign of something simpler."""
        ...

    def require_positive(self, value: Product) -> bool:
        """Note that a value is positive, or nothing balances; return whether it can be."""
        ...

    def name_value(self, name: str, value: Product) -> Product:
        """Return a value, by a name where it is more than a product of few factors."""
        ...

    def define(self, name: str, formula: Formula) -> str:
        """Return the name of a formula from now on: ``name``, if that is free."""
        ...


class SignNames:
    """The names in order of definition; what is the same has one name."""

    def __init__(self, taken: Set[str], meanings: Meanings, endings: Sequence[str]) -> None:
        self.definitions: list[Definition] = []
        self._taken, self._meanings, self._endings = set(taken), meanings, endings
        self._known: dict[Formula, str] = {}

    def name_value(self, name: str, value: Product) -> Product:
        """Return a value, by a name unless it is a number, or one length, sine or cosine."""
        if not value.factors or _is_single(value):
            return value
        return Product.symbol(self.define(name, value.formula()))

    def define(self, name: str, formula: Formula) -> str:
        """Return the name of a formula from now on."""
        if formula not in self._known:
            name = self._named_once(name, formula)
            self._known[formula] = name
            self.definitions.append(Definition(name, formula))
        return self._known[formula]

    def _named_once(self, name: str, formula: Formula) -> str:
        """Return a name that is free here and means nothing else in other results."""
        ways = (name, *(f"{name}_{ending}" for ending in self._endings))
        allowed = (n for n in ways if n not in self._taken and self._meanings.allow(n, formula))
        name = self.fresh(next(allowed, ways[-1]))
        while not self._meanings.allow(name, formula):
            name = self.fresh(name)
        return name

    def fresh(self, name: str) -> str:
        """Return a name that nothing else has: ``name``, if that is free."""
        while name in self._taken:
            name = another(name)
        self._taken.add(name)
        return name

    def turn(self, name: str, line: Angle, by: Inverse, value: Product) -> Angle:
        """Return a line turned by an arc, or back by that of the opposite value."""
        there, back = (Call(by, (v.formula(),)) for v in (value, -value))
        if back in self._known:
            return line - Angle.of(self._known[back])
        return line + Angle.of(self.define(name, there))


def is_root(value: Product) -> bool:
    """Return whether a product is a single square root."""
    match list(value.factors.items()):
        case [(Opaque(Call("sqrt" | "hypot")), 1)]:
            return True
        case _:
            return False


def _is_single(value: Product) -> bool:
    (factor, exponent), *more = value.factors.items()
    return not more and exponent == 1 and isinstance(factor, Length | Trig)


def bare(value: Product) -> Product:
    """Return a product of the same sign, with no more in it than that needs."""
    odd = {factor: 1 for factor, exponent in value.factors.items() if exponent % 2}
    return Product(exact_sign(value.coefficient), odd)


def exact_sign(value: Rational) -> int:
    """Return the sign of a coefficient, which may be as small as it likes."""
    return (value > 0) - (value < 0)
