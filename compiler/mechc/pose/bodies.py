"""Slides, slots and contacts at a pose: directions, and where pins touch bodies."""

from collections.abc import Callable, Iterator

from ..algebra.angle import Angle
from ..algebra.product import Product
from ..model.mechanism import Direction, Mechanism
from .compass import Compass
from .pose import Arm, Touch, Vector
from .vectors import Vectors

Find = Callable[[Direction, str, str], Angle]
"""Resolves a direction: its name, and what it is wanted for."""


def touches(
    mechanism: Mechanism, compass: Compass, vectors: Vectors, find: Find
) -> Iterator[Touch]:
    """Yield every pin that slides along a body."""
    slides = {s.name for s in mechanism.slides}
    for slot in mechanism.slots:
        line = compass.of(slot.tail, slot.head) or Angle()
        reach = _reach(slot.tail, slot.point, line, vectors)
        yield Touch(
            "slot",
            slot.point,
            slot.link,
            slot.tail,
            () if slot.link in slides else reach,
            line + Angle.constant(90),
            slot.span,
        )
    for contact in mechanism.contacts:
        normal = find(contact.normal, f"theta_{contact.point}", f"the contact at {contact.point}")
        reach = _reach(contact.tail, contact.point, normal + Angle.constant(-90), vectors)
        yield Touch(
            "contact",
            contact.point,
            contact.link,
            contact.tail,
            () if contact.link in slides else reach,
            normal,
            contact.span,
        )


def _reach(tail: str, point: str, line: Angle, vectors: Vectors) -> Vector:
    """Return the vector to a pin: given, or along the line, of a length left open."""
    given = vectors.path(tail, point)
    if given:
        return given
    name = f"len_{tail}{point}"
    if name not in vectors.placeholders:
        vectors.placeholders.append(name)
    return (Arm(Product.symbol(name), line),)
