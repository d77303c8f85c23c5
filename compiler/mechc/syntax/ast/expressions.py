"""Expressions, and the directions and places that are made of them."""

from fractions import Fraction
from typing import Literal

from ...base.frozen import field, frozen
from ...source import Span


@frozen
class Name:
    """An identifier as written: a point ``A``, points ``OBA``, a parameter ``alpha``."""

    text: str
    span: Span = field(compare=False)


@frozen
class Number:
    """A number with the unit attached to it; ``digits`` are as typed, ``unit`` may be ''."""

    digits: str
    unit: str
    span: Span = field(compare=False)

    @property
    def value(self) -> Fraction:
        """Return the number exactly, in its own unit."""
        return Fraction(self.digits)


@frozen
class Symbol:
    """A name in an expression: a parameter, a load, a result, or ``V_D``, ``omega_OB``, ``R_O``."""

    name: str
    span: Span = field(compare=False)


@frozen
class Sum:
    """Terms in the order written, each with its sign (+1 or −1); a lone −x is a Sum too."""

    terms: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@frozen
class Product:
    """Factors in the order written, each with +1 (times) or −1 (divided by)."""

    factors: tuple[tuple[int, "Expr"], ...]
    span: Span = field(compare=False)


@frozen
class Power:
    """``base ^ exponent``."""

    base: "Expr"
    exponent: "Expr"
    span: Span = field(compare=False)


@frozen
class Call:
    """A function of the language by its canonical name (``tg`` is read as ``tan``)."""

    function: str
    arguments: tuple["Expr", ...]
    span: Span = field(compare=False)


Expr = Number | Symbol | Sum | Product | Power | Call


@frozen
class Axis:
    """``x``, ``-x``, ``y`` or ``-y``."""

    axis: Literal["x", "y"]
    sign: int
    span: Span = field(compare=False)


@frozen
class Toward:
    """``AB``, ``-AB``, ``perp AB`` or ``-perp AB``: from A to B, back, turned by ±90 deg."""

    points: Name
    sign: int
    perp: bool
    span: Span = field(compare=False)


Direction = Axis | Toward | Expr
"""An angle counter-clockwise from +x, an axis, or the direction of a vector."""


@frozen
class Polar:
    """``length @ direction``; either may be missing, not both."""

    length: Expr | None
    direction: Direction | None
    span: Span = field(compare=False)


@frozen
class Cartesian:
    """``(x, y)``."""

    x: Expr
    y: Expr
    span: Span = field(compare=False)
