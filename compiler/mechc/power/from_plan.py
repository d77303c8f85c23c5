"""Virtual power: from the plan to what was asked for."""

from typing import assert_never

from ..diagnostics import Report
from ..frozen import replace
from ..kinematics.plan import Plan
from ..model.mechanism import (
    Axial,
    Efficiency,
    Find,
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
from .remarks import warn_of_idle_loads, warn_of_idle_motions


def balance(plan: Plan, report: Report) -> Balance:
    """Return the power equations and what was asked for without friction.

    Reports E501 … E508 where a result is not determined or not finite at the default
    pose, W501 … W504 for loads without work, zero and negative ratios, idle degrees of freedom.
    """
    problem = problem_of(plan, report)
    answers = [_answer(problem, find) for find in problem.mechanism.finds]
    solved = tuple(answer for answer in answers if answer is not None)
    terms, equations, driving = problem.terms, problem.equations, problem.driving
    balanced = Balance(plan, terms, equations, driving, solved, problem.reading.plan)
    report.stop_on_errors()
    warn_of_idle_motions(problem)
    if not problem.mechanism.friction.joints:
        warn_of_idle_loads(balanced, balanced.results, report)
    return replace(balanced, solved=checked(balanced, problem.numbers, report))


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
