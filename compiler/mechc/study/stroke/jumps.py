"""Where a result jumps along a stroke: over what is infinitely far, or where friction turns round.

Friction turns round where a slip or a pressing force changes its sign. That shows in the
signs themselves, be the jump however small, and in the values where something else jumps.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import pairwise, product

from ...formula.numeric.jumps import JUMP_WIDTH, NEAR_JUMP, Jump, is_steady, jumps, side
from ...formula.numeric.roots import RealFunction, spaced
from ...formula.tree import Formula, is_call
from ...formula.walk import walk
from ...model.parts.targets import Efficiency, Reaction, WithFriction
from ..analysis import Analysis
from ..sweep import Sweep
from ..tolerances import JUMP_SIDES, SHOWN_JUMP
from ..variables import last
from .rounded import is_nothing
from .run import StrokeRun
from .stroke import Singular, StrokeEvent, StrokeInterval

PLACES = 60
"""In how many parts a stroke is looked at for the usual size of a result."""

GROWS_TEN_TIMES_NEARER = 5.0
"""How much larger what is infinite somewhere is ten times nearer to it, at least."""

SIGNS = ("sign", "sense")
"""The functions that change with a slip or a force that turns round."""

ROUNDING_CHANGES = 48
"""A sign that changes in so many cells is that of what is zero but for rounding."""


def turns_along(run: StrokeRun, stretches: Sequence[StrokeInterval]) -> tuple[float, ...]:
    """Return where friction turns round along a stroke: there results jump, or have a kink."""
    results = [result for result in run.results if has_turns(result)]
    found = (
        x
        for stretch in (stretches if results else ())
        for signs in _signs(results, run.along)
        for x in changes_of_sign(signs, run.within(stretch))
    )
    return tuple(sorted(found))


def jumps_along(
    run: StrokeRun, stretches: Sequence[StrokeInterval], turns: Sequence[float]
) -> Iterator[Singular]:
    """Yield where results with friction jump; a direction does where the components do.

    They may do so at ``turns``, where friction turns round or a ratio without friction jumps; and
    an efficiency where that is zero or infinite, as drive and load change places there.
    """
    results = [result for result in run.results if has_turns(result)]
    for stretch, result in product(stretches, results):
        own = [x for x in turns if stretch.low <= x <= stretch.high]
        yield from jumping(result, run.along, run.within(stretch), own)


def has_turns(result: Analysis) -> bool:
    """Return whether a result changes where friction turns round, but for directions."""
    match result.target:
        case WithFriction(Reaction(part="direction")):
            return False
        case WithFriction() | Efficiency():
            return True
        case _:
            return False


def jumping(
    result: Analysis, along: Sweep, grid: Sequence[float], turns: Sequence[float] = ()
) -> Iterator[Singular]:
    """Yield where a result jumps between values of a grid, unless it is nothing but rounding.

    It may do so at ``turns`` as well, be it by less than what it changes by in the next cells.
    Seen next to one it is there: what is divided by next to nothing is rounded most.
    """
    size, range_ = along.function(result.formula, result), grid[-1] - grid[0]
    seen, places = jumps(size, grid), spaced(grid[0], grid[-1], PLACES)
    near = 2 * NEAR_JUMP * range_
    others = [x for x in turns if all(abs(x - jump.x) > near for jump in seen)]
    placed = (jump._replace(x=_nearest(turns, jump.x, near)) for jump in seen)
    for jump in (*placed, *_at_turns(size, _spaced_out(others, near), range_)):
        higher = max(abs(jump.before), abs(jump.after))
        if not is_nothing({jump.x: higher}, result, along, places):
            yield _jumping(result.name, jump, along, range_)


def _spaced_out(places: Sequence[float], near: float) -> Iterator[float]:
    """Yield places in order, those once that are so near each other.

    >>> list(_spaced_out([3.0, 1.0, 1.01, 2.0], 0.1))
    [1.0, 2.0, 3.0]
    """
    before = -math.inf
    for x in sorted(places):
        if x - before > near:
            yield x
            before = x


def _nearest(turns: Sequence[float], x: float, near: float) -> float:
    """Return the turn nearest to x, x itself where none is near."""
    nearest = min(turns, key=lambda turn: abs(turn - x), default=x)
    return nearest if abs(nearest - x) <= near else x


def is_on_the_stroke(found: Singular, run: StrokeRun) -> bool:
    """Return whether a result jumps on its way, if it jumps, not where the stroke has its ends.

    There it is on one side, and rounding alone makes it the other.
    """
    near = 2 * NEAR_JUMP * run.range
    return not found.sides or run.low + near < found.drive < run.high - near


def _jumping(name: str, jump: Jump, along: Sweep, range_: float) -> Singular:
    """Return a jump as a singular pose: what grows without end towards it is far."""
    near, away = (along.values(jump.x + part * range_) for part in JUMP_SIDES)
    is_far = any(
        abs(near[n]) > GROWS_TEN_TIMES_NEARER * abs(away[n]) > 0 for n in along.closing if n in near
    )
    sides = (jump.before, jump.after)
    kind: StrokeEvent = "far" if is_far else "jump"
    return Singular(name, "undetermined", kind, jump.x, jump.bracket, None, sides)


def _at_turns(size: RealFunction, turns: Iterable[float], range_: float) -> Iterator[Jump]:
    """Yield the turns at which a function jumps by what shows in its figures."""
    for x in turns:
        before, after = (side(size, x, way * NEAR_JUMP * range_) for way in (-1, 1))
        jump = Jump(x, JUMP_WIDTH * range_, before, after)
        shows = abs(after - before) > SHOWN_JUMP * max(abs(before), abs(after))
        if shows and is_steady(size, jump, range_):
            yield jump


SignsAt = Callable[[float], Sequence[float]]
"""Returns the signs of slips and forces at a value of the drive."""


def _signs(results: Sequence[Analysis], along: Sweep) -> Iterator[SignsAt]:
    """Yield the signs in results, those in forms for elsewhere among them, a few functions for all.

    Results that call different things by one name do not share a function.
    """
    groups = list[dict[str, Formula]]()
    forms = [form for r in results for form in (r, r.elsewhere) if form is not None]
    for where in (dict(form.where) for form in forms):
        alike = (g for g in groups if all(g.get(n, f) == f for n, f in where.items()))
        group = next(alike, None)
        if group is None:
            groups.append(where)
        else:
            group.update((n, f) for n, f in where.items() if n not in group)
    for group in groups:
        parts = dict.fromkeys(p for f in group.values() for p in walk(f) if is_call(p, *SIGNS))
        if parts:
            yield along.functions([*parts], [*group.items()])


def changes_of_sign(signs: SignsAt, grid: Sequence[float]) -> Iterator[float]:
    """Yield where each of some signs changes between two values of a grid.

    >>> [round(x, 9) for x in changes_of_sign(lambda x: (x - 0.3, 1.0), [0.0, 0.25, 0.5])]
    [0.3]
    """
    rows = [_senses(signs(x)) for x in grid]
    for i, column in enumerate(zip(*rows, strict=True)):
        sides = zip(pairwise(grid), pairwise(column), strict=True)
        cells = [(*cell, before) for cell, (before, after) in sides if before != after]
        for a, b, before in cells if len(cells) < ROUNDING_CHANGES else ():
            yield last(partial(_is, signs, i, before), a, b)


def _senses(signs: Sequence[float]) -> list[int]:
    """Return 1 for what is positive, -1 for what is negative, else 0."""
    return [(sign > 0) - (sign < 0) for sign in signs]


def _is(signs: SignsAt, i: int, sense: int, x: float) -> bool:
    return _senses(signs(x))[i] == sense
