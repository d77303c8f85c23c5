"""The derivation read off the plan: speeds step by step, then the power equation."""

from collections.abc import Sequence, Set
from typing import TYPE_CHECKING

from ...base.frozen import replace
from ...formula.tree import ZERO, Formula, Symbol
from ...formula.walk import substitute, symbols
from ...friction.solution import FrictionSolution
from ...model.mechanism import SpeedRatio
from ...study.analysis import Analysis
from ..kinds import StepRule
from ..readable import turns_of_friction
from ..sentences.speller import guided_of
from ..steps import Derivation, DerivationStep, Equation
from . import equilibrium
from .forces import of_forces
from .friction import of_friction
from .last_step import last_steps
from .position import position_steps
from .power_terms import power_equations, power_terms, speeds_along
from .readable import ReadableDerivation
from .speed_steps import SpeedSteps

if TYPE_CHECKING:
    from ...equilibrium.equilibrium import Equilibrium


def derive(
    solution: FrictionSolution, results: Sequence[Analysis], forces: "Sequence[Equilibrium]" = ()
) -> Derivation:
    """Return the derivation of all results, which are given as they were analysed.

    ``forces`` are those at joints that follow from sums of forces and moments.
    """
    speeds = SpeedSteps(solution.balance)
    steps = tuple(speeds.steps())
    along = speeds_along(speeds)
    mechanism = solution.plan.graph.pose.mechanism
    terms = power_terms(speeds, along)
    at_joints = equilibrium.explained_by_sums(solution, forces) if forces else of_forces(solution)
    derivation = Derivation(
        translating((*steps, *(each.step for each in along.values())), guided_of(mechanism)),
        terms,
        tuple(power_equations(speeds, terms)),
        tuple(results),
        (*at_joints, *of_friction(solution, results)),
        ratios=tuple(speeds.ratios),
        requires=mechanism.requires,
    )
    face = ReadableDerivation(solution.plan, turns_of_friction(results, solution.plan.graph.pose))
    derivation = face.derivation(derivation)
    last = map(face.last_step, last_steps(derivation, solution.balance.equations.owners))
    derivation = without_unused(replace(derivation, last_steps=tuple(last)))
    position = position_steps(solution.plan.graph.pose, derivation)
    return replace(derivation, position=tuple(position))


# ------------------------------------------------------------------------------- what is not used


def without_unused(derivation: Derivation) -> Derivation:
    """Return a derivation without the speeds that relations solved together give in vain.

    Nothing else has them: no other step, no load's power, no account of friction, no result.
    """
    asked = _speeds_elsewhere(derivation)

    def used(step: DerivationStep) -> DerivationStep:
        if step.rule is not StepRule.TOGETHER:
            return step
        others = (each for each in derivation.steps if each is not step)
        names = asked.union(*(_names_in(*each.relations, *each.results) for each in others))
        wanted = tuple(e for e in step.results if _is_wanted(e, step.results, names))
        return replace(step, results=wanted) if wanted else step

    steps = tuple(map(used, derivation.steps))
    shown = _names_in(*(e for step in steps for e in step.results))
    ratios = tuple(r for r in derivation.ratios if r.name in shown | asked)
    return replace(derivation, steps=steps, ratios=ratios)


def _is_wanted(equation: Equation, beside: Sequence[Equation], names: Set[str]) -> bool:
    """Return whether a result is mentioned, by its own name or the ratio that it stands for."""
    of_it = [e for e in beside if e.left == equation.left]
    ratios = (symbols(e.right) for e in of_it if e.right != equation.right)
    own = symbols(equation.left)
    return not names.isdisjoint(own) or any(names & found for found in ratios)


def _names_in(*equations: Equation) -> frozenset[str]:
    return symbols(*(side for equation in equations for side in equation))


