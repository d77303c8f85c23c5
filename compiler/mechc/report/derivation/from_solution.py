"""The derivation read off the plan: speeds step by step, then the power equation."""

from collections.abc import Iterable, Sequence, Set
from functools import cache, partial
from typing import TYPE_CHECKING

from ...formula.facing import (
    LONG,
    ahead,
    as_in,
    condition,
    facing,
    factors_as_in,
    led,
    without_sign,
)
from ...formula.layout import has_minus
from ...formula.operations import count_operations
from ...formula.over_line import over_line
from ...formula.tree import ZERO, Formula, Product, Symbol, is_call, negative
from ...formula.walk import substitute, symbols, walk
from ...friction.solution import Solution
from ...frozen import replace
from ...kinematics.plan import Plan
from ...model.mechanism import Mechanism, WithFriction
from ...pose.given_angles import given_lines
from ...power.numbers import default_values
from ...study.analysis import Analysis, Vanishing
from ..kinds import Rule
from ..sentences.order import geometry_first
from ..sentences.speller import guided_of
from ..steps import Derivation, Equation, Explanation, LastStep, Step
from . import equilibrium
from .forces import of_forces
from .friction import of_friction
from .last_step import last_steps
from .position import position_steps
from .power_terms import power_equations, power_terms, speeds_along
from .speed_steps import SpeedSteps

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
    face = Facing(solution.plan, _turns(results, mechanism))
    derivation = _facing(derivation, face)
    position = position_steps(solution.plan.graph.pose, derivation)
    last = map(face.last_step, last_steps(derivation, solution.balance.equations.owners))
    return replace(derivation, position=tuple(position), last_steps=tuple(last))


class Facing:
    """Writes formulas as :func:`facing` does, at the default pose of a plan."""

    def __init__(self, plan: Plan, turns: Set[str] = frozenset()) -> None:
        """Take the angles by which friction ``turns`` forces: they stand behind others."""
        self._turns = turns
        self._values = cache(partial(default_values, plan))
        self._quarter = given_lines(plan.graph.pose)

    def of(self, formula: Formula) -> Formula:
        """Return a formula with its sines of differences turned, its sums led by a plus.

        Its quotients have whole numbers, not decimals.
        """
        faced = over_line(facing(formula, self._values, self._quarter))
        if count_operations(faced) > LONG:
            return faced
        is_turned = not self._turns.isdisjoint(symbols(formula))
        return led(geometry_first(faced, self._turns) if is_turned else faced)

    def relation(self, equation: Equation) -> Equation:
        """Return an equation of such sides, with the fewer minuses at their heads.

        Of sums of forces and moments the signs have a meaning; velocities have none.
        """
        sides = Equation(*map(self.of, equation))
        if not any(isinstance(side, Product) and has_minus(side) for side in sides):
            return sides
        opposite = Equation(*(self.of(negative(side)) for side in sides))
        return min(sides, opposite, key=lambda pair: sum(map(has_minus, pair)))

    def sines(self, formulas: Iterable[Formula]) -> Sequence[Formula]:
        """Return the sines of differences that are written in formulas as a person has them."""
        return ahead(formulas, self._values)

    def zero(self, limit: Vanishing, formula: Formula) -> Vanishing:
        """Return a condition under which a formula is zero or infinite as the formula has it."""
        factor, *but = (self._condition(f, formula) for f in (limit.factor, *limit.but))
        return limit._replace(factor=factor, but=tuple(but))

    def _condition(self, factor: Formula, formula: Formula) -> Formula:
        """Return a factor that is zero as a formula has it, else as it would be written alone."""
        if factor in walk(formula):
            return factor
        turned = condition(factor, self._values, self._quarter)
        shown = (without_sign(as_in(one, formula)) for one in (factor, turned))
        return next((one for one in shown if one in walk(formula)), turned)

    def equations(self, equations: Iterable[Equation]) -> tuple[Equation, ...]:
        """Return equations, either side of each by itself."""
        return tuple(Equation(*map(self.of, equation)) for equation in equations)

    def step(self, step: Step, sines: Sequence[Formula]) -> Step:
        """Return a step of the velocities; what it finds has the sines that results have."""
        relations = tuple(map(self.relation, step.relations))
        results = self.equations(step.results)
        found = (e._replace(right=factors_as_in(e.right, *sines)) for e in results)
        return replace(step, relations=relations, results=tuple(found))

    def explanation(self, explanation: Explanation) -> Explanation:
        """Return how a force follows."""
        paragraphs = explanation.paragraphs
        faced = (replace(p, equations=self.equations(p.equations)) for p in paragraphs)
        return replace(explanation, paragraphs=tuple(faced))

    def result(self, result: Analysis) -> Analysis:
        """Return a result; what is said of its formula mentions the same parts as that does."""
        formula = self.of(result.formula)
        zeros = tuple(self.zero(limit, formula) for limit in result.zeros)
        poles = tuple(self.zero(limit, formula) for limit in result.poles)
        slopes = result.derivatives
        derivatives = slopes and {n: as_in(self.of(s), formula) for n, s in slopes.items()}
        where = tuple(d._replace(formula=self._turned(d.formula)) for d in result.where)
        holds = tuple(replace(h, left=self._turned(h.left)) for h in result.holds)
        result = replace(result, where=where, holds=holds, derivatives=derivatives)
        return replace(result, formula=formula, zeros=zeros, poles=poles)

    def _turned(self, formula: Formula) -> Formula:
        """Return a formula with an angle of friction in front as it is written, else as it is."""
        if self._turns.isdisjoint(symbols(formula)):
            return formula
        return formula if geometry_first(formula, self._turns) == formula else self.of(formula)

    def last_step(self, step: LastStep) -> LastStep:
        """Return the step that gives a ratio."""
        ratio = step.ratio._replace(right=self.of(step.ratio.right))
        chain = step.chain and step.chain._replace(product=self.of(step.chain.product))
        return LastStep(chain, ratio)


