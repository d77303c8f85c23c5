"""The mechanism as text, one fact to a line, for ``mechc show model``."""

from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import assert_never

from ..formula.to_text import text
from ..formula.tree import Formula
from ..units import described
from .mechanism import (
    Absolute,
    Arrow,
    Axial,
    Direction,
    Efficiency,
    Find,
    Force,
    Geometry,
    Load,
    LoadForm,
    LoadRatio,
    Mechanism,
    Normal,
    Offset,
    Parameter,
    Reaction,
    Slider,
    Speed,
    SpeedRatio,
    Target,
    Thrust,
    Torque,
    Turn,
    WithFriction,
)


def describe(mechanism: Mechanism) -> str:
    """Return every fact of a mechanism, quantities in SI and angles in radians."""
    return "\n".join(_lines(mechanism)) + "\n"


def _lines(mechanism: Mechanism) -> Iterator[str]:
    yield f'mechanism {mechanism.name} "{mechanism.title}"'
    if mechanism.source:
        yield f'source "{mechanism.source}"'
    yield from map(_parameter, mechanism.parameters)
    yield from (f"pivot {pivot.point}" for pivot in mechanism.pivots)
    yield from map(_slider, mechanism.sliders)
    yield from (f"link {k.name} through {' '.join(k.points)}" for k in mechanism.links)
    yield from _joints(mechanism)
    yield from map(_geometry, mechanism.geometry)
    yield from map(_load, mechanism.loads)
    yield from _symmetry(mechanism)
    yield from map(_find, mechanism.finds)
    for let in mechanism.lets:
        yield f"let {let.name} = {text(let.value)}, {described(let.dimension)}"
    for r in mechanism.requires:
        yield f"require {text(r.left)} {r.operator} {text(r.right)}"
    yield from _expects(mechanism)


def _parameter(parameter: Parameter) -> str:
    words = [f"param {parameter.name}: {described(parameter.dimension)}"]
    if parameter.value:
        follows = " (dependent)" if parameter.dependent else ""
        words.append(f"= {text(parameter.value)}{follows}")
    if parameter.range:
        words.append(f"in {text(parameter.range.low)} .. {text(parameter.range.high)}")
    return " ".join(words)


def _slider(slider: Slider) -> str:
    through = f" through {slider.through}" if slider.through else ""
    return f"slider {slider.point} along {direction_text(slider.along)}{through}"


def direction_text(direction: Direction) -> str:
    """Return a direction: an angle in radians, or the vector it is taken from.

    >>> from ..source import Span
    >>> from .mechanism import Along
    >>> direction_text(Along("A", "B", 1, Span(0, 0)))
    'AB turned by 90 deg'
    """
    if isinstance(direction, Absolute):
        return text(direction.angle)
    turned = f" turned by {direction.quarter * 90} deg" if direction.quarter else ""
    return f"{direction.tail}{direction.head}{turned}"


def _joints(mechanism: Mechanism) -> Iterator[str]:
    for slide in mechanism.slides:
        yield f"slide {slide.name} along {direction_text(slide.along)}"
    yield from (f"telescope {t.name}" for t in mechanism.telescopes)
    yield from (f"slot {s.point} in {s.tail}{s.head} of {s.link}" for s in mechanism.slots)
    for contact in mechanism.contacts:
        normal = direction_text(contact.normal)
        yield f"contact {contact.point} on {contact.link} normal {normal}"
    for mesh in mechanism.meshes:
        radii = f"{text(mesh.first_radius)}, {text(mesh.second_radius)}"
        way = "the same way" if mesh.same else "opposite ways"
        yield f"{mesh.kind} {mesh.first}, {mesh.second} of radii {radii}, turning {way}"
    for rack in mechanism.racks:
        yield f"rack {rack.point} on {rack.pivot} of radius {text(rack.radius)}"
    for screw in mechanism.screws:
        yield f"screw {screw.link} moves {screw.point} by {text(screw.pitch)} per turn"
    if drive := mechanism.drive:
        ends = f" from {text(drive.low)} to {text(drive.high)}" if drive.low and drive.high else ""
        yield f"drive {drive.parameter}{ends}"
    yield from (f"assembly {' '.join(a.points)} {a.mode}" for a in mechanism.assemblies)


def _geometry(entry: Geometry) -> str:
    match entry:
        case Arrow(tail, head, length, direction):
            along = f"direction {direction_text(direction)}" if direction else ""
            return f"vector {tail}{head}: {_joined(_measured('length', length), along)}"
        case Offset(tail, head, x, y):
            start = f"vector {tail}{head}" if tail else f"place of {head}"
            return f"{start}: ({text(x)}, {text(y)})"
        case Turn(first, vertex, second, angle):
            return f"angle {first}{vertex}{second}: {text(angle)}"
        case _:
            assert_never(entry)


def _measured(what: str, formula: Formula | None) -> str:
    return f"{what} {text(formula)}" if formula else ""


def _joined(*parts: str) -> str:
    return ", ".join(part for part in parts if part)


def _load(load: Load) -> str:
    match load:
        case Force():
            kind = "weight" if load.weight else "force"
            line = f"{kind} {load.name} at {load.point} along {direction_text(load.along)}"
        case Torque():
            line = f"torque {load.name} on {load.link}"
        case Thrust():
            kind = "spring" if load.spring else "actuator"
            line = f"{kind} {load.name} between {load.first} and {load.second}"
        case _:
            assert_never(load)
    tie = f" = {text(load.tie)}" if load.tie else ""
    times = f" times {load.times}" if load.times != Fraction(1) else ""
    return f"{line}{tie}{times}"


def _symmetry(mechanism: Mechanism) -> Iterator[str]:
    if mirror := mechanism.mirror:
        yield f"mirror across {direction_text(mirror.across)}{_sharing(mirror.sharing)}"
    if copies := mechanism.copies:
        yield f"copies {copies.number}{_sharing(copies.sharing)}"


def _sharing(points: Iterable[str]) -> str:
    shared = " ".join(points)
    return f" sharing {shared}" if shared else ""


def _find(find: Find) -> str:
    return f"find {find.name} = {target_text(find.target)}"


def target_text(target: Target) -> str:
    """Return what is asked for, as in the language.

    >>> target_text(SpeedRatio(Speed("link", "OBA"), Speed("point", "K")))
    'omega_OBA / V_K'
    """
    match target:
        case LoadRatio(above, below):
            return f"{above} / {below}"
        case LoadForm(load):
            return load
        case SpeedRatio(above, below):
            return f"{_speed(above)} / {_speed(below)}"
        case Reaction(point, link, part):
            return f"R_{point}{f' on {link}' if link else ''}, {part}"
        case Axial(_, tail, head):
            return f"N_{tail}{head}"
        case Normal(point):
            return f"N_{point}"
        case WithFriction(of, sense, order):
            return f"{target_text(of)} with friction, {sense}, {order}"
        case Efficiency(of, sense):
            return f"efficiency of {target_text(of)}, {sense}"
        case _:
            assert_never(target)


def _speed(speed: Speed) -> str:
    return f"{'V' if speed.kind == 'point' else 'omega'}_{speed.of}"


def _expects(mechanism: Mechanism) -> Iterator[str]:
    for expect in mechanism.expects:
        at = ", ".join(f"{name} = {text(value)}" for name, value in expect.at.items())
        within = f" within {float(expect.tolerance):g}" if expect.tolerance else ""
        yield f"expect {expect.subject} = {text(expect.value)}{within}{' at ' if at else ''}{at}"
