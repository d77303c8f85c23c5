"""Values at many poses with bounds of their rounding errors: :mod:`.rounding`, column by column.

An operation runs over a whole column of poses, in which nothing is asked of a single one. Where
it meets what is zero, infinite or undetermined the value of that pose is NaN, and so is what rests
on it: there a :class:`~.rounding.Rounding` of the one pose knows more. Elsewhere values and errors
are the same to the last bit.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import partial

from ...base.named import NamedTuple
from ..choices import chosen
from ..evaluate import solution
from ..functions import FUNCTIONS
from ..tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
)
from ..walk import symbols
from .rounding import BY_SINES, EPS, SOLVED, Rounded, called, multiplied, powered, summed

SMOOTH = frozenset({"sin", "cos", "asin", "acos", "atan", "sqrt", "abs", "exp", "log"})
"""Functions of one argument whose value is NaN where that is."""

NOTHING, ONE = Rounded(math.nan, 0.0), Rounded(1.0, 0.0)

NO_VALUE = (ZeroDivisionError, ValueError, OverflowError)


class RoundedColumn(NamedTuple):
    """The values of one quantity at all poses, and what rounding may have made of each at most."""

    values: Sequence[float]
    errors: Sequence[float]

    def at(self, row: int) -> Rounded | None:
        """Return the value at a pose; None where it must be looked at alone."""
        value = self.values[row]
        return None if math.isnan(value) else Rounded(value, self.errors[row])


Pairs = tuple[Sequence[float], Sequence[float]]
"""Values, and their errors."""

WholeColumns = Callable[[Sequence[RoundedColumn]], Pairs]
"""Makes values and errors of columns; raises where a value is not defined at each pose."""


class ColumnOperation(NamedTuple):
    """What makes a column of others under a name, by its ``whole`` or only at ``one`` pose each."""

    name: object
    whole: WholeColumns | None
    one: Callable[[Sequence[Rounded]], Rounded]


class RoundedColumns:
    """Formulas at many poses; what several share is found once.

    >>> from ..tree import product
    >>> x = RoundedColumns({"x": RoundedColumn([2.0, 0.0], [0.0, 0.0])}, 2)
    >>> inverse = x.of(product([(Symbol("x"), -1)]))
    >>> inverse.at(0).value, inverse.at(1)
    (0.5, None)
    """

    def __init__(self, given: Mapping[str, RoundedColumn], rows: int) -> None:
        """Take what has a name, each as a column of so many rows."""
        self._named, self._rows = dict(given), rows
        self._known: dict[int, tuple[Formula, RoundedColumn]] = {}
        self._constants: dict[Rounded, RoundedColumn] = {}
        self._made: dict[tuple[object, ...], tuple[Sequence[RoundedColumn], RoundedColumn]] = {}
        self._solved: dict[tuple[int, ...], tuple[System, list[tuple[float, ...]]]] = {}

    @property
    def names(self) -> Set[str]:
        """Return the names that have columns."""
        return self._named.keys()

    def with_definitions(self, definitions: Iterable[tuple[str, Formula]]) -> "RoundedColumns":
        """Return these columns with what definitions in order say, as far as it has values."""
        new = [d for d in definitions if d[0] not in self._named]
        if not new:
            return self
        inner = RoundedColumns(self._named, self._rows)
        inner._constants, inner._made, inner._solved = self._constants, self._made, self._solved
        for name, formula in new:
            if name not in inner._named and symbols(formula) <= inner._named.keys():
                inner._named[name] = inner.of(formula)
        return inner

    def of(self, formula: Formula) -> RoundedColumn:
        """Return a formula's column."""
        if isinstance(formula, Symbol) and not isinstance(formula, Constant):
            return self._named[formula.name]
        known = self._known.get(id(formula))
        if known is None:
            known = self._known[id(formula)] = formula, self._column(formula)
        return known[1]

    def _column(self, formula: Formula) -> RoundedColumn:
        """Return a column from those of the parts, one for each kind of node."""
        match formula:
            case Number(value):
                number = value.numerator / value.denominator
                return self._constant(Rounded(number, EPS / 2 * abs(number)))
            case Pi():
                return self._constant(Rounded(math.pi, EPS * math.pi))
            case Constant(_, known):
                return self.of(known)
            case Sum(terms):
                return self._made_of(SUM, [*map(self.of, terms)])
            case Product(factors):
                return self._made_of(PRODUCT, [*map(self.of, factors)])
            case Power(base, Number(exponent)):
                number = exponent.numerator / exponent.denominator
                return self._made_of(_to_the(number, EPS / 2 * abs(number)), [self.of(base)])
            case Power(base, exponent):
                return self._made_of(POWER, [self.of(base), self.of(exponent)])
            case Call(function, arguments):
                return self._call(function, [*map(self.of, arguments)])
            case Implicit():
                return self._unknown(formula)
            case _:
                return self.of(formula)

    def _constant(self, number: Rounded) -> RoundedColumn:
        if number not in self._constants:
            columns = [number.value] * self._rows, [number.error] * self._rows
            self._constants[number] = RoundedColumn(*columns)
        return self._constants[number]

    def _made_of(
        self, operation: ColumnOperation, columns: Sequence[RoundedColumn]
    ) -> RoundedColumn:
        """Return the column that an operation makes of others; each is made once."""
        key = operation.name, *map(id, columns)
        if key not in self._made:
            self._made[key] = columns, _carried_out(operation, columns)
        return self._made[key][1]

    def _call(self, function: str, columns: Sequence[RoundedColumn]) -> RoundedColumn:
        if function in BY_SINES:
            above, below = (
                self._call(f, columns) if f else self._constant(ONE) for f in BY_SINES[function]
            )
            return self._made_of(PRODUCT, [above, self._made_of(_to_the(-1.0, 0.0), [below])])
        return self._made_of(_function(function), columns)

    def _unknown(self, formula: Implicit) -> RoundedColumn:
        columns = [*map(self.of, formula.arguments)]
        key = id(formula.system), *map(id, columns)
        if key not in self._solved:
            self._solved[key] = formula.system, _solutions(formula.system, columns, self._rows)
        found = [unknowns[formula.index] for unknowns in self._solved[key][1]]
        return RoundedColumn(found, [SOLVED * max(1.0, abs(number)) for number in found])


