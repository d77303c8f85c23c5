"""Virtual power: from the plan to what was asked for."""

from collections.abc import Iterable
from typing import assert_never

from ..base.frozen import replace
from ..diagnostics import Report
from ..formula.differences import positive_sines, terms_as_in
from ..formula.tree import Formula
from ..kinematics.plan import Plan
from ..model.mechanism import (
    Axial,
    Efficiency,
    Find,
    ForceAtJoint,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    SpeedRatio,
    WithFriction,
)
from . import force_results, speed_results
from .balance import AlgebraicResult, Balance
from .load_results import load_form, load_ratio
from .numbers import checked
from .problem import PowerProblem, problem_of
from .remarks import refuse_unbalanced, warn_of_idle_loads, warn_of_idle_motions


def balance(plan: Plan, report: Report) -> Balance:
    """Return the power equations and what was asked for without friction.

    Reports E501 … E508 where a result is not determined or not finite at the default
    pose, E544 where nothing balances the loads, W501 … W504 for loads without work, zero and
    negative ratios, idle degrees of freedom.
    """
    problem = problem_of(plan, report)
    answers = [_answer(problem, find) for find in problem.mechanism.finds]
    solved = _with_sines_alike(problem, [answer for answer in answers if answer is not None])
    terms, equations, driving = problem.terms, problem.equations, problem.driving
    balanced = Balance(plan, terms, equations, driving, solved, problem.reading.plan)
    report.stop_on_errors()
    refuse_unbalanced(problem)
    warn_of_idle_motions(problem)
    if not problem.mechanism.friction.joints:
        warn_of_idle_loads(balanced, balanced.results, report)
    return replace(balanced, solved=checked(balanced, problem.numbers, report))


def _with_sines_alike(
    problem: PowerProblem, answers: Iterable[AlgebraicResult]
) -> tuple[AlgebraicResult, ...]:
    """Return answers; forces at joints have sines of differences the way round of those before."""
    alike: list[AlgebraicResult] = []
    known: list[Formula] = []
    for answer in answers:
        result = answer.result
        if known and isinstance(result.target, ForceAtJoint):
            result = replace(result, formula=terms_as_in(result.formula, *known))
        known += positive_sines([result.formula], lambda: problem.numbers.values)
        alike.append(answer if result is answer.result else replace(answer, result=result))
    return tuple(alike)


def _answer(problem: PowerProblem, find: Find) -> AlgebraicResult | None:
    """Return the solution of a query; None where it is undetermined, or asks for friction."""
    match find.target:
        case LoadRatio() as ratio:
            return load_ratio(problem, find, ratio)
        case LoadForm(load):
            return load_form(problem, find, load)
        case SpeedRatio() as ratio:
            return speed_results.speed_ratio(problem, find, ratio)
        case Reaction() | Axial() | Normal() as force:
            return force_results.joint_force(problem, find, force)
        case WithFriction() | Efficiency():
            return None
        case _:
            assert_never(find.target)
