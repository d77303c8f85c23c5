"""What is nothing but rounding along the stroke: an extremum, or a result all over a stretch.

A result is zero all over a part where a loop folds, and what it leads rests.
"""

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import chain, pairwise

from ...formula.numeric.roots import spaced
from ...formula.numeric.rounding import Rounding, with_error
from ...formula.walk import walk
from ...model.result import Definition, Result
from ..states import is_sign
from ..sweep import Sweep
from ..tolerances import BRANCH_POINT, LOST, NEAR_ZERO, NEARBY, NEGLIGIBLE
from .run import StrokeRun
from .stroke import ChangePoint, Extremum, Singular, StrokeInterval, ZeroInterval

ASIDE = (1, 2, 4)
"""So many values away an extremum is compared with what is next to it, if nearer ones are equal."""

FEW, MANY = 8, 180
"""Parts of a stretch between which a result shows that it is not zero, and that it seems to be."""


def rounded(
    found: Extremum, result: Result, along: Sweep, grid: Sequence[float]
) -> Iterator[Extremum]:
    """Yield an extremum, 0 where that is nothing but rounding; none where there is no value.

    Nor is there one where rounding is as large as values elsewhere: something is infinite. Where
    friction turns round it is as large on a kink as well, and the value is that of both sides.
    """
    number = along.beyond_rounding(result, found.drive, found.value)
    is_small = abs(found.value) <= LOST * _usual(result, along, grid)
    if not number and not is_small:
        where = along.form_at(result, found.drive).where
        number = found.value if is_on_a_sign(where, along.rounding(found.drive)) else None
    if number is not None and math.isfinite(number):
        yield found._replace(value=number)


def is_on_a_sign(where: Sequence[Definition], rounding: Rounding) -> bool:
    """Return whether definitions have a sign in them that rounding makes."""
    known = Rounding({})
    known.values.update(rounding.values)
    known.define(where)
    formulas = (d.formula for d in where if d.name in known.values)
    signs = (part for formula in formulas for part in walk(formula) if is_sign(part))
    return any(known.of(sign).error >= 1 for sign in signs)


def is_turning(found: Extremum, result: Result, along: Sweep, grid: Sequence[float]) -> bool:
    """Return whether a result turns by more than what rounding may have made of its values.

    Near a branch point rounding may be larger than what the result changes by. Where friction
    turns round the bound holds for either sign of it, so that it is taken from next to there. A
    sign may be that of rounding all along, as of a joint that nothing presses: where it is the same
    on both sides, it is held.
    """
    around = _around(found, grid)
    if _exceeds(found, around, lambda x: _error(x, result, along), result, along, grid):
        return True
    here = _senses(found.drive, result, along)
    alike = [p for p in around if all(_senses(x, result, along) == here for x in p)] if here else []
    return _exceeds(found, alike, lambda x: _error_by_senses(x, result, along), result, along, grid)


def _around(found: Extremum, grid: Sequence[float]) -> list[tuple[float, float]]:
    """Return the values of a grid on both sides of an extremum, farther and farther away."""
    left, right = bisect_left(grid, found.drive), bisect_right(grid, found.drive) - 1
    return [(grid[max(left - n, 0)], grid[min(right + n, len(grid) - 1)]) for n in ASIDE]


def _exceeds(
    found: Extremum,
    around: Iterable[tuple[float, float]],
    error_at: Callable[[float], float],
    result: Result,
    along: Sweep,
    grid: Sequence[float],
) -> bool:
    """Return whether values on both sides go beyond an extremum by more than errors."""
    sense = 1 if found.kind == "minimum" else -1
    step = NEARBY[0] * (grid[-1] - grid[0])
    error = min(error_at(found.drive + side * step) for side in (-1, 0, 1))
    least = found.value + sense * error

    def is_beyond(x: float) -> bool:
        beside = along.of(result.formula, result, x) - sense * error_at(x)
        return sense * beside > sense * least

    return any(is_beyond(left) and is_beyond(right) for left, right in around)


def _error(x: float, result: Result, along: Sweep) -> float:
    """Return a bound of the rounding error in a result's value, 0 where none is known."""
    form = along.form_at(result, x)
    error = with_error(form.formula, form.where, along.rounding(x)).error
    return error if math.isfinite(error) else 0.0


def _error_by_senses(x: float, result: Result, along: Sweep) -> float:
    """Return the same bound if signs of slips and forces are what they are found to be."""
    error = _by_senses(x, result, along).of(along.form_at(result, x).formula).error
    return error if math.isfinite(error) else 0.0


def _senses(x: float, result: Result, along: Sweep) -> tuple[float, ...]:
    """Return the signs of slips and forces that a result rests on."""
    where, found = along.form_at(result, x).where, _by_senses(x, result, along).values
    return tuple(found[d.name].value for d in where if is_sign(d.formula) and d.name in found)


