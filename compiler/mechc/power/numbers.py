"""The results at the default pose: signs, zeros, poles, branch points."""

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property

from ..algebra.factors import Factor, Trig
from ..algebra.matrices import numeric_rank
from ..algebra.product import Product, Sum
from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics import power as messages
from ..formula.evaluate import SharedEvaluation
from ..formula.numeric.rounding import PrintedNumber, Rounding, beyond_rounding, without_value
from ..formula.to_text import text
from ..formula.tree import ZERO, Formula, is_call
from ..formula.walk import symbols
from ..kinematics.plan import Block, Plan
from ..model.mechanism import Contact, Find, Force, LoadForm, LoadRatio
from ..model.result import Result
from ..model.values import (
    Chain,
    PrintedForm,
    ValuedForm,
    completed,
    defaults,
    dependent,
    of_sound_form,
    range_of,
    user_defined,
    valued_form,
)
from ..pose.pose import Pose
from .balance import AlgebraicResult, Balance
from .tolerances import VANISHED

STROKE_PARTS = 24
"""Parts of the stroke at whose ends the sign of a result is looked at."""


class DefaultNumbers:
    """The results' numbers at the default pose, without what is nothing but rounding."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan

    @property
    def pose(self) -> Pose:
        """The pose."""
        return self._plan.graph.pose

    @cached_property
    def values(self) -> dict[str, float]:
        """The values of parameters, intermediates and bound sums."""
        return self._chain.complete(self._given)

    @cached_property
    def _rounding(self) -> Rounding:
        """The same values, with what rounding makes of them."""
        rounding = Rounding(self._given)
        rounding.define(self._chain.definitions)
        return rounding

    @cached_property
    def _chain(self) -> Chain:
        return _chain(self._plan.graph.pose)

    @cached_property
    def _given(self) -> dict[str, float]:
        return _given(self._plan.graph.pose)

    @cached_property
    def _chained(self) -> "_Chained":
        return _Chained(self.values, self._rounding)

    def has_given(self, result: Result) -> bool:
        """Return whether no formula of the user's that a result mentions is NaN there."""
        formulas = (result.formula, *(d.formula for d in result.where))
        own = {p.name for p in self._plan.graph.pose.mechanism.parameters if p.dependent}
        mentioned = own & symbols(*formulas)
        return not any(math.isnan(self.values.get(name, 0.0)) for name in mentioned)

    def of(self, result: Result) -> PrintedNumber:
        """Return the value of a result there; no number where something it needs has none.

        NaN that no condition makes is 0/0 or a pole. What has conditions may have a form for
        elsewhere, in which names mean something else: it shares none of them.
        """
        return of_sound_form(result, self._printed_form)

    def _printed_form(self, result: Result) -> PrintedForm:
        """Return the form of a result that stands at the default pose, with its number."""
        is_shared = not result.guards and self._chained.takes(result.where)
        values = self._chained.values if is_shared else self.values
        rounding = self._chained.rounding if is_shared else self._rounding
        form, number = form_of(result, values)
        if number is not None and math.isnan(number) and not result.guards:
            nowhere = without_value(result.formula, result.where, rounding)
            return PrintedForm(result, number, nowhere)
        if number is not None and math.isnan(number) and is_call(form.formula, "atan2"):
            return PrintedForm(form, number, PrintedNumber(None, undetermined=True))
        return PrintedForm(
            form, number, beyond_rounding(number, form.formula, form.where, rounding)
        )


