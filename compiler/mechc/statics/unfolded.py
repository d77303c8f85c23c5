"""The bodies, pivots, guides and contacts of the whole mechanism: both halves of a mirrored one."""

import math
from collections.abc import Iterator

from ..model.mechanism import Pivot, Slider
from ..model.repeated import primed
from ..pose.pose import evaluate_vector
from .assembly import Body, Cylinder, Guide, PinOnBody, Plane, Translation, direction
from .halves import Halves


def bodies(halves: Halves) -> Iterator[Body]:
    """Yield every link, in both halves."""
    for link in halves.pose.mechanism.links:
        frame = halves.pose.frames[link.name]
        points = {p: Plane(*evaluate_vector(frame[p], halves.values)) for p in link.points}
        yield Body(link.name, points, link.arc is not None)
        if not halves.is_shared(link.name):
            twins = {halves.twin(p): halves.reflected(v) for p, v in points.items()}
            yield Body(primed(link.name), twins, link.arc is not None)


def pivots(halves: Halves) -> Iterator[str]:
    """Yield every pin on the ground, in both halves."""
    for pivot in halves.pose.mechanism.each(Pivot):
        yield from dict.fromkeys((pivot.point, halves.twin(pivot.point)))


def guides(halves: Halves) -> Iterator[Guide]:
    """Yield the guide of every slider, in both halves, and those that symmetry makes."""
    for slider in halves.pose.mechanism.each(Slider):
        along = halves.direction_of_guide(slider.point)
        yield Guide(slider.point, along)
        if not halves.is_shared(slider.point):
            yield Guide(halves.twin(slider.point), halves.reflected(along))
    yield from _guides_by_symmetry(halves)


def _guides_by_symmetry(halves: Halves) -> Iterator[Guide]:
    copies, guides = halves.pose.mechanism.copies, halves.pose.guides
    if copies is None:
        return
    axis = next((halves.direction_of_guide(p) for p in copies.sharing if p in guides), None)
    held = {*guides, *halves.pose.mechanism.fixed}
    for point in copies.sharing:
        if axis is not None and point not in held:
            yield Guide(point, axis)


def slides(halves: Halves) -> Iterator[Translation]:
    """Yield every body that only translates, in both halves."""
    for slide in halves.pose.mechanism.slides:
        along = direction(halves.pose.slides[slide.name].evaluate(halves.values))
        frame = halves.pose.frames[slide.name]
        points = {p: Plane(*evaluate_vector(frame[p], halves.values)) for p in slide.points}
        yield Translation(Body(slide.name, points), along)
        if not halves.is_shared(slide.name):
            twins = {halves.twin(p): halves.reflected(v) for p, v in points.items()}
            yield Translation(Body(primed(slide.name), twins), halves.reflected(along))


def point_contacts(halves: Halves) -> Iterator[PinOnBody]:
    """Yield every pin in a slot and every contact, in both halves."""
    for contact in halves.pose.contacts:
        normal = direction(contact.normal.evaluate(halves.values))
        reach = Plane(*evaluate_vector(contact.reach, halves.values))
        first = next(iter(halves.pose.frames[contact.body]))
        base = halves.arm(contact.body, first, contact.tail)
        arm = Plane(base.x + reach.x, base.y + reach.y)
        yield PinOnBody(contact.kind, contact.point, contact.body, arm, normal)
        if not (halves.is_shared(contact.point) and halves.is_shared(contact.body)):
            body = contact.body if halves.is_shared(contact.body) else primed(contact.body)
            mirrored = halves.reflected(arm), halves.reflected(normal)
            yield PinOnBody(contact.kind, halves.twin(contact.point), body, *mirrored)


def telescopes(halves: Halves) -> Iterator[Cylinder]:
    """Yield every telescope that two bodies make, in both halves."""
    for telescope in halves.pose.mechanism.cylinders:
        first, second = telescope.points
        arm = halves.arm(telescope.name, first, second)
        reach = math.hypot(arm.x, arm.y)
        along = arm.times(1 / reach)
        yield Cylinder(telescope.name, telescope.points, reach, along)
        if not halves.is_shared(telescope.name):
            ends = halves.twin(first), halves.twin(second)
            yield Cylinder(primed(telescope.name), ends, reach, halves.reflected(along))
