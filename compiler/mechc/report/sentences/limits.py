"""Under which conditions a result is zero or infinite, in sentences."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby

from ...formula.operations import count_operations
from ...formula.tree import ZERO, Formula, Sum, Symbol, total
from ...study.analysis import Analysis, Cause, DeadCentre, Extent, Vanishing
from ..languages.locale import Locale
from .locking import span
from .order import alternatives, positive_first
from .speller import Speller

MOST_CONDITION_OPERATIONS = 8
"""A condition of more operations says less than the places at which it holds."""


def limits(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield when a result vanishes, then when it becomes infinite; like conditions together.

    Of one that is zero wherever it was looked at the conditions are of no meaning.
    """
    if any(extent.is_zero for extent in result.extents):
        return
    for template, kind in ((locale.zero, "zeros"), (locale.pole, "poles")):
        looked, passed = _looked(result), passed_by(result, kind)
        listed = [_in_reach(limit, passed) for limit in _stated(result, kind)]
        for _, alike in groupby(listed, _likeness):
            group = [*alike]
            if _is_bare(group[0]):
                over = looked[0] if group[0].absent and len(looked) == 1 else passed
                yield _bare(template, symbol, group, over, locale, spell)
            else:
                yield from (_particular(template, symbol, v, locale, spell) for v in group)


def _in_reach(limit: Vanishing, passed: Extent | None) -> Vanishing:
    """Return a condition without its exceptions where it holds for no value that is looked at.

    That is where it is outside the ranges given, or no place is found in the one looked at.
    """
    is_nowhere = limit.outside or (passed and not limit.at)
    return limit._replace(except_where=()) if limit.except_where and is_nowhere else limit


def _likeness(limit: Vanishing) -> object:
    """Return a key, the same for conditions that one sentence states together."""
    return limit.cause, _is_bare(limit), limit.absent, limit if limit.at else None


def _looked(result: Analysis) -> list[Extent]:
    """Return the ranges in which zeros and poles are looked for."""
    return [extent for extent in result.extents if extent.looked]


def passed_by(result: Analysis, kind: str) -> Extent | None:
    """Return the range on which no zero, or no pole, was found; None where there is none."""
    looked = _looked(result)
    free = [extent for extent in looked if not getattr(extent, kind)]
    return free[0] if len(free) == len(looked) == 1 else None


def states_none(result: Analysis, kind: str) -> bool:
    """Return whether :func:`limits` states that a range has no zero, or no pole.

    It does as well where it states of all of them that they are outside the ranges given.
    """
    passed = passed_by(result, kind)
    if not passed:
        return False
    found: Sequence[Vanishing] = getattr(result, kind)
    are_outside = bool(found) and all(limit.outside for limit in found)
    stated = _stated(result, kind)
    if are_outside and len(stated) == len(found):
        return True
    return any(_is_bare(_in_reach(limit, passed)) for limit in stated)


def _stated(result: Analysis, kind: str) -> list[Vanishing]:
    """Return the conditions of zeros, or of poles, that are stated.

    A long condition is left out where its places are listed: these tell more. Beside a short
    condition it is stated, too: the places listed would be read as those of the short one.
    """
    found: Sequence[Vanishing] = getattr(result, kind)
    looked = _looked(result)
    short = [v for v in found if not (looked and _is_long(v))]
    has_places = any(getattr(extent, kind) for extent in looked)
    return [*found] if short and has_places else short


def _is_long(limit: Vanishing) -> bool:
    return limit.at is None and count_operations(limit.factor) > MOST_CONDITION_OPERATIONS


def _is_bare(limit: Vanishing) -> bool:
    """Return whether there is nothing but the condition and its cause."""
    return not (limit.at or limit.except_where or limit.outside)


def _bare(
    template: str,
    symbol: str,
    group: Sequence[Vanishing],
    passed: Extent | None,
    locale: Locale,
    spell: Speller,
) -> str:
    """Return the sentence on conditions without a value, under which a result is 0 or infinite."""
    conditions = alternatives([_zero(v.factor, spell) for v in group], locale)
    said = _with_cause(
        template.format(result=symbol, condition=conditions), group[0], locale, spell
    )
    if passed:
        unmet = locale.absent if group[0].absent else locale.unmet
        said += unmet.format(span=span(passed.range, passed, locale, spell))
    return f"{said}."


def _particular(
    template: str, symbol: str, limit: Vanishing, locale: Locale, spell: Speller
) -> str:
    """Return the sentence on one condition: where it holds, what it excepts, and its cause."""
    said = template.format(result=symbol, condition=_zero(limit.factor, spell))
    if limit.at:
        said += ", " + locale.when.format(condition=_places(*limit.at, limit, locale, spell))
    if limit.outside:
        said += ", " + locale.out_of_ranges
    if limit.except_where:
        conditions = alternatives([_zero(f, spell) for f in limit.except_where], locale)
        said += ", " + locale.but_where.format(conditions=conditions)
    return f"{_with_cause(said, limit, locale, spell)}."


def _places(name: str, value: Formula, limit: Vanishing, locale: Locale, spell: Speller) -> str:
    """Return all places within a range, else one: ``φ = 90° or 270°``."""
    first, *others = map(_ordered, limit.within or (value,))
    is_angle = name in spell.angles
    said = [spell.relation((Symbol(name), first), ("=",), is_angle)]
    said += [spell.relation((other,), (), is_angle) for other in others]
    if not limit.period:
        return alternatives(said, locale)
    period = spell.relation((limit.period,), (), is_angle)
    return locale.and_every.format(first=said[0], period=period)


def _with_cause(said: str, limit: Vanishing, locale: Locale, spell: Speller) -> str:
    cause = _cause(limit.cause, locale, spell)
    return f"{said} ({cause})" if cause else said


def _cause(cause: Cause, locale: Locale, spell: Speller) -> str:
    """Return the cause in words, '' where it is not known."""
    if not isinstance(cause, DeadCentre):
        return locale.causes[cause]
    return dead_centre(cause, locale.causes, spell.point)


def dead_centre(centre: DeadCentre, words: Mapping[str, str], spell: Callable[[str], str]) -> str:
    """Return in words what stands still while what else moves; ``spell`` writes their names."""
    still, moving = (
        words[f"{verb} distance" if acted.is_distance else verb].format(name=spell(acted.name))
        for verb, acted in (("still", centre.still), ("moves", centre.moving))
    )
    return words["dead centre"].format(still=still, moving=moving)


def _zero(factor: Formula, spell: Speller) -> str:
    return spell.relation((factor, ZERO), ("=",), False)


def _ordered(angle: Formula) -> Formula:
    """Return an angle as it is written, ``90° − θ``."""
    return total(positive_first(angle.terms)) if isinstance(angle, Sum) else angle
