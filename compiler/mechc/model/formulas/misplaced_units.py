"""Units behind a number that are meant for the whole formula, and numbers that stand for units."""

from collections.abc import Mapping
from fractions import Fraction
from typing import TypeGuard

from ...diagnostics.model import sheets as messages
from ...diagnostics.model import sizes
from ...syntax import ast
from ...units import FREQUENCY, LENGTH, NUMBER, POWER, TORQUE, UNITS, VELOCITY, Dimension
from ..constants import expressions_in, leaves
from ..names.scope import NameScope

AREA = LENGTH.scaled(2)


def note_misplaced_unit(statement: ast.Let | ast.Param, found: Dimension, scope: NameScope) -> None:
    """Say of ``pi*d^2/4 mm^2`` that it is a number, of ``pi*d^2*0.25 mm^2`` that it is mm^4."""
    name, value = statement.name.text, statement.value
    if not isinstance(value, ast.Product):
        return
    has_unit = isinstance(statement, ast.Let)
    if found == NUMBER:
        _note_divisor(name, value, has_unit, scope)
    elif (factor := measured_twice(value, found)) is not None:
        digits, unit = factor.digits, factor.unit
        text = scope.report.source.text
        before = text[value.span.start : factor.span.start]
        if before.endswith("("):
            return  # what has brackets of its own is meant
        behind = text[factor.span.end : value.span.end]
        plain = f"{before}{digits}{behind}" + f" in {unit}" * has_unit
        scope.report.add(messages.unit_twice(factor.span, name, f"{digits} {unit}", unit, plain))


def measured_twice(value: ast.Product, found: Dimension) -> ast.Number | None:
    """Return the number of a product whose unit is that of the rest as well; None without one.

    A length by a number of millimetres is an area, and an area with a name by a number of square
    millimetres the second moment of one; that of other quantities is hardly ever meant.
    """
    named = all(_is_quantity(f) for _, f in value.factors)
    for sign, factor in value.factors:
        if sign > 0 and isinstance(factor, ast.Number) and factor.unit:
            own = UNITS[factor.unit].dimension
            is_moment = named and own == AREA
            if own not in (NUMBER, LENGTH) and not is_moment and found == own.scaled(2) != NUMBER:
                return factor
    return None


def _note_divisor(name: str, value: ast.Product, has_unit: bool, scope: NameScope) -> None:
    """Say of ``F/20 mm`` that the unit belongs to the divisor."""
    *others, last = value.factors
    if any(isinstance(factor, ast.Number) and factor.unit for _, factor in others):
        return
    match last:
        case (-1, ast.Number(digits=digits, unit=unit, span=span)) if unit:
            before = scope.report.source.text[value.span.start : span.start].rstrip()
            if before.endswith("/"):  # and no bracket behind it
                rest = f"{before}{digits}" + f" in {unit}" * has_unit
                scope.report.add(
                    messages.unit_of_divisor(span, name, f"{digits} {unit}", unit, rest)
                )


def _is_quantity(factor: ast.Expr) -> bool:
    """Return whether a factor is a quantity by its name, or a number with its unit."""
    match factor:
        case ast.Symbol(name=name):
            return name != "pi"
        case ast.Number(unit=unit):
            return bool(unit)
        case _:
            return False


FACTORS = frozenset(map(Fraction, ("9550", "9549", "9549.3", "974", "975", "716.2", "60000")))
"""Numbers by which formulas of speeds in 1/min have powers in kW, or torques in N·m and kgf·m."""

BY_A_FACTOR: Mapping[Dimension, str] = {POWER: "kW", TORQUE: "N*m", VELOCITY: "m/s"}
"""What has such a number in formulas of speeds, and the unit that it is to bring about."""


def note_unit_factor(statement: ast.Let, dimension: Dimension, scope: NameScope) -> None:
    """Warn of a factor between units in a formula of a speed, which has its own unit here."""
    if statement.value is None or dimension not in BY_A_FACTOR:
        return
    parts = [leaf for each in expressions_in(statement.value) for leaf in leaves(each)]
    frequency = next((part.name for part in parts if _is_frequency(part, scope)), None)
    factor = next((part for part in parts if _is_factor_between_units(part)), None)
    if frequency and factor:
        found = (factor.digits, frequency, BY_A_FACTOR[dimension])
        scope.report.add(sizes.factor_between_units(factor.span, *found))


def _is_frequency(part: ast.Expr, scope: NameScope) -> TypeGuard[ast.Symbol]:
    """Return whether a part of a formula is the name of a frequency."""
    entry = scope.entries.get(part.name) if isinstance(part, ast.Symbol) else None
    return entry is not None and entry.dimension == FREQUENCY


def _is_factor_between_units(part: ast.Expr) -> TypeGuard[ast.Number]:
    """Return whether a part of a formula is a bare number such as 60, by which units differ."""
    return isinstance(part, ast.Number) and not part.unit and part.value in FACTORS
