"""The report's first part: what was given, as tables and sentences."""

from collections.abc import Iterable, Iterator, Mapping, Set
from typing import assert_never

from ...base.named import NamedTuple
from ...formula.names import split_points
from ...formula.tree import Constant, Formula, Symbol, number, product
from ...model.entries import unit_of_drawing
from ...model.mechanism import (
    GRAVITY,
    Arrow,
    Force,
    ForcePair,
    Geometry,
    Link,
    Load,
    Mechanism,
    Offset,
    Parameter,
    Pivot,
    Slider,
    Spread,
    Torque,
    Turn,
)
from ...model.parts.written import WrittenFormula
from ...model.values import is_constant, own_stroke
from ...units import DIMENSIONS
from ..definitions import by_letter, literal_unit, takes_usual_g
from ..languages.locale import Locale
from ..sentences.order import enumeration
from ..sentences.speller import number_of
from .friction import friction_sentences
from .joints import joint_sentences
from .notation import LatexNotation, name, points, translated
from .note import side
from .printer import latex
from .quantity import direction, length_of, math, quantity, spaced, spoken, usual_unit
from .text import escape
from .unit_symbols import unit_symbol


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


def parameter_row(
    parameter: Parameter,
    locale: Locale,
    style: LatexNotation,
    drive: str = "",
    value: Formula | None = None,
) -> ParameterRow:
    """Return a parameter's symbol, label, value and range with the user's units.

    That of the ``drive`` is called so where it has no text; one that follows from others may have
    a ``value`` behind its formula.
    """
    shown = _value(parameter, locale, style)
    if value is not None:
        known = quantity(value, parameter.dimension, parameter.unit, locale, style)
        shown = f"{shown} {math(f'= {known}')}"
    label = "; ".join(translated(t, style) for t in (parameter.label, parameter.about) if t)
    return ParameterRow(
        math(name(parameter.name, style)),
        label or (locale.driving if parameter.name == drive else ""),
        shown,
        _range(parameter, locale, style),
    )


def _value(parameter: Parameter, locale: Locale, style: LatexNotation) -> str:
    """Return a parameter's value in its unit, with its tolerance; as a formula if it follows."""
    if parameter.value is None:
        return locale.any_value
    if parameter.dependent and not is_constant(parameter):
        shown = parameter.written or WrittenFormula(parameter.value)
        return math(side(shown, shown.formula, style, parameter.name in style.angles).tex)
    dimension, unit = parameter.dimension, parameter.unit
    value = quantity(parameter.value, dimension, unit, locale, style)
    if parameter.tolerance is None:
        turn = quantity(parameter.value, dimension, "deg", locale, style)
        return f"{math(value)} {math(f'({turn})')}" if unit == "rad" else math(value)
    mark = unit_symbol(unit or usual_unit(dimension), locale)
    off = quantity(parameter.tolerance, dimension, unit, locale, style)
    if mark:
        return math(rf"({value.removesuffix(mark)} \pm {off.removesuffix(mark)}){mark}")
    return math(rf"{value} \pm {off}")


def _range(parameter: Parameter, locale: Locale, style: LatexNotation) -> str:
    if parameter.range is None:
        return ""
    dimension, unit = parameter.dimension, parameter.unit
    low, high = (quantity(end, dimension, unit, locale, style) for end in parameter.range)
    mark = unit_symbol(unit or usual_unit(dimension), locale)
    if mark.startswith(r"\,"):
        low = low.removesuffix(mark)
    return math(rf"{low}\ \ldots\ {{{high}}}")


