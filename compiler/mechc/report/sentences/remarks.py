"""The remarks on a result, in sentences, whatever the language and whoever prints."""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, assert_never

from ...formula.layout import is_angle
from ...formula.names import split_points, split_ratio
from ...formula.tree import ONE, ZERO, Call, Formula, Symbol, is_call, product, quotient
from ...formula.walk import symbols, walk
from ...model.mechanism import (
    Axial,
    Efficiency,
    LoadForm,
    LoadRatio,
    Normal,
    Reaction,
    Require,
    Speed,
    SpeedRatio,
    WithFriction,
)
from ...model.names.forms import form_of_pose
from ...model.parts.targets import drives_from_below, drives_the_return
from ...model.parts.written import WrittenSides
from ...study.analysis import Analysis, Break, ClaimScope, Multiple, Trend
from ..languages.locale import Locale
from . import extents
from .limits import limits
from .locking import friction_remarks
from .order import enumeration, joined
from .speller import LoadWords, Speller, WordForms, force_words, spelled

if TYPE_CHECKING:
    from ..steps import Paragraph


def said(paragraph: "Paragraph", locale: Locale, spell: Speller) -> str:
    """Return the sentence of a paragraph."""
    names = {
        place: enumeration((spell.point(n) for n in listed), locale)
        for place, listed in paragraph.names.items()
        if any(listed)
    }
    formulas = {
        place: spell.relation((f,), (), place == "direction")
        for place, f in paragraph.formulas.items()
    }
    loads = {place: f.name for place, f in paragraph.formulas.items() if isinstance(f, Symbol)}
    each = {f"of_{place}": LoadWords([load], spell.couples) for place, load in loads.items()}
    at = "".join(paragraph.names.get("point", ())[:1])
    forms = WordForms(len(split_points(at)) > 1)
    words = {"of_drive": LoadWords([*loads.values()], spell.couples), **each, "forms": forms}
    held = " " + locale.held.format(loads=names["held"]) if "held" in names else ""
    sentence = locale.sentences[paragraph.sentence]
    return sentence.format_map({**names, **formulas, **words, "held": held})


def subject(results: Iterable[Analysis], locale: Locale) -> str:
    """Return the subject of a report: how forces or speeds are passed on, or forces alone."""
    targets = {type(result.target) for result in results}
    if LoadRatio in targets:
        return locale.subjects["force ratio"]
    return locale.subjects["speed ratio" if SpeedRatio in targets else "forces"]


def heading(result: Analysis, locale: Locale, spell: Speller) -> str:
    """Return the heading of a result by its kind; ``""`` for a user-defined formula."""
    said = kind(result, locale, spell)
    return f"{said} ({spelled(asked(result), spell)})" if says_what_drives(result) else said


def says_what_drives(result: Analysis) -> bool:
    """Return whether :func:`kind` says which load drives, or is back-driven."""
    return isinstance(result.target, WithFriction) and isinstance(
        result.target.of, LoadRatio | LoadForm
    )


def kind(result: Analysis, locale: Locale, spell: Speller) -> str:
    """Return the kind of a result in words; ``""`` for a user-defined formula."""
    match result.target:
        case LoadRatio():
            return locale.force_ratio
        case LoadForm(load):
            return locale.load.format(of_load=LoadWords([load], spell.couples))
        case SpeedRatio(above, below):
            is_of_links = above.kind == below.kind == "link"
            return locale.transmission_ratio if is_of_links else locale.speed_ratio
        case Reaction() | Normal() | Axial():
            return _capital(force_words(result.target, locale, spell))
        case WithFriction(LoadRatio() | LoadForm()):
            return _said_of(*_way(result, result.target), locale, spell)
        case WithFriction(force):
            assert not isinstance(force, LoadRatio | LoadForm)  # both stand above
            said = locale.at_joints["with friction"]
            return said.format(force=_capital(force_words(force, locale, spell)))
        case Efficiency():
            return locale.efficiency
        case None:
            return ""
        case _:
            assert_never(result.target)


