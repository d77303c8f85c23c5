"""What a printer must know to write mathematics inside a sentence; forces at joints in words."""

from collections.abc import Iterable, Sequence, Set
from typing import Protocol

from ...formula.layout import is_angle
from ...formula.tree import Formula
from ...model.mechanism import Axial, Mechanism, Normal, Reaction, Slider, Torque
from ...model.parts.joints import rope_id
from ...model.parts.targets import ForceAtJoint
from ...model.result import Result
from ..languages.locale import Locale


class Speller(Protocol):
    """Writes mathematics inside a sentence."""

    @property
    def angles(self) -> frozenset[str]:
        """Return the names that are angles."""
        ...

    @property
    def couples(self) -> frozenset[str]:
        """Return the loads that are couples, which languages with genders call by another word."""
        ...

    @property
    def guided(self) -> frozenset[str]:
        """Return the points that a guide of the ground holds, and no pivot."""
        ...

    def relation(self, sides: tuple[Formula, ...], signs: tuple[str, ...], angle: bool) -> str:
        """Return sides joined by signs (``<``, ``<=``, ``=``, ``!=`` …); one side, none.

        ``angle`` says that the sides are angles, so that constants are in degrees.
        """
        ...

    def number(self, value: float) -> str:
        """Return a number that was computed."""
        ...

    def unit_behind(self, unit: str) -> str:
        """Return a unit behind its number, in the letters of a language."""
        ...

    def point(self, names: str) -> str:
        """Return a point, a link or a vector."""
        ...


def spelled(formula: Formula, spell: Speller) -> str:
    """Return a formula by itself, as it stands inside a sentence."""
    return spell.relation((formula,), (), False)


class LoadWords:
    """Forms of words on one force, on one couple, or on several loads, as templates ask for them.

    >>> "{of:рушійна сила|рушійний момент} T".format(of=LoadWords(["T"], frozenset("T")))
    'рушійний момент T'
    """

    def __init__(self, loads: Sequence[str], couples: frozenset[str]) -> None:
        self._form = 2 if len(loads) != 1 else int(loads[0] in couples)

    def __format__(self, forms: str) -> str:
        return forms.split("|")[self._form]


class WordForms:
    """Forms of words on one or several, on a point or a body, as templates ask for them.

    >>> "{forms:link|links} AB".format(forms=WordForms(False))
    'link AB'
    """

    def __init__(self, is_second: bool) -> None:
        self._form = int(is_second)

    def __format__(self, forms: str) -> str:
        return forms.split("|")[self._form]


def number_of(items: Sequence[object]) -> WordForms:
    """Return the forms of words on one item, or on several."""
    return WordForms(len(items) != 1)


def angles_of(mechanism: Mechanism, results: Iterable[Result]) -> frozenset[str]:
    """Return the names that are angles: parameters, and what results rest on."""
    angles = set(mechanism.angles)
    for result in results:
        for definition in result.where:
            if is_angle(definition.formula, angles):
                angles.add(definition.name)
    return frozenset(angles)


def couples_of(mechanism: Mechanism) -> frozenset[str]:
    """Return the names of the loads that are couples."""
    return frozenset(load.name for load in mechanism.loads if isinstance(load, Torque))


def guided_of(mechanism: Mechanism) -> frozenset[str]:
    """Return the points that a guide of the ground holds, alone or with their body."""
    sliders = {slider.point for slider in mechanism.each(Slider)}
    return frozenset(sliders.union(*(slide.points for slide in mechanism.slides)))


def own_names(mechanism: Mechanism) -> frozenset[str]:
    """Return the names that the description gives, which are the same in every language."""
    listed = (*mechanism.parameters, *mechanism.literals, *mechanism.loads, *mechanism.lets)
    return frozenset(each.name for each in listed) - mechanism.follow


def plain_names(mechanism: Mechanism) -> frozenset[str]:
    """Return the names of the description's own lines, none of which anything else brings in."""
    parameters = {parameter.name for parameter in mechanism.parameters}
    lets = {let.name for let in mechanism.lets}
    tables = {table.name for table in mechanism.tables}
    return frozenset(parameters | lets | tables) - mechanism.brought


def force_words(force: ForceAtJoint, locale: Locale, spell: Speller) -> str:
    """Return which force is meant: of which joint, on which link, in which rod."""
    said = locale.at_joints[carrier(force, spell.guided)]
    match force:
        case Axial(slot=pin) if pin:
            return said.format(point=spell.point(pin))
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
    """Return the kind of part that passes a force on: a rope, rod, slot, or guide by its normal.

    What the ground exerts on a ``guided`` point is the force of a guide, too; the force ``on``
    a link is that of a joint.
    """
    match force:
        case Axial(slot=pin) if pin:
            return "slot"
        case Axial(link):
            return "rope" if link.startswith(rope_id(())) else "rod"
        case Normal():
            return "normal"
        case Reaction(point, ""):
            return "guide" if point in guided else "joint"
        case Reaction():
            return "on"