def vector_rows(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> Iterator[VectorRow]:
    """Yield the entries of the geometry, and points as drawn rather than what follows from them."""
    drawn = {d.span: Offset("", d.point, d.x, d.y, d.span) for d in mechanism.drawn}
    given = [entry for entry in mechanism.geometry if entry.span not in drawn]
    unit = unit_of_drawing(mechanism)
    literals = {literal.name: literal for literal in mechanism.literals}
    for entry in (*given, *drawn.values()):
        row = _vector_row(entry, literals, unit, locale, style)
        if row.length or row.direction:
            yield VectorRow(*map(spaced, row))


def _vector_row(
    entry: Geometry,
    literals: Mapping[str, Parameter],
    unit: str,
    locale: Locale,
    style: LatexNotation,
) -> VectorRow:
    """Return the row of the table of vectors for one line of the geometry."""
    match entry:
        case Arrow(tail, head, _, line):
            along = math(direction(line, style)) if line else ""
            size = _length(entry, literals, locale, style)
            return VectorRow(_vector(tail, head), size, along)
        case Offset(tail, head, x, y):
            across, up = (length_of(part, locale, style, unit) for part in (x, y))
            return VectorRow(_vector(tail, head), math(f"({across}{style.between}{up})"), "")
        case Turn(first, vertex, second, angle):
            corner = rf"\angle {''.join(map(points, (first, vertex, second)))}"
            return VectorRow(math(corner), "", math(latex(angle, style, angle=True)))
        case _:
            assert_never(entry)


def _length(
    entry: Arrow, literals: Mapping[str, Parameter], locale: Locale, style: LatexNotation
) -> str:
    """Return a length with its unit and its text, or by the first name of such a number."""
    if entry.length is None:
        return ""
    symbol = latex(entry.length, style)
    if not isinstance(entry.length, Constant):
        return math(symbol)
    literal = literals[entry.length.name]
    value = quantity(entry.length.value, literal.dimension, literal.unit, locale, style)
    if not _is_own(entry):
        return math(f"{symbol}={value}")
    return ", ".join((math(value), *([translated(literal.label, style)] if literal.label else [])))


def _is_own(entry: Arrow) -> bool:
    """Return whether a length is a number that has its name from this very vector."""
    name = f"len_{entry.tail}{entry.head}"
    return isinstance(entry.length, Constant) and entry.length.name == name


def in_vectors(mechanism: Mechanism) -> frozenset[str]:
    """Return the names of the lengths that the table of vectors shows the numbers of."""
    drawn = {d.span for d in mechanism.drawn}
    written = (entry for entry in mechanism.geometry if entry.span not in drawn)
    arrows = [entry for entry in written if isinstance(entry, Arrow)]
    return frozenset(f"len_{a.tail}{a.head}" for a in arrows if _is_own(a))


def _vector(tail: str, head: str) -> str:
    return math(points(tail) + points(head) if tail else points(head))


def scheme(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> tuple[str, ...]:
    """Return the mechanism in sentences: joints, links, loads, symmetry."""
    sentences = [*_parts(mechanism, locale, style), *_pivots_and_sliders(mechanism, locale, style)]
    sentences += _links(mechanism, locale, style)
    sentences += joint_sentences(mechanism, locale, style)
    links = {link.name for link in mechanism.links}
    sentences += (_load(load, links, locale, style) for load in mechanism.loads)
    sentences += _stroke(mechanism, locale, style)
    sentences += friction_sentences(mechanism, locale, style)
    sentences += _symmetry(mechanism, locale, style)
    return tuple(f"{s[0].upper()}{s[1:]}." for s in dict.fromkeys(sentences))


def _stroke(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield from where to where the drive goes, where no table of ranges shows it."""
    if found := own_stroke(mechanism):
        parameter, *ends = found
        low, high = (
            math(quantity(end, parameter.dimension, parameter.unit, locale, style)) for end in ends
        )
        symbol = math(name(parameter.name, style))
        yield locale.joints["driven"].format(parameter=symbol, low=low, high=high)


def _parts(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield the mechanisms that this one is joined of, and the names of their points here."""
    for part in mechanism.subassemblies:
        there, here = (_listed(names, locale) for names in zip(*part.points, strict=True))
        symbol, title = math(name(part.prefix, style)), escape(part.name)
        yield locale.joints["part"].format(
            part=symbol, name=title, there=there, here=here, forms=number_of(part.points)
        )


def _pivots_and_sliders(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> list[str]:
    """Return a sentence on all pivots of a named point, and one on each slider and its guide."""
    fixed = [p.point for p in mechanism.each(Pivot) if split_points(p.point)]
    pivots = locale.pivots.format(points=_listed(fixed, locale), forms=number_of(fixed))
    sentences = [pivots] if fixed else []
    for slider in mechanism.each(Slider):
        along = spoken(slider.along, locale, style)
        guided = locale.slider.format(point=math(points(slider.point)), direction=along)
        through = slider.through and locale.through.format(point=math(points(slider.through)))
        sentences.append(guided + (through or ""))
    return sentences


def _links(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> list[str]:
    rods = [link for link in mechanism.rigid_links if _is_rod(link, mechanism)]
    bodies = [link for link in mechanism.rigid_links if link not in rods]
    return [
        template.format(
            links=enumeration([_link(link, style) for link in links], locale),
            forms=number_of(links),
        )
        for template, links in ((locale.rods, rods), (locale.bodies, bodies))
        if links
    ]


def _is_rod(link: Link, mechanism: Mechanism) -> bool:
    """Return whether a link is its two pins: the free end of a screw or of a wheel is none."""
    held = {point for joint in mechanism.joints for point in joint.points} | {*mechanism.fixed}
    others = {point for other in mechanism.links if other is not link for point in other.points}
    return len(link.points) == 2 and {*link.points} <= held | others


def _link(link: Link, style: LatexNotation) -> str:
    """Return a link by its points, and what it is called."""
    called = f" ({translated(link.label, style)})" if link.label else ""
    return math(points(link.name)) + called


def _listed(names: Iterable[str], locale: Locale) -> str:
    spelled = [math(points(n)) for n in names]
    return enumeration(spelled, locale) if spelled else ""


def _end(point: str, link: str, links: Set[str], locale: Locale) -> str:
    """Return a point, and the link that carries a load there if one is named."""
    if link not in links:
        return math(points(point))
    return locale.joints["on link"].format(point=math(points(point)), link=math(points(link)))


def _load(load: Load, links: Set[str], locale: Locale, style: LatexNotation) -> str:
    """Return the sentence of a load, with what it is tied to."""
    symbol = latex(product([(number(load.times), 1), (Symbol(load.name), 1)]), style)
    tie = _tie(load, locale, style) if load.tie else ""
    match load:
        case Force(_, point, along, spread=Spread() as spread):
            where, at = spoken(along, locale, style), math(points(point))
            stretch = math(points(spread.tail + spread.head))
            reach = math(f"{points(spread.tail + point)}={latex(spread.reach, style)}")
            said = locale.joints["spread"].format(
                load=math(symbol), stretch=stretch, direction=where, point=at, reach=reach
            )
        case Force(_, point, along):
            template = locale.weight if load.weight else locale.force
            where, at = spoken(along, locale, style), _end(point, load.link, links, locale)
            said = template.format(load=math(symbol), point=at, direction=where)
        case Torque(_, link):
            said = locale.torque.format(load=math(symbol), link=math(points(link)))
        case ForcePair(_, first, second):
            kind = "spring" if load.spring else "actuator"
            ends = (first, load.first_link), (second, load.second_link)
            start, end = (_end(*each, links, locale) for each in ends)
            said = locale.joints[kind].format(load=math(symbol), first=start, second=end)
        case _:
            assert_never(load)
    return said + tie


def _tie(load: Load, locale: Locale, style: LatexNotation) -> str:
    """Return the formula of a tied load, with the value of g where a weight takes the usual one."""
    assert load.tie
    usual = takes_usual_g(load)
    tie = by_letter(load.tie) if usual else load.tie
    unit = unit_symbol(literal_unit(load), locale)
    said = ", " + math(f"{name(load.name, style)}={latex(tie, style)}{unit}")
    if not usual:
        return said
    g = quantity(GRAVITY, DIMENSIONS["acceleration"], "m/s^2", locale, style)
    return f"{said}, {math(f'g={g}')}"


def _symmetry(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> list[str]:
    sentences = []
    if mechanism.mirror:
        across = spoken(mechanism.mirror.across, locale, style)
        sharing = mechanism.mirror.sharing
        shared, forms = _listed(sharing, locale), number_of(sharing)
        sentences.append(locale.mirror.format(direction=across, points=shared, forms=forms))
    if mechanism.copies:
        count = math(latex(number(mechanism.copies.number), style))
        sharing = mechanism.copies.sharing
        shared, forms = _listed(sharing, locale), number_of(sharing)
        sentences.append(locale.copies.format(number=count, points=shared, forms=forms))
    return sentences
