"""Which force at a joint is meant, in words."""

from collections.abc import Set

from ...model.mechanism import Axial, Normal, Reaction
from ...model.parts.linkage import rope_id
from ...model.parts.targets import ForceAtJoint
from ..languages.locale import Locale
from .speller import Speller


def force_words(force: ForceAtJoint, locale: Locale, spell: Speller) -> str:
    """Return which force is meant: of which joint, on which link, in which rod."""
    said = locale.at_joints[carrier(force, spell.guided)]
    match force:
        case Axial(_, tail, head):
            return said.format(line=spell.point(f"{tail}{head}"))
        case Normal(point):
            return said.format(point=spell.point(point))
        case Reaction(point, link):
            return said.format(point=spell.point(point), link=spell.point(link) if link else "")


def component_words(force: ForceAtJoint, locale: Locale, spell: Speller) -> str:
    """Return which force is meant, and which component of it."""
    said = force_words(force, locale, spell)
    part = locale.at_joints[force.part] if isinstance(force, Reaction) else "{force}"
    return part.format(force=said)


def carrier(force: ForceAtJoint, guided: Set[str] = frozenset()) -> str:
    """Return the kind of part that passes a force on: a rope, a rod, or a guide by its normal.

    What the ground exerts on a ``guided`` point is the force of a guide, too; the force ``on``
    a link is that of a joint.
    """
    match force:
        case Axial(link):
            return "rope" if link.startswith(rope_id(())) else "rod"
        case Normal():
            return "normal"
        case Reaction(point, ""):
            return "guide" if point in guided else "joint"
        case Reaction():
            return "on"
