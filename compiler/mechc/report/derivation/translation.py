"""Links that only translate, said in one step, with what follows for the speeds of their points."""

from collections.abc import Sequence, Set

from ...formula.tree import ZERO, Formula, Symbol
from ...formula.walk import substitute
from ...frozen import replace
from ..kinds import Rule
from ..steps import Equation, Step


def translating(steps: Sequence[Step]) -> tuple[Step, ...]:
    """Return steps in which one says that a link translates, and why.

    It stands for two, the equal projections of two velocities and the angular velocity that
    comes to nothing; of what follows from that nothing has this angular velocity.
    """
    found = {step: ends for step in steps if (ends := _equal_ends(step, steps))}
    still = {step.results[-1].left for step in found}
    links = {step.subject[0] for step in found}
    merged = [
        _at_rest(each, still, links) if each not in found else _translation(each, found[each])
        for each in steps
        if each not in found.values()
    ]
    return tuple(merged)


def _equal_ends(step: Step, steps: Sequence[Step]) -> Step | None:
    """Return the step by which the ends of a link have one speed, if the link does not turn."""
    if step.rule is not Rule.ROTATION or not step.results or step.results[-1].right != ZERO:
        return None
    ends = set(step.subject[1:])
    for before in steps[: steps.index(step)]:
        if before.rule is Rule.PROJECTION and set(before.subject) == ends and before.results:
            return before if isinstance(before.results[-1].right, Symbol) else None
    return None


def _translation(step: Step, ends: Step) -> Step:
    equations = (ends.results[-1], step.results[-1])
    return Step(Rule.TRANSLATION, step.subject, equations, equations)


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
