"""Results at given values, again and again: on floats for one pose, on arrays for many.

For one pose arrays cost more than formulas, so functions on floats are made in memory.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Set
from functools import cached_property
from typing import Any

from ...formula.functions import FUNCTIONS
from ...routine.evaluate import OnArrays, evaluate, scalar_or_array
from ...routine.steps import Function, Routine, Solve, Step, names_of
from ..names import Reserved, TargetNames, mangle
from ..printer import Printer
from .printer import KEYWORDS

OnFloats = Callable[..., float]
ERRORS = (ArithmeticError, ValueError)
"""What such a function raises where NumPy has NaN or an infinity."""


class FloatPrinter(Printer):
    """Prints for floats; the functions that it calls begin with an underscore, as no name does."""

    pi = repr(math.pi)

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of one of the other functions."""
        return f"_{function}({', '.join(arguments)})"

    def power(self, base: str, exponent: str) -> str:
        """Return a call of ``math.pow``, which never is complex."""
        return f"_pow({base}, {exponent})"


def on_floats(function: Function) -> OnFloats | None:
    """Return a result as a function of floats in the order of its inputs; None where it iterates.

    It raises one of :data:`ERRORS` where a step has no finite value, and is NaN where a
    condition fails.
    """
    if function.common or any(isinstance(step, Solve) for step in function.steps):
        return None
    names = (*(i.name for i in function.inputs), *(n for s in function.steps for n in names_of(s)))
    printer = FloatPrinter(mangle(names, TargetNames(Reserved(KEYWORDS))))
    space = {f"_{name}": meaning for name, meaning in _BESIDE.items()}
    exec("\n".join(_lines(function, printer)), space)
    return space["_value"]


def _lines(function: Function, printer: FloatPrinter) -> Iterator[str]:
    yield f"def _value({', '.join(printer.names[i.name] for i in function.inputs)}):"
    for step in function.steps:
        assert isinstance(step, Step)
        yield f"    {printer.names[step.name]} = {printer.print(step.formula)}"
    for guard in function.guards:
        yield f"    if not {printer.condition(guard)}: return _nan()"
    yield f"    return {printer.print(function.output)}"


def _sign(x: float) -> float:
    return 1.0 if x > 0 else -1.0 if x < 0 else x


def _min(x: float, y: float) -> float:
    return x if x < y or x != x else y


def _max(x: float, y: float) -> float:
    return x if x > y or x != x else y


_BESIDE: Mapping[str, OnFloats] = {
    **FUNCTIONS,
    "pow": math.pow,
    "sign": _sign,
    "min": _min,
    "max": _max,
    "nan": lambda: math.nan,
}
"""What a function calls; signs, and what is less or more, keep NaN as arrays do."""


class Evaluator:
    """The results of a routine: for one pose on floats, for many on arrays.

    For these the interpreter is asked where ``on_arrays`` has no function for a result.
    """

    def __init__(self, routine: Routine, on_arrays: Mapping[str, OnArrays] | None = None) -> None:
        others = on_arrays or {}
        self._parts = [
            _EvaluatedFunction(function, others.get(function.name))
            for function in routine.functions
        ]
        self.inputs = frozenset(name for part in self._parts for name in part.inputs)

    def values(self, given: Mapping[str, Any], overridden: Set[str]) -> dict[str, Any]:
        """Return by name the results whose inputs are given, and the loads that go before them."""
        found = {p.name: p.value(given) for p in self._parts if given.keys() >= p.needed}
        if overridden:
            found |= {name: scalar_or_array(given[name]) for name in overridden}
        return found


class _EvaluatedFunction:
    """One function; it is made for floats when it is first asked for."""

    def __init__(self, function: Function, on_arrays: OnArrays | None) -> None:
        self._function, self._on_arrays = function, on_arrays
        self.name = function.name
        self.inputs = tuple(i.name for i in function.inputs)
        self.needed = frozenset(self.inputs)

    @cached_property
    def _on_floats(self) -> OnFloats | None:
        return on_floats(self._function)

    def value(self, given: Mapping[str, Any]) -> Any:
        values = [given[name] for name in self.inputs]
        found = self._at_one_pose(values)
        if found is not None:
            return found
        return self._on_arrays(*values) if self._on_arrays else evaluate(self._function, given)

    def _at_one_pose(self, values: list[Any]) -> float | None:
        """Return the value for floats; None where only arrays can give it."""
        if self._on_floats is None or not all(isinstance(v, float | int) for v in values):
            return None
        try:
            found = self._on_floats(*map(float, values))
        except ERRORS:
            return None
        return None if found != found and self._function.otherwise else found
