"""Values with a bound of their rounding errors: what is smaller than that is zero.

The bound runs through a formula as the value does, by what each operation makes of the
errors of its parts, to first order. cos 90° is 6e-17 and its error 2e-16: it is 0. What is
divided by such a zero is infinite, and undetermined where it is such a zero itself.
"""

import math
from collections.abc import Iterable, Mapping, Sequence

from ...base.named import NamedTuple
from ..choices import chosen
from ..evaluate import solution
from ..functions import FUNCTIONS
from ..tree import Call, Constant, Formula, Implicit, Number, Pi, Power, Product, Sum, Symbol
from ..walk import symbols

EPS = 2.0**-52
"""What one operation on doubles is off by at most, against its result: twice half a last place."""

SOLVED = 64 * EPS
"""The error of what Newton's method gives, against its size or 1."""


class Rounded(NamedTuple):
    """A value, and what rounding may have made of it at most."""

    value: float
    error: float

    @property
    def is_zero(self) -> bool:
        """Return whether nothing is left of the value but rounding."""
        return abs(self.value) <= self.error < math.inf

    @property
    def is_infinite(self) -> bool:
        """Return whether something that is not zero was divided by what is."""
        return math.isinf(self.value)

    @property
    def is_undetermined(self) -> bool:
        """Return whether it is 0/0, but for rounding."""
        return math.isnan(self.value) and math.isinf(self.error)


INFINITE = Rounded(math.inf, math.inf)
"""A pole; its sign is not known."""


class Rounding:
    """Formulas with the errors of their values; what several share is found once.

    Names may be added to ``values`` later on, but not change.

    >>> from ..tree import degrees
    >>> [Rounding({}).of(Call("cos", (degrees(x),))).is_zero for x in (90, 89)]
    [True, False]
    """

    def __init__(self, given: Mapping[str, float]) -> None:
        """Take values that were given, as near as floats come to them."""
        self.values = {name: Rounded(v, EPS * abs(v)) for name, v in given.items()}
        self._known: dict[int, Rounded] = {}
        self._alive: list[Formula] = []

    def of(self, formula: Formula) -> Rounded:
        """Return the value of a formula with its error.

        Infinite where what is zero is divided by, NaN where it has no value: with no bound at all
        where it is 0/0.
        """
        self._alive.append(formula)
        try:
            return self._of(formula)
        except ZeroDivisionError:
            return Rounded(math.nan, math.inf)
        except (ValueError, OverflowError):
            return Rounded(math.nan, 0.0)

    def define(self, definitions: Iterable[tuple[str, Formula]]) -> None:
        """Add what definitions in order say, as far as their names have values."""
        for name, formula in definitions:
            if name not in self.values and symbols(formula) <= self.values.keys():
                self.values[name] = self.of(formula)

    def _of(self, formula: Formula) -> Rounded:
        if isinstance(formula, Symbol) and not isinstance(formula, Constant):
            return self.values[formula.name]
        known = self._known.get(id(formula))
        if known is None:
            known = self._known[id(formula)] = self._compute(formula)
        return known

    def _compute(self, formula: Formula) -> Rounded:
        """Return a value with its bound from those of the parts, one for each kind of node."""
        match formula:
            case Product(factors):
                return multiplied(map(self._of, factors))
            case Sum(terms):
                return summed(map(self._of, terms))
            case Power(base, exponent):
                return powered(self._of(base), self._of(exponent))
            case Number(value):
                number = value.numerator / value.denominator
                return Rounded(number, EPS / 2 * abs(number))
            case Constant(_, known):
                return self._of(known)
            case Pi():
                return Rounded(math.pi, EPS * math.pi)
            case Call("choose", arguments):
                part = chosen(arguments, lambda p: self._of(p).value)
                return Rounded(math.nan, 0.0) if part is None else self._of(part)
            case Call("next", (least, *sizes)):
                wanted, listed = self._of(least).value, map(self._of, sizes)
                return next((size for size in listed if wanted <= size.value), Rounded(math.nan, 0))
            case Call(function, arguments):
                return called(function, [*map(self._of, arguments)])
            case Implicit(system, index, arguments):
                number = solution(system, tuple(self._of(a).value for a in arguments))[index]
                return Rounded(number, SOLVED * max(1.0, abs(number)))
            case _:
                return self._of(formula)


class PrintedNumber(NamedTuple):
    """A number as it may be printed: None where it is none, ``undetermined`` where it is 0/0."""

    number: float | None
    undetermined: bool = False


def beyond_rounding(
    number: float | None,
    formula: Formula | None,
    where: Iterable[tuple[str, Formula]],
    rounding: Rounding,
) -> PrintedNumber:
    """Return the number that a formula came to, without what is nothing but rounding.

    It is 0, infinite or undetermined where it is so but for rounding, and never -0. Of a
    number without a formula no more is known than that.
    """
    if number is None or not math.isfinite(number):
        return PrintedNumber(number)
    if formula is None:
        return PrintedNumber(number + 0.0)
    return without_rounding(number, with_error(formula, where, rounding))


