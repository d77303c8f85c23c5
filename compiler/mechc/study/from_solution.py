"""What follows from a result: zeros and poles, proportions, symmetries, trends, derivatives."""

from collections.abc import Callable, Mapping, Sequence, Set
from functools import cache, partial
from itertools import combinations
from math import isclose, isfinite

from ..algebra.derivative import depends_openly, derivative
from ..algebra.equality import equal
from ..algebra.factors import ConstantSymbol, Length
from ..algebra.product import Product
from ..algebra.sums import add
from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics import friction as messages
from ..formula.evaluate import evaluate
from ..formula.numeric.rounding import Rounded, Rounding
from ..formula.tree import Call, Formula, Symbol, is_call
from ..formula.walk import substitute, symbols
from ..friction import at_rest
from ..friction.solution import FrictionSolution, SolvedWithFriction
from ..model.boxes import range_box
from ..model.dependence import in_geometry
from ..model.mechanism import Efficiency, LoadForm, LoadRatio, Mechanism, WithFriction
from ..model.result import Definition, Result
from ..model.values import Values, holds, usual_units
from ..pose.pose import Pose
from ..power.balance import AlgebraicResult, Balance
from ..power.definitions import resting_on
from ..power.numbers import DefaultNumbers
from ..units import LENGTH
from ..work import Allowance, WorkLimitError, most_of_what_is_left, within_part
from . import locking, ratios
from .analysis import Analysis, ClaimScope, NumericSlope, Trend, as_printed
from .locking_intervals import Locking
from .tolerances import PRINTED_ROUNDING, SAME_RATIO
from .trends import trend
from .variables import with_range
from .zeros import breaks, limits

MOST_PARAMETERS = 16
"""A result of more parameters than this is given without swaps, trends and derivatives.

Their number grows with the square of the parameters', and nobody reads them then.
"""


DEEP = 24
"""A result in which more angles of loops than this move is given without its slope.

Each loop's rate rests on the one before, so that the formula of the slope nests as deep.
"""


def analyse(solution: FrictionSolution, report: Report) -> tuple[Analysis, ...]:
    """Return the results with what follows from each.

    W261 names those of which it is not looked at where friction locks them: it takes too much.
    """
    numbers, study = DefaultNumbers(solution.plan), cache(partial(_study, solution))
    part = most_of_what_is_left()  # along ranges friction is solved anew at each place of each
    analyses: list[Analysis] = []
    for item in solution.solved:
        try:
            analyses.append(_concluded(item, solution, numbers, study, part))
        except WorkLimitError:
            if part.left >= 0:
                raise
            analyses.append(as_printed(item.result))
            finds = solution.plan.graph.pose.mechanism.finds
            span = next(f.span for f in finds if f.name == item.result.name)
            report.add(messages.ranges_not_looked_at(span, item.result.name))
    return tuple(analyses)


def _study(solution: FrictionSolution) -> "ratios.FrictionStudy":
    return ratios.FrictionStudy(solution)


def _concluded(
    item: AlgebraicResult | SolvedWithFriction,
    solution: FrictionSolution,
    numbers: DefaultNumbers,
    study: "Callable[[], ratios.FrictionStudy]",
    part: Allowance,
) -> Analysis:
    """Return a result with what is known of it: zeros, poles, breaks, trends."""
    balance, values = solution.balance, numbers.values
    if isinstance(item, SolvedWithFriction) or item.value is None:
        with within_part(part):
            found = _with_friction(item.result, balance, study)
            return replace(found, fails_here=fails_here(found, values))
    pose = balance.plan.graph.pose
    where = resting_on(balance.plan, item.value.formula(), [item.value])
    zero, infinite = limits(item, balance, values)
    result = replace(
        as_printed(item.result),
        zeros=zero,
        poles=infinite,
        breaks=breaks((*where, *(Definition(*d) for d in pose.put_in)), values),
        proportional=_proportional(item.value, item.result),
        independent=_independent(item.result, pose.mechanism),
    )
    return _with_trends(result, item.value, pose, numbers)


