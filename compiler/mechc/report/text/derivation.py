"""The derivation for the terminal: numbered steps, the rule in words, what it gives."""

import re
from collections.abc import Iterable, Iterator, Mapping
from textwrap import wrap
from typing import NamedTuple

from ...formula.layout import is_angle
from ...formula.tree import ZERO, Formula, Symbol
from ...formula.walk import evaluate
from ...frozen import replace
from ...model.mechanism import GRAVITY, Mechanism, Parameter
from ...model.result import Definition
from ...model.sheets import is_sheet
from ...study.analysis import Analysis
from ...units import ANGLE, in_unit
from ..brief import needed, relations, short
from ..definitions import Solved, grouped
from ..derivation.steps import Derivation, LastStep, Step
from ..evaluated import Evaluated, evaluated
from ..languages.en import LOCALE
from ..put_in import Quantity, in_degrees
from ..sections import PositionSection, Section, outline
from ..sentences.remarks import asked, conditions, heading, is_nameless, ratio, remarks, said
from ..sentences.wording import Sides, lines, position_sentence, sentence
from . import note
from .printer import ASCII, UNICODE, Signs, print_point, print_side

SHOWN = 6
"""Significant digits of values."""

WIDTH = 80
"""Columns that lines keep to where they can."""

_DEEP = " " * 8
_INNERMOST = re.compile(r"\([^()]*\)")


class Speller(NamedTuple):
    """Mathematics inside a sentence, with the signs of a terminal."""

    signs: Signs

    @property
    def angles(self) -> frozenset[str]:
        """Return the names that are angles."""
        return self.signs.angles

    def relation(self, sides: tuple[Formula, ...], signs: tuple[str, ...], angle: bool) -> str:
        """Return sides joined by signs."""
        line = print_side(sides[0], self.signs, angle)
        for sign, side in zip(signs, sides[1:], strict=True):
            shown = self.signs.relations.get(sign, sign)
            line += f" {shown} {print_side(side, self.signs, angle)}"
        return line

    def number(self, value: float) -> str:
        """Return a number that was computed."""
        return f"{value:.{SHOWN}g}".replace("-", self.signs.minus)

    def quantity(self, quantity: Quantity) -> str:
        """Return a value in its unit, an angle in degrees."""
        if quantity.unit != "deg":
            return quantity.text(SHOWN)
        return print_side(in_degrees(quantity.value, SHOWN), self.signs, True)

    def point(self, names: str) -> str:
        """Return a point, a link or a vector."""
        return print_point(names, self.signs)

    def literal(self, literal: Parameter) -> str:
        """Return the line on a length that is given by a number."""
        assert literal.value
        name = self.relation((Symbol(literal.name),), (), False)
        value = in_unit(evaluate(literal.value, {}), literal.unit, 10)
        return f"{_DEEP}{name} = {value.replace('-', self.signs.minus)}"


def render(
    derivation: Derivation, mechanism: Mechanism, *, unicode: bool = True, numbers: bool = True
) -> str:
    """Return the derivation as text, ending in a line feed.

    Velocities are named ``V_A``, angular velocities ``ω_OA``; with ``unicode`` False
    only ASCII characters are used in formulas. Lines keep to 80 columns, except a
    formula that has no place to break. Of a calculation sheet it is the calculation.
    ``numbers`` adds what the formulas come to at the default pose.
    """
    if is_sheet(mechanism):
        return note.render(mechanism, derivation.results, unicode)
    spell = speller(derivation, mechanism, unicode)
    whole = outline(derivation, mechanism)
    lines = [*_title(mechanism), *_position(whole.position, spell)]
    lines += [*_velocities(derivation, spell), *_power(derivation, spell)]
    before = ""
    for section in whole.results:
        title = heading(section.results[0], LOCALE, spell) or LOCALE.results
        again = title == before == LOCALE.results
        lines += ["", *([] if again else [title]), *_section(section, spell)]
        before = title
    if numbers:
        lines += _numbers(evaluated(whole, mechanism), spell)
    if mechanism.requires:
        lines += [
            "",
            *_wrapped(f"{LOCALE.requirements} {conditions(mechanism.requires, spell)}.", ""),
        ]
    return "\n".join(line.rstrip() for line in lines).lstrip("\n") + "\n"


