"""What a table gives between two of its rows, in numbers."""

import math
from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise

from ..formula.evaluate import evaluate
from ..formula.tree import Constant, Formula, Number, negative, product, total
from ..formula.walk import constants
from ..model.mechanism import Mechanism
from ..model.written import WrittenTable
from ..syntax.vocabulary import split_quantity
from .put_in import DIGITS, Quantity

Tables = Mapping[str, WrittenTable]
"""Tables by their names."""


def tables_of(mechanism: Mechanism) -> Tables:
    """Return the tables and lists of a description, by their names."""
    return {table.name: table for table in mechanism.tables}


def line_between(table: WrittenTable, asked: float) -> Formula | None:
    """Return the straight line between the rows around what is asked for: y1 + (x - x1)/….

    None where that is a row itself, or where no two rows lie around it.
    """
    rows = [(cell, evaluate(cell, {}), value) for cell, value in table.rows]
    for before, after in pairwise(sorted(rows, key=lambda row: row[1])):
        if before[1] < asked < after[1] and not _is_one_of(asked, before[1], after[1]):
            low, high = map(_as_written, (before[2], after[2]))
            first, last = map(_as_written, (before[0], after[0]))
            way, rise = _less(last, first), _less(high, low)
            part = product([(_less(_asked(asked, first), first), 1), (way, -1), (rise, 1)])
            return total([low, part])
    return None


def _less(one: Formula, other: Formula) -> Formula:
    return total([one, negative(other)])


def _is_one_of(asked: float, *rows: float) -> bool:
    return any(math.isclose(asked, row, rel_tol=1e-12) for row in rows)


def _asked(value: float, row: Formula) -> Constant:
    """Return the value asked for in the unit of a row."""
    unit = next((split_quantity(c.name)[1] for c in constants([row])), "")
    return Constant(Quantity(value, unit).text(DIGITS), Number(Fraction(value)))


def _as_written(cell: Formula) -> Formula:
    """Return a cell that stays as it is written, also where it is a number alone."""
    return Constant(str(cell.value), cell) if isinstance(cell, Number) else cell
