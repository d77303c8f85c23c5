"""Signs of slips and forces: of a printed case, or of whatever pose is evaluated.

A closed form needs to know which way each joint slips and whether each rod is pressed or
pulled. Code takes these signs from the ideal solution at the pose; a printed formula
states one case, that of the default pose.
"""

from collections.abc import Mapping
from typing import Protocol

from ...algebra.angle import Angle, Rational
from ...algebra.factors import Length, Trig
from ...algebra.product import Product
from ...formula.tree import Call, Formula
from ...formula.walk import evaluate
from ...model.result import Definition


class Signs(Protocol):
    """A way to write signs down, and what it had to name so far."""

    definitions: list[Definition]

    def of(self, name: str, value: Product) -> Product:
        """Return the sign of a value, which may be called ``name``."""
        ...

    def turned(self, name: str, line: Angle, sine: Product) -> Angle:
        """Return a line turned by the arcsine of a product, which may be called ``name``."""
        ...

    def named(self, name: str, value: Product) -> Product:
        """Return a value, by a name where it is more than a product of few factors."""
        ...


class _Names:
    """The names in order of definition."""

    def __init__(self) -> None:
        self.definitions: list[Definition] = []

    def named(self, name: str, value: Product) -> Product:
        """Return a value, by a name where it is a sum or holds a root."""
        if all(isinstance(factor, Length | Trig) for factor in value.factors):
            return value
        self.define(name, value.formula())
        return Product.symbol(name)

    def define(self, name: str, formula: Formula) -> None:
        """Note a definition, once."""
        definition = Definition(name, formula)
        if definition not in self.definitions:
            self.definitions.append(definition)


class AtAnyPose(_Names):
    """Signs and turns as names with formulas of their own."""

    def of(self, name: str, value: Product) -> Product:
        """Return the name of the sign."""
        if not value.factors:
            return Product(_sign(value.coefficient))
        self.define(name, Call("sign", (value.formula(),)))
        return Product.symbol(name)

    def turned(self, name: str, line: Angle, sine: Product) -> Angle:
        """Return the line turned by a named angle, which carries its sign."""
        if not sine:
            return line
        self.define(name, Call("asin", (sine.formula(),)))
        return line + Angle.of(name)


class AtOnePose(_Names):
    """Signs as numbers, and turns as positive angles, as they are at one pose."""

    def __init__(self, values: Mapping[str, float]) -> None:
        super().__init__()
        self._values = dict(values)

    def of(self, name: str, value: Product) -> Product:
        """Return 1, 0 or -1."""
        return Product(_sign(value.evaluate(self._values)))

    def turned(self, name: str, line: Angle, sine: Product) -> Angle:
        """Return the line turned by a positive angle, one way or the other."""
        sign = _sign(sine.evaluate(self._values)) if sine else 0
        if not sign:
            return line
        self.define(name, Call("asin", (sine.scaled(sign).formula(),)))
        return line + Angle.of(name) * sign

    def define(self, name: str, formula: Formula) -> None:
        """Note a definition, and its value."""
        super().define(name, formula)
        self._values[name] = evaluate(formula, self._values)


def _sign(value: float | Rational) -> int:
    return (value > 0) - (value < 0)