def _with_trends(result: Analysis, value: Product, pose: Pose, numbers: DefaultNumbers) -> Analysis:
    """Return a result with how it depends on its parameters, of which there may not be too many.

    Where it rests on definitions that is seen along the stroke alone.
    """
    mechanism, used = pose.mechanism, symbols(result.formula)
    names = [p.name for p in mechanism.parameters if p.name in used]
    if len(names) > MOST_PARAMETERS or not depends_openly(value):
        return result
    if result.where:
        return _sloping(result, _along_the_stroke(value, result, pose), mechanism, numbers)
    slopes = {name: derivative(value, name) for name in names}
    box = range_box(mechanism)
    trends: dict[str, Trend] = {name: trend(value, slopes[name], name, box) for name in names}
    swaps, scopes = _swaps(result.formula, mechanism, names), _scopes(mechanism, result, names)
    result = replace(result, swaps=swaps, trends=trends, scopes=scopes)
    partial_ones = {name: slope.formula() for name, slope in slopes.items()}
    return _sloping(result, partial_ones, mechanism, numbers)


def _scopes(mechanism: Mechanism, result: Analysis, names: list[str]) -> dict[str, ClaimScope]:
    """Return for which values each trend holds: a factor's own value has no part in the others."""
    ranged, given = with_range(mechanism), {p.name for p in mechanism.parameters if p.value}
    fixed = given - ranged
    return {name: _scope(name, ranged, fixed, result, names) for name in names}


def _scope(
    name: str, ranged: Set[str], fixed: Set[str], result: Analysis, names: list[str]
) -> ClaimScope:
    """Return for which values a trend along a parameter is proved."""
    if name in fixed:
        return "as given"
    rest = {n for n in names if n != name and n not in (result.proportional or {})}
    in_ranges = not ranged.isdisjoint({name, *rest})
    if fixed.isdisjoint(rest):
        return "ranges" if in_ranges else "always"
    return "ranges, rest as given" if in_ranges else "rest as given"


def _sloping(
    result: Analysis,
    derivatives: Mapping[str, Formula] | None,
    mechanism: Mechanism,
    numbers: DefaultNumbers,
) -> Analysis:
    """Return a result with its derivatives and their values at the default pose."""
    slopes: dict[str, NumericSlope] = {}
    for name, formula in (derivatives or {}).items():
        size = numbers.of(replace(result, formula=formula)).number
        if size is not None and isfinite(size):
            dimension = result.dimension.over(mechanism.parameter(name).dimension)
            unit = usual_units(mechanism).length if dimension == LENGTH else ""
            slopes[name] = NumericSlope(size, dimension, unit)
    return replace(result, derivatives=derivatives, slopes=slopes)


def _with_friction(
    result: Result, balance: Balance, study: "Callable[[], ratios.FrictionStudy]"
) -> Analysis:
    """Return a result as it is printed, with where the mechanism moves at all.

    Where a slip is 0 for once at the default pose that is said along what moves it alone: whatever
    else changes, friction has no sense there.
    """
    pose, printed = balance.plan.graph.pose, as_printed(result)
    only = at_rest.movers(result, pose) if result.sides else None
    if pose.mechanism.friction.efficiency is not None:
        return printed
    match result.target:
        case WithFriction(of=LoadRatio() | LoadForm(), order="exact"):
            found = locking.locking(study(), result, printed)
            return replace(
                printed, locking=found if only is None or not found else _along(only, found)
            )
        case Efficiency():
            ranges = ratios.efficiency_ranges(study(), result)
            shown = tuple(one for one in ranges if only is None or one.parameter in only)
            return replace(printed, efficiency_ranges=shown)
        case _:
            return printed


def _along(only: Set[str], found: Locking) -> Locking:
    """Return where nothing moves along parameters, without what is so at the default pose."""
    reaches = tuple(reach for reach in found.reaches if reach.parameter in only)
    return replace(found, state=None, reaches=reaches)


def _along_the_stroke(value: Product, result: Analysis, pose: Pose) -> Mapping[str, Formula] | None:
    """Return the derivative by the drive, through all loops; None where a rate is not known.

    None, too, where the formula would be too deep. It rests on what the result rests on.
    """
    drive = pose.mechanism.drive
    moving = {d.name for d in pose.definitions} & symbols(value.formula())
    if drive is None or len(moving) > DEEP or not moving <= pose.rates.keys():
        return None
    direct = [derivative(value, drive.parameter)]
    slope = add([*direct, *(derivative(value, n) * pose.rates[n] for n in sorted(moving))])
    return {drive.parameter: _put_in(result.where, slope.formula(), pose)}


