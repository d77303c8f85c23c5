"""Ratios and forms of loads with friction in them, and their efficiency."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

from ..formula.tree import ZERO, Formula
from ..frozen import replace
from ..model.mechanism import Efficiency, Find, LoadForm, LoadRatio, Sense
from ..model.result import Result
from ..model.targets import SIGNS
from ..power.numbers import value_of
from ..power.speeds import magnitude
from .case import Case, case_of_loads, without_friction
from .closed_form import ClosedFormSolver, Named, closed_form, printed_form
from .efficiency import Drives
from .free_bodies import EquationsCoupled
from .iterated import exact, exact_case, first_order, first_order_case
from .linear import LinearSolver
from .naming import Sizes
from .normal_forces import LoadedPair, scaled
from .problem import Loaded, Problem
from .results import result_of
from .sequential import SequentialSolver
from .signs import AtAnyPose, Signs
from .solution import SolvedWithFriction

Of = LoadRatio | LoadForm


def load_with_friction(
    problem: Problem, find: Find, ideal: Result, of: Of, sense: Sense, order: str
) -> SolvedWithFriction | None:
    """Return a ratio or a form of loads with friction; None where an error was reported."""
    efficiency = problem.mechanism.friction.efficiency
    if efficiency is None:
        return by_coefficients(problem, find, ideal, of, sense, order)
    drives = Drives(ideal, sense, problem.plan)
    named = drives.with_constant(find.name, efficiency)
    return _solved(problem, find, ideal, (), named, drives.is_printed_as_driven)


def by_coefficients(
    problem: Problem, find: Find, ideal: Result, of: Of, sense: Sense, order: str = "exact"
) -> SolvedWithFriction | None:
    """Return the solution with friction alone, without efficiencies that are given."""
    case = case_of_loads(of, ideal, problem.equations)
    loaded = problem.loaded(find, case)
    if loaded is None:
        return None
    if order == "first":
        named = _to_first_order(problem, find, case, loaded, sense)
    else:
        once = partial(_exactly, problem, find, case, loaded, sense)
        named = problem.exact(ideal.name, sense, once)
    driven = Drives(ideal, sense, problem.plan).is_driven
    return _solved(problem, find, ideal, loaded, named, driven)


def _solved(
    problem: Problem,
    find: Find,
    ideal: Result,
    loaded: Loaded,
    named: Named,
    driven: bool | None,
) -> SolvedWithFriction:
    steps = named.case.steps if named.case else named.steps
    result = replace(result_of(problem, find, ideal, loaded, named), driven=driven)
    return SolvedWithFriction(result, steps=steps)


def efficiency(
    problem: Problem, find: Find, ideal: Result, asked: Efficiency
) -> SolvedWithFriction | None:
    """Return which part of the power arrives; None where an error was reported.

    None as well where a load has nothing but friction to overcome, as in a brake: no power is
    meant to arrive, so there is no part of it.
    """
    if ideal.formula == ZERO:
        return None
    whole = load_with_friction(problem, find, ideal, asked.of, asked.sense, "exact")
    if whole is None:
        return None
    drives = Drives(ideal, asked.sense, problem.plan)
    return SolvedWithFriction(drives.efficiency(whole.result, find.span))


# ----------------------------------------------------------------------------- formulas


def _to_first_order(
    problem: Problem, find: Find, case: Case, loaded: Loaded, sense: Sense
) -> Named:
    """Return the load with friction that ideal forces make."""
    ideal, sign, added = case.ideal, SIGNS[sense], scaled(loaded, case.factor)
    way = partial(first_order_case, find.name, ideal, added, sign)
    printed = problem.default.printed(way, problem.endings.of(ideal.name, sense))
    return replace(first_order(ideal.formula, added, sign, problem.mechanism), case=printed)


def _exactly(problem: Problem, find: Find, case: Case, loaded: Loaded, sense: Sense) -> Named:
    """Return the load in closed form, where there is one that stands at the default pose.

    Elsewhere, and where there is none, it is found by iteration.
    """
    ideal, sign = case.ideal, SIGNS[sense]
    endings, added = problem.endings.of(ideal.name, sense), scaled(loaded, case.factor)
    closed = in_closed_form(problem, case, loaded, sign, endings)
    problem.remark_on_pins(case, exact=closed is not None)
    sizes = problem.sizes(loaded, sign, endings)
    stands = partial(_stands, problem, find, ideal, loaded)
    if closed and stands(closed):
        return replace(closed, elsewhere=iterated(problem, ideal.formula, added, sizes))
    found = iterated(problem, ideal.formula, added, sizes)
    way = partial(exact_case, ideal.formula, added, sizes)
    found = replace(found, case=problem.default.printed(way, endings))
    if closed and not stands(found):
        return replace(closed, elsewhere=iterated(problem, ideal.formula, added, sizes))
    return found


def _stands(problem: Problem, find: Find, ideal: Result, loaded: Loaded, found: Named) -> bool:
    """Return whether a formula has a value at the default pose, as far as that has values.

    A closed form has none where friction turns a pressing force round: there it takes
    iteration. Neither has one where the drive jams.
    """
    result = result_of(problem, find, ideal, loaded, found)
    value = value_of(result, problem.default.values())
    return value is None or math.isfinite(value)


def in_closed_form(
    problem: Problem, case: Case, loaded: Loaded, sense: int, endings: Sequence[str]
) -> Named | None:
    """Return the first closed form that there is; None where the equations are coupled."""
    for way in ways(problem, case, loaded, sense):
        try:
            signs = AtAnyPose(problem.taken, problem.in_code, endings)
            found = closed_form(way, case.factor, signs)
        except EquationsCoupled:
            continue
        problem.in_code.note(found.where)
        printed = partial(printed_form, way, case.factor)
        return replace(found, case=problem.default.printed(printed, endings))
    return None


def ways(
    problem: Problem, case: Case, loaded: Loaded, sense: int
) -> Iterator[Callable[[Signs], ClosedFormSolver]]:
    """Yield the ways in which the driving load may be found in closed form."""
    yield lambda signs: SequentialSolver(problem.bodies(case, loaded, False), signs, sense)
    yield lambda signs: SequentialSolver(problem.bodies(case, loaded, True), signs, sense)
    ideal = without_friction(case, problem.equations)
    yield lambda signs: LinearSolver(case.driving, ideal, loaded, signs, sense)


def iterated(problem: Problem, ideal: Formula, loaded: Sequence[LoadedPair], sizes: Sizes) -> Named:
    """Return the load by Newton's method, whichever way the joints are pressed."""
    return exact(ideal, loaded, sizes, partial(magnitude, mechanism=problem.mechanism))
