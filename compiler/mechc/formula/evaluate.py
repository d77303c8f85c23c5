"""The value of a formula on floats, and the solutions of its systems."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, assert_never

from ..base.named import NamedTuple
from ..work import MOST_WORK, Allowance, at_most, spend
from . import derivative
from .choices import chosen
from .functions import FUNCTIONS
from .names import another
from .numeric import newton
from .numeric.straight_line import OFTEN, StraightLine, SystemSolver, in_order
from .tree import (
    Call,
    Constant,
    Formula,
    Implicit,
    Number,
    Pi,
    Power,
    Product,
    Sum,
    Symbol,
    System,
)
from .walk import substitute, symbols

if TYPE_CHECKING:
    from .numeric.elimination import Matrix
    from .numeric.newton import Bordered, Residuals, Way
    from .numeric.newton_status import NewtonStatus

SYSTEMS, SOLUTIONS = 256, 1024
"""Of so many systems the code is kept, of each so many solutions: several results share them."""


def evaluate(formula: Formula, values: Mapping[str, float]) -> float:
    """Return the value on floats; NaN where a function is not defined there.

    >>> from .tree import degrees
    >>> round(evaluate(Call("sin", (degrees(30),)), {}), 12)
    0.5
    """
    return SharedEvaluation(values).of(formula)


class SharedEvaluation:
    """Formulas on floats at one set of values: a part that several share is found once.

    Parts are known by their identity, as large formulas are put together of the same ones.
    Names may be added to ``values`` later on, but not change.
    """

    def __init__(self, values: Mapping[str, float]) -> None:
        self._values = values
        self._known: dict[int, float] = {}
        self._outer: dict[int, tuple[float, ...]] = {}
        self._alive: list[Formula] = []

    def of(self, formula: Formula) -> float:
        """Return the value of a formula; NaN where a function is not defined there."""
        self._alive.append(formula)
        before = len(self._known)
        try:
            return self._of(formula)
        except (ZeroDivisionError, ValueError, OverflowError):
            return math.nan
        finally:
            spend(1 + len(self._known) - before)

    def _of(self, formula: Formula) -> float:
        """Return the value of a formula, found once for each part."""
        match formula:
            case Constant(_, value):
                return self._of(value)
            case Symbol(name):
                return self._values[name]
            case Number(value):
                return value.numerator / value.denominator
            case Pi():
                return math.pi
        known = self._known.get(id(formula))
        if known is None:
            known = self._known[id(formula)] = self._compute(formula)
        return known

    def _compute(self, formula: Sum | Product | Power | Call | Implicit) -> float:
        match formula:
            case Sum(terms):
                return math.fsum(map(self._of, terms))
            case Product(factors):
                return math.prod(map(self._of, factors))
            case Power(base, exponent):
                result = self._of(base) ** self._of(exponent)
                return result if isinstance(result, float) else math.nan
            case Call("choose", arguments):
                part = chosen(arguments, self._of)
                return math.nan if part is None else self._of(part)
            case Call(function, arguments):
                return float(FUNCTIONS[function](*map(self._of, arguments)))
            case Implicit(system, index, arguments):
                return solution(system, self._of_a_system(arguments))[index]
            case _:
                assert_never(formula)

    def _of_a_system(self, arguments: tuple[Formula, ...]) -> tuple[float, ...]:
        """Return the values of what all unknowns of a system have as arguments, found once."""
        if id(arguments) not in self._outer:
            self._outer[id(arguments)] = tuple(map(self._of, arguments))
        return self._outer[id(arguments)]


# ------------------------------------------------------------------------- systems


def equations(formula: Implicit) -> tuple[Formula, ...]:
    """Return the left-hand sides of the equations, in the unknowns and the arguments."""
    names = (name for name, _ in formula.system.anchor)
    values = dict(zip(names, formula.arguments, strict=True))
    return tuple(substitute(e, values) for e in formula.system.equations)


def solution(system: System, outer: tuple[float, ...]) -> tuple[float, ...]:
    """Return the unknowns at values of the outer symbols; NaN where the branch ends."""
    return solver(system)(outer)


def status(formula: Implicit, values: Mapping[str, float]) -> "NewtonStatus":
    """Return how a solution was found, or why it was not; the work was counted as it was found."""
    here = SharedEvaluation(values)
    return _followed(formula.system)(tuple(map(here.of, formula.arguments))).status


def status_along(formula: Implicit) -> "Callable[[Mapping[str, float]], NewtonStatus]":
    """Return how solutions are found as a function of the names' values, for many of them."""
    names = sorted(symbols(formula))
    code, given = straight_line(formula.arguments, names), in_order(names)
    followed = _followed(formula.system)
    return lambda values: followed(tuple(code.at(given(values)))).status


def straight_line(
    formulas: Sequence[Formula],
    names: Sequence[str],
    definitions: Iterable[tuple[str, Formula]] = (),
    often: int = OFTEN,
) -> StraightLine:
    """Return formulas that are evaluated again and again, as functions of what has a name."""
    return StraightLine(formulas, names, solver, definitions, often)


