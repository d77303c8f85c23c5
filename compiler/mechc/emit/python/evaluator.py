"""Results at given values, again and again: what is worked out beforehand for that."""

from collections.abc import Mapping, Set
from functools import cached_property
from typing import Any

from ...routine.evaluate import OnArrays, evaluate, scalar_or_array
from ...routine.steps import Function, Routine
from .one_pose import ERRORS, OnFloats, on_floats


class Evaluator:
    """The results of a routine: for one pose on floats, for many on arrays.

    For these the interpreter is asked where ``on_arrays`` has no function for a result.
    """

    def __init__(self, routine: Routine, on_arrays: Mapping[str, OnArrays] | None = None) -> None:
        others = on_arrays or {}
        self._parts = [_Part(function, others.get(function.name)) for function in routine.functions]
        self.inputs = frozenset(name for part in self._parts for name in part.inputs)

    def values(self, given: Mapping[str, Any], overridden: Set[str]) -> dict[str, Any]:
        """Return by name the results whose inputs are given, and the loads that go before them."""
        found = {p.name: p.value(given) for p in self._parts if given.keys() >= p.needed}
        if overridden:
            found |= {name: scalar_or_array(given[name]) for name in overridden}
        return found


class _Part:
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