def _speeds_elsewhere(derivation: Derivation) -> frozenset[str]:
    """Return the names that a derivation has but for its steps, the speeds asked for by theirs."""
    found = {n for term in derivation.terms for n in symbols(term.speed)}
    for explanation in derivation.explanations:
        found |= _names_in(*(e for p in explanation.paragraphs for e in p.equations))
        found |= symbols(*(d.formula for d in explanation.where))
    for last in derivation.last_steps:
        found |= _names_in(last.ratio) | symbols(*(last.chain.links if last.chain else ()))
    for result in derivation.results:
        found |= symbols(result.formula, *(d.formula for d in result.where))
        if isinstance(result.target, SpeedRatio):
            found |= {result.target.above.name, result.target.below.name}
    return frozenset(found)


# -------------------------------------------------------------------------------------- translation


def translating(
    steps: Sequence[DerivationStep], guided: Set[str] = frozenset()
) -> tuple[DerivationStep, ...]:
    """Return steps in which one says that a link translates, and why.

    It may stand for two, the equal projections of two velocities and the angular velocity that
    comes to nothing; of what follows from that nothing has this angular velocity. Points that
    are ``guided`` move along guides of the ground.
    """
    resting = {step: _equal_ends(step, steps) for step in steps if _is_at_rest(step)}
    still = {step.results[-1].left for step in resting}
    links = {step.subject[0] for step in resting}
    merged = [
        _translation(each, resting[each], guided)
        if each in resting
        else _at_rest(each, still, links)
        for each in steps
        if each not in resting.values()
    ]
    return tuple(merged)


def _is_at_rest(step: DerivationStep) -> bool:
    """Return whether a step finds that a link does not turn."""
    return step.rule is StepRule.ROTATION and bool(step.results) and step.results[-1].right == ZERO


def _equal_ends(step: DerivationStep, steps: Sequence[DerivationStep]) -> DerivationStep | None:
    """Return the step by which the ends of a link that does not turn have one speed."""
    ends = set(step.subject[1:])
    for before in steps[: steps.index(step)]:
        if before.rule is StepRule.PROJECTION and set(before.subject) == ends and before.results:
            return before if isinstance(before.results[-1].right, Symbol) else None
    return None


def _translation(
    step: DerivationStep, ends: DerivationStep | None, guided: Set[str]
) -> DerivationStep:
    """Return the step that says why a link translates, with what its points' speeds are."""
    still = step.results[-1:]
    if ends:
        equations = (*ends.results[-1:], *still)
        return DerivationStep(StepRule.TRANSLATION, step.subject, equations, equations)
    if guided >= {*step.subject[1:]}:
        return DerivationStep(StepRule.PARALLEL_GUIDES, step.subject, still, still)
    return DerivationStep(
        StepRule.EQUAL_VELOCITIES, step.subject, (*_equal_speeds(step), *still), still
    )


def _equal_speeds(step: DerivationStep) -> list[Equation]:
    """Return that the speeds of a link's two points are equal, where both are in its relation."""
    speeds = [Symbol(f"V_{point}") for point in step.subject[1:]]
    met = symbols(*(e.right for e in step.relations))
    is_met = len(speeds) == 2 and met.issuperset(speed.name for speed in speeds)
    return [Equation(*speeds)] if is_met else []


def _at_rest(step: DerivationStep, still: Set[Formula], links: Set[str]) -> DerivationStep:
    """Return a step without the angular velocities that are zero."""
    zeros = {speed.name: ZERO for speed in still if isinstance(speed, Symbol)}
    if not zeros:
        return step

    def without(equations: tuple[Equation, ...]) -> tuple[Equation, ...]:
        return tuple(Equation(e.left, substitute(e.right, zeros)) for e in equations)

    rule = step.rule
    if rule is StepRule.COMPONENT_OF_BODY and step.subject[0] in links:
        rule = StepRule.COMPONENT_OF_TRANSLATION
    relations, results = without(step.relations), without(step.results)
    return replace(step, rule=rule, relations=relations, results=results)