def _way(result: Analysis, target: WithFriction) -> tuple[str, str]:
    """Return how friction is met, and the load of which that is said, at the values given."""
    assert isinstance(target.of, LoadRatio | LoadForm)
    drive = target.of.above if isinstance(target.of, LoadRatio) else target.of.load
    is_by_other = drives_from_below(target, result.name, result.driven)
    if target.order == "first":
        return "first", drive
    if drives_the_return(target, result.driven, result.default):
        return target.sense if is_by_other else "returns", drive
    if is_by_other and isinstance(target.of, LoadRatio):
        return "drives", target.of.below
    ways = {None: target.sense, True: "driven", False: "drives"}
    return ways[result.driven], drive


def _said_of(way: str, drive: str, locale: Locale, spell: Speller) -> str:
    of_drive = LoadWords([drive], spell.couples)
    return locale.with_friction[way].format(drive=spelled(Symbol(drive), spell), of_drive=of_drive)


def headings(firsts: Iterable[Analysis], locale: Locale, spell: Speller) -> list[str]:
    """Return the headings of results that come first under them, a common one only once.

    User-defined formulas are further quantities behind results that have a kind.
    """
    said, last = list[str](), ""
    for first in firsts:
        own = heading(first, locale, spell) or (locale.further if last else "")
        said.append("" if own == last == locale.further else own)
        last = own
    return said


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


def ratio(result: Analysis) -> Formula | None:
    """Return the ratio that was asked for, ``P/F`` or ``V_D/V_A``; None for anything else.

    None as well where the formula of the result is the ratio, and of an efficiency whose
    formula holds for either side that drives, with the sign of k: it is k/k_f or k_f/k.
    """
    match result.target:
        case LoadRatio(above, below):
            return quotient(Symbol(above), Symbol(below))
        case SpeedRatio(above, below):
            return quotient(Symbol(above.name), Symbol(below.name))
        case Efficiency():
            share = _share(result)
            return None if share == result.formula or _has_sign(result.formula) else share
        case _:
            return None


def _share(result: Analysis) -> Formula:
    """Return ``k/k_f``, or ``k_f/k`` where the load drives; 0 where friction then holds it."""
    assert isinstance(result.target, Efficiency)
    name = result.name.removeprefix("eta_")
    ideal, real = Symbol(name), Symbol(f"{name}_f")
    drives = result.target.sense == "tightening" if result.driven is None else not result.driven
    is_below = drives or result.formula == ZERO or (result.driven is None and result.default == 0)
    share = quotient(ideal, real) if is_below else quotient(real, ideal)
    is_held = is_call(result.formula, "max")
    return Call("max", (share, ZERO)) if is_held else share


def _has_sign(formula: Formula) -> bool:
    return any(is_call(part, "sign") for part in walk(formula))


def asked(result: Analysis) -> Formula:
    """Return the result's own symbol; a ratio that was given no name stands for itself."""
    asked_for = ratio(result)
    return asked_for if asked_for and is_nameless(result) else Symbol(called(result))


def called(result: Analysis) -> str:
    """Return a result's name in print; the direction of a force has an angle's letter."""
    force = reaction(result)
    if force and force.part == "direction":
        return f"phi_{result.name.replace('_direction', '')}"
    return result.name


def reaction(result: Analysis) -> Reaction | None:
    """Return the force that a result is a part of, with friction or without it."""
    match result.target:
        case Reaction() as force:
            return force
        case WithFriction(Reaction() as force):
            return force
        case _:
            return None


def is_direction(result: Analysis) -> bool:
    """Return whether a result is the direction of a force, which has none where it is zero."""
    force = reaction(result)
    return force is not None and force.part == "direction"


def result_symbol(name: str) -> Formula:
    """Return the symbol of a result; of a ratio without a name of its own, the ratio.

    >>> from ...formula.to_text import text
    >>> text(result_symbol("k")), text(result_symbol("M_1_over_M_2"))
    ('k', 'M_1/M_2')
    """
    above, *below = map(Symbol, split_ratio(name))
    return quotient(above, *below) if below else above


def is_nameless(result: Analysis) -> bool:
    """Return whether a ratio's name was made up (``V_D_over_V_A``); its efficiency has eta."""
    return len(split_ratio(result.name)) > 1 and not isinstance(result.target, Efficiency)


