"""Forces at joints that are asked for: reactions, forces along rods, normal forces."""

from ..diagnostics import Diagnostic
from ..diagnostics import reactions as messages
from ..formula.walk import symbols
from ..kinematics.joint_refs import unclear
from ..model.mechanism import Find, ForceAtJoint, Normal, Reaction
from ..model.result import Definition, Result
from ..source import Span
from ..units import ANGLE, FORCE
from .balance import AlgebraicResult
from .definitions import intermediates, resting_on
from .joint_forces import ForceFormula, called, find_force, has_direction, joint_of
from .problem import PowerProblem


def joint_force(problem: PowerProblem, find: Find, asked: ForceAtJoint) -> AlgebraicResult | None:
    """Return a force at a joint; None, with an error reported, where it is open."""
    pose, report = problem.plan.graph.pose, problem.report
    point = joint_of(asked, pose).point
    if not isinstance(asked, Normal) and point in unclear(problem.mechanism):
        report.add(messages.transmission_presses(find.span, point, has_friction=False))
        return None
    if undecided := problem.undecided:
        shown = called(asked), undecided, problem.equations.number
        report.add_first(messages.which_load_follows(find.span, *shown))
        return None
    found = find_force(asked, pose, problem.reactions())
    if found is None:
        report.add(_open(problem, find.span, called(asked)))
        return None
    return AlgebraicResult(_result(problem, find, asked, found), releases=found.releases)


def _result(problem: PowerProblem, find: Find, asked: ForceAtJoint, found: ForceFormula) -> Result:
    """Return a force at a joint as a result, with all that its formula rests on."""
    formula = problem.with_positive_sines(found.formula)
    where = [d for p in found.plans for d in resting_on(p, formula, found.values)]
    problem.check_lengths(find, [formula, *(d.formula for d in where)])
    given = _given_loads(problem, found)
    names = symbols(formula, *(g.formula for g in given))
    before = intermediates(problem.plan.graph.pose, names)
    coefficients = found.coefficients
    return Result(
        find.name,
        asked,
        ANGLE if isinstance(asked, Reaction) and asked.part == "direction" else FORCE,
        formula,
        tuple(dict.fromkeys((*before, *where, *given))),
        None if coefficients is None else {n: c.formula() for n, c in coefficients.items()},
        guards=has_direction(formula, find.span),
    )


def _given_loads(problem: PowerProblem, found: ForceFormula) -> list[Definition]:
    """Return the loads in a force whose size the description gives."""
    loads, used = (
        (*problem.equations.columns, *problem.equations.idle_loads),
        symbols(found.formula),
    )
    given = ((name, problem.given(name)) for name in loads if name in used)
    return [Definition(name, size) for name, size in given if size]


def _open(problem: PowerProblem, at: Span, force: str) -> Diagnostic:
    """Return why a force at a joint is open: no load holds the mechanism, or too much does."""
    needed, holding = problem.equations.number, len(problem.driving)
    if holding < needed:
        return messages.nothing_holds(at, force, needed, holding)
    return messages.reaction_undetermined(at, force)
