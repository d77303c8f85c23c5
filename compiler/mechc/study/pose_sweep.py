"""Poses along one parameter: the values of all names at each of its values, the others stand.

A drive on its stroke and a parameter in its range are looked at in this one way.
"""

import math
from collections.abc import Callable, Mapping, Sequence, Set
from functools import cached_property, partial
from typing import TYPE_CHECKING, TypeVar

from ..algebra.product import Product
from ..formula.evaluate import status
from ..formula.numeric import continuation, rounded_columns
from ..formula.numeric.rounding import EPS, Rounded, Rounding
from ..formula.numeric.straight_line import SystemSolver, in_order
from ..formula.tree import Definitions, Formula, Implicit, System
from ..kinematics.plan import Plan
from ..model.result import Result
from ..model.values import Chain, Completion, Values, defaults, following, user_defined
from .forms import SOON, FormulaCode, FormulaCodes, code_of_all, form, holding

if TYPE_CHECKING:
    from ..formula.numeric.roots import RealFunction
    from ..formula.numeric.rounded_columns import RoundedColumns

NOT_ASSEMBLED = "cannot be assembled"
NOT_FOUND = "iteration finds no pose"
NOT_REACHED = "no pose is reached from the default one"
NO_POSE = (NOT_ASSEMBLED, NOT_REACHED, NOT_FOUND)
"""From what is most surely known to what is least."""

EXCLUDED = "excluded by a condition of use"

RANGE_HALVINGS = 40
"""After so many nothing is left of a range that is shown."""

T = TypeVar("T")

Functions = Callable[[float], Sequence[float]]
"""Returns several values at a value of the parameter."""


class PoseCode:
    """The formulas of a pose and of results as code, the same whatever parameter varies.

    ``given`` are the values that do not follow from others; lengths that nobody gives are 1.
    """

    def __init__(self, plan: Plan) -> None:
        pose = plan.graph.pose
        self.mechanism = pose.mechanism
        self.defaults = defaults(pose.mechanism)
        self.given = {**dict.fromkeys(pose.placeholders, 1.0), **self.defaults}
        self.closing = dict(pose.definitions)
        formulas = {**self.closing, **user_defined(pose.mechanism)}
        self.chain = following(pose.mechanism, formulas.items(), _continued)
        self._plan = plan
        self._forms: dict[
            tuple[int, int, Set[str]], tuple[Formula, Result | None, FormulaCode]
        ] = {}
        self._codes: dict[
            tuple[tuple[int, ...], int, Set[str]], tuple[object, object, FormulaCodes]
        ] = {}
        self._chains: dict[int, tuple[Result, Chain]] = {}

    @cached_property
    def inner(self) -> Chain:
        """Return the formulas of what the compiler found on its way."""
        bound = {name: value.formula() for name, value in self._plan.bindings}
        return Chain({**dict(self._plan.graph.pose.closing), **bound})

    def form(self, formula: Formula, where: Result | None, names: Set[str]) -> FormulaCode:
        """Return a formula of a result in names that have values."""
        key = id(formula), id(where), names
        if key not in self._forms:
            self._forms[key] = formula, where, form(formula, where, names)
        return self._forms[key][2]

    def forms(
        self, formulas: Sequence[Formula], definitions: Definitions, names: Set[str]
    ) -> FormulaCodes:
        """Return formulas with definitions as one code, in names that have values."""
        key = tuple(map(id, formulas)), id(definitions), names
        if key not in self._codes:
            code = code_of_all(formulas, names, definitions)
            self._codes[key] = formulas, definitions, code
        return self._codes[key][2]

    def whole(self, result: Result, names: frozenset[str]) -> tuple[Completion, FormulaCode]:
        """Return the definitions of a result in names that have values, and its value in both."""
        key = id(result)
        if key not in self._chains:
            self._chains[key] = result, Chain(dict(result.where))
        following = self._chains[key][1].completion(names, SOON)
        return following, self.form(result.formula, result, names.union(following.names))


