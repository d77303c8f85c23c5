"""The derivation read off the plan: speeds step by step, then the power equation."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING

from ...formula.facing import facing
from ...friction.solution import Solution
from ...frozen import replace
from ...power.numbers import default_values
from ...study.analysis import Analysis
from . import equilibrium
from .forces import of_forces
from .friction import of_friction
from .last_step import last_steps
from .position import position_steps
from .power_terms import power_equations, power_terms, speeds_along
from .speed_steps import SpeedSteps
from .steps import Derivation, Equation, LastStep

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
    values = cache(partial(default_values, solution.plan))
    derivation = _facing(derivation, values)
    position = position_steps(solution.plan.graph.pose, derivation)
    last = tuple(_last_facing(step, values) for step in last_steps(derivation))
    return replace(derivation, position=tuple(position), last_steps=last)


Values = Callable[[], Mapping[str, float]]


def _last_facing(step: LastStep, values: Values) -> LastStep:
    ratio = step.ratio._replace(right=facing(step.ratio.right, values))
    chain = step.chain and step.chain._replace(product=facing(step.chain.product, values))
    return LastStep(chain, ratio)


def _facing(derivation: Derivation, values: Values) -> Derivation:
    """Return the steps with sines of differences turned as those of the results are."""

    def turned(equations: Iterable[Equation]) -> tuple[Equation, ...]:
        return tuple(Equation(*(facing(side, values) for side in e)) for e in equations)

    steps = (
        replace(step, relations=turned(step.relations), results=turned(step.results))
        for step in derivation.steps
    )
    explanations = (
        replace(
            each,
            paragraphs=tuple(replace(p, equations=turned(p.equations)) for p in each.paragraphs),
        )
        for each in derivation.explanations
    )
    ratios = (r._replace(formula=facing(r.formula, values)) for r in derivation.ratios)
    results = (replace(r, formula=facing(r.formula, values)) for r in derivation.results)
    return replace(
        derivation,
        results=tuple(results),
        steps=tuple(steps),
        balances=turned(derivation.balances),
        explanations=tuple(explanations),
        ratios=tuple(ratios),
    )
