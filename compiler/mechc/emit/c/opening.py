"""The first correction from the default pose, whose slopes are known when code is written."""

from collections.abc import Mapping

from ...formula.elimination import eliminate
from ...formula.evaluate import evaluate
from ...formula.walk import symbols
from ...named import NamedTuple
from ...routine.steps import Solver
from .printer import QuickPrinter


class Opening(NamedTuple):
    """The sides of the equations at the start, and the corrections that follow from them."""

    residuals: list[str]
    change: list[str]


def opening(solver: Solver, names: Mapping[str, str]) -> Opening | None:
    """Return the first correction; None where the slopes depend on more than unknowns."""
    values = _at_start(solver)
    entries = [entry for row in solver.jacobian for entry in row]
    if any(isinstance(value, str) for value in solver.start):
        return None
    mixed = {step.name for step in solver.steps if step.name not in values}
    mixed -= fixed_steps(solver)
    if any(symbols(f) - values.keys() for f in entries):
        return None
    if any(symbols(f) & mixed for f in solver.residuals):
        return None
    known = {name: f"({value!r})" for name, value in values.items()}
    printer = QuickPrinter({**names, **known}, solver.residuals)
    inverse = _inverse([[evaluate(entry, values) for entry in row] for row in solver.jacobian])
    return Opening(
        [printer.print(f) for f in solver.residuals],
        [" + ".join(f"{a!r}*residual[{j}]" for j, a in enumerate(row) if a) for row in inverse],
    )


def fixed_steps(solver: Solver) -> set[str]:
    """Return the steps that no unknown enters."""
    known = set(solver.outer)
    for step in solver.steps:
        if symbols(step.formula) <= known:
            known.add(step.name)
    return known


def _at_start(solver: Solver) -> dict[str, float]:
    """Return the values at the default pose of the unknowns and of what they alone decide."""
    pairs = zip(solver.unknowns, solver.start, strict=True)
    values = {name: value for name, value in pairs if not isinstance(value, str)}
    for step in solver.steps:
        if symbols(step.formula) <= values.keys():
            values[step.name] = evaluate(step.formula, values)
    return values


def _inverse(matrix: list[list[float]]) -> list[list[float]]:
    columns = []
    for i in range(len(matrix)):
        unit = [float(i == j) for j in range(len(matrix))]
        eliminate([[*row] for row in matrix], unit)
        columns.append(unit)
    return [list(row) for row in zip(*columns, strict=True)]
