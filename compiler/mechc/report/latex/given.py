"""The report's first part: what was given, as tables and sentences."""

from collections.abc import Iterable, Iterator, Set
from typing import NamedTuple, assert_never

from ...formula.names import split_points
from ...formula.tree import ZERO, Formula, Sum, number
from ...formula.walk import symbols
from ...model.mechanism import (
    GRAVITY,
    Arrow,
    Force,
    Geometry,
    Load,
    Mechanism,
    Offset,
    Parameter,
    Thrust,
    Torque,
    Turn,
)
from ...units import DIMENSIONS
from ..definitions import by_letter, literal_unit, takes_usual_g
from ..languages.locale import Words
from ..sentences.wording import enumeration
from .directions import direction, math
from .friction import rubbing_sentences
from .joints import joint_sentences
from .notation import Notation, name, points
from .printer import latex
from .quantity import length_of, quantity, unit_symbol, usual_unit
from .text import escape


class ParameterRow(NamedTuple):
    """A line of the table of parameters, ready for LaTeX."""

    symbol: str
    label: str
    value: str
    range: str


class VectorRow(NamedTuple):
    """A line of the table of the geometry, ready for LaTeX."""

    vector: str
    length: str
    direction: str


def parameter_row(parameter: Parameter, words: Words, style: Notation) -> ParameterRow:
    """Return a parameter's symbol, label, value and range with the user's units."""
    label = "; ".join(t for t in (parameter.label, parameter.about) if t)
    return ParameterRow(
        math(name(parameter.name, style)),
        escape(label),
        _value(parameter, words, style),
        _range(parameter, words, style),
    )


def _value(parameter: Parameter, words: Words, style: Notation) -> str:
    if parameter.value is None:
        return words.any_value
    if parameter.dependent:
        return math(latex(parameter.value, style, parameter.name in style.angles))
    dimension, unit = parameter.dimension, parameter.unit
    value = quantity(parameter.value, dimension, unit, words, style)
    if parameter.tolerance is None:
        return math(value)
    mark = unit_symbol(unit or usual_unit(dimension), words)
    off = quantity(parameter.tolerance, dimension, unit, words, style)
    if mark:
        return math(rf"({value.removesuffix(mark)} \pm {off.removesuffix(mark)}){mark}")
    return math(rf"{value} \pm {off}")


def _range(parameter: Parameter, words: Words, style: Notation) -> str:
    if parameter.range is None:
        return ""
    dimension, unit = parameter.dimension, parameter.unit
    low, high = (quantity(end, dimension, unit, words, style) for end in parameter.range)
    mark = unit_symbol(unit or usual_unit(dimension), words)
    if mark.startswith(r"\,"):
        low = low.removesuffix(mark)
    return math(rf"{low}\ \ldots\ {{{high}}}")


def vector_row(entry: Geometry, words: Words, style: Notation) -> VectorRow:
    """Return one entry of the geometry."""
    match entry:
        case Arrow(tail, head, length, line):
            along = math(direction(line, style)) if line else ""
            size = math(length_of(length, words, style)) if length else ""
            return VectorRow(_vector(tail, head), size, along)
        case Offset(tail, head, x, y):
            across, up = (length_of(part, words, style) for part in (x, y))
            return VectorRow(_vector(tail, head), math(rf"({across};\ {up})"), "")
        case Turn(first, vertex, second, angle):
            corner = rf"\angle {''.join(map(points, (first, vertex, second)))}"
            return VectorRow(math(corner), "", math(latex(angle, style, angle=True)))
        case _:
            assert_never(entry)


def has_literal_lengths(geometry: Iterable[Geometry]) -> bool:
    """Tell whether a length of the geometry is given by a number."""
    return any(map(_has_number, _lengths(geometry)))


def _lengths(geometry: Iterable[Geometry]) -> Iterator[Formula]:
    for entry in geometry:
        match entry:
            case Arrow(length=length) if length is not None:
                yield length
            case Offset(x=x, y=y):
                yield from (x, y)


def _has_number(length: Formula) -> bool:
    """Tell whether a term of a length has no symbol: it is a number of metres."""
    if isinstance(length, Sum):
        return any(map(_has_number, length.terms))
    return length != ZERO and not symbols(length)


