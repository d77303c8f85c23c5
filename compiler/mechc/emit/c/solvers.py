"""What a source needs to solve systems: one function for each, and elimination for all."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set

from ...base.named import NamedTuple
from ...formula.evaluate import evaluate
from ...formula.numeric import newton
from ...formula.numeric.elimination import eliminate
from ...formula.to_text import text
from ...formula.walk import symbols
from ...routine import steps
from ...routine.steps import ProgramStatement, Solve, Solver
from ..names import TargetNames, mangle
from ..printer import Printer
from ..render import Assignment
from .elimination import Reduced, reduced
from .printer import QuickPrinter, harmless, wrapped
from .reserved import RESERVED


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


_WORDS = """
    base reached step last count i found aim rest right matrix sign size far longest good there
    residual slope change mechc_eliminate given work status mechc_arcs
"""
_OWN = frozenset(_WORDS.split())
"""What the template calls its own."""


TAU = repr(math.tau)

NEVER = 2
"""No determinant has this sign: nothing can be followed from a singular pose."""


class ByArcsContext(NamedTuple):
    """What follows a branch by its arc length: its equations as a function of what is ``given``.

    ``ends`` are the values given, so many in ``number``, ``lines`` what residuals and slopes rest
    on, ``sides`` the lines that fill these in, ``room`` how many numbers are kept on the way.
    """

    name: str
    lines: list[Assignment]
    sides: list[str]
    number: int
    ends: str
    room: int


class SolverContext(NamedTuple):
    """One system; fields are what ``c/solver.jinja`` mentions.

    ``turned`` lines bring what is known but for whole turns nearest to its anchor, ``fixed`` lines
    are those of a step along the way, ``body`` those of a correction; ``shortest`` is the condition
    under which steps are not too short.
    """

    title: str
    zeros: list[str]
    head: str
    size: int
    start: str
    turned: list[Assignment]
    fixed: list[Assignment]
    body: list[Assignment]
    residuals: list[str]
    jacobian: list[list[str]]
    left: Reduced
    opening: Opening | None
    far: str
    norm: str
    side: int
    shortest: str
    by_arcs: ByArcsContext | None


def solvers_of(statements: Iterable[ProgramStatement]) -> list[Solver]:
    """Return every system once, however many mention it."""
    return list(dict.fromkeys(s.solver for s in statements if isinstance(s, Solve)))


def solver_context(solver: Solver, name: str) -> SolverContext:
    """Return a system's function."""
    space = TargetNames(RESERVED.besides(_OWN), {name})
    names = mangle(solver.names, space)
    anchored = list(_anchored(solver))
    ends = {outer: space.claim(f"{names[outer]}_end") for outer, _ in anchored}
    plain = {outer: space.claim(f"{names[outer]}_given") for outer in solver.turning}
    given = [plain.get(n, ends.get(n, names[n])) for n in solver.outer]
    start = (names[s] if isinstance(s, str) else repr(s) for s in solver.start)
    gaps = (_square(_gap(ends[outer], a), newton.scale(a)) for outer, a in anchored)
    changes = (_square(f"change[{i}]", newton.scale(s)) for i, s in enumerate(solver.start))
    printer = QuickPrinter(names, solver.computed)
    fixed, body = _steps(solver, printer)
    left = reduced(solver.jacobian)
    fixed = [*(_between(outer, names, ends, a) for outer, a in anchored), *fixed]
    body = [*(Assignment(names[n], f"found[{i}]") for i, n in enumerate(solver.unknowns)), *body]
    return SolverContext(
        title=harmless(f"The unknowns {', '.join(solver.unknowns)}, for which these are zero"),
        zeros=[harmless(text(equation)) for equation in solver.equations],
        head=wrapped(f"static int {name}(", [*(f"double {g}" for g in given), "double *found"]),
        size=len(solver.unknowns),
        start=f"{{{', '.join(start)}}}",
        turned=[_nearest(ends[n], plain[n], a) for n, a in anchored if n in plain],
        fixed=fixed,
        body=body,
        residuals=[printer.print(f) for f in solver.residuals],
        jacobian=[[printer.print(f) for f in row] for row in solver.jacobian],
        left=left,
        opening=opening(solver, names),
        far=" + ".join(gaps) or "0.0",
        norm=" + ".join(changes),
        side=solver.side * left.turn or NEVER,
        shortest=f" && step >= {newton.ARCS_FROM!r}" if solver.by_arcs else "",
        by_arcs=_by_arcs(solver, solver.by_arcs, f"{name}_sides", given, [*fixed, *body], printer)
        if solver.by_arcs
        else None,
    )


