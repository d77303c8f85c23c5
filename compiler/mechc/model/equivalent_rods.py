"""The equivalent linkage of a mechanism with circular slots: a rod in the place of each.

Everything behind the model knows links and joints alone.
"""

from collections.abc import Sequence

from ..base.frozen import replace
from ..diagnostics.model import circular_slots as slot_messages
from ..diagnostics.model import joints as messages
from .entries import vector_between
from .mechanism import ArcSlot, Arrow, Geometry, Link, Mechanism
from .names.scope import NameScope


def with_rods_for_circular_slots(
    mechanism: Mechanism, arcs: Sequence[tuple[str, ArcSlot]], scope: NameScope
) -> Mechanism:
    """Return the mechanism with a rod from the centre to the pin for each circular slot.

    The rod has the slot's radius for its length, pushes and pulls along the same line, and so
    takes the slot's place exactly: the equivalent linkage of textbooks.
    """
    links, geometry = list(mechanism.links), list(mechanism.geometry)
    for pin, arc in arcs:
        ends = (arc.centre, pin)
        if other := next((k for k in links if {*ends} == {*k.points}), None):
            scope.report.add(messages.link_again(arc.span, other.name, other.span))
            continue
        links.append(Link("".join(ends), ends, arc.span, arc=arc))
        _give_length(geometry, ends, arc, scope)
    return replace(mechanism, links=tuple(links), geometry=tuple(geometry))


def _give_length(
    geometry: list[Geometry], ends: tuple[str, str], arc: ArcSlot, scope: NameScope
) -> None:
    """Give the vector between two points the radius for its length."""
    entry = vector_between(ends, geometry)
    if not isinstance(entry, Arrow):
        geometry.append(Arrow(*ends, arc.radius, None, arc.span))
        return
    if entry.length is not None:
        scope.report.add(slot_messages.radius_is_length(entry.span, "".join(ends), arc.span))
    geometry[geometry.index(entry)] = replace(entry, length=arc.radius)