def render_brief(
    derivation: Derivation, mechanism: Mechanism, *, unicode: bool = True, numbers: bool = True
) -> str:
    """Return the formulas of a derivation as text: of the position, the speeds, the results.

    What else is asked for is as for :func:`render`.
    """
    if is_sheet(mechanism):
        return note.render(mechanism, derivation.results, unicode)
    spell = speller(derivation, mechanism, unicode)
    whole = outline(derivation, mechanism)
    position = [line for p in whole.position for line in _where(p.literals, p.where, spell, {})]
    results = _equations(needed(derivation), spell)
    for section in whole.results:
        results += _equations([e for p in section.paragraphs for e in p.equations], spell)
        results += [line for r in section.results for line in _result(r, spell, section.units)]
        results += _where(section.literals, section.where, spell, section.units)
    parts = [_title(mechanism), position, _equations(relations(derivation), spell), results]
    text = "\n\n".join("\n".join(part) for part in parts if part) + "\n"
    found = short(evaluated(whole, mechanism), derivation) if numbers else ()
    return text + "".join(f"{line.rstrip()}\n" for line in _numbers(found, spell))


def _numbers(values: Iterable[Evaluated], spell: Speller) -> Iterator[str]:
    """Yield what formulas come to at the default pose, with the numbers put in."""
    found = tuple(values)
    if found:
        yield from ("", LOCALE.numbers, f"     {LOCALE.at_default}:")
    for left, numbers, value, angle in found:
        sides = [spell.relation((left,), (), False)]
        sides += [spell.relation((numbers,), (), angle)] if numbers else []
        sides.append(spell.quantity(value))
        yield from _broken(" = ".join(sides).replace("-", spell.signs.minus))


def speller(derivation: Derivation, mechanism: Mechanism, unicode: bool) -> Speller:
    """Return what spells mathematics, with the names that are angles in this mechanism."""
    angles = {p.name for p in mechanism.parameters if p.dimension == ANGLE}
    for result in derivation.results:
        for definition in result.where:
            if is_angle(definition.formula, angles):
                angles.add(definition.name)
    return Speller(replace(UNICODE if unicode else ASCII, angles=frozenset(angles)))


def _title(mechanism: Mechanism) -> list[str]:
    return [*_wrapped(mechanism.title or mechanism.name, ""), *_wrapped(mechanism.source, "")]


def _position(position: Iterable[PositionSection], spell: Speller) -> Iterator[str]:
    for number, section in enumerate(position, 1):
        if number == 1:
            yield from ("", LOCALE.position)
        yield from _wrapped(position_sentence(section.step, LOCALE, spell.point), f"{number:>3}. ")
        yield from _where(section.literals, section.where, spell, {})


def _where(
    literals: Iterable[Parameter],
    where: Iterable[Definition],
    spell: Speller,
    units: Mapping[str, str],
) -> Iterator[str]:
    yield from map(spell.literal, literals)
    for group in grouped(where):
        yield from _group(group, spell, units)


def _velocities(derivation: Derivation, spell: Speller) -> Iterator[str]:
    if not derivation.steps:
        return
    yield from ("", LOCALE.velocities)
    for number, step in enumerate(derivation.steps, 1):
        yield from _step(number, step, spell)


def _step(number: int, step: Step, spell: Speller) -> Iterator[str]:
    yield from _wrapped(sentence(step, LOCALE, spell.point), f"{number:>3}. ")
    said, hence = lines(step)
    yield from _equations((*said, *hence), spell)


def _power(derivation: Derivation, spell: Speller) -> Iterator[str]:
    if derivation.balances:
        yield from ("", LOCALE.power)
        yield from _wrapped(LOCALE.power_rule, "     ")
        yield from _equations(derivation.balances, spell)
    for step in derivation.last_steps:
        yield from _last(step, spell)


