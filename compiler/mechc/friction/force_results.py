"""Forces at joints, as large as friction everywhere makes them."""

from ..frozen import replace
from ..model.mechanism import Axial, Find, Normal, Reaction, Sense
from ..model.result import Drive, Result
from ..model.targets import SIGNS
from ..power.definitions import bound_sums
from .assumptions import asks_for_loads
from .case import case_of_force, without_friction
from .joint_forces import ForceWithFriction
from .load_results import in_closed_form, iterated
from .problem import Problem
from .results import resting_on, result_of
from .solution import SolvedWithFriction
from .steps import Step


def force_with_friction(
    problem: Problem, find: Find, ideal: Result, force: Reaction | Axial | Normal, sense: Sense
) -> SolvedWithFriction | None:
    """Return a force at a joint; None where equilibrium leaves it open, or friction does."""
    case = case_of_force(problem.driving, ideal, problem.equations)
    loaded = problem.loaded(find, case)
    if loaded is None:
        return None
    endings = problem.endings.of_force(ideal.name, sense)
    if not asks_for_loads(problem.mechanism):
        closed = in_closed_form(problem, case, loaded, SIGNS[sense], endings)
        problem.remark_on_pins(case, exact=closed is not None)
    sizes = problem.sizes(loaded, SIGNS[sense], endings)
    found = ForceWithFriction(force, problem.plan, problem.driving, loaded, sizes)
    if found.transmitted is None:
        return None
    printed = problem.default.printed(found.at_one_pose, endings)
    named = replace(found.at_any_pose(), case=printed)
    result = result_of(problem, find, replace(ideal, where=()), loaded, named)
    without = without_friction(case, problem.equations)
    load = iterated(problem, without.formula(), loaded, sizes).formula
    drive = Drive(without.formula(), load)
    known = resting_on(problem, ideal, drive.ideal, bound_sums(problem.plan, [without]))
    where = tuple(dict.fromkeys((*found.sums(), *known, *result.where)))
    return SolvedWithFriction(replace(result, where=where, drive=drive), (Step("iterated"),))