def without_rounding(number: float, size: Rounded) -> PrintedNumber:
    """Return a finite number as what its formula is but for rounding."""
    if size.is_undetermined:
        return PrintedNumber(None, undetermined=True)
    if size.is_infinite:
        return PrintedNumber(math.inf)
    return PrintedNumber(0.0 if size.is_zero or number == 0 else number)


def without_value(
    formula: Formula, where: Iterable[tuple[str, Formula]], rounding: Rounding
) -> PrintedNumber:
    """Return the size of a formula whose value is NaN: infinite, 0/0, or unknown."""
    size = with_error(formula, where, rounding)
    if size.is_infinite:
        return PrintedNumber(math.inf)
    return PrintedNumber(None if size.is_undetermined else math.nan, size.is_undetermined)


def with_error(
    formula: Formula, where: Iterable[tuple[str, Formula]], rounding: Rounding
) -> Rounded:
    """Return the value of a formula with its error, after the definitions that it rests on."""
    new = [definition for definition in where if definition[0] not in rounding.values]
    if not new:
        return rounding.of(formula)
    inner = Rounding({})
    inner.values.update(rounding.values)
    inner.define(new)
    return inner.of(formula)


def summed(terms: Iterable[Rounded]) -> Rounded:
    """Return a sum with its error."""
    values, errors = zip(*terms, strict=True)
    if poles := values.count(math.inf) + values.count(-math.inf):
        if poles > 1:
            raise ZeroDivisionError
        return INFINITE
    value = math.fsum(values)
    return Rounded(value, math.fsum(errors) + EPS * abs(value))


def multiplied(factors: Iterable[Rounded]) -> Rounded:
    """Return a product with its error."""
    parts = list(factors)
    value, error = 1.0, 0.0
    for size, lost in parts:
        if math.isinf(size):
            if any(part.is_zero for part in parts):
                raise ZeroDivisionError
            return INFINITE
        error = abs(value) * lost + abs(size) * error + error * lost
        value *= size
        error += EPS * abs(value)
    return Rounded(value, error)


def powered(base: Rounded, exponent: Rounded) -> Rounded:
    """Return a power with its error."""
    if base.is_infinite:
        return INFINITE if exponent.value > 0 else Rounded(0.0, 0.0)
    if exponent.value < 0 and base.is_zero:
        return INFINITE
    value = base.value**exponent.value
    if not isinstance(value, float):
        raise ValueError
    if base.value == 0:
        return Rounded(value, base.error**exponent.value)
    relative = abs(exponent.value) * base.error / abs(base.value)
    relative += abs(math.log(abs(base.value))) * exponent.error + EPS
    if base.is_zero:
        return Rounded(value, max(abs(value) * relative, (2 * base.error) ** exponent.value))
    return Rounded(value, abs(value) * relative)


BY_SINES = {"tan": ("sin", "cos"), "cot": ("cos", "sin"), "sec": ("", "cos"), "csc": ("", "sin")}
"""Functions with poles as quotients."""


def called(function: str, arguments: Sequence[Rounded]) -> Rounded:
    """Return a call; its error is how far its value moves where its arguments do."""
    if any(argument.is_infinite for argument in arguments):
        if function in ("abs", "hypot", "sqrt"):
            return INFINITE
        raise ZeroDivisionError
    if function in BY_SINES:
        above, below = (
            called(f, arguments) if f else Rounded(1.0, 0.0) for f in BY_SINES[function]
        )
        return multiplied([above, powered(below, Rounded(-1.0, 0.0))])
    if function == "atan2" and all(argument.is_zero for argument in arguments):
        raise ZeroDivisionError
    return _with_moved_arguments(function, arguments)


def _with_moved_arguments(function: str, arguments: Sequence[Rounded]) -> Rounded:
    """Return a function's value; its error is how far it goes as each argument has its own error.

    Raises ValueError where it has no value.
    """
    here = [argument.value for argument in arguments]
    value = _called(function, here)
    if not math.isfinite(value):
        raise ValueError
    error = EPS * abs(value)
    for i, argument in enumerate(arguments):
        moved = [
            _called(function, [*here[:i], argument.value + step, *here[i + 1 :]])
            for step in (argument.error, -argument.error)
        ]
        away = (_apart(function, m, value) for m in moved if math.isfinite(m))
        error += max(away, default=math.inf)
    return Rounded(value, error)


def _called(function: str, arguments: list[float]) -> float:
    """Return the value of a function, NaN where it has none."""
    try:
        return FUNCTIONS[function](*arguments)
    except (ZeroDivisionError, ValueError, OverflowError):
        return math.nan


def _apart(function: str, one: float, other: float) -> float:
    """Return how far two values of a function are apart: of directions, the shorter way round."""
    gap = abs(one - other)
    return min(gap, abs(2 * math.pi - gap)) if function == "atan2" else gap
