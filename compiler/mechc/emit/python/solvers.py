"""What a module needs to solve systems: one function for each, and Newton's method for all."""

from collections.abc import Iterable, Mapping, Set

from ...base.named import NamedTuple
from ...formula.numeric import newton
from ...formula.to_text import text
from ...routine.steps import NO_ARCS, ProgramStatement, Solve, Solver
from ..names import TargetNames, mangle
from ..render import Assignment
from .printer import RESERVED, PythonPrinter

_OWN = {"unknowns", "outer", "changes", "equations", "rows", "start", "anchor", "scales"}
"""What the template calls its own."""


class SolverContext(NamedTuple):
    """One system; ``rows`` are the residuals and then the rows of the Jacobian.

    ``turned`` lines bring what is known but for whole turns nearest to its anchor.

    With ``by_arcs`` the slopes by the share of the way rest on ``changes`` and lines of their own.
    """

    name: str
    unknowns: list[str]
    outer: list[str]
    zeros: list[str]
    body: list[Assignment]
    rows: list[list[str]]
    start: list[str]
    anchor: list[str]
    turned: list[Assignment]
    side: int
    by_arcs: bool
    changes: list[Assignment]
    by_share: list[str]
    scales: list[float]


def solver_names(statements: Iterable[ProgramStatement]) -> dict[Solver, str]:
    """Return the function that solves each system: one, however many mention it."""
    found = dict.fromkeys(s.solver for s in statements if isinstance(s, Solve))
    return {solver: f"_solution_{i}" for i, solver in enumerate(found, 1)}


def solver_context(solver: Solver, name: str) -> SolverContext:
    """Return a system's function."""
    names = mangle(solver.names, TargetNames(RESERVED.besides(_OWN)))
    arcs = solver.by_arcs or NO_ARCS
    printer = PythonPrinter(names)
    anchored = list(zip(solver.outer, solver.anchor, strict=True))
    return SolverContext(
        name=name,
        unknowns=[names[n] for n in solver.unknowns],
        outer=[names[n] for n in solver.outer],
        zeros=zeros(solver),
        body=[Assignment(names[s.name], printer.print(s.formula)) for s in solver.steps],
        rows=[[printer.print(f) for f in row] for row in (solver.residuals, *solver.jacobian)],
        start=[names[s] if isinstance(s, str) else repr(s) for s in solver.start],
        anchor=[names[outer] if a is None else repr(a) for outer, a in anchored],
        turned=[
            Assignment(names[n], f"_nearest({names[n]}, {a!r})")
            for n, a in anchored
            if n in solver.turning
        ],
        side=solver.side,
        by_arcs=solver.by_arcs is not None,
        changes=[
            *(Assignment(names[change], f"changes[{i}]") for i, change in arcs.changes),
            *(Assignment(names[s.name], printer.print(s.formula)) for s in arcs.steps),
        ],
        by_share=[printer.print(f) for f in arcs.slopes],
        scales=[newton.scale(s) for s in solver.start],
    )


def zeros(solver: Solver) -> list[str]:
    """Return the left sides of a system's equations, with the names of the description."""
    return [text(equation) for equation in solver.equations]


def line(
    statement: ProgramStatement,
    used: Set[str],
    solvers: Mapping[Solver, str],
    printer: PythonPrinter,
    status: str = "_",
) -> Assignment:
    """Return a statement as a line; a solution's status goes to the name ``status``."""
    if not isinstance(statement, Solve):
        return Assignment(printer.names[statement.name], printer.print(statement.formula))
    names = ", ".join(printer.names[n] if n in used else "_" for n in statement.names)
    given = ", ".join(printer.print(a) for a in statement.arguments)
    comma = "," if len(statement.names) == 1 else ""
    return Assignment(f"{status}, ({names}{comma})", f"{solvers[statement.solver]}({given})")