def _put_in(where: Sequence[Definition], formula: Formula, pose: Pose) -> Formula:
    """Return a formula in which all that loops find, but for what is defined, is put in.

    A rate may rest on a length to which a slot gives a name of its own, P₅A₄ = −A₄P₅. Each
    definition rests on those before it alone, so that this ends.
    """
    known = {d.name for d in where}
    found = {d.name: d.formula for d in pose.definitions if d.name not in known}
    while not symbols(formula).isdisjoint(found):
        formula = substitute(formula, found)
    return formula


def _proportional(value: Product, result: Result) -> Mapping[str, int]:
    """Return the powers of parameters that occur nowhere but as a factor.

    One that an intermediate angle depends on, too, is in no simple proportion, nor is what loops
    find: nothing else stays as it is where that changes.
    """
    lengths = {f: e for f, e in value.factors.items() if isinstance(f, Length)}
    factors = {f.name: e for f, e in lengths.items() if not isinstance(f, ConstantSymbol)}
    rest = Product(1, {f: e for f, e in value.factors.items() if not isinstance(f, Length)})
    inside = symbols(rest.formula()).union(*(symbols(d.formula) for d in result.where))
    inside |= {d.name for d in result.where}
    return {name: e for name, e in factors.items() if name not in inside}


def _independent(result: Result, mechanism: Mechanism) -> tuple[str, ...]:
    """Return the parameters of the geometry that a result does not depend on.

    Of others, a pressure or a mass, nobody expects that it does.
    """
    used = {s for f in (result.formula, *(d.formula for d in result.where)) for s in symbols(f)}
    used |= {
        s for p in mechanism.parameters if p.name in used and p.value for s in symbols(p.value)
    }
    others = in_geometry(mechanism) - used - mechanism.friction.parameters
    return tuple(p.name for p in mechanism.parameters if p.name in others and not p.dependent)


def _swaps(formula: Formula, mechanism: Mechanism, names: list[str]) -> tuple[tuple[str, str], ...]:
    """Return the pairs of parameters that may change places."""
    kinds = {p.name: p.dimension for p in mechanism.parameters}
    return tuple(
        (a, b)
        for a, b in combinations(names, 2)
        if kinds[a] == kinds[b]
        and _agree_at_a_pose(formula, a, b)
        and equal(formula, substitute(formula, {a: Symbol(b), b: Symbol(a)}))
    )


def _agree_at_a_pose(formula: Formula, a: str, b: str) -> bool:
    """Return whether two names may be exchanged at one pose: most may not, which saves a proof."""
    names = sorted(symbols(formula))
    values = {name: 0.3 + 0.61803 * i % 0.7 for i, name in enumerate(names)}
    here = evaluate(formula, values)
    there = evaluate(formula, {**values, a: values[b], b: values[a]})
    return not abs(here - there) > SAME_RATIO * (abs(here) + abs(there))


# --------------------------------------------------------------------------------- printed formulas


def fails_here(result: Analysis, values: Values) -> bool:
    """Return whether the value of a result is not what its formula comes to, as it is printed.

    Friction alone may make the force in a rod that bears nothing without it: the sign of its
    force is that of 0 on paper, and one by which all forces balance in code.
    """
    if result.default is None or not isinstance(result.target, WithFriction | Efficiency):
        return False
    if result.sides:
        return False
    if not result.guards and not any(is_call(d.formula, "sign") for d in result.where):
        return False
    rounding = Rounding(values)
    for name, formula in result.where:
        if name not in rounding.values and symbols(formula) <= rounding.values.keys():
            rounding.values[name] = _on_paper(formula, rounding)
    known = {name: found.value for name, found in rounding.values.items()}
    if not all(holds(guard, known) for guard in result.guards):
        return result.default != 0 or not rounding.of(result.formula).is_zero
    if not symbols(result.formula) <= known.keys():
        return False
    value = evaluate(result.formula, known)
    return isfinite(value) and not isclose(
        value, result.default, rel_tol=PRINTED_ROUNDING, abs_tol=PRINTED_ROUNDING**2
    )


def _on_paper(formula: Formula, rounding: Rounding) -> Rounded:
    """Return the value of a definition: 0 of the sign of what is zero but for rounding."""
    match formula:
        case Call("sign", (inner,)) if rounding.of(inner).is_zero:
            return Rounded(0.0, 0.0)
        case _:
            return rounding.of(formula)
