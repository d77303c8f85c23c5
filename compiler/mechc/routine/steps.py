"""The straight-line program: what every target emits and the interpreter runs.

Language-neutral: SI units and radians, names from the drawing (each target renames
what its language forbids). Each step's formula mentions inputs and earlier steps
only. Parts that occur twice are steps of their own. The number of steps grows
linearly with the mechanism.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Literal, TypeVar

from ..base.frozen import frozen, replace
from ..formula.tree import Formula
from ..formula.walk import constants, symbols
from ..model.mechanism import Mechanism, Require
from ..model.result import DrivingLoad
from ..units import ANGLE, LENGTH, Dimension
from .statuses import JAMMED, LOCKED, NOT_FOUND

if TYPE_CHECKING:
    from ..pose.motion import MotionQuantity


@frozen
class Input:
    """A free parameter: its unit as the user writes it, default, range and tolerance in SI."""

    name: str
    dimension: Dimension
    unit: str = ""
    default: float | None = None
    low: float | None = None
    high: float | None = None
    label: str = ""
    tolerance: float | None = None


@frozen
class Step:
    """``name = formula``."""

    name: str
    formula: Formula


@frozen
class ByArcs:
    """What a branch is followed by its arc length with, besides a solver's own.

    ``changes`` name by how much outer symbols change on the whole way, those at these places;
    ``slopes`` are those of the residuals by the share of the way. They mention ``steps`` of their
    own, too.
    """

    changes: tuple[tuple[int, str], ...]
    steps: tuple[Step, ...]
    slopes: tuple[Formula, ...]


NO_ARCS = ByArcs((), (), ())


@frozen
class Solver:
    """A system in straight lines: what Newton's method needs at each correction.

    ``equations`` are for the reader. ``residuals`` have the values of their left sides, the rows
    of ``jacobian`` these sides' slopes by the unknowns, and ``steps`` are what all share;
    they mention unknowns, outer symbols and earlier steps only. ``anchor`` and ``start``
    are the values of outer symbols and unknowns where the way begins, as those of a
    :class:`~mechc.formula.tree.System`; ``side`` is the Jacobian's sign there. The method is that
    of :mod:`mechc.formula.numeric.newton`, with ``by_arcs`` that of
    :mod:`mechc.formula.numeric.arcs` besides. ``turning`` are outer symbols that are brought
    nearest to their anchors by whole turns.
    """

    unknowns: tuple[str, ...]
    outer: tuple[str, ...]
    equations: tuple[Formula, ...]
    start: tuple[float | str, ...]
    anchor: tuple[float | None, ...]
    side: int
    steps: tuple[Step, ...]
    residuals: tuple[Formula, ...]
    jacobian: tuple[tuple[Formula, ...], ...]
    by_arcs: ByArcs | None = None
    turning: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names in its formulas."""
        arcs = self.by_arcs or NO_ARCS
        changes = (name for _, name in arcs.changes)
        steps = (step.name for step in (*self.steps, *arcs.steps))
        return (*self.unknowns, *self.outer, *changes, *steps)

    @property
    def computed(self) -> tuple[Formula, ...]:
        """Return the formulas that one correction computes."""
        slopes = (entry for row in self.jacobian for entry in row)
        return (*(step.formula for step in self.steps), *self.residuals, *slopes)


@frozen
class Solve:
    """``names = the solver's unknowns`` where its outer symbols have the values ``arguments``.

    All are NaN where the branch ends or corrections run out.
    """

    names: tuple[str, ...]
    arguments: tuple[Formula, ...]
    solver: Solver


ProgramStatement = Step | Solve

S = TypeVar("S", bound=Step | Solve)


def names_of(statement: ProgramStatement) -> tuple[str, ...]:
    """Return the names that a statement gives values to."""
    return statement.names if isinstance(statement, Solve) else (statement.name,)


def formulas_of(statement: ProgramStatement) -> tuple[Formula, ...]:
    """Return the formulas that a statement computes from names outside it."""
    return statement.arguments if isinstance(statement, Solve) else (statement.formula,)


