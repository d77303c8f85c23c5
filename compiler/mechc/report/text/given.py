"""What a description gives, for the terminal: quantities, angles that are numbers, the stroke."""

from collections.abc import Collection, Iterator, Mapping
from types import MappingProxyType

from ...formula.evaluate import evaluate
from ...formula.layout import in_degrees
from ...formula.tree import ZERO, Constant, Formula, Number, Symbol
from ...formula.walk import symbols
from ...model.mechanism import (
    Absolute,
    Arrow,
    Direction,
    Force,
    Mechanism,
    Slider,
    Torque,
    Turn,
)
from ...model.values import is_constant, own_stroke
from ...units import in_unit, si_unit
from ..definitions import given_loads
from ..digits import VALUE_DIGITS
from ..roles import with_places, with_roles
from . import note
from .printer import print_name, print_quantity
from .speller import TextSpeller


def given(
    mechanism: Mechanism,
    met: Collection[str],
    spell: TextSpeller,
    defined: Collection[str] = (),
    values: Mapping[str, Formula] = MappingProxyType({}),
) -> list[str]:
    """Return the lines of what is given: quantities, lengths, angles and loads that are numbers.

    Lengths and angles of a drawing are among them as far as they are ``met`` in formulas, and so
    are loads that follow from others, but for those that are ``defined`` elsewhere. What follows
    from given quantities may have one of the ``values`` behind its formula.
    """
    free = (p for p in mechanism.parameters if p.value is not None or p.range)
    chosen = (p for p in free if p.name in met or not is_constant(p))
    literals = (p for p in mechanism.literals if p.name in met)
    quantities = (*chosen, *literals, *given_loads(mechanism))
    tied = _tied(mechanism, spell, met, defined)
    angles = dict.fromkeys((*tied, *_angles(mechanism, met, spell)))
    words = spell.locale.roles
    known = with_places(with_roles(quantities, mechanism, words), mechanism, words)
    lines = note.given(known, spell, angles, values)
    said = [line for each in _directions(mechanism, spell) for line in spell.wrapped(each, "  ")]
    heading = [spell.locale.given] if said and not lines else []
    return ["", *heading, *lines, *said, *_stroke(mechanism, spell)] if lines or said else []


def _tied(
    mechanism: Mechanism, spell: TextSpeller, met: Collection[str], defined: Collection[str]
) -> Iterator[str]:
    """Yield the loads that others give the size of: ``T = f · R``."""
    for load in mechanism.loads:
        is_plain = isinstance(load, Torque) or (
            isinstance(load, Force) and not load.weight and not load.spread
        )
        if is_plain and load.tie and symbols(load.tie) and load.name in {*met} - {*defined}:
            yield spell.relation((Symbol(load.name), load.tie), ("=",), False)


def _angles(mechanism: Mechanism, met: Collection[str], spell: TextSpeller) -> Iterator[str]:
    """Yield the angles of vectors that are numbers, and those between the arms of a link.

    That of a vector of which formulas do not have the length is none of them.
    """
    drawn = {point.span for point in mechanism.drawn}
    for item in mechanism.geometry:
        match item:
            case Arrow(length=Constant(name)) if name not in met:
                continue
            case Arrow(tail, head, _, line) if item.span not in drawn and _is_oblique(line):
                assert isinstance(line, Absolute)
                yield _angle(f"(x, {spell.point(tail + head)})", line.angle, spell)
            case Turn(first, vertex, second, size) if _is_number(size):
                yield _angle(f" {spell.point(first + vertex + second)}", size, spell)


def _angle(name: str, size: Formula, spell: TextSpeller) -> str:
    """Return an angle with its size: ``∠(x, AB) = −47°``, ``∠ABC = 100°``."""
    sign, name = ("∠", name.lstrip()) if spell.signs.fancy else ("angle", name)
    return f"{sign}{name} = {_size(size, spell)}"


def _size(angle: Formula, spell: TextSpeller) -> str:
    """Return an angle that is a number; one in radians in degrees, too."""
    if not isinstance(angle, Number):
        return spell.relation((angle,), (), True)
    value = evaluate(angle, {})
    turn, degrees = (
        print_quantity(in_unit(value, u, VALUE_DIGITS), spell.signs) for u in ("rad", "deg")
    )
    return f"{spell.units(turn)} ({spell.units(degrees)})"


def _is_number(angle: Formula) -> bool:
    """Return whether an angle is a number of degrees or of radians."""
    return in_degrees(angle) is not None or isinstance(angle, Number)


def _is_oblique(line: Direction | None) -> bool:
    """Return whether a direction is a number that is none of an axis."""
    if not isinstance(line, Absolute) or not _is_number(line.angle):
        return False
    size = in_degrees(line.angle)
    return line.angle != ZERO if size is None else bool(size % 90)


def _directions(mechanism: Mechanism, spell: TextSpeller) -> Iterator[str]:
    """Yield the sentences on guides and loads along directions that are oblique numbers."""
    words = spell.locale
    for slider in mechanism.each(Slider):
        if _is_oblique(slider.along):
            direction = _spoken(slider.along, spell)
            yield _sentence(words.slider, point=spell.point(slider.point), direction=direction)
    for load in mechanism.loads:
        if isinstance(load, Force) and _is_oblique(load.along):
            template = words.weight if load.weight else words.force
            names = {"load": print_name(load.name, spell.signs), "point": spell.point(load.point)}
            yield _sentence(template, **names, direction=_spoken(load.along, spell))


def _spoken(line: Direction, spell: TextSpeller) -> str:
    assert isinstance(line, Absolute)
    angle = _size(line.angle, spell)
    return spell.locale.directions["absolute"].format(angle=angle).replace("$", "")


def _sentence(template: str, **words: str) -> str:
    said = template.format(**words)
    return f"{said[0].upper()}{said[1:]}."


def _stroke(mechanism: Mechanism, spell: TextSpeller) -> Iterator[str]:
    if found := own_stroke(mechanism):
        parameter, *ends = found
        unit = parameter.unit or si_unit(parameter.dimension)
        values = (in_unit(evaluate(end, {}), unit, VALUE_DIGITS) for end in ends)
        low, high = (spell.units(print_quantity(value, spell.signs)) for value in values)
        symbol = print_name(parameter.name, spell.signs)
        driven = spell.locale.joints["driven"]
        yield from spell.wrapped(_sentence(driven, parameter=symbol, low=low, high=high), "  ")
