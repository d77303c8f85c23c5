"""Joints beyond pins and guides, in sentences."""

from collections.abc import Iterator, Set
from typing import assert_never

from ...formula.layout import has_minus
from ...formula.tree import negative
from ...model.mechanism import (
    ArcSlot,
    Contact,
    Joint,
    Link,
    Mechanism,
    Pivot,
    Rack,
    Rope,
    RopeFriction,
    Screw,
    Slider,
    Slot,
    WheelPair,
)
from ..languages.locale import Locale
from ..sentences.speller import number_of
from .notation import LatexNotation, points
from .quantity import length_of, math, spoken


def joint_sentences(mechanism: Mechanism, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield a sentence for each slide, slot, contact, pair of wheels, rack and screw."""
    say = locale.joints
    for slide in mechanism.slides:
        along = spoken(slide.along, locale, style)
        yield say["slide"].format(body=math(points(slide.name)), direction=along)
    if mechanism.telescopes:
        named = ", ".join(math(points(t.name)) for t in mechanism.telescopes)
        yield say["telescope"].format(links=named, forms=number_of(mechanism.telescopes))
    for link in mechanism.links:
        if link.arc:
            yield _arc(link, link.arc, locale, style)
    for joint in mechanism.joints:
        if isinstance(joint, Rope):
            yield _rope(joint, mechanism, locale)
        yield from _sentence(joint, locale, style)
        if isinstance(joint, WheelPair) and joint.arm:
            yield from _on_arm(joint, _in_two_parts(mechanism), locale, style)


def _in_two_parts(mechanism: Mechanism) -> frozenset[str]:
    """Return the centres of wheels that do not turn together."""
    held: dict[str, set[str]] = {}
    for mesh in mechanism.each(WheelPair):
        for centre, link in zip(mesh.points, mesh.wheels, strict=True):
            held.setdefault(centre, set()).add(link)
    return frozenset(centre for centre, links in held.items() if len(links) > 1)


def _arc(rod: Link, arc: ArcSlot, locale: Locale, style: LatexNotation) -> str:
    pin, body, centre = (math(points(name)) for name in (rod.points[1], arc.link, arc.centre))
    line, length = points(rod.name), length_of(arc.radius, locale, style)
    radius = math(line if length == line else f"{line}={length}")
    return locale.joints["arc"].format(point=pin, body=body, centre=centre, radius=radius)


def _sentence(joint: Joint, locale: Locale, style: LatexNotation) -> Iterator[str]:
    """Yield the sentence of a joint; pivots and sliders are named with the points, ropes apart."""
    say = locale.joints
    match joint:
        case Pivot() | Slider() | Rope():
            pass
        case Slot(point, link, tail, head):
            on, line, body = (math(points(names)) for names in (point, tail + head, link))
            kind = "slot of two" if line == body else "slot"
            yield say[kind].format(point=on, line=line, body=body)
            if joint.guided:
                guided = math(points(joint.guided))
                yield say["guided"].format(guided=guided, point=on, body=body)
        case Contact(point, link, normal=normal):
            on, body = math(points(point)), math(points(link))
            across = spoken(normal, locale, style)
            yield say["contact"].format(point=on, body=body, normal=across)
        case WheelPair():
            yield _wheels(joint, locale, style)
        case Rack(point, pivot, radius=size):
            on, centre = math(points(point)), math(points(pivot))
            is_left = has_minus(size)
            radius = math(length_of(negative(size) if is_left else size, locale, style))
            kind = "rack on the left" if is_left else "rack"
            yield say[kind].format(point=on, pivot=centre, radius=radius)
        case Screw(point, size, link):
            on, body = math(points(point)), math(points(link))
            yield say["screw"].format(
                link=body, point=on, pitch=math(length_of(size, locale, style))
            )
        case _:
            assert_never(joint)


def _rope(rope: Rope, mechanism: Mechanism, locale: Locale) -> str:
    """Return the sentence of a rope; one that slides may be a band around a drum as well."""
    frictions = (f for f in mechanism.friction.joints if isinstance(f, RopeFriction))
    kind = "flexible" if any(f.joint == rope.id for f in frictions) else "rope"
    route = ", ".join(math(points(point)) for point in rope.route)
    return locale.joints[kind].format(points=route)


def _wheels(mesh: WheelPair, locale: Locale, style: LatexNotation) -> str:
    """Return the sentence of two wheels: gears, one inside the other or not, or a belt."""
    kinds = {
        ("gear", False): "gear",
        ("gear", True): "inner",
        ("belt", True): "belt",
        ("belt", False): "crossed",
    }
    return locale.joints[kinds[mesh.kind, mesh.same]].format(
        first=math(points(mesh.first)),
        second=math(points(mesh.second)),
        one=math(length_of(mesh.first_radius, locale, style)),
        two=math(length_of(mesh.second_radius, locale, style)),
    )


def _on_arm(
    mesh: WheelPair, shared: Set[str], locale: Locale, style: LatexNotation
) -> Iterator[str]:
    """Yield the carrier of the centres of two wheels, and the bodies that they are fixed to.

    Of several about a ``shared`` centre it is said by its radius which one is meant.
    """
    say = locale.joints
    ends = f" {locale.conjunction} ".join(math(points(centre)) for centre in sorted(mesh.points))
    yield say["arm"].format(link=math(points(mesh.arm)), points=ends)
    radii = (mesh.first_radius, mesh.second_radius)
    for centre, link, radius in zip(mesh.points, mesh.wheels, radii, strict=True):
        size = f" {math(length_of(radius, locale, style))}" if centre in shared else ""
        yield say["wheel" if link else "fixed wheel"].format(
            point=math(points(centre)),
            link=math(points(link)) if link else "",
            radius=say["of radius"] + size if size else "",
        )
