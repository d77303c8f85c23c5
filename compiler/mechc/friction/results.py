"""Results with friction: ratios and forms of loads, efficiencies, and forces at joints."""

import math
from collections.abc import Iterator, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING

from ..base.frozen import on_demand, replace
from ..formula.tree import ZERO, Formula
from ..formula.walk import reached, symbols
from ..model.boxes import allowed_box, with_angles
from ..model.mechanism import (
    Efficiency,
    Find,
    ForceAtJoint,
    LoadForm,
    LoadRatio,
    Require,
    Sense,
)
from ..model.parts.targets import SIGNS
from ..model.result import Definition, DrivingLoad, FrictionResult, Result, SignCase
from ..power.definitions import bound_sums, intermediates, open_lengths
from ..power.joint_forces import has_direction
from ..power.magnitudes import magnitude
from ..power.numbers import is_zero, value_of
from ..power.reactions import Transmitted
from . import closed_forces, joint_forces, linear
from .chain_bodies import EquationsCoupled
from .closed_form import DefinedFormula, PrintedFormula, closed_form, printed_form
from .efficiency import Drives
from .friction_pairs import LoadedPair
from .iterated import exact, exact_case, first_order, first_order_case, step_of
from .naming import ForceSizes
from .normal_forces import scaled
from .problem import (
    FrictionProblem,
    IdealResult,
    LoadedPairs,
    case_of_force,
    case_of_loads,
    without_friction,
)
from .remarks import asks_for_loads
from .sequential import SequentialSolver
from .signs.at_any_pose import AtAnyPose
from .signs.conditions import signed_part
from .solution import SolvedWithFriction

if TYPE_CHECKING:
    from .closed_forces import AskedForce, MakeSolver


def result_of(
    problem: FrictionProblem, find: Find, ideal: Result, loaded: LoadedPairs, named: DefinedFormula
) -> FrictionResult:
    """Return the solution as a result, the one without friction being ``ideal``."""
    sums = problem.sums(loaded)
    return FrictionResult(
        find.name,
        find.target,
        ideal.dimension,
        named.formula,
        resting_on(problem, ideal, named.formula, (*sums, *named.where)),
        guards=(
            *(Require(c, ">", ZERO, find.span) for c in named.positive),
            *has_direction(named.formula, find.span),
        ),
        elsewhere=on_demand(partial(_elsewhere, problem, find, ideal, loaded, named)),
        case=_case(problem, find, ideal, named.case or _at_any_pose(named, sums, problem), sums),
        inside=named.inside,
    )


def _elsewhere(
    problem: FrictionProblem, find: Find, ideal: Result, loaded: LoadedPairs, named: DefinedFormula
) -> Result | None:
    """Return the result for elsewhere, if all the lengths in it are given."""
    if named.elsewhere is None:
        return None
    found = result_of(problem, find, ideal, loaded, named.elsewhere())
    missing = open_lengths(problem.plan, (found.formula, *(d.formula for d in found.where)))
    return None if missing else found


def _at_any_pose(
    named: DefinedFormula, sums: Sequence[Definition], problem: FrictionProblem
) -> PrintedFormula | None:
    """Return a formula with signs in it as it is printed: it holds where forces keep theirs.

    None where it takes nothing for granted, or finds forces by iteration.
    """
    return None if named.inside or not named.positive else _as_it_is(named, sums, problem)


def _as_it_is(
    named: DefinedFormula, sums: Sequence[Definition], problem: FrictionProblem
) -> PrintedFormula:
    """Return a formula of code as it is printed, with what it takes for granted."""
    box = with_angles(allowed_box(problem.mechanism), problem.plan.graph.pose.definitions)
    holds = tuple(dict.fromkeys(c for f in named.positive if (c := signed_part(f, box))))
    return PrintedFormula(named.formula, (*sums, *named.where), holds, (), named.positive)


def _case(
    problem: FrictionProblem,
    find: Find,
    ideal: Result,
    printed: PrintedFormula | None,
    sums: Sequence[Definition],
) -> SignCase | None:
    """Return the case of the default pose, with those of the sums that it rests on."""
    if printed is None:
        return None
    used = symbols(printed.formula, *(d.formula for d in printed.where))
    rests_on = reached(used, {d.name: d.formula for d in sums})
    own = (*(d for d in sums if d.name in rests_on), *printed.where)
    where = resting_on(problem, ideal, printed.formula, own)
    holds = (Require(f, o, ZERO, find.span) for f, o in printed.holds)
    guards = tuple(Require(c, ">", ZERO, find.span) for c in printed.positive)
    return SignCase(printed.formula, where, tuple(holds), guards)


