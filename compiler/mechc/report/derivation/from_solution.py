"""The derivation read off the plan: speeds step by step, then the power equation."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ...friction.solution import Solution
from ...frozen import replace
from ...study.analysis import Analysis
from . import equilibrium
from .forces import of_forces
from .friction import of_friction
from .last_step import last_steps
from .position import position_steps
from .power_terms import power_equations, power_terms, speeds_along
from .speed_steps import SpeedSteps
from .steps import Derivation

if TYPE_CHECKING:
    from ...equilibrium.equilibrium import Equilibrium


def derive(
    solution: Solution, results: Sequence[Analysis], forces: "Sequence[Equilibrium]" = ()
) -> Derivation:
    """Return the derivation of all results, which are given as they were analysed.

    ``forces`` are those at joints that follow from sums of forces and moments.
    """
    speeds = SpeedSteps(solution.balance)
    steps = tuple(speeds.steps())
    along = speeds_along(speeds)
    terms = power_terms(speeds, along)
    at_joints = equilibrium.explained_by_sums(solution, forces) if forces else of_forces(solution)
    derivation = Derivation(
        (*steps, *(each.step for each in along.values())),
        terms,
        tuple(power_equations(speeds, terms)),
        tuple(results),
        (*at_joints, *of_friction(solution, results)),
        ratios=tuple(speeds.ratios),
    )
    position = position_steps(solution.plan.graph.pose, derivation)
    return replace(derivation, position=tuple(position), last_steps=tuple(last_steps(derivation)))
