"""What turns on pins, counted on the free bodies: where every pin is said to have friction."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

from ..model.parts.linkage import primed
from .assembly import Action, AssembledBodies, Couple
from .unfold import Unfolding

PinActions = Iterable[tuple[str, tuple[Action, ...]]]
"""What friction does at one pin after another."""


def uncounted(unfolding: Unfolding, friction: PinActions) -> Iterator[str]:
    """Yield each pin, and the body on it, whose friction is said and acts on no free body.

    The pins are counted on what is cut free, twins among them, and not on the description: a
    body turns on a pin that something else holds or turns on, unless symmetry keeps it still.
    """
    whole = unfolding.assembly()
    acted, held = set(_acted(friction, whole)), _held(whole)
    symmetric, own = unfolding.axis is not None, {*whole.twins, *whole.twins.values()}
    for point, bodies in _turning(whole).items():
        if len(bodies) > 1 or point in held:
            turning = (b for b in bodies if not symmetric or b in own)
            yield from (f"{point} on {b}" for b in turning if (point, b) not in acted)


def _acted(friction: PinActions, whole: AssembledBodies) -> Iterator[tuple[str, str]]:
    """Yield each pin, or its twin, with a body on it that friction turns."""
    parts = {c.part(p): (p, c.name) for c in whole.cylinders for p in c.ends}
    for pin, actions in friction:
        for action in actions:
            if isinstance(action, Couple):
                for point in (pin, primed(pin)):
                    yield parts.get(action.body, (point, action.body))


def _held(whole: AssembledBodies) -> set[str]:
    """Return the pins that the ground, a guide or a body without rotation holds."""
    guided = (guide.point for guide in whole.guides)
    return {*whole.pivots, *guided, *chain(*(slide.body.points for slide in whole.slides))}


def _turning(whole: AssembledBodies) -> Mapping[str, list[str]]:
    """Return the links and telescopes at each pin."""
    found: dict[str, list[str]] = {}
    for body in whole.bodies:
        for point in () if body.arc else body.points:
            found.setdefault(point, []).append(body.name)
    for cylinder in whole.cylinders:
        for point in cylinder.ends:
            found.setdefault(point, []).append(cylinder.name)
    return found