def _turns(results: Sequence[Analysis], mechanism: Mechanism) -> Set[str]:
    """Return the names of angles by which friction turns a force."""
    found = (d for r in results if isinstance(r.target, WithFriction) for d in r.where)
    turned = (d.name for d in found if is_call(d.formula, "asin", "atan"))
    return mechanism.friction.parameters | {*turned}


def _facing(derivation: Derivation, face: Facing) -> Derivation:
    """Return the steps with sines of differences turned as those of the results are."""
    results = tuple(map(face.result, derivation.results))
    sines = face.sines(result.formula for result in results)
    return replace(
        derivation,
        results=results,
        steps=tuple(face.step(step, sines) for step in derivation.steps),
        balances=face.equations(derivation.balances),
        explanations=tuple(map(face.explanation, derivation.explanations)),
        ratios=tuple(r._replace(formula=face.of(r.formula)) for r in derivation.ratios),
    )


# -------------------------------------------------------------------------------------- translation


def translating(steps: Sequence[Step], guided: Set[str] = frozenset()) -> tuple[Step, ...]:
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


def _is_at_rest(step: Step) -> bool:
    """Return whether a step finds that a link does not turn."""
    return step.rule is Rule.ROTATION and bool(step.results) and step.results[-1].right == ZERO


def _equal_ends(step: Step, steps: Sequence[Step]) -> Step | None:
    """Return the step by which the ends of a link that does not turn have one speed."""
    ends = set(step.subject[1:])
    for before in steps[: steps.index(step)]:
        if before.rule is Rule.PROJECTION and set(before.subject) == ends and before.results:
            return before if isinstance(before.results[-1].right, Symbol) else None
    return None


def _translation(step: Step, ends: Step | None, guided: Set[str]) -> Step:
    """Return the step that says why a link translates, with what its points' speeds are."""
    still = step.results[-1:]
    if ends:
        equations = (*ends.results[-1:], *still)
        return Step(Rule.TRANSLATION, step.subject, equations, equations)
    if guided >= {*step.subject[1:]}:
        return Step(Rule.PARALLEL_GUIDES, step.subject, still, still)
    return Step(Rule.EQUAL_VELOCITIES, step.subject, (*_equal_speeds(step), *still), still)


def _equal_speeds(step: Step) -> list[Equation]:
    """Return that the speeds of a link's two points are equal, where both are in its relation."""
    speeds = [Symbol(f"V_{point}") for point in step.subject[1:]]
    met = symbols(*(e.right for e in step.relations))
    is_met = len(speeds) == 2 and met.issuperset(speed.name for speed in speeds)
    return [Equation(*speeds)] if is_met else []


def _at_rest(step: Step, still: Set[Formula], links: Set[str]) -> Step:
    """Return a step without the angular velocities that are zero."""
    nothing = {speed.name: ZERO for speed in still if isinstance(speed, Symbol)}

    def without(equations: tuple[Equation, ...]) -> tuple[Equation, ...]:
        return tuple(Equation(e.left, substitute(e.right, nothing)) for e in equations)

    rule = step.rule
    if rule is Rule.COMPONENT_OF_BODY and step.subject[0] in links:
        rule = Rule.COMPONENT_OF_TRANSLATION
    if not nothing:
        return step
    relations, results = without(step.relations), without(step.results)
    return replace(step, rule=rule, relations=relations, results=results)
