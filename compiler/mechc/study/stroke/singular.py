"""Singular poses: where a ratio of loads is zero or infinite, and what stands still there."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from functools import partial
from itertools import pairwise
from typing import Literal

from ...formula.evaluate import evaluate
from ...formula.numeric.roots import RealFunction, Root, lowest, roots, spaced
from ...formula.tree import Formula, degrees, number, product, total
from ...formula.walk import symbols
from ..analysis import Analysis, Break, Vanishing
from ..sweep import Sweep
from ..tolerances import (
    BEYOND_BRANCH_POINT,
    BRANCH_POINT,
    DIFFERENCE,
    NEARBY,
    NOTHING_AT_END,
    SAME_EXPONENT,
    SAME_VALUE,
    SIDE,
    STEADY,
    VARYING_EXPONENT,
)
from .jumps import PLACES, jumping, jumps_along
from .rounded import each_zero_once, is_nothing, is_zero
from .run import StrokeRun
from .stroke import ChangePoint, Singular, StrokeInterval

LimitValue = Literal["0", "infinite"]

Order = Literal["0", "infinite", "finite", "jump"]
"""What a result does at a value; ``jump``: it is finite on either side, but not the same."""

OrderAt = Callable[[float, Sequence[float]], Order | None]
"""Returns what a result does at a value, as it is seen at some parts of the stroke from there."""


def singular_along(
    run: StrokeRun,
    stretches: Sequence[StrokeInterval],
    branches: Sequence[ChangePoint],
    turns: Sequence[float] = (),
) -> tuple[Singular, ...]:
    """Return singular poses of ratios of loads and speeds, zeros of forces, jumps by friction.

    Of loads poles are among them, and those that friction makes to first order.

    Friction turns round at ``turns``. Where a force at a joint is zero its sense changes: a rod is
    in compression, then in tension.
    """
    found = [
        *_found_on(stretches, run.quotients, run, _of_ratio),
        *_found_on(stretches, (*run.forms, *run.signed), run, _zeros_of),
        *_found_on(stretches, (*run.forms, *run.first_order), run, _poles_of),
    ]
    places = (one.drive for one in found if one.kind == "jump" or one.value != "undetermined")
    found += jumps_along(run, stretches, (*turns, *places))
    orders = {r.name: partial(order_of, run, r) for r in run.results}
    return distinguished(each_zero_once(found, run), branches, run.range, orders)


def _found_on(
    stretches: Sequence[StrokeInterval],
    results: Sequence[Analysis],
    run: StrokeRun,
    find: Callable[[Analysis, StrokeRun, StrokeInterval], Iterator[Singular]],
) -> Iterator[Singular]:
    """Yield the singular poses of results on stretches, of those that are not zero throughout."""
    for stretch in stretches:
        for result in results:
            if not is_zero(result, run.along, stretch):
                yield from find(result, run, stretch)


def _of_ratio(ratio: Analysis, run: StrokeRun, stretch: StrokeInterval) -> Iterator[Singular]:
    """Yield the poses in which a ratio is zero, infinite or undetermined."""
    return singular_poses(ratio, run.drive.name, run.along, stretch, run.within(stretch))


def _zeros_of(force: Analysis, run: StrokeRun, stretch: StrokeInterval) -> Iterator[Singular]:
    """Yield where the other forces balance without one."""
    size = run.along.function(force.formula, force)
    for root in _other_zeros(size, run.within(stretch), []):
        yield Singular(force.name, "0", "other", *root, None)


def _poles_of(force: Analysis, run: StrokeRun, stretch: StrokeInterval) -> Iterator[Singular]:
    """Yield where a load is infinite, or friction to first order makes a result so.

    What is infinite without friction is stated without it.
    """
    ideal = [r for r in run.results if r.target == getattr(force.target, "of", None)]
    size = run.along.function(force.formula, force)
    for x in peaks(size, run.within(stretch)):
        orders = [order_of(run, one, x) for one in (force, *ideal)]
        if orders[0] == "infinite" and "infinite" not in orders[1:]:
            yield Singular(force.name, "infinite", "other", x, math.ulp(x), None)


def peaks(function: RealFunction, grid: Sequence[float]) -> Iterator[float]:
    """Yield where the size of a function is greatest between values, which may be a pole.

    >>> [round(x, 9) for x in peaks(lambda x: 3 - abs(x - 1.3), [0.0, 1.0, 2.0, 3.0, 4.0])]
    [1.3]
    """

    def size(x: float) -> float:
        value = abs(function(x))
        return math.inf if math.isnan(value) else value

    values = [*map(size, grid)]
    for i in range(1, len(grid) - 1):
        before, here, after = values[i - 1 : i + 2]
        if before < here >= after and max(before, after) < math.inf:
            yield lowest(lambda x: -size(x), grid[i - 1], grid[i + 1])


def order_of(
    run: StrokeRun, result: Analysis, x: float, parts: Sequence[float] = NEARBY
) -> Order | None:
    """Return the order of a result at a value of the drive: zero, infinite, finite or a jump."""
    size = run.values(result.formula, result)
    found, step = order_at(size, x, run.range, parts), SIDE * run.range
    if found == "jump":
        sides = {side: size(side) for side in (x - step, x + step)}
        if is_nothing(sides, result, run.along, spaced(run.low, run.high, PLACES)):
            return "finite"
    return found


def singular_poses(
    result: Analysis, drive: str, along: Sweep, stretch: StrokeInterval, grid: Sequence[float]
) -> Iterator[Singular]:
    """Yield where on a stretch a ratio of loads is zero, infinite or undetermined, or jumps.

    First come the zeros and poles of its factors, then the zeros of sums that have none, then
    values at which a point that it rests on is infinitely far away, then jumps.
    """
    conditions: list[tuple[Vanishing, LimitValue]] = [(v, "0") for v in result.zeros]
    conditions += [(v, "infinite") for v in result.poles]
    known = list[float]()
    for vanishing, value in conditions:
        for root in roots_at(result, vanishing, along, stretch, grid):
            exact = _exact(vanishing, drive, along, root)
            known.append(root.x)
            is_open = _is_indeterminate(vanishing, result, along, stretch, root.x)
            cause = "other" if is_open else vanishing.cause
            yield Singular(result.name, value, cause, *root, exact)
    size = along.function(result.formula, result)
    for root in _other_zeros(size, grid, known):
        yield Singular(result.name, "0", "other", *root, None)
    for broken in result.breaks:
        for root in roots_at(result, broken, along, stretch, grid):
            yield Singular(result.name, "undetermined", "far", *root, None)
    yield from jumping(result, along, grid)


def _is_indeterminate(
    vanishing: Vanishing, result: Analysis, along: Sweep, stretch: StrokeInterval, x: float
) -> bool:
    """Return whether another factor vanishes there, too, so that what stands still is open."""
    others = (along.function(other, result) for other in vanishing.except_where)
    return any(order_at(other, x, stretch.high - stretch.low) == "0" for other in others)


def _other_zeros(
    size: RealFunction, grid: Sequence[float], known: Sequence[float]
) -> Iterator[Root]:
    """Yield the zeros of a result that none of its factors has: of a sum too long to be split."""
    near = BRANCH_POINT * (grid[-1] - grid[0])
    for root in roots(size, grid):
        falls = abs(size(root.x + near / 10)) < abs(size(root.x + near))
        if falls and all(abs(root.x - other) > near for other in known):
            yield root


def roots_at(
    result: Analysis,
    vanishing: Vanishing | Break,
    along: Sweep,
    stretch: StrokeInterval,
    grid: Sequence[float],
) -> Iterator[Root]:
    """Yield where on a stretch a result's factor vanishes."""
    factor = along.function(vanishing.factor, result)
    yield from roots(factor, grid)
    yield from _at_the_ends(factor, stretch)


