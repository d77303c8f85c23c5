"""Coefficients and lengths of friction, checked for values that make sense."""

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction

from ...diagnostics.model import friction as messages
from ...diagnostics.model import sizes
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, Number, number
from ...formula.walk import symbols
from ...source import Span
from ...syntax import ast
from ...units import LENGTH, NUMBER, UNITS
from ..formulas.expressions import Reader
from ..names.scope import DESCRIPTION, NameScope

HAIR = 1e-9
"""How far within a range is looked at, as a part of it."""


LOSS = "loss"
"""The part of the force that teeth or a belt lose: it is no coefficient of what slides."""


def coefficient(expression: ast.Expr, of: str, scope: NameScope, part: str = "") -> Formula | None:
    """Return a coefficient of friction, by a name where it is a number; None after an error.

    It is that of a point, or of all pins: then ``of`` is empty. One of another ``part`` is no
    coefficient of what slides, and has a name of its own where the numbers are the same.
    """
    what = "a coefficient of friction"
    formula = Reader(scope, DESCRIPTION).wanted(expression, NUMBER, what)
    value = value_of(formula, scope) if formula else None
    if value is not None and value > 1:
        scope.report.add(sizes.coefficient_above_one(expression.span, what, value))
    found = checked(formula, expression.span, what, lambda v: v >= 0, scope)
    of = "" if found in scope.shared and not part else of
    return found and scope.named("f", of, found, NUMBER, expression.span, part)


def shared_coefficients(statements: Iterable[ast.Statement]) -> frozenset[Formula]:
    """Return the number that is the coefficient of several points, or of all pins, if it is one.

    It is f then: as f_B, after one of the points, it would be read as that of this point alone.
    Of several such numbers each is called after a point of its own.
    """
    points: dict[Formula, set[str]] = {}
    for statement in statements:
        match statement:
            case (
                ast.PinFriction()
                | ast.GuideFriction()
                | ast.ContactFriction()
                | ast.CollarFriction()
                | ast.ScrewFriction()
                | ast.RopeFriction()
                | ast.RollerFriction()
            ):
                value, point = statement.coefficient, statement.point
                if isinstance(value, ast.Number) and not value.unit:
                    of = points.setdefault(Number(Fraction(value.digits)), set())
                    of.add(point.text if point else "")
    everywhere = [value for value, of in points.items() if "" in of]
    several = everywhere or [value for value, of in points.items() if len(of) > 1]
    return frozenset(several) if len(several) == 1 else frozenset()


def shared_sizes(statements: Iterable[ast.Statement]) -> frozenset[tuple[str, Formula]]:
    """Return the numbers that are the size of several parts of one kind, each with that kind."""
    parts: dict[tuple[str, Formula], set[str]] = {}
    for statement in statements:
        for what, of, size in _sizes(statement):
            if isinstance(size, ast.Number) and size.unit in {"", *UNITS}:
                factor = UNITS[size.unit].factor if size.unit else 1
                parts.setdefault((what, number(size.value * factor)), set()).add(of)
    return frozenset(key for key, of in parts.items() if len(of) > 1)


def _sizes(statement: ast.Statement) -> Iterator[tuple[str, str, ast.Expr]]:
    """Yield what may be the same of several parts: what it is, of which part, and the size."""
    match statement:
        case ast.PinFriction(point=point, diameter=diameter):
            yield "pin", point.text if point else "", diameter
        case ast.RollerFriction(point=point, axle=axle, wheel=wheel):
            yield "axle", point.text, axle
            yield "wheel", point.text, wheel
        case ast.Spring(rate=rate, first=first, second=second, free=free):
            yield "rate", first.text + second.text, rate
            yield "free", first.text + second.text, free
        case (
            ast.GearFriction(point=point, coefficient=loss)
            | ast.BeltFriction(point=point, coefficient=loss)
            | ast.RackFriction(point=point, coefficient=loss)
        ):
            yield LOSS, point.text, loss


def positive_length(expression: ast.Expr, what: str, scope: NameScope) -> Formula | None:
    """Return a length above zero; None where an error was reported."""
    formula = Reader(scope, DESCRIPTION).wanted(expression, LENGTH, what)
    return checked(formula, expression.span, what, lambda v: v > 0, scope, _in_mm)


def _in_mm(length: float) -> str:
    return f"{length * 1000:g} mm"


def checked(
    formula: Formula | None,
    span: Span,
    what: str,
    fits: Callable[[float], bool],
    scope: NameScope,
    show: Callable[[float], str] = "{:g}".format,
) -> Formula | None:
    """Return a quantity whose default value makes sense; report one that makes none."""
    value = None if formula is None else value_of(formula, scope)
    if value is not None and not fits(value):
        scope.report.add(messages.senseless(span, what, show(value)))
        return None
    if formula is not None and (far := _out_of_sense(formula, fits, scope)):
        scope.report.add(messages.range_makes_no_sense(span, what, far[0], show(far[1])))
    return formula


def _out_of_sense(
    formula: Formula, fits: Callable[[float], bool], scope: NameScope
) -> tuple[str, float] | None:
    """Return a parameter whose range takes a quantity to where it makes no sense, and to what.

    The end itself may make none: a diameter may shrink to nothing.
    """
    for name in sorted(symbols(formula) & scope.ranges.keys()):
        low, high = scope.ranges[name]
        for end, other in ((low, high), (high, low)):
            at_end = {**scope.values, name: end}
            inside = {**scope.values, name: end + (other - end) * HAIR}
            if symbols(formula) <= inside.keys() and not fits(evaluate(formula, inside)):
                return name, evaluate(formula, at_end)
    return None


def value_of(formula: Formula, scope: NameScope) -> float | None:
    """Return the default value of a formula; None where a parameter of it has none."""
    if not symbols(formula) <= scope.values.keys():
        return None
    return evaluate(formula, scope.values)
