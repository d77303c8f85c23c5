"""What results with friction promise, as a check for tests and for whoever finds them."""

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from typing import Protocol

from ..formula.evaluate import evaluate
from ..formula.tree import Formula
from ..formula.walk import symbols
from ..model.mechanism import Efficiency, LoadRatio, Mechanism, Require, ResultTarget, WithFriction
from ..model.parts.targets import SIGNS
from ..model.result import Definition, FrictionResult, Result
from ..model.values import Values, completed, holds, valid_form
from ..power.numbers import default_values
from ..power.promises import undefined
from .solution import FrictionSolution, SolvedWithFriction
from .tolerances import SAME_BY_ITERATION


def broken_promises(solution: FrictionSolution) -> list[str]:
    """Return a sentence for each promise of this folder that a solution breaks."""
    mechanism, values = solution.plan.graph.pose.mechanism, _values(solution)
    ideal = {s.result.target: s.result for s in solution.balance.solved}
    results = [s.result for s in solution.solved if isinstance(s, SolvedWithFriction)]
    found = [*_meanings([r.where for r in results])]
    found += _meanings([r.case.where for r in results if r.case])
    for result in results:
        found += [*_names(result, mechanism), *_printed(result, values)]
        found += _resists(result, ideal)
    return found


def _values(solution: FrictionSolution) -> Values:
    """Return the numbers of the default pose; a load of open size has none.

    Of several loads the sizes decide the signs, so that a printed case has to be known by them.
    """
    return default_values(solution.plan)


def _names(result: FrictionResult, mechanism: Mechanism) -> Iterator[str]:
    """Yield the names that mean nothing, in a result and in what is printed of it."""
    known = {p.name for p in mechanism.parameters} | {load.name for load in mechanism.loads}
    yield from _defined(result.name, result, result.guards, known)
    strays = sorted(result.inside - {d.name for d in result.where})
    yield from (f"{name} is inside a system of {result.name} that is not there" for name in strays)
    if result.elsewhere is not None:
        there = result.elsewhere
        yield from _defined(f"{result.name} elsewhere", there, there.guards, known)
    if result.case is not None:
        conditions = (*result.case.holds, *result.case.guards)
        yield from _defined(f"{result.name} as printed", result.case, conditions, known)


class CheckedFormula(Protocol):
    """A formula and what it rests on: a result, or its printed case."""

    @property
    def formula(self) -> Formula:
        """Return the formula."""
        ...

    @property
    def where(self) -> Sequence[Definition]:
        """Return the names that the formula mentions, each after those it needs."""
        ...


def _defined(
    name: str, shown: CheckedFormula, conditions: Sequence[Require], known: Set[str]
) -> Iterator[str]:
    yield from undefined(name, shown.formula, shown.where, known)
    defined = known | {d.name for d in shown.where}
    used = frozenset[str]().union(*(symbols(c.left) | symbols(c.right) for c in conditions))
    yield from (f"a condition of {name} uses {n}" for n in sorted(used - defined))


def _meanings(lists: Sequence[Sequence[Definition]]) -> Iterator[str]:
    """Yield the names that stand for one thing in one result and for another in the next."""
    meanings: dict[str, Formula] = {}
    for name, formula in (definition for where in lists for definition in where):
        if meanings.setdefault(name, formula) != formula:
            yield f"{name} means two things"


# ---------------------------------------------------------------- at the default pose


def _printed(result: FrictionResult, values: Values) -> Iterator[str]:
    """Yield a printed case that is another number than the result, or not that of the pose."""
    case, found = result.case, valid_form(result, values)
    if case is None or found is None:
        return
    there, printed = completed(values, found.where), completed(values, case.where)
    if not (symbols(found.formula) <= there.keys() and symbols(case.formula) <= printed.keys()):
        return
    if any(not holds(condition, printed) for condition in case.holds):
        yield f"{result.name} is printed for other signs than those of the default pose"
    number, shown = evaluate(found.formula, there), evaluate(case.formula, printed)
    if not (
        math.isnan(number)
        or math.isclose(number, shown, rel_tol=SAME_BY_ITERATION, abs_tol=SAME_BY_ITERATION)
    ):
        yield f"{result.name} is {number:.9g} and printed as {shown:.9g}"


def _resists(result: FrictionResult, ideal: Mapping[ResultTarget | None, Result]) -> Iterator[str]:
    """Yield a friction that helps the drive: more than all of its power arrives, or less than none.

    For a force F of 1 a drive that moves along its arrow takes more than without friction, by
    what is lost, and one that moves against it less, whatever the sign of k.
    """
    number = result.default
    match result.target:
        case Efficiency(LoadRatio(), "tightening") if number is not None and not 0 <= number <= 1:
            yield f"{result.name} is {number:.6g}"
        case WithFriction(LoadRatio() as ratio, sense) if number is not None:
            without = ideal[ratio].default
            if without is not None and (number - without) * SIGNS[sense] < -SAME_BY_ITERATION:
                yield f"{result.name} is {number:.6g}, {without:.6g} without friction"
        case _:
            pass