def _at_the_ends(factor: RealFunction, stretch: StrokeInterval) -> Iterator[Root]:
    """Yield the ends beyond which nothing can be assembled, where the factor goes to zero.

    It does so as a square root: it halves where the distance from the end is quartered. The drive
    may end there, too: then the factor is nothing at the end itself, but for rounding.
    """
    step = DIFFERENCE * (stretch.high - stretch.low)
    ends = ((stretch.low, stretch.before, step), (stretch.high, stretch.after, -step))
    for end, why, inwards in ends:
        there, near, away = (abs(factor(end + part * inwards)) for part in (0, 1, 4))
        if near < 0.7 * away and (why or there < NOTHING_AT_END * near):
            yield Root(end, math.ulp(end))


def _exact(vanishing: Vanishing, drive: str, along: Sweep, root: Root) -> Formula | None:
    """Return the drive as a constant formula, turned by half turns to the value found."""
    if vanishing.at is None or vanishing.at[0] != drive:
        return None
    formula = vanishing.at[1]
    if symbols(formula) - along.defaults.keys():
        return None
    value = evaluate(formula, along.values(root.x))
    turns = round((root.x - value) / math.pi)
    shifted = total([formula, product([(number(turns), 1), (degrees(180), 1)])])
    return shifted if math.isclose(value + turns * math.pi, root.x, abs_tol=SAME_VALUE) else None


