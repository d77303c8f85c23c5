"""The derivation for the terminal: numbered steps, the rule in words, what it gives."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Sized
from itertools import chain
from math import isnan

from ...formula.layout import is_angle
from ...formula.tree import Formula, Implicit, Symbol
from ...model.mechanism import GRAVITY, Mechanism, Parameter
from ...model.result import Definition
from ...model.statements import is_sheet
from ...study.analysis import Analysis
from ...study.variables import scale_of
from ...units import ANGLE
from ..brief import needed, relations, short
from ..by_parts import by_parts
from ..definitions import SolvedSystem, grouped, looked_up, stated_above, without_minus
from ..digits import VALUE_DIGITS
from ..evaluated import Evaluated, evaluated, following, has_atan2, hides_units, named_directions
from ..made_names import MadeNames, names_of, points_of
from ..sections import PositionSection, ReportOutline, Section, outline
from ..sentences.powers import power_remarks
from ..sentences.remarks import asked, conditions, headings, is_nameless, ratio, remarks, said
from ..sentences.wording import (
    EquationSides,
    direction_function,
    directions_named,
    lines,
    position_sentences,
    sentences,
)
from ..steps import Derivation, LastStep, names_met
from . import note
from .given import given
from .speller import DEEP, LINE_COLUMNS, LINES, TextSpeller, speller


def render(
    derivation: Derivation,
    mechanism: Mechanism,
    *,
    unicode: bool = True,
    numbers: bool = True,
    language: str = "en",
    width: int = LINE_COLUMNS,
) -> str:
    """Return the derivation as text, ending in a line feed.

    Velocities are named ``V_A``, angular velocities ``ω_OA``; with ``unicode`` False
    only ASCII characters are used in formulas. Lines keep to ``width`` columns, except
    a formula that has no place to break. Of a calculation sheet it is the calculation.
    ``numbers`` adds what the formulas come to at the default pose.
    """
    spell = speller(derivation.results, mechanism, unicode, language, width)
    if is_sheet(mechanism):
        return note.render(mechanism, derivation.results, spell)
    whole = outline(derivation, mechanism, stated_above(mechanism))
    spell = spell.naming(_formulas(whole, derivation), _names(derivation, mechanism))
    tables = note.tables(mechanism.tables, spell)
    met = names_met(derivation, mechanism)
    found = [*evaluated(whole, mechanism)] if numbers else []
    values = following(mechanism, {item.left for item in found}) if numbers else {}
    defined = {d.name for r in derivation.results for d in r.where}
    lines = [
        *_title(mechanism, spell),
        *given(mechanism, met, spell, defined, values),
        *(["", *tables] if tables else []),
        *_conventions(whole, mechanism, met, spell),
        *_position(whole.position, spell),
    ]
    lines += [*_velocities(derivation, spell), *_power(derivation, mechanism, spell)]
    lines += _results(whole.results, spell)
    lines += _numbers(found, spell) if numbers else []
    lines += _jumps(derivation.results, mechanism, spell) if numbers else []
    if derivation.requires:
        demand = f"{spell.locale.requirements} {conditions(derivation.requires, spell)}."
        lines += ["", *spell.wrapped(demand, "")]
    return "\n".join(line.rstrip() for line in lines).lstrip("\n") + "\n"


def _names(derivation: Derivation, mechanism: Mechanism) -> MadeNames:
    """Return names to be made up, but for those that mean something on the page."""
    made = MadeNames()
    made.take(names_of(mechanism, derivation.results))
    made.take_points(points_of(mechanism))
    return made


def _formulas(whole: ReportOutline, derivation: Derivation) -> Iterator[Formula]:
    """Yield the sides of the equations of a page from the velocities on."""
    for step in derivation.steps:
        for sides in chain(*lines(step)):
            yield from sides
    for last in derivation.last_steps:
        yield from (last.chain.product, last.ratio.right) if last.chain else last.ratio
    for section in whole.results:
        yield from (side for p in section.paragraphs for pair in p.equations for side in pair)
        yield from (r.formula for r in section.results if r.name not in section.lines)
        yield from (d.formula for d in section.where if not isinstance(d.formula, Implicit))


def _results(sections: Sequence[Section], spell: TextSpeller) -> Iterator[str]:
    """Yield the sections on results, each under its heading."""
    titles = headings((section.results[0] for section in sections), spell.locale, spell)
    for number, (section, title) in enumerate(zip(sections, titles, strict=True)):
        title = title or ("" if number else spell.locale.results)
        yield from ("", *([title] if title else []), *_section(section, spell))


def render_brief(
    derivation: Derivation,
    mechanism: Mechanism,
    *,
    unicode: bool = True,
    numbers: bool = True,
    language: str = "en",
    width: int = LINE_COLUMNS,
) -> str:
    """Return the formulas of a derivation as text: of the position, the speeds, the results.

    What else is asked for is as for :func:`render`.
    """
    spell = speller(derivation.results, mechanism, unicode, language, width)
    if is_sheet(mechanism):
        return note.render(mechanism, derivation.results, spell)
    whole = outline(derivation, mechanism, looked_up(mechanism))
    spell = spell.naming(_formulas(whole, derivation), _names(derivation, mechanism))
    position = [line for p in whole.position for line in _where(p.literals, p.where, spell, {})]
    results = _equations(needed(derivation), spell)
    for section in whole.results:
        results += _equations([e for p in section.paragraphs for e in p.equations], spell)
        results += [line for r in section.results for line in _result(r, spell, section)]
        results += _where(section.literals, section.where, spell, section.units)
    parts = [_title(mechanism, spell), position, _equations(relations(derivation), spell), results]
    text = "\n\n".join("\n".join(part) for part in parts if part) + "\n"
    found = short(evaluated(whole, mechanism), derivation, mechanism) if numbers else ()
    return text + "".join(f"{line.rstrip()}\n" for line in _numbers(found, spell))


def _numbers(values: Iterable[Evaluated], spell: TextSpeller) -> Iterator[str]:
    """Yield the values of formulas at the default pose, with the numbers put in."""
    sums = spell.parts.sums if spell.parts else {}
    found = tuple(by_parts(values, sums, lambda item: _fits(item, spell)))
    if found:
        yield from ("", spell.locale.numbers, f"     {spell.locale.at_default}:")
    for left, numbers, value, angle, *_ in found:
        sides = [spell.relation((left,), (), False)]
        sides += [spell.relation((numbers,), (), angle)] if numbers else []
        sides.append(spell.quantity(value))
        whole = " = ".join(sides).replace("-", spell.signs.minus)
        yield from spell.broken(spell.units(whole))


def _jumps(results: Iterable[Analysis], mechanism: Mechanism, spell: TextSpeller) -> Iterator[str]:
    """Yield between what values results jump at the default pose."""
    for result in results:
        if len(result.sides) == 2 and not any(map(isnan, result.sides)):
            unit, name = scale_of(result, mechanism), spell.relation((asked(result),), (), False)
            low, high = (spell.measured(side, unit, VALUE_DIGITS) for side in result.sides)
            said = spell.locale.checked["jumps"].format(low=low, high=high)
            yield from spell.broken(f"{name}: {said}".replace("-", spell.signs.minus))


def _fits(item: Evaluated, spell: TextSpeller) -> bool:
    """Return whether a formula is shown with its numbers; with names for its parts, if short."""
    if item.numbers is None:
        return False
    if item.formula is None or not spell.parts:
        return True
    is_named = spell.parts.shown(item.formula) != item.formula
    room = LINES * spell.width
    return not is_named or len(spell.relation((item.numbers,), (), item.angle)) <= room


def _title(mechanism: Mechanism, spell: TextSpeller) -> list[str]:
    said = (mechanism.title or mechanism.name, mechanism.source)
    return [line for text in said for line in spell.wrapped(spell.text(text), "")]


def _conventions(
    whole: ReportOutline, mechanism: Mechanism, met: Collection[str], spell: TextSpeller
) -> Iterator[str]:
    if hides_units(whole, mechanism):
        yield from spell.wrapped(spell.locale.plain_numbers, "  ")
    if named := directions_named(named_directions(whole, mechanism, met), spell.locale, spell):
        yield from spell.wrapped(named, "  ")
    if has_atan2(whole):
        yield from spell.wrapped(direction_function(spell.locale, spell), "  ")


def _position(position: Iterable[PositionSection], spell: TextSpeller) -> Iterator[str]:
    sections = [*position]
    said = position_sentences((s.step for s in sections), spell.locale, spell)
    if sections:
        yield from ("", spell.locale.position)
    for number, section, words in zip(_numbers_of(sections), sections, said, strict=True):
        yield from spell.wrapped(words, number)
        yield from _where((), section.where, spell, {})


def _numbers_of(steps: Sized) -> list[str]:
    """Return the numbers of steps, blanks where there is only one."""
    several = len(steps) > 1
    return [f"{i:>3}. " if several else " " * 5 for i in range(1, len(steps) + 1)]


def _where(
    literals: Iterable[Parameter],
    where: Iterable[Definition],
    spell: TextSpeller,
    units: Mapping[str, str],
) -> Iterator[str]:
    yield from map(spell.literal, literals)
    for group in grouped(where):
        yield from _group(group, spell, units)


def _velocities(derivation: Derivation, spell: TextSpeller) -> Iterator[str]:
    """Yield the steps to the speeds, each a sentence with its equations."""
    if not derivation.steps:
        return
    several = len(derivation.balances) > 1
    convention = spell.locale.signed if several else spell.locale.magnitudes
    yield from ("", spell.locale.velocities, *spell.wrapped(convention, "     "))
    words = sentences(derivation.steps, spell.locale, spell.point)
    steps = derivation.steps
    yield from [""] * (len(steps) == 1)
    for number, step, sentence in zip(_numbers_of(steps), steps, words, strict=True):
        yield from spell.wrapped(sentence, number)
        said, hence = lines(step)
        yield from _equations((*said, *hence), spell)


def _power(derivation: Derivation, mechanism: Mechanism, spell: TextSpeller) -> Iterator[str]:
    if derivation.balances:
        explained = power_remarks(derivation, mechanism, spell.locale, spell)
        yield from ("", spell.locale.power)
        yield from spell.wrapped(f"{spell.locale.power_rule} {explained}".rstrip(), "     ")
        yield from _equations(derivation.balances, spell)
    for step in derivation.last_steps:
        yield from _last(step, spell)


def _last(step: LastStep, spell: TextSpeller) -> Iterator[str]:
    if step.chain:
        ratio, links, product = step.chain
        shown = [spell.relation((side,), (), False) for side in (ratio, *links, product)]
        times = " · " if spell.signs.fancy else " * "
        yield from spell.broken(f"{shown[0]} = {times.join(shown[1:-1])} = {shown[-1]}")
        yield from _made([product], spell)
    yield from _equations((step.ratio,), spell)


def _section(section: Section, spell: TextSpeller) -> Iterator[str]:
    """Yield how results of one section come about, the results, and what they rest on."""
    for paragraph in section.paragraphs:
        yield from spell.wrapped(said(paragraph, spell.locale, spell), "     ")
        yield from _equations(paragraph.equations, spell)
    if section.paragraphs and section.paragraphs[-1].equations:
        yield f"     {spell.locale.hence}"
    for result in section.results:
        if result.name in section.lines and (label := section.lines[result.name].label):
            yield from spell.wrapped(f"{spell.text(label)}:", "     ")
        yield from _result(result, spell, section)
    if section.where:
        yield f"     {spell.locale.where}"
        yield from _where((), section.where, spell, section.units)
    if section.has_usual_g:
        unit = "m/s²" if spell.signs.fancy else "m/s^2"
        yield spell.units(f"{DEEP}g = {float(GRAVITY.value)} {unit}")
    for result in section.results:
        for remark in remarks(result, spell.locale, spell):
            yield from spell.wrapped(remark, "   - ")


def _result(result: Analysis, spell: TextSpeller, section: Section) -> list[str]:
    if line := section.lines.get(result.name):
        return spell.broken(spell.units(note.formula_alone(line, spell)))
    asked_for = ratio(result)
    left = (asked(result),) if is_nameless(result) or not asked_for else (asked(result), asked_for)
    angle = result.dimension == ANGLE or is_angle(result.formula, spell.angles)
    whole = spell.relation((*left, result.formula), ("=",) * len(left), angle)
    shown = spell.broken(whole + _unit(result.name, section.units, spell))
    return shown + list(_made([result.formula], spell))


def _unit(name: str, units: Mapping[str, str], spell: TextSpeller) -> str:
    """Return the unit behind a load or a measure that is a number, '' behind anything else."""
    unit = units.get(name, "")
    if unit == "deg":
        return spell.signs.degree
    letters = f" {spell.unit(unit)}"
    return (letters.replace("*", "·") if spell.signs.fancy else letters).rstrip()


def _group(
    group: Definition | SolvedSystem, spell: TextSpeller, units: Mapping[str, str]
) -> Iterator[str]:
    """Yield a definition, or the equations of a system with the names that they are solved for."""
    if isinstance(group, Definition):
        left = spell.relation((Symbol(group.name),), (), False)
        angle = is_angle(Symbol(group.name), spell.angles)
        right = spell.relation((group.formula,), (), angle)
        yield from spell.broken(f"{left} = {right}{_unit(group.name, units, spell)}")
    else:
        names = ", ".join(spell.relation((Symbol(n),), (), False) for n in group.names)
        yield from spell.wrapped(spell.locale.solve.format(names=names), DEEP)
        for zero in group.zeros:
            yield from spell.broken(spell.relation(without_minus(zero), ("=",), False))


def _equations(equations: Iterable[EquationSides], spell: TextSpeller) -> list[str]:
    """Return equations, aligned at the first equals sign where that costs no width."""
    equations = tuple(equations)
    rows = [[spell.relation((side,), (), False) for side in e] for e in equations]
    widest = max((len(row[0]) for row in rows), default=0)
    aligned = [" = ".join((row[0].rjust(widest), *row[1:])) for row in rows]
    if max(map(len, aligned), default=0) > spell.width - len(DEEP):
        aligned = [line.lstrip() for line in aligned]
    shown = [part for line in aligned for part in spell.broken(line)]
    return shown + list(_made((side for e in equations for side in e), spell))


def _made(formulas: Iterable[Formula], spell: TextSpeller) -> Iterator[str]:
    """Yield the names that are new in formulas of the page, with what they stand for."""
    fresh = [*spell.parts.fresh(formulas)] if spell.parts else []
    if fresh:
        yield f"     {spell.locale.where}"
    for definition in fresh:
        yield from _group(definition, spell, {})
