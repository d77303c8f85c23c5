"""Conditions of use, and what books and colleagues expect of results."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from ...base.frozen import replace
from ...diagnostics import Diagnostic, Report
from ...diagnostics import uses as uses_messages
from ...diagnostics.model import doubts, quantities, sizes
from ...diagnostics.model import results as messages
from ...formula.evaluate import evaluate
from ...formula.tree import Formula, Symbol
from ...formula.walk import substitute, symbols
from ...syntax import ast
from ...units import NUMBER, Dimension, in_unit, si_unit
from ..constants import last_digit
from ..formulas.definitions import DefinedValues, written_out
from ..formulas.expressions import Reader
from ..formulas.measured import MeasuredFormula, alike, fits
from ..formulas.parameters import constant, read_tolerance
from ..formulas.sorts import Nature
from ..mechanism import Expect, Find, Require, Subject
from ..names.scope import CONDITION, EXPECTED, NameScope
from ..statements import every
from ..tolerances import SAME_VALUE
from ..values import Chain, Values, compare, holds
from . import failures
from .finds import read_target


def _of_parameters(
    found: MeasuredFormula, lets: Mapping[str, Formula], scope: NameScope
) -> Formula:
    """Return the formula with every let that is no parameter written out.

    A sheet's conditions keep the names that people wrote: its lets have values as parameters do.
    """
    if scope.sheet:
        return found.formula
    for name in sorted((symbols(found.formula) & scope.entries.keys()) - lets.keys()):
        if scope.entries[name].kind == "let" and name not in scope.feeding:
            scope.report.add(messages.let_too_long(found.span, name))
    return substitute(found.formula, lets)


# ---------------------------------------------------------------------- conditions


def read_requires(file: ast.File, found: DefinedValues, scope: NameScope) -> list[Require]:
    """Return every condition; a chain is split into its links."""
    lets = written_out(found, scope)
    values = Chain({let.name: let.value for let in found.lets.values()}).complete(scope.values)
    requires: list[Require] = []
    for statement in every(file, ast.Require):
        reader = Reader(scope, CONDITION)
        read = [reader.read(operand) for operand in statement.operands]
        operands = [operand for operand in read if operand]
        sort = alike(operands, "compare", scope) if len(operands) == len(read) else None
        if sort is None:
            continue
        formulas = [_of_parameters(operand, lets, scope) for operand in operands]
        pairs = zip(formulas, statement.operators, formulas[1:], strict=False)
        place, dimension = statement.span, sort.dimension
        conditions = [Require(*pair, place, dimension=dimension) for pair in pairs]
        _remark_on(conditions, found, scope)
        for condition in conditions if not scope.sheet else ():
            if not holds(condition, values):
                scope.report.add(
                    failures.broken(condition, values, scope.report.source, found.lets)
                )
        requires += conditions
    if not scope.sheet:
        _refuse_without(found.requires, values, scope)
        return [*_ranges(found, lets, values, scope), *requires]
    return [*sorted(found.requires, key=lambda r: r.span), *requires]


def _remark_on(conditions: Sequence[Require], found: DefinedValues, scope: NameScope) -> None:
    """Say of a condition that it names nothing, or that it holds at one value alone."""
    for condition in conditions:
        sides = condition.left, condition.right
        if not symbols(*sides):
            scope.report.add(doubts.condition_of_constants(condition.span))
        elif condition.left == condition.right:
            scope.report.add(doubts.condition_of_constants(condition.span, is_same=True))
        elif condition.operator == "=":
            free = [f.name for f in sides if isinstance(f, Symbol) and _is_free(f.name, found)]
            if free:
                scope.report.add(doubts.condition_of_one_value(condition.span, free[0]))


def _is_free(name: str, found: DefinedValues) -> bool:
    parameter = found.parameters.get(name)
    return parameter is not None and not parameter.dependent


def implied(found: DefinedValues) -> Iterator[Require]:
    """Yield what tables, lists and choices demand, for when the pose and results are known."""
    return (require for require in found.requires if not _is_range(require))


def _refuse_without(implied: Sequence[Require], values: Values, scope: NameScope) -> None:
    """Report the tables, choices and lists that have no value at those of a mechanism.

    Where a sheet is given what is outside its range, that alone is reported.
    """
    if all(holds(require, values) for require in implied if _is_range(require)):
        refuse_failing(implied, values, scope.report)


def refuse_failing(implied: Iterable[Require], values: Values, report: Report) -> None:
    """Report the conditions that fail at these values; those on what has none are left out."""
    for require in implied:
        if not symbols(require.left) | symbols(require.right) <= values.keys():
            continue
        left, right = evaluate(require.left, values), evaluate(require.right, values)
        if math.isnan(left) or math.isnan(right):
            continue  # what has no value is remarked on by itself
        if not compare(left, require.operator, right):
            report.add(failures.failure(require, (left, right), report.source))


def _is_range(require: Require) -> bool:
    return require.subject is not None and require.subject.kind == "range"


def _ranges(
    found: DefinedValues, lets: Mapping[str, Formula], values: Values, scope: NameScope
) -> Iterator[Require]:
    """Yield that what a mechanism gives to sheets is in the ranges that these have for it."""
    refused = set[str]()
    for require in found.requires:
        subject = require.subject
        if subject is None or subject.kind != "range":
            continue
        entry = scope.entries[subject.let]
        if entry.on_loads or entry.on_pose:
            if subject.let not in refused:
                scope.report.add(
                    uses_messages.range_of_results(require.span, subject.let, subject.place)
                )
            refused.add(subject.let)
            continue
        if fault := _outside(require, subject, values):
            scope.report.add(fault)
        yield replace(require, left=substitute(require.left, lets), subject=None)


def _outside(require: Require, subject: Subject, values: Values) -> Diagnostic | None:
    """Return that what is given is outside its range, at the values of the description."""
    if subject.let not in values or holds(require, values):
        return None
    end = evaluate(require.right, {})
    unit = si_unit(require.dimension)
    left, right = (in_unit(value, unit, 6) for value in (values[subject.let], end))
    said = f"{subject.let} = {left}", require.operator, right
    return uses_messages.outside_used_range(require.span, *said, subject.place)


# -------------------------------------------------------------------- expectations


def read_expects(
    file: ast.File, finds: Sequence[Find], found: DefinedValues, scope: NameScope
) -> list[Expect]:
    """Return the expected values of results, and their tolerances."""
    subjects = _subjects(file, finds, found, scope)
    failed = _failed(file, subjects, found)  # and, as they are met, other names of no result
    lets = written_out(found, scope)
    expects: list[Expect | None] = []
    for statement in every(file, ast.Expect):
        named = statement.subject.name if isinstance(statement.subject, ast.Symbol) else ""
        if named in failed:
            continue
        subject = _subject(statement.subject, finds, subjects, scope)
        if subject is None and named:
            failed.add(named)
        dimension = subjects[subject] if subject else None
        expects.append(_expect(statement, subject, dimension, lets, scope))
    return [expect for expect in expects if expect]


def _expect(
    statement: ast.Expect,
    subject: str | None,
    dimension: Dimension | None,
    lets: Mapping[str, Formula],
    scope: NameScope,
) -> Expect | None:
    """Return an expectation; None where it is of no result, or where it cannot be read."""
    value = Reader(scope, EXPECTED).read(statement.value)
    at = _settings(statement, scope)
    if subject is None or value is None or not _suits(value, dimension, "the result", scope):
        return None
    formula = _of_parameters(value, lets, scope)
    tolerance = _tolerance(statement, value, formula, scope)
    stated = statement.tolerance is not None
    return Expect(subject, formula, at, tolerance, statement.span, stated)


def _tolerance(
    statement: ast.Expect, value: MeasuredFormula, formula: Formula, scope: NameScope
) -> Fraction:
    """Return how far a figure may be off, in SI: as stated, or half of its last digit."""
    if statement.tolerance is None:
        return half_a_digit(statement.value)
    if symbols(formula):
        scope.report.add(messages.tolerance_of_formula(statement.tolerance.span))
        return Fraction(0)
    anything = value.sort.nature is Nature.ZERO
    dimension = None if anything else value.dimension
    found = read_tolerance(statement.tolerance, dimension, "of the figure", scope)
    if found is None:
        return Fraction(0)
    size = evaluate(found, {})
    if 0 < abs(evaluate(formula, {})) <= size:
        scope.report.add(sizes.tolerance_of_all(statement.tolerance.span))
    return Fraction(size)


def _subjects(
    file: ast.File, finds: Sequence[Find], found: DefinedValues, scope: NameScope
) -> dict[str, Dimension | None]:
    """Return the possible subjects of expectations: finds, lets of results, used results."""
    known = [find.name for find in finds] + [n for n in found.lets if n not in scope.feeding]
    known += [taken.name.text for taken in every(file, ast.Taken)]
    return {name: scope.entries[name].dimension for name in known}


def _failed(file: ast.File, known: Mapping[str, object], found: DefinedValues) -> set[str]:
    """Return the names of results that were reported already.

    They are of finds that ask for nothing, and of lets that cannot be read. Without any result,
    that is what is reported, and no ``expect``.
    """
    names = {s.name.text for s in every(file, ast.Find) if s.name}
    names |= {s.name.text for s in every(file, ast.Let)} - found.lets.keys()
    if not known:
        names |= {
            e.subject.name for e in every(file, ast.Expect) if isinstance(e.subject, ast.Symbol)
        }
    return names - known.keys()


def _subject(
    subject: ast.Expr, finds: Sequence[Find], known: Mapping[str, object], scope: NameScope
) -> str | None:
    """Return the name of a result that is named or repeated as a ratio."""
    match subject:
        case ast.Symbol(name=name) if name in known:
            scope.used.add(name)
            return name
        case ast.Product():
            asked = read_target(subject, scope)
            if asked is None:
                return None
            for find in finds:
                if find.target == asked.target:
                    return find.name
    name = subject.name if isinstance(subject, ast.Symbol) else ""
    load = name if name in scope.names({"load"}) else ""
    scope.report.add(messages.unknown_subject(subject.span, known, load))
    return None


def _suits(
    value: MeasuredFormula, dimension: Dimension | None, what: str, scope: NameScope
) -> bool:
    return dimension is None or fits(value, dimension, what, scope)


def _settings(statement: ast.Expect, scope: NameScope) -> dict[str, Formula]:
    """Return the values behind ``at``."""
    at: dict[str, Formula] = {}
    for name, expression in statement.at:
        value = _setting(name, expression, scope)
        if value is not None:
            if name.text in at:
                scope.report.add(messages.set_twice(name.span, name.text))
            at[name.text] = value
            _remark_on_setting(name, evaluate(value, {}), scope)
    return at


def _setting(name: ast.Name, expression: ast.Expr, scope: NameScope) -> Formula | None:
    """Return the value that a parameter or a load is set to, None where that is wrong."""
    entry, what = scope.entries.get(name.text), f"the value of '{name.text}'"
    value = constant(expression, scope, what)
    if entry is None:
        scope.unknown(name.span, name.text, scope.names({"parameter", "load"}))
    elif entry.kind not in ("parameter", "load"):
        scope.report.add(messages.not_a_setting(name.span, name.text, f"a {entry.kind}"))
    elif value and entry.number and entry.dimension and value.dimension != NUMBER:
        bare = entry.number
        scope.doubt(Symbol(name.text))
        scope.report.add(quantities.bare_number(bare.span, bare.digits, value.dimension, name.span))
    elif value and _suits(value, entry.dimension, what, scope):
        return value.formula
    return None


def _remark_on_setting(name: ast.Name, value: float, scope: NameScope) -> None:
    """Say that a parameter is set to a value outside its range."""
    if ends := scope.ranges.get(name.text):
        slack = SAME_VALUE * max(map(abs, ends))
        if not ends[0] - slack <= value <= ends[1] + slack:
            place = scope.entries[name.text].span
            scope.report.add(sizes.setting_outside_range(name.span, name.text, place))


def half_a_digit(value: ast.Expr) -> Fraction:
    """Return half a unit of the last digit written, in SI; 0 for formulas and whole numbers.

    A number with an exponent is no whole number: 353e-3 is 3.53e-1 is 0.353.

    >>> from ...source import Span
    >>> half_a_digit(ast.Number("7.1407", "", Span(0, 6)))
    Fraction(1, 20000)
    """
    match value:
        case ast.Sum(terms=((_, ast.Number() as number),)) | (ast.Number() as number):
            return _half_a_digit(number)
        case _:
            return Fraction(0)


def _half_a_digit(number: ast.Number) -> Fraction:
    is_whole = number.digits.isdecimal()
    return Fraction(0) if is_whole else last_digit(number) / 2
