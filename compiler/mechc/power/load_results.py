"""Loads that are asked for: as a ratio of two, or as a linear form in all that are known."""

from collections.abc import Mapping

from ..algebra.product import ZERO, Product
from ..algebra.sums import canonical
from ..base.frozen import replace
from ..diagnostics import Diagnostic
from ..diagnostics import power as messages
from ..formula.walk import symbols
from ..model.mechanism import Find, LoadForm, LoadRatio
from ..model.result import Definition, Result
from .balance import AlgebraicResult
from .definitions import intermediates
from .linear_forms import linear_form
from .loads import at_rest, held_drives
from .problem import PowerProblem
from .remarks import looseness, unbalanced


def load_ratio(problem: PowerProblem, find: Find, asked: LoadRatio) -> AlgebraicResult | None:
    """Return a load per unit of another, others being absent; None where that is not fixed.

    Reports E501 … E503 there, E544 and E545 of loads that are tied to each other.
    """
    equations = problem.equations
    (upper, factor), (lower, divisor) = map(equations.owner, (asked.above, asked.below))
    factor = factor / divisor
    if upper == lower:
        if fault := _fault_of_tie(problem, find, asked):
            problem.report.add(fault)
            return None
        return _ratio(problem, find, asked, factor)
    others = [n for n in equations.columns if n not in (upper, lower)]
    unknown = [upper, *others]
    if not _is_determined(problem, find, asked, unknown):
        return None
    if lower not in equations.columns:
        return _ratio(problem, find, asked, ZERO)
    value = canonical(factor * equations.solve(upper, unknown, lower))
    shown = problem.reading.read(value, lambda e: factor * e.solve(upper, unknown, lower))
    return _ratio(problem, find, asked, value, shown)


def _fault_of_tie(problem: PowerProblem, find: Find, asked: LoadRatio) -> Diagnostic | None:
    """Return why a ratio of tied loads is no result: they do not balance, or there is friction."""
    if problem.balances_at_zero_alone:
        return unbalanced(problem, find)
    if problem.mechanism.friction.joints:
        pair = (asked.below, asked.above)
        tied = next(load for load in pair if problem.loads[load].tie is not None)
        return messages.tied_with_friction(find.span, find.name, tied)
    return None


def _is_determined(problem: PowerProblem, find: Find, asked: LoadRatio, unknown: list[str]) -> bool:
    """Return whether the equations give the unknown loads, the one asked for first."""
    equations, report, (upper, *others) = problem.equations, problem.report, unknown
    above, below = asked.above, asked.below
    if upper not in equations.columns:
        report.add(_not_balanced(problem, find, below, above))
        return False
    if len(unknown) < equations.number:
        _report_too_few(problem, find, unknown)
        return False
    if len(unknown) > equations.number or not equations.determines(unknown):
        tied = others or [equations.owner(below)[0]]
        weights = {name for name in problem.loads if problem.given(name) is not None}
        report.add(messages.ratio_not_determined(find.span, above, below, tied, weights))
        return False
    return True


def _not_balanced(problem: PowerProblem, find: Find, load: str, by: str) -> Diagnostic:
    """Return E501: one load cannot balance another one, or the others."""
    mechanism = problem.mechanism
    rest = at_rest(problem.loads[by], mechanism) if by in problem.equations.idle_loads else ""
    return messages.load_not_balanced(find.span, load, by, held_drives(mechanism), rest)


def _report_too_few(problem: PowerProblem, find: Find, unknown: list[str]) -> None:
    number, loose = problem.equations.number, looseness(problem.mechanism)
    problem.report.add(messages.unknown_loads_do_not_match(find.span, unknown, number, loose))


def _ratio(
    problem: PowerProblem,
    find: Find,
    asked: LoadRatio,
    value: Product,
    shown: Product | None = None,
) -> AlgebraicResult:
    """Return a ratio of loads as a result; ``shown`` is its value as it is printed."""
    above, below = problem.dimension(asked.above), problem.dimension(asked.below)
    shown = value if shown is None else shown
    result = problem.result(find, shown.formula(), above.over(below), [shown])
    return AlgebraicResult(result, value, asked.above, asked.below)


def load_form(problem: PowerProblem, find: Find, load: str) -> AlgebraicResult | None:
    """Return a load as a linear form in those known; None where the equations do not give it.

    Reports E501 … E503 there.
    """
    equations = problem.equations
    asked = [f.target.load for f in problem.mechanism.finds if isinstance(f.target, LoadForm)]
    unknown = asked if len(asked) == equations.number else [load]
    if len(unknown) != equations.number:
        _report_too_few(problem, find, asked)
        return None
    if not equations.determines(unknown):
        problem.report.add(_not_balanced(problem, find, "the other loads", load))
        return None
    known = [n for n in equations.columns if n not in unknown]
    values = {n: equations.solve(load, unknown, n) for n in known}
    return AlgebraicResult(_linear(problem, find, load, values), None, load)


def _linear(problem: PowerProblem, find: Find, load: str, values: Mapping[str, Product]) -> Result:
    coefficients = {n: v.formula() for n, v in values.items() if v}
    formula = linear_form(values)
    result = problem.result(find, formula, problem.dimension(load), list(values.values()))
    given = [Definition(n, f) for n in values if (f := problem.given(n)) is not None]
    found = intermediates(problem.plan.graph.pose, symbols(*(g.formula for g in given), formula))
    where = dict.fromkeys((*found, *result.where, *given))
    return replace(result, where=tuple(where), coefficients=coefficients)