def order_at(
    function: RealFunction, x: float, range_: float, parts: Sequence[float] = NEARBY
) -> Order | None:
    """Return the order of a function at ``x``; None where it is no power of the distance.

    The ``parts`` of the range are the distances at which that is seen, the first that shows it.

    >>> order_at(lambda x: (1e-6 - x) / x, 0.0, 1.0)
    'infinite'
    """
    for part in parts:
        sides = (_exponent(function, x, side * part * range_) for side in (-1, 1))
        if exponents := [e for e in sides if e is not None]:
            if max(exponents) < -VARYING_EXPONENT:
                return "infinite"
            if min(exponents) > VARYING_EXPONENT:
                return "0"
            if max(map(abs, exponents)) > VARYING_EXPONENT:
                return None
            before, after = (function(x + side * part / 16 * range_) for side in (-1, 1))
            return "jump" if abs(before - after) > STEADY * abs(after) else "finite"
    return None


def _exponent(function: RealFunction, x: float, distance: float) -> float | None:
    """Return the power of the distance by which a function varies, None where it is none."""
    sizes = [abs(function(x + distance * part)) for part in (1, 1 / 4, 1 / 16)]
    if not all(0 < size < math.inf for size in sizes):
        return None
    first, second = (math.log(far / near, 4) for far, near in pairwise(sizes))
    return second if abs(first - second) < SAME_EXPONENT else None


def distinguished(
    found: Iterable[Singular],
    branches: Sequence[ChangePoint],
    range_: float,
    orders: Mapping[str, OrderAt],
) -> tuple[Singular, ...]:
    """Return singular poses in their order, those left out that only a branch point makes.

    What is left at one is seen from farther away than rounding reaches: where a triangle is flat
    but for rounding, a result may pass 0 on its way over a jump.

    ``orders`` say of each result what it does there: which of a zero and a pole that are
    at one value, where neither of them leaves it undetermined; or that what vanishes there
    makes it neither, as something else is infinite.
    """
    beside = BRANCH_POINT * range_
    kept: list[Singular] = []
    on_a_branch: dict[tuple[str, ChangePoint], list[Singular]] = {}
    for one in sorted(found, key=lambda s: s.drive):
        branch = next((b for b in branches if abs(one.drive - b.drive) <= beside), None)
        if branch is None:
            kept.append(one)
        elif one.sides is None:
            on_a_branch.setdefault((one.result, branch), []).append(one)
    for (_, branch), ones in on_a_branch.items():
        if len({one.value for one in ones}) == 1:
            kept.append(ones[0]._replace(drive=branch.drive, bracket=branch.bracket))
    kept.sort(key=lambda s: (s.result, s.drive))
    flat = {branch.drive for branch in branches}
    merged = _merged(kept, SAME_VALUE * range_, orders, flat)
    return tuple(sorted(merged, key=lambda s: s.drive))


def _merged(
    found: Sequence[Singular],
    width: float,
    orders: Mapping[str, OrderAt],
    flat: Set[float],
) -> Iterator[Singular]:
    """Yield singular poses, those of a result at one value as its order there.

    ``flat`` are the values at which a loop is flat.
    """
    for ones in _at_one_value(found, width):
        first = next((one for one in ones if one.sides), ones[0])
        if first.sides:
            yield first
            continue
        parts = BEYOND_BRANCH_POINT if first.drive in flat else NEARBY
        value = orders[first.result](first.drive, parts)
        if any(one.kind == "far" for one in ones):
            yield from _at_what_is_far(first, value)
        else:
            yield from _of_order(ones, value)


def _at_one_value(found: Sequence[Singular], width: float) -> list[list[Singular]]:
    """Return singular poses, in order, those of a result together that are so near each other."""
    groups: list[list[Singular]] = []
    for one in found:
        last = groups[-1][-1] if groups else None
        if last and last.result == one.result and one.drive - last.drive <= width:
            groups[-1].append(one)
        else:
            groups.append([one])
    return groups


def _of_order(ones: Sequence[Singular], value: Order | None) -> Iterator[Singular]:
    """Yield one of singular poses at one value, as its order there says; none that is finite."""
    first = ones[0]
    undetermined = first._replace(
        value="undetermined", kind="jump" if value == "jump" else "branch point"
    )
    if len({one.value for one in ones}) > 1:
        yield next((one for one in ones if one.value == value), undetermined)
    elif value == "jump":
        yield undetermined
    elif value != "finite" or first.value == "undetermined":
        yield first


def _at_what_is_far(one: Singular, value: Order | None) -> Iterator[Singular]:
    """Yield a singular pose where something is infinite, none where a result runs on."""
    if value == "0" or value == "infinite":
        yield one._replace(value=value, kind="other", exact=None)
    elif value != "finite":
        yield one._replace(value="undetermined", kind="far", exact=None)
