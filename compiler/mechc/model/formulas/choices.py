"""User-defined formulas that are more than an expression: choices, and what tables hold."""

import math
from collections.abc import Iterator, Mapping, Sequence

from ...diagnostics.model import doubts
from ...formula.choices import CONDITIONS
from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula, Symbol, number
from ...formula.walk import symbols
from ...syntax import ast
from ..mechanism import Require, Subject
from ..names.scope import FORMULA, NameScope
from .expressions import Reader
from .measured import MeasuredFormula, alike
from .tables import ConditionalFormula, Tables, looked_up, next_size

_TURNED = {"less": "more", "at_most": "at_least", "more": "less", "at_least": "at_most"}
"""A comparison read from its right side."""

ValueRange = tuple[float, float]

OpenOrClosed = tuple[float, bool]
"""An end of an interval, the upper one with its sign turned, and whether it is left out.

Of two ends the stricter one is the greater.
"""


def read_let_value(let: ast.Let, tables: Tables, scope: NameScope) -> ConditionalFormula | None:
    """Read what a ``let`` stands for; None where an error in it was reported."""
    match let.value:
        case ast.Choice() as choice:
            return _choice(choice, let, scope)
        case ast.Lookup() as lookup:
            return looked_up(lookup, let, tables, scope)
        case ast.NextSize() as wanted:
            return next_size(wanted, let, tables, scope)
        case expression:
            found = Reader(scope, FORMULA).read(expression)
            return ConditionalFormula(found) if found else None


def _choice(choice: ast.Choice, let: ast.Let, scope: NameScope) -> ConditionalFormula | None:
    """Read a choice: its value is that of the first branch whose conditions hold.

    More than one may not hold, and one must unless something is said otherwise.
    """
    read = list(_branches(choice, scope))
    branches = [branch for branch in read if branch]
    values = [value for _, value in branches]
    requires: tuple[Require, ...] = ()
    if choice.otherwise:
        other = _otherwise(choice.otherwise, let, scope)
        if other is None:
            return None
        requires = other.requires
        values.append(other.quantity)
    sort = alike(values, "choose between", scope)
    if len(branches) < len(read) or sort is None:
        return None
    conditions = [condition for condition, _ in branches]
    formula = Call("choose", tuple(_flat(conditions, values)))
    own = _exclusive(conditions, choice, let)
    return ConditionalFormula(MeasuredFormula(formula, sort, choice.span), (*own, *requires))


def _otherwise(
    otherwise: ast.Expr | ast.Choice, let: ast.Let, scope: NameScope
) -> ConditionalFormula | None:
    if isinstance(otherwise, ast.Choice):
        return _choice(otherwise, let, scope)
    found = Reader(scope, FORMULA).read(otherwise)
    return ConditionalFormula(found) if found else None


def _flat(conditions: Sequence[Formula], values: Sequence[MeasuredFormula]) -> Iterator[Formula]:
    for condition, value in zip(conditions, values, strict=False):
        yield from (condition, value.formula)
    yield from (value.formula for value in values[len(conditions) :])


def _exclusive(
    conditions: Sequence[Formula], choice: ast.Choice, let: ast.Let
) -> tuple[Require, ...]:
    """Return that one branch holds, or that no two do where something is said otherwise.

    A choice in an ``else`` is asked only where no branch before it holds: nothing is
    required of it there.
    """
    nested = let.value != choice
    if nested or (choice.otherwise and len(conditions) == 1):
        return ()
    subject = Subject("choice", let.name.text, let.name.text)
    count = Call("count", tuple(conditions))
    if choice.otherwise:
        return (Require(count, "<=", number(1), choice.span, subject),)
    return (Require(count, "=", number(1), choice.span, subject),)


def _branches(
    choice: ast.Choice, scope: NameScope
) -> Iterator[tuple[Formula, MeasuredFormula] | None]:
    """Yield the condition and the value of each branch; None where there is an error in it."""
    reader = Reader(scope, FORMULA)
    for branch in choice.branches:
        value = reader.read(branch.value)
        pairs = [pair for c in branch.conditions for pair in _links(c, reader)]
        found = [pair for pair in pairs if pair]
        sound = value is not None and found and len(found) == len(pairs)
        if sound and not symbols(*found):
            operands = branch.conditions[0].operands
            whole = operands[0].span.to(operands[-1].span)
            reader.report.add(doubts.condition_of_constants(whole))
        elif sound and (name := never_met(found, scope.ranges)):
            first, last = branch.conditions[0].operands[0], branch.conditions[-1].operands[-1]
            whole = first.span.to(last.span)
            reader.report.add(doubts.never_met(whole, name, name in scope.ranges))
        condition = Call("both", tuple(found)) if len(found) > 1 else found[0] if found else None
        yield (condition, value) if sound and condition and value else None


def _links(condition: ast.Condition, reader: Reader) -> list[Formula | None]:
    """Return the links of a chain of comparisons; None where there is an error in it."""
    operands = [reader.read(operand) for operand in condition.operands]
    known = [operand for operand in operands if operand]
    if len(known) < len(operands) or alike(known, "compare", reader.scope) is None:
        return [None]
    signs = (CONDITIONS[operator] for operator in condition.operators)
    triples = zip(known, signs, known[1:], strict=False)
    return [Call(sign, (left.formula, right.formula)) for left, sign, right in triples]


def never_met(links: Sequence[Formula], ranges: Mapping[str, ValueRange]) -> str:
    """Return the name of which no value in its range meets all comparisons with numbers, or ''.

    Comparisons of other things are not looked at.

    >>> from ...formula.tree import number
    >>> v = Symbol("v")
    >>> never_met([Call("more", (v, number(5)))], {"v": (0, 2)})
    'v'
    >>> never_met([Call("more", (v, number(5))), Call("less", (v, number(9)))], {})
    ''
    >>> never_met([Call("more", (v, number(5))), Call("at_most", (v, number(5)))], {})
    'v'
    >>> never_met([Call(c, (v, number(n))) for c, n in (("more", 3), ("same", 5))], {})
    ''
    """
    ends: dict[str, tuple[OpenOrClosed, OpenOrClosed]] = {}
    for name, comparison, value in filter(None, map(_about_a_name, links)):
        first, last = ranges.get(name, (-math.inf, math.inf))
        low, high = ends.get(name, ((first, False), (-last, False)))
        if comparison in ("more", "at_least", "same"):
            low = max(low, (value, comparison == "more"))
        if comparison in ("less", "at_most", "same"):
            high = max(high, (-value, comparison == "less"))
        ends[name] = low, high
        width = -high[0] - low[0]
        if width < 0 or (width == 0 and (low[1] or high[1])):
            return name
    return ""


def _about_a_name(link: Formula) -> tuple[str, str, float] | None:
    """Return a comparison of a name with a number: the name, the comparison, the number."""
    match link:
        case Call(comparison, (Symbol(name), right)) if not symbols(right):
            return name, comparison, evaluate(right, {})
        case Call(comparison, (left, Symbol(name))) if not symbols(left):
            return name, _TURNED.get(comparison, comparison), evaluate(left, {})
    return None