class PoseSweep:
    """Poses at values of a ``parameter``, the others at their defaults.

    ``loads`` are sizes of loads that nobody gives; ``ends`` are those of what is looked at.
    """

    def __init__(
        self,
        code: PoseCode,
        parameter: str,
        ends: Sequence[float] = (),
        loads: Mapping[str, float] | None = None,
    ) -> None:
        self.mechanism, self.parameter = code.mechanism, parameter
        self.code, self._given = code, {**(loads or {}), **code.given}
        fixed = {name: v for name, v in self._given.items() if name != parameter}
        self._fixed = code.chain.complete(fixed)
        names = frozenset((*self._fixed, parameter))
        self._following = code.chain.completion(names, SOON)
        self.names = names.union(self._following.names)
        self.width = max(ends, default=0.0) - min(ends, default=0.0)
        self._near = 2 * EPS * max(map(abs, ends), default=0.0)
        self._known: dict[float, Values] = {}
        self._known_inside: dict[float, Values] = {}
        self._troubles: dict[float, str] = {}

    @property
    def defaults(self) -> Values:
        """The values that the user gave."""
        return self.code.defaults

    @property
    def default(self) -> float:
        """Return the parameter's own value; any value where it is none of the mechanism."""
        return self._given.get(self.parameter, 0.0)

    @property
    def closing(self) -> Set[str]:
        """The names of what is found by closing loops."""
        return self.code.closing.keys()

    def given(self, x: float) -> Values:
        """Return the given values at a value of the parameter."""
        return {**self._given, self.parameter: x}

    def values(self, x: float) -> Values:
        """Return the value of every name that has one, at a value of the parameter."""
        if x not in self._known:
            self._known[x] = self._following.complete({**self._fixed, self.parameter: x})
        return self._known[x]

    def trouble(self, x: float) -> str:
        """Return why there is no pose at a value of the parameter, '' where there is one."""
        if x not in self._troubles:
            self._troubles[x] = self._trouble(self.values(x))
        return self._troubles[x]

    def _trouble(self, values: Values) -> str:
        if not all(map(math.isfinite, self._found(values))):
            return why_open(self.code.closing, values) or NOT_ASSEMBLED
        return "" if self._is_allowed(values) else EXCLUDED

    def is_allowed(self, x: float) -> bool:
        """Return whether the conditions of use hold at a value of the parameter."""
        return self._is_allowed(self.values(x))

    @cached_property
    def _found(self) -> Callable[[Values], Sequence[float]]:
        """Return the function that takes what loops give from among values."""
        return in_order([name for name in self.code.closing if name in self.names])

    @cached_property
    def _is_allowed(self) -> Callable[[Values], bool]:
        return holding(self.mechanism.requires, self.names)

    def rounding(self, x: float) -> Rounding:
        """Return the values at one of the parameter with what rounding makes of them.

        The parameter itself is as near as the ends and the steps between them are.
        """
        rounding = Rounding(self.given(x))
        rounding.values[self.parameter] = Rounded(x, max(self._near, EPS * abs(x)))
        rounding.define(self.code.chain.definitions)
        return rounding

    def rounding_inside(self, x: float) -> Rounding:
        """Return the values of :meth:`rounding`, with those that the compiler found on its way."""
        rounding = self.rounding(x)
        rounding.define(self.code.inner.definitions)
        return rounding

    def rounded(self, places: Sequence[float]) -> "RoundedColumns":
        """Return the values of :meth:`rounding_inside` at several of the parameter at once."""
        rows = len(places)
        given = {
            name: rounded_columns.RoundedColumn([value] * rows, [EPS * abs(value)] * rows)
            for name, value in self._given.items()
        }
        given[self.parameter] = rounded_columns.RoundedColumn(places, [self._near] * rows)
        named = rounded_columns.RoundedColumns(given, rows).with_definitions(
            self.code.chain.definitions
        )
        return named.with_definitions(self.code.inner.definitions)

    def inside_together(self, values: Sequence[Product]) -> list["RealFunction"]:
        """Return intermediate results of the compiler as functions that are evaluated together.

        But for rounding they have the values of :meth:`inside`.
        """
        names = self.code.inner.complete(self.values(self.default)).keys()
        formulas = [value.formula() for value in values]
        found = keeping(code_of_all(formulas, names), self._inside)
        return [partial(_taken, found, i) for i in range(len(formulas))]

    def inside(self, value: Product, x: float) -> float:
        """Return the value of something that the compiler found on its way, NaN at a pole."""
        try:
            return value.evaluate(self._inside(x))
        except (KeyError, ZeroDivisionError, ValueError, OverflowError):
            return math.nan

    def _inside(self, x: float) -> Values:
        """Return the values of names that the compiler found on its way, too."""
        if x not in self._known_inside:
            values = {**self._fixed_inside, **self.values(x)}
            self._known_inside[x] = self.code.inner.complete(values)
        return self._known_inside[x]

    @cached_property
    def _fixed_inside(self) -> Values:
        return self.code.inner.complete(self._fixed)


def why_open(definitions: Mapping[str, Formula], values: Values) -> str:
    """Return why what loops define has no value, "" where all of it has one.

    Of the closures of a system one is followed, to its end: what rests on it may have a value
    in another one.
    """
    named = [(n, f) for n, f in definitions.items() if n in values]
    last = next((i for i, (n, _) in enumerate(named) if not math.isfinite(values[n])), None)
    if last is None:
        return ""
    broken = named[last][1]
    if isinstance(broken, Implicit) and status(broken, values) == 2:
        return NOT_FOUND
    is_followed = any(isinstance(f, Implicit) for _, f in named[: last + 1])
    return NOT_REACHED if is_followed else NOT_ASSEMBLED


def last_that(meets: Callable[[float], bool], good: float, bad: float) -> float:
    """Return the last value that meets something between one that does and one that does not."""
    for _ in range(RANGE_HALVINGS):
        middle = (good + bad) / 2
        if meets(middle):
            good = middle
        else:
            bad = middle
    return good


def _continued(system: System) -> SystemSolver:
    """Return a system's unknowns; most poses have no systems."""
    return continuation.continued(system)


def keeping(value: Callable[[Values], T], at: Callable[[float], Values]) -> Callable[[float], T]:
    """Return a function of the parameter, computed of its values there once each."""
    known: dict[float, T] = {}

    def function(x: float) -> T:
        if x not in known:
            known[x] = value(at(x))
        return known[x]

    return function


def _taken(found: Functions, i: int, x: float) -> float:
    return found(x)[i]
