"""Tables and lists of sizes: how they are read, and what is looked up in them."""

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

from ...base.named import NamedTuple
from ...diagnostics.model import sheets as messages
from ...formula.choices import SAME_ROW
from ...formula.evaluate import evaluate
from ...formula.tree import Call, Formula
from ...syntax import ast
from ...units import LENGTH
from ..constants import leaves
from ..mechanism import Require, Subject
from ..names.scope import FORMULA, NameScope
from ..statements import every
from .expressions import Reader
from .measured import MeasuredFormula, alike, fits
from .parameters import constant
from .sorts import Sort


class Tables(NamedTuple):
    """The tables and lists of a description by their names, each value a constant in SI.

    A table has its rows from the smallest argument on, a list its sizes.
    """

    tables: dict[str, list[tuple[MeasuredFormula, MeasuredFormula]]]
    sizes: dict[str, list[MeasuredFormula]]


class ConditionalFormula(NamedTuple):
    """A user-defined formula, and the conditions under which it has a value."""

    quantity: MeasuredFormula
    requires: tuple[Require, ...] = ()


DOUBTFUL_SIZE_STEP = 5.0
"""How many times the size before it a size in a unit of its own is without a doubt."""

JUMP_OF_TWO = 100.0
"""The same where there are two sizes, either of which may have the wrong unit."""

MOST_ROWS = 200
"""Rows of a table, or sizes of a list: more are a file of data."""


def read_tables(file: ast.File, scope: NameScope) -> Tables:
    """Read the tables and lists of a description, whose names the scope knows."""
    found = Tables({}, {})
    lengths = [(table.name, len(table.rows)) for table in every(file, ast.Table)]
    lengths += [(listed.name, len(listed.sizes)) for listed in every(file, ast.Sizes)]
    for name, length in lengths:
        if length > MOST_ROWS:
            scope.report.add(messages.too_long(name.span, name.text, MOST_ROWS))
            return found
    for table in every(file, ast.Table):
        if rows := _rows(table, scope):
            found.tables[table.name.text] = rows
    for listed in every(file, ast.Sizes):
        _check_commas(listed.sizes, scope)
        if sizes := _alike([constant(s, scope, "a size of a list") for s in listed.sizes], scope):
            _check_order(sizes, listed.name.text, scope)
            _check_units(listed.sizes, sizes, f"size of list '{listed.name.text}'", scope)
            _check_least(sizes[0], listed.name.text, scope)
            found.sizes[listed.name.text] = sizes
    return found


def _rows(table: ast.Table, scope: NameScope) -> list[tuple[MeasuredFormula, MeasuredFormula]]:
    """Return the rows of a table from the smallest argument on; none where one is wrong."""
    columns = list(zip(*table.rows, strict=True))
    read = ([constant(e, scope, "a value of a table") for e in column] for column in columns)
    arguments, values = (_alike(column, scope) for column in read)
    if not (arguments and values):
        return []
    for written, found in zip(columns, (arguments, values), strict=True):
        _check_units(written, found, f"number of table '{table.name.text}'", scope)
    if len(arguments) == 1:
        scope.report.add(messages.table_of_one_row(table.name.span, table.name.text))
        return []
    rows = list(zip(arguments, values, strict=True))
    rows = rows if _value(arguments[0]) < _value(arguments[-1]) else rows[::-1]
    _check_order([argument for argument, _ in rows], table.name.text, scope)
    return rows


def _alike(read: Sequence[MeasuredFormula | None], scope: NameScope) -> list[MeasuredFormula]:
    """Return quantities of one dimension, a bare 0 of that of the others; none where one is wrong.

    That is reported.
    """
    found = [quantity for quantity in read if quantity]
    sort = alike(found, "compare", scope) if len(found) == len(read) else None
    return [quantity._replace(sort=sort) for quantity in found] if sort else []


def _check_order(column: Sequence[MeasuredFormula], name: str, scope: NameScope) -> None:
    """Report the first number that is not larger than the one before it."""
    for before, after in pairwise(column):
        if not _value(before) < _value(after):
            scope.report.add(
                messages.not_in_order(
                    after.span, name, before.span, _value(after) == _value(before)
                )
            )
            return


def _check_commas(sizes: Sequence[ast.Expr], scope: NameScope) -> None:
    """Say that two numbers stand like one with a decimal comma, and others do not."""
    text = scope.report.source.text
    pairs = [
        (one, next_, text[one.span.end : next_.span.start] == ",")
        for one, next_ in pairwise(sizes)
        if isinstance(one, ast.Number) and isinstance(next_, ast.Number)
    ]
    is_everywhere = all(is_tight for _, _, is_tight in pairs)
    for whole, part, is_tight in pairs:
        if is_tight and not whole.unit and (part.unit or not is_everywhere):
            span = whole.span.to(part.span)
            scope.report.add(messages.decimal_comma(span, whole.digits, part.digits))
            return


def _check_units(
    written: Sequence[ast.Expr], sizes: Sequence[MeasuredFormula], what: str, scope: NameScope
) -> None:
    """Say that one number alone has another unit, and is far from its neighbours."""
    units = [next((n.unit for n in leaves(e) if isinstance(n, ast.Number)), "") for e in written]
    usual = max(units, key=units.count)
    odd = [i for i, unit in enumerate(units) if unit != usual]
    if len(odd) != 1:
        return
    jump = DOUBTFUL_SIZE_STEP if len(units) > 2 else JUMP_OF_TWO
    values = [_value(size) for size in sizes]
    here, rest = odd[0], [v for i, v in enumerate(values) if v and i != odd[0]]
    nearest = min(rest, key=lambda value: abs(value - values[here]), default=0.0)
    if nearest and units[here] and not 1 / jump < values[here] / nearest < jump:
        scope.report.add(messages.size_in_another_unit(sizes[here].span, what, usual))


