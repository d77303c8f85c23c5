"""The extent of a ratio along the stroke or over a range, in sentences."""

from collections.abc import Iterator, Mapping, Sequence

from ...formula.tree import ZERO, Formula, Symbol
from ...study.analysis import Analysis, Extent, Extreme
from ...units import behind, size_of
from ..digits import EXTREME_DIGITS
from ..dimensions import names_in
from ..languages.locale import Locale
from .limits import states_none
from .locking import rounded_value, span
from .order import enumeration
from .speller import Speller

MOST_LISTED_ZEROS = 8
"""More zeros, or poles, than this are not listed."""

AS_NOTHING = 1e-6
"""Places are found to so small a part of the range: one that is less than that is 0.

An extremum lies anywhere where its values are alike but for rounding, of which that is the root.
"""


def extent_remarks(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield a sentence for each range or stroke of which there is something to say."""
    open_ = [kind for kind in ("zeros", "poles") if not states_none(result, kind)]
    yield from _ends(result, symbol, locale, spell)
    for extent in (each for each in result.extents if not each.is_monotone):
        words = locale.extents
        parts = [*_singular(extent, symbol, open_, locale, spell)]
        parts += _extreme(extent, symbol, locale, spell)
        if parts:
            where = span(extent.range, extent, locale, spell)
            yield words["whole"].format(span=where, parts="; ".join(parts))


def _ends(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield what a result comes to at the ends of ranges over which it rises or falls."""
    pairs = [
        locale.extents["pair"].format_map(_at_ends(extent, locale, spell))
        for extent in result.extents
        if extent.is_monotone
    ]
    if pairs:
        ends = locale.extents["ends alone" if _rests_on_one(result) else "ends"]
        yield ends.format(result=symbol, pairs="; ".join(pairs))


def _rests_on_one(result: Analysis) -> bool:
    """Return whether a result rests on one name alone, so that there is no rest at its values."""
    formulas = (result.formula, *(d.formula for d in result.where))
    names = frozenset[str]().union(*map(names_in, formulas))
    return len(names - {d.name for d in result.where}) == 1


def _at_ends(extent: Extent, locale: Locale, spell: Speller) -> Mapping[str, str]:
    """Return the values at the first and the last end, and where these are, for a sentence.

    ``low`` is the value at the first end, which is the greater one where a result falls.
    """
    ends = [end for end in (extent.least, extent.greatest) if end is not None]
    first, last = sorted(ends, key=lambda end: end.x)
    return {
        "low": _value(first, extent, locale, spell),
        "first": _at(first.x, extent, locale, spell),
        "high": _value(last, extent, locale, spell),
        "last": _at(last.x, extent, locale, spell),
    }


def _singular(
    extent: Extent, symbol: str, open_: Sequence[str], locale: Locale, spell: Speller
) -> Iterator[str]:
    """Yield where it is zero, where infinite, or what it is not of that which is ``open_``."""
    if extent.looked and open_ and not extent.zeros and not extent.poles:
        kind = "neither" if len(open_) > 1 else f"no {open_[0]}"
        yield locale.extents[kind].format(result=symbol)
    if extent.is_zero:
        yield locale.extents["0 all over"].format(result=symbol)
    elif extent.zero_intervals:
        spans = enumeration(
            [span(part, extent, locale, spell) for part in extent.zero_intervals], locale
        )
        yield locale.extents["0 throughout"].format(result=symbol, spans=spans)
    for kind, found in (("0", extent.zeros), ("infinite", extent.poles)):
        if 0 < len(found) <= MOST_LISTED_ZEROS:
            places = _places(found, extent, locale, spell)
            yield locale.extents[kind].format(result=symbol, places=places)


def _places(found: Sequence[float], extent: Extent, locale: Locale, spell: Speller) -> str:
    """Return places, each with the condition that holds there where it is one of several."""
    if not extent.vanishes.keys() >= {*found}:
        return enumeration([_at(x, extent, locale, spell) for x in found], locale)
    groups: dict[Formula, list[str]] = {}
    for x in found:
        groups.setdefault(extent.vanishes[x], []).append(_at(x, extent, locale, spell))
    tied = [
        f"{enumeration(places, locale)} ({spell.relation((factor, ZERO), ('=',), False)})"
        for factor, places in groups.items()
    ]
    return ", ".join(tied)


def _extreme(extent: Extent, symbol: str, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield where it is least and greatest, unless it is the same throughout."""
    least, greatest = extent.least, extent.greatest
    if least is None or greatest is None:
        return
    values = [_value(e, extent, locale, spell) for e in (least, greatest)]
    if values[0] != values[1]:
        for kind, extreme, value in zip(
            ("least", "greatest"), (least, greatest), values, strict=True
        ):
            places = [_at(x, extent, locale, spell) for x in (extreme.x, *extreme.again)]
            at = enumeration(dict.fromkeys(places), locale)
            yield locale.extents[kind].format(result=symbol, place=at, value=value)


def _at(x: float, extent: Extent, locale: Locale, spell: Speller) -> str:
    """Return ``α = 45°``."""
    low, high = extent.range
    at = 0.0 if abs(x) < AS_NOTHING * (high - low) else x
    sides = (Symbol(extent.parameter), rounded_value(at, extent, spell))
    shown = spell.relation(sides, ("=",), extent.parameter in spell.angles)
    return shown + behind(locale.units.get(extent.unit, extent.unit))


def _value(extreme: Extreme, extent: Extent, locale: Locale, spell: Speller) -> str:
    rounded = float(f"{extreme.value / size_of(extent.scale):.{EXTREME_DIGITS}g}")
    return spell.number(rounded or 0.0) + spell.unit_behind(extent.scale)
