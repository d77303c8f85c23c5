"""Values along the drive: parameters, what follows from them, results."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from functools import cached_property, partial
from typing import TypeVar

from ...algebra.product import Product
from ...formula.continuation import continued
from ...formula.roots import Function
from ...formula.rounded_columns import RoundedColumn, RoundedColumns
from ...formula.rounding import EPS, Rounded, Rounding
from ...formula.straight_line import in_order
from ...formula.tree import Formula, is_call
from ...formula.walk import symbols
from ...friction.at_rest import one_or_both
from ...kinematics.plan import Plan
from ...model.result import Definition, Result
from ...model.values import Chain, Values, defaults, dependent
from ..open_ranges import NOT_ASSEMBLED, why_open
from ..tolerances import SAME_SIDES, SIDE
from .forms import form, holding, together

EXCLUDED = "excluded by a condition of use"


T = TypeVar("T")

Senses = Callable[[float], Sequence[float]]
"""Returns the senses of slips at a value of the drive."""


def _keeping(value: Callable[[Values], T], at: Callable[[float], Values]) -> Callable[[float], T]:
    """Return a function of the drive, computed of its values there once each."""
    known: dict[float, T] = {}

    def function(x: float) -> T:
        if x not in known:
            known[x] = value(at(x))
        return known[x]

    return function


class Along:
    """Evaluates formulas at values of the drive, the other parameters at their defaults."""

    def __init__(self, plan: Plan, lets: Mapping[str, Formula], ends: Sequence[float] = ()) -> None:
        pose = plan.graph.pose
        self.mechanism = pose.mechanism
        assert pose.mechanism.drive is not None
        self._drive = pose.mechanism.drive.parameter
        self.defaults = defaults(pose.mechanism)
        self._given = {**dict.fromkeys(pose.placeholders, 1.0), **self.defaults}
        self._definitions = dict(pose.definitions)
        formulas = {**dependent(pose.mechanism), **self._definitions, **lets}
        self._chain = Chain(formulas, continued)
        bound = {name: value.formula() for name, value in plan.bindings}
        self._inner = Chain({**dict(pose.closing), **bound})
        self._default = self.defaults.get(self._drive, 0.0)
        fixed = {name: v for name, v in self._given.items() if name != self._drive}
        self._fixed = self._chain.complete(fixed)
        self._fixed_inside = self._inner.complete(self._fixed)
        self._near = 2 * EPS * max(map(abs, ends), default=0.0)
        self._step = SIDE * (max(ends, default=1.0) - min(ends, default=0.0))
        self._senses: dict[int, tuple[Sequence[Definition], Senses | None]] = {}
        self._known: dict[float, Values] = {}
        self._known_inside: dict[float, Values] = {}
        self._troubles: dict[float, str] = {}
        self._functions: dict[tuple[int, int], tuple[Formula, Result | None, Function]] = {}

    @property
    def closing(self) -> Iterable[str]:
        """The names of what is found by closing loops."""
        return self._definitions

    def given(self, x: float) -> Values:
        """Return the given values at a value of the drive."""
        return {**self._given, self._drive: x}

    @cached_property
    def _names(self) -> Set[str]:
        """Return the names that have values along the drive."""
        return self.values(self._default).keys()

    def values(self, x: float) -> Values:
        """Return the value of every name that has one, at a value of the drive."""
        if x not in self._known:
            self._known[x] = self._chain.complete({**self._fixed, self._drive: x})
        return self._known[x]

    def rounding(self, x: float) -> Rounding:
        """Return the values at one of the drive with what rounding makes of them.

        The drive itself is as near as the ends of the stroke and the steps between them are.
        """
        rounding = Rounding(self.given(x))
        rounding.values[self._drive] = Rounded(x, self._near)
        rounding.define(self._chain.definitions)
        rounding.define(self._inner.definitions)
        return rounding

    def rounded(self, drives: Sequence[float]) -> RoundedColumns:
        """Return the values at several of the drive at once, with what rounding makes of them."""
        rows = len(drives)
        given = {
            name: RoundedColumn([value] * rows, [EPS * abs(value)] * rows)
            for name, value in self._given.items()
        }
        given[self._drive] = RoundedColumn(drives, [self._near] * rows)
        named = RoundedColumns(given, rows).with_definitions(self._chain.definitions)
        return named.with_definitions(self._inner.definitions)

    def of(self, formula: Formula, where: Result | None, x: float) -> float:
        """Return a formula's value, with the definitions of a result; NaN where it has none.

        It has none either where a condition of the result is broken; where the result has a
        form for elsewhere, its value is that of the form that stands. Where a slip is 0 for once,
        it is the limit, or one of both where the result jumps.
        """
        return self.function(formula, where)(x)

    def function(self, formula: Formula, where: Result | None) -> Function:
        """Return a formula as a function of the drive, which keeps its values."""
        key = id(formula), id(where)
        if key not in self._functions:
            value = _keeping(form(formula, where, self._names), self.values)
            senses = self._senses_of(where.where) if where else None
            value = value if senses is None else partial(self._on_sides, value, senses)
            self._functions[key] = formula, where, value
        return self._functions[key][2]

    def _on_sides(self, value: Function, senses: Senses, x: float) -> float:
        """Return a value, the limit of it where a slip is 0 for once."""
        limits = [side for side in self._sides(value, senses, x) if math.isfinite(side)]
        return limits[0] if limits else value(x)

    def sides(self, value: Function, where: Sequence[Definition], x: float) -> Sequence[float]:
        """Return the limits of a result where a slip is 0 for once, one where they are alike.

        Friction has no sense there, and what is without it is the limit of neither side; NaN
        stands for one on which nothing balances. There are none where no slip is 0, or each is on
        both sides as well.
        """
        senses = self._senses_of(where)
        return () if senses is None else self._sides(value, senses, x)

    def _sides(self, value: Function, senses: Senses, x: float) -> Sequence[float]:
        rest = senses(x).count(0)
        if not rest:
            return ()
        steps = [s * self._step for s in (-1, 1)]
        moving = (step for step in steps if senses(x + step).count(0) < rest)
        away = [step for step in moving if not self.trouble(x + step)]
        limits = [2 * value(x + step) - value(x + 2 * step) for step in away]
        return one_or_both(limits, SAME_SIDES)

    def _senses_of(self, where: Sequence[Definition]) -> Senses | None:
        """Return the senses of slips in definitions as a function of the drive, if there are any.

        Those without a value along it are left out.
        """
        if id(where) not in self._senses:
            found = [d.formula for d in where if is_call(d.formula, "sense")]
            self._senses[id(where)] = where, self.signs(found, where) if found else None
        return self._senses[id(where)][1]

    def signs(
        self, formulas: Sequence[Formula], definitions: Sequence[tuple[str, Formula]]
    ) -> Callable[[float], Sequence[float]]:
        """Return signs as a function of the drive, those that have a value along it together."""
        new = [(name, formula) for name, formula in definitions if name not in self._names]
        known = self._names | {name for name, _ in new}
        found = [formula for formula in formulas if symbols(formula) <= known]
        return _keeping(together(found, self._names, new), self.values)

    def together(self, values: Sequence[Product]) -> list[Function]:
        """Return intermediate results of the compiler as functions that are evaluated together.

        But for rounding they have the values of :meth:`inside`.
        """
        names = self._inner.complete(self.values(self._default)).keys()
        formulas = [value.formula() for value in values]
        known = [formula for formula in formulas if symbols(formula) <= names]
        found = _keeping(together(known, names), self._inside)
        places = {id(formula): i for i, formula in enumerate(known)}

        def function(formula: Formula) -> Function:
            i = places.get(id(formula))
            return (lambda x: math.nan) if i is None else lambda x: found(x)[i]

        return [*map(function, formulas)]

    def inside(self, value: Product, x: float) -> float:
        """Return the value of something that the compiler found on its way, NaN at a pole."""
        try:
            return value.evaluate(self._inside(x))
        except (KeyError, ZeroDivisionError, ValueError, OverflowError):
            return math.nan

    def _inside(self, x: float) -> Values:
        """Return the values of names that the compiler found on its way, too."""
        if x not in self._known_inside:
            self._known_inside[x] = self._inner.complete({**self._fixed_inside, **self.values(x)})
        return self._known_inside[x]

    def trouble(self, x: float) -> str:
        """Return why there is no pose at a value of the drive, '' where there is one."""
        if x not in self._troubles:
            self._troubles[x] = self._trouble(self.values(x))
        return self._troubles[x]

    def _trouble(self, values: Values) -> str:
        if not all(map(math.isfinite, self._found(values))):
            return why_open(self._definitions, values) or NOT_ASSEMBLED
        return "" if self._is_allowed(values) else EXCLUDED

    @cached_property
    def _found(self) -> Callable[[Values], Sequence[float]]:
        """Return the function that takes what loops give from among values."""
        return in_order([name for name in self._definitions if name in self._names])

    @cached_property
    def _is_allowed(self) -> Callable[[Values], bool]:
        return holding(self.mechanism.requires, self._names)