def remarks(result: Analysis, locale: Locale, spell: Speller) -> tuple[str, ...]:
    """Return the remarks on a result: limits, proportions, symmetries, trends, locking."""
    symbol = spelled(asked(result), spell)
    if result.same_as:
        other = spelled(result_symbol(result.same_as), spell)
        senses = _senses(result, symbol, locale, spell)
        same = locale.same_as.format(result=symbol, other=other)
        return (*(senses if isinstance(result.target, SpeedRatio) else ()), same)
    if result.inverse_of:
        return (_inverse(result, symbol, locale, spell),)
    said = _holds(result, locale, spell) + _senses(result, symbol, locale, spell)
    if result.multiple_of:
        said += _as_other(result, result.multiple_of, symbol, locale, spell)
        said += _proportions(result, locale, spell)
        return (*said, *_independent(result, symbol, locale, spell))
    said += limits(result, symbol, locale, spell)
    said += [_infinite(symbol, b, locale, spell) for b in result.breaks]
    said += _proportions(result, locale, spell)
    said += _independent(result, symbol, locale, spell)
    said += _swaps(result, symbol, locale, spell)
    said += _trends(result, symbol, locale, spell)
    said += extents.extent_remarks(result, symbol, locale, spell)
    return (*said, *friction_remarks(result, locale, spell))


