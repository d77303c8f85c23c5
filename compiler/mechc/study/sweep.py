"""Results along one parameter, and what of them is nothing but rounding."""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from ..formula.numeric.rounding import beyond_rounding
from ..formula.tree import Definitions, Formula, is_call
from ..formula.walk import symbols
from ..friction import at_rest
from ..model.result import Result
from ..model.values import PrintedForm, Values, of_sound_form, valid_form
from .pose_sweep import Functions, PoseCode, PoseSweep, keeping
from .tolerances import SAME_SIDES, SIDE

if TYPE_CHECKING:
    from ..formula.numeric.roots import RealFunction


class Sweep(PoseSweep):
    """Evaluates formulas of results in the poses along a parameter."""

    def __init__(
        self,
        code: PoseCode,
        parameter: str,
        ends: Sequence[float] = (),
        loads: Mapping[str, float] | None = None,
    ) -> None:
        """Take what a :class:`PoseSweep` takes.

        Functions are kept by the formula and the result that they are of, senses of slips by the
        definitions that they are in.
        """
        super().__init__(code, parameter, ends, loads)
        self._functions: dict[tuple[int, int], tuple[Formula, Result | None, RealFunction]] = {}
        self._senses: dict[int, tuple[Definitions, Functions | None]] = {}

    def of(self, formula: Formula, where: Result | None, x: float) -> float:
        """Return a formula's value, with the definitions of a result; NaN where it has none.

        It has none either where a condition of the result is broken; where the result has a
        form for elsewhere, its value is that of the form that stands. Where a slip is 0 for once,
        it is the limit, or one of both where the result jumps.
        """
        return self.function(formula, where)(x)

    def function(self, formula: Formula, where: Result | None) -> "RealFunction":
        """Return a formula as a function of the parameter, which keeps its values."""
        key = id(formula), id(where)
        if key not in self._functions:
            value = keeping(self.code.form(formula, where, self.names), self.values)
            senses = self._senses_of(where.where) if where else None
            value = value if senses is None else partial(self._on_sides, value, senses)
            self._functions[key] = formula, where, value
        return self._functions[key][2]

    def value_of(self, result: Result, x: float) -> float:
        """Return a result's value, NaN as well where there is no pose."""
        return math.nan if self.trouble(x) else self.of(result.formula, result, x)

    def named(self, result: Result, x: float) -> Values:
        """Return the values at ``x``, those of the names in a result among them."""
        return self.whole(result, x)[1]

    def whole(self, result: Result, x: float) -> tuple[float, Values]:
        """Return a result's value with those of :meth:`named`, each system solved once."""
        following, value = self.code.whole(result, self.names)
        values = following.complete(self.values(x))
        return math.nan if self.trouble(x) else value(values), values

    def functions(self, formulas: Sequence[Formula], definitions: Definitions) -> Functions:
        """Return formulas as one function of the parameter, those that have a value along it."""
        return keeping(self.code.forms(formulas, definitions, self.names), self.values)

    def _on_sides(self, value: "RealFunction", senses: Functions, x: float) -> float:
        """Return a value, the limit of it where a slip is 0 for once."""
        limits = [side for side in self._sides(value, senses, x) if math.isfinite(side)]
        return limits[0] if limits else value(x)

    def sides(self, value: "RealFunction", where: Definitions, x: float) -> Sequence[float]:
        """Return the limits of a result where a slip is 0 for once, one where they are alike.

        Friction has no sense there, and what is without it is the limit of neither side; NaN
        stands for one on which nothing balances. There are none where no slip is 0, or each is on
        both sides as well.
        """
        senses = self._senses_of(where)
        return () if senses is None else self._sides(value, senses, x)

    def _sides(self, value: "RealFunction", senses: Functions, x: float) -> Sequence[float]:
        steps = self._steps_off_rest(senses, x)
        limits = [2 * value(x + step) - value(x + 2 * step) for step in steps]
        return at_rest.one_or_both(limits, SAME_SIDES)

    def off_rest(self, where: Definitions, x: float) -> list[float]:
        """Return values next to one at which alone a slip is 0, none for any other value."""
        senses = self._senses_of(where)
        steps = () if senses is None else self._steps_off_rest(senses, x)
        return [x + step for step in steps]

    def _steps_off_rest(self, senses: Functions, x: float) -> Iterator[float]:
        """Yield the steps to poses at which a slip has a sense that has none at ``x``."""
        rest = senses(x).count(0)
        size = SIDE * (self.width or max(abs(x), 1.0))
        for step in (-size, size) if rest else ():
            if not self.trouble(x + step) and senses(x + step).count(0) < rest:
                yield step

    def _senses_of(self, where: Definitions) -> Functions | None:
        """Return the senses of slips in definitions as a function of the parameter, if any.

        Those without a value along it are NaN.
        """
        if id(where) not in self._senses:
            found = [d[1] for d in where if is_call(d[1], "sense")]
            self._senses[id(where)] = where, self.functions(found, where) if found else None
        return self._senses[id(where)][1]

    def beyond_rounding(
        self, result: Result, x: float, number: float | None = None
    ) -> float | None:
        """Return a result's value, ``number`` if that is known, without what is only rounding."""
        known = self.value_of(result, x) if number is None else number

        def look(at: Result) -> PrintedForm:
            form = self.form_at(at, x)
            value = known if at is result else self.of(at.formula, at, x)
            return PrintedForm(
                form, value, beyond_rounding(value, form.formula, form.where, rounding)
            )

        rounding = self.rounding(x)
        return of_sound_form(result, look).number

    def form_at(self, result: Result, x: float) -> Result:
        """Return the form of a result that has a value: the one for elsewhere, perhaps."""
        return valid_form(result, self.values(x)) or result if result.elsewhere else result

    def varying(self, result: Result) -> set[str]:
        """Return the parameter and the names that vary with it, those of a result among them."""
        formulas = {**dict(self.code.chain.definitions), **dict(result.where)}
        needed = {name: symbols(formula) for name, formula in formulas.items()}
        varying, before = {self.parameter}, 0
        while len(varying) > before:
            before = len(varying)
            varying |= {n for n, needs in needed.items() if not varying.isdisjoint(needs)}
        return varying