class _Chained:
    """The values of definitions that results share: formulas of the user's own rest on others.

    Each is found once, so that a long chain of them does not take the square of its length.
    """

    def __init__(self, values: Mapping[str, float], rounding: Rounding) -> None:
        self.values, self.rounding = dict(values), Rounding({})
        self.rounding.values.update(rounding.values)
        self._evaluation = SharedEvaluation(self.values)
        self._formulas: dict[str, Formula] = {}

    def takes(self, where: Sequence[tuple[str, Formula]]) -> bool:
        """Add definitions in order; return whether each has one meaning in all that was added."""
        if any(self._formulas.get(name, formula) is not formula for name, formula in where):
            return False
        for name, formula in where:
            if name not in self.values and symbols(formula) <= self.values.keys():
                self.values[name] = self._evaluation.of(formula)
            self._formulas[name] = formula
        self.rounding.define(where)
        return True


def with_default(result: Result, size: PrintedNumber) -> Result:
    """Return a result with its value at the default pose, if it has a finite one."""
    finite = size.number is not None and math.isfinite(size.number)
    default = size.number if finite else None
    return replace(result, default=default, undetermined=size.undetermined)


def checked(
    balance: Balance, numbers: DefaultNumbers, report: Report
) -> tuple[AlgebraicResult, ...]:
    """Return the results with their default values; report what is not regular there."""
    is_branch = _check_branch(balance, numbers.values, report)
    finds = {f.name: f for f in balance.plan.graph.pose.mechanism.finds}
    solved: list[AlgebraicResult] = []
    arrows, is_at_rest = Arrows(balance, report), _are_at_rest(balance, numbers.values)
    for item in balance.solved:
        size = numbers.of(item.result)
        if is_at_rest and isinstance(item.result.target, LoadRatio):
            size = PrintedNumber(None, undetermined=True)
        if size.number is not None and not is_branch:
            find = finds[item.result.name]
            _remark(item, size.number, numbers.values, find, arrows, report)
        solved.append(replace(item, result=with_default(item.result, size)))
    return tuple(solved)


def default_values(plan: Plan) -> dict[str, float]:
    """Return the values of parameters, intermediates, and bound sums at the default pose."""
    return pose_values(plan.graph.pose)


def pose_values(pose: Pose) -> dict[str, float]:
    """Return the values that a pose has by default."""
    return _chain(pose).complete(_given(pose))


def values_along(pose: Pose, name: str, step: float) -> dict[str, float]:
    """Return the values of a pose at which a parameter is a step farther on than by default."""
    given = _given(pose)
    return _chain(pose).complete({**given, name: given.get(name, 0.0) + step})


def values_near_default(pose: Pose, step: float) -> dict[str, float]:
    """Return the values of a pose whose angles are up to a step farther on than by default.

    Each is by another part of it, so that no difference of two stays what it is.
    """
    given, angles = _given(pose), sorted(pose.mechanism.angles)
    parts = {name: (2 + math.sin(i)) / 3 for i, name in enumerate(angles)}
    moved = {name: x + step * parts[name] for name, x in given.items() if name in parts}
    return _chain(pose).complete({**given, **moved})


def _chain(pose: Pose) -> Chain:
    """Return the definitions on the parameters; a load may rest on user-defined formulas."""
    own = user_defined(pose.mechanism)
    return Chain({**own, **dependent(pose.mechanism), **dict(pose.definitions)})


def _given(pose: Pose) -> dict[str, float]:
    return {**defaults(pose.mechanism), **dict.fromkeys(pose.placeholders, 1.0)}


OTHER_POWERS = (1.013, 0.971)
"""By what parameters are changed to see whether a result stays zero, each by another power."""


def is_zero(result: Result, pose: Pose) -> bool:
    """Return whether a form of loads is zero by default and stays so with other parameters.

    The formula of a brake's moment may be 0, or a sum of coordinates that is no other number.
    """
    if result.formula != ZERO and (result.default or not isinstance(result.target, LoadForm)):
        return False
    return is_zero_everywhere(result.formula, result.where, pose)


def is_zero_everywhere(formula: Formula, where: Iterable[tuple[str, Formula]], pose: Pose) -> bool:
    """Return whether a formula is zero by default and stays so with other parameters and loads."""
    if formula == ZERO:
        return True
    loads = {load.name: 1.0 for load in pose.mechanism.loads}
    given, chain = {**loads, **_given(pose)}, (*_chain(pose).definitions, *where)
    return all(_is_zero_at(formula, chain, given, ratio) for ratio in (1.0, *OTHER_POWERS))