def _inverse(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> str:
    """Return the sentence on a result that is the inverse of a ratio, of which all was said."""
    other = spelled(result_symbol(result.inverse_of), spell)
    trends = ((n, trend) for n, trend in (result.trends or {}).items() if _is_news([n], result))
    moves = (trend in ("rises", "falls") for _, trend in trends)
    kinds = {"limits": bool(result.zeros or result.poles), "trends": any(moves)}
    said = [
        locale.inverse_of[kind].format(result=symbol, other=other)
        for kind, is_said in kinds.items()
        if is_said
    ]
    inverse = spell.relation(
        (asked(result), quotient(ONE, result_symbol(result.inverse_of))), ("=",), False
    )
    return f"{inverse}: {'; '.join(said)}." if said else f"{inverse}."


def _as_other(
    result: Analysis, other: Multiple, symbol: str, locale: Locale, spell: Speller
) -> list[str]:
    """Return the sentence on a result that is a multiple of a ratio, of which all was said."""
    trends = (result.trends or {}).items()
    moved = [n for n, trend in trends if trend in ("rises", "falls") and _is_news([n], result)]
    extremes = any(extent.least and not extent.is_monotone for extent in result.extents)
    names = {"result": symbol, "other": spelled(result_symbol(other.name), spell)}
    names["names"] = _symbols(moved, locale, spell) if moved else ""
    sense = "opposite " if other.is_negative else ""
    kinds = {
        "limits": bool(result.zeros or result.poles),
        f"{sense}trends": bool(moved),
        f"{sense}extremes": extremes,
    }
    said = [locale.multiple_of[k].format_map(names) for k, is_said in kinds.items() if is_said]
    times = product([(other.factor, 1), (result_symbol(other.name), 1)])
    equation = spell.relation((asked(result), times), ("=",), False)
    return [f"{equation}: {'; '.join(said)}."] if said else [f"{equation}."]


def _is_news(names: Iterable[str], result: Analysis) -> bool:
    """Return whether some of the names are none that the result is proportional to."""
    return any(name not in (result.proportional or {}) for name in names)


def _holds(result: Analysis, locale: Locale, spell: Speller) -> list[str]:
    if result.holds_as:
        return [locale.holds_as.format(result=spelled(result_symbol(result.holds_as), spell))]
    held = own_conditions(result)
    return [locale.holds.format(conditions=conditions(held, spell))] if held else []


def _senses(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> list[str]:
    """Return the sentences on a minus: of a ratio of velocities, as steps count them as they move.

    That of a load, or of a ratio of two, says which one acts against its arrow.
    """
    if (result.default or 0) >= 0:
        return []
    match result.target:
        case SpeedRatio(Speed("link"), Speed("link")):
            return [locale.opposite_senses]
        case SpeedRatio(above, below) if not (above.axis and below.axis):
            return [locale.opposite_along_guides]
        case LoadRatio(drive, load):
            return [_against(locale.against_load, symbol, drive, load, spell)]
        case LoadForm(drive) | WithFriction(LoadForm(drive)):
            return [_against(locale.against, symbol, drive, drive, spell)]
        case _:
            return []


def _against(template: str, symbol: str, drive: str, load: str, spell: Speller) -> str:
    of_drive, of_load = (LoadWords([name], spell.couples) for name in (drive, load))
    shown = (spelled(Symbol(name), spell) for name in (drive, load))
    names = dict(zip(("drive", "load"), shown, strict=True))
    return template.format(result=symbol, of_drive=of_drive, of_load=of_load, **names)


def _infinite(symbol: str, found: Break, locale: Locale, spell: Speller) -> str:
    condition = spell.relation((found.factor, ZERO), ("=",), False)
    name = spelled(Symbol(found.name), spell)
    return locale.infinite.format(result=symbol, condition=condition, name=name)


def _proportions(result: Analysis, locale: Locale, spell: Speller) -> list[str]:
    powers = {n: e for n, e in (result.proportional or {}).items() if e}
    if not powers:
        return []
    inverse = all(e < 0 for e in powers.values())
    template = locale.inverse if inverse else locale.proportional
    simple = product((Symbol(n), -e if inverse else e) for n, e in sorted(powers.items()))
    shown, factor = spelled(asked(result), spell), spelled(simple, spell)
    return [template.format(result=shown, factor=factor)]


def _swaps(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> Iterator[str]:
    """Yield which two parameters may change places, where no other remark says it."""
    for pair in result.swaps:
        if _is_news(pair, result):
            first, second = (spelled(Symbol(name), spell) for name in pair)
            yield locale.swaps.format(result=symbol, first=first, second=second)


def _independent(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> list[str]:
    """Return on which parameters a result does not depend, as a sentence, if there are any."""
    if not result.independent:
        return []
    names = joined((spelled(Symbol(n), spell) for n in result.independent), locale.negation)
    return [locale.independent.format(result=symbol, names=names)]


def _symbols(names: Iterable[str], locale: Locale, spell: Speller) -> str:
    return enumeration([spelled(Symbol(n), spell) for n in names], locale)


def _trends(result: Analysis, symbol: str, locale: Locale, spell: Speller) -> list[str]:
    """Return a sentence for each trend, on all parameters that have it in the same ranges."""
    groups: dict[tuple[Trend, ClaimScope], list[str]] = {}
    for parameter, trend in (result.trends or {}).items():
        if locale.trends[trend] and _is_news([parameter], result):
            groups.setdefault((trend, result.scopes[parameter]), []).append(parameter)
    return [
        locale.trends[trend].format(
            within=locale.within[scope], result=symbol, names=_symbols(names, locale, spell)
        )
        for (trend, scope), names in groups.items()
    ]


def own_conditions(result: Analysis) -> tuple[Require, ...]:
    """Return the conditions of a case, of an efficiency what the ratio's sign must be.

    Else it has those of what it is made of.
    """
    if not isinstance(result.target, Efficiency):
        return result.holds
    ratio = Symbol(result.name.removeprefix("eta_"))
    return tuple(h for h in result.holds if h.left == ratio)


def conditions(requires: Iterable[Require], spell: Speller) -> str:
    """Return the conditions of use, the links of a chain joined again.

    They are as they were written, but for what they ask of the pose, as the direction of a link:
    that is in the names that the position has introduced.
    """
    chains: list[tuple[tuple[Formula, ...], tuple[str, ...]]] = []
    for require in requires:
        shown = _shown(require)
        if chains and chains[-1][0][-1] == shown.left:
            sides, signs = chains.pop()
            chains.append(((*sides, shown.right), (*signs, require.operator)))
        else:
            chains.append(((shown.left, shown.right), (require.operator,)))
    return ", ".join(
        spell.relation(sides, signs, any(is_angle(s, spell.angles) for s in sides))
        for sides, signs in chains
    )


def _shown(require: Require) -> WrittenSides:
    made = WrittenSides(require.left, require.right)
    written = require.written or made
    return WrittenSides(
        made.left if _asks_of_the_pose(written.left) else written.left,
        made.right if _asks_of_the_pose(written.right) else written.right,
    )


def _asks_of_the_pose(side: Formula) -> bool:
    forms = filter(None, map(form_of_pose, symbols(side)))
    return any(form.prefix in ("phi", "len", "x", "y") for form in forms)
