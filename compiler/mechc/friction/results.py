"""Results with friction: a formula, with all that it rests on."""

from collections.abc import Iterator, Sequence

from ..formula.tree import ZERO, Formula
from ..formula.walk import symbols
from ..model.mechanism import Find, Require
from ..model.result import Case as PrintedCase
from ..model.result import Definition, FrictionResult, Result
from ..power.definitions import bound_sums, intermediates
from .closed_form import Named, Printed
from .normal_forces import LoadedPair
from .problem import Loaded, Problem


def result_of(
    problem: Problem, find: Find, ideal: Result, loaded: Loaded, named: Named
) -> FrictionResult:
    """Return the solution as a result, the one without friction being ``ideal``."""
    sums = _sums(problem, loaded)
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
    formulas = [found.formula, *(d.formula for d in found.where)]
    used = frozenset[str]().union(*map(symbols, formulas))
    return found if used.isdisjoint(problem.plan.graph.pose.placeholders) else None


def _case(problem: Problem, find: Find, ideal: Result, printed: Printed) -> PrintedCase:
    where = resting_on(problem, ideal, printed.formula, printed.where)
    holds = (Require(f, o, ZERO, find.span) for f, o in printed.holds)
    guards = tuple(Require(c, ">", ZERO, find.span) for c in printed.positive)
    return PrintedCase(printed.formula, where, tuple(holds), guards)


def resting_on(
    problem: Problem, ideal: Result, formula: Formula, own: Sequence[Definition]
) -> tuple[Definition, ...]:
    """Return definitions with those that they rest on: of the pose, of weights."""
    formulas = [formula, *(d.formula for d in own)]
    used = {name for f in formulas for name in symbols(f)}
    weights = [Definition(n, f) for n, f in problem.valued.items() if n in used]
    known = [*weights, *intermediates(problem.plan.graph.pose, formulas), *ideal.where]
    return tuple(dict.fromkeys((*known, *own)))


def _sums(problem: Problem, loaded: Sequence[LoadedPair]) -> Iterator[Definition]:
    """Yield the named sums that slips and pressing forces rest on."""
    yield from bound_sums(problem.plan, [p.slip for p in loaded])
    for each in (p for p in loaded if p.pair.thrust is None):
        for plan, component in zip(each.plans, each.components, strict=True):
            yield from bound_sums(plan, [component.ideal, *component.by.values()])