def _check_least(least: MeasuredFormula, name: str, scope: NameScope) -> None:
    """Report a length, the first and smallest of a list, that is not positive."""
    if least.dimension == LENGTH and not _value(least) > 0:
        scope.report.add(messages.size_not_positive(least.span, name))


def _value(quantity: MeasuredFormula) -> float:
    return evaluate(quantity.formula, {})


def looked_up(
    lookup: ast.Lookup, let: ast.Let, tables: Tables, scope: NameScope
) -> ConditionalFormula | None:
    """Return the value of a table at an argument, on the condition that it reaches so far."""
    name = lookup.table.text
    first_arguments = {each: rows[0][0] for each, rows in tables.tables.items()}
    what = f"the argument of table '{name}'"
    at = _sought(lookup.at, lookup.table, "table", first_arguments, what, scope)
    if not at:
        return None
    rows = tables.tables[name]
    parts = [part.formula for row in rows for part in row]
    if lookup.exactly:
        return _row_of(at, parts, rows[0][1].sort, lookup, let)
    formula = Call("interpolate", (at.formula, *parts))
    first, last = (
        Subject("first row", name, let.name.text),
        Subject("last row", name, let.name.text),
    )
    low, high = rows[0][0].formula, rows[-1][0].formula
    return ConditionalFormula(
        MeasuredFormula(formula, rows[0][1].sort, lookup.span),
        (
            Require(low, "<=", at.formula, lookup.span, first, dimension=at.dimension),
            Require(at.formula, "<=", high, lookup.span, last, dimension=at.dimension),
        ),
    )


def note_between(
    let: ast.Let, statements: Mapping[str, ast.Statement], tables: Tables, scope: NameScope
) -> None:
    """Warn where a size of a list is looked up in a table that has no row for some sizes.

    Sizes come one by one, and what belongs to them, a rod, a pitch, does so as well.
    """
    match let.value:
        case ast.Lookup(table, ast.Symbol(name=asked), exactly=False):
            pass
        case _:
            return
    match statements.get(asked):
        case ast.Let(value=ast.NextSize(sizes=sizes)):
            pass
        case _:
            return
    rows = [_value(argument) for argument, _ in tables.tables.get(table.text, ())]
    between = [
        size.span
        for size in tables.sizes.get(sizes.text, ())
        if rows and rows[0] < _value(size) < rows[-1] and not _is_row(_value(size), rows)
    ]
    if between:
        span = let.value.span
        scope.report.add(messages.size_between_rows(span, table.text, sizes.text, between))


def _is_row(value: float, rows: Sequence[float]) -> bool:
    return any(math.isclose(value, row, rel_tol=float(SAME_ROW)) for row in rows)


def _row_of(
    at: MeasuredFormula, parts: Sequence[Formula], sort: Sort, lookup: ast.Lookup, let: ast.Let
) -> ConditionalFormula:
    """Return the value of a row, on the condition that what is asked for is one."""
    formula, met = Call("row", (at.formula, *parts)), Call("met", (at.formula, *parts[::2]))
    subject = Subject("row", lookup.table.text, let.name.text)
    is_row = Require(at.formula, "=", met, lookup.span, subject, dimension=at.dimension)
    return ConditionalFormula(MeasuredFormula(formula, sort, lookup.span), (is_row,))


def next_size(
    wanted: ast.NextSize, let: ast.Let, tables: Tables, scope: NameScope
) -> ConditionalFormula | None:
    """Return the next size of a list, on the condition that the largest one is enough."""
    name = wanted.sizes.text
    smallest = {each: sizes[0] for each, sizes in tables.sizes.items()}
    what = f"a size of list '{name}'"
    least = _sought(wanted.least, wanted.sizes, "list", smallest, what, scope)
    if not least:
        return None
    sizes = tables.sizes[name]
    formula = Call("next", (least.formula, *(size.formula for size in sizes)))
    last, subject = sizes[-1].formula, Subject("list", name, let.name.text)
    dimension = sizes[0].dimension
    largest = Require(least.formula, "<=", last, wanted.span, subject, dimension=dimension)
    return ConditionalFormula(MeasuredFormula(formula, sizes[0].sort, wanted.span), (largest,))


def _sought(
    written: ast.Expr,
    name: ast.Name,
    kind: str,
    first: Mapping[str, MeasuredFormula],
    what: str,
    scope: NameScope,
) -> MeasuredFormula | None:
    """Return the quantity looked up in a table or list, by the ``first`` quantities of these.

    None where there is no such table or list, or that measures something else: it is reported.
    """
    if not _known(name, first, kind, scope):
        return None
    found = Reader(scope, FORMULA).read(written)
    like = first.get(name.text)
    return found if found and like and fits(found, like.dimension, what, scope) else None


def _known(name: ast.Name, known: Mapping[str, object], kind: str, scope: NameScope) -> bool:
    """Return whether a table or list was declared; one that was wrong has been reported."""
    entry = scope.entries.get(name.text)
    scope.used.add(name.text)
    if entry is not None and entry.kind == kind:
        return True
    scope.report.add(messages.no_such_table(name.span, name.text, kind, list(known)))
    return False
