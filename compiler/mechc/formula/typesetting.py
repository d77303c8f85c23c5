"""A formula set on paper, piece by piece: what is the same on a terminal and in LaTeX.

What stands in parentheses, which functions are raised before their argument, what counts
as a fraction and what leads a product is decided here once, on top of
:mod:`mechc.formula.layout`, by a :class:`Typesetter`. A :class:`Look` says how the pieces look:
text on one line, or boxes that know how wide they will be.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from enum import IntEnum
from fractions import Fraction
from math import isqrt
from typing import Generic, TypeVar, assert_never

from .choices import SIGNS
from .evaluate import equations
from .layout import (
    TRIGONOMETRIC,
    decimal,
    fractions,
    in_degrees,
    is_angle,
    multiple_of_sum,
    short_decimal,
    squares,
    turned_to_degrees,
    unstacked,
)
from .tree import (
    HALF,
    ZERO,
    Call,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    power,
    product,
)

Piece = TypeVar("Piece")

FormulaRow = tuple[Formula, ...]


class Surroundings(IntEnum):
    """What stands around a formula, by what must be put in parentheses there."""

    SUM = 0
    """Nothing, or a sum."""
    FACTOR = 1
    """Other factors."""
    BASE = 2
    """An exponent."""


class Look(ABC, Generic[Piece]):
    """How the pieces of a formula look: what a terminal and LaTeX have each for themselves.

    ``built`` says that fractions have a line and exponents are small, so that both hold
    together without parentheses; ``raised`` that ``sin² α`` is written for a power.
    """

    built: bool
    raised: bool

    @abstractmethod
    def numeral(self, figures: str) -> Piece:
        """Return a whole number or a decimal, perhaps with a minus."""

    @abstractmethod
    def ratio(self, value: Fraction) -> Piece:
        """Return a rational that no decimal stands for."""

    @abstractmethod
    def degrees(self, number: Piece) -> Piece:
        """Return a number with the sign of degrees."""

    @abstractmethod
    def pi(self) -> Piece:
        """Return π."""

    @abstractmethod
    def name(self, name: str) -> Piece:
        """Return a quantity's name."""

    @abstractmethod
    def parentheses(self, inner: Piece) -> Piece:
        """Return a piece in parentheses."""

    @abstractmethod
    def minus(self, piece: Piece) -> Piece:
        """Return a piece with a minus before it."""

    @abstractmethod
    def joined(self, term: Piece) -> Piece:
        """Return a term with the sign that joins it to those before; it may have a minus."""

    @abstractmethod
    def row(self, pieces: Sequence[Piece]) -> Piece:
        """Return pieces side by side, as they are."""

    @abstractmethod
    def factors(self, formulas: FormulaRow, pieces: Sequence[Piece]) -> Piece:
        """Return the factors of a row, kept apart where they would run together."""

    @abstractmethod
    def over(self, above: Piece, below: Piece, several: bool) -> Piece:
        """Return a fraction; ``several`` says that more than one factor is below the line."""

    @abstractmethod
    def beside(self, first: Piece, second: Piece) -> Piece:
        """Return the two parts of a product that are apart: ``b/a · cot α``."""

    @abstractmethod
    def scaled(self, lead: Piece, rest: Piece) -> Piece:
        """Return a product that a decimal leads."""

    @abstractmethod
    def power(self, base: Piece, exponent: Piece) -> Piece:
        """Return a power."""

    @abstractmethod
    def holds(self, call: Piece) -> bool:
        """Return whether a call, as it is set, may have an exponent behind it."""

    @abstractmethod
    def root(self, inner: Piece) -> Piece:
        """Return a square root."""

    @abstractmethod
    def absolute(self, inner: Piece) -> Piece:
        """Return an absolute value."""

    @abstractmethod
    def applied(self, function: str, exponent: str, argument: Formula, inner: Piece) -> Piece:
        """Return a function of one argument, ``exponent`` (or nothing) behind its name.

        Where the argument stands without parentheses is a matter of how it looks.
        """

    @abstractmethod
    def called(self, function: str, arguments: Sequence[Piece]) -> Piece:
        """Return a function of several arguments."""

    @abstractmethod
    def joined_by(self, sign: str, pieces: Sequence[Piece]) -> Piece:
        """Return the sides of a comparison by its sign, or conditions that all hold by a comma."""

    @abstractmethod
    def cases(self, rows: Sequence[tuple[Piece, Piece]], other: Piece | None) -> Piece:
        """Return values with the conditions under which they are meant, and one elsewhere."""

    @abstractmethod
    def solution(self, unknown: str, zeros: Sequence[Piece]) -> Piece:
        """Return an unknown and what is zero for it."""