def _carried_out(operation: ColumnOperation, columns: Sequence[RoundedColumn]) -> RoundedColumn:
    """Return an operation on whole columns; pose by pose where it is not defined in all."""
    if operation.whole is None:
        return _pose_by_pose(operation, columns)
    try:
        values, errors = operation.whole(columns)
    except NO_VALUE:
        return _pose_by_pose(operation, columns)
    if all(map(math.isfinite, values)):
        return RoundedColumn(values, errors)
    return RoundedColumn([v if math.isfinite(v) else math.nan for v in values], errors)


def _pose_by_pose(operation: ColumnOperation, columns: Sequence[RoundedColumn]) -> RoundedColumn:
    parts = [[*map(Rounded, column.values, column.errors)] for column in columns]
    found = [_at_one(operation, at_one) for at_one in zip(*parts, strict=True)]
    return RoundedColumn([f.value for f in found], [f.error for f in found])


def _at_one(operation: ColumnOperation, parts: Sequence[Rounded]) -> Rounded:
    if any(math.isnan(part.value) for part in parts):
        return NOTHING
    try:
        found = operation.one(parts)
    except NO_VALUE:
        return NOTHING
    return found if math.isfinite(found.value) else NOTHING


# ------------------------------------------------------------------------- operations


def _sum(columns: Sequence[RoundedColumn]) -> Pairs:
    values = [*map(math.fsum, zip(*(c.values for c in columns), strict=True))]
    errors = map(math.fsum, zip(*(c.errors for c in columns), strict=True))
    return values, [e + EPS * abs(v) for e, v in zip(errors, values, strict=True)]


def _product(columns: Sequence[RoundedColumn]) -> Pairs:
    """Return the products of the rows of columns, and what rounding makes of them."""
    values, errors = columns[0]
    errors = [e + EPS * abs(v) for v, e in zip(values, errors, strict=True)]
    for column in columns[1:]:
        parts = [*zip(values, errors, *column, strict=True)]
        values = [value * size for value, _, size, _ in parts]
        errors = [
            abs(value) * lost + abs(size) * error + error * lost + EPS * abs(made)
            for (value, error, size, lost), made in zip(parts, values, strict=True)
        ]
    return values, errors


def _powers(columns: Sequence[RoundedColumn], exponent: Rounded) -> Pairs:
    """Return powers of what is not zero, but for rounding."""
    (bases, errors), (power, lost) = columns[0], exponent
    is_whole = power.is_integer()
    values = [
        base**power if error < (abs(base) if is_whole else base) < math.inf else math.nan
        for base, error in zip(bases, errors, strict=True)
    ]
    steep = abs(power)
    moved = [
        math.nan if v != v else abs(v) * (steep * e / abs(b) + (abs(math.log(abs(b))) * lost + EPS))
        for v, b, e in zip(values, bases, errors, strict=True)
    ]
    return values, moved


def _moved(function: Callable[[float], float], columns: Sequence[RoundedColumn]) -> Pairs:
    """Return a function of one column, and how far it moves where that does."""
    sizes, errors = columns[0]
    values = [*map(function, sizes)]
    moved = [
        EPS * abs(v) + max(abs(function(x + e) - v), abs(function(x - e) - v))
        for x, e, v in zip(sizes, errors, values, strict=True)
    ]
    return values, moved


def _to_the(exponent: float, error: float) -> ColumnOperation:
    """Return a power that is the same at all poses."""
    size = Rounded(exponent, error)
    return ColumnOperation(
        size, partial(_powers, exponent=size), lambda base: powered(base[0], size)
    )


def _function(name: str) -> ColumnOperation:
    whole = partial(_moved, FUNCTIONS[name]) if name in SMOOTH else None
    return ColumnOperation(name, whole, CHOICES.get(name, partial(called, name)))


def _chosen(parts: Sequence[Rounded]) -> Rounded:
    part = chosen(parts, lambda p: p.value)
    return NOTHING if part is None else part


def _next(parts: Sequence[Rounded]) -> Rounded:
    least, *sizes = parts
    return next((size for size in sizes if least.value <= size.value), NOTHING)


SUM = ColumnOperation("+", _sum, summed)
PRODUCT = ColumnOperation("*", _product, multiplied)
POWER = ColumnOperation("^", None, lambda pair: powered(*pair))
CHOICES = {"choose": _chosen, "next": _next}


def _solutions(
    system: System, columns: Sequence[RoundedColumn], rows: int
) -> list[tuple[float, ...]]:
    """Return the unknowns of a system at all poses, found once for all of them."""
    unknown = (math.nan,) * len(system.unknowns)
    places = zip(*(c.values for c in columns), strict=True) if columns else [()] * rows
    return [unknown if any(map(math.isnan, p)) else solution(system, p) for p in places]
