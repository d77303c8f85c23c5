"""Expressions to formulas in SI, with what they measure.

A formula that is wrong in one place is reported once and reads as None, so that what
uses it stays quiet.
"""

from fractions import Fraction
from typing import assert_never

from ...base.frozen import frozen
from ...base.later import pattern
from ...diagnostics import Report
from ...diagnostics.model import names, quantities, reactions, sizes
from ...formula.tree import (
    PI,
    ZERO,
    Call,
    Formula,
    Number,
    Power,
    Product,
    Symbol,
    negative,
    number,
    power,
    product,
    total,
)
from ...source import Span
from ...syntax import ast
from ...units import ANGLE, LENGTH, NUMBER, UNITS, Dimension
from ..constants import LARGEST_EXPONENT, rational, too_large
from ..names.forms import COORDINATES, FORMS, ReservedName, form_of_pose
from ..names.scope import NameScope, Usage
from .measured import MeasuredFormula, alike, fits
from .misplaced_units import measured_twice
from .sorts import Nature, Sort, multiplied, raised

VELOCITIES = "the name of a result: a ratio of velocities is asked for with 'find'"

ANGLE_TO_NUMBER = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})
NUMBER_TO_ANGLE = frozenset({"asin", "acos", "atan"})
NUMBER_TO_NUMBER = frozenset({"exp", "log"})
ALIKE = frozenset({"abs", "min", "max", "hypot", "atan2"})

POWER_OF_LENGTH = pattern(r"(mm|cm|dm|m|in|ft)\^([234])")
"""A unit that is a power of one of length."""


@frozen
class Reader:
    """Reads expressions whose names may be of certain kinds."""

    scope: NameScope
    usage: Usage

    @property
    def report(self) -> Report:
        """Return the report that errors go to."""
        return self.scope.report

    def wanted(self, expression: ast.Expr, dimension: Dimension, what: str) -> Formula | None:
        """Read an expression that must measure ``dimension``; ``what`` names it in messages."""
        found = self.read(expression)
        return found.formula if found and fits(found, dimension, what, self.scope) else None

    def read(self, expression: ast.Expr) -> MeasuredFormula | None:
        """Read an expression; None where an error in it was reported."""
        match expression:
            case ast.Number():
                found: MeasuredFormula | None = _number(expression)
            case ast.Symbol():
                found = self._symbol(expression)
            case ast.Sum():
                found = self._sum(expression)
            case ast.Product():
                found = self._product(expression)
            case ast.Power():
                found = self._power(expression)
            case ast.Call():
                found = self._call(expression)
            case _:
                assert_never(expression)
        return _sized(found, self.report) if found else None

    def _symbol(self, node: ast.Symbol) -> MeasuredFormula | None:
        if node.name == "pi":
            return MeasuredFormula(PI, Sort(NUMBER, Nature.LOOSE), node.span)
        if _is_asked_of_the_pose(node.name, self.scope) and (form := form_of_pose(node.name)):
            return _of_the_pose(node, form, self.scope, self.usage)
        entry = self.scope.look_up(node, self.usage)
        if entry is None or entry.dimension is None:
            return None
        known = Sort(NUMBER, Nature.UNITLESS) if entry.is_unitless else Sort.of(entry.dimension)
        return MeasuredFormula(Symbol(node.name), known, node.span)

    def _sum(self, node: ast.Sum) -> MeasuredFormula | None:
        terms = [self.read(term) for _, term in node.terms]
        known = [term for term in terms if term]
        signs = [sign for sign, _ in node.terms]
        act = "add" if all(sign > 0 for sign in signs[1:]) else "subtract"
        sort = alike(known, act, self.scope)
        if sort is None or len(known) < len(terms):
            return None
        pairs = zip(signs, known, strict=True)
        formula = total(t.formula if sign > 0 else negative(t.formula) for sign, t in pairs)
        return MeasuredFormula(formula, sort, node.span)

    def _product(self, node: ast.Product) -> MeasuredFormula | None:
        """Return a product or quotient; None where it is divided by zero, which is reported."""
        signs = [sign for sign, _ in node.factors]
        read = [self.read(factor) for _, factor in node.factors]
        factors = [factor for factor in read if factor]
        if len(factors) < len(signs) or not _divisible(factors, signs, self.report):
            return None
        formula = product((f.formula, s) for f, s in zip(factors, signs, strict=True))
        sort = multiplied([(f.sort, s) for f, s in zip(factors, signs, strict=True)])
        if formula == ZERO and sort.nature is Nature.BARE:
            sort = Sort(NUMBER, Nature.ZERO)
        if not measured_twice(node, sort.dimension):
            _remark_on_powers(node, self.report)
        return MeasuredFormula(formula, sort, node.span)

    def _power(self, node: ast.Power) -> MeasuredFormula | None:
        """Return a power; None where its exponent is no number or too large, which is reported."""
        base, exponent = self.read(node.base), self.read(node.exponent)
        if not base or not exponent:
            return None
        exponent = _in_a_product(node.exponent, exponent)
        if not fits(exponent, NUMBER, "an exponent", self.scope):
            return None
        constant = rational(exponent.formula)
        if constant is None:
            return _general_power(base, exponent, node.span, self.report)
        if abs(constant) > LARGEST_EXPONENT:
            self.report.add(quantities.number_too_large(exponent.span))
            return None
        if constant < 0 and rational(base.formula) == 0:
            self.report.add(quantities.divided_by_zero(base.span))
            return None
        return MeasuredFormula(
            power(base.formula, number(constant)), raised(base.sort, constant), node.span
        )

    def _call(self, node: ast.Call) -> MeasuredFormula | None:
        read = [self.read(argument) for argument in node.arguments]
        arguments = [argument for argument in read if argument]
        sort = self._result(node, arguments) if len(arguments) == len(read) else None
        if sort is None:
            return None
        formula = Call(node.function, tuple(a.formula for a in arguments))
        return MeasuredFormula(formula, sort, node.span)

    def _result(self, node: ast.Call, arguments: list[MeasuredFormula]) -> Sort | None:
        """Return the sort of a function's value; report arguments that do not suit it."""
        argument = arguments[0]
        what = f"the argument of {node.function}"
        if node.function in ANGLE_TO_NUMBER:
            return Sort(NUMBER, Nature.VALUE) if fits(argument, ANGLE, what, self.scope) else None
        if node.function in NUMBER_TO_ANGLE:
            return Sort(ANGLE) if fits(argument, NUMBER, what, self.scope) else None
        if node.function in NUMBER_TO_NUMBER:
            argument = _in_a_product(node.arguments[0], argument)
            return Sort.of(NUMBER) if fits(argument, NUMBER, what, self.scope) else None
        if node.function == "sqrt":
            return raised(argument.sort, Fraction(1, 2))
        assert node.function in ALIKE, node.function
        sort = alike(arguments, "compare", self.scope)
        return Sort(ANGLE) if sort and node.function == "atan2" else sort


