"""The results of a calculation sheet, whose formulas are given: nothing is derived."""

import math
from collections.abc import Sequence

from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics import sheets as messages
from ..diagnostics import uses as uses_messages
from ..formula.evaluate import evaluate
from ..formula.numeric.rounding import Rounding
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Mechanism, Require
from ..model.result import ClosedLoop, Result, UsedSolution
from ..model.results import failures
from ..model.values import Chain, Values, compare, default_pose, following, user_defined
from ..pose.pose import Pose, PoseDefinition
from ..power.definitions import let_results
from .calculation import Calculation, Check
from .doubtful_signs import doubtful, negative_sizes
from .mechanism_results import is_at_rest, resting_on_sheet, with_values


def calculate(pose: Pose, solved: UsedSolution, report: Report) -> Calculation:
    """Return the results of a sheet with their values, those of the mechanisms that it uses first.

    E550 where a condition fails at the values of the sheet, E551 where a formula has no value
    there, E564 where a result of a mechanism has none; W265 where a sign makes a condition hold,
    W290 where a size is negative, W518 where a joint of a mechanism does not slide.
    """
    pose = _with_conditions_of(solved, pose)
    mechanism = pose.mechanism
    given = {**default_pose(mechanism)}
    brought = tuple(with_values(resting_on_sheet(mechanism, solved), given))
    own = tuple(let_results(pose, brought, report))
    given |= {r.name: r.default for r in brought if r.default is not None}
    lets = user_defined(mechanism)
    values = Chain({**dict(solved.definitions), **lets}).complete(given)
    checks = tuple(_checked(condition, values) for condition in mechanism.requires)
    failed = _refuse_broken(checks, report)
    for doubt in doubtful(mechanism, checks):
        report.add(doubt)
    for doubt in negative_sizes(mechanism, values, len(report.source.text)):
        report.add(doubt)
    _warn_of_results_at_rest(mechanism, brought, given, report)
    failed |= _refuse_without(pose, given, values, report)
    _refuse_undefined(mechanism, values, failed, report)
    nothing = _rounded_zeros(mechanism, given)
    known = {name: 0.0 if name in nothing else value for name, value in values.items()}
    found = (_with_value(result, known) for result in own)
    return Calculation(pose, (*brought, *found), checks)


def _with_conditions_of(solved: UsedSolution, pose: Pose) -> Pose:
    """Return the pose of a sheet with the conditions and definitions of used mechanisms."""
    requires = (*pose.mechanism.requires, *solved.requires)
    definitions = (PoseDefinition(*d) for d in solved.definitions)
    return replace(
        pose,
        mechanism=replace(pose.mechanism, requires=requires),
        definitions=(*pose.definitions, *definitions),
        loops=solved.loops,
    )


def _refuse_without(pose: Pose, given: Values, values: Values, report: Report) -> set[str]:
    """Report the first result of each mechanism that has no value; return the names of all.

    Where a parameter has no value nothing is known of them.
    """
    taken = pose.mechanism.taken
    missing = [r for r in taken if not math.isfinite(given.get(r.name, 0.0))]
    for span, result in {r.span: r for r in reversed(missing)}.items():
        loop = _open_loop(result.name, pose.loops, values)
        report.add(uses_messages.result_without_value(span, result.name, result.asked, loop))
    return {result.name for result in missing}


def _warn_of_results_at_rest(
    mechanism: Mechanism, brought: Sequence[Result], given: Values, report: Report
) -> None:
    """Warn of results of mechanisms that lack the friction of a joint which does not slide.

    Of those that one mechanism gives, and that the sheet uses, the first is warned of.
    """
    conditions = (side for r in mechanism.requires for side in (r.left, r.right))
    used = symbols(*user_defined(mechanism).values(), *conditions)
    at_rest = {r.name for r in brought if r.name in used and is_at_rest(r, given)}
    first = {taken.span: taken for taken in reversed(mechanism.taken) if taken.name in at_rest}
    for taken in first.values():
        report.add(uses_messages.result_at_rest(taken.span, taken.name, taken.asked))


def _open_loop(result: str, loops: tuple[ClosedLoop, ...], values: Values) -> str:
    """Return the first loop of the mechanism of a result that does not close, '' if all do."""
    for loop in loops:
        known = symbols(loop.margin) <= values.keys()
        if known and result.startswith(f"{loop.of}_") and not evaluate(loop.margin, values) >= 0:
            return loop.loop
    return ""


def _rounded_zeros(mechanism: Mechanism, values: Values) -> frozenset[str]:
    """Return the formulas of which nothing is left but rounding."""
    rounding = Rounding(values)
    rounding.define(following(mechanism, user_defined(mechanism).items()).definitions)
    return frozenset(name for name, value in rounding.values.items() if value.is_zero)


def _with_value(result: Result, values: Values) -> Result:
    return replace(result, default=values.get(result.name))


def _checked(condition: Require, values: Values) -> Check:
    return Check(condition, _value(condition.left, values), _value(condition.right, values))


def _value(formula: Formula, values: Values) -> float | None:
    return evaluate(formula, values) if symbols(formula) <= values.keys() else None


def holds(check: Check) -> bool:
    """Return whether a condition holds; True where a side of it has no value."""
    if check.left is None or check.right is None:
        return True
    return compare(check.left, check.condition.operator, check.right)


def _refuse_broken(checks: tuple[Check, ...], report: Report) -> set[str]:
    """Report every condition that fails; return the formulas that have no value by that."""
    failed = set[str]()
    for check in checks:
        if check.left is None or check.right is None:
            continue
        if math.isnan(check.left) or math.isnan(check.right):
            continue  # what has no value is reported by itself
        if not holds(check):
            report.add(failures.failure(check.condition, (check.left, check.right), report.source))
            if check.condition.subject:
                failed.add(check.condition.subject.let)
    return failed


def _refuse_undefined(
    mechanism: Mechanism, values: Values, failed: set[str], report: Report
) -> None:
    """Report the formulas that have no value, without those that failed or rest on others."""
    missing, places = set(failed), {let.name: let.span for let in mechanism.lets}
    for name, formula in Chain(user_defined(mechanism)).definitions:
        if symbols(formula) & missing:
            missing.add(name)
        elif name not in missing and not math.isfinite(values.get(name, 0.0)):
            missing.add(name)
            report.add(messages.without_value(places[name], name))