def _is_zero_at(
    formula: Formula,
    where: Iterable[tuple[str, Formula]],
    given: Mapping[str, float],
    ratio: float,
) -> bool:
    """Return whether a formula is zero at sizes changed each by another power of a ratio."""
    changed = {n: size * ratio ** (1 + i / 7) for i, (n, size) in enumerate(given.items())}
    rounding = Rounding(changed)
    rounding.define(where)
    return symbols(formula) <= rounding.values.keys() and rounding.of(formula).is_zero


def value_of(result: Result, values: Mapping[str, float]) -> float | None:
    """Return a result at given values; None where something it needs has none.

    NaN where a condition of the result is broken, and it has no form for elsewhere.
    """
    return form_of(result, values).value


def form_of(result: Result, values: Mapping[str, float]) -> ValuedForm:
    """Return the form of a result that stands at given values, itself where none does.

    With it comes the value of the result there, as :func:`value_of` has it.
    """
    found = valued_form(result, values)
    if found and found.form is result:
        return found
    known = completed(values, (d for d in result.where if d.name not in values))
    form, value = found or (result, math.nan)
    return ValuedForm(form, value if symbols(result.formula) <= known.keys() else None)


def _check_branch(balance: Balance, values: Mapping[str, float], report: Report) -> bool:
    """Return whether the pose is a branch point, and report it.

    There the relations have a lower rank than in general, and no speed is determined.

    Where every block of the plan has its full rank, so have all relations together; only
    if one has not is the whole looked at, which is dear. Where the whole has its full rank all the
    same, what speeds are given by may stand still; a load whose speed is finite then does no work.
    """
    plan = balance.plan
    try:
        rows = [{u: _unrounded(p, values) for u, p in r.form.items()} for r in plan.relations]
    except (KeyError, ZeroDivisionError):
        return False
    if all(_is_regular(block, rows) for block in plan.blocks):
        return False
    mechanism, rank = plan.graph.pose.mechanism, numeric_rank(rows)
    if rank < len(rows):
        report.add(messages.branch_point(mechanism.span, [k.name for k in mechanism.links]))
    elif numeric_rank([*rows, *({d: 1.0} for d in plan.drives)]) == rank:
        speeds = [s for term in balance.terms for s in term.speed]
        if speeds and all(_is_finite(s, values) for s in speeds):
            report.add(messages.loads_stand_still(mechanism.span))
    return rank < len(rows)


def _are_at_rest(balance: Balance, values: Mapping[str, float]) -> bool:
    """Return whether no load does work in the only motion there is, and all of them next to it.

    Joints alone balance any load there, whatever is left where what vanishes is cancelled.
    """
    columns = balance.equations.columns.values()
    powers = [power for column in columns for power in column]
    return len(powers) == len(columns) > 1 and all(
        power and _vanishing(power, values, 1) is not None for power in powers
    )


def _unrounded(value: Product, values: Mapping[str, float]) -> float:
    """Return the value of a product, 0 where a factor is zero: rounding would have a rank."""
    return 0.0 if _vanishing(value, values, 1) is not None else value.evaluate(values)


def _is_finite(speed: Product, values: Mapping[str, float]) -> bool:
    try:
        return abs(speed.evaluate(values)) < 1 / VANISHED
    except (KeyError, ZeroDivisionError):
        return False


def _is_regular(block: Block, rows: Sequence[Mapping[int, float]]) -> bool:
    """Return whether a block's unknowns follow from its relations, against the rows' size."""
    scales = [max(map(abs, rows[r].values())) or 1.0 for r in block.relations]
    inner = [
        {u: rows[r].get(u, 0.0) / scale for u in block.unknowns}
        for r, scale in zip(block.relations, scales, strict=True)
    ]
    return numeric_rank(inner, scaled=False) == len(inner)