@lru_cache(maxsize=SYSTEMS)
def solver(system: System) -> SystemSolver:
    """Return a system's unknowns as a function of the outer symbols' values."""
    followed = _followed(system)

    def unknowns(outer: tuple[float, ...]) -> tuple[float, ...]:
        status, found, work = followed(outer)
        spend(work)
        return found if status == 0 else (math.nan,) * len(found)

    return unknowns


class _Ended(NamedTuple):
    """Where a way ended, and the work that it took, which counts however often it is asked."""

    status: "NewtonStatus"
    unknowns: tuple[float, ...]
    work: int


@lru_cache(maxsize=SYSTEMS)
def _followed(system: System) -> Callable[[tuple[float, ...]], _Ended]:
    """Return the function that follows a system from its anchor, and counts the work each time."""
    with at_most(Allowance()) as allowance:
        way = way_of(system)
    ahead = MOST_WORK - allowance.left

    @lru_cache(maxsize=SOLUTIONS)
    def followed(outer: tuple[float, ...]) -> _Ended:
        outer = turned_back(system, outer)
        with at_most(Allowance()) as allowance:
            ended, found = way.follow(*beginning(system, outer), outer)
        return _Ended(ended, found, ahead + MOST_WORK - allowance.left)

    return followed


def way_of(system: System) -> "Way":
    """Return the values that are the same on all ways to a system's solutions."""
    scales = [newton.scale(value) for value in system.start]
    along = numeric_along(system) if system.by_arcs else None
    return newton.Way(numeric(system), side(system), scales, along)


def beginning(system: System, outer: Sequence[float]) -> tuple[list[float], list[float]]:
    """Return the values of outer symbols and unknowns where the way begins."""
    pairs = zip(system.anchor, outer, strict=True)
    anchor = {name: end if value is None else value for (name, value), end in pairs}
    return list(anchor.values()), [anchor[s] if isinstance(s, str) else s for s in system.start]


def turned_back(system: System, outer: tuple[float, ...]) -> tuple[float, ...]:
    """Return values of outer symbols, those that are known but for turns nearest to the anchor."""
    if not system.turning:
        return outer
    return tuple(
        newton.nearest(value, anchor) if name in system.turning and anchor is not None else value
        for (name, anchor), value in zip(system.anchor, outer, strict=True)
    )


def side(system: System) -> int:
    """Return the sign of the Jacobian's determinant where the way begins.

    It does not depend on what stays the same along it.
    """
    anchor, start = beginning(system, (0.0,) * len(system.anchor))
    return newton.side_of(numeric(system), start, anchor)


@lru_cache(maxsize=SYSTEMS)
def numeric(system: System) -> "Residuals":
    """Return residuals and Jacobian as a function of floats."""
    rows = derivative.jacobian(system.equations, system.unknowns)
    read = _on_floats(system.equations, rows, [*system.unknowns, *(n for n, _ in system.anchor)])

    def at(unknowns: Sequence[float], outer: Sequence[float]) -> "tuple[list[float], Matrix]":
        return read((*unknowns, *outer))

    return at


@lru_cache(maxsize=SYSTEMS)
def numeric_along(system: System) -> "Bordered":
    """Return residuals and their slopes, by the unknowns and by a share of the way, on floats."""
    steps = changes(system)
    outer_names = [name for name, _ in system.anchor]
    by_unknowns = derivative.jacobian(system.equations, system.unknowns)
    by_way = derivative.along(system.equations, {n: Symbol(step) for n, step in steps.items()})
    rows = [(*row, last) for row, last in zip(by_unknowns, by_way, strict=True)]
    read = _on_floats(system.equations, rows, [*system.unknowns, *outer_names, *steps.values()])
    changing = [outer_names.index(name) for name in steps]

    def at(
        unknowns: Sequence[float], outer: Sequence[float], by: Sequence[float]
    ) -> "tuple[list[float], Matrix]":
        return read((*unknowns, *outer, *(by[place] for place in changing)))

    return at


def _on_floats(
    equations: Sequence[Formula], rows: Sequence[Sequence[Formula]], names: Sequence[str]
) -> "Callable[[Sequence[float]], tuple[list[float], Matrix]]":
    """Return the values of equations, and of a row of slopes for each, by the values of names."""
    code = straight_line([*equations, *(entry for row in rows for entry in row)], names)
    size, width = len(equations), len(rows[0])
    starts = range(size, size * (width + 1), width)

    def at(values: Sequence[float]) -> "tuple[list[float], Matrix]":
        found = code.at(values)
        return found[:size], [found[start : start + width] for start in starts]

    return at


def changes(system: System) -> dict[str, str]:
    """Return the outer symbols that change on the way, with names for by how much they do."""
    taken = {*system.unknowns, *(name for name, _ in system.anchor)}
    found = {}
    for name, _ in (pair for pair in system.anchor if pair[1] is not None):
        wanted = f"{name}_change"
        while wanted in taken:
            wanted = another(wanted)
        found[name] = wanted
        taken.add(wanted)
    return found
