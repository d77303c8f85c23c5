"""Results with friction: a formula, with all that it rests on."""

from collections.abc import Sequence

from ..formula.tree import ZERO, Formula
from ..formula.walk import symbols
from ..model.mechanism import Find, Require
from ..model.result import Case as PrintedCase
from ..model.result import Definition, FrictionResult, Result
from ..power.definitions import intermediates, open_lengths
from .closed_form import Named, Printed
from .problem import Loaded, Problem


def result_of(
    problem: Problem, find: Find, ideal: Result, loaded: Loaded, named: Named
) -> FrictionResult:
    """Return the solution as a result, the one without friction being ``ideal``."""
    sums = problem.sums(loaded)
    return FrictionResult(
        find.name,
        find.target,
        ideal.dimension,
        named.formula,
        resting_on(problem, ideal, named.formula, (*sums, *named.where)),
        guards=tuple(Require(c, ">", ZERO, find.span) for c in named.positive),
        elsewhere=_elsewhere(problem, find, ideal, loaded, named),
        case=_case(problem, find, ideal, named.case) if named.case else None,
        inside=named.inside,
    )


def _elsewhere(
    problem: Problem, find: Find, ideal: Result, loaded: Loaded, named: Named
) -> Result | None:
    """Return the result for elsewhere, if all the lengths in it are given."""
    if named.elsewhere is None:
        return None
    found = result_of(problem, find, ideal, loaded, named.elsewhere)
    missing = open_lengths(problem.plan, (found.formula, *(d.formula for d in found.where)))
    return None if missing else found


def _case(problem: Problem, find: Find, ideal: Result, printed: Printed) -> PrintedCase:
    where = resting_on(problem, ideal, printed.formula, printed.where)
    holds = (Require(f, o, ZERO, find.span) for f, o in printed.holds)
    guards = tuple(Require(c, ">", ZERO, find.span) for c in printed.positive)
    return PrintedCase(printed.formula, where, tuple(holds), guards)


def resting_on(
    problem: Problem, ideal: Result, formula: Formula, own: Sequence[Definition]
) -> tuple[Definition, ...]:
    """Return definitions with those that they rest on: of the pose, of weights."""
    used = symbols(formula, *(d.formula for d in own))
    weights = [Definition(n, f) for n, f in problem.valued.items() if n in used]
    known = [*weights, *intermediates(problem.plan.graph.pose, used), *ideal.where]
    return tuple({d.name: d for d in (*known, *own)}.values())
