"""Results at given values: which values may be given, and what is kept for the next ones."""

import math
import warnings
from collections.abc import Iterable, Mapping, Set
from functools import cached_property
from typing import TYPE_CHECKING, Any

from .base.frozen import replace
from .compilation import Compilation
from .diagnostics import near_miss
from .formula.evaluate import evaluate
from .formula.to_text import text
from .formula.tree import Formula
from .formula.walk import symbols
from .model.formulas.parameters import in_si
from .model.mechanism import Mechanism
from .model.result import Definition, FrictionResult, Result
from .model.values import default_pose, dependent
from .units import ANGLE, Dimension

if TYPE_CHECKING:
    from .emit.python.evaluator import Evaluator
    from .routine.evaluate import OnArrays

KEPT_FUNCTIONS = 8
"""How many choices of loads given by hand functions are kept for."""


class Evaluation:
    """The results of a compilation at values in SI and radians, or in text with its unit.

    For arrays a result's function ``on_arrays`` is asked, where there is one.
    """

    def __init__(
        self, compilation: Compilation, on_arrays: "Mapping[str, OnArrays] | None"
    ) -> None:
        self._compilation, self._on_arrays = compilation, on_arrays
        self._evaluators: dict[frozenset[str], Evaluator] = {}

    @property
    def has_machine_code(self) -> bool:
        """Whether there are functions for arrays."""
        return self._on_arrays is not None

    @cached_property
    def defaults(self) -> Mapping[str, float]:
        """The parameters' values from the description."""
        return default_pose(self._compilation.mechanism)

    def results(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the results at values, which go before those of the description.

        TypeError for a name that no result depends on, or that follows from others.
        """
        values = self.in_si(values)
        for name in values.keys() & self._ranges.keys():
            _doubt(name, values[name], self._ranges[name])
        overridden = self._fixed_loads.intersection(values)
        evaluator = self._evaluator(overridden)
        self._refuse_strangers(values.keys() - overridden, evaluator.inputs)
        found = evaluator.values({**self.defaults, **values}, overridden)
        return {r.name: found[r.name] for r in self._compilation.found if r.name in found}

    def points(self, values: Mapping[str, Any]) -> tuple[dict[str, Any], Any]:
        """Return where points are and how links point at values, and the status.

        ValueError without a drive that moves points, TypeError for a name that is no input, or an
        input without a value.
        """
        from .routine.evaluate import pose

        routine = self._compilation.routine
        if routine.points is None:
            raise ValueError("there is no motion: expected a drive that moves points, found none")
        inputs = [i.name for i in routine.points.program.inputs]
        values = self.in_si(values)
        used = {i.name for f in routine.functions for i in f.inputs}
        self._refuse_strangers(values.keys(), used.union(inputs))
        given = {**self.defaults, **values}
        if missing := [name for name in inputs if name not in given]:
            raise TypeError(f"no value is given for {', '.join(missing)}")
        return pose(routine.points.program, given)

    def in_si(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return values with those in SI that are texts, or sequences of texts."""
        sizes = self._dimensions
        return {n: _in_si(n, v, sizes[n]) if n in sizes else v for n, v in values.items()}

    @cached_property
    def _ranges(self) -> dict[str, tuple[float, float]]:
        """The ranges of the parameters that are angles, in radians."""
        parameters = self._compilation.mechanism.parameters
        ranges = {p.name: p.range for p in parameters if p.dimension == ANGLE and p.range}
        return {n: (evaluate(r.low, {}), evaluate(r.high, {})) for n, r in ranges.items()}

    @cached_property
    def _dimensions(self) -> dict[str, Dimension]:
        """The dimension of each parameter and load."""
        mechanism = self._compilation.mechanism
        return {q.name: q.dimension for q in (*mechanism.parameters, *mechanism.loads)}

    @cached_property
    def _fixed_loads(self) -> frozenset[str]:
        """The loads whose size the description gives."""
        return given_loads(self._compilation.mechanism, self._compilation.found)

    def _evaluator(self, overridden: frozenset[str]) -> "Evaluator":
        """Return the evaluator in which these loads are inputs, though the description sizes them.

        A few of them are kept, each for the loads that were last given by hand.
        """
        found = self._evaluators.pop(overridden, None) or self._new_evaluator(overridden)
        self._evaluators[overridden] = found
        if len(self._evaluators) > KEPT_FUNCTIONS:
            del self._evaluators[next(iter(self._evaluators))]
        return found

    def _new_evaluator(self, overridden: frozenset[str]) -> "Evaluator":
        from .emit.python.evaluator import Evaluator

        if not overridden:
            return Evaluator(self._compilation.routine, self._on_arrays)
        pose, found = self._compilation.pose, self._compilation.found
        changed = freed(pose.mechanism, found, overridden)
        return Evaluator(self._compilation.routine_of(*changed))

    def _refuse_strangers(self, names: Set[str], inputs: Set[str]) -> None:
        """Raise TypeError for a name that is no input, with what it follows from."""
        known = inputs | self._fixed_loads
        for name in sorted(names - known):
            formula = self._followed.get(name)
            if formula is None:
                hint = near_miss(name, known) or f"they depend on {', '.join(sorted(known))}"
                raise TypeError(f"no result depends on {name!r}; {hint if known else 'on nothing'}")
            raise TypeError(
                f"{name!r} follows from the description: {name} = {text(formula)}; "
                f"give {', '.join(sorted(symbols(formula) & known)) or 'what it rests on'} instead"
            )

    @cached_property
    def _followed(self) -> dict[str, Formula]:
        """The formulas of the description: results, tied loads, parameters."""
        mechanism = self._compilation.mechanism
        ties = {load.name: load.tie for load in mechanism.loads if load.tie is not None}
        found = {r.name: r.formula for r in self._compilation.found}
        return {**found, **ties, **dependent(mechanism)}


def _doubt(name: str, value: Any, within: tuple[float, float]) -> None:
    """Warn of an angle beyond a turn that in degrees, and in no other turn, is within its range."""
    low, high = within
    if not isinstance(value, float | int) or abs(value) <= math.tau:
        return
    further_on = low + (value - low) % math.tau
    if further_on > high and low <= math.radians(value) <= high:
        warnings.warn(
            f"{name} = {value:g} is taken in radians, {value / math.tau:.3g} turns, which is "
            f"beyond its range: degrees are a text, {name}='{value:g} deg'",
            stacklevel=4,
        )


def _in_si(name: str, value: Any, dimension: Dimension) -> Any:
    """Return a value in SI where it is text, or has texts in it, else as it is."""
    if value is None:
        raise TypeError(f"{name} is None: without it the value of the description is taken")
    if isinstance(value, str):
        return in_si(name, value, dimension)
    if isinstance(value, list | tuple):
        return [_in_si(name, each, dimension) for each in value]
    return value


def given_loads(mechanism: Mechanism, results: Iterable[Result]) -> frozenset[str]:
    """Return the loads that results take from the description: weights, and those with a let."""
    loads = {load.name for load in mechanism.loads}
    asked = {r.name for r in results if r.target is not None}
    used = {d.name for r in results for d in r.where} | {let.name for let in mechanism.lets}
    return frozenset((loads & used) - asked)


def freed(
    mechanism: Mechanism, results: Iterable[Result], names: Set[str]
) -> tuple[Mechanism, tuple[Result, ...]]:
    """Return a mechanism and its results with loads of these names given by nothing."""
    loads = (replace(k, tie=None) if k.name in names else k for k in mechanism.loads)
    others = (r for r in results if r.name not in names)
    return replace(mechanism, loads=tuple(loads)), tuple(_freed(r, names) for r in others)


def _freed(result: Result, names: Set[str]) -> Result:
    where = _without(result.where, names)
    elsewhere = _freed(result.elsewhere, names) if result.elsewhere else None
    changed = replace(result, where=where, elsewhere=elsewhere)
    if not isinstance(changed, FrictionResult) or changed.case is None:
        return changed
    case = replace(changed.case, where=_without(changed.case.where, names))
    return replace(changed, case=case)


def _without(where: Iterable[Definition], names: Set[str]) -> tuple[Definition, ...]:
    return tuple(d for d in where if d.name not in names)
