"""Expressions to formulas in SI, with what they measure.

A formula that is wrong in one place is reported once and reads as None, so that what
uses it stays quiet.
"""

from fractions import Fraction
from typing import assert_never

from ...diagnostics import Report
from ...diagnostics.model import doubtful_sizes as sizes
from ...diagnostics.model import names, quantities, reactions
from ...formula.to_text import text
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
from ...frozen import frozen
from ...named import NamedTuple
from ...patterns import pattern
from ...source import Span
from ...syntax import ast
from ...units import ANGLE, LENGTH, NUMBER, UNITS, Dimension
from ..constants import LARGEST_EXPONENT, rational, too_large
from ..names.forms import COORDINATES, FORMS, Form, form_of_pose
from ..names.scope import Bare, Scope, Usage
from .sorts import Nature, Sort, agreed, multiplied, raised

VELOCITIES = "the name of a result: a ratio of velocities is asked for with 'find'"

ANGLE_TO_NUMBER = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})
NUMBER_TO_ANGLE = frozenset({"asin", "acos", "atan"})
NUMBER_TO_NUMBER = frozenset({"exp", "log"})
ALIKE = frozenset({"abs", "min", "max", "hypot", "atan2"})

POWER_OF_LENGTH = pattern(r"(mm|cm|dm|m|in|ft)\^([234])")
"""A unit that is a power of one of length."""


def shown(formula: Formula) -> str:
    """Return a number without unit for a message."""
    value = rational(formula)
    return text(formula) if value is None or too_large(value) else f"{float(value):g}"


class Quantity(NamedTuple):
    """A formula in SI, what it measures and where it stands."""

    formula: Formula
    sort: Sort
    span: Span

    @property
    def dimension(self) -> Dimension:
        """Return the dimension."""
        return self.sort.dimension