def _by_arcs(
    solver: Solver,
    arcs: steps.ByArcs,
    name: str,
    given: Sequence[str],
    lines: Sequence[Assignment],
    printer: Printer,
) -> ByArcsContext:
    """Return the functions that follow a branch by its arc length."""
    size, names = len(solver.unknowns), printer.names
    rows = zip(solver.jacobian, arcs.slopes, strict=True)
    slopes = [entry for row, last in rows for entry in (*row, last)]
    anchors = dict(_anchored(solver))
    return ByArcsContext(
        name=name,
        lines=[
            *(Assignment(g, f"given[{i}]") for i, g in enumerate(given)),
            *lines,
            *(
                Assignment(names[c], _gap(given[i], anchors[solver.outer[i]]))
                for i, c in arcs.changes
            ),
            *(Assignment(names[s.name], printer.print(s.formula)) for s in arcs.steps),
        ],
        sides=[
            f"{to}[{i}] = {printer.print(f)};"
            for to, formulas in (("residual", solver.residuals), ("slope", slopes))
            for i, f in enumerate(formulas)
        ],
        number=len(given),
        ends=f"{{{', '.join(given)}}}",
        room=5 * (size + 1) + (size + 1) ** 2,
    )


def _steps(solver: Solver, printer: Printer) -> tuple[list[Assignment], list[Assignment]]:
    """Return the lines that a step along the way fixes, and those of every correction."""
    fixed = fixed_steps(solver)
    lines = {
        s.name: Assignment(printer.names[s.name], printer.print(s.formula)) for s in solver.steps
    }
    return (
        [line for name, line in lines.items() if name in fixed],
        [line for name, line in lines.items() if name not in fixed],
    )


def _anchored(solver: Solver) -> Iterator[tuple[str, float]]:
    """Yield the outer symbols that change along the path, and where they start."""
    pairs = zip(solver.outer, solver.anchor, strict=True)
    return ((name, anchor) for name, anchor in pairs if anchor is not None)


def _between(
    name: str, names: Mapping[str, str], ends: Mapping[str, str], anchor: float
) -> Assignment:
    value = f"({anchor!r})" if anchor < 0 else repr(anchor)
    return Assignment(names[name], f"rest*{value} + aim*{ends[name]}")


def _gap(end: str, anchor: float) -> str:
    return f"({end} + {-anchor!r})" if anchor < 0 else f"({end} - {anchor!r})"


def _nearest(name: str, given: str, anchor: float) -> Assignment:
    return Assignment(name, f"{given} - {TAU}*floor({_gap(given, anchor)}/{TAU} + 0.5)")


def _square(part: str, scale: float) -> str:
    return f"{part}*{part}" if scale == 1 else f"({part}/{scale!r})*({part}/{scale!r})"


# ----------------------------------------------------------------------- statements


def lines(
    statements: Iterable[ProgramStatement],
    used: Set[str],
    solvers: Mapping[Solver, str],
    printer: Printer,
    space: TargetNames,
) -> tuple[list[str], list[str]]:
    """Return statements as C and the names of the solutions' statuses.

    Unknowns that nobody has ``used`` get no names, so that no compiler complains.
    """
    made: list[str] = []
    statuses: list[str] = []
    for statement in statements:
        if isinstance(statement, Solve):
            status = space.claim("status_1")
            statuses.append(status)
            made += _solution(statement, status, used, solvers, printer, space)
        else:
            value = printer.print(statement.formula)
            made.append(f"const double {printer.names[statement.name]} = {value};")
    return made, statuses


def _solution(
    statement: Solve,
    status: str,
    used: Set[str],
    solvers: Mapping[Solver, str],
    printer: Printer,
    space: TargetNames,
) -> Iterator[str]:
    """Yield the lines that solve a system, its status under a name, and give what is used one."""
    solution = space.claim("solution")
    given = [*map(printer.print, statement.arguments), solution]
    yield f"double {solution}[{len(statement.names)}];"
    yield f"const int {status} = {solvers[statement.solver]}({', '.join(given)});"
    for i, name in enumerate(statement.names):
        if name in used:
            yield f"const double {printer.names[name]} = {solution}[{i}];"