def resting_on(
    problem: FrictionProblem, ideal: Result, formula: Formula, own: Sequence[Definition]
) -> tuple[Definition, ...]:
    """Return definitions with those that they rest on: of the pose, of weights."""
    used = symbols(formula, *(d.formula for d in own))
    weights = [Definition(n, f) for n, f in problem.valued.items() if n in used]
    known = [*weights, *intermediates(problem.plan.graph.pose, used), *ideal.where]
    return tuple({d.name: d for d in (*known, *own)}.values())


Of = LoadRatio | LoadForm


def load_with_friction(
    problem: FrictionProblem, find: Find, ideal: Result, of: Of, sense: Sense, order: str
) -> SolvedWithFriction | None:
    """Return a ratio or a form of loads with friction; None where an error was reported."""
    efficiency = problem.mechanism.friction.efficiency
    if efficiency is None:
        return by_coefficients(problem, find, ideal, of, sense, order)
    drives = Drives(ideal, sense, problem.plan)
    named = drives.with_constant(find.name, efficiency)
    return _solved(problem, find, ideal, (), named, drives.is_printed_as_driven)


def by_coefficients(
    problem: FrictionProblem, find: Find, ideal: Result, of: Of, sense: Sense, order: str = "exact"
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
    problem: FrictionProblem,
    find: Find,
    ideal: Result,
    loaded: LoadedPairs,
    named: DefinedFormula,
    driven: bool | None,
) -> SolvedWithFriction:
    """Return a result by its formula, with the steps of the case that is printed."""
    steps = named.case.steps if named.case else named.steps
    found = result_of(problem, find, ideal, loaded, named)
    result = replace(found, driven=driven, is_idle=is_zero(ideal, problem.plan.graph.pose))
    return SolvedWithFriction(result, steps=steps)


def efficiency(
    problem: FrictionProblem, find: Find, ideal: Result, asked: Efficiency
) -> SolvedWithFriction | None:
    """Return which part of the power arrives; None where an error was reported.

    None as well where a load has nothing but friction to overcome, as in a brake: no power is
    meant to arrive, so there is no part of it.
    """
    if is_zero(ideal, problem.plan.graph.pose):
        return None
    whole = load_with_friction(problem, find, ideal, asked.of, asked.sense, "exact")
    if whole is None:
        return None
    drives = Drives(ideal, asked.sense, problem.plan)
    return SolvedWithFriction(drives.efficiency(whole.result, find.span))


# ----------------------------------------------------------------------------- formulas


def _to_first_order(
    problem: FrictionProblem, find: Find, case: IdealResult, loaded: LoadedPairs, sense: Sense
) -> DefinedFormula:
    """Return the load with friction that ideal forces make."""
    ideal, sign, added = case.ideal, SIGNS[sense], scaled(loaded, case.factor)
    way = partial(first_order_case, find.name, ideal, added, sign)
    printed = problem.default.printed(way, problem.endings.of(ideal.name, sense))
    return replace(first_order(ideal.formula, added, sign, problem.mechanism), case=printed)


def _exactly(
    problem: FrictionProblem, find: Find, case: IdealResult, loaded: LoadedPairs, sense: Sense
) -> DefinedFormula:
    """Return the load in closed form, where there is one that stands at the default pose.

    Elsewhere, and where there is none, it is found by iteration. Where nothing presses a joint that
    has friction, it is the load without friction.
    """
    ideal, sign = case.ideal, SIGNS[sense]
    endings, added = problem.endings.of(ideal.name, sense), scaled(loaded, case.factor)
    closed = in_closed_form(problem, case, loaded, sign, endings) if loaded else None
    problem.remark_on_pins(case, exact=closed is not None)
    sizes = problem.sizes(loaded, sign, endings)
    stands = partial(_stands, problem, find, ideal, loaded)
    elsewhere = cache(lambda: iterated(problem, ideal.formula, added, sizes()))
    if closed and stands(closed):
        return replace(closed, elsewhere=elsewhere)
    found = elsewhere()
    way = partial(exact_case, ideal, loaded, case.factor, sizes())
    found = replace(found, case=problem.default.printed(way, endings))
    if closed and not stands(found):
        return replace(closed, elsewhere=elsewhere)
    return found


