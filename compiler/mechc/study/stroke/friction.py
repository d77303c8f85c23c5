"""Friction along the stroke: results as code takes them, and where nothing moves."""

from collections.abc import Iterable, Iterator
from itertools import chain

from ...friction.solution import FrictionSolution
from ...frozen import replace
from ...model.parts.targets import Efficiency, drives_from_below
from ..analysis import Analysis
from ..intervals import EfficiencyRange, LockingInterval
from .stroke import Extremum, JammedInterval


def in_code(result: Analysis, solution: FrictionSolution) -> Analysis:
    """Return a result as code takes it, with signs that follow from the pose."""
    whole = next(r for r in solution.results if r.name == result.name)
    return replace(result, formula=whole.formula, where=whole.where, guards=whole.guards)


def standstills(results: Iterable[Analysis], drive: str) -> Iterator[JammedInterval]:
    """Yield where friction lets nothing move."""
    for result in results:
        for stretch in _stretches(result, drive):
            if stretch.within:
                left_out, driving = _left_out(stretch, *stretch.within), _driving(result)
                yield JammedInterval(result.name, stretch.state, *stretch.within, left_out, driving)


def _driving(result: Analysis) -> str:
    """Return the load that drives from below the line, '' where that above the line does."""
    is_by_other = drives_from_below(result.target, result.name, result.driven)
    return result.locking.load if is_by_other and result.locking else ""


def _stretches(result: Analysis, drive: str) -> Iterator[LockingInterval]:
    """Return the stretches of the drive on which a result is locked or jammed."""
    reaches = result.locking.reaches if result.locking else ()
    return chain.from_iterable(reach.stretches for reach in reaches if reach.parameter == drive)


def _left_out(stretch: LockingInterval, low: float, high: float) -> tuple[bool, bool]:
    """Return of either end of what lies in the range whether the stretch only reaches up to it."""
    first, last = stretch.low, stretch.high
    return (
        first is not None and first.is_strict and first.x == low,
        last is not None and last.is_strict and last.x == high,
    )


def is_shown(extremum: Extremum, result: Analysis) -> bool:
    """Return whether an extremum is none of an efficiency where nothing moves."""
    return extremum.value > 0 or not isinstance(result.target, Efficiency)


def efficiency_ranges(
    results: Iterable[Analysis], drive: str
) -> Iterator[tuple[str, EfficiencyRange]]:
    """Yield each efficiency with what it runs through."""
    for result in results:
        yield from ((result.name, c) for c in result.efficiency_ranges if c.parameter == drive)