def _last(step: LastStep, spell: Speller) -> Iterator[str]:
    if step.chain:
        ratio, links, product = step.chain
        shown = [spell.relation((side,), (), False) for side in (ratio, *links, product)]
        times = " · " if spell.signs.fancy else " * "
        yield from _broken(f"{shown[0]} = {times.join(shown[1:-1])} = {shown[-1]}")
    yield from _equations((step.ratio,), spell)


def _section(section: Section, spell: Speller) -> Iterator[str]:
    for paragraph in section.paragraphs:
        yield from _wrapped(said(paragraph, LOCALE, spell), "     ")
        yield from _equations(paragraph.equations, spell)
    if section.paragraphs:
        yield f"     {LOCALE.hence}"
    for result in section.results:
        yield from _result(result, spell, section.units)
    if section.where or section.literals:
        yield f"     {LOCALE.where}"
        yield from _where(section.literals, section.where, spell, section.units)
    if section.has_usual_g:
        yield f"{_DEEP}g = {float(GRAVITY.value)} m/s{'²' if spell.signs.fancy else '^2'}"
    for result in section.results:
        for remark in remarks(result, LOCALE, spell):
            yield from _wrapped(remark, "   - ")


def _result(result: Analysis, spell: Speller, units: Mapping[str, str]) -> list[str]:
    asked_for = ratio(result)
    left = (asked(result),) if is_nameless(result) or not asked_for else (asked(result), asked_for)
    angle = result.dimension == ANGLE or is_angle(result.formula, spell.angles)
    whole = spell.relation((*left, result.formula), ("=",) * len(left), angle)
    return _broken(whole + _unit(result.name, units, spell))


def _unit(name: str, units: Mapping[str, str], spell: Speller) -> str:
    """Return the unit behind a load that is a number, '' behind anything else."""
    unit = units.get(name, "")
    return f" {unit.replace('*', '·') if spell.signs.fancy else unit}".rstrip()


def _group(group: Definition | Solved, spell: Speller, units: Mapping[str, str]) -> Iterator[str]:
    if isinstance(group, Definition):
        left = spell.relation((Symbol(group.name),), (), False)
        right = spell.relation((group.formula,), (), group.name in spell.angles)
        yield from _broken(f"{left} = {right}{_unit(group.name, units, spell)}")
    else:
        names = ", ".join(spell.relation((Symbol(n),), (), False) for n in group.names)
        yield from _wrapped(LOCALE.solve.format(names=names), _DEEP)
        for zero in group.zeros:
            yield from _broken(spell.relation((zero, ZERO), ("=",), False))


def _equations(equations: Iterable[Sides], spell: Speller) -> list[str]:
    """Return equations, aligned at the first equals sign where that costs no width."""
    rows = [[spell.relation((side,), (), False) for side in e] for e in equations]
    widest = max((len(row[0]) for row in rows), default=0)
    aligned = [" = ".join((row[0].rjust(widest), *row[1:])) for row in rows]
    if max(map(len, aligned), default=0) > WIDTH - len(_DEEP):
        aligned = [line.lstrip() for line in aligned]
    return [part for line in aligned for part in _broken(line)]


def _broken(equation: str) -> list[str]:
    """Break a long equation at the spaces around its signs, not within ``sin(α + β)``."""
    indent = _DEEP + " " * (len(equation) - len(equation.lstrip()))
    tied = _INNERMOST.sub(lambda m: m[0].replace(" ", "\u00a0"), equation.lstrip())
    lines = wrap(
        tied,
        WIDTH,
        initial_indent=indent,
        subsequent_indent=indent + "    ",
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace("\u00a0", " ") for line in lines]


def _wrapped(text: str, lead: str) -> list[str]:
    hanging = " " * len(lead)
    return wrap(text, WIDTH, initial_indent=lead, subsequent_indent=hanging, break_long_words=False)
