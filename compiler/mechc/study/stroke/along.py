"""Values along the drive: parameters, what follows from them, results."""

import math
from collections.abc import Iterable, Mapping, Sequence

from ...algebra.product import Product
from ...formula.continuation import continued
from ...formula.evaluate import status
from ...formula.rounded_columns import Column, RoundedColumns
from ...formula.rounding import EPS, Rounded, Rounding
from ...formula.tree import Formula, Implicit
from ...kinematics.plan import Plan
from ...model.result import Result
from ...model.values import Chain, Values, allowed, defaults, dependent
from .forms import Form, form

NOT_ASSEMBLED = "cannot be assembled"
NOT_FOUND = "iteration finds no pose"
NO_POSE = (NOT_ASSEMBLED, NOT_FOUND)
EXCLUDED = "excluded by a condition of use"


_Known = tuple[Formula, Result | None, Form, dict[float, float]]
"""What was asked for, which keeps its identity, its code, and its values along the drive."""


class Along:
    """Evaluates formulas at values of the drive, the other parameters at their defaults."""

    def __init__(self, plan: Plan, lets: Mapping[str, Formula], ends: Sequence[float] = ()) -> None:
        pose = plan.graph.pose
        self.mechanism = pose.mechanism
        assert pose.mechanism.drive is not None
        self._drive = pose.mechanism.drive.parameter
        self.defaults = defaults(pose.mechanism)
        self._definitions = dict(pose.definitions)
        formulas = {**dependent(pose.mechanism), **self._definitions, **lets}
        self._chain = Chain(formulas, continued)
        bound = {name: value.formula() for name, value in plan.bindings}
        self._inner = Chain({**dict(pose.closing), **bound})
        self._open = dict.fromkeys(pose.placeholders, 1.0)
        self._near = 2 * EPS * max(map(abs, ends), default=0.0)
        self._known: dict[float, Values] = {}
        self._known_inside: dict[float, Values] = {}
        self._troubles: dict[float, str] = {}
        self._forms: dict[tuple[int, int], _Known] = {}
        self._codes: dict[int, tuple[Product, Form]] = {}

    @property
    def closing(self) -> Iterable[str]:
        """The names of what is found by closing loops."""
        return self._definitions

    def given(self, x: float) -> Values:
        """Return the given values at a value of the drive."""
        return {**self._open, **self.defaults, self._drive: x}

    def values(self, x: float) -> Values:
        """Return the value of every name that has one, at a value of the drive."""
        if x not in self._known:
            self._known[x] = self._chain.complete(self.given(x))
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
        """Return the same at several values of the drive at once."""
        rows = len(drives)
        given = {
            name: Column([value] * rows, [EPS * abs(value)] * rows)
            for name, value in {**self._open, **self.defaults}.items()
        }
        given[self._drive] = Column(drives, [self._near] * rows)
        named = RoundedColumns(given, rows).with_definitions(self._chain.definitions)
        return named.with_definitions(self._inner.definitions)

    def of(self, formula: Formula, where: Result | None, x: float) -> float:
        """Return a formula's value, with the definitions of a result; NaN where it has none.

        It has none either where a condition of the result is broken; where the result has a
        form for elsewhere, its value is that of the form that stands.
        """
        values = self.values(x)
        key = id(formula), id(where)
        if key not in self._forms:
            self._forms[key] = formula, where, form(formula, where, values.keys()), {}
        _, _, value, known = self._forms[key]
        if x not in known:
            known[x] = value(values)
        return known[x]

    def inside(self, value: Product, x: float) -> float:
        """Return the value of something that the compiler found on its way, NaN at a pole."""
        try:
            return value.evaluate(self._inside(x))
        except (KeyError, ZeroDivisionError, ValueError, OverflowError):
            return math.nan

    def in_code(self, value: Product, x: float) -> float:
        """Return the same, but for rounding, from code that is made once for a whole stroke."""
        values = self._inside(x)
        if id(value) not in self._codes:
            self._codes[id(value)] = value, form(value.formula(), None, values.keys())
        return self._codes[id(value)][1](values)

    def _inside(self, x: float) -> Values:
        """Return the values of names that the compiler found on its way, too."""
        if x not in self._known_inside:
            self._known_inside[x] = self._inner.complete(self.values(x))
        return self._known_inside[x]

    def trouble(self, x: float) -> str:
        """Return why there is no pose at a value of the drive, '' where there is one."""
        if x not in self._troubles:
            self._troubles[x] = self._trouble(self.values(x))
        return self._troubles[x]

    def _trouble(self, values: Values) -> str:
        named = ((n, f) for n, f in self._definitions.items() if n in values)
        broken = next((f for n, f in named if not math.isfinite(values[n])), None)
        if isinstance(broken, Implicit) and status(broken, values) == 2:
            return NOT_FOUND
        if broken is not None:
            return NOT_ASSEMBLED
        return "" if allowed(self.mechanism, values) else EXCLUDED