def mentioned(statements: Iterable[ProgramStatement], others: Iterable[Formula]) -> frozenset[str]:
    """Return the names that statements and other formulas use."""
    return names_in([*(f for s in statements for f in formulas_of(s)), *others])


def names_in(formulas: Sequence[Formula]) -> frozenset[str]:
    """Return the names in formulas, those of numbers among them, which conditions have as such."""
    return frozenset(c.name for c in constants(formulas)).union(*map(symbols, formulas))


def leading_to(names: Iterable[str], statements: Sequence[S]) -> tuple[S, ...]:
    """Return those of the statements that names rest on, in their order."""
    needed, kept = set(names), list[S]()
    for statement in reversed(statements):
        if not needed.isdisjoint(names_of(statement)):
            kept.append(statement)
            needed |= names_in(formulas_of(statement))
    return tuple(kept[::-1])


@frozen
class Guard:
    """A ``require``: where ``left OP right`` is false, the output is NaN.

    ``loop`` names the loop that does not close there, if it is that, and ``balance`` the result
    whose loads do not balance there as its formula takes for granted, or, of a ``direction``, whose
    force is zero there.
    """

    left: Formula
    operator: Literal["<", "<=", ">", ">=", "=", "!="]
    right: Formula
    loop: str = ""
    balance: str = ""
    direction: bool = False


def sides_of(guards: Iterable[Guard]) -> Iterator[Formula]:
    """Yield what conditions compare, two formulas for each."""
    return (side for guard in guards for side in (guard.left, guard.right))


@frozen
class ResultStatus:
    """Whether a result with friction moves what it drives: how code distinguishes its poses.

    ``drive`` is the function of the same without friction, or, of a force at a joint, the load
    that drives, ``sense`` 1 where the motion is that along the drive's arrow, else -1. ``steps``
    solve for the pressing forces, and where ``guards`` fail there is no pose. The numbers are
    those of :data:`~.statuses.STATUSES`. A load that ``is_idle`` has friction alone to overcome: it
    drives either way, and no motion needs one against it.
    """

    name: str
    drive: str | DrivingLoad
    sense: int
    inputs: tuple[Input, ...]
    steps: tuple[ProgramStatement, ...]
    guards: tuple[Guard, ...]
    is_idle: bool = False

    @property
    def sides(self) -> tuple[Formula, ...]:
        """Return the formulas in terms of the steps."""
        compared = sides_of(self.guards)
        return (*compared, *(self.drive if isinstance(self.drive, DrivingLoad) else ()))

    @property
    def way(self) -> str:
        """Return how an idle load compares with 0 where it drives the motion."""
        return ">=" if self.sense > 0 else "<="

    @property
    def standstill(self) -> tuple[int, int]:
        """Return the codes where nothing moves: with the ideal result positive, and negative.

        Of an idle load: where it would be against the motion, and where nothing balances.
        """
        if self.is_idle:
            return NOT_FOUND, JAMMED
        return (JAMMED, LOCKED) if self.sense > 0 else (LOCKED, JAMMED)


NO_LOAD = 1e-30
"""Below this, in units of the SI, there is no load: what remains of it is rounding."""


@frozen
class Common:
    """The computation that many functions share.

    ``outputs`` are the names that they, or others of these, mention. Its ``steps`` may rest on
    the outputs of the one ``before``, which takes some of the same inputs. A ``number`` tells
    such programs apart.
    """

    number: int
    inputs: tuple[Input, ...]
    steps: tuple[ProgramStatement, ...]
    outputs: tuple[str, ...]
    before: "Common | None" = None


