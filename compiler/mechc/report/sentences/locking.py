"""Where a mechanism is locked by friction, and how its efficiency runs, in sentences."""

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from ...formula.layout import in_degrees
from ...formula.tree import Formula, Number, Symbol, degrees, number, total
from ...model.parts.targets import drives_from_below
from ...study.analysis import Analysis, Extent
from ...study.locking_intervals import (
    Bound,
    EfficiencyRange,
    Locking,
    LockingInterval,
    LockingIntervals,
    Range,
    rounded_share,
)
from ...units import behind, size_of
from ..languages.locale import Locale
from .order import enumeration, positive_first
from .speller import LoadWords, Speller, spelled

FoundAlong = LockingIntervals | EfficiencyRange | Extent
"""What is stated along a parameter."""

DIGITS, MOST = 4, 10
"""Significant digits of a value, and the most where fewer make one of the ends of an interval."""

ROUNDED_ZERO = 1e-7
"""An angle in radians that is nothing but rounding, next to a pose in which all sides lie flat."""


def friction_remarks(result: Analysis, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield where nothing moves, what an efficiency runs through, and whether that is proved.

    Before that, whether the formula holds at the values given.
    """
    if result.sides:
        yield locale.at_rest["limit" if len(result.sides) == 1 else "jump"]
    if result.fails_here:
        yield locale.fails_here
    if result.locking:
        yield from _locking(result, result.locking, locale, spell)
    for efficiency in result.efficiency_ranges:
        yield _efficiency_range(result, efficiency, locale, spell)
    usual = list[str]()
    if any(
        efficiency.least != efficiency.greatest and efficiency.is_of_joints
        for efficiency in result.efficiency_ranges
    ):
        usual = [locale.why_usual]
    reaches = result.locking.reaches if result.locking else ()
    shown = [s for reach in reaches for s in reach.of_interest if _is_shown(s, reach)]
    if result.efficiency_ranges or any(part.sampled for part in shown):
        yield locale.sampled
    yield from usual


def _locking(result: Analysis, locking: Locking, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield where nothing moves: no self-locking is said of a load that is said to drive."""
    drive = spelled(Symbol(locking.drive), spell)
    load = spelled(Symbol(locking.load), spell) if locking.load else locale.all_loads
    loads = [locking.load] if locking.load else []
    of_drive, of_load = (LoadWords(n, spell.couples) for n in ([locking.drive], loads))
    is_by_other = drives_from_below(result.target, result.name, result.driven)
    locked = "locked, driving" if is_by_other else "locked"
    said = {
        s: template.format(drive=drive, load=load, of_drive=of_drive, of_load=of_load)
        for s, template in (("locked", locale.states[locked]), ("jammed", locale.states["jammed"]))
    }
    if locking.state and locking.state != "free" and not _holds_throughout(locking):
        yield f"{said[locking.state]} {locale.as_given}."
    for reach in locking.reaches:
        for part in (s for s in reach.of_interest if _is_shown(s, reach)):
            where = locale.where_it_holds.format(condition=_condition(part, reach, spell, locale))
            yield f"{said[part.state]} {where}{_within(part, reach, locale, spell)}."


def _holds_throughout(locking: Locking) -> bool:
    """Return whether a whole range has the state of the given pose: then the range is stated."""
    stretches = ((s, r) for r in locking.reaches if r.range for s in r.of_interest)
    return any(s.state == locking.state and s.within == r.range for s, r in stretches)


def _is_shown(part: LockingInterval, reach: LockingIntervals) -> bool:
    """Return whether an interval is of interest.

    Outside the range it is where a formula gives its ends, unless it is a jam near a dead centre.
    """
    if reach.range and part.within is None and part.sampled:
        return False
    is_solved = any(b and b.exact for b in (part.low, part.high))
    return part.state == "locked" or part.within is not None or (not reach.range and is_solved)


def _condition(
    part: LockingInterval, reach: LockingIntervals, spell: Speller, locale: Locale
) -> str:
    """Return an interval as an inequality, with figures behind its formulas."""
    low, high = _shown_ends(part, reach)
    bounds = [b for b in (low, high) if b]
    if not bounds:
        return locale.any_of.format(name=_name(reach, spell))
    said = spell.relation(*_relation(low, high, reach, spell), reach.parameter in spell.angles)
    known = [b.x for b in bounds if b.exact and not _is_figure(b.exact)]
    figures = [_figure(x, reach, locale, spell) for x in known]
    unit = _unit(reach, locale) if any(not b.exact for b in bounds) else ""
    return f"{said}{unit}" + (f" ({', '.join(figures)})" if figures else "")


def _relation(
    low: Bound | None, high: Bound | None, reach: LockingIntervals, spell: Speller
) -> tuple[tuple[Formula, ...], tuple[str, ...]]:
    """Return the sides of an inequality, and the signs between them."""
    name = Symbol(reach.parameter)
    if low and high:
        digits = _apart([low.x, high.x], reach, spell)
        below, above = (_side(b, reach, spell, digits) for b in (low, high))
        return (below, name, above), (_sign("<", low), _sign("<", high))
    if low:
        return (name, _side(low, reach, spell)), (_sign(">", low),)
    assert high
    return (name, _side(high, reach, spell)), (_sign("<", high),)


def _sign(sign: str, bound: Bound) -> str:
    return sign if bound.is_strict else f"{sign}="


def _is_figure(formula: Formula) -> bool:
    return isinstance(formula, Number) or in_degrees(formula) is not None


def _shown_ends(
    part: LockingInterval, reach: LockingIntervals
) -> tuple[Bound | None, Bound | None]:
    """Return the ends of an interval but for those that the range has, or that lie beyond it.

    An end is shown where the range has it and the part leaves it out.
    """
    low, high = part.low, part.high
    if reach.range is None or part.within is None:
        return low, high
    first, last = reach.range
    low = low if low and (low.x > first or (low.is_strict and low.x == first)) else None
    high = high if high and (high.x < last or (high.is_strict and high.x == last)) else None
    if any(b and (b.exact is None or _is_figure(b.exact)) for b in (low, high)):
        return low or Bound(first), high or Bound(last)
    return low, high


def _side(bound: Bound, reach: FoundAlong, spell: Speller, digits: int = DIGITS) -> Formula:
    if bound.exact is None:
        return rounded_value(bound.x, reach, spell, digits)
    terms = getattr(bound.exact, "terms", (bound.exact,))
    return total(positive_first(terms))


def _within(part: LockingInterval, reach: LockingIntervals, locale: Locale, spell: Speller) -> str:
    """Return the part of an interval that lies in the range, unless both ends show it."""
    if reach.range is None or (part.within and all(_shown_ends(part, reach))):
        return ""
    if part.within is None:
        return f", {locale.out_of_range}"
    if part.within == reach.range:
        return f", {locale.all_of_range}"
    return f", {locale.in_range.format(condition=span(part.within, reach, locale, spell))}"


def _efficiency_range(
    result: Analysis, efficiency: EfficiencyRange, locale: Locale, spell: Speller
) -> str:
    least, greatest = (_share(v, locale, spell) for v in (efficiency.least, efficiency.greatest))
    said = (locale.steady if least == greatest else locale.efficiency_range).format(
        result=spelled(Symbol(result.name), spell),
        condition=span(efficiency.range, efficiency, locale, spell),
        least=least,
        greatest=greatest,
    )
    is_bare = least == greatest or not efficiency.is_of_joints
    return f"{said}." if is_bare else f"{said}; {_usual(efficiency, locale, spell)}."


def _usual(efficiency: EfficiencyRange, locale: Locale, spell: Speller) -> str:
    """Return where an efficiency is what textbooks assume."""
    if efficiency.usual == (efficiency.range,):
        return locale.always_usual
    spans = [span(part, efficiency, locale, spell) for part in efficiency.usual]
    return locale.usual.format(conditions=enumeration(spans, locale)) if spans else locale.unusual


# --------------------------------------------------------------------------- figures


def span(part: Range, reach: FoundAlong, locale: Locale, spell: Speller) -> str:
    """Return ``1° ≤ α ≤ 45°``."""
    digits = _apart(part, reach, spell)
    low, high = (rounded_value(end, reach, spell, digits) for end in part)
    sides, angle = (low, Symbol(reach.parameter), high), reach.parameter in spell.angles
    return spell.relation(sides, ("<=", "<="), angle) + _unit(reach, locale)


def _figure(at: float, reach: LockingIntervals, locale: Locale, spell: Speller) -> str:
    shown = spell.relation((rounded_value(at, reach, spell),), (), reach.parameter in spell.angles)
    return shown + _unit(reach, locale)


def rounded_value(at: float, reach: FoundAlong, spell: Speller, digits: int = DIGITS) -> Formula:
    """Return a value with few digits, an angle in degrees, of which rounding alone makes none."""
    if reach.parameter in spell.angles:
        return degrees(Fraction(f"{math.degrees(at):.{digits}g}") if abs(at) > ROUNDED_ZERO else 0)
    return number(Fraction(f"{at / size_of(reach.unit):.{digits}g}"))


def _apart(ends: Sequence[float], reach: FoundAlong, spell: Speller) -> int:
    """Return how many digits show the ends of an interval to be two."""
    for digits in range(DIGITS, MOST):
        if len({rounded_value(end, reach, spell, digits) for end in ends}) == len(ends):
            return digits
    return MOST


def _share(value: float, locale: Locale, spell: Speller) -> str:
    shown = spelled(number(Fraction(rounded_share(value))), spell)
    return shown if value else locale.still.format(least=shown)


def _unit(reach: FoundAlong, locale: Locale) -> str:
    return behind(locale.units.get(reach.unit, reach.unit))


def _name(reach: LockingIntervals, spell: Speller) -> str:
    return spelled(Symbol(reach.parameter), spell)
