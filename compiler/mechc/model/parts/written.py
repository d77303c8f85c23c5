"""What people wrote, for people: formulas with the numbers and units that stand in them.

Formulas that are computed with are in SI. Here a number that has a unit or a point is a
:class:`~...formula.tree.Constant` whose name is the text of it: ``5 mm``, ``0.25``.
"""

from collections.abc import Iterable
from itertools import pairwise
from typing import Literal, assert_never

from ...base.frozen import frozen
from ...formula.choices import CONDITIONS
from ...formula.layout import short_decimal
from ...formula.tree import (
    PI,
    Call,
    Constant,
    Formula,
    Number,
    Symbol,
    negative,
    power,
    product,
    total,
)
from ...formula.walk import constants, substitute, walk
from ...syntax import ast
from ...syntax.vocabulary import split_quantity
from ...units import UNITS, behind
from ..constants import rational


@frozen
class WrittenTable:
    """A table or, with one column, a list of sizes, and where it is from."""

    name: str
    source: str
    rows: tuple[tuple[Formula, ...], ...]


@frozen
class WrittenFormula:
    """A user-defined formula as it is written.

    One that is looked up has the ``kind`` of what it is ``of``; the formula is what that is asked
    for.
    """

    formula: Formula
    kind: Literal["", "table", "row", "list"] = ""
    of: str = ""


@frozen
class WrittenSides:
    """The sides of a condition as they are written, and the remark behind it."""

    left: Formula
    right: Formula
    label: str = ""


def let_value(value: ast.LetValue) -> WrittenFormula:
    """Return a user-defined formula as it is written."""
    match value:
        case ast.Choice():
            return WrittenFormula(_choice(value))
        case ast.Lookup(table, at, exactly=exactly):
            return WrittenFormula(expression(at), "row" if exactly else "table", table.text)
        case ast.NextSize(least, sizes):
            return WrittenFormula(expression(least), "list", sizes.text)
        case _:
            return WrittenFormula(expression(value))


def tables(statements: Iterable[ast.Statement]) -> tuple[WrittenTable, ...]:
    """Return the tables and lists among statements as they are written."""
    found: list[WrittenTable] = []
    for statement in statements:
        match statement:
            case ast.Table(_, name, rows, source):
                pairs = tuple((expression(a), expression(value)) for a, value in rows)
                found.append(WrittenTable(name.text, source, pairs))
            case ast.Sizes(_, name, sizes, source):
                column = tuple((expression(size),) for size in sizes)
                found.append(WrittenTable(name.text, source, column))
    return tuple(found)


def sides(require: ast.Require) -> list[WrittenSides]:
    """Return the links of a condition as they are written."""
    operands = map(expression, require.operands)
    return [WrittenSides(left, right, require.remark) for left, right in pairwise(operands)]


def units(*formulas: Formula) -> list[str]:
    """Return the units written in formulas."""
    numbers = (part.name for f in formulas for part in walk(f) if isinstance(part, Constant))
    return [split_quantity(number.strip("(-)"))[1] for number in numbers]


def expression(node: ast.Expr) -> Formula:
    """Return an expression as it is written."""
    match node:
        case ast.Number():
            return _number(node)
        case ast.Symbol(name):
            return PI if name == "pi" else Symbol(name)
        case ast.Sum(terms):
            parts = ((sign, expression(term)) for sign, term in terms)
            return total(part if sign > 0 else negative(part) for sign, part in parts)
        case ast.Product(factors):
            return product((_factor(factor, sign), sign) for sign, factor in factors)
        case ast.Power(base, exponent):
            return power(_bracketed(expression(base)), _exponent(exponent))
        case ast.Call(function, arguments):
            return Call(function, tuple(map(expression, arguments)))
        case _:
            assert_never(node)


def _factor(node: ast.Expr, sign: int) -> Formula:
    """Return a factor; a whole number below the line stays there, where it could be a decimal."""
    found = expression(node)
    if sign < 0 and isinstance(found, Number) and found.value and short_decimal(1 / found.value):
        return Constant(str(found.value), found)
    return found


def _exponent(node: ast.Expr) -> Formula:
    """Return an exponent; one that is a number as such, so that halves are roots."""
    found = expression(node)
    exact = rational(substitute(found, {c.name: c.value for c in constants([found])}))
    return found if exact is None else Number(exact)


def _bracketed(base: Formula) -> Formula:
    """Return the base of a power; a number with its unit is squared with it, ``(8 mm)^2``."""
    if isinstance(base, Constant) and split_quantity(base.name)[1]:
        return Constant(f"({base.name})", base.value)
    return base


def _number(node: ast.Number) -> Formula:
    if not node.unit and node.digits.isdecimal():
        return Number(node.value)
    unit = UNITS.get(node.unit)
    plain = Number(node.value * unit.factor if unit else node.value)
    value = product([(plain, 1), (PI, 1)]) if unit and unit.pi else plain
    return Constant(f"{node.digits}{behind(node.unit)}", value)


def _choice(choice: ast.Choice) -> Formula:
    """Return a choice as it is written, one in an ``else`` as its last value."""
    parts: list[Formula] = []
    for branch in choice.branches:
        links = [link for condition in branch.conditions for link in _links(condition)]
        condition = links[0] if len(links) == 1 else Call("both", tuple(links))
        parts += [condition, expression(branch.value)]
    match choice.otherwise:
        case None:
            return Call("choose", tuple(parts))
        case ast.Choice() as other:
            return Call("choose", (*parts, _choice(other)))
        case other:
            return Call("choose", (*parts, expression(other)))


def _links(condition: ast.Condition) -> list[Formula]:
    operands = [expression(operand) for operand in condition.operands]
    triples = zip(operands, condition.operators, operands[1:], strict=False)
    return [Call(CONDITIONS[operator], (left, right)) for left, operator, right in triples]