@frozen
class Function:
    """One result: inputs in declared order, only those it depends on.

    ``formula`` is the result as a reader sees it, with ``where`` defining the named
    intermediates it mentions, in order; where it is a case, it ``holds`` under conditions,
    and ``iterated`` are names that a system defines. ``steps`` compute the same, shared parts once,
    and ``output`` is the formula of the last line (usually one symbol or a short
    product). ``operations`` counts ``steps`` and ``output``, one correction of each solver.
    The steps may be those of a ``common`` program, handed out by one function for many, and
    behind them its ``own``; then ``others`` are the results that ``formula`` and ``where``
    mention. Where the value is NaN,
    the result is that of ``otherwise``, which takes some of the same inputs. ``units`` are those of
    the SI of what ``where`` has as a number.
    """

    name: str
    title: str
    inputs: tuple[Input, ...]
    guards: tuple[Guard, ...]
    steps: tuple[ProgramStatement, ...]
    output: Formula
    formula: Formula
    where: tuple[Step, ...]
    dimension: Dimension
    operations: int
    holds: tuple[Guard, ...] = ()
    iterated: tuple[str, ...] = ()
    common: Common | None = None
    own: tuple[ProgramStatement, ...] = ()
    others: tuple[str, ...] = ()
    otherwise: "Function | None" = None
    status: ResultStatus | None = None
    units: Mapping[str, str] = MappingProxyType({})


@frozen
class PoseProgram:
    """The angles and lengths found by loops that results rest on, together.

    ``outputs`` are their names in the order of the results, each defined by ``steps``. Those
    that are ``closed`` have values wherever the loops close.
    """

    inputs: tuple[Input, ...]
    steps: tuple[ProgramStatement, ...]
    outputs: tuple[str, ...]
    closed: tuple[str, ...]


@frozen
class PointsProgram:
    """Coordinates of points, directions of links and their rates: a program, and what each is.

    The outputs of the program are the names of the ``quantities``.
    """

    program: PoseProgram
    quantities: "tuple[MotionQuantity, ...]"


@frozen
class Checks:
    """The conditions of a calculation sheet, together: which is the first that fails.

    ``steps`` compute what the ``guards`` compare. The status is 0 where all hold, else the
    number of the first that does not.
    """

    inputs: tuple[Input, ...]
    steps: tuple[ProgramStatement, ...]
    guards: tuple[Guard, ...]


def every(functions: Iterable[Function]) -> Iterator[Function]:
    """Yield functions, each behind the one that it calls where it gives no number itself."""
    for function in functions:
        if function.otherwise:
            yield function.otherwise
        yield function


@frozen
class Routine:
    """All functions of one mechanism.

    ``pose`` is None where loops find nothing, ``points`` where there is no drive; ``checks`` are
    those of a calculation sheet that has conditions. ``unchecked`` are the conditions of use that
    no function checks.
    """

    name: str
    title: str
    source: str
    functions: tuple[Function, ...]
    pose: PoseProgram | None = None
    points: PointsProgram | None = None
    checks: Checks | None = None
    unchecked: tuple[Require, ...] = ()


Program = Common | Function | PoseProgram | Checks
"""What is written out with inputs and steps of its own."""


def programs(routine: Routine) -> list[Program]:
    """Return all that is written out: what functions have in common first, and once.

    A function that takes what is common has its own steps only.
    """
    listed = list(every(routine.functions))
    common = {f.common.number: f.common for f in listed if f.common}
    others = (replace(f, steps=f.own) if f.common else f for f in listed)
    poses = (routine.pose, routine.points.program if routine.points else None)
    return [
        *(common[n] for n in sorted(common)),
        *others,
        *(part for part in (*poses, routine.checks) if part),
    ]


def inputs_of(routine: Routine) -> tuple[Input, ...]:
    """Return the inputs of a routine: of its programs, each once, and of statuses besides.

    A force that nothing makes is 0 whatever the loads are; whether the drive moves is not.
    """
    statuses = (f.status for f in every(routine.functions) if f.status)
    parts = (*programs(routine), *statuses)
    return tuple({item.name: item for part in parts for item in part.inputs}.values())


def closed_dimensions(pose: PoseProgram, mechanism: Mechanism) -> dict[str, Dimension]:
    """Return the dimension of each output: a parameter's own, else a length or an angle."""
    own = {p.name: p.dimension for p in mechanism.parameters}
    return {n: own.get(n, LENGTH if n.startswith("len_") else ANGLE) for n in pose.outputs}
