"""Friction: from the balance without it to everything that was asked for."""

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, assert_never

from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics import friction as messages
from ..diagnostics import power as power_messages
from ..formula.numeric.rounding import PrintedNumber
from ..formula.tree import ZERO, Formula, Symbol
from ..model.mechanism import (
    Axial,
    Efficiency,
    Find,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    WithFriction,
)
from ..model.parts.friction import RopeFriction
from ..model.parts.targets import SIGNS, ResultTarget
from ..model.result import Result
from ..model.results.conditions_of_use import refuse_failing
from ..power.balance import AlgebraicResult, Balance
from ..power.definitions import let_results, open_lengths
from ..power.numbers import DefaultNumbers, value_of, with_default
from ..power.remarks import warn_of_idle_loads
from . import at_rest, results
from . import problem as problems
from .solution import FrictionSolution, SolvedWithFriction

if TYPE_CHECKING:
    from .problem import FrictionProblem


LARGEST_MULTIPLE = 100.0
"""How often friction may multiply the load without it, where that is nothing but rounding."""


def solve(balance: Balance, report: Report) -> FrictionSolution:
    """Return the results without friction, with it, and the user's own formulas of them.

    Reports what friction leaves undetermined (E510 … E514), a length that it needs (E506),
    a drive that jams at the default pose (W513), too many formulas of the user's (E831).
    """
    numbers = DefaultNumbers(balance.plan)
    with_friction = {s.result.name: s for s in _with_friction(balance, numbers, report)}
    report.stop_on_errors()
    known = {s.result.name: s for s in balance.solved} | with_friction
    finds = balance.plan.graph.pose.mechanism.finds
    solved = [known[find.name] for find in finds if find.name in known]
    lets = let_results(balance.plan.graph.pose, [s.result for s in solved], report)
    solved += [AlgebraicResult(with_default(let, numbers.of(let))) for let in lets]
    results = [s.result for s in solved]
    _refuse_undefined(results, balance, numbers, report)
    if balance.plan.graph.pose.mechanism.friction.joints:
        warn_of_idle_loads(balance, results, report)
    return FrictionSolution(balance, tuple(solved))


def _refuse_undefined(
    results: Sequence[Result], balance: Balance, numbers: DefaultNumbers, report: Report
) -> None:
    """Report tables, lists and choices that have no value at the pose and results by default."""
    if implied := balance.plan.graph.pose.mechanism.implied:
        known = {r.name: r.default for r in results if r.default is not None}
        refuse_failing(implied, {**numbers.values, **known}, report)


def _with_friction(
    balance: Balance, numbers: DefaultNumbers, report: Report
) -> Iterator[SolvedWithFriction]:
    """Yield the solutions with friction; few descriptions ask for any."""
    finds = balance.plan.graph.pose.mechanism.finds
    asked = [f for f in finds if isinstance(f.target, WithFriction | Efficiency)]
    if not asked:
        return
    problem = problems.FrictionProblem(balance, report)
    ideal = {r.target: r for r in balance.results}
    joints = problem.mechanism.friction.joints
    grips = bool(joints) and all(isinstance(joint, RopeFriction) for joint in joints)
    answered: list[tuple[Find, SolvedWithFriction, Result]] = []
    for find in asked:
        assert isinstance(find.target, WithFriction | Efficiency)
        without = ideal[find.target.of]
        if (found := _answer(problem, find, find.target, without)) is not None:
            _check_lengths(find, found.result, balance, report)
            answered.append((find, found, without))
    by_target: dict[ResultTarget | None, Result] = {f.target: s.result for f, s, _ in answered}
    for find, found, without in answered:
        back = by_target.get(_driven_back(find.target))
        result = _with_default(find, found.result, back, without, numbers, grips, report)
        yield replace(found, result=result)


def _driven_back(target: ResultTarget) -> ResultTarget | None:
    """Return the result of the motion against the arrow, for that of one along it; else None."""
    is_along = isinstance(target, WithFriction) and target.sense == "tightening"
    return replace(target, sense="releasing") if is_along else None


def _answer(
    problem: "FrictionProblem", find: Find, target: WithFriction | Efficiency, ideal: Result
) -> SolvedWithFriction | None:
    """Return the result with friction; None where an error was reported, or there is none."""
    if isinstance(target, Efficiency):
        return results.efficiency(problem, find, ideal, target)
    sense, order = target.sense, target.order
    match target.of:
        case LoadRatio() | LoadForm() as of:
            return results.load_with_friction(problem, find, ideal, of, sense, order)
        case Reaction() | Axial() | Normal() as force:
            return results.force_with_friction(problem, find, ideal, force, sense)
        case _:
            assert_never(target.of)


