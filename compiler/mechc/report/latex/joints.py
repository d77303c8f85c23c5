"""Joints beyond pins and guides, in sentences."""

from collections.abc import Iterator

from ...model.mechanism import Mechanism, WheelPair
from ..languages.locale import Locale
from .directions import direction, math
from .notation import Notation, points
from .quantity import length_of


def joint_sentences(mechanism: Mechanism, locale: Locale, style: Notation) -> Iterator[str]:
    """Yield a sentence for each slide, slot, contact, pair of wheels, rack and screw."""
    say = locale.joints
    for slide in mechanism.slides:
        along = math(direction(slide.along, style))
        yield say["slide"].format(body=math(points(slide.name)), direction=along)
    if mechanism.telescopes:
        named = ", ".join(math(points(t.name)) for t in mechanism.telescopes)
        yield say["telescope"].format(links=named)
    for slot in mechanism.slots:
        line, body = math(points(slot.tail + slot.head)), math(points(slot.link))
        yield say["slot"].format(point=math(points(slot.point)), line=line, body=body)
    for contact in mechanism.contacts:
        point, body = math(points(contact.point)), math(points(contact.link))
        normal = math(direction(contact.normal, style))
        yield say["contact"].format(point=point, body=body, normal=normal)
    for mesh in mechanism.wheel_pairs:
        yield _mesh(mesh, locale, style)
    for rack in mechanism.racks:
        point, pivot = math(points(rack.point)), math(points(rack.pivot))
        yield say["rack"].format(
            point=point, pivot=pivot, radius=math(length_of(rack.radius, locale, style))
        )
    for screw in mechanism.screws:
        link, point = math(points(screw.link)), math(points(screw.point))
        yield say["screw"].format(
            link=link, point=point, pitch=math(length_of(screw.pitch, locale, style))
        )


def _mesh(mesh: WheelPair, locale: Locale, style: Notation) -> str:
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
