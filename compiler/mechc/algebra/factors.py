"""What a product is made of: lengths, sines and cosines, and what algebra does not see into."""

import math
from collections.abc import Hashable, Mapping
from functools import lru_cache
from typing import Any, Literal, Protocol

from ..base.frozen import Hashed, frozen
from ..formula.evaluate import evaluate
from ..formula.tree import Call, Formula, Number, Pi, Symbol
from ..formula.tree import Constant as ConstantFormula
from .angle import Angle
from .modular import ModularPoint

SineOrCosine = Literal["sin", "cos"]

FactorRank = tuple[int, Any]
"""A place in reading order: a number for each kind of factor, then what is compared within it."""


class Factor(Hashable, Protocol):
    """Anything that may stand in a product."""

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value on floats."""
        ...

    def residue(self, point: ModularPoint) -> int:
        """Return the value at a random point of a finite field."""
        ...

    def formula(self) -> Formula:
        """Return the factor as a formula."""
        ...

    def order(self) -> FactorRank:
        """Return the place in reading order: lengths, sines and cosines, sums."""
        ...


@frozen
class Length:
    """A symbol that is not inside an angle: a length, a radius, a pure number, a load."""

    name: str

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the symbol's value."""
        return values[self.name]

    def residue(self, point: ModularPoint) -> int:
        """Return the symbol's random value."""
        return point.length(self.name)

    def formula(self) -> Formula:
        """Return the symbol."""
        return Symbol(self.name)

    def order(self) -> tuple[int, str]:
        """Return the place in reading order."""
        return (0, self.name)


@frozen
class ConstantSymbol(Length):
    """A symbol that has a value: what is decided about it is decided by that."""

    value: Formula

    def __hash__(self) -> int:
        """Return the hash of the name, which no other value has: that of a fraction is dear."""
        return hash(self.name)

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value, whatever the symbols' values."""
        if isinstance(self.value, Number):
            return self.value.value.numerator / self.value.value.denominator
        return evaluate(self.value, {})

    def residue(self, point: ModularPoint) -> int:
        """Return the value in the field; of a root, a random value of its own."""
        if isinstance(self.value, Number):
            return point.rational(self.value.value)
        return point.length(str(self.value))

    def formula(self) -> Formula:
        """Return the symbol with its value."""
        return ConstantFormula(self.name, self.value)


@frozen
class Trig(Hashed):
    """A sine or cosine of a canonical angle; made by ``sine`` and ``cosine`` only."""

    function: SineOrCosine
    angle: Angle

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value on floats."""
        turn = self.angle.evaluate(values)
        return math.sin(turn) if self.function == "sin" else math.cos(turn)

    def residue(self, point: ModularPoint) -> int:
        """Return the value at a random point of a finite field."""
        return point.trig(self.function, self.angle)

    def formula(self) -> Formula:
        """Return ``sin(angle)`` or ``cos(angle)``."""
        return _trig_formula(self)

    def order(self) -> tuple[int, str]:
        """Return the place in reading order."""
        return _trig_order(self)


@lru_cache(maxsize=4096)
def _trig_formula(trig: Trig) -> Formula:
    return Call(trig.function, (trig.angle.formula(),))


@lru_cache(maxsize=4096)
def _trig_order(trig: Trig) -> tuple[int, str]:
    return (1, f"{trig.angle}{trig.function}")


@frozen
class Opaque:
    """A formula that angle algebra does not look into, ``sqrt(a^2 + b^2)`` for example."""

    inside: Formula

    def evaluate(self, values: Mapping[str, float]) -> float:
        """Return the value on floats."""
        return evaluate(self.inside, values)

    def residue(self, point: ModularPoint) -> int:
        """Return a random value of its own."""
        return point.length(_text(self.inside))

    def formula(self) -> Formula:
        """Return the formula itself."""
        return self.inside

    def order(self) -> tuple[int, str]:
        """Return the place in reading order."""
        return (0, "") if isinstance(self.inside, Pi) else (2, _text(self.inside))


@lru_cache(maxsize=4096)
def _text(inside: Formula) -> str:
    return str(inside)


CIRCLE = Opaque(Pi())
"""The number π as a factor."""