@frozen
class Reader:
    """Reads expressions whose names may be of certain kinds."""

    scope: Scope
    usage: Usage

    @property
    def report(self) -> Report:
        """Return the report that errors go to."""
        return self.scope.report

    def wanted(self, expression: ast.Expr, dimension: Dimension, what: str) -> Formula | None:
        """Read an expression that must measure ``dimension``; ``what`` names it in messages."""
        found = self.read(expression)
        return found.formula if found and self.fits(found, dimension, what) else None

    def fits(self, found: Quantity, dimension: Dimension, what: str) -> bool:
        """Return whether a quantity measures what is wanted; report where it does not."""
        if found.sort.fits(dimension):
            return True
        if found.sort.nature is Nature.BARE:
            digits = shown(found.formula)
            self.report.add(quantities.bare_number(found.span, digits, dimension))
        elif bare := self._bare(found):
            self.scope.doubt(found.formula)
            self.report.add(quantities.bare_number(bare.span, bare.digits, dimension, found.span))
        else:
            self._report_dimension(found, dimension, what)
        return False

    def _report_dimension(self, found: Quantity, dimension: Dimension, what: str) -> None:
        """Report a quantity of another dimension: of a name once, with where it is declared."""
        name = found.formula.name if isinstance(found.formula, Symbol) else ""
        declared = self.scope.declared(name)
        if declared and not self.scope.first_misfit(name, dimension):
            return
        message = quantities.wrong_dimension(
            found.span, found.dimension, dimension, what, name, declared
        )
        if message.span == declared:
            self.scope.doubt(found.formula)
        self.report.add(message)

    def _bare(self, found: Quantity) -> Bare | None:
        """Return the number without unit that a quantity is made of, where it is one."""
        unitless = found.sort.nature is Nature.UNITLESS
        return self.scope.bare(found.formula) if unitless else None

    def read(self, expression: ast.Expr) -> Quantity | None:
        """Read an expression; None where an error in it was reported."""
        match expression:
            case ast.Number():
                found: Quantity | None = self._number(expression)
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
        return self._sized(found) if found else None

    def _sized(self, found: Quantity) -> Quantity | None:
        """Refuse constants that grow beyond what anything measured can be."""
        match found.formula:
            case Number(value) | Product((Number(value), *_)) if too_large(value):
                self.report.add(quantities.number_too_large(found.span))
                return None
            case Power(_, Number(exponent)) if abs(exponent) > LARGEST_EXPONENT:
                self.report.add(quantities.number_too_large(found.span))
                return None
        return found

    def _number(self, node: ast.Number) -> Quantity:
        if not node.unit:
            nature = Nature.BARE if node.value else Nature.ZERO
            return Quantity(Number(node.value), Sort(NUMBER, nature), node.span)
        unit = UNITS[node.unit]
        plain = number(node.value * unit.factor)
        formula = product([(plain, 1), (PI, 1)]) if unit.pi else plain
        return Quantity(formula, Sort(unit.dimension), node.span)

    def _symbol(self, node: ast.Symbol) -> Quantity | None:
        if node.name == "pi":
            return Quantity(PI, Sort(NUMBER, Nature.LOOSE), node.span)
        if self._is_asked_of_the_pose(node.name) and (form := form_of_pose(node.name)):
            return self._of_the_pose(node, form)
        entry = self.scope.look_up(node, self.usage)
        if entry is None or entry.dimension is None:
            return None
        known = Sort(NUMBER, Nature.UNITLESS) if entry.unitless else Sort.of(entry.dimension)
        return Quantity(Symbol(node.name), known, node.span)

    def _is_asked_of_the_pose(self, name: str) -> bool:
        """Return whether no name of the user's own is meant; ``x_B`` is one where B is no point."""
        form = form_of_pose(name)
        is_own = (
            form and form.prefix in COORDINATES and form.points[0] not in self.scope.points.places
        )
        return name not in self.scope.entries and not is_own

    def _of_the_pose(self, node: ast.Symbol, form: Form) -> Quantity | None:
        """Return a direction or a length that the pose has; refuse other such quantities."""
        if form.prefix not in ("phi", "len", *COORDINATES):
            self._refuse(node, form)
            return None
        if len(form.points) > 2:
            self.scope.look_up(node, self.usage)
            return None
        if not self.scope.points.acting(ast.Name("".join(form.points), node.span)):
            return None
        if not self.usage.posed:
            what = f"{(FORMS | COORDINATES)[form.prefix]}, which follows from the description"
            wanted = self.usage.wanted
            hint = names.angle_from_vector() if form.prefix == "phi" else ""
            self.report.add(names.name_out_of_place(node.span, node.name, what, wanted, hint))
            return None
        sort = Sort.of(ANGLE if form.prefix == "phi" else LENGTH)
        return Quantity(Symbol(node.name), sort, node.span)

    def _refuse(self, node: ast.Symbol, form: Form) -> None:
        """Say why a quantity of the mechanism cannot stand in a formula."""
        points = ast.Name("".join(form.points), node.span)
        if not self.scope.points.known(points):
            return
        if form.prefix in ("V", "omega"):
            what, hint = FORMS[form.prefix], "give the ratio a name with 'find', and use that"
            self.report.add(names.name_out_of_place(node.span, node.name, what, VELOCITIES, hint))
        else:
            self.report.add(reactions.ask_first(node.span, node.name))

    def _sum(self, node: ast.Sum) -> Quantity | None:
        terms = [self.read(term) for _, term in node.terms]
        known = [term for term in terms if term]
        signs = [sign for sign, _ in node.terms]
        act = "add" if all(sign > 0 for sign in signs[1:]) else "subtract"
        sort = self.alike(known, act)
        if sort is None or len(known) < len(terms):
            return None
        pairs = zip(signs, known, strict=True)
        formula = total(t.formula if sign > 0 else negative(t.formula) for sign, t in pairs)
        return Quantity(formula, sort, node.span)

    def alike(self, parts: list[Quantity], act: str) -> Sort | None:
        """Return the sort that parts of a sum or comparison share; report where they do not."""
        if not parts:
            return None
        first, *rest = parts
        sort = first.sort
        anchor = first
        for part in rest:
            both = agreed(sort, part.sort)
            if both is None:
                self._differ(anchor, part, act)
                return None
            if both != sort:
                sort, anchor = both, part
        return sort

    def _differ(self, first: Quantity, part: Quantity, act: str) -> None:
        for bare, other in ((part, first), (first, part)):
            if bare.sort.nature is Nature.BARE or self._bare(bare):
                self.fits(bare, other.dimension, "a term")
                return
        self.report.add(
            quantities.mixed_dimensions(
                part.span,
                part.dimension,
                first.span,
                first.dimension,
                act,
                self._names(first, part),
            )
        )

    def _names(self, *parts: Quantity) -> list[tuple[str, Span]]:
        """Return the names among quantities, and where each is declared."""
        names = [part.formula.name for part in parts if isinstance(part.formula, Symbol)]
        places = [(name, self.scope.declared(name)) for name in names]
        return [(name, place) for name, place in places if place]

    def _product(self, node: ast.Product) -> Quantity | None:
        signs = [sign for sign, _ in node.factors]
        read = [self.read(factor) for _, factor in node.factors]
        factors = [factor for factor in read if factor]
        if len(factors) < len(signs) or not self._divisible(factors, signs):
            return None
        self._remark_on_powers(node)
        formula = product((f.formula, s) for f, s in zip(factors, signs, strict=True))
        sort = multiplied([(f.sort, s) for f, s in zip(factors, signs, strict=True)])
        if formula == ZERO and sort.nature is Nature.BARE:
            sort = Sort(NUMBER, Nature.ZERO)
        return Quantity(formula, sort, node.span)

    def _remark_on_powers(self, node: ast.Product) -> None:
        """Say of ``pi*50 mm^2`` that the power belongs to the unit: that of a length is meant."""
        above = [factor for sign, factor in node.factors if sign > 0]
        if not any(isinstance(factor, ast.Symbol) and factor.name == "pi" for factor in above):
            return
        for factor in above:
            if isinstance(factor, ast.Number) and (found := POWER_OF_LENGTH.fullmatch(factor.unit)):
                place = factor.span
                self.report.add(sizes.area_for_square(place, factor.digits, found[1], found[2]))

    def _divisible(self, factors: list[Quantity], signs: list[int]) -> bool:
        for factor, sign in zip(factors, signs, strict=True):
            if sign < 0 and rational(factor.formula) == 0:
                self.report.add(quantities.divided_by_zero(factor.span))
                return False
        return True

    def _power(self, node: ast.Power) -> Quantity | None:
        base, exponent = self.read(node.base), self.read(node.exponent)
        if not base or not exponent:
            return None
        exponent = _in_a_product(node.exponent, exponent)
        if not self.fits(exponent, NUMBER, "an exponent"):
            return None
        constant = rational(exponent.formula)
        if constant is None:
            return self._general_power(base, exponent, node.span)
        if abs(constant) > LARGEST_EXPONENT:
            self.report.add(quantities.number_too_large(exponent.span))
            return None
        if constant < 0 and rational(base.formula) == 0:
            self.report.add(quantities.divided_by_zero(base.span))
            return None
        return Quantity(
            power(base.formula, number(constant)), raised(base.sort, constant), node.span
        )

    def _general_power(self, base: Quantity, exponent: Quantity, span: Span) -> Quantity | None:
        if not base.sort.fits(NUMBER):
            self.report.add(quantities.exponent_not_number(exponent.span, base.dimension))
            return None
        formula = Power(base.formula, exponent.formula)
        return Quantity(formula, Sort(NUMBER, Nature.LOOSE), span)

    def _call(self, node: ast.Call) -> Quantity | None:
        read = [self.read(argument) for argument in node.arguments]
        arguments = [argument for argument in read if argument]
        sort = self._result(node, arguments) if len(arguments) == len(read) else None
        if sort is None:
            return None
        formula = Call(node.function, tuple(a.formula for a in arguments))
        return Quantity(formula, sort, node.span)

    def _result(self, node: ast.Call, arguments: list[Quantity]) -> Sort | None:
        """Return the sort of a function's value; report arguments that do not suit it."""
        argument = arguments[0]
        what = f"the argument of {node.function}"
        if node.function in ANGLE_TO_NUMBER:
            return Sort(NUMBER, Nature.VALUE) if self.fits(argument, ANGLE, what) else None
        if node.function in NUMBER_TO_ANGLE:
            return Sort(ANGLE) if self.fits(argument, NUMBER, what) else None
        if node.function in NUMBER_TO_NUMBER:
            argument = _in_a_product(node.arguments[0], argument)
            return Sort.of(NUMBER) if self.fits(argument, NUMBER, what) else None
        if node.function == "sqrt":
            return raised(argument.sort, Fraction(1, 2))
        assert node.function in ALIKE, node.function
        sort = self.alike(arguments, "compare")
        return Sort(ANGLE) if sort and node.function == "atan2" else sort


def _in_a_product(node: ast.Expr, found: Quantity) -> Quantity:
    """Return a multiple of an angle as the pure number that it is, as in exp(0.25*theta).

    An angle alone may be meant in degrees: it stays one.
    """
    terms = [term for _, term in node.terms] if isinstance(node, ast.Sum) else [node]
    if found.dimension != ANGLE or not all(isinstance(term, ast.Product) for term in terms):
        return found
    return found._replace(sort=Sort.of(NUMBER))