def _remark(
    item: AlgebraicResult,
    number: float,
    values: Mapping[str, float],
    find: Find,
    arrows: "Arrows",
    report: Report,
) -> None:
    """Warn of a result that is infinite, zero or negative at the default pose."""
    factor = _vanishing(item.value, values, -1) if item.value else None
    if factor is not None or not math.isfinite(number):
        report.add(messages.pole_at_default(find.span, find.name, text(factor) if factor else ""))
    elif isinstance(find.target, LoadRatio):
        vanishes = item.value and _vanishing(item.value, values, 1) is not None
        if (number == 0 or vanishes) and find.target.below not in arrows.idle:
            report.add(messages.result_zero(find.span, find.name))
        elif number < 0:
            arrows.remark(find, find.target, item.result)


class Arrows:
    """Which arrows point the wrong way; of those of several ratios it is said once.

    ``idle`` are the loads that do no work in any motion: a ratio to one is zero for that reason.
    """

    def __init__(self, balance: Balance, report: Report) -> None:
        self.idle = balance.equations.idle_loads
        self._pose = balance.plan.graph.pose
        self._loads = {t.load.name: t.load for t in balance.terms}
        self._report, self._reported = report, set[str]()

    def remark(self, find: Find, target: LoadRatio, result: Result) -> None:
        """Warn of a ratio that is negative, where an arrow can be turned for it to be positive.

        A couple is negative where it acts clockwise, a pair of forces where it pulls, and
        along some strokes a ratio changes its sign: then no arrow is wrong. With friction such
        a load is driven back where it is said to move along its arrow.
        """
        asked = [self._loads[n] for n in (target.below, target.above) if n in self._loads]
        if self._reported & {k.name for k in asked} or self._is_positive_somewhere(result):
            return
        self._reported |= {k.name for k in asked}
        friction = self._pose.mechanism.friction
        if all(isinstance(load, Force) for load in asked):
            forces = [k.name for k in asked if isinstance(k, Force) and not k.weight]
            hint = messages.turn_round(forces, bool(self._pose.mechanism.each(Contact)))
            self._report.add(messages.result_negative(find.span, find.name, hint))
        elif not friction.is_ideal and friction.sense == "tightening":
            drive = target.above
            turned = [k.name for k in asked if isinstance(k, Force) and not k.weight]
            self._report.add(messages.drive_is_back_driven(find.span, find.name, drive, turned))

    def _is_positive_somewhere(self, result: Result) -> bool:
        """Return whether a result that is negative by default is positive along the stroke."""
        drive = self._pose.mechanism.drive
        if drive is None or not (ends := range_of(drive.parameter, self._pose.mechanism)):
            return False
        chain, given, (low, high) = _chain(self._pose), _given(self._pose), ends
        along = (low + (high - low) * i / STROKE_PARTS for i in range(STROKE_PARTS + 1))
        poses = (chain.complete({**given, drive.parameter: x}) for x in along)
        return any((value_of(result, values) or 0.0) > 0 for values in poses)


def _vanishing(value: Product, values: Mapping[str, float], side: int) -> Formula | None:
    """Return the factor above (1) or below (-1) the line that is zero against its terms."""
    try:
        for factor in (f for f, exponent in value.factors.items() if exponent * side > 0):
            if abs(factor.evaluate(values)) < VANISHED * _size(factor, values):
                return factor.formula()
    except (KeyError, ZeroDivisionError):
        return None
    return None


def _size(factor: Factor, values: Mapping[str, float]) -> float:
    """Return the scale of a factor's value; 0 for a mere length."""
    if isinstance(factor, Sum):
        return sum(abs(t.evaluate(values)) for t in factor.terms)
    return 1.0 if isinstance(factor, Trig) else 0.0