def _vector(tail: str, head: str) -> str:
    return math(points(tail) + points(head) if tail else points(head))


def scheme(mechanism: Mechanism, words: Words, style: Notation) -> tuple[str, ...]:
    """Return the mechanism in sentences: joints, links, loads, symmetry."""
    sentences = [*_joints(mechanism, words, style), *_links(mechanism, words)]
    sentences += joint_sentences(mechanism, words, style)
    links = {link.name for link in mechanism.links}
    sentences += (_load(load, links, words, style) for load in mechanism.loads)
    sentences += rubbing_sentences(mechanism, words, style)
    sentences += _symmetry(mechanism, words, style)
    return tuple(f"{s[0].upper()}{s[1:]}." for s in dict.fromkeys(sentences))


def _joints(mechanism: Mechanism, words: Words, style: Notation) -> list[str]:
    pivots = _listed((p.point for p in mechanism.pivots if split_points(p.point)), words)
    sentences = [words.pivots.format(points=pivots)] if pivots else []
    for slider in mechanism.sliders:
        along = math(direction(slider.along, style))
        guided = words.slider.format(point=math(points(slider.point)), direction=along)
        through = slider.through and words.through.format(point=math(points(slider.through)))
        sentences.append(guided + (through or ""))
    return sentences


def _links(mechanism: Mechanism, words: Words) -> list[str]:
    rods = _listed((link.name for link in mechanism.links if len(link.points) == 2), words)
    bodies = _listed((link.name for link in mechanism.links if len(link.points) > 2), words)
    said = ((words.rods, rods), (words.bodies, bodies))
    return [template.format(links=links) for template, links in said if links]


def _listed(names: Iterable[str], words: Words) -> str:
    spelled = [math(points(n)) for n in names]
    return enumeration(spelled, words) if spelled else ""


def _end(point: str, link: str, links: Set[str], words: Words) -> str:
    """Return a point, and the link that carries a load there if one is named."""
    if link not in links:
        return math(points(point))
    return words.joints["on link"].format(point=math(points(point)), link=math(points(link)))


def _load(load: Load, links: Set[str], words: Words, style: Notation) -> str:
    symbol = name(load.name, style)
    if load.times != 1:
        symbol = rf"{latex(number(load.times), style)}\,{symbol}"
    tie = _tie(load, words, style) if load.tie else ""
    match load:
        case Force(_, point, along):
            template = words.weight if load.weight else words.force
            where, at = math(direction(along, style)), _end(point, load.link, links, words)
            said = template.format(load=math(symbol), point=at, direction=where)
        case Torque(_, link):
            said = words.torque.format(load=math(symbol), link=math(points(link)))
        case Thrust(_, first, second):
            kind = "spring" if load.spring else "actuator"
            ends = (first, load.first_link), (second, load.second_link)
            start, end = (_end(*each, links, words) for each in ends)
            said = words.joints[kind].format(load=math(symbol), first=start, second=end)
        case _:
            assert_never(load)
    return said + tie


def _tie(load: Load, words: Words, style: Notation) -> str:
    """Return what a load is tied to, with the value of g where a weight takes the usual one."""
    assert load.tie
    usual = takes_usual_g(load)
    tie = by_letter(load.tie) if usual else load.tie
    unit = unit_symbol(literal_unit(load), words)
    said = ", " + math(f"{name(load.name, style)}={latex(tie, style)}{unit}")
    if not usual:
        return said
    g = quantity(GRAVITY, DIMENSIONS["acceleration"], "m/s^2", words, style)
    return f"{said}, {math(f'g={g}')}"


def _symmetry(mechanism: Mechanism, words: Words, style: Notation) -> list[str]:
    sentences = []
    if mechanism.mirror:
        across = math(direction(mechanism.mirror.across, style))
        shared = _listed(mechanism.mirror.sharing, words)
        sentences.append(words.mirror.format(direction=across, points=shared))
    if mechanism.copies:
        count = math(latex(number(mechanism.copies.number), style))
        shared = _listed(mechanism.copies.sharing, words)
        sentences.append(words.copies.format(number=count, points=shared))
    return sentences