class Typesetter(Look[Piece]):
    """Sets formulas of the pieces that a look has; ``angles`` are the names that are angles."""

    angles: frozenset[str]

    def whole(self, formula: Formula, angle: bool = False) -> Piece:
        """Return a formula; one that is an angle, or said to be one, has constants in degrees."""
        if angle or is_angle(formula, self.angles):
            return self.set(multiple_of_sum(turned_to_degrees(formula)), Surroundings.SUM, True)
        return self.set(formula, Surroundings.SUM, False)

    def set(self, formula: Formula, around: Surroundings, angle: bool) -> Piece:
        """Return a formula as it stands inside another; ``angle`` as in :meth:`whole`."""
        constant = in_degrees(formula) if angle and formula != ZERO else None
        if constant is not None:
            return self._degrees(constant, around)
        match formula:
            case Number(value):
                return self.number(value, short_decimal(value), around)
            case Pi():
                return self.pi()
            case Symbol(name):
                return self.name(name)
            case Sum(terms):
                row = self.row([self.term(t, i == 0, angle) for i, t in enumerate(terms)])
                return self.parentheses(row) if around else row
            case Product():
                return self._product(formula, around, angle)
            case Power(base, exponent):
                return self._power(base, exponent, around)
            case Call(function, arguments):
                return self._call(function, arguments)
            case Implicit(system, index, _):
                zeros = [self.set(zero, Surroundings.SUM, False) for zero in equations(formula)]
                return self.parentheses(self.solution(system.unknowns[index], zeros))
            case _:
                assert_never(formula)

    def term(self, term: Formula, first: bool, angle: bool = False) -> Piece:
        """Return a term of a sum, with the sign that joins it to what stands before."""
        piece = self.set(term, Surroundings.SUM, angle)
        return piece if first else self.joined(piece)

    def number(self, value: Fraction, figures: str | None, around: Surroundings) -> Piece:
        """Return a number; ``figures`` is the decimal to be printed for it, if any."""
        return self._enclosed(self._digits(value, figures), value, figures, around)

    def _degrees(self, value: Fraction, around: Surroundings) -> Piece:
        """Return an angle; the degree sign is inside the parentheses."""
        figures = decimal(value)
        return self._enclosed(self.degrees(self._digits(value, figures)), value, figures, around)

    def _digits(self, value: Fraction, figures: str | None) -> Piece:
        if figures is None and value.denominator != 1:
            return self.ratio(value)
        return self.numeral(figures or str(value))

    def _enclosed(
        self, piece: Piece, value: Fraction, figures: str | None, around: Surroundings
    ) -> Piece:
        """Return a number in the parentheses that it needs."""
        if value < 0 and around:
            return self.parentheses(piece)
        is_ratio = figures is None and value.denominator != 1
        return self._held(piece, around) if is_ratio else piece

    def _held(self, fraction: Piece, around: Surroundings) -> Piece:
        """Return a fraction that holds together; a line does that among factors."""
        needed = around == Surroundings.BASE or (around and not self.built)
        return self.parentheses(fraction) if needed else fraction

    def _product(self, formula: Product, around: Surroundings, angle: bool) -> Piece:
        match formula.factors:
            case (Number(value), *rest) if (figures := short_decimal(value)) is not None:
                piece = self.scaled(self.numeral(figures), self._led(tuple(rest), angle))
                negative = value < 0
            case _:
                piece, negative = self._fractions(formula, angle)
        closed = around == Surroundings.BASE or (around and negative)
        return self.parentheses(piece) if closed else piece

    def _fractions(self, formula: Product, angle: bool) -> tuple[Piece, bool]:
        """Return a product as one fraction or two, and whether a minus is before it.

        Above a line no sum stands that has lines of its own: it is put behind the fraction.
        """
        whole = fractions(formula)
        whole, behind = unstacked(whole) if self.built else (whole, ())
        sign, *parts = whole
        first, *second = [self._fraction(*part, angle) for part in parts if part != ((), ())]
        piece = self.beside(first, *second) if second else first
        if behind:
            piece = self.row((piece, self.row_of(behind, Surroundings.FACTOR, angle)))
        return (self.minus(piece), True) if sign < 0 else (piece, False)

    def _fraction(self, above: FormulaRow, below: FormulaRow, angle: bool = False) -> Piece:
        """Return the factors above and below a line, or side by side when nothing is below."""
        if not below:
            return self.row_of(above, Surroundings.FACTOR, angle)
        top = self.row_of(above, Surroundings.SUM if self.built else Surroundings.FACTOR, angle)
        bottom = self.row_of(below, Surroundings.SUM if self.built else Surroundings.BASE, angle)
        return self.over(top, bottom, len(below) > 1)

    def _led(self, factors: FormulaRow, angle: bool) -> Piece:
        """Return the factors that a decimal leads."""
        return self._product(Product(factors), Surroundings.FACTOR, angle)

    def row_of(self, formulas: FormulaRow, alone: Surroundings, angle: bool) -> Piece:
        """Return factors side by side; ``alone`` is what stands around a single one."""
        if not formulas:
            return self.numeral("1")
        around = Surroundings.FACTOR if len(formulas) > 1 else alone
        return self.factors(formulas, [self.set(f, around, angle) for f in formulas])

    def _power(self, base: Formula, exponent: Formula, around: Surroundings) -> Piece:
        """Return a power as a fraction, a root, a function raised, or a base with its exponent."""
        match base, exponent:
            case _, Number(value) if value < 0:
                return self._held(self._fraction((), (power(base, Number(-value)),)), around)
            case _, Number() if exponent == HALF:
                return self._root(base, around)
            case Call(function, (argument,)), Number(value) if (
                self.raised and function in TRIGONOMETRIC and value.denominator == 1
            ):
                return self.applied(function, str(value), argument, self._angle(argument))
        raised = self.set(exponent, Surroundings.SUM if self.built else Surroundings.BASE, False)
        return self.power(self._base(base), raised)

    def _root(self, inner: Formula, around: Surroundings) -> Piece:
        """Return a square root, the root of a square number below its line in front: √a/3."""
        match inner:
            case Product((Number(value), *rest)) if (size := isqrt(value.denominator)) > 1 and (
                size**2 == value.denominator
            ):
                above = product([(Number(Fraction(value.numerator)), 1), *((f, 1) for f in rest)])
                root = self.root(self.set(above, Surroundings.SUM, False))
                return self._held(self.over(root, self.numeral(str(size)), False), around)
        return self.root(self.set(inner, Surroundings.SUM, False))

    def _base(self, base: Formula) -> Piece:
        """Return the base of a power, in parentheses where it needs them."""
        if isinstance(base, Power):
            return self.parentheses(self.set(base, Surroundings.SUM, False))
        piece = self.set(base, Surroundings.BASE, False)
        open_call = isinstance(base, Call) and not self.holds(piece)
        return self.parentheses(piece) if open_call else piece

    def _call(self, function: str, arguments: FormulaRow) -> Piece:
        """Return a function of its arguments, in the form that its books have."""
        match function, arguments:
            case "choose", _:
                return self.cases(*self._cases(arguments))
            case "both", _:
                return self.joined_by(
                    ",", [self.set(a, Surroundings.SUM, False) for a in arguments]
                )
            case _, (left, right) if function in SIGNS:
                angle = is_angle(left, self.angles) or is_angle(right, self.angles)
                both = [self.whole(side, angle) for side in (left, right)]
                return self.joined_by(SIGNS[function], both)
            case "sense", (value, _):  # whose size is there for what rounding leaves of a zero
                return self._call("sign", (value,))
            case "hypot", _:
                return self.root(self.set(squares(arguments), Surroundings.SUM, False))
            case "sqrt", (argument,) if self.built:  # its line holds a fraction together
                return self._root(argument, Surroundings.SUM)
            case "sqrt", (argument,):
                return self.root(self.set(argument, Surroundings.SUM, False))
            case "abs", (argument,):
                return self.absolute(self.whole(argument))
            case _, (argument,):
                is_turn = function in TRIGONOMETRIC
                inner = self._angle(argument) if is_turn else self.whole(argument)
                return self.applied(function, "", argument, inner)
        return self.called(function, [self.whole(a) for a in arguments])

    def _angle(self, argument: Formula) -> Piece:
        """Return the angle of a sine or cosine, its constants in degrees; 0 alone is 0°, too."""
        is_zero = argument == ZERO
        return self.degrees(self.numeral("0")) if is_zero else self.whole(argument, True)

    def _cases(self, parts: FormulaRow) -> tuple[list[tuple[Piece, Piece]], Piece | None]:
        """Return a choice as rows; a choice for what is left goes on with them."""
        pairs = zip(parts[1::2], parts[::2], strict=False)
        rows = [(self.whole(value), self.whole(condition)) for value, condition in pairs]
        match parts[len(rows) * 2 :]:
            case (Call("choose", inner),):
                others, last = self._cases(inner)
                return [*rows, *others], last
            case (other,):
                return rows, self.whole(other)
            case _:
                return rows, None