def _stands(
    problem: FrictionProblem, find: Find, ideal: Result, loaded: LoadedPairs, found: DefinedFormula
) -> bool:
    """Return whether a formula has a value at the default pose, as far as that has values.

    A closed form has none where friction turns a pressing force round: there it takes
    iteration. Neither has one where the drive jams.
    """
    result = result_of(problem, find, ideal, loaded, found)
    value = value_of(result, problem.default.values())
    return value is None or math.isfinite(value)


def in_closed_form(
    problem: FrictionProblem,
    case: IdealResult,
    loaded: LoadedPairs,
    sense: int,
    endings: Sequence[str],
) -> DefinedFormula | None:
    """Return the first closed form that there is; None where the equations are coupled."""
    for way in ways(problem, case, loaded, sense):
        try:
            signs = AtAnyPose(problem.taken, problem.in_code, endings)
            found = closed_form(way, case.factor, signs)
        except EquationsCoupled:
            continue
        problem.in_code.note(found.where)
        printed = problem.default.printed(partial(printed_form, way, case.factor), endings)
        if printed is None:
            free = problem.default.in_free_names(found, endings)
            renamed = free.where != found.where
            printed = _as_it_is(free, problem.sums(loaded), problem) if renamed else None
        return replace(found, case=printed)
    return None


def ways(
    problem: FrictionProblem, case: IdealResult, loaded: LoadedPairs, sense: int
) -> "Iterator[MakeSolver]":
    """Yield the ways in which the driving load may be found in closed form."""
    yield lambda signs: SequentialSolver(problem.bodies(case, loaded, False), signs, sense)
    yield lambda signs: SequentialSolver(problem.bodies(case, loaded, True), signs, sense)
    ideal = without_friction(case, problem.equations)
    yield lambda signs: linear.LinearSolver(case.driving, ideal, loaded, signs, sense)


def iterated(
    problem: FrictionProblem, ideal: Formula, loaded: Sequence[LoadedPair], sizes: ForceSizes
) -> DefinedFormula:
    """Return the load by Newton's method, whichever way the joints are pressed."""
    return exact(ideal, loaded, sizes, partial(magnitude, mechanism=problem.mechanism))


def force_with_friction(
    problem: FrictionProblem, find: Find, ideal: Result, force: ForceAtJoint, sense: Sense
) -> SolvedWithFriction | None:
    """Return a force at a joint; None where equilibrium leaves it open, or friction does."""
    case = case_of_force(problem.driving, ideal, problem.equations)
    loaded = problem.loaded(find, case)
    if loaded is None:
        return None
    endings = problem.endings.of_force(ideal.name, sense)
    if loaded and not asks_for_loads(problem.mechanism):
        closed = in_closed_form(problem, case, loaded, SIGNS[sense], endings)
        problem.remark_on_pins(case, exact=closed is not None)
    sizes = problem.sizes(loaded, SIGNS[sense], endings)()
    found = joint_forces.ForceWithFriction(force, problem.plan, problem.driving, loaded, sizes)
    if found.transmitted is None:
        return None
    asked = closed_forces.AskedForce(
        find.name, force, problem.plan.graph.pose, problem.driving, problem.drive(sense)
    )
    in_steps = _in_steps(problem, asked, found.transmitted, case, loaded, sense, endings)
    printed = in_steps or problem.default.printed(found.at_one_pose, endings)
    named = replace(found.at_any_pose(), case=printed)
    result = result_of(problem, find, replace(ideal, where=()), loaded, named)
    without = without_friction(case, problem.equations)
    load = iterated(problem, without.formula(), loaded, sizes).formula
    drive = DrivingLoad(without.formula(), load)
    known = resting_on(problem, ideal, drive.ideal, bound_sums(problem.plan, [without]))
    where = tuple(dict.fromkeys((*found.sums(), *known, *result.where)))
    is_idle = problem.is_idle(drive.ideal, known)
    steps = in_steps.steps if in_steps else (step_of(loaded),)
    return SolvedWithFriction(replace(result, where=where, drive=drive, is_idle=is_idle), steps)


def _in_steps(
    problem: FrictionProblem,
    asked: "AskedForce",
    transmitted: Transmitted,
    case: IdealResult,
    loaded: LoadedPairs,
    sense: Sense,
    endings: Sequence[str],
) -> PrintedFormula | None:
    """Return a force as it follows from bodies that are solved one after another, if it does."""
    for way in ways(problem, case, loaded, SIGNS[sense]) if loaded else ():
        by = partial(closed_forces.closed_force, asked, transmitted, way)
        printed = problem.default.printed(by, endings)
        if printed is not None:
            return printed if problem.default.balances(printed) else None
    return None
