"""The frame of a used mechanism: where its origin lies in that of its user, how it is turned.

Places are turned and moved, vectors and directions turned. A direction between two points,
an angle between three and a length are what they are. Numbers stay numbers where the turn is
one by quarters.
"""

from decimal import Decimal
from fractions import Fraction

from ...base.frozen import replace
from ...base.named import NamedTuple
from ...source import Span
from ...syntax import ast
from ...syntax.vocabulary import points_of

QUARTER = 90
AXES: tuple[tuple[str, int], ...] = (("x", 1), ("y", 1), ("x", -1), ("y", -1))
"""The axes by quarter turns from +x."""


BARE_ZERO = (Fraction(0), "")
"""A zero without a unit, which it needs none of."""


class PartFrame(NamedTuple):
    """How a frame lies: turned by ``turned``, its origin at ``at``; None for not at all."""

    at: ast.Cartesian | None = None
    turned: ast.Expr | None = None

    def statement(self, statement: ast.Statement) -> ast.Statement:
        """Return a statement of the frame as one of its user's."""
        if self.at is None and self.turned is None:
            return statement
        match statement:
            case ast.Pivot(at=ast.Cartesian() as at) | ast.Drawn(at=at):
                return replace(statement, at=self.place(at))
            case ast.Slider(along=along, through=ast.Cartesian() as through):
                return replace(statement, along=self.direction(along), through=self.place(through))
            case (
                ast.Slider(along=along)
                | ast.Slide(along=along)
                | ast.Force(along=along)
                | ast.Distributed(along=along)
            ):
                return replace(statement, along=self.direction(along))
            case ast.Contact(normal=normal):
                return replace(statement, normal=self.direction(normal))
            case ast.Vector(value=ast.Cartesian() as value):
                return replace(statement, value=self._vector(value))
            case ast.Vector(value=ast.Polar(direction=towards) as value) if towards is not None:
                turned = replace(value, direction=self.direction(towards))
                return replace(statement, value=turned)
            case ast.Drive(name=name, low=low, high=high) if len(points_of(name.text)) == 2:
                return replace(statement, low=self._angle(low), high=self._angle(high))
        return statement

    def place(self, at: ast.Cartesian) -> ast.Cartesian:
        """Return where a place of the frame is."""
        turned = self._vector(at)
        if self.at is None:
            return turned
        return ast.Cartesian(plus(turned.x, self.at.x), plus(turned.y, self.at.y), at.span)

    def direction(self, towards: ast.Direction) -> ast.Direction:
        """Return a direction of the frame as it is outside."""
        if self.turned is None or isinstance(towards, ast.Toward):
            return towards
        if not isinstance(towards, ast.Axis):
            return plus(towards, self.turned)
        if (more := _quarters(self.turned)) is None:
            return plus(angle_of(towards), self.turned)
        quarters = AXES.index((towards.axis, towards.sign))
        axis, sign = AXES[(quarters + more) % len(AXES)]
        return ast.Axis("x" if axis == "x" else "y", sign, towards.span)

    def seen(self, angle: ast.Expr) -> ast.Expr:
        """Return a direction outside as it is in the frame."""
        return angle if self.turned is None else plus(angle, negative(self.turned))

    def _angle(self, angle: ast.Expr | None) -> ast.Expr | None:
        return plus(angle, self.turned) if angle is not None and self.turned else angle

    def _vector(self, at: ast.Cartesian) -> ast.Cartesian:
        """Return a vector that is turned as the frame is."""
        if self.turned is None:
            return at
        match _quarters(self.turned):
            case 0:
                return at
            case 1:
                return ast.Cartesian(negative(at.y), at.x, at.span)
            case 2:
                return ast.Cartesian(negative(at.x), negative(at.y), at.span)
            case 3:
                return ast.Cartesian(at.y, negative(at.x), at.span)
        sine, cosine = (ast.Call(f, (self.turned,), self.turned.span) for f in ("sin", "cos"))
        x = plus(_times(at.x, cosine), negative(_times(at.y, sine)))
        return ast.Cartesian(x, plus(_times(at.x, sine), _times(at.y, cosine)), at.span)


def between(here: ast.Cartesian, there: ast.Cartesian, turned: ast.Expr | None) -> PartFrame:
    """Return the frame that is turned so and in which one place falls on another outside."""
    seen = PartFrame(None, turned).place(there)
    x, y = plus(here.x, negative(seen.x)), plus(here.y, negative(seen.y))
    return PartFrame(ast.Cartesian(x, y, here.span), turned)


def same(one: ast.Cartesian, other: ast.Cartesian) -> bool:
    """Return whether two places are the same; formulas that may be are taken to be."""
    for a, b in ((one.x, other.x), (one.y, other.y)):
        difference = literal(plus(a, negative(b)))
        if difference is not None and difference[0] != 0:
            return False
    return True


def angle_of(axis: ast.Axis) -> ast.Expr:
    """Return the angle of an axis: y is 90 deg."""
    quarters = AXES.index((axis.axis, axis.sign))
    return number(Fraction(quarters * QUARTER), "deg", axis.span)


def plus(one: ast.Expr, other: ast.Expr) -> ast.Expr:
    """Return a sum: a number where both are numbers in one unit."""
    left, right = literal(one), literal(other)
    if left == BARE_ZERO:
        return other
    if right == BARE_ZERO:
        return one
    if left and right and left[1] == right[1]:
        return number(left[0] + right[0], left[1], one.span)
    return ast.Sum((*_terms(one), *_terms(other)), one.span)


def negative(value: ast.Expr) -> ast.Expr:
    """Return the opposite of a value."""
    if known := literal(value):
        return number(-known[0], known[1], value.span)
    return ast.Sum(tuple((-sign, term) for sign, term in _terms(value)), value.span)


def literal(value: ast.Expr) -> tuple[Fraction, str] | None:
    """Return the value and unit of a number with or without a sign; None for a formula."""
    match value:
        case ast.Number(unit=unit):
            return value.value, unit
        case ast.Sum(terms=((sign, ast.Number(unit=unit) as only),)):
            return sign * only.value, unit
    return None


def number(value: Fraction, unit: str, span: Span) -> ast.Expr:
    """Return a number whose decimals end, as one would write it."""
    size = abs(value)
    digits = format(Decimal(size.numerator) / Decimal(size.denominator), "f")
    written = ast.Number(digits, unit, span)
    return ast.Sum(((-1, written),), span) if value < 0 else written


def _terms(value: ast.Expr) -> tuple[tuple[int, ast.Expr], ...]:
    return value.terms if isinstance(value, ast.Sum) else ((1, value),)


def _times(value: ast.Expr, factor: ast.Expr) -> ast.Expr:
    return ast.Product(((1, value), (1, factor)), value.span)


def _quarters(turned: ast.Expr) -> int | None:
    """Return by how many quarters a turn is; None where it is by no whole number of them."""
    known = literal(turned)
    if known is None or known[1] != "deg" or known[0] % QUARTER:
        return None
    return int(known[0] / QUARTER) % len(AXES)
