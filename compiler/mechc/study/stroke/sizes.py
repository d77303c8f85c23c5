"""The sizes in the rows of a stroke, without what is nothing but rounding."""

import math
from collections.abc import Callable, Sequence
from functools import cache, partial

from ...formula.rounded_columns import Column, RoundedColumns
from ...formula.rounding import Rounding, Size, beyond_rounding, without_rounding, without_value
from ...formula.walk import symbols
from .columns import Filled
from .run import Run
from .sides import from_both_sides, is_on_a_side


class Sizes:
    """Finds sizes at poses; how exact they are is found for all poses at once where it can be."""

    def __init__(self, run: Run, drives: Sequence[float], filled: Sequence[Filled]) -> None:
        self._run, self._filled = run, filled
        self._rows = {x: i for i, x in enumerate(drives)}
        columns = run.along.rounded(drives)
        self._rounded = [_rounded(f, columns) for f in filled]

    def at(self, x: float) -> list[Size]:
        """Return the size of each column at one of the poses."""
        alone = cache(partial(self._run.along.rounding, x))
        known = zip(self._filled, self._rounded, strict=True)
        return [self._size(f, x, column, alone) for f, column in known]

    def _size(
        self, filled: Filled, x: float, column: Column | None, alone: Callable[[], Rounding]
    ) -> Size:
        number, formula, where = filled.at(x), filled.formula, filled.where
        if formula is None:
            return Size(number + 0.0)
        if math.isnan(number) and not filled.has_friction:
            return without_value(formula, where, alone())
        rounded = column.at(self._rows[x]) if column and math.isfinite(number) else None
        if rounded is not None:
            size = without_rounding(number, rounded)
        else:
            size = beyond_rounding(number, formula, where, alone())
        if filled.has_friction and is_on_a_side(size, where, alone()):
            return from_both_sides(filled.at, partial(_is_pose, self._run), x, self._run.range)
        return size


def _rounded(filled: Filled, columns: RoundedColumns) -> Column | None:
    """Return a column with its errors; None where it has no formula, or not in what has values."""
    if filled.formula is None:
        return None
    known = columns.with_definitions(filled.where)
    return known.of(filled.formula) if symbols(filled.formula) <= known.names else None


def _is_pose(run: Run, x: float) -> bool:
    return not run.along.trouble(x)