def _check_lengths(find: Find, result: Result, balance: Balance, report: Report) -> None:
    if missing := open_lengths(balance.plan, (result.formula, *(d.formula for d in result.where))):
        report.add_first(power_messages.length_not_given(find.span, find.name, missing))


def _with_default(
    find: Find,
    result: Result,
    back: Result | None,
    ideal: Result,
    numbers: DefaultNumbers,
    grips: bool,
    report: Report,
) -> Result:
    """Return a result with its value at the default pose; warn where the drive jams there.

    It may be driven ``back`` by the other load all the same. It ``grips`` where nothing but ropes
    has friction. Where a coefficient has no value nothing is said of that. Where the result
    without friction is 0/0 no slip has a direction, and this one has no value either. Where a slip
    is 0 for once it has the limit of both sides, or jumps.
    """
    if ideal.undetermined:
        return with_default(result, PrintedNumber(None, undetermined=True))
    size = numbers.of(result)
    if sides := at_rest.sides(result, numbers.pose, size.number):
        default = sides[0] if len(sides) == 1 else None
        return replace(result, default=default, sides=sides)
    if isinstance(find.target, Efficiency) and ideal.default == 0:
        size = _of_nothing(size, result, ideal, numbers)
    elif isinstance(find.target, WithFriction) and _is_rounding(size.number, ideal, numbers):
        size = PrintedNumber(0.0)
    if _jams(find, size.number, ideal.default) and numbers.has_given(result):
        idle = _below(find) if ideal.formula == ZERO else ""
        is_driven = back is not None and _moves(back, ideal, numbers)
        drive = _drive(find)
        message = messages.drive_jams(find.span, find.name, drive, grips, is_driven, idle)
        report.add_first(message)
        size = PrintedNumber(None)
    return with_default(result, size)


def _of_nothing(
    size: PrintedNumber, result: Result, ideal: Result, numbers: DefaultNumbers
) -> PrintedNumber:
    """Return the efficiency where the load without friction is 0, of which rounding makes the sign.

    It is 0 where friction alone asks for a load, and undetermined where that is 0, too.
    """
    real = numbers.of(_of_formula(result, Symbol(f"{ideal.name}_f"))).number
    if real and not _is_rounding(real, ideal, numbers):
        return PrintedNumber(0.0) if size.undetermined else size
    return size if real is None else PrintedNumber(None, undetermined=True)


def _of_formula(result: Result, formula: Formula) -> Result:
    """Return a result that has another formula, in its form for elsewhere, too."""
    elsewhere = result.elsewhere and _of_formula(result.elsewhere, formula)
    return replace(result, formula=formula, elsewhere=elsewhere)


def _is_rounding(number: float | None, ideal: Result, numbers: DefaultNumbers) -> bool:
    """Return whether a load with friction is a multiple of one without it that is rounding."""
    if number is None or ideal.default != 0:
        return False
    return abs(number) <= LARGEST_MULTIPLE * abs(value_of(ideal, numbers.values) or 0.0)


def _jams(find: Find, number: float | None, ideal: float | None) -> bool:
    """Return whether the drive has to move the mechanism and no force of it does.

    A result may be infinite where the one without friction is, too, and a force at a joint.
    """
    match find.target:
        case WithFriction(of, sense, order) if order != "first" and number is not None:
            is_load = isinstance(of, LoadRatio | LoadForm)
            if math.isinf(number) and not (is_load and ideal is not None):
                return False
            driven = ideal if ideal is not None and is_load else 0.0
            follows = SIGNS[sense] * driven < 0
            return not follows and not (math.isfinite(number) and number * driven >= 0)
        case _:
            return False


def _moves(result: Result, ideal: Result, numbers: DefaultNumbers) -> bool:
    """Return whether a load with friction acts as it does without, at the default pose."""
    number, without = numbers.of(result).number, ideal.default
    if number is None or without is None:
        return False
    return math.isfinite(number) and number * without > 0


def _below(find: Find) -> str:
    """Return the load below the line of a ratio with friction, '' of anything else."""
    match find.target:
        case WithFriction(LoadRatio(below=below)):
            return below
        case _:
            return ""


def _drive(find: Find) -> str:
    match find.target:
        case WithFriction(LoadRatio(above)):
            return above
        case WithFriction(LoadForm(load)):
            return load
        case _:
            return "of the drive"