def _sized(found: MeasuredFormula, report: Report) -> MeasuredFormula | None:
    """Refuse constants that grow beyond what anything measured can be."""
    match found.formula:
        case Number(value) | Product((Number(value), *_)) if too_large(value):
            report.add(quantities.number_too_large(found.span))
            return None
        case Power(_, Number(exponent)) if abs(exponent) > LARGEST_EXPONENT:
            report.add(quantities.number_too_large(found.span))
            return None
    return found


def _number(node: ast.Number) -> MeasuredFormula:
    if not node.unit:
        nature = Nature.BARE if node.value else Nature.ZERO
        return MeasuredFormula(Number(node.value), Sort(NUMBER, nature), node.span)
    unit = UNITS[node.unit]
    plain = number(node.value * unit.factor)
    formula = product([(plain, 1), (PI, 1)]) if unit.pi else plain
    return MeasuredFormula(formula, Sort(unit.dimension), node.span)


def _is_asked_of_the_pose(name: str, scope: NameScope) -> bool:
    """Return whether no name of the user's own is meant; ``x_B`` is one where B is no point."""
    form = form_of_pose(name)
    is_own = form and form.prefix in COORDINATES and form.points[0] not in scope.points.places
    return name not in scope.entries and not is_own


def _of_the_pose(
    node: ast.Symbol, form: ReservedName, scope: NameScope, usage: Usage
) -> MeasuredFormula | None:
    """Return a direction or a length that the pose has; refuse other such quantities."""
    if form.prefix not in ("phi", "len", *COORDINATES):
        _refuse(node, form, scope)
        return None
    if len(form.points) > 2:
        scope.look_up(node, usage)
        return None
    if not scope.points.acting(ast.Name("".join(form.points), node.span)):
        return None
    if not usage.with_pose:
        what = f"{(FORMS | COORDINATES)[form.prefix]}, which follows from the description"
        wanted = usage.wanted
        hint = names.angle_from_vector() if form.prefix == "phi" else ""
        scope.report.add(names.name_out_of_place(node.span, node.name, what, wanted, hint))
        return None
    sort = Sort.of(ANGLE if form.prefix == "phi" else LENGTH)
    return MeasuredFormula(Symbol(node.name), sort, node.span)


def _refuse(node: ast.Symbol, form: ReservedName, scope: NameScope) -> None:
    """Say why a quantity of the mechanism cannot stand in a formula."""
    points = ast.Name("".join(form.points), node.span)
    if not scope.points.known(points):
        return
    if form.prefix in ("V", "omega"):
        what, hint = FORMS[form.prefix], "give the ratio a name with 'find', and use that"
        scope.report.add(names.name_out_of_place(node.span, node.name, what, VELOCITIES, hint))
    else:
        scope.report.add(reactions.ask_first(node.span, node.name))


def _remark_on_powers(node: ast.Product, report: Report) -> None:
    """Say of ``pi*50 mm^2`` that the power belongs to the unit: that of a length is meant."""
    above = [factor for sign, factor in node.factors if sign > 0]
    if not any(isinstance(factor, ast.Symbol) and factor.name == "pi" for factor in above):
        return
    for factor in above:
        if isinstance(factor, ast.Number) and (found := POWER_OF_LENGTH.fullmatch(factor.unit)):
            place = factor.span
            report.add(sizes.area_for_square(place, factor.digits, found[1], found[2]))


def _divisible(factors: list[MeasuredFormula], signs: list[int], report: Report) -> bool:
    for factor, sign in zip(factors, signs, strict=True):
        if sign < 0 and rational(factor.formula) == 0:
            report.add(quantities.divided_by_zero(factor.span))
            return False
    return True


def _general_power(
    base: MeasuredFormula, exponent: MeasuredFormula, span: Span, report: Report
) -> MeasuredFormula | None:
    if not base.sort.fits(NUMBER):
        report.add(quantities.exponent_not_number(exponent.span, base.dimension))
        return None
    formula = Power(base.formula, exponent.formula)
    return MeasuredFormula(formula, Sort(NUMBER, Nature.LOOSE), span)


def _in_a_product(node: ast.Expr, found: MeasuredFormula) -> MeasuredFormula:
    """Return a multiple of an angle as the pure number that it is, as in exp(0.25*theta).

    An angle alone may be meant in degrees: it stays one.
    """
    terms = [term for _, term in node.terms] if isinstance(node, ast.Sum) else [node]
    if found.dimension != ANGLE or not all(isinstance(term, ast.Product) for term in terms):
        return found
    return found._replace(sort=Sort.of(NUMBER))
