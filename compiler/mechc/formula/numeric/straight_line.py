"""Formulas that are evaluated again and again, put in order once as straight-line code.

Parts that are equal are computed once, whatever formulas they stand in. The values are
those of :class:`~..evaluate.SharedEvaluation` to the last bit, in a tenth of the time; code that is
used often is compiled to one function of Python, in which only numbers of places and
constants stand, and takes a third of that.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from operator import itemgetter
from typing import Any, assert_never

from ...work import spend
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

SystemSolver = Callable[[tuple[float, ...]], tuple[float, ...]]
"""Returns the unknowns of a system at values of its outer symbols."""

FloatProgram = Callable[[Sequence[float]], list[float]]
"""Returns the values of formulas at values of what has a name."""

Operation = Callable[[Any], Any]
"""Takes one value, or several as a tuple."""

OPERATIONS_A_STEP = 8
"""So many operations on floats take as long as one step of algebra."""

OFTEN = 64
"""What is computed so often is compiled."""

NESTED = 32
"""Python reads products of more factors than this more slowly than they are computed."""

UNDEFINED = (ZeroDivisionError, ValueError, OverflowError, TypeError)
"""Raised where a function has no value, or by None for an argument that has none."""


def in_order(names: Sequence[str]) -> Callable[[Mapping[str, float]], Sequence[float]]:
    """Return the function that takes values of names, in this order, from among others.

    >>> in_order(["b", "a"])({"a": 1.0, "b": 2.0, "c": 3.0})
    (2.0, 1.0)
    """
    if len(names) > 1:
        return itemgetter(*names)
    return lambda values: [values[name] for name in names]


class StraightLine:
    """Formulas in ``names`` as operations in order, each on values that are there by then.

    ``definitions`` give names to more of them, in order; what has no value is NaN there.

    >>> x, y, z = map(Symbol, "xyz")
    >>> inverse = Power(z, Number(-1))
    >>> code = StraightLine([inverse, z], ["x", "y"], lambda system: None, [("z", Sum((x, y)))])
    >>> code.at([1.0, 3.0]), code.at([1.0, -1.0])
    ([0.25, 4.0], [nan, 0.0])
    """

    def __init__(
        self,
        formulas: Sequence[Formula],
        names: Sequence[str],
        solution: Callable[[System], SystemSolver],
        definitions: Iterable[tuple[str, Formula]] = (),
        often: int = OFTEN,
    ) -> None:
        """Take what is computed, to be compiled when it has been computed ``often``."""
        maker = _ProgramMaker(names, solution)
        for name, formula in definitions:
            maker.define(name, formula)
        results = [maker.value(formula) for formula in formulas]
        self._given = len(names)
        self._constants, self._made = maker.in_order()
        self._steps = [(value.operation, value.arguments) for value in self._made]
        self._results = [result.index for result in results]
        self._work = 1 + len(self._steps) // OPERATIONS_A_STEP
        self._left = often
        self._function: FloatProgram = self._step_by_step

    def at(self, values: Sequence[float]) -> list[float]:
        """Return the values of the formulas; NaN where a function is not defined there."""
        spend(self._work)
        if self._left:
            self._left -= 1
            if not self._left:
                self._function = _compiled(self._given, self._constants, self._made, self._results)
        try:
            return self._function(values)
        except UNDEFINED:
            return self._step_by_step(values)

    def _step_by_step(self, values: Sequence[float]) -> list[float]:
        """Return the values of the formulas where some of the operations have none."""
        found: list[Any] = [*values, *self._constants]
        keep, steps = found.append, iter(self._steps)
        while True:
            try:
                for operation, arguments in steps:
                    keep(operation(arguments(found)))
            except UNDEFINED:  # the loop goes on behind the operation that has no value
                keep(None)
            else:
                return [math.nan if (v := found[i]) is None else v for i in self._results]


class _Value:
    """What is given, a constant or what is made, at a place among all values."""

    def __init__(self, index: int) -> None:
        self.index = index


class _Made(_Value):
    """What an operation makes of other values."""

    def __init__(self, operation: Operation, *on: _Value) -> None:
        super().__init__(0)
        self.operation, self.on = operation, on

    @property
    def arguments(self) -> Operation:
        """Return the getter of the arguments from all values: one as it is, several as a tuple."""
        return itemgetter(*(value.index for value in self.on))


class _ProgramMaker:
    """Gathers operations, each after those it needs, none twice."""

    def __init__(self, names: Sequence[str], solution: Callable[[System], SystemSolver]) -> None:
        self._solution = solution
        self._first = len(names)
        self._named = dict[str, _Value]((n, _Value(i)) for i, n in enumerate(names))
        self._constants: dict[float, _Value] = {}
        self._made: dict[tuple[object, ...], _Made] = {}
        self._solutions: dict[int, Operation] = {}
        self._known: dict[int, _Value] = {}

    def value(self, formula: Formula) -> _Value:
        """Return the value of a formula, after all that it needs."""
        known = self._known.get(id(formula))
        if known is None:
            known = self._known[id(formula)] = self._value(formula)
        return known

    def define(self, name: str, formula: Formula) -> None:
        """Give the value of a formula a name."""
        value = self.value(formula)
        key = (_or_nan, value)
        self._named[name] = self._made.setdefault(key, _Made(_or_nan, value))

    def in_order(self) -> tuple[list[float], list[_Made]]:
        """Return the constants, and what operations make of them.

        They come in this order, behind what is given.
        """
        unnamed = (*self._constants.values(), *self._made.values())
        for index, value in enumerate(unnamed, self._first):
            value.index = index
        return list(self._constants), list(self._made.values())

    def _value(self, formula: Formula) -> _Value:
        """Return a formula as a value of the straight line; what it is made of comes before it."""
        match formula:
            case Constant(_, number):
                return self.value(number)
            case Number(number):
                return self._constant(number.numerator / number.denominator)
            case Symbol(name):
                return self._named[name]
            case Pi():
                return self._constant(math.pi)
            case Sum(parts):
                return self._operation(math.fsum, parts)
            case Product(parts):
                return self._operation(math.prod, parts)
            case Power(base, exponent):
                return self._operation(_power, (base, exponent))
            case Call(function, parts):
                operation = FUNCTIONS[function] if len(parts) == 1 else SEVERAL[function]
                return self._operation(operation, parts)
            case Implicit(system, index, parts):
                unknowns = self._operation(self._solved(system), parts)
                key = (index, unknowns)
                return self._made.setdefault(key, _Made(itemgetter(index), unknowns))
            case _:
                assert_never(formula)

    def _constant(self, value: float) -> _Value:
        return self._constants.setdefault(value, _Value(0))

    def _operation(self, operation: Operation, parts: Sequence[Formula]) -> _Value:
        on = tuple(map(self.value, parts))
        return self._made.setdefault((operation, *on), _Made(operation, *on))

    def _solved(self, system: System) -> Operation:
        if id(system) not in self._solutions:
            self._solutions[id(system)] = partial(_unknowns, self._solution(system))
        return self._solutions[id(system)]


def _compiled(
    given: int, constants: Sequence[float], made: Sequence[_Made], results: Sequence[int]
) -> FloatProgram:
    """Return operations as one function, which raises where one of them has no value."""
    names = [f"v{i}" for i in range(given)] + [f"({constant!r})" for constant in constants]
    operations: dict[str, Operation] = {}
    lines = ["def at(values):", f" [{', '.join(names[:given])}] = values"]
    for value in made:
        called = f"f{value.index}"
        operations[called] = OF_SEVERAL.get(value.operation, value.operation)
        lines.append(f" v{value.index} = {_written(value, called, names)}")
        names.append(f"v{value.index}")
    lines.append(f" return [{', '.join(names[i] for i in results)}]")
    exec("\n".join(lines), operations)
    return operations["at"]


def _written(value: _Made, called: str, names: Sequence[str]) -> str:
    """Return an operation as Python: products and whole powers are its own."""
    arguments = [names[on.index] for on in value.on]
    if value.operation is math.prod and len(arguments) <= NESTED:
        return "*".join(arguments)
    if value.operation is _power and _is_whole(arguments[1]):
        return "**".join(arguments)
    if value.operation is _or_nan:
        return arguments[0]
    joined = ", ".join(arguments)
    is_plain = len(arguments) == 1 or value.operation in OF_SEVERAL
    return f"{called}({joined})" if is_plain else f"{called}(({joined}))"


def _is_whole(exponent: str) -> bool:
    """Return whether this is a whole number: to its power no negative number is complex."""
    return exponent.endswith(".0)")


def _power(pair: tuple[float, float]) -> float:
    result = pair[0] ** pair[1]
    return result if isinstance(result, float) else math.nan


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value


def _unknowns(solution: SystemSolver, outer: tuple[float, ...] | float) -> tuple[float, ...]:
    """Return the unknowns of a system; of one argument no tuple is made."""
    values = outer if isinstance(outer, tuple) else (outer,)
    if None in values:
        raise ValueError("an argument without a value")
    return solution(values)


def _on_several(function: Callable[..., float]) -> Operation:
    return lambda arguments: function(*arguments)


SEVERAL = {name: _on_several(function) for name, function in FUNCTIONS.items()}
"""The functions as operations on a tuple."""

OF_SEVERAL: Mapping[Operation, Callable[..., float]] = {
    operation: FUNCTIONS[name] for name, operation in SEVERAL.items()
}
"""The functions by these operations."""
