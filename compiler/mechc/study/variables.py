"""The parameters that results are followed along: the drive, angles, and those with a range."""

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import groupby

from ..formula.numeric import roots
from ..formula.tree import Symbol
from ..formula.walk import symbols
from ..model.mechanism import Arrow, Mechanism
from ..model.result import Result
from ..model.values import own_unit, usual_units
from ..units import ANGLE, LENGTH, in_unit
from .locking_intervals import Range
from .tolerances import EXACT, NEARLY


def varying(mechanism: Mechanism, results: Sequence[Result]) -> Iterator[str]:
    """Yield the drive, angles, and what else has a range, if results depend on them.

    They come in the order of the text.
    """
    used = _used(mechanism, results)
    drive = mechanism.drive_name
    for parameter in mechanism.parameters:
        turns = parameter.dimension == ANGLE and not parameter.dependent
        is_followed = turns or parameter.range is not None or parameter.name == drive
        if parameter.name in used and parameter.value and is_followed:
            yield parameter.name


def moved(mechanism: Mechanism, results: Sequence[Result]) -> Iterator[str]:
    """Yield those among them that may pass a dead centre: the drive and angles."""
    drive = mechanism.drive_name
    for name in varying(mechanism, results):
        if name == drive or turns(name, mechanism):
            yield name


def moving_first(mechanism: Mechanism) -> list[str]:
    """Return the names of parameters: the drive's, then those with a range, then the others."""
    drive, ranged = mechanism.drive, with_range(mechanism)
    names = [p.name for p in mechanism.parameters]
    return sorted(names, key=lambda n: (not drive or n != drive.parameter, n not in ranged))


def with_range(mechanism: Mechanism) -> frozenset[str]:
    """Return the parameters that have a range, or a stroke."""
    drive = mechanism.drive
    moved = {drive.parameter} if drive and drive.low and drive.high else set[str]()
    return frozenset(moved.union(p.name for p in mechanism.parameters if p.range is not None))


def _used(mechanism: Mechanism, results: Sequence[Result]) -> set[str]:
    used: set[str] = set()
    for result in results:
        used |= symbols(result.formula).union(*(symbols(d.formula) for d in result.where))
    dependent = [p for p in mechanism.parameters if p.dependent and p.value]
    for _ in dependent:
        used |= {s for p in dependent if p.value and p.name in used for s in symbols(p.value)}
    return used


def turns(name: str, mechanism: Mechanism) -> bool:
    """Return whether a parameter is an angle."""
    return any(p.name == name and p.dimension == ANGLE for p in mechanism.parameters)


def extends(name: str, mechanism: Mechanism) -> bool:
    """Return whether a parameter is the length of a telescope."""
    ends = {frozenset(telescope.points) for telescope in mechanism.telescopes}
    arrows = (entry for entry in mechanism.geometry if isinstance(entry, Arrow))
    return any(a.length == Symbol(name) and {a.tail, a.head} in ends for a in arrows)


def unit_of(name: str, mechanism: Mechanism) -> str:
    """Return the unit that was written, "" for angles and numbers."""
    parameter = mechanism.parameter(name)
    if parameter.dimension == ANGLE:
        return ""
    return parameter.unit or ("m" if parameter.dimension == LENGTH else "")


def scale_of(result: Result, mechanism: Mechanism) -> str:
    """Return the unit in which a person reads a result: its own, else as others are given."""
    if own := own_unit(result.name, mechanism):
        return own
    return usual_units(mechanism).of(result.dimension)


SignedMeasure = Callable[[float], float]
"""Gives a value that is positive where something holds and negative beyond, or the other way."""


def last(
    holds: Callable[[float], bool],
    good: float,
    bad: float,
    width: float = EXACT,
    measure: SignedMeasure | None = None,
) -> float:
    """Return the last value at which something holds that no longer does at another.

    It is found by halves. Where a ``measure`` changes its sign there, values on either side of
    that are tried first, and what follows from them is not tried again.
    """
    least, way = width * max(abs(good), abs(bad)), math.copysign(1.0, bad - good)
    sure, out = good, bad
    if measure:
        sure, out = _between(holds, _next_to_zero(measure, good, bad, least), good, bad)
    while abs(bad - good) > least and (middle := (good + bad) / 2) not in (good, bad):
        if (sure - middle) * way >= 0:
            good = middle
        elif (middle - out) * way >= 0:
            bad = middle
        elif holds(middle):
            good = sure = middle
        else:
            bad = out = middle
    return good


NEARER = (8, 16, 24, 32, 40)
"""How often a stretch is halved to values next to a zero at its end."""


def _next_to_zero(
    measure: SignedMeasure, good: float, bad: float, least: float
) -> Collection[float]:
    """Return values on either side of where a measure is zero, nearer and nearer to it.

    It may be zero at the end itself, but for rounding.
    """
    first, final = measure(good), measure(bad)
    if abs(final) <= EXACT * abs(first):
        return [bad + (good - bad) * 0.5**halvings for halvings in NEARER]
    if not (first * final < 0 and math.isfinite(first * final)):
        return ()
    taken: dict[float, float] = {good: first, bad: final}

    def noted(x: float) -> float:
        if x not in taken:
            taken[x] = measure(x)
        return taken[x]

    roots.narrowed(noted, good, bad, least)
    return taken


def _between(
    holds: Callable[[float], bool], values: Collection[float], good: float, bad: float
) -> tuple[float, float]:
    """Return two neighbours among values: at the first something holds, and no longer beyond."""
    ordered = sorted({good, bad, *values}, reverse=bad < good)
    first, final = 0, len(ordered) - 1
    while final - first > 1:
        middle = (first + final) // 2
        if holds(ordered[middle]):
            first = middle
        else:
            final = middle
    return ordered[first], ordered[final]


def spans(
    grid: Sequence[float], holds: Callable[[float], bool], measure: SignedMeasure | None = None
) -> Iterator[Range]:
    """Yield the stretches on which something holds, and a measure, if there is one, is positive."""
    first = 0
    for so, group in groupby(grid, holds):
        final = first + len(list(group)) - 1
        if so:
            low = last(holds, grid[first], grid[first - 1], NEARLY, measure) if first else grid[0]
            high = grid[-1]
            if final + 1 < len(grid):
                high = last(holds, grid[final], grid[final + 1], NEARLY, measure)
            yield low, high
        first = final + 1


def shown(name: str, ends: Range, mechanism: Mechanism) -> str:
    """Return a stretch as a message says it: ``alpha = 1 deg .. 7.1 deg``."""
    parameter = mechanism.parameter(name)
    unit = parameter.unit or ("rad" if parameter.dimension == ANGLE else "")
    low, high = (in_unit(end, unit, 4) for end in ends)
    return f"{name} = {low} .. {high}"