def _by_senses(x: float, result: Result, along: Sweep) -> Rounding:
    """Return the definitions of a result with their errors, but for those of signs."""
    where, known = along.form_at(result, x).where, along.rounding(x).values
    own, held = {d.name for d in where}, Rounding({})
    held.values.update((name, value) for name, value in known.items() if name not in own)
    for definition in where:
        held.define([definition])
        if is_sign(definition.formula) and definition.name in held.values:
            held.values[definition.name] = held.values[definition.name]._replace(error=0.0)
    return held


def is_zero(result: Result, along: Sweep, stretch: StrokeInterval) -> bool:
    """Return whether a result is zero but for rounding wherever a stretch is looked at.

    That is no proof, and what states it says that it was looked at.
    """
    grids = (spaced(stretch.low, stretch.high, parts)[1:-1] for parts in (FEW, MANY))
    return all(along.beyond_rounding(result, x) == 0 for x in chain.from_iterable(grids))


def is_nothing(
    sides: Mapping[float, float], result: Result, along: Sweep, grid: Sequence[float]
) -> bool:
    """Return whether a result's values at some places are nothing but rounding.

    They are small against what half of those exceed that are not rounding, too: relative to what is
    infinite rounding alone is larger than any value.
    """
    if any(along.beyond_rounding(result, x, value) != 0 for x, value in sides.items()):
        return False
    certain = [x for x in grid if along.beyond_rounding(result, x)]
    usual = _usual(result, along, certain)
    return not usual or max(map(abs, sides.values())) < NEGLIGIBLE * usual


def each_zero_once(found: Iterable[Singular], run: StrokeRun) -> Iterator[Singular]:
    """Yield singular poses; zeros between which nothing but rounding is left are one.

    A zero of a high order is flat: Watt's point runs straight in the fourth order, and a sign
    changes by rounding on a thousandth of a degree. Such a zero is at 0, or at the value given,
    where it may be.
    """
    results = {result.name: result for result in run.results}
    kept = list[tuple[str, tuple[float, float]]]()
    for one in found:
        if one.value != "0" or one.exact is not None:
            yield one
            continue
        low, high = _flat_part(one.drive, results[one.result], run)
        if any(name == one.result and a < one.drive < b for name, (a, b) in kept):
            continue
        kept.append((one.result, (low, high)))
        likely = (0.0, run.along.defaults.get(run.drive.name, 0.0))
        drive = next((x for x in likely if low < x < high), one.drive)
        yield one._replace(drive=drive)


def _flat_part(x: float, result: Result, run: StrokeRun) -> tuple[float, float]:
    """Return the ends of the part around a zero on which values are nothing but rounding.

    Of most zeros there is no such part: both ends are the zero.
    """
    along, least = run.along, NEAR_ZERO * run.range

    def is_flat(at: float) -> bool:
        return along.beyond_rounding(result, at) == 0

    def reach(side: int) -> float:
        step = least
        while step < run.range and is_flat(x + side * step):
            step *= 2
        return x + side * step / 2 if step > least else x

    return reach(-1), reach(1)


def _usual(result: Result, along: Sweep, grid: Sequence[float]) -> float:
    """Return a size that half of a result's values do not exceed."""
    values = (along.of(result.formula, result, x) for x in grid)
    sizes = sorted(abs(value) for value in values if math.isfinite(value))
    return sizes[len(sizes) // 2] if sizes else 0.0


def zero_parts(
    run: StrokeRun, stretches: Sequence[StrokeInterval], branches: Sequence[ChangePoint]
) -> Iterator[ZeroInterval]:
    """Yield the parts between ends of stretches and branch points on which results are zero."""
    for stretch in stretches:
        inner = (b.drive for b in branches if stretch.low < b.drive < stretch.high)
        for low, high in pairwise((stretch.low, *sorted(inner), stretch.high)):
            if high - low > BRANCH_POINT * run.range:
                part = StrokeInterval(low, high, "", "")
                zero = (r.name for r in run.results if is_zero(r, run.along, part))
                yield from (ZeroInterval(name, low, high) for name in zero)


def is_apart(
    found: Singular | Extremum, zero_intervals: Sequence[ZeroInterval], range_: float
) -> bool:
    """Return whether a singular pose or extremum is on no part on which its result is zero.

    At an end of one a result may jump.
    """
    near = BRANCH_POINT * range_
    if isinstance(found, Singular) and found.value == "undetermined":
        near = -near
    parts = (part for part in zero_intervals if part.result == found.result)
    return not any(p.low - near <= found.drive <= p.high + near for p in parts)
