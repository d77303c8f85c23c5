"""A printer of formulas in the arithmetic of most languages.

A target's printer says how it writes numbers, names and calls; precedence, fractions
and minus signs are decided here, in the order of :mod:`mechc.routine.quotient`.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from enum import IntEnum
from fractions import Fraction
from functools import reduce
from typing import assert_never

from ..formula.choices import equal_within, spelled_out
from ..formula.tree import Call, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol
from ..model.result import DrivingLoad
from ..routine.quotient import is_decimal, quotient_of
from ..routine.steps import Guard, ResultStatus


class Level(IntEnum):
    """Where a formula stands, by what must be put in parentheses there."""

    SUM = 0
    """At the outset, in an argument, or as a term."""
    PRODUCT = 1
    """As a factor above the line."""
    DIVISOR = 2
    """As the whole divisor, or under a minus sign's operand that must hold together."""


class Printer(ABC):
    """Prints formulas with the target's names for symbols."""

    def __init__(self, names: Mapping[str, str]) -> None:
        """Take the target's name of every symbol (:func:`mechc.emit.names.mangle`)."""
        self.names = names

    @property
    @abstractmethod
    def pi(self) -> str:
        """Return the target's π."""

    @abstractmethod
    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of one of the language's functions with one or two arguments."""

    @abstractmethod
    def power(self, base: str, exponent: str) -> str:
        """Return a power whose exponent is not a small whole number."""

    def print(self, formula: Formula, level: Level = Level.SUM) -> str:
        """Return the formula as it must be written at a level."""
        match formula:
            case Number(value):
                return self._number(value, level)
            case Pi():
                return self.pi
            case Symbol(name):
                return self.names[name]
            case Sum(terms):
                return _enclosed(reduce(_join, map(self._term, terms)), level > Level.SUM)
            case Product():
                return self._product(formula, level)
            case Power(_, Number(value)) if value < 0:
                return self._product(Product((formula,)), level)
            case Power(Symbol() as base, Number(value)) if value in (2, 3):
                return self._product(Product((base,) * int(value)), level)
            case Power(base, exponent):
                return self.power(self.print(base), self.print(exponent))
            case Call(function, arguments):
                if simpler := spelled_out(function, arguments):
                    return self.print(simpler, level)
                return self._call(function, arguments, level)
            case Implicit():
                raise TypeError("a solution is a step of its own")
            case _:
                assert_never(formula)

    def condition(self, guard: Guard) -> str:
        """Return a guard as a comparison in the code of the target.

        Sides that are to be equal may differ by as much as rounding can make them.
        """
        if guard.operator == "=":
            gap, slack = equal_within(guard.left, guard.right)
            return f"{self.print(gap)} <= {self.print(slack)}"
        return f"{self.print(guard.left)} {guard.operator} {self.print(guard.right)}"

    def _term(self, term: Formula) -> str:
        return self.print(term, Level.PRODUCT if isinstance(term, Sum) else Level.SUM)

    def _number(self, value: Fraction, level: Level) -> str:
        if is_decimal(value):
            return _enclosed(repr(float(value)), value < 0 and level > Level.SUM)
        quotient = f"{float(value.numerator)!r}/{float(value.denominator)!r}"
        return _enclosed(quotient, level > Level.SUM)

    def _call(self, function: str, arguments: tuple[Formula, ...], level: Level) -> str:
        if function in _QUOTIENTS:
            above, below = _QUOTIENTS[function]
            upper = tuple(Call(name, arguments) for name in above)
            return self._product(
                Product((*upper, Power(Call(below, arguments), _MINUS_ONE))), level
            )
        return self._nested(function, [self.print(a) for a in arguments])

    def _nested(self, function: str, arguments: list[str]) -> str:
        """Return a call of two arguments at most: min, max and hypot take their own results.

        Only a choice has three.
        """
        if len(arguments) <= 2 or function == "choose":
            return self.call(function, arguments)
        return reduce(lambda left, right: self.call(function, [left, right]), arguments)

    def _product(self, formula: Product, level: Level) -> str:
        negative, above, below = quotient_of(formula)
        line = "*".join(self.print(f, Level.PRODUCT) for f in above) or "1.0"
        if len(below) == 1:
            line += f"/{self.print(below[0], Level.DIVISOR)}"
        elif below:
            line += f"/({'*'.join(self.print(f, Level.PRODUCT) for f in below)})"
        together = level is Level.DIVISOR and (len(above) > 1 or bool(below))
        return _enclosed(f"-{line}" if negative else line, together or (negative and level > 0))


_MINUS_ONE = Number(Fraction(-1))
_QUOTIENTS = {"cot": (("cos",), "sin"), "sec": ((), "cos"), "csc": ((), "sin")}
"""What few languages have a function for: factors above the line, and the one below."""


def _enclosed(text: str, needed: bool) -> str:
    return f"({text})" if needed else text


def _join(left: str, right: str) -> str:
    return f"{left} - {right[1:]}" if right.startswith("-") else f"{left} + {right}"


def driving(status: ResultStatus, printer: Printer, call: Callable[[str], str]) -> tuple[str, str]:
    """Return the code of the load that drives, without friction and with it.

    Of a load or a ratio the second one is its own ``value``.
    """
    if isinstance(status.drive, DrivingLoad):
        return printer.print(status.drive.ideal), printer.print(status.drive.load)
    return call(status.drive), "value"
