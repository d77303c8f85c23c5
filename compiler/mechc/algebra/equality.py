"""Is one formula equal to another? Exactly, at random points of a finite field.

>>> from ..formula.tree import Call, Number, Symbol, power, number, total
>>> s, c = (power(Call(f, (Symbol("t"),)), number(2)) for f in ("sin", "cos"))
>>> equal(total([s, c]), number(1))
True
>>> equal(s, c)
False
"""

from collections.abc import Sequence
from typing import assert_never

from ..formula.tree import (
    Call,
    Constant,
    Definitions,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    negative,
)
from ..formula.walk import children, rebuild
from .angle import Angle
from .from_formula import to_angle
from .modular import ModularPoint

_TRIES = 3

_TRIGONOMETRIC = {"sin", "cos", "tan", "cot", "sec", "csc"}
_ARCS = {"asin", "acos", "atan", "atan2"}
_ODD = {"asin", "atan"}


def equal(left: Formula, right: Formula, definitions: Definitions = ()) -> bool:
    """Return whether two formulas are the same function of their symbols.

    Names that ``definitions`` explain are looked into, without writing them out.

    True is a proof up to a chance of some 1e-50. False is certain for what angle
    algebra sees; a root or an arc function counts as an unknown quantity of its own,
    the same for equal arguments however they are written. What follows from the function
    itself (a root squared, the sine of an arcsine) may be called different: compare
    numerically then.
    """
    return all(_agree(left, right, definitions, seed) for seed in range(_TRIES))


def _agree(left: Formula, right: Formula, definitions: Definitions, seed: int) -> bool:
    place = _FieldPoint(seed)
    try:
        for name, formula in definitions:
            place.define(name, formula)
        return place.residue(left) == place.residue(right)
    except ZeroDivisionError:
        return False


class _FieldPoint:
    """A random point of a finite field, and what defined names are there."""

    def __init__(self, seed: int) -> None:
        self._point = ModularPoint(seed)
        self._values: dict[str, int] = {}
        self._angles: dict[str, Angle] = {}

    def define(self, name: str, formula: Formula) -> None:
        """Give a name the value of a formula, and its angle if it is one."""
        self._values[name] = self.residue(formula)
        if (angle := self._angle(formula)) is not None:
            self._angles[name] = angle

    def _angle(self, formula: Formula) -> Angle | None:
        """Return a formula as an angle if it is linear in angles, with defined ones put in."""
        angle = to_angle(self._with_arcs_named(formula))
        if angle is None:
            return None
        result = Angle.constant(angle.degrees)
        for name, c in angle.terms:
            result = result + self._angles.get(name, Angle.of(name)) * c
        return result

    def _with_arcs_named(self, formula: Formula) -> Formula:
        """Return a formula with a symbol for each arc function in it."""
        match formula:
            case Call(function, arguments) if function in _ARCS:
                return self._named(function, arguments)
            case Sum() | Product():
                parts = (self._with_arcs_named(part) for part in children(formula))
                return rebuild(formula, tuple(parts))
            case _:
                return formula

    def _named(self, function: str, arguments: Sequence[Formula]) -> Formula:
        """Return the symbol of a function's value, one for equal arguments."""
        values = [self.residue(argument) for argument in arguments]
        is_turned = function in _ODD and 2 * values[0] > self._point.prime
        if is_turned:
            values[0] = self._point.prime - values[0]
        symbol = Symbol(f"{function} {values}")
        return negative(symbol) if is_turned else symbol

    def residue(self, formula: Formula) -> int:
        """Return the value of a formula."""
        point = self._point
        match formula:
            case Constant(_, known):
                return self.residue(known)
            case Number(value):
                return point.rational(value)
            case Symbol(name):
                given = self._values.get(name)
                return point.length(name) if given is None else given
            case Sum(terms):
                return sum(map(self.residue, terms)) % point.prime
            case Product(factors):
                result = 1
                for factor in factors:
                    result = result * self.residue(factor) % point.prime
                return result
            case Power(base, Number(value)) if value.denominator == 1:
                return point.power(self.residue(base), value.numerator)
            case Call(function, (argument,)) if (
                function in _TRIGONOMETRIC and (angle := self._angle(argument)) is not None
            ):
                return self._trigonometric(function, angle)
            case Power(base, exponent):
                return self.residue(self._named("power", (base, exponent)))
            case Call(function, arguments):
                return self.residue(self._named(function, arguments))
            case Pi() | Implicit():
                return point.length(str(formula))
            case _:
                assert_never(formula)

    def _trigonometric(self, function: str, angle: Angle) -> int:
        """Return the residue of a function of an angle, by those of its sine and cosine."""
        point = self._point
        sin, cos = point.trig("sin", angle), point.trig("cos", angle)
        match function:
            case "sin":
                return sin
            case "cos":
                return cos
            case "tan":
                return sin * point.power(cos, -1) % point.prime
            case "cot":
                return cos * point.power(sin, -1) % point.prime
            case "sec":
                return point.power(cos, -1)
            case _:
                return point.power(sin, -1)
